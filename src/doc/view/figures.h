/* The figures of a document's project: stored as recipes, each change a step that can be undone,
 * and made again from the window as `quoin-cli figures` makes them. */
#pragma once

#include "doc/document/document.h"
#include "doc/view/recipe.h"
#include "doc/view/view-state.h"
#include "render/figure/figure.h"

/* Of QnRecipe *, possibly none; NULL with an error where the project's are unreadable. */
GPtrArray *qn_document_get_figures (QnDocument *document, GError **error);

/* Keeps a recipe, in place of one of the same name, with the digest of the present model. */
gboolean qn_document_store_figure (QnDocument *document, const QnRecipe *recipe,
                                   GError **error);

/* Forgets the recipe of this name; nothing changes where there is none. */
gboolean qn_document_remove_figure (QnDocument *document, const char *name,
                                    GError **error);

/* "figure", "figure-2", …: a name that no figure of the project has. The caller frees it. */
char *qn_document_dup_figure_name (QnDocument *document, const char *like);

/* Whether a recipe without a result file has nothing to show: no run of the present model by the
 * project's own procedure is there, so an analysis must come first. */
gboolean qn_document_figure_waits (QnDocument *document, const QnRecipe *recipe);

/* The user allows the files of this figure, wherever they are, until the document is closed. */
void qn_document_allow_figure (QnDocument *document, const QnRecipe *recipe);

/* Writes the picture of a recipe where it says, beside the project. Files outside the project's folder
 * that the user has not allowed are refused (QN_IO_ERROR_OUTSIDE). */
gboolean qn_document_export_figure (QnDocument *document, const QnRecipe *recipe,
                                    GError **error);

/* The figure that a recipe asks for, of what the window shows: its current run, outdated or
 * not. Borrows from the state. False where the view needs a result and there is none. */
gboolean qn_view_state_get_figure_as (QnViewState *state, const QnRecipe *recipe,
                                      QnFigure *figure, GError **error);
gboolean qn_view_state_export_as (QnViewState *state, const QnRecipe *recipe,
                                  const char *path, GError **error);

/* Metadata of pictures of a document; borrows from it. */
void qn_document_get_metadata (QnDocument *document, QnMetadata *metadata);

/* Before the document is saved as `path`: copies records of ground motion and results of figures
 * into the new folder, and the picture of a document that was opened as a copy; other pictures are
 * named as seen from there. FALSE with an error where a file of the name is there that says
 * something else: nothing is written over. */
gboolean qn_document_carry_files (QnDocument *document, const char *path, GError **error);
