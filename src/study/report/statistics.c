#include "study/report/statistics.h"

#include "core/base/integer.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <string.h>

/* Probability outside an interval, on each side. */
#define TAIL 0.025

#define RESAMPLES    500
#define LEAST_BLOCKS 8

QnMoments
qn_moments (const double *values, gsize count)
{
  QnMoments moments = { NAN, NAN, { NAN, NAN } };
  if (count == 0)
    return moments;
  moments.mean = gsl_stats_mean (values, 1, count);
  if (count == 1)
    return moments;
  moments.deviation = gsl_stats_sd_m (values, 1, count, moments.mean);
  double half = gsl_cdf_tdist_Qinv (TAIL, (double) (count - 1)) * moments.deviation
                / sqrt ((double) count);
  moments.of_mean = (QnInterval){ moments.mean - half, moments.mean + half };
  return moments;
}

double
qn_quantile (const double *sorted, gsize count, double p)
{
  return count > 0 ? gsl_stats_quantile_from_sorted_data (sorted, 1, count, p) : NAN;
}

/* The number of values below the true quantile is binomial: the k-th value is above it with the
 * probability of fewer than k. */
QnInterval
qn_quantile_interval (const double *sorted, gsize count, double p)
{
  QnInterval interval = { -INFINITY, INFINITY };
  /* Eight deviations below the mean there is nothing to find. */
  double n = (double) count, start = n * p - 8 * sqrt (n * p * (1 - p));
  for (gsize k = (gsize) qn_to_integer (start, 1, G_MAXINT32); k <= count; k++) {
    double fewer = gsl_cdf_binomial_P ((guint) k - 1, p, (guint) count);
    if (fewer <= TAIL)
      interval.low = sorted[k - 1];
    if (fewer >= 1 - TAIL) {
      interval.high = sorted[k - 1];
      break;
    }
  }
  return interval;
}

/* By halving: GSL's own inverse does not always converge. */
static double
beta_quantile (double share, double a, double b)
{
  double low = 0, high = 1;
  while (high - low > 1e-12) {
    double middle = 0.5 * (low + high);
    if (gsl_cdf_beta_P (middle, a, b) < share)
      low = middle;
    else
      high = middle;
  }
  return 0.5 * (low + high);
}

QnInterval
qn_share_interval (gsize part, gsize whole)
{
  double k = (double) part, n = (double) whole;
  return (QnInterval){ part > 0 ? beta_quantile (TAIL, k, n - k + 1) : 0,
                       part < whole ? beta_quantile (1 - TAIL, k + 1, n - k) : 1 };
}

gsize
qn_count_up_to (const double *sorted, gsize count, double x)
{
  gsize low = 0, high = count;
  while (low < high) {
    gsize middle = low + (high - low) / 2;
    if (sorted[middle] <= x)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

double
qn_rank_correlation (const double *a, const double *b, gsize count)
{
  g_autofree double *work = g_new (double, 2 * count);
  if (count < 3)
    return NAN;
  double r = gsl_stats_spearman (a, 1, b, 1, count, work);
  return isfinite (r) ? r : NAN;
}

/* The indices of the blocks that `chosen` names, in the order of the parameters: first, total. */
static gboolean
estimate (const double *values, gsize width, const gsize *chosen, gsize count,
          double *first, double *total)
{
  gsize rows = width + 2;
  double mean = 0, variance = 0;
  memset (first, 0, width * sizeof *first);
  memset (total, 0, width * sizeof *total);
  for (gsize i = 0; i < count; i++)
    mean += values[chosen[i] * rows] + values[chosen[i] * rows + 1];
  mean /= 2 * (double) count;
  for (gsize i = 0; i < count; i++) {
    const double *block = values + chosen[i] * rows;
    double a = block[0] - mean, b = block[1] - mean;
    variance += a * a + b * b;
    for (gsize k = 0; k < width; k++) {
      double mixed = block[k + 2] - mean;
      first[k] += b * (mixed - a);                 /* f(B) (f(AB) - f(A)) */
      total[k] += 0.5 * (a - mixed) * (a - mixed); /* (f(A) - f(AB))^2 / 2 */
    }
  }
  variance /= 2;
  for (gsize k = 0; k < width; k++) {
    first[k] /= variance;
    total[k] /= variance;
  }
  return variance > 0;
}

static QnInterval
interval_of (double *values, gsize stride)
{
  g_autofree double *sorted = g_new (double, RESAMPLES);
  for (gsize i = 0; i < RESAMPLES; i++)
    sorted[i] = values[i * stride];
  gsl_sort (sorted, 1, RESAMPLES);
  return (QnInterval){ qn_quantile (sorted, RESAMPLES, TAIL),
                       qn_quantile (sorted, RESAMPLES, 1 - TAIL) };
}

/* How the indices scatter when blocks are drawn again from themselves. */
static void
resample (const double *values, gsize width, const gsize *whole, gsize count,
          QnSobolIndex *indices)
{
  g_autofree double *first = g_new (double, RESAMPLES *width);
  g_autofree double *total = g_new (double, RESAMPLES *width);
  g_autofree gsize *chosen = g_new (gsize, count);
  gsl_rng *random = gsl_rng_alloc (gsl_rng_mt19937);
  for (gsize i = 0; i < RESAMPLES; i++) {
    for (gsize k = 0; k < count; k++)
      chosen[k] = whole[gsl_rng_uniform_int (random, count)];
    estimate (values, width, chosen, count, first + i * width, total + i * width);
  }
  gsl_rng_free (random);
  for (gsize k = 0; k < width; k++) {
    indices[k].of_first = interval_of (first + k, width);
    indices[k].of_total = interval_of (total + k, width);
  }
}

gboolean
qn_sobol_indices (const double *values, gsize blocks, gsize width, QnSobolIndex *indices)
{
  g_autofree gsize *whole = g_new (gsize, blocks);
  g_autofree double *first = g_new (double, width), *total = g_new (double, width);
  gsize count = 0;
  for (gsize i = 0; i < blocks; i++) {
    gboolean known = TRUE;
    for (gsize k = 0; k < width + 2; k++)
      known &= isfinite (values[i * (width + 2) + k]) != 0;
    if (known)
      whole[count++] = i;
  }
  if (count < LEAST_BLOCKS || !estimate (values, width, whole, count, first, total))
    return FALSE;
  for (gsize k = 0; k < width; k++)
    indices[k] = (QnSobolIndex){ .first = first[k], .total = total[k] };
  resample (values, width, whole, count, indices);
  return TRUE;
}
