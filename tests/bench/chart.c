#include "bench/chart.h"

#include "bench/bench.h"
#include "render/figure/plot.h"

#include <math.h>

static ChartSeries *
find_series (const Chart *chart, const char *label)
{
  for (size_t i = 0; i < chart->series_count; i++)
    if (g_str_equal (chart->series[i].label, label))
      return (ChartSeries *) &chart->series[i];
  return NULL;
}

void
chart_add (Chart *chart, const char *label, double x, double y)
{
  ChartSeries *series = find_series (chart, label);
  if (series == NULL) {
    g_assert_cmpuint (chart->series_count, <, G_N_ELEMENTS (chart->series));
    series = &chart->series[chart->series_count++];
    series->label = g_strdup (label);
    series->points = g_array_new (FALSE, FALSE, sizeof (ChartPoint));
  }
  const ChartPoint point = { x, y };
  g_array_append_val (series->points, point);
}

/* The point nearest to x by ratio. */
static const ChartPoint *
nearest (const ChartSeries *series, double x)
{
  const ChartPoint *best = &g_array_index (series->points, ChartPoint, 0);
  for (guint i = 1; i < series->points->len; i++) {
    const ChartPoint *point = &g_array_index (series->points, ChartPoint, i);
    if (fabs (log (point->x / x)) < fabs (log (best->x / x)))
      best = point;
  }
  return best;
}

double
chart_exponent (const Chart *chart, const char *label, double *x0, double *x1)
{
  const ChartSeries *series = find_series (chart, label);
  if (series == NULL)
    return NAN;
  const ChartPoint *a = nearest (series, *x0), *b = nearest (series, *x1);
  *x0 = a->x;
  *x1 = b->x;
  return a != b ? log (b->y / a->y) / log (b->x / a->x) : NAN;
}

static int
compare_points (gconstpointer a, gconstpointer b)
{
  double x = ((const ChartPoint *) a)->x, y = ((const ChartPoint *) b)->x;
  return (x > y) - (x < y);
}

static void
add_series (QnPlot *plot, ChartSeries *series, int index)
{
  guint count = series->points->len;
  double *x = qn_plot_keep (plot, g_new (double, count));
  double *y = qn_plot_keep (plot, g_new (double, count));
  g_array_sort (series->points, compare_points);
  for (guint i = 0; i < count; i++) {
    x[i] = g_array_index (series->points, ChartPoint, i).x;
    y[i] = g_array_index (series->points, ChartPoint, i).y;
  }
  QnMarks marks = { .kind = QN_MARKS_LINE,
                    .label = series->label,
                    .series = index,
                    .dash = index % 2 == 1 ? QN_USUAL_DASH : 0,
                    .x = x,
                    .y = y,
                    .count = count };
  qn_plot_add (plot, marks);
  marks.kind = QN_MARKS_POINTS;
  marks.label = NULL;
  qn_plot_add (plot, marks);
}

void
chart_write (Chart *chart)
{
  g_autofree char *file = g_strconcat (chart->name, ".svg", NULL);
  g_autofree char *path = g_build_filename (bench_output_folder (), file, NULL);
  g_autofree char *x_label =
    *chart->x_unit != '\0' ? g_strdup_printf ("%s (%s)", chart->x_label, chart->x_unit)
                           : g_strdup (chart->x_label);
  g_autoptr (QnPlot) plot = qn_plot_new (x_label, chart->y_label);
  GError *error = NULL;
  QnMetadata metadata;
  QnOutput output;

  if (chart->series_count == 0)
    return;
  plot->title = chart->title;
  plot->x.log = !chart->x_linear;
  plot->y.log = !chart->y_linear;
  for (size_t i = 0; i < chart->series_count; i++)
    add_series (plot, &chart->series[i], (int) i);
  qn_output_init (&output);
  output.width = 900;
  output.height = 640;
  qn_metadata_init (&metadata);
  if (!qn_plot_export (plot, path, &output, &metadata, &error))
    g_error ("%s", error->message);
  for (size_t i = 0; i < chart->series_count; i++) {
    g_free (chart->series[i].label);
    g_array_unref (chart->series[i].points);
  }
  chart->series_count = 0;
}
