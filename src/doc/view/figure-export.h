/* Exporting what a window shows: the same bytes as the command line writes for the same
 * project, result and options. */
#pragma once

#include "doc/view/recipe.h"
#include "doc/view/view-state.h"
#include "render/figure/figure.h"

/* The figure of the present view, with the titles that figures have and windows do not.
 * Borrows from the state. False where the view needs a result and there is none. */
gboolean qn_view_state_get_figure (QnViewState *state, QnFigure *figure, GError **error);

/* The figure that a recipe asks for, of what the window shows: its current run, outdated or
 * not. */
gboolean qn_view_state_get_figure_as (QnViewState *state, const QnRecipe *recipe,
                                      QnFigure *figure, GError **error);
gboolean qn_view_state_export_as (QnViewState *state, const QnRecipe *recipe,
                                  const char *path, GError **error);

/* Metadata of pictures of a document; borrows from it. */
void qn_document_get_metadata (QnDocument *document, QnMetadata *metadata);
