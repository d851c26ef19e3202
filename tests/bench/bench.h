/* What the benchmark programs share: processor time, the calibration kernel, result files and
 * charts.
 *
 * Results go to the folder that the environment variable QUOIN_BENCH_OUTPUT names, else to
 * "bench-results" where the program runs: NAME.csv and NAME.svg for each part, and machine.txt.
 */
#ifndef QN_TESTS_BENCH_H
#define QN_TESTS_BENCH_H

#include "core/progress.h"

#include <glib.h>
#include <stdio.h>

/* Processor time of this process, s: what other processes do does not count. */
double bench_cpu_seconds (void);

/* A QnProgressFunc: cancels once bench_cpu_seconds() has passed *end, a double. */
bool bench_within_time (const QnProgress *progress, void *end);

/* Seconds that the calibration kernel takes here: ordering, factorising (CHOLMOD, simplicial)
 * and solving the five-point Laplacian of a grid of 150 x 150 points, best of five. Times
 * divided by it compare across machines. Measured once per process. */
double bench_kernel_seconds (void);

/* Most memory that the process has held since _reset_peak(), or in its life where the system
 * does not let it be reset, MB. */
void bench_reset_peak (void);
double bench_peak_megabytes (void);

/* Opens NAME.csv and writes the line of columns, to standard output too. The first call
 * describes the machine in machine.txt. */
FILE *bench_csv_open (const char *name, const char *columns);

/* One line, to the file and to standard output. */
void bench_csv_row (FILE *csv, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* A line of a chart. */
typedef struct BenchSeries {
  char *label;
  GArray *x, *y; /* double */
} BenchSeries;

/* Series of a chart, created on first use of a label. */
typedef struct BenchChart {
  const char *name; /* of the file, without ending */
  const char *title;
  const char *x_label;
  const char *x_unit; /* "" for none */
  const char *y_label;
  BenchSeries series[16];
  size_t series_count;
} BenchChart;

void bench_chart_add (BenchChart *chart, const char *label, double x, double y);

/* Slope between the points of a series nearest to x0 and x1, both axes logarithmic; NAN where
 * it has no two of them. */
double bench_chart_exponent (const BenchChart *chart, const char *label, double x0,
                             double x1);

/* Writes NAME.svg, both axes logarithmic, and frees the series. */
void bench_chart_write (BenchChart *chart);

#endif
