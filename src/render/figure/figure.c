#include "render/figure/figure.h"

#include "render/drawing/text.h"
#include "render/figure/figure-layout.h"
#include "render/scene/motion.h"

#include <glib/gi18n-lib.h>

/* Space around everything, pt. */
#define PAGE_MARGIN 8.0

void
qn_figure_init (QnFigure *figure, const QnModel *model, const QnContacts *contacts,
                const QnResult *result, QnView view)
{
  *figure = (QnFigure){ .model = model, .contacts = contacts, .result = result };
  qn_view_options_init (&figure->options, view);
}

const char *
qn_figure_title (const QnFigure *figure)
{
  return figure->title != NULL ? figure->title : figure->model->title;
}

QnFrame
qn_page_frame (const QnPage *page, double margin)
{
  margin = fmin (margin * page->unit, 0.1 * fmin (page->width, page->height));
  return (QnFrame){ .x = margin,
                    .y = margin,
                    .width = page->width - 2 * margin,
                    .height = page->height - 2 * margin };
}

static size_t
shown_step (const QnFigure *figure)
{
  const QnResult *result = figure->result;
  return figure->options.step == QN_STEP_LAST
           ? result->step_count - 1
           : MIN ((size_t) MAX (figure->options.step, 0), result->step_count - 1);
}

static bool
shows_result (const QnFigure *figure)
{
  return figure->result != NULL && qn_view_needs_result (figure->options.view);
}

double
qn_figure_multiplier (const QnFigure *figure)
{
  const QnResult *result = figure->result;
  if (!shows_result (figure) || result->history.width > 0)
    return (double) NAN;
  if (figure->options.view == QN_VIEW_MECHANISM && result->has_collapse_multiplier)
    return result->collapse_multiplier;
  return result->step_count > 0 ? result->steps[shown_step (figure)].multiplier
                                : (double) NAN;
}

/* ---- words ----------------------------------------------------------------------------- */

G_GNUC_PRINTF (2, 3)
static void
append_part (GString *text, const char *format, ...)
{
  va_list arguments;
  g_string_append (text, text->len > 0 ? " · " : "");
  va_start (arguments, format);
  g_string_append_vprintf (text, format, arguments);
  va_end (arguments);
}

/* When the step shown of an analysis in time was, and whether it overturned then. */
static void
append_time (GString *text, const QnFigure *figure)
{
  const QnResult *result = figure->result;
  if (result->step_count == 0)
    return;
  const QnStep *step = &result->steps[shown_step (figure)];
  g_autofree char *number = qn_label_number ("%.3f", step->time);
  append_part (text, _ ("t = %s s"), number);
  if (step->event == QN_EVENT_COLLAPSE)
    append_part (text, _ ("overturned"));
}

static void
append_multiplier (GString *text, const QnFigure *figure, bool brief)
{
  double multiplier = qn_figure_multiplier (figure);
  const QnResult *result = figure->result;
  if (isnan (multiplier))
    return;
  g_autofree char *number =
    qn_label_number (fabs (multiplier) < 10 ? "%.4f" : "%.5g", multiplier);
  append_part (text, brief ? "λ = %s" : _ ("load multiplier λ = %s"), number);
  if (brief || figure->options.view == QN_VIEW_MECHANISM || result->step_count == 0)
    return;
  size_t step = shown_step (figure);
  if (result->outcome == QN_OUTCOME_UNBOUNDED && step + 1 == result->step_count)
    append_part (text, _ ("any multiple of the live load is carried"));
  else if (result->steps[step].event == QN_EVENT_COLLAPSE)
    append_part (text, _ ("last equilibrium before collapse"));
  else if (result->steps[step].event == QN_EVENT_SNAP)
    append_part (text, _ ("after a jump"));
}

