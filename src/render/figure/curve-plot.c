#include "render/figure/curve-plot.h"

#include "core/base/integer.h"
#include "render/backend/draw-cairo.h"
#include "render/figure/figure-furniture.h"
#include "render/scene/camera.h"
#include "render/scene/paint.h"
#include "render/scene/scene.h"
#include "render/scene/text.h"

#include <glib/gi18n-lib.h>

#define TYPE_TICK  7.5
#define TYPE_LABEL 8.5

/* Axes aim at a tick every so many pt. */
#define TICK_SPACING_X 62.0
#define TICK_SPACING_Y 36.0

/* Decades on an axis up to which they are divided. */
#define MOST_DIVIDED 2.2

typedef struct Axis {
  double low, high;   /* in displayed units, of a logarithmic axis their decades */
  double step, first; /* of the ticks */
  bool log;
  double start, end; /* px */
} Axis;

typedef struct Plot {
  const QnCurvePlot *data;
  cairo_t *cr;
  double unit;
  double factor; /* of x, from SI to the unit shown */
  Axis x, y;
} Plot;

static double
axis_place (const Axis *axis, double value)
{
  if (axis->log)
    value = log10 (value);
  return axis->start
         + (value - axis->low) / (axis->high - axis->low) * (axis->end - axis->start);
}

/* A 1-2-5 step that gives about `count` ticks. */
static double
nice_step (double range, double count)
{
  double raw = range / fmax (count, 1), power = pow (10, floor (log10 (raw)));
  double digit = raw / power;
  return (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10) * power;
}

/* Ticks at multiples of a nice step; an end is rounded to the next tick where it is near, and
 * what passes one by less than can be seen does not ask for another. */
static void
set_axis (Axis *axis, double low, double high, double length, double spacing)
{
  if (!(high > low))
    high = low + (low != 0 ? fabs (low) : 1);
  axis->step = nice_step (high - low, fabs (length) / spacing);
  double below = floor (low / axis->step + 1e-3) * axis->step;
  double above = ceil (high / axis->step - 1e-3) * axis->step;
  axis->low = low - below < 0.35 * axis->step ? below : low - 0.04 * (high - low);
  axis->high = above - high < 0.35 * axis->step ? above : high + 0.04 * (high - low);
  axis->first = ceil (axis->low / axis->step - 1e-9) * axis->step;
}

/* The tick after v; decades that leave room are divided at 2 and 5. */
static double
next_tick (const Axis *axis, double v)
{
  double part = v - floor (v + 1e-9);
  if (!axis->log || axis->step > 1 || axis->high - axis->low > MOST_DIVIDED)
    return v + axis->step;
  return floor (v + 1e-9) + (part < 0.2 ? log10 (2) : part < 0.5 ? log10 (5) : 1);
}

/* Ticks at decades, at most so many that they do not touch; ends at the next ninth of one. */
static void
set_log_axis (Axis *axis, double low, double high, double length, double spacing)
{
  axis->log = true;
  axis->low = log10 (low) - 0.08;
  axis->high = fmax (log10 (high) + 0.08, axis->low + 0.3);
  axis->step = fmax (1, ceil ((axis->high - axis->low) * spacing / fabs (length)));
  axis->first = ceil (axis->low / axis->step) * axis->step;
  if (axis->high - axis->low > MOST_DIVIDED)
    return;
  axis->first = floor (axis->low);
  while (axis->first < axis->low)
    axis->first = next_tick (axis, axis->first);
}

/* Whether the point has a place on the axes. */
static bool
is_drawn (const QnCurvePlot *data, double x, double y)
{
  return isfinite (x) && isfinite (y) && (!data->x_log || x > 0)
         && (!data->y_log || y > 0);
}

static void
data_ranges (const QnCurvePlot *data, QnBox *box)
{
  *box = QN_BOX_EMPTY;
  for (size_t c = 0; c < data->curve_count; c++)
    for (size_t i = 0; i < data->curves[c].count; i++)
      if (is_drawn (data, data->curves[c].x[i], data->curves[c].y[i]))
        qn_box_add_point (box, qn_vec2 (data->curves[c].x[i], data->curves[c].y[i]));
  if (!(box->min.x <= box->max.x))
    *box = (QnBox){ { data->x_log, data->y_log }, { data->x_log, data->y_log } };
  for (size_t i = 0; i < data->reference_count; i++)
    if (is_drawn (data, 1, data->references[i].y))
      qn_box_add_point (box, qn_vec2 (box->min.x, data->references[i].y));
  /* Linear axes begin at 0. */
  if (!data->x_log)
    qn_box_add_point (box, qn_vec2 (0, box->min.y));
  if (!data->y_log)
    qn_box_add_point (box, qn_vec2 (box->min.x, 0));
  if (box->max.y > 0 && !data->y_log)
    box->max.y *= 1.04;
}

