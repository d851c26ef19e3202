/* What the benchmark programs share: processor time, the calibration kernel, result files.
 *
 * Results go to the folder that the environment variable QUOIN_BENCH_OUTPUT names, else to
 * "bench-results" where the program runs: NAME.csv and NAME.svg (chart.h) for each part, and
 * machine.txt.
 */
#pragma once

#include "core/base/progress.h"

#include <glib.h>
#include <stdio.h>

/* Sets the locale and reads the command line of a program that has no arguments: --help tells what
 * it measures (`summary`), anything else ends the program with exit code 2. */
void bench_no_arguments (int argc, char **argv, const char *summary);

/* Processor time of this process, s: what other processes do does not count. */
double bench_cpu_seconds (void);

/* A QnProgressFunc: cancels once bench_cpu_seconds() has passed *end, a double. */
bool bench_within_time (const QnProgress *progress, void *end);

/* Seconds that the calibration kernel takes here: ordering, factorising (CHOLMOD, simplicial)
 * and solving the five-point Laplacian of a grid of 150 x 150 points, best of five. Times
 * divided by it compare across machines. A machine that others use too is now faster, now slower:
 * what was measured more than a few seconds ago is measured anew. */
double bench_kernel_seconds (void);

/* The folder of the results. */
const char *bench_output_folder (void);

/* Most memory that the process has held since _reset_peak(), or in its life where the system
 * does not let it be reset, MB. */
void bench_reset_peak (void);
double bench_peak_megabytes (void);

/* Opens NAME.csv and writes the line of columns, to standard output too. The first call
 * describes the machine in machine.txt. */
FILE *bench_csv_open (const char *name, const char *columns);

/* One line, to the file and to standard output. */
void bench_csv_row (FILE *csv, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* What is demanded of the program: one line of NAME-bars.csv, with the headings
 * "bar,case,measured,demanded,met". A figure that is missing (NAN) is a demand not met. Returns
 * whether it is met. */
typedef enum { BENCH_AT_MOST, BENCH_AT_LEAST } BenchDemand;
FILE *bench_bars_open (const char *name);
gboolean bench_bar (FILE *csv, const char *bar, const char *what, double measured,
                    BenchDemand demand, double value);
