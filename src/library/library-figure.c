#include "doc/document/underlay.h"
#include "library/library-private.h"
#include "render/figure/figure.h"

#include <math.h>
#include <string.h>

struct QuoinFigure {
  QuoinModel *model;
  QuoinResult *result; /* or NULL */
  QnFigure figure;
  QnOutput output;
  char *title, *caption;
};

QuoinFigure *
quoin_figure_new (QuoinModel *model, QuoinResult *result, const char *view,
                  QuoinError **error)
{
  if (!quoin_library_given (model, "model", error)
      || !quoin_library_given (view, "view", error))
    return NULL;
  QnView kind;
  if (!qn_view_parse (view, &kind)) {
    quoin_library_set_error (error, QUOIN_ERROR_USAGE, "%s: no such view", view);
    return NULL;
  }
  if (result == NULL && kind != QN_VIEW_MODEL && kind != QN_VIEW_CONTACTS) {
    quoin_library_set_error (error, QUOIN_ERROR_USAGE, "%s: this view needs a result",
                             view);
    return NULL;
  }
  QuoinFigure *figure = g_new0 (QuoinFigure, 1);
  figure->model = quoin_model_ref (model);
  figure->result = result != NULL ? quoin_library_result_ref (result) : NULL;
  qn_figure_init (&figure->figure, &model->project.model, &model->contacts,
                  result != NULL ? &result->result : NULL, kind);
  qn_output_init (&figure->output);
  return figure;
}

void
quoin_figure_free (QuoinFigure *figure)
{
  if (figure == NULL)
    return;
  quoin_model_unref (figure->model);
  quoin_result_free (figure->result);
  g_free (figure->title);
  g_free (figure->caption);
  g_free (figure);
}

static void
keep_text (char **kept, const char **shown, const char *value)
{
  g_free (*kept);
  *shown = *kept = g_strdup (value);
}

/* A number of the whole text, finite and at least `least`. */
static bool
parse_number (const char *value, double least, double *number)
{
  char *end;
  double parsed = g_ascii_strtod (value, &end);
  if (end == value || *end != '\0' || !isfinite (parsed) || parsed < least)
    return false;
  *number = parsed;
  return true;
}

/* "last" or a step that the result has. */
static bool
parse_step (const QuoinFigure *figure, const char *value, int32_t *step)
{
  guint64 number;
  *step = QN_STEP_LAST;
  if (strcmp (value, "last") == 0)
    return true;
  if (figure->result == NULL
      || !g_ascii_string_to_unsigned (value, 10, 0, G_MAXINT32, &number, NULL)
      || number >= figure->result->result.step_count)
    return false;
  *step = (int32_t) number;
  return true;
}

/* Whether there is an option of this name and the value is one of its. */
static bool
set_option (QuoinFigure *figure, const char *name, const char *value, GError **cause)
{
  QnViewOptions *options = &figure->figure.options;
  bool on = strcmp (value, "on") == 0, *flag = qn_view_switch (options, name);
  if (strcmp (name, "monochrome") == 0)
    flag = &options->monochrome;
  if (flag != NULL) {
    *flag = on;
    return on || strcmp (value, "off") == 0;
  }
  if (strcmp (name, "size") == 0)
    return qn_output_parse_size (&figure->output, value, cause);
  if (strcmp (name, "dpi") == 0)
    return parse_number (value, 1, &figure->output.dpi);
  if (strcmp (name, "field") == 0)
    return qn_field_parse (value, &options->field);
  if (strcmp (name, "diagram") == 0)
    return qn_diagram_parse (value, &options->diagram);
  if (strcmp (name, "step") == 0)
    return parse_step (figure, value, &options->step);
  if (strcmp (name, "scale") == 0 && strcmp (value, "auto") == 0) {
    options->scale = QN_SCALE_AUTO;
    return true;
  }
  if (strcmp (name, "scale") == 0)
    return parse_number (value, DBL_MIN, &options->scale);
  if (strcmp (name, "title") == 0)
    keep_text (&figure->title, &figure->figure.title, value);
  else if (strcmp (name, "caption") == 0)
    keep_text (&figure->caption, &figure->figure.caption, value);
  else
    return false;
  return true;
}

bool
quoin_figure_set (QuoinFigure *figure, const char *name, const char *value,
                  QuoinError **error)
{
  if (!quoin_library_given (figure, "figure", error)
      || !quoin_library_given (name, "name", error)
      || !quoin_library_given (value, "value", error))
    return false;
  GError *cause = NULL;
  if (set_option (figure, name, value, &cause))
    return true;
  if (cause != NULL)
    quoin_library_take_error (error, NULL, cause);
  else
    quoin_library_set_error (error, QUOIN_ERROR_USAGE,
                             "%s=%s: no such option, or not a value of it", name, value);
  return false;
}

/* Draws in a format, or by the ending of a path. */
static GBytes *
encode (const QuoinFigure *self, QnFormat format, GError **cause)
{
  QnMetadata metadata;
  QnFigure figure = self->figure;
  const QnProject *project = &self->model->project;
  qn_metadata_init (&metadata);
  metadata.generator = "quoin " QN_VERSION;
  metadata.model_sha256 = project->sha256;
  g_autofree char *base = g_path_get_basename (project->name);
  metadata.model = base;
  if (!qn_underlay_read (project, FALSE, &figure.options.underlay, cause))
    return NULL;
  GBytes *bytes = qn_figure_encode (&figure, format, &self->output, &metadata, cause);
  g_clear_pointer (&figure.options.underlay.image, cairo_surface_destroy);
  return bytes;
}

bool
quoin_figure_write (const QuoinFigure *figure, const char *path, QuoinError **error)
{
  if (!quoin_library_given (figure, "figure", error)
      || !quoin_library_given (path, "path", error))
    return false;
  QnFormat format;
  GError *cause = NULL;
  g_autoptr (GBytes) bytes = NULL;
  gsize length;
  if (qn_format_of_path (path, &format, &cause)
      && (bytes = encode (figure, format, &cause)) != NULL) {
    const void *content = g_bytes_get_data (bytes, &length);
    if (qn_file_replace (path, content, length, &cause))
      return true;
  }
  quoin_library_take_error (error, path, cause);
  return false;
}

void *
quoin_figure_encode (const QuoinFigure *figure, const char *format, size_t *length,
                     QuoinError **error)
{
  if (!quoin_library_given (figure, "figure", error)
      || !quoin_library_given (format, "format", error)
      || !quoin_library_given (length, "length", error))
    return NULL;
  QnFormat kind;
  GError *cause = NULL;
  g_autofree char *path = g_strconcat ("figure.", format, NULL);
  GBytes *bytes = NULL;
  if (qn_format_of_path (path, &kind, &cause))
    bytes = encode (figure, kind, &cause);
  if (bytes != NULL)
    return g_bytes_unref_to_data (bytes, length);
  quoin_library_take_error (error, NULL, cause);
  return NULL;
}
