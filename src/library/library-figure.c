#include "core/base/word.h"
#include "doc/document/underlay.h"
#include "doc/view/report.h"
#include "doc/view/sheet.h"
#include "library/library-private.h"
#include "render/movie/animation.h"

#include <float.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

/* Views that are no picture of one model: of several results, or pages. */
typedef enum { PICTURE, CURVE, ENERGY, COMPARISON, REPORT } Kind;

static const char *const kind_names[] = {
  [CURVE] = "curve", [ENERGY] = "energy", [COMPARISON] = "compare", [REPORT] = "report"
};

struct QuoinFigure {
  QuoinModel *model;
  GPtrArray *results; /* of QuoinResult *, held, */
  GPtrArray *labels;  /* and of char *: what tells the first ones apart */
  Kind kind;
  QnFigure figure;
  QnOutput output;
  char *title, *caption;
  QnAnimation animation; /* its settings alone */
  double speed;          /* s of an analysis in time in a second; 0: by the frames */
  QnCurveSheet sheet;
  GArray *references; /* of QnReferenceLine, with labels of their own */
  double columns;
  QnReportTemplate plan;
};

static void
clear_reference (gpointer line)
{
  g_free ((char *) ((QnReferenceLine *) line)->label);
}

QuoinFigure *
quoin_figure_new (QuoinModel *model, QuoinResult *result, const char *view,
                  QuoinError **error)
{
  if (!quoin_library_given (model, "model", error)
      || !quoin_library_given (view, "view", error))
    return NULL;
  Kind kind = PICTURE;
  QnView picture = QN_VIEW_MODEL;
  GError *cause = NULL;
  if (!qn_find_word (view, kind_names, G_N_ELEMENTS (kind_names), &kind)
      && !qn_find_word (view, qn_view_names, QN_VIEW_COUNT, &picture))
    return quoin_library_set_error (error, QUOIN_ERROR_USAGE, "%s: no such view", view);
  if (result == NULL
      && (kind == PICTURE ? qn_view_needs_result (picture) : kind != REPORT))
    return quoin_library_set_error (error, QUOIN_ERROR_USAGE,
                                    "%s: this view needs a result", view);
  g_autoptr (QuoinFigure) figure = g_new0 (QuoinFigure, 1);
  figure->model = quoin_model_ref (model);
  figure->results = g_ptr_array_new_with_free_func ((GDestroyNotify) quoin_result_free);
  figure->labels = g_ptr_array_new_with_free_func (g_free);
  figure->kind = kind;
  figure->references = g_array_new (FALSE, FALSE, sizeof (QnReferenceLine));
  g_array_set_clear_func (figure->references, clear_reference);
  qn_figure_init (&figure->figure, &model->project.model, &model->contacts,
                  result != NULL ? &result->result : NULL, picture);
  qn_animation_init (&figure->animation, &model->project.model, &model->contacts,
                     result != NULL ? &result->result : NULL, picture);
  qn_output_init (&figure->output);
  if (result != NULL)
    quoin_figure_add (figure, result);
  if (kind == REPORT && !qn_report_template_read (&figure->plan, &model->project, &cause))
    return quoin_library_take_error (error, model->project.name, cause);
  return g_steal_pointer (&figure);
}

void
quoin_figure_add (QuoinFigure *figure, QuoinResult *result)
{
  if (figure != NULL && result != NULL)
    g_ptr_array_add (figure->results, quoin_library_result_ref (result));
}

