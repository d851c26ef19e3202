#include "render/figure/figure-furniture.h"

#include "render/backend/draw-cairo.h"
#include "render/drawing/paint.h"
#include "render/drawing/text.h"

/* Measures of the layout, pt. */
#define ROW_HEIGHT   12.5
#define BAR_HEIGHT   31.0
#define ITEM_GAP     14.0
#define LINE_GAP     3.0
#define SAMPLE_WIDTH 20.0
#define SAMPLE_GAP   5.0
#define SCALE_WIDTH  84.0
#define COLOR_WIDTH  128.0

typedef enum { ITEM_SCALE, ITEM_COLORS, ITEM_ENTRY } ItemKind;

/* The items in their order: scale bar, colour bar, legend entries. */
static ItemKind
item_kind (const QnFurniture *f, size_t item, const QnLegendEntry **entry)
{
  size_t bar = f->scale_bar ? 1 : 0;
  size_t first = bar + (f->scene->bar.shown ? 1 : 0);
  *entry = NULL;
  if (item < bar)
    return ITEM_SCALE;
  if (item < first)
    return ITEM_COLORS;
  *entry = &g_array_index (f->scene->legend, QnLegendEntry, item - first);
  return ITEM_ENTRY;
}

/* Where the text of an entry begins: beside its sample, where it has one. */
static double
text_left (const QnFurniture *f, const QnLegendEntry *entry)
{
  bool alone = entry->kind == QN_COMMAND_TEXT || entry->kind == QN_COMMAND_IMAGE;
  return alone ? 0 : (SAMPLE_WIDTH + SAMPLE_GAP) * f->unit;
}

static double
longest_word (cairo_t *cr, const QnTextStyle *style, const char *text)
{
  g_auto (GStrv) words = g_strsplit (text, " ", -1);
  double longest = 0;
  for (char **word = words; *word != NULL; word++) {
    double width, height;
    qn_text_measure (cr, style, *word, &width, &height);
    longest = fmax (longest, width);
  }
  return longest;
}

/* One that is wider than the limit wraps between its words, and is so much higher. */
static void
measure_entry (QnFurniture *f, size_t item, const QnLegendEntry *entry, cairo_t *cr,
               double limit)
{
  QnTextStyle style = { .size = QN_TYPE_LEGEND * f->unit };
  double left = text_left (f, entry), width, height;
  qn_text_measure (cr, &style, entry->text, &width, &height);
  f->widths[item] = left + width;
  if (f->widths[item] <= limit)
    return;
  f->widths[item] = fmax (limit, left + longest_word (cr, &style, entry->text));
  style.width = f->widths[item] - left + 1;
  qn_text_measure (cr, &style, entry->text, &width, &height);
  f->heights[item] = fmax (f->heights[item], height + LINE_GAP * f->unit);
}

void
qn_furniture_init (QnFurniture *f, const QnScene *scene, cairo_t *cr, double unit,
                   double limit, bool scale_bar)
{
  *f = (QnFurniture){ .scene = scene, .unit = unit, .scale_bar = scale_bar };
  f->count = scene->legend->len + (scene->bar.shown ? 1 : 0) + (scale_bar ? 1 : 0);
  f->widths = g_new0 (double, f->count);
  f->heights = g_new0 (double, f->count);
  for (size_t i = 0; i < f->count; i++) {
    const QnLegendEntry *entry;
    f->heights[i] = ROW_HEIGHT * unit;
    switch (item_kind (f, i, &entry)) {
    case ITEM_ENTRY:
      measure_entry (f, i, entry, cr, limit);
      break;
    case ITEM_COLORS:
      f->widths[i] = fmin (COLOR_WIDTH * unit, limit);
      f->heights[i] = BAR_HEIGHT * unit;
      break;
    case ITEM_SCALE:
      f->widths[i] = fmin (SCALE_WIDTH * unit, limit);
      break;
    }
  }
}

void
qn_furniture_clear (QnFurniture *f)
{
  g_free (f->widths);
  g_free (f->heights);
  *f = (QnFurniture){ 0 };
}

/* Place of the next item in a flow of rows; the cursor starts as { 0, 0, 0 }. */
typedef struct Flow {
  double x, y, row;
} Flow;

static void
flow_place (const QnFurniture *f, size_t item, double width, Flow *flow)
{
  if (flow->x > 0 && flow->x + f->widths[item] > width) {
    flow->y += flow->row;
    flow->x = flow->row = 0;
  }
  flow->row = fmax (flow->row, f->heights[item]);
}

