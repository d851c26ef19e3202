#include "render/figure/data-plot.h"

#include "render/backend/draw-cairo.h"
#include "render/drawing/paint.h"
#include "render/drawing/scene.h"
#include "render/figure/figure-furniture.h"
#include "render/figure/plot-axes.h"

#include <math.h>

/* Size of a dot, pt; with many of them, of the smallest; where its colour says something. */
#define DOT         4.0
#define LEAST_DOT   1.8
#define COLORED_DOT 4.0

typedef struct Plot {
  const QnDataPlot *data;
  cairo_t *cr;
  double unit;
  QnAxis x, y;
  QnColorBar bar;
} Plot;

static void
add_range (const double *numbers, size_t count, double *low, double *high)
{
  for (size_t i = 0; numbers != NULL && i < count; i++)
    if (isfinite (numbers[i])) {
      *low = fmin (*low, numbers[i]);
      *high = fmax (*high, numbers[i]);
    }
}

/* Ends of all marks; 0 … 1 where there are none. */
static void
find_ranges (const QnDataPlot *data, double x[2], double y[2], double values[2])
{
  double *const ranges[] = { x, y, values };
  for (int i = 0; i < 3; i++) {
    ranges[i][0] = INFINITY;
    ranges[i][1] = -INFINITY;
  }
  for (size_t i = 0; i < data->mark_count; i++) {
    const QnMarks *m = &data->marks[i];
    add_range (m->x, m->count, &x[0], &x[1]);
    add_range (m->x_end, m->count, &x[0], &x[1]);
    add_range (m->y, m->count, &y[0], &y[1]);
    add_range (m->y_end, m->count, &y[0], &y[1]);
    add_range (m->values, m->count, &values[0], &values[1]);
  }
  for (int i = 0; i < 3; i++)
    if (!(ranges[i][0] <= ranges[i][1])) {
      ranges[i][0] = 0;
      ranges[i][1] = 1;
    }
  if (data->x_from_zero) {
    x[0] = fmin (x[0], 0);
    x[1] = fmax (x[1], 0);
  }
  if (data->y_from_zero) {
    y[0] = fmin (y[0], 0);
    y[1] = fmax (y[1], 0);
  }
}

static QnColor
color_of (const Plot *plot, const QnMarks *marks, size_t i)
{
  if (marks->values == NULL)
    return qn_series_color (marks->series, plot->data->monochrome);
  return qn_color_bar_color (&plot->bar, marks->values[i], plot->data->monochrome);
}

static double
px (const Plot *plot, double x)
{
  return qn_axis_place (&plot->x, x);
}

static double
py (const Plot *plot, double y)
{
  return qn_axis_place (&plot->y, y);
}

static void
draw_points (const Plot *plot, const QnMarks *m)
{
  double size = fmax (LEAST_DOT, DOT * pow (fmax ((double) m->count, 60) / 60, -0.25));
  if (m->values != NULL)
    size = COLORED_DOT;
  for (size_t i = 0; i < m->count; i++)
    if (isfinite (m->x[i]) && isfinite (m->y[i]))
      qn_draw_cairo_marker (plot->cr, QN_MARKER_DOT, px (plot, m->x[i]),
                            py (plot, m->y[i]), size * plot->unit, 0, plot->unit,
                            color_of (plot, m, i));
}

/* A value that is not finite interrupts the line; one between two of these is a dot. */
static void
draw_line (const Plot *plot, const QnMarks *m)
{
  double dashes[2] = { 4 * plot->unit, 2.5 * plot->unit };
  cairo_save (plot->cr);
  qn_set_color (plot->cr, color_of (plot, m, 0), 1);
  cairo_set_line_width (plot->cr, 1.3 * plot->unit);
  cairo_set_line_join (plot->cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash (plot->cr, dashes, m->dashed ? 2 : 0, 0);
  for (size_t i = 0; i < m->count; i++) {
    bool before = i > 0 && isfinite (m->y[i - 1]);
    if (!isfinite (m->y[i])) {
      cairo_new_sub_path (plot->cr);
      continue;
    }
    if (before && m->kind == QN_MARKS_STEPS)
      cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y[i - 1]));
    cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y[i]));
    if (!before && (i + 1 == m->count || !isfinite (m->y[i + 1]))) {
      cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y[i]));
      cairo_set_line_cap (plot->cr, CAIRO_LINE_CAP_ROUND);
    }
  }
  cairo_stroke (plot->cr);
  cairo_restore (plot->cr);
}

