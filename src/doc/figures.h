/* The figures of a document's project: stored as recipes, each change a step that can be undone,
 * and made again from the window as `quoin-cli figures` makes them. */
#ifndef QN_DOC_FIGURES_H
#define QN_DOC_FIGURES_H

#include "doc/document.h"
#include "doc/recipe.h"

/* Of QnRecipe *, possibly none; NULL with an error where the project's are unreadable. */
GPtrArray *qn_document_get_figures (QnDocument *document, GError **error);

/* Keeps a recipe, in place of one of the same name, with the digest of the present model. */
gboolean qn_document_store_figure (QnDocument *document, const QnRecipe *recipe,
                                   GError **error);

gboolean qn_document_remove_figure (QnDocument *document, const char *name,
                                    GError **error);

/* "figure", "figure-2", …: a name that no figure of the project has. The caller frees it. */
char *qn_document_dup_figure_name (QnDocument *document, const char *like);

/* The latest run of the present model by the project's own procedure, or NULL: what figures
 * without a result file show. Borrowed. */
QnRun *qn_document_find_own_run (QnDocument *document);

/* Whether that run is missing for a recipe: an analysis must come first. */
gboolean qn_document_figure_waits (QnDocument *document, const QnRecipe *recipe);

/* Writes the picture of a recipe; `path` NULL: where the recipe says, beside the project. */
gboolean qn_document_export_figure (QnDocument *document, const QnRecipe *recipe,
                                    const char *path, GError **error);

#endif