double
qn_furniture_row_height (const QnFurniture *f, double width)
{
  Flow flow = { 0, 0, 0 };
  for (size_t i = 0; i < f->count; i++) {
    flow_place (f, i, width, &flow);
    flow.x += f->widths[i] + ITEM_GAP * f->unit;
  }
  return flow.y + flow.row;
}

void
qn_furniture_column_size (const QnFurniture *f, double *width, double *height)
{
  *width = *height = 0;
  for (size_t i = 0; i < f->count; i++) {
    *width = fmax (*width, f->widths[i]);
    *height += f->heights[i];
  }
}

/* ---- items ----------------------------------------------------------------------------- */

static void
rectangle_outline (cairo_t *cr, double x, double y, double width, double height,
                   double line, QnColor color)
{
  qn_set_color (cr, color, 1);
  cairo_set_line_width (cr, line);
  cairo_rectangle (cr, x, y, width, height);
  cairo_stroke (cr);
}

/* A bar of a 1-2-5 length with its half filled. */
static void
draw_scale_bar (const QnFurniture *f, cairo_t *cr, double x, double y, double scale)
{
  double u = f->unit;
  QnColor line = qn_ink (QN_INK_LINE, f->scene->monochrome);
  const double most = 0.6 * SCALE_WIDTH * u / scale;
  double power = pow (10, floor (log10 (most))), digit = most / power;
  double length = (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
  double width = length * scale, top = y + 4.2 * u, height = 3.2 * u;
  qn_set_color (cr, line, 1);
  cairo_rectangle (cr, x, top, 0.5 * width, height);
  cairo_fill (cr);
  rectangle_outline (cr, x, top, width, height, 0.6 * u, line);
  g_autofree char *number = qn_label_number ("%g", length >= 1 ? length : 1000 * length);
  g_autofree char *text = g_strconcat (number, length >= 1 ? " m" : " mm", NULL);
  qn_text_draw (cr, &(QnTextStyle){ .size = QN_TYPE_LEGEND * u }, text, x + width + 4 * u,
                y + 0.5 * ROW_HEIGHT * u, 0, 0.5, 0, line);
}

static void
draw_bar_number (const QnFurniture *f, cairo_t *cr, double value, double x, double y,
                 double align)
{
  g_autofree char *text = qn_label_number ("%.3g", value * f->scene->bar.factor);
  qn_text_draw (cr, &(QnTextStyle){ .size = (QN_TYPE_LEGEND - 0.5) * f->unit }, text, x,
                y, align, 0, 0, qn_ink (QN_INK_LINE, f->scene->monochrome));
}

static void
draw_color_bar (const QnFurniture *f, cairo_t *cr, double x, double y, double width)
{
  enum { STEPS = 64 };
  const QnColorBar *bar = &f->scene->bar;
  int monochrome = f->scene->monochrome;
  QnColor line = qn_ink (QN_INK_LINE, monochrome);
  double u = f->unit, top = y + 11 * u, height = 7 * u;
  qn_text_draw (cr, &(QnTextStyle){ .size = QN_TYPE_LEGEND * u }, bar->title, x, y, 0, 0,
                0, line);
  cairo_save (cr);
  cairo_set_antialias (cr, CAIRO_ANTIALIAS_NONE);
  for (int i = 0; i < STEPS; i++) {
    double value = bar->min + (bar->max - bar->min) * (i + 0.5) / STEPS;
    qn_set_color (cr, qn_color_bar_color (bar, value, monochrome), 1);
    cairo_rectangle (cr, x + i * width / STEPS, top, width / STEPS, height);
    cairo_fill (cr);
  }
  cairo_restore (cr);
  rectangle_outline (cr, x, top, width, height, 0.5 * u, line);
  double below = top + height + 1.5 * u;
  draw_bar_number (f, cr, bar->min, x, below, 0);
  /* Zero, where colours diverge, or else the middle. */
  double share = bar->max > bar->min ? -bar->min / (bar->max - bar->min) : 0;
  if (!bar->diverging || share < 0.25 || share > 0.75)
    share = 0.5;
  draw_bar_number (f, cr, bar->min + share * (bar->max - bar->min), x + share * width,
                   below, 0.5);
  draw_bar_number (f, cr, bar->max, x + width, below, 1);
}

static void
draw_hatch (cairo_t *cr, double x, double y, double width, double height, double u,
            QnColor color)
{
  cairo_save (cr);
  cairo_rectangle (cr, x, y, width, height);
  cairo_clip (cr);
  qn_set_color (cr, color, 1);
  cairo_set_line_width (cr, 0.5 * u);
  for (double s = x - height; s < x + width; s += 3.5 * u) {
    cairo_move_to (cr, s, y + height);
    cairo_line_to (cr, s + height, y);
  }
  cairo_stroke (cr);
  cairo_restore (cr);
}

/* A line of the sample's colour from its left end. */
static void
draw_sample_line (cairo_t *cr, const QnLegendEntry *entry, double x, double middle,
                  double length, double width)
{
  qn_set_color (cr, entry->color, 1);
  cairo_set_line_width (cr, width);
  cairo_move_to (cr, x, middle);
  cairo_line_to (cr, x + length, middle);
  cairo_stroke (cr);
}

static void
draw_sample_marker (cairo_t *cr, const QnLegendEntry *entry, double x, double middle,
                    double u)
{
  if (entry->marker == QN_MARKER_SLIDE) /* beside the line of the joint */
    draw_sample_line (cr, entry, x, middle, SAMPLE_WIDTH * u, 1.5 * u);
  if (entry->marker == QN_MARKER_ARROW_HEAD) {
    double head = (3 + 2.5 * entry->size) * u;
    draw_sample_line (cr, entry, x, middle, SAMPLE_WIDTH * u - 0.5 * head,
                      entry->size * u);
    qn_draw_cairo_marker (cr, QN_MARKER_ARROW_HEAD, x + SAMPLE_WIDTH * u, middle, head, 0,
                          false, u, entry->color);
    return;
  }
  qn_draw_cairo_marker (cr, (QnMarker) entry->marker, x + 0.5 * SAMPLE_WIDTH * u, middle,
                        entry->size * u, 0, false, u, entry->color);
}

static void
draw_entry (const QnFurniture *f, cairo_t *cr, const QnLegendEntry *entry, double x,
            double y, double width, double height)
{
  double u = f->unit, middle = y + 0.5 * height;
  QnColor line = qn_ink (QN_INK_LINE, f->scene->monochrome);
  double left = text_left (f, entry);
  switch ((QnCommandKind) entry->kind) {
  case QN_COMMAND_FILL:
    qn_set_color (cr, entry->color, 1);
    cairo_rectangle (cr, x, middle - 4 * u, SAMPLE_WIDTH * u, 8 * u);
    cairo_fill (cr);
    if (entry->hatched)
      draw_hatch (cr, x, middle - 4 * u, SAMPLE_WIDTH * u, 8 * u, u, line);
    rectangle_outline (cr, x, middle - 4 * u, SAMPLE_WIDTH * u, 8 * u, 0.5 * u, line);
    break;
  case QN_COMMAND_STROKE:
    qn_set_dashes (cr, entry->dashed, u);
    draw_sample_line (cr, entry, x, middle, SAMPLE_WIDTH * u, entry->size * u);
    qn_set_dashes (cr, false, u);
    break;
  case QN_COMMAND_MARKER:
    draw_sample_marker (cr, entry, x, middle, u);
    break;
  case QN_COMMAND_TEXT:
  case QN_COMMAND_IMAGE:
    break;
  }
  qn_text_draw (cr,
                &(QnTextStyle){ .size = QN_TYPE_LEGEND * u, .width = width - left + 1 },
                entry->text, x + left, middle, 0, 0.5, 0, line);
}

void
qn_furniture_draw (const QnFurniture *f, cairo_t *cr, double scale, bool as_column)
{
  Flow flow = { 0, 0, 0 };
  double flow_width = as_column ? 1 : f->width;
  for (size_t i = 0; i < f->count; i++) {
    const QnLegendEntry *entry;
    flow_place (f, i, flow_width, &flow);
    double x = f->x + flow.x, y = f->y + flow.y;
    switch (item_kind (f, i, &entry)) {
    case ITEM_SCALE:
      draw_scale_bar (f, cr, x, y, scale);
      break;
    case ITEM_COLORS:
      draw_color_bar (f, cr, x, y, f->widths[i] - 8 * f->unit);
      break;
    case ITEM_ENTRY:
      draw_entry (f, cr, entry, x, y, f->widths[i], f->heights[i]);
      break;
    }
    flow.x += f->widths[i] + ITEM_GAP * f->unit;
  }
}