/* Along the lower edge and back along the upper one. */
static void
draw_band (const Plot *plot, const QnMarks *m)
{
  qn_set_color (plot->cr, color_of (plot, m, 0), 0.22);
  for (size_t i = 0; i < m->count; i++) {
    if (i > 0)
      cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y[i - 1]));
    cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y[i]));
  }
  for (size_t i = m->count; i-- > 0;) {
    cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y_end[i]));
    if (i > 0)
      cairo_line_to (plot->cr, px (plot, m->x[i]), py (plot, m->y_end[i - 1]));
  }
  cairo_close_path (plot->cr);
  cairo_fill (plot->cr);
}

/* Cells of a surface have no rim, bars have. */
static void
draw_rectangles (const Plot *plot, const QnMarks *m)
{
  for (size_t i = 0; i < m->count; i++) {
    double x0 = px (plot, m->x[i]), x1 = px (plot, m->x_end[i]);
    double y0 = py (plot, m->y[i]), y1 = py (plot, m->y_end[i]);
    QnColor c = color_of (plot, m, i);
    cairo_rectangle (plot->cr, fmin (x0, x1), fmin (y0, y1), fabs (x1 - x0),
                     fabs (y1 - y0));
    qn_set_color (plot->cr, c, m->values != NULL ? 1 : 0.75);
    if (m->values != NULL) {
      cairo_fill (plot->cr);
      continue;
    }
    cairo_fill_preserve (plot->cr);
    qn_set_color (plot->cr, c, 1);
    cairo_set_line_width (plot->cr, 0.6 * plot->unit);
    cairo_stroke (plot->cr);
  }
}

static void
draw_whiskers (const Plot *plot, const QnMarks *m)
{
  double end = 2.2 * plot->unit;
  qn_set_color (plot->cr, qn_ink (QN_INK_LINE, plot->data->monochrome), 1);
  cairo_set_line_width (plot->cr, 0.7 * plot->unit);
  for (size_t i = 0; i < m->count; i++) {
    double x[2] = { px (plot, m->x[i]), px (plot, m->x_end[i]) }, y = py (plot, m->y[i]);
    cairo_move_to (plot->cr, x[0], y);
    cairo_line_to (plot->cr, x[1], y);
    for (int k = 0; k < 2; k++) {
      cairo_move_to (plot->cr, x[k], y - end);
      cairo_line_to (plot->cr, x[k], y + end);
    }
    cairo_stroke (plot->cr);
  }
}

static void
draw_marks (const Plot *plot, const QnMarks *marks)
{
  switch (marks->kind) {
  case QN_MARKS_POINTS:
    draw_points (plot, marks);
    return;
  case QN_MARKS_LINE:
  case QN_MARKS_STEPS:
    draw_line (plot, marks);
    return;
  case QN_MARKS_BAND:
    draw_band (plot, marks);
    return;
  case QN_MARKS_RECTANGLES:
    draw_rectangles (plot, marks);
    return;
  case QN_MARKS_WHISKERS:
    draw_whiskers (plot, marks);
    return;
  }
  g_assert_not_reached ();
}

/* Legend and colour bar as those of a scene without commands. */
static QnScene *
create_legend (const Plot *plot)
{
  const QnDataPlot *data = plot->data;
  QnScene *scene = qn_scene_new ();
  scene->monochrome = data->monochrome;
  for (size_t i = 0; i < data->mark_count; i++) {
    const QnMarks *m = &data->marks[i];
    if (m->label == NULL)
      continue;
    bool filled = m->kind == QN_MARKS_BAND || m->kind == QN_MARKS_RECTANGLES;
    QnLegendEntry *entry =
      qn_scene_legend (scene,
                       m->kind == QN_MARKS_POINTS ? QN_COMMAND_MARKER
                       : filled                   ? QN_COMMAND_FILL
                                                  : QN_COMMAND_STROKE,
                       qn_color_fade (qn_series_color (m->series, data->monochrome),
                                      m->kind == QN_MARKS_BAND ? 0.22
                                      : filled                 ? 0.75
                                                               : 1),
                       "%s", m->label);
    entry->dashed = m->dashed;
    if (m->kind == QN_MARKS_POINTS) {
      entry->marker = QN_MARKER_DOT;
      entry->size = (float) DOT;
    }
  }
  if (data->bar_title != NULL) {
    scene->bar = plot->bar;
    scene->bar.title = g_strdup (data->bar_title);
  }
  return scene;
}

