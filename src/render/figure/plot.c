#include "render/figure/plot.h"

#include "core/base/integer.h"
#include "render/backend/draw-cairo.h"
#include "render/drawing/paint.h"
#include "render/drawing/text.h"
#include "render/figure/figure-furniture.h"

#include <math.h>

/* Size of a dot, pt; with many of them, of the smallest. */
#define DOT       4.0
#define LEAST_DOT 1.8

#define DASH_GAP    2.5
#define LINE_WIDTH  1.3
#define LEVEL_WIDTH 0.8
#define BAND_ALPHA  0.22
#define BAR_ALPHA   0.75
#define PLOT_MARGIN 10.0
#define FAR_OFF     1e5  /* px */
#define LEAST_RANGE 2e-4 /* of an axis, over its middle: less is rounding */

/* Size of the numbers at the ticks and of the axes' names, pt. */
#define QN_TYPE_TICK  7.5
#define QN_TYPE_LABEL 8.5

/* Axes aim at a tick every so many pt. */
#define QN_TICK_SPACING_X 62.0
#define QN_TICK_SPACING_Y 36.0

typedef struct QnAxis {
  const QnPlotAxis *as;
  double low, high;   /* in displayed units, of a logarithmic axis their decades */
  double step, first; /* of the ticks */
  double start, end;  /* px */
} QnAxis;

typedef struct Drawing {
  const QnPlot *plot;
  cairo_t *cr;
  double unit;
  QnAxis x, y;
  QnColorBar bar;
} Drawing;

/* ---- data ---- */

QnPlot *
qn_plot_new (const char *x_label, const char *y_label)
{
  QnPlot *plot = g_new0 (QnPlot, 1);
  plot->x = (QnPlotAxis){ .label = x_label, .from_zero = true };
  plot->y = (QnPlotAxis){ .label = y_label, .from_zero = true };
  plot->marks = g_array_new (FALSE, FALSE, sizeof (QnMarks));
  plot->kept = g_ptr_array_new_with_free_func (g_free);
  return plot;
}

void
qn_plot_free (QnPlot *plot)
{
  g_array_unref (plot->marks);
  g_ptr_array_unref (plot->kept);
  g_free (plot);
}

void *
qn_plot_keep (QnPlot *plot, void *memory)
{
  g_ptr_array_add (plot->kept, memory);
  return memory;
}

QnMarks *
qn_plot_add (QnPlot *plot, QnMarks marks)
{
  g_array_append_val (plot->marks, marks);
  return &g_array_index (plot->marks, QnMarks, plot->marks->len - 1);
}

QnMarks *
qn_plot_mark (QnPlot *plot, QnMarkKind kind, const char *label, int series,
              const double *x, const double *y, size_t count)
{
  return qn_plot_add (plot,
                      (QnMarks){ kind, label, series, .x = x, .y = y, .count = count });
}

QnMarks *
qn_plot_points (QnPlot *plot, const char *label, int series, const double *x,
                const double *y, size_t count, QnMarker marker, double size)
{
  QnMarks *points = qn_plot_mark (plot, QN_MARKS_POINTS, label, series, x, y, count);
  points->marker = marker;
  points->size = size;
  return points;
}

/* ---- axes ---- */

/* Decades on an axis up to which they are divided. */
#define MOST_DIVIDED 2.2

/* Place of a value, px. */
static double
axis_place (const QnAxis *axis, double value)
{
  if (axis->as->log)
    value = log10 (value);
  return axis->start
         + (value - axis->low) / (axis->high - axis->low) * (axis->end - axis->start);
}

/* Ticks at multiples of a nice step over a length in px. A value beyond a tick by less than can be seen
 * needs no further tick. */
static void
axis_set (QnAxis *axis, double low, double high, double length, double spacing)
{
  if (!(high > low))
    high = low + (low != 0 ? fabs (low) : 1);
  /* A 1-2-5 step. */
  double raw = (high - low) / fmax (fabs (length) / spacing, 1),
         power = pow (10, floor (log10 (raw)));
  double digit = raw / power;
  axis->step = (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10) * power;
  double below = floor (low / axis->step + 1e-3) * axis->step;
  double above = ceil (high / axis->step - 1e-3) * axis->step;
  axis->low = low - below < 0.35 * axis->step ? below : low - 0.04 * (high - low);
  axis->high = above - high < 0.35 * axis->step ? above : high + 0.04 * (high - low);
  axis->first = ceil (axis->low / axis->step - 1e-9) * axis->step;
}