static void
set_ink (const Plot *plot, QnInk ink, double alpha)
{
  qn_set_color (plot->cr, qn_ink (ink, plot->data->monochrome), alpha);
}

/* The digits that tell neighbouring ticks apart; of decades, the power of ten. */
static char *
tick_text (const Axis *axis, double value)
{
  double step = axis->step;
  if (axis->log)
    return qn_label_number ("%.6g", pow (10, value));
  int digits = (int) qn_to_integer (-floor (log10 (step) + 1e-9), 0, 9);
  if (fabs (value) < 0.5 * step)
    value = 0;
  g_autofree char *format = g_strdup_printf ("%%.%df", digits);
  return qn_label_number (format, value);
}

static void
line (const Plot *plot, double x0, double y0, double x1, double y1)
{
  cairo_move_to (plot->cr, x0, y0);
  cairo_line_to (plot->cr, x1, y1);
  cairo_stroke (plot->cr);
}

static void
draw_ticks (const Plot *plot)
{
  double u = plot->unit;
  QnTextStyle style = { .size = TYPE_TICK * u };
  QnColor ink = qn_ink (QN_INK_LINE, plot->data->monochrome);
  for (double v = plot->x.first; v <= plot->x.high + 1e-9 * plot->x.step;
       v = next_tick (&plot->x, v)) {
    double x = axis_place (&plot->x, plot->x.log ? pow (10, v) : v);
    g_autofree char *text = tick_text (&plot->x, v);
    cairo_set_line_width (plot->cr, 0.4 * u);
    set_ink (plot, QN_INK_FAINT, 0.35);
    line (plot, x, plot->y.start, x, plot->y.end);
    qn_text_draw (plot->cr, &style, text, x, plot->y.start + 4 * u, 0.5, 0, 0, ink);
  }
  for (double v = plot->y.first; v <= plot->y.high + 1e-9 * plot->y.step;
       v = next_tick (&plot->y, v)) {
    double y = axis_place (&plot->y, plot->y.log ? pow (10, v) : v);
    g_autofree char *text = tick_text (&plot->y, v);
    cairo_set_line_width (plot->cr, 0.4 * u);
    set_ink (plot, QN_INK_FAINT, 0.35);
    line (plot, plot->x.start, y, plot->x.end, y);
    qn_text_draw (plot->cr, &style, text, plot->x.start - 5 * u, y, 1, 0.5, 0, ink);
  }
  set_ink (plot, QN_INK_LINE, 1);
  cairo_set_line_width (plot->cr, 0.7 * u);
  cairo_rectangle (plot->cr, plot->x.start, plot->y.end, plot->x.end - plot->x.start,
                   plot->y.start - plot->y.end);
  cairo_stroke (plot->cr);
}

/* Curves and references differ by dashes as well as by colour. */
static bool
is_dashed (const QnCurvePlot *data, size_t curve)
{
  return data->curve_count > 1 && curve % 2 == 1;
}

