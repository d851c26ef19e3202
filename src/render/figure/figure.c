#include "render/figure/figure.h"

#include "render/backend/offscreen.h"
#include "render/drawing/text.h"
#include "render/scene/motion.h"

#include <glib/gi18n-lib.h>
#include <string.h>

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

/* Of the shown result; not-a-number: no result. */
static double
shown_multiplier (const QnFigure *figure)
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
  double multiplier = shown_multiplier (figure);
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

/* ---- layout ----------------------------------------------------------------------------- */

/* A label of a block or joint is taken to reach no farther than so many times its size: where it is
 * farther from the edge it need not be measured. */
#define LONGEST_LABEL 12

/* How far markers, lines and labels reach beyond the box of the places: left, top, right and
 * bottom, px. */
static void
measure_overhang (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
                  double reach[4])
{
  QnVec2 low = qn_camera_to_screen (camera, scene->box.min);
  QnVec2 high = qn_camera_to_screen (camera, scene->box.max);
  memset (reach, 0, 4 * sizeof *reach);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *c = qn_scene_command (scene, i);
    double left = 0.6 * c->size * camera->unit, right = left, up = left, down = left;
    if (c->kind == QN_COMMAND_FILL || c->kind == QN_COMMAND_IMAGE)
      continue;
    if (!qn_command_has_size (c, camera))
      continue;
    QnVec2 a = qn_camera_to_screen (camera, c->box.min);
    QnVec2 b = qn_camera_to_screen (camera, c->box.max);
    if (c->kind == QN_COMMAND_TEXT) {
      double w, h, most = LONGEST_LABEL * c->size * camera->unit;
      if (c->extent > 0 && a.x - most > low.x && b.x + most < high.x && a.y + most < low.y
          && b.y - most > high.y)
        continue;
      qn_text_measure (cr, &(QnTextStyle){ .size = c->size * camera->unit }, c->text, &w,
                       &h);
      bool upright = fabs (sin (c->angle)) > 0.5;
      left = upright ? h * (1 - c->align_y) : w * c->align_x;
      right = upright ? h * c->align_y : w * (1 - c->align_x);
      up = upright ? w * (1 - c->align_x) : h * (1 - c->align_y);
      down = upright ? w * c->align_x : h * c->align_y;
    }
    reach[0] = fmax (reach[0], low.x - (a.x - left));
    reach[1] = fmax (reach[1], high.y - (b.y - up));
    reach[2] = fmax (reach[2], b.x + right - high.x);
    reach[3] = fmax (reach[3], a.y + down - low.y);
  }
}

void
qn_scene_fit (QnCamera *camera, const QnScene *scene, cairo_t *cr, double scale)
{
  double reach[4] = { 0, 0, 0, 0 };
  for (int pass = 0; pass < 4; pass++) {
    QnCamera inner = *camera;
    inner.width = fmax (camera->width - reach[0] - reach[2], 0.1 * camera->width);
    inner.height = fmax (camera->height - reach[1] - reach[3], 0.1 * camera->height);
    qn_camera_fit (&inner, scene->box, 0);
    if (scale > 0)
      inner.scale = scale;
    camera->scale = inner.scale;
    camera->center = inner.center;
    camera->center.x += 0.5 * (reach[2] - reach[0]) / camera->scale;
    camera->center.y += 0.5 * (reach[1] - reach[3]) / camera->scale;
    measure_overhang (scene, camera, cr, reach);
  }
}

/* Space between the parts, pt. */
#define PART_GAP 7.0

/* Least share of a frame that the structure keeps; furniture that would take more is left
 * out. */
#define LEAST_SHARE 0.35

/* Draws title and caption from the top of the frame, or only measures them; returns their
 * height with the gap. */
static double
draw_titles (const QnFigure *figure, const QnScene *scene, cairo_t *cr,
             const QnPage *page, const QnFrame *frame, bool draw)
{
  if (!figure->options.titles)
    return 0;
  g_autofree char *own =
    figure->caption == NULL ? qn_figure_dup_caption (figure, scene, false) : NULL;
  const char *caption = figure->caption != NULL ? figure->caption : own;
  const char *title = qn_figure_title (figure);
  QnTextStyle big = { .size = QN_TYPE_TITLE * page->unit,
                      .bold = true,
                      .width = frame->width };
  QnTextStyle small = { .size = QN_TYPE_TEXT * page->unit, .width = frame->width };
  double y = 0, width, height;
  if (title != NULL && *title != '\0') {
    qn_text_measure (cr, &big, title, &width, &height);
    if (draw)
      qn_text_draw (cr, &big, title, frame->x, frame->y, 0, 0, 0,
                    qn_ink (QN_INK_LINE, figure->options.monochrome));
    y += height + page->unit;
  }
  if (*caption != '\0') {
    qn_text_measure (cr, &small, caption, &width, &height);
    if (draw)
      qn_text_draw (cr, &small, caption, frame->x, frame->y + y, 0, 0, 0,
                    qn_ink (QN_INK_LINE, figure->options.monochrome));
    y += height;
  }
  return y > 0 ? y + PART_GAP * page->unit : 0;
}

