/* Plots as data: what is in view, and where values lie. */
#include "render/figure/plot.h"

#include "support/room.h"

#include <math.h>

static const QnFrame frame = { 10, 20, 400, 300 };

static cairo_surface_t *
draw (const QnPlot *plot, QnPlotPlace *place)
{
  cairo_surface_t *surface =
    cairo_recording_surface_create (CAIRO_CONTENT_COLOR_ALPHA, NULL);
  cairo_t *cr = cairo_create (surface);
  qn_plot_draw (plot, cr, 1, &frame, place);
  g_assert_cmpint (cairo_status (cr), ==, CAIRO_STATUS_SUCCESS);
  cairo_destroy (cr);
  return surface;
}

/* The whole plot holds every value and 0; a part that is chosen ends where it is told to, and marks beyond
 * it stay out of sight. Values are given in SI and lie by the scale of the axis. */
static void
test_range (void)
{
  const double x[] = { 1, 2, 3, 10 }, y[] = { 5, 1e3, NAN, 2e3 };
  g_autoptr (QnPlot) plot = qn_plot_new ("x", "y");
  QnPlotPlace place;
  plot->x.factor = 1e3;
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_LINE, .x = x, .y = y, .count = 4 });
  cairo_surface_destroy (draw (plot, &place));
  for (int i = 0; i < 4; i++)
    g_assert_cmpfloat (place.x_zero + place.x_scale * x[i], <=, place.frame.max.x + 1e-9);
  g_assert_cmpfloat (place.x_zero, >=, place.frame.min.x - 1e-9);
  g_assert_cmpfloat (place.y_zero, <=, place.frame.max.y + 1e-9);
  g_assert_cmpfloat (place.y_zero + place.y_scale * 2e3, >=, place.frame.min.y - 1e-9);

  plot->x.low = 1.5;
  plot->x.high = 2.5;
  plot->y.low = 0;
  plot->y.high = 1500;
  cairo_rectangle_t ink;
  cairo_surface_t *surface = draw (plot, &place);
  g_assert_cmpfloat_with_epsilon (place.x_zero + place.x_scale * 1.5, place.frame.min.x,
                                  1e-9);
  g_assert_cmpfloat_with_epsilon (place.x_zero + place.x_scale * 2.5, place.frame.max.x,
                                  1e-9);
  g_assert_cmpfloat_with_epsilon (place.y_zero + place.y_scale * 1500, place.frame.min.y,
                                  1e-9);
  cairo_recording_surface_ink_extents (surface, &ink.x, &ink.y, &ink.width, &ink.height);
  g_assert_cmpfloat (ink.x + ink.width, <=, frame.x + frame.width + 1);
  g_assert_cmpfloat (ink.y, >=, frame.y - 1);
  cairo_surface_destroy (surface);
}

/* Values that differ by rounding alone are not drawn over the whole width, and no number at the end of
 * an axis is cut, whatever its digits. */
static void
test_narrow (void)
{
  const double x[] = { 0.35581234, 0.35581241 }, y[] = { 1, 2 };
  g_autoptr (QnPlot) plot = qn_plot_new ("x", "y");
  QnPlotPlace place;
  plot->x.from_zero = false;
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_LINE, .x = x, .y = y, .count = 2 });
  for (int zoomed = 0; zoomed < 2; zoomed++) {
    cairo_rectangle_t ink;
    if (zoomed) {
      plot->x.low = x[0];
      plot->x.high = x[1];
    }
    cairo_surface_t *surface = draw (plot, &place);
    double part = place.x_scale * (x[1] - x[0]) / (place.frame.max.x - place.frame.min.x);
    g_assert_cmpfloat (part, <=, zoomed ? 1 + 1e-6 : 0.01);
    cairo_recording_surface_ink_extents (surface, &ink.x, &ink.y, &ink.width,
                                         &ink.height);
    g_assert_cmpfloat (ink.x + ink.width, <=, frame.x + frame.width);
    cairo_surface_destroy (surface);
  }
}

/* What a plot keeps goes with it; marks without a place and plots without room are drawn as nothing. */
static void
test_odd (void)
{
  g_autoptr (QnPlot) plot = qn_plot_new ("x", "y");
  double *numbers = qn_plot_keep (plot, g_new0 (double, 2));
  const QnMarkKind kinds[] = { QN_MARKS_POINTS, QN_MARKS_LINE, QN_MARKS_STEPS,
                               QN_MARKS_LEVEL };
  numbers[1] = (double) NAN;
  plot->y.log = true;
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++)
    qn_plot_add (plot, (QnMarks){ .kind = kinds[i],
                                  .label = i % 2 == 0 ? "label" : NULL,
                                  .x = numbers,
                                  .y = numbers,
                                  .count = 2 });
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_POINTS, .label = "sample alone" });
  cairo_surface_destroy (draw (plot, NULL));
  plot->y.log = false;
  cairo_surface_destroy (draw (plot, NULL));
}

QN_TESTS
{
  g_test_add_func ("/render/plot/range", test_range);
  g_test_add_func ("/render/plot/narrow", test_narrow);
  g_test_add_func ("/render/plot/odd", test_odd);
}
