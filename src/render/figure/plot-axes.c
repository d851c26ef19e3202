#include "render/figure/plot-axes.h"

#include "core/base/integer.h"
#include "render/drawing/paint.h"
#include "render/drawing/text.h"

#include <glib.h>
#include <math.h>

/* Decades on an axis up to which they are divided. */
#define MOST_DIVIDED 2.2

double
qn_axis_place (const QnAxis *axis, double value)
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

/* A value beyond a tick by less than can be seen needs no further tick. */
void
qn_axis_set (QnAxis *axis, double low, double high, double length, double spacing)
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

void
qn_axis_cut (QnAxis *axis, double low, double high)
{
  axis->low = low;
  axis->high = high;
  axis->first = ceil (low / axis->step - 1e-9) * axis->step;
}

/* The tick after v; decades that leave room are divided at 2 and 5. */
static double
next_tick (const QnAxis *axis, double v)
{
  double part = v - floor (v + 1e-9);
  if (!axis->log || axis->step > 1 || axis->high - axis->low > MOST_DIVIDED)
    return v + axis->step;
  return floor (v + 1e-9) + (part < 0.2 ? log10 (2) : part < 0.5 ? log10 (5) : 1);
}

/* Ends at the next ninth of a decade. */
void
qn_axis_set_log (QnAxis *axis, double low, double high, double length, double spacing)
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

void
qn_axis_set_names (QnAxis *axis, const char *const *names, int count)
{
  axis->names = names;
  axis->name_count = count;
  axis->low = count - 0.5;
  axis->high = -0.5;
  axis->first = 0;
  axis->step = 1;
}

/* The digits that distinguish neighbouring ticks; of decades, the power of ten. */
static char *
tick_text (const QnAxis *axis, double value)
{
  double step = axis->step;
  if (axis->names != NULL)
    return g_strdup (axis->names[qn_to_integer (value + 0.5, 0, axis->name_count - 1)]);
  if (axis->log)
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
  return qn_axis_place (axis, axis->log ? pow (10, tick) : tick);
}

static void
line (cairo_t *cr, double x0, double y0, double x1, double y1)
{
  cairo_move_to (cr, x0, y0);
  cairo_line_to (cr, x1, y1);
  cairo_stroke (cr);
}

void
qn_axes_draw (const QnAxis *x, const QnAxis *y, cairo_t *cr, double unit, bool monochrome)
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

double
qn_axis_text_width (const QnAxis *axis, cairo_t *cr, double unit)
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

void
qn_axes_draw_names (const QnAxis *x, const QnAxis *y, cairo_t *cr, double unit,
                    const char *x_name, const char *y_name, double left, double bottom,
                    bool monochrome)
{
  QnColor ink = qn_ink (QN_INK_LINE, monochrome);
  double across = fabs (x->end - x->start), upright = fabs (bottom - y->end);
  draw_name (cr, x_name, unit, 0.5 * (x->start + x->end), bottom, 1, 0, across, ink);
  draw_name (cr, y_name, unit, left, 0.5 * (y->end + bottom), 0, G_PI / 2, upright, ink);
}