/* Divides what the titles leave between the structure and the furniture, beside or below,
 * whichever lets the structure be larger. */
static bool
place_furniture (QnFurniture *furniture, QnCamera *view, const QnScene *scene,
                 double unit)
{
  double gap = PART_GAP * unit, column, column_height;
  double row = qn_furniture_row_height (furniture, view->width);
  qn_furniture_column_size (furniture, &column, &column_height);
  QnCamera below = *view, beside = *view;
  below.height = view->height - row - gap;
  beside.width = view->width - column - 2 * gap;

  bool below_fits = below.height > LEAST_SHARE * view->height;
  bool beside_fits =
    beside.width > LEAST_SHARE * view->width && column_height <= view->height;
  qn_camera_fit (&below, scene->box, 0);
  qn_camera_fit (&beside, scene->box, 0);
  bool as_column = beside_fits && (!below_fits || beside.scale > below.scale);
  if (!as_column && !below_fits) {
    furniture->count = 0;
    return false;
  }
  furniture->width = as_column ? column : view->width;
  furniture->height = as_column ? column_height : row;
  furniture->x = view->x + (as_column ? view->width - column : 0);
  furniture->y = view->y + view->height - furniture->height;
  *view = as_column ? beside : below;
  return as_column;
}

void
qn_figure_layout_init (QnFigureLayout *layout, const QnFigure *figure,
                       const QnScene *scene, cairo_t *cr, const QnPage *page,
                       const QnFrame *frame)
{
  double titles = draw_titles (figure, scene, cr, page, frame, false);
  *layout = (QnFigureLayout){ .frame = *frame,
                              .titles = titles <= (1 - LEAST_SHARE) * frame->height };
  if (!layout->titles)
    titles = 0;
  layout->camera = (QnCamera){ .scale = 1,
                               .unit = page->unit,
                               .x = frame->x,
                               .y = frame->y + titles,
                               .width = frame->width,
                               .height = frame->height - titles };
  if (figure->options.legend) {
    qn_furniture_init (&layout->furniture, scene, cr, page->unit, frame->width, true);
    layout->as_column =
      place_furniture (&layout->furniture, &layout->camera, scene, page->unit);
  }
  qn_scene_fit (&layout->camera, scene, cr, 0);
}

bool
qn_figure_layout_draw (const QnFigureLayout *layout, const QnFigure *figure,
                       const QnScene *scene, cairo_t *cr, const QnPage *page,
                       GError **error)
{
  if (layout->titles)
    draw_titles (figure, scene, cr, page, &layout->frame, true);
  if (!qn_scene_draw (scene, &layout->camera, cr, page, error))
    return false;
  if (layout->furniture.count > 0)
    qn_furniture_draw (&layout->furniture, cr, layout->camera.scale, layout->as_column);
  return true;
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
  qn_furniture_clear (&layout.furniture);
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
  qn_furniture_clear (&layout.furniture);
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

bool
qn_figure_draw_page (cairo_t *cr, const QnPage *page, void *figure, GError **error)
{
  QnFrame frame = qn_page_frame (page, PAGE_MARGIN);
  return qn_figure_draw (figure, cr, page, &frame, NULL, error);
}

QnMetadata
qn_figure_metadata (const QnFigure *figure, const QnMetadata *metadata)
{
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = qn_figure_title (figure);
  if (isnan (full.multiplier))
    full.multiplier = shown_multiplier (figure);
  return full;
}

bool
qn_figure_export (const QnFigure *figure, const char *path, const QnOutput *output,
                  const QnMetadata *metadata, GError **error)
{
  QnMetadata full = qn_figure_metadata (figure, metadata);
  QnFigure copy = *figure;
  return qn_page_export (path, output, &full, qn_figure_draw_page, &copy, error);
}

GBytes *
qn_figure_encode (const QnFigure *figure, QnFormat format, const QnOutput *output,
                  const QnMetadata *metadata, GError **error)
{
  QnMetadata full = qn_figure_metadata (figure, metadata);
  QnFigure copy = *figure;
  return qn_page_encode (format, output, &full, qn_figure_draw_page, &copy, error);
}
