/* Estimates of a distribution from a sample, with confidence intervals.
 *
 * Intervals hold the true value with a probability of 95 % for independent random cases. The cases
 * of a Latin hypercube or of a Sobol sequence cover the space more evenly: there the intervals are
 * wider than they need be, never narrower.
 */
#pragma once

#include <glib.h>

typedef struct QnInterval {
  double low, high;
} QnInterval;

typedef struct QnMoments {
  double mean, deviation; /* NaN: too few values */
  QnInterval of_mean;     /* by Student's distribution */
} QnMoments;

/* Values without NaN. */
QnMoments qn_moments (const double *values, gsize count);

/* The value that a share p of an ascending sample does not exceed, interpolated. */
double qn_quantile (const double *sorted, gsize count, double p);

/* Bounds of the true quantile: two of the values, chosen by the binomial distribution, whatever the
 * distribution of the values. An end that no value bounds is infinite. */
QnInterval qn_quantile_interval (const double *sorted, gsize count, double p);

/* Bounds of the probability of an event that occurred in `part` of `whole` (> 0) cases, after Clopper
 * and Pearson (Biometrika 26, 1934). */
QnInterval qn_share_interval (gsize part, gsize whole);

/* How many of an ascending sample do not exceed x. */
gsize qn_count_up_to (const double *sorted, gsize count, double x);

/* Rank correlation (Spearman); NaN where one of the two does not vary or there are fewer than
 * three values. */
double qn_rank_correlation (const double *a, const double *b, gsize count);

/* Shares of the variance of an output (Sobol 1993): `first` explained by a parameter alone, `total`
 * remaining if all others were known. */
typedef struct QnSobolIndex {
  double first, total;
  QnInterval of_first, of_total; /* by the bootstrap, 500 times */
} QnSobolIndex;

/* The indices of `width` parameters from blocks of width + 2 values in the order of sample.h, blocks
 * with a NaN left out. First-order after Saltelli et al. 2010, total after Jansen 1999. FALSE
 * where fewer than 8 blocks are whole or nothing varies. */
gboolean qn_sobol_indices (const double *values, gsize blocks, gsize width,
                           QnSobolIndex *indices);