void
quoin_figure_free (QuoinFigure *figure)
{
  if (figure == NULL)
    return;
  quoin_model_unref (figure->model);
  g_ptr_array_unref (figure->results);
  g_ptr_array_unref (figure->labels);
  g_array_unref (figure->references);
  qn_report_template_clear (&figure->plan);
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

/* Whether there is an option of this name and the value is one of its. */
static bool
set_option (QuoinFigure *figure, const char *name, const char *value, GError **cause)
{
  /* What is on or off beside the switches of a view, and numbers with the least that they may be. */
  const struct {
    const char *name;
    bool *flag;
    double *number, least;
  } known[] = { { "transparent", &figure->output.transparent, NULL, 0 },
                { "once", &figure->animation.once, NULL, 0 },
                { "curve", &figure->animation.curve, NULL, 0 },
                { "whole", &figure->sheet.whole, NULL, 0 },
                { "dpi", NULL, &figure->output.dpi, 1 },
                { "rate", NULL, &figure->animation.rate, 1 },
                { "speed", NULL, &figure->speed, DBL_MIN },
                { "until", NULL, &figure->sheet.until, DBL_MIN },
                { "columns", NULL, &figure->columns, 1 } };
  for (gsize i = 0; i < G_N_ELEMENTS (known); i++) {
    if (strcmp (known[i].name, name) != 0)
      continue;
    if (known[i].flag == NULL)
      return parse_number (value, known[i].least, known[i].number);
    *known[i].flag = strcmp (value, "on") == 0;
    return *known[i].flag || strcmp (value, "off") == 0;
  }
  if (strcmp (name, "size") == 0)
    return qn_output_parse_size (&figure->output, value, cause);
  if (strcmp (name, "frames") == 0) {
    double frames;
    bool given = parse_number (value, 2, &frames) && frames <= QN_MAX_FRAMES;
    figure->animation.frames = given ? (int) frames : 0;
    return given;
  }
  if (strcmp (name, "reference") == 0) {
    QnReferenceLine line;
    if (!qn_reference_line_parse (value, &line))
      return false;
    line.label = g_strdup (line.label != NULL ? line.label : "reference");
    g_array_append_val (figure->references, line);
    return true;
  }
  if (strcmp (name, "label") == 0) {
    g_ptr_array_add (figure->labels, g_strdup (value));
    return true;
  }
  if (figure->kind == REPORT
      && (strcmp (name, "paper") == 0 || strcmp (name, "sections") == 0
          || strcmp (name, "demand") == 0))
    return qn_report_template_set (&figure->plan, name, value, cause);
  if (strcmp (name, "title") == 0)
    keep_text (&figure->title, &figure->figure.title, value);
  else if (strcmp (name, "caption") == 0)
    keep_text (&figure->caption, &figure->figure.caption, value);
  else {
    /* An option of the picture; a step must be one of the result. */
    QnViewOptions *options = &figure->figure.options, before = *options;
    const QnResult *result = figure->figure.result;
    if (qn_view_options_set (options, name, value)
        && (options->step == QN_STEP_LAST
            || (result != NULL && (size_t) options->step < result->step_count)))
      return true;
    *options = before; /* what is refused changes nothing */
    return false;
  }
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
    return quoin_library_take_error (error, NULL, cause);
  return quoin_library_set_error (
    error, QUOIN_ERROR_USAGE, "%s=%s: no such option, or not a value of it", name, value);
}

/* ---- pictures ---- */

static bool
report_frame (int done, int total, void *data)
{
  QuoinCaller *caller = data;
  caller->steps = done;
  caller->reached = done;
  return quoin_library_tell (caller, (double) done / MAX (total, 1), 0);
}

static bool
animate (const QuoinFigure *self, const char *path, QuoinCaller *caller, GError **cause)
{
  QnMetadata metadata;
  QnAnimation animation = self->animation;
  qn_project_get_metadata (&self->model->project, &metadata);
  animation.progress = report_frame;
  animation.user_data = caller;
  animation.figure.options.monochrome = self->figure.options.monochrome;
  animation.figure.options.scale = self->figure.options.scale;
  return (self->speed == 0 || qn_animation_set_speed (&animation, self->speed, cause))
         && qn_animation_export (&animation, path, &self->output, &metadata, cause);
}

/* ---- sheets and reports ---- */

static QnSheetRun *
get_runs (const QuoinFigure *figure)
{
  QnSheetRun *runs = g_new0 (QnSheetRun, figure->results->len + 1);
  for (guint i = 0; i < figure->results->len; i++) {
    const QuoinResult *result = figure->results->pdata[i];
    runs[i] = (QnSheetRun){ .project = &result->model->project,
                            .contacts = &result->model->contacts,
                            .result = &result->result,
                            .name = i < figure->labels->len ? figure->labels->pdata[i]
                                                            : result->name };
  }
  return runs;
}

static GBytes *
encode_report (const QuoinFigure *figure, GError **cause)
{
  guint count = figure->results->len;
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, count + 1);
  g_autofree QnSheetRun *given = get_runs (figure);
  gboolean done = TRUE;
  for (guint i = 0; i < count && done; i++) {
    runs[i] = (QnReportRun){ .project = given[i].project,
                             .contacts = given[i].contacts,
                             .name = g_strdup (given[i].name) };
    done = qn_report_run_take (&runs[i], given[i].result, cause);
  }
  const QnReport report = { .project = &figure->model->project,
                            .contacts = &figure->model->contacts,
                            .runs = runs,
                            .run_count = count,
                            .plan = figure->plan,
                            .units = QN_UNITS_REPORT };
  GBytes *bytes = done ? qn_report_encode (&report, cause) : NULL;
  for (guint i = 0; i < count; i++)
    qn_report_run_clear (&runs[i]);
  return bytes;
}