/* The tick after v; decades that leave room are divided at 2 and 5. */
static double
next_tick (const QnAxis *axis, double v)
{
  double part = v - floor (v + 1e-9);
  if (!axis->as->log || axis->step > 1 || axis->high - axis->low > MOST_DIVIDED)
    return v + axis->step;
  return floor (v + 1e-9) + (part < 0.2 ? log10 (2) : part < 0.5 ? log10 (5) : 1);
}

/* Ticks at decades, at most so many that they do not touch. */
static void
axis_set_log (QnAxis *axis, double low, double high, double length, double spacing)
{
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

/* The digits that distinguish neighbouring ticks; of decades, the power of ten. */
static char *
tick_text (const QnAxis *axis, double value)
{
  double step = axis->step;
  if (axis->as->names != NULL)
    return g_strdup (axis->as->names[qn_to_integer (value + 0.5, 0,
                                                    (int64_t) axis->as->name_count - 1)]);
  if (axis->as->log)
    return qn_label_number ("%.6g", pow (10, value));
  int digits = (int) qn_to_integer (-floor (log10 (step) + 1e-9), 0, 9);
  if (fabs (value) < 0.5 * step)
    value = 0;
  g_autofree char *format = g_strdup_printf ("%%.%df", digits);
  return qn_label_number (format, value);
}

static double
last_tick (const QnAxis *axis)
{
  return fmax (axis->low, axis->high) + 1e-9 * axis->step;
}

static double
tick_place (const QnAxis *axis, double tick)
{
  return axis_place (axis, axis->as->log ? pow (10, tick) : tick);
}

static void
line (cairo_t *cr, double x0, double y0, double x1, double y1)
{
  cairo_move_to (cr, x0, y0);
  cairo_line_to (cr, x1, y1);
  cairo_stroke (cr);
}

/* Grid lines, numbers and the frame of a plot. */
static void
axes_draw (const QnAxis *x, const QnAxis *y, cairo_t *cr, double unit, bool monochrome)
{
  QnTextStyle style = { .size = QN_TYPE_TICK * unit };
  QnColor ink = qn_ink (QN_INK_LINE, monochrome);
  for (double v = x->first; v <= last_tick (x); v = next_tick (x, v)) {
    double at = tick_place (x, v);
    g_autofree char *text = tick_text (x, v);
    cairo_set_line_width (cr, 0.4 * unit);
    qn_set_color (cr, qn_ink (QN_INK_FAINT, monochrome), 0.35);
    line (cr, at, y->start, at, y->end);
    qn_text_draw (cr, &style, text, at, y->start + 4 * unit, 0.5, 0, 0, ink);
  }
  for (double v = y->first; v <= last_tick (y); v = next_tick (y, v)) {
    double at = tick_place (y, v);
    g_autofree char *text = tick_text (y, v);
    cairo_set_line_width (cr, 0.4 * unit);
    qn_set_color (cr, qn_ink (QN_INK_FAINT, monochrome), 0.35);
    line (cr, x->start, at, x->end, at);
    qn_text_draw (cr, &style, text, x->start - 5 * unit, at, 1, 0.5, 0, ink);
  }
  qn_set_color (cr, ink, 1);
  cairo_set_line_width (cr, 0.7 * unit);
  cairo_rectangle (cr, x->start, y->end, x->end - x->start, y->start - y->end);
  cairo_stroke (cr);
}

/* Width of the widest number or name at a vertical axis, px. */
static double
axis_text_width (const QnAxis *axis, cairo_t *cr, double unit)
{
  double widest = 0;
  for (double v = axis->first; v <= last_tick (axis); v = next_tick (axis, v)) {
    double width, height;
    g_autofree char *text = tick_text (axis, v);
    qn_text_measure (cr, &(QnTextStyle){ .size = QN_TYPE_TICK * unit }, text, &width,
                     &height);
    widest = fmax (widest, width);
  }
  return widest;
}

/* The name of an axis beside its middle, where the page has room for all of it; smaller where it has not,
 * then in two lines, which take the room of a usual one. */
#define SMALLER  0.75
#define SMALLEST 0.6

static void
draw_name (cairo_t *cr, const char *name, double unit, double x, double y, double align_y,
           double angle, double room, QnColor ink)
{
  double width, height;
  QnTextStyle style = { .size = QN_TYPE_LABEL * unit };
  qn_text_measure (cr, &style, name, &width, &height);
  if (width > room)
    style.size *= room > SMALLER * width ? room / width : SMALLEST;
  if (room < SMALLER * width)
    style.width = room;
  qn_text_draw (cr, &style, name, x, y, 0.5, align_y, angle, ink);
}

/* ---- layout ---- */

static void
add_range (const double *numbers, size_t count, bool positive, double range[2])
{
  for (size_t i = 0; numbers != NULL && i < count; i++)
    if (isfinite (numbers[i]) && (!positive || numbers[i] > 0)) {
      range[0] = fmin (range[0], numbers[i]);
      range[1] = fmax (range[1], numbers[i]);
    }
}

static double
factor_of (const QnPlotAxis *axis)
{
  return axis->factor != 0 ? axis->factor : 1;
}

/* Ends of what is drawn, in written units; 0 … 1 where there is nothing. */
static void
set_axis (QnAxis *axis, const QnPlotAxis *as, const double found[2], double start,
          double end, double spacing)
{
  double factor = factor_of (as), range[2] = { found[0], found[1] };
  bool given = as->low < as->high;
  *axis = (QnAxis){ .as = as, .start = start, .end = end };
  if (as->names
      != NULL) { /* a tick per name, the first at the end that is drawn on top or right */
    axis->low = (double) as->name_count - 0.5;
    axis->high = -0.5;
    axis->step = 1;
    return;
  }
  if (!(range[0] <= range[1]))
    range[0] = range[1] = as->log ? 1 : 0;
  if (as->from_zero && !as->log) {
    range[0] = fmin (range[0], 0);
    range[1] = fmax (range[1], 0);
  }
  if (range[1] > 0 && !as->log)
    range[1] *= 1 + as->room;
  if (given) {
    range[0] = as->low;
    range[1] = as->high;
  } else if (range[1] > range[0]) {
    double middle = 0.5 * (range[0] + range[1]), half = 0.5 * LEAST_RANGE * fabs (middle);
    range[0] = fmin (range[0], middle - half);
    range[1] = fmax (range[1], middle + half);
  }
  (as->log ? axis_set_log : axis_set) (axis, range[0] * factor, range[1] * factor,
                                       end - start, spacing);
  if (given) { /* a linear axis ends there, with its ticks as they are */
    axis->low = range[0] * factor;
    axis->high = range[1] * factor;
    axis->first = ceil (axis->low / axis->step - 1e-9) * axis->step;
  }
}

static void
lay_out (Drawing *d, const QnFrame *frame, double top, double bottom)
{
  const QnPlot *plot = d->plot;
  double u = d->unit, x[2] = { INFINITY, -INFINITY }, y[2] = { INFINITY, -INFINITY };
  for (guint i = 0; i < plot->marks->len; i++) {
    const QnMarks *m = &g_array_index (plot->marks, QnMarks, i);
    add_range (m->x, m->count, plot->x.log, x);
    add_range (m->x_end, m->count, plot->x.log, x);
    add_range (m->y, m->count, plot->y.log, y);
    add_range (m->y_end, m->count, plot->y.log, y);
  }
  set_axis (&d->y, &plot->y, y, bottom - (3.1 * QN_TYPE_TICK + 4) * u,
            top + 0.6 * QN_TYPE_TICK * u, QN_TICK_SPACING_Y * u);
  double left = 1.8 * QN_TYPE_LABEL * u + axis_text_width (&d->y, d->cr, u) + 5 * u;
  double right = 2.2 * QN_TYPE_TICK * u;
  for (int pass = 0; pass < 2; pass++) { /* a long number at the end needs more */
    set_axis (&d->x, &plot->x, x, frame->x + left, frame->x + frame->width - right,
              QN_TICK_SPACING_X * u);
    right = fmax (right, 0.5 * axis_text_width (&d->x, d->cr, u));
  }
}

/* Cairo has no room for what lies very far from the part that is shown. */
static double
place (const QnAxis *axis, double value)
{
  double at = axis_place (axis, value * factor_of (axis->as));
  return axis->as->low < axis->as->high && isfinite (at) ? CLAMP (at, -FAR_OFF, FAR_OFF)
                                                         : at;
}

static double
px (const Drawing *d, double x)
{
  return place (&d->x, x);
}

static double
py (const Drawing *d, double y)
{
  return place (&d->y, y);
}

/* Whether the i-th of the marks has a place. */
static bool
is_placed (const Drawing *d, const QnMarks *m, size_t i)
{
  return isfinite (px (d, m->x[i])) && isfinite (py (d, m->y[i]));
}

/* ---- drawing ---- */

static QnColor
series_color (const QnPlot *plot, int series)
{
  return series == QN_SERIES_INK         ? qn_ink (QN_INK_LINE, plot->monochrome)
         : series == QN_SERIES_REFERENCE ? qn_ink (QN_INK_DEAD_LOAD, plot->monochrome)
                                         : qn_series_color (series, plot->monochrome);
}

static QnColor
color_of (const Drawing *d, const QnMarks *marks, size_t i)
{
  return marks->values == NULL
           ? series_color (d->plot, marks->series)
           : qn_color_bar_color (&d->bar, marks->values[i], d->plot->monochrome);
}

static void
draw_points (const Drawing *d, const QnMarks *m)
{
  double size =
    m->size > 0 ? m->size
    : m->values != NULL
      ? DOT
      : fmax (LEAST_DOT, DOT * pow (fmax ((double) m->count, 60) / 60, -0.25));
  double ahead = m->marker == QN_MARKER_ARROW_HEAD ? size * d->unit * cos (m->angle) : 0;
  for (size_t i = 0; i < m->count; i++)
    if (is_placed (d, m, i))
      qn_draw_cairo_marker (d->cr, m->marker, px (d, m->x[i]) + ahead, py (d, m->y[i]),
                            size * d->unit, m->angle, false, d->unit, color_of (d, m, i));
}

static void
set_line (const Drawing *d, const QnMarks *m, double width)
{
  double dashes[2] = { m->dash * d->unit, DASH_GAP * d->unit };
  qn_set_color (d->cr, color_of (d, m, 0), 1);
  cairo_set_line_width (d->cr, width * d->unit);
  cairo_set_line_join (d->cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash (d->cr, dashes, m->dash > 0 ? 2 : 0, 0);
}

/* Values that are not finite interrupt the line; a value between two gaps is a dot. */
static void
draw_line (const Drawing *d, const QnMarks *m)
{
  cairo_t *cr = d->cr;
  set_line (d, m, LINE_WIDTH);
  for (size_t i = 0; i < m->count; i++) {
    bool before = i > 0 && is_placed (d, m, i - 1);
    if (!is_placed (d, m, i)) {
      cairo_new_sub_path (cr);
      continue;
    }
    if (before && m->kind == QN_MARKS_STEPS)
      cairo_line_to (cr, px (d, m->x[i]), py (d, m->y[i - 1]));
    cairo_line_to (cr, px (d, m->x[i]), py (d, m->y[i]));
    if (!before && (i + 1 == m->count || !is_placed (d, m, i + 1))) {
      cairo_line_to (cr, px (d, m->x[i]), py (d, m->y[i]));
      cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
    }
  }
  cairo_stroke (cr);
}

static void
draw_levels (const Drawing *d, const QnMarks *m)
{
  set_line (d, m, LEVEL_WIDTH);
  for (size_t i = 0; i < m->count; i++) {
    if (!isfinite (py (d, m->y[i])))
      continue;
    cairo_move_to (d->cr, d->x.start, py (d, m->y[i]));
    cairo_line_to (d->cr, d->x.end, py (d, m->y[i]));
  }
  cairo_stroke (d->cr);
}

/* Along the lower edge and back along the upper one. */
static void
draw_band (const Drawing *d, const QnMarks *m)
{
  qn_set_color (d->cr, color_of (d, m, 0), BAND_ALPHA);
  for (size_t i = 0; i < m->count; i++) {
    if (i > 0)
      cairo_line_to (d->cr, px (d, m->x[i]), py (d, m->y[i - 1]));
    cairo_line_to (d->cr, px (d, m->x[i]), py (d, m->y[i]));
  }
  for (size_t i = m->count; i-- > 0;) {
    cairo_line_to (d->cr, px (d, m->x[i]), py (d, m->y_end[i]));
    if (i > 0)
      cairo_line_to (d->cr, px (d, m->x[i]), py (d, m->y_end[i - 1]));
  }
  cairo_close_path (d->cr);
  cairo_fill (d->cr);
}

/* Cells of a surface have no rim, bars have. */
static void
draw_rectangles (const Drawing *d, const QnMarks *m)
{
  for (size_t i = 0; i < m->count; i++) {
    double x0 = px (d, m->x[i]), x1 = px (d, m->x_end[i]);
    double y0 = py (d, m->y[i]), y1 = py (d, m->y_end[i]);
    QnColor c = color_of (d, m, i);
    cairo_rectangle (d->cr, fmin (x0, x1), fmin (y0, y1), fabs (x1 - x0), fabs (y1 - y0));
    qn_set_color (d->cr, c, m->values != NULL ? 1 : BAR_ALPHA);
    if (m->values != NULL) {
      cairo_fill (d->cr);
      continue;
    }
    cairo_fill_preserve (d->cr);
    qn_set_color (d->cr, c, 1);
    cairo_set_line_width (d->cr, 0.6 * d->unit);
    cairo_stroke (d->cr);
  }
}

static void
draw_whiskers (const Drawing *d, const QnMarks *m)
{
  double end = 2.2 * d->unit;
  qn_set_color (d->cr, qn_ink (QN_INK_LINE, d->plot->monochrome), 1);
  cairo_set_line_width (d->cr, 0.7 * d->unit);
  for (size_t i = 0; i < m->count; i++) {
    double x[2] = { px (d, m->x[i]), px (d, m->x_end[i]) }, y = py (d, m->y[i]);
    cairo_move_to (d->cr, x[0], y);
    cairo_line_to (d->cr, x[1], y);
    for (int k = 0; k < 2; k++) {
      cairo_move_to (d->cr, x[k], y - end);
      cairo_line_to (d->cr, x[k], y + end);
    }
    cairo_stroke (d->cr);
  }
}

static void
draw_marks (const Drawing *d, const QnMarks *marks)
{
  static void (*const kinds[]) (const Drawing *, const QnMarks *) = {
    [QN_MARKS_POINTS] = draw_points,
    [QN_MARKS_LINE] = draw_line,
    [QN_MARKS_STEPS] = draw_line,
    [QN_MARKS_BAND] = draw_band,
    [QN_MARKS_RECTANGLES] = draw_rectangles,
    [QN_MARKS_WHISKERS] = draw_whiskers,
    [QN_MARKS_LEVEL] = draw_levels,
  };
  cairo_save (d->cr);
  if (d->plot->x.low < d->plot->x.high || d->plot->y.low < d->plot->y.high) {
    cairo_rectangle (d->cr, d->x.start, d->y.end, d->x.end - d->x.start,
                     d->y.start - d->y.end);
    cairo_clip (d->cr);
  }
  if (marks->count > 0)
    kinds[marks->kind](d, marks);
  cairo_restore (d->cr);
}

/* Legend and colour bar as those of a scene without commands. */
static QnScene *
create_legend (const Drawing *d)
{
  const QnPlot *plot = d->plot;
  QnScene *scene = qn_scene_new ();
  scene->monochrome = plot->monochrome;
  for (guint i = 0; i < plot->marks->len; i++) {
    const QnMarks *m = &g_array_index (plot->marks, QnMarks, i);
    bool filled = m->kind == QN_MARKS_BAND || m->kind == QN_MARKS_RECTANGLES;
    QnColor color = series_color (plot, m->series);
    if (m->label == NULL || plot->without_legend)
      continue;
    if (m->kind == QN_MARKS_POINTS) {
      qn_scene_legend (scene, QN_COMMAND_MARKER, m->size > 0 ? m->size : DOT, color, "%s",
                       m->label)
        ->marker = (uint8_t) m->marker;
      continue;
    }
    QnLegendEntry *entry =
      qn_scene_legend (scene, filled ? QN_COMMAND_FILL : QN_COMMAND_STROKE,
                       m->kind == QN_MARKS_LEVEL ? LEVEL_WIDTH : 1.5,
                       qn_color_fade (color, m->kind == QN_MARKS_BAND ? BAND_ALPHA
                                             : filled                 ? BAR_ALPHA
                                                                      : 1),
                       "%s", m->label);
    entry->dashed = m->dash > 0;
  }
  scene->bar = d->bar;
  scene->bar.title = g_strdup (plot->bar_title);
  return scene;
}

/* Draws the title at the top of the frame and places the legend at its bottom, which the caller draws and
 * clears; the plot gets the heights left between *top and *bottom. */
static void
place_words (const Drawing *d, const QnScene *legend, const QnFrame *frame,
             QnFurniture *furniture, double *top, double *bottom)
{
  const double u = d->unit, width = frame->width;
  *top = frame->y;
  if (d->plot->title != NULL && *d->plot->title != '\0') {
    QnTextStyle style = { .size = QN_TYPE_TITLE * u, .bold = true, .width = width };
    double w, h;
    qn_text_measure (d->cr, &style, d->plot->title, &w, &h);
    qn_text_draw (d->cr, &style, d->plot->title, frame->x, *top, 0, 0, 0,
                  qn_ink (QN_INK_LINE, d->plot->monochrome));
    *top += h + 6 * u;
  }
  qn_furniture_init (furniture, legend, d->cr, u, width, false);
  furniture->x = frame->x;
  furniture->width = width;
  furniture->height = qn_furniture_row_height (furniture, width);
  furniture->y = frame->y + frame->height - furniture->height;
  *bottom = furniture->y - (furniture->count > 0 ? 6 * u : 0);
}

void
qn_plot_draw (const QnPlot *plot, cairo_t *cr, double u, const QnFrame *frame,
              QnPlotPlace *where)
{
  Drawing d = { .plot = plot, .cr = cr, .unit = u };
  double top, bottom, values[2] = { INFINITY, -INFINITY };
  QnFurniture furniture;
  for (guint i = 0; i < plot->marks->len; i++) {
    const QnMarks *m = &g_array_index (plot->marks, QnMarks, i);
    add_range (m->values, m->count, false, values);
  }
  d.bar = (QnColorBar){ .shown = plot->bar_title != NULL,
                        .min = fmin (values[0], values[1]),
                        .max = fmax (values[0], values[1]),
                        .factor = 1 };
  g_autoptr (QnScene) legend = create_legend (&d);
  place_words (&d, legend, frame, &furniture, &top, &bottom);
  lay_out (&d, frame, top, bottom);
  if (d.y.start > d.y.end && d.x.end > d.x.start) {
    axes_draw (&d.x, &d.y, cr, u, plot->monochrome);
    for (guint i = 0; i < plot->marks->len; i++)
      draw_marks (&d, &g_array_index (plot->marks, QnMarks, i));
    /* Names of the axes, the vertical one on the left, the horizontal one above `bottom`. */
    QnColor ink = qn_ink (QN_INK_LINE, plot->monochrome);
    double across = fabs (d.x.end - d.x.start), upright = fabs (bottom - d.y.end);
    draw_name (cr, d.x.as->label, u, 0.5 * (d.x.start + d.x.end), bottom, 1, 0, across,
               ink);
    draw_name (cr, d.y.as->label, u, frame->x, 0.5 * (d.y.end + bottom), 0, G_PI / 2,
               upright, ink);
  }
  qn_furniture_draw (&furniture, cr, 1, false);
  qn_furniture_clear (&furniture);
  if (where == NULL)
    return;
  *where = (QnPlotPlace){ .x_zero = axis_place (&d.x, 0),
                          .y_zero = axis_place (&d.y, 0),
                          .frame = { { d.x.start, d.y.end }, { d.x.end, d.y.start } } };
  where->x_scale = axis_place (&d.x, factor_of (&plot->x)) - where->x_zero;
  where->y_scale = axis_place (&d.y, factor_of (&plot->y)) - where->y_zero;
}

static bool
draw_page (cairo_t *cr, const QnPage *page, void *plot, GError **error)
{
  QnFrame frame = qn_page_frame (page, PLOT_MARGIN);
  (void) error;
  qn_plot_draw (plot, cr, page->unit, &frame, NULL);
  return true;
}

bool
qn_plot_export (const QnPlot *plot, const char *path, const QnOutput *output,
                const QnMetadata *metadata, GError **error)
{
  QnMetadata full = *metadata;
  QnPlot copy = *plot;
  if (full.title == NULL)
    full.title = plot->title;
  return qn_page_export (path, output, &full, draw_page, &copy, error);
}
