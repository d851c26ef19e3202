/* Charts of the benchmark programs, drawn by Quoin itself. */
#pragma once

#include <glib.h>

typedef struct ChartPoint {
  double x, y;
} ChartPoint;

/* A line of a chart. */
typedef struct ChartSeries {
  char *label;
  GArray *points; /* of ChartPoint */
} ChartSeries;

/* Series of a chart, created on first use of a label. */
typedef struct Chart {
  const char *name; /* of the file, without ending */
  const char *title;
  const char *x_label;
  const char *x_unit; /* "" for none */
  const char *y_label;
  gboolean x_linear, y_linear; /* otherwise decades */
  ChartSeries series[24];
  size_t series_count;
} Chart;

/* The points of a series are joined in the order of x. */
void chart_add (Chart *chart, const char *label, double x, double y);

/* Slope between the points of a series nearest to *x0 and *x1, both axes logarithmic; NAN where it
 * has no two of them. *x0 and *x1 become where these points are. */
double chart_exponent (const Chart *chart, const char *label, double *x0, double *x1);

/* Writes NAME.svg into the folder of the results, where there are points, and frees the series. */
void chart_write (Chart *chart);
