#include "doc/view/figure-export.h"

#include <glib/gi18n-lib.h>
#include <string.h>

static gboolean
refuse_without_result (GError **error)
{
  g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE,
                       _ ("This view shows a result, and there is none yet"));
  return FALSE;
}

gboolean
qn_view_state_get_figure_as (QnViewState *state, const QnRecipe *recipe, QnFigure *figure,
                             GError **error)
{
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (!qn_view_state_get_content_of (state, recipe->view.view, &model, &contacts,
                                     &result))
    return refuse_without_result (error);
  QnViewOptions shown = qn_view_state_get_options (state);
  qn_recipe_fill (recipe, model, contacts, result, figure);
  figure->options.underlay = shown.underlay;
  if (shown.view == recipe->view.view)
    figure->options.onion = shown.onion;
  return TRUE;
}

gboolean
qn_view_state_export_as (QnViewState *state, const QnRecipe *recipe, const char *path,
                         GError **error)
{
  QnFigure figure;
  QnMetadata metadata;
  if (!qn_view_state_get_figure_as (state, recipe, &figure, error))
    return FALSE;
  qn_document_get_metadata (qn_view_state_get_document (state), &metadata);
  return qn_figure_export (&figure, path, &recipe->output, &metadata, error);
}

gboolean
qn_view_state_get_figure (QnViewState *state, QnFigure *figure, GError **error)
{
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (!qn_view_state_get_content (state, &model, &contacts, &result))
    return refuse_without_result (error);
  QnViewOptions options = qn_view_state_get_options (state);
  options.titles = true;
  qn_figure_init (figure, model, contacts, result, options.view);
  figure->options = options;
  return TRUE;
}

void
qn_document_get_metadata (QnDocument *document, QnMetadata *metadata)
{
  const QnProject *project = qn_document_get_project (document);
  const char *path = qn_document_get_path (document);
  const char *slash = path != NULL ? strrchr (path, G_DIR_SEPARATOR) : NULL;
  qn_metadata_init (metadata);
  metadata->model = slash != NULL ? slash + 1 : path;
  metadata->model_sha256 = project->sha256;
  metadata->generator = "quoin " QN_VERSION;
}