static void
lay_out (Plot *plot, double x, double top, double right, double bottom,
         const double x_range[2], const double y_range[2])
{
  const QnDataPlot *data = plot->data;
  double u = plot->unit;
  plot->y.start = bottom - (3.1 * QN_TYPE_TICK + 4) * u;
  plot->y.end = top + 0.6 * QN_TYPE_TICK * u;
  if (data->y_names != NULL)
    qn_axis_set_names (&plot->y, data->y_names, (int) data->y_name_count);
  else
    qn_axis_set (&plot->y, y_range[0], y_range[1], plot->y.start - plot->y.end,
                 QN_TICK_SPACING_Y * u);
  plot->x.start =
    x + 1.8 * QN_TYPE_LABEL * u + qn_axis_text_width (&plot->y, plot->cr, u) + 5 * u;
  plot->x.end = right - 2.2 * QN_TYPE_TICK * u;
  qn_axis_set (&plot->x, x_range[0], x_range[1], plot->x.end - plot->x.start,
               QN_TICK_SPACING_X * u);
}

void
qn_data_plot_draw (const QnDataPlot *data, cairo_t *cr, double page_width,
                   double page_height, double u, QnPlotPlace *place)
{
  double margin = fmin (10 * u, 0.1 * fmin (page_width, page_height));
  double width = page_width - 2 * margin, top = margin, bottom = page_height - margin;
  double x_range[2], y_range[2], values[2];
  Plot plot = { .data = data, .cr = cr, .unit = u };
  find_ranges (data, x_range, y_range, values);
  plot.bar = (QnColorBar){
    .shown = data->bar_title != NULL, .min = values[0], .max = values[1], .factor = 1
  };
  g_autoptr (QnScene) legend = create_legend (&plot);
  QnFurniture furniture;
  qn_furniture_init_plot (&furniture, legend, cr, u, data->title, data->monochrome,
                          margin, width, &top, &bottom);

  lay_out (&plot, margin, top, margin + width, bottom, x_range, y_range);
  if (plot.y.start > plot.y.end && plot.x.end > plot.x.start) {
    qn_axes_draw (&plot.x, &plot.y, cr, u, data->monochrome);
    for (size_t i = 0; i < data->mark_count; i++)
      draw_marks (&plot, &data->marks[i]);
    qn_axes_draw_names (&plot.x, &plot.y, cr, u, data->x_label, data->y_label, margin,
                        bottom, data->monochrome);
  }
  qn_furniture_draw (&furniture, cr, 1, false);
  qn_furniture_clear (&furniture);
  if (place != NULL)
    *place = (QnPlotPlace){ .x_zero = px (&plot, 0),
                            .x_scale = px (&plot, 1) - px (&plot, 0),
                            .y_zero = py (&plot, 0),
                            .y_scale = py (&plot, 1) - py (&plot, 0) };
}

static bool
draw_page (cairo_t *cr, const QnPage *page, void *user_data, GError **error)
{
  (void) error;
  cairo_set_antialias (cr,
                       page->antialias ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
  qn_data_plot_draw (user_data, cr, page->width, page->height, page->unit, NULL);
  return true;
}

bool
qn_data_plot_export (const QnDataPlot *plot, const char *path, const QnOutput *output,
                     const QnMetadata *metadata, GError **error)
{
  QnMetadata full = *metadata;
  QnDataPlot copy = *plot;
  if (full.title == NULL)
    full.title = plot->title;
  return qn_page_export (path, output, &full, draw_page, &copy, error);
}
