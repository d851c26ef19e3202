/* Results of the benchmark programs held against those of an earlier run.
 *
 * A column's heading says what it holds and when it got worse:
 *   … outcome         text: from an answer to none, or to another answer
 *   … factorisations  count: larger at all
 *   … multiplier      lower by more than a relative margin, in rows without an error;
 *                     "limit multiplier", which is exact: different by more than 1e-6
 *   error …           %: farther from zero by more than the margin of a multiplier
 *   …/kernel          time in calibration kernels: larger by more than the noise of one time
 *   met               "yes" that became "no"
 * Where a table has a column "tolerance", twice that is the margin of its multipliers if it is the
 * larger. What was stopped by a time limit both times is not compared, its counts and multipliers
 * being those of the clock. All other columns but the keys, among them plain seconds, say
 * nothing that holds on another machine and are left out.
 *
 * Times are noisy, many together less: a table as a whole got worse where the geometric mean
 * of its times did, by more than the noise of a mean.
 */
#ifndef QN_TESTS_BENCH_COMPARE_H
#define QN_TESTS_BENCH_COMPARE_H

#include <glib.h>
#include <stdio.h>

typedef struct CompareMargins {
  double time;       /* one time may be so many times as large */
  double mean_time;  /* the geometric mean of a table's times, likewise */
  double short_time; /* kernels: times below are not compared */
  double multiplier; /* relative */
} CompareMargins;

CompareMargins compare_margins_default (void);

typedef struct CompareVerdict {
  int compared; /* figures */
  int worse, better;
  int missing; /* rows of the baseline that are not there any more: as bad as worse */
  int added;   /* rows that the baseline does not have */
} CompareVerdict;

/* Compares every table that both folders have, and writes to `out` a line for each and for every
 * figure that got worse or better. `partial`: tables and rows that were not run are no fault.
 * FALSE with an error where a folder or a table cannot be read. */
gboolean compare_folders (const char *baseline, const char *fresh,
                          const CompareMargins *margins, gboolean partial, FILE *out,
                          CompareVerdict *verdict, GError **error);

#endif