static void
draw_curve (const Plot *plot, size_t index)
{
  const QnCurve *curve = &plot->data->curves[index];
  double u = plot->unit, dashes[2] = { 4 * u, 2.5 * u };
  QnColor c = qn_series_color ((int) index, plot->data->monochrome);
  cairo_save (plot->cr);
  qn_set_color (plot->cr, c, 1);
  cairo_set_line_width (plot->cr, 1.3 * u);
  cairo_set_line_join (plot->cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash (plot->cr, dashes, is_dashed (plot->data, index) ? 2 : 0, 0);
  for (size_t i = 0; i < curve->count; i++)
    if (is_drawn (plot->data, curve->x[i], curve->y[i]))
      cairo_line_to (plot->cr, axis_place (&plot->x, curve->x[i] * plot->factor),
                     axis_place (&plot->y, curve->y[i]));
  cairo_stroke (plot->cr);
  cairo_restore (plot->cr);
  for (size_t i = 0; i < curve->count && plot->data->points; i++)
    if (is_drawn (plot->data, curve->x[i], curve->y[i]))
      qn_draw_cairo_marker (plot->cr, QN_MARKER_DOT,
                            axis_place (&plot->x, curve->x[i] * plot->factor),
                            axis_place (&plot->y, curve->y[i]), 4.5 * u, 0, u, c);

  const struct {
    ptrdiff_t at;
    QnMarker marker;
    double size;
  } marks[] = { { curve->limit_point, QN_MARKER_DIAMOND, 7 },
                { curve->collapse_point, QN_MARKER_CROSS, 6.5 },
                { curve->dot, QN_MARKER_DOT, 7.5 } };
  for (size_t k = 0; k < G_N_ELEMENTS (marks); k++)
    if (marks[k].at >= 0 && (size_t) marks[k].at < curve->count)
      qn_draw_cairo_marker (plot->cr, marks[k].marker,
                            axis_place (&plot->x, curve->x[marks[k].at] * plot->factor),
                            axis_place (&plot->y, curve->y[marks[k].at]),
                            marks[k].size * u, 0, u, c);
}

static QnColor
reference_color (const QnCurvePlot *data, size_t index)
{
  return index == 0
           ? qn_ink (QN_INK_DEAD_LOAD, data->monochrome)
           : qn_series_color ((int) (data->curve_count + index - 1), data->monochrome);
}

static void
draw_references (const Plot *plot)
{
  double u = plot->unit;
  for (size_t i = 0; i < plot->data->reference_count; i++) {
    double dashes[2] = { (i / 2 % 2 == 0 ? 5 : 1.5) * u, 2.5 * u };
    QnColor c = reference_color (plot->data, i);
    double y = axis_place (&plot->y, plot->data->references[i].y);
    cairo_save (plot->cr);
    qn_set_color (plot->cr, c, 1);
    cairo_set_line_width (plot->cr, 0.8 * u);
    cairo_set_dash (plot->cr, dashes, 2, 0);
    line (plot, plot->x.start, y, plot->x.end, y);
    cairo_restore (plot->cr);
  }
}

/* The legend as that of a scene without commands. */
static QnScene *
create_legend (const QnCurvePlot *data)
{
  QnScene *scene = qn_scene_new ();
  scene->monochrome = data->monochrome;
  QnColor ink = qn_ink (QN_INK_LINE, data->monochrome);
  bool limit = false, collapse = false;
  for (size_t i = 0; i < data->curve_count; i++) {
    const QnCurve *curve = &data->curves[i];
    limit |= curve->limit_point >= 0;
    collapse |= curve->collapse_point >= 0;
    if (curve->label != NULL)
      qn_scene_legend (scene, QN_COMMAND_STROKE,
                       qn_series_color ((int) i, data->monochrome), "%s", curve->label)
        ->dashed = is_dashed (data, i);
  }
  for (size_t i = 0; i < data->reference_count; i++) {
    g_autofree char *number = qn_label_number ("%.4g", data->references[i].y);
    QnLegendEntry *entry =
      qn_scene_legend (scene, QN_COMMAND_STROKE, reference_color (data, i), "%s (%s)",
                       data->references[i].label, number);
    entry->dashed = true;
    entry->size = 0.8f;
  }
  if (limit) {
    QnLegendEntry *entry =
      qn_scene_legend (scene, QN_COMMAND_MARKER, ink, "%s", _ ("first limit point"));
    entry->marker = QN_MARKER_DIAMOND;
    entry->size = 7;
  }
  if (collapse) {
    QnLegendEntry *entry =
      qn_scene_legend (scene, QN_COMMAND_MARKER, ink, "%s", _ ("collapse"));
    entry->marker = QN_MARKER_CROSS;
    entry->size = 6.5f;
  }
  return scene;
}

/* Width of the widest number on the vertical axis, px. */
static double
tick_width (const Plot *plot)
{
  double widest = 0;
  for (double v = plot->y.first; v <= plot->y.high + 1e-9 * plot->y.step;
       v = next_tick (&plot->y, v)) {
    double width, height;
    g_autofree char *text = tick_text (&plot->y, v);
    qn_text_measure (plot->cr, &(QnTextStyle){ .size = TYPE_TICK * plot->unit }, text,
                     &width, &height);
    widest = fmax (widest, width);
  }
  return widest;
}

static const char *
x_unit (const QnCurvePlot *data, double largest, double *factor)
{
  if (data->x_unit != NULL) {
    *factor = 1;
    return data->x_unit;
  }
  bool small = largest < (data->rotation ? 0.1 : 1.0);
  *factor = small ? 1000 : 1;
  if (data->rotation)
    return small ? "mrad" : "rad";
  return small ? "mm" : "m";
}

static void
draw_axis_labels (const Plot *plot, const char *unit, double x, double bottom)
{
  double u = plot->unit;
  QnTextStyle style = { .size = TYPE_LABEL * u };
  QnColor ink = qn_ink (QN_INK_LINE, plot->data->monochrome);
  const char *name =
    plot->data->x_label != NULL ? plot->data->x_label : _ ("Displacement");
  g_autofree char *label =
    *unit != '\0' ? g_strdup_printf ("%s (%s)", name, unit) : g_strdup (name);
  qn_text_draw (plot->cr, &style, label, 0.5 * (plot->x.start + plot->x.end), bottom, 0.5,
                1, 0, ink);
  qn_text_draw (plot->cr, &style,
                plot->data->y_label != NULL ? plot->data->y_label
                                            : _ ("Load multiplier λ"),
                x, 0.5 * (plot->y.start + plot->y.end), 0.5, 0, G_PI / 2, ink);
}

void
qn_curve_plot_draw (const QnCurvePlot *data, cairo_t *cr, const QnPage *page, double x,
                    double y, double width, double height)
{
  double u = page->unit;
  Plot plot = { .data = data, .cr = cr, .unit = u };
  cairo_set_antialias (cr,
                       page->antialias ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
  QnBox box;
  data_ranges (data, &box);
  const char *unit =
    x_unit (data, fmax (fabs (box.min.x), fabs (box.max.x)), &plot.factor);

  double top = y, bottom = y + height;
  if (data->title != NULL && *data->title != '\0') {
    QnTextStyle style = { .size = QN_TYPE_TITLE * u, .bold = true, .width = width };
    double w, h;
    qn_text_measure (cr, &style, data->title, &w, &h);
    qn_text_draw (cr, &style, data->title, x, y, 0, 0, 0,
                  qn_ink (QN_INK_LINE, data->monochrome));
    top += h + 6 * u;
  }
  g_autoptr (QnScene) legend = create_legend (data);
  QnFurniture furniture;
  qn_furniture_init (&furniture, legend, cr, u, width, false);
  furniture.x = x;
  furniture.width = width;
  furniture.height = qn_furniture_row_height (&furniture, width);
  furniture.y = bottom - furniture.height;
  bottom = furniture.y - (furniture.count > 0 ? 6 * u : 0);

  plot.y.start = bottom - (3.1 * TYPE_TICK + 4) * u;
  plot.y.end = top + 0.6 * TYPE_TICK * u;
  (data->y_log ? set_log_axis : set_axis) (&plot.y, box.min.y, box.max.y,
                                           plot.y.start - plot.y.end, TICK_SPACING_Y * u);
  plot.x.start = x + 1.8 * TYPE_LABEL * u + tick_width (&plot) + 5 * u;
  plot.x.end = x + width - 2.2 * TYPE_TICK * u;
  (data->x_log ? set_log_axis : set_axis) (&plot.x, box.min.x * plot.factor,
                                           box.max.x * plot.factor,
                                           plot.x.end - plot.x.start, TICK_SPACING_X * u);
  if (plot.y.start > plot.y.end && plot.x.end > plot.x.start) {
    draw_ticks (&plot);
    draw_references (&plot);
    for (size_t i = 0; i < data->curve_count; i++)
      draw_curve (&plot, i);
    draw_axis_labels (&plot, unit, x, bottom);
  }
  qn_furniture_draw (&furniture, cr, 1, false);
  qn_furniture_clear (&furniture);
}

static bool
draw_curve_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  (void) error;
  double margin = fmin (10 * page->unit, 0.1 * fmin (page->width, page->height));
  qn_curve_plot_draw (data, cr, page, margin, margin, page->width - 2 * margin,
                      page->height - 2 * margin);
  return true;
}

bool
qn_curve_export (const QnCurvePlot *plot, const char *path, const QnOutput *output,
                 const QnMetadata *metadata, GError **error)
{
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = plot->title;
  QnCurvePlot copy = *plot;
  return qn_page_export (path, output, &full, draw_curve_page, &copy, error);
}