static bool
write_sheet (const QuoinFigure *figure, const char *path, GError **cause)
{
  gsize count = figure->results->len;
  bool monochrome = figure->figure.options.monochrome;
  g_autofree QnSheetRun *runs = get_runs (figure);
  QnCurveSheet sheet = figure->sheet;
  sheet.title = figure->title;
  sheet.monochrome = monochrome;
  sheet.references = (const QnReferenceLine *) (void *) figure->references->data;
  sheet.reference_count = figure->references->len;
  if (figure->kind == ENERGY)
    return qn_energy_sheet_export (&sheet, runs, path, &figure->output, cause);
  if (figure->kind == CURVE)
    return qn_curve_sheet_export (&sheet, runs, count, path, &figure->output, cause);
  return qn_comparison_export (runs, count, (int) figure->columns, figure->title,
                               monochrome, path, &figure->output, cause);
}

/* ---- files ---- */

static bool
is_animation (const QuoinFigure *figure, const char *path)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  return figure->kind == PICTURE
         && (g_str_has_suffix (lower, ".gif") || g_str_has_suffix (lower, ".webm")
             || g_str_has_suffix (lower, "/") || g_file_test (path, G_FILE_TEST_IS_DIR));
}

static GBytes *
encode (const QuoinFigure *figure, const char *path, GError **cause)
{
  QnFormat format;
  if (!qn_format_of_path (path, &format, cause))
    return NULL;
  if (figure->kind == PICTURE) {
    QnMetadata metadata;
    QnFigure picture = figure->figure;
    qn_project_get_metadata (&figure->model->project, &metadata);
    if (!qn_underlay_read (&figure->model->project, FALSE, &picture.options.underlay,
                           cause))
      return NULL;
    GBytes *bytes =
      qn_figure_encode (&picture, format, &figure->output, &metadata, cause);
    g_clear_pointer (&picture.options.underlay.image, cairo_surface_destroy);
    return bytes;
  }
  if (format == QN_FORMAT_PDF)
    return encode_report (figure, cause);
  g_set_error (cause, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE, "%s: a report is a PDF",
               path);
  return NULL;
}

static bool
write_figure (const QuoinFigure *figure, const char *path, QuoinCaller *caller,
              GError **cause)
{
  gsize length;
  if (is_animation (figure, path))
    return animate (figure, path, caller, cause);
  if (figure->kind != PICTURE && figure->kind != REPORT)
    return write_sheet (figure, path, cause);
  g_autoptr (GBytes) bytes = encode (figure, path, cause);
  const void *content = bytes != NULL ? g_bytes_get_data (bytes, &length) : NULL;
  return content != NULL && qn_file_replace (path, content, length, cause);
}

bool
quoin_figure_write_watched (const QuoinFigure *figure, const char *path,
                            QuoinProgressFunc progress, void *data, QuoinError **error)
{
  GError *cause = NULL;
  QuoinCaller caller = { .func = progress, .data = data, .what = "frames" };
  if (!quoin_library_given (figure, "figure", error)
      || !quoin_library_given (path, "path", error))
    return false;
  if (write_figure (figure, path, &caller, &cause)) {
    if (caller.done < 1)
      quoin_library_tell (&caller, 1, 0);
    return true;
  }
  if (!caller.cancelled)
    return quoin_library_take_error (error, path, cause);
  g_error_free (cause);
  return quoin_library_set_error (error, QUOIN_ERROR_NO_ANSWER, "%s: cancelled", path);
}

bool
quoin_figure_write (const QuoinFigure *figure, const char *path, QuoinError **error)
{
  return quoin_figure_write_watched (figure, path, NULL, NULL, error);
}

/* What only files can take is written to one that goes again. */
static void *
encode_by_file (const QuoinFigure *figure, const char *format, size_t *length,
                GError **cause)
{
  char *content = NULL;
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", cause);
  if (folder == NULL)
    return NULL;
  g_autofree char *name = g_strconcat ("figure.", format, NULL);
  g_autofree char *path = g_build_filename (folder, name, NULL);
  QuoinCaller nobody = { 0 };
  if (write_figure (figure, path, &nobody, cause))
    g_file_get_contents (path, &content, length, cause);
  g_unlink (path);
  g_rmdir (folder);
  return content;
}

void *
quoin_figure_encode (const QuoinFigure *figure, const char *format, size_t *length,
                     QuoinError **error)
{
  GError *cause = NULL;
  if (!quoin_library_given (figure, "figure", error)
      || !quoin_library_given (format, "format", error)
      || !quoin_library_given (length, "length", error))
    return NULL;
  g_autofree char *path = g_strconcat ("figure.", format, NULL);
  if (is_animation (figure, path)
      || (figure->kind != PICTURE && figure->kind != REPORT)) {
    void *content = encode_by_file (figure, format, length, &cause);
    if (content != NULL)
      return content;
  } else {
    GBytes *bytes = encode (figure, path, &cause);
    if (bytes != NULL)
      return g_bytes_unref_to_data (bytes, length);
  }
  return quoin_library_take_error (error, NULL, cause);
}