static void
append_mechanism (GString *text, const QnFigure *figure, const QnScene *scene)
{
  if (figure->options.view != QN_VIEW_MECHANISM || figure->contacts == NULL
      || figure->result->mechanism == NULL
      || figure->result->block_count != figure->model->block_count)
    return;
  if (figure->result->vibration.mode > 0) {
    g_autofree char *frequency =
      qn_label_number ("%.4g", figure->result->vibration.omega / (2 * G_PI));
    append_part (text, _ ("mode %d, %s Hz"), figure->result->vibration.mode, frequency);
    return;
  }
  append_part (text, "%s",
               figure->result->stability == QN_STABILITY_LOST
                 ? _ ("buckling mode")
                 : qn_mechanism_kind_text (scene->mechanism));
  if (figure->result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    append_part (text, _ ("no equilibrium under the dead load"));
  else if (figure->result->mechanism_uncertain)
    append_part (text, _ ("last motion"));
}

char *
qn_figure_dup_caption (const QnFigure *figure, const QnScene *scene, bool brief)
{
  g_autoptr (GString) text = g_string_new (NULL);
  const QnModel *model = figure->model;
  if (!shows_result (figure)) {
    if (model->block_count > 0 || model->beam_count == 0)
      append_part (text, ngettext ("%zu block", "%zu blocks", model->block_count),
                   model->block_count);
    if (model->beam_count > 0)
      append_part (text, ngettext ("%zu beam", "%zu beams", model->beam_count),
                   model->beam_count);
    return g_strdup (text->str);
  }
  if (figure->result->history.width > 0)
    append_time (text, figure);
  else
    append_multiplier (text, figure, brief);
  append_mechanism (text, figure, scene);
  if (figure->options.view == QN_VIEW_DEFORMED && scene->scale > 0) {
    g_autofree char *scale = qn_motion_dup_scale (scene->scale);
    append_part (text, "%s", scale);
  }
  return g_strdup (text->str);
}

bool
qn_figure_draw (const QnFigure *figure, cairo_t *cr, const QnPage *page,
                const QnFrame *frame, QnCamera *camera, GError **error)
{
  g_autoptr (QnScene) scene = qn_scene_build (figure->model, figure->contacts,
                                              figure->result, &figure->options, error);
  if (scene == NULL)
    return false;
  QnFigureLayout layout;
  qn_figure_layout_init (&layout, figure, scene, cr, page, frame);
  bool done = qn_figure_layout_draw (&layout, figure, scene, cr, page, error);
  if (camera != NULL)
    *camera = layout.camera;
  qn_figure_layout_clear (&layout);
  return done;
}

/* Scale at which the structure is drawn in a frame of this height. */
static double
scale_in (const QnFigure *figure, const QnScene *scene, cairo_t *cr, const QnPage *page,
          QnFrame frame, double height)
{
  QnFigureLayout layout;
  frame.height = height;
  qn_figure_layout_init (&layout, figure, scene, cr, page, &frame);
  double scale = layout.camera.scale;
  qn_figure_layout_clear (&layout);
  return scale;
}

/* Nearly as large, and the steps of the search for it. */
#define NEARLY        0.97
#define FITTING_STEPS 7

bool
qn_figure_fit_height (const QnFigure *figure, cairo_t *cr, const QnPage *page,
                      const QnFrame *frame, double *height, GError **error)
{
  g_autoptr (QnScene) scene = qn_scene_build (figure->model, figure->contacts,
                                              figure->result, &figure->options, error);
  if (scene == NULL)
    return false;
  double least = NEARLY * scale_in (figure, scene, cr, page, *frame, frame->height);
  double low = 0.2 * frame->height, high = frame->height;
  for (int i = 0; i < FITTING_STEPS; i++) {
    double middle = 0.5 * (low + high);
    if (scale_in (figure, scene, cr, page, *frame, middle) >= least)
      high = middle;
    else
      low = middle;
  }
  *height = high;
  return true;
}

/* ---- export ---------------------------------------------------------------------------- */

static bool
draw_figure_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  QnFrame frame = qn_page_frame (page, PAGE_MARGIN);

  return qn_figure_draw (data, cr, page, &frame, NULL, error);
}

QnMetadata
qn_figure_metadata (const QnFigure *figure, const QnMetadata *metadata)
{
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = qn_figure_title (figure);
  if (isnan (full.multiplier))
    full.multiplier = qn_figure_multiplier (figure);
  return full;
}

bool
qn_figure_export (const QnFigure *figure, const char *path, const QnOutput *output,
                  const QnMetadata *metadata, GError **error)
{
  QnMetadata full = qn_figure_metadata (figure, metadata);
  QnFigure copy = *figure;
  return qn_page_export (path, output, &full, draw_figure_page, &copy, error);
}

GBytes *
qn_figure_encode (const QnFigure *figure, QnFormat format, const QnOutput *output,
                  const QnMetadata *metadata, GError **error)
{
  QnMetadata full = qn_figure_metadata (figure, metadata);
  QnFigure copy = *figure;
  return qn_page_encode (format, output, &full, draw_figure_page, &copy, error);
}
