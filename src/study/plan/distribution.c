#include "study/plan/distribution.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <math.h>

/* Least probability between min and max. */
#define LEAST_PROBABILITY 1e-12

const char *const qn_distribution_kind_names[QN_DISTRIBUTION_COUNT] = {
  [QN_DISTRIBUTION_NORMAL] = "normal",   [QN_DISTRIBUTION_LOGNORMAL] = "lognormal",
  [QN_DISTRIBUTION_UNIFORM] = "uniform", [QN_DISTRIBUTION_TRIANGULAR] = "triangular",
  [QN_DISTRIBUTION_WEIBULL] = "weibull", [QN_DISTRIBUTION_DISCRETE] = "discrete",
};

/* Probability of less than x, or of more where `upper`: each is exact in its own tail. */
static double
tail (const QnDistribution *d, double x, gboolean upper)
{
  if (isinf (x))
    return (x > 0) != upper ? 1 : 0;
  if (d->kind == QN_DISTRIBUTION_NORMAL)
    return upper ? gsl_cdf_gaussian_Q (x - d->first, d->second)
                 : gsl_cdf_gaussian_P (x - d->first, d->second);
  if (x <= 0)
    return upper ? 1 : 0;
  if (d->kind == QN_DISTRIBUTION_LOGNORMAL)
    return upper ? gsl_cdf_lognormal_Q (x, d->first, d->second)
                 : gsl_cdf_lognormal_P (x, d->first, d->second);
  return upper ? gsl_cdf_weibull_Q (x, d->first, d->second)
               : gsl_cdf_weibull_P (x, d->first, d->second);
}

static double
inverse_tail (const QnDistribution *d, double p, gboolean upper)
{
  switch (d->kind) {
  case QN_DISTRIBUTION_NORMAL:
    return d->first
           + (upper ? gsl_cdf_gaussian_Qinv (p, d->second)
                    : gsl_cdf_gaussian_Pinv (p, d->second));
  case QN_DISTRIBUTION_LOGNORMAL:
    return upper ? gsl_cdf_lognormal_Qinv (p, d->first, d->second)
                 : gsl_cdf_lognormal_Pinv (p, d->first, d->second);
  case QN_DISTRIBUTION_WEIBULL:
    return upper ? gsl_cdf_weibull_Qinv (p, d->first, d->second)
                 : gsl_cdf_weibull_Pinv (p, d->first, d->second);
  case QN_DISTRIBUTION_UNIFORM:
  case QN_DISTRIBUTION_TRIANGULAR:
  case QN_DISTRIBUTION_DISCRETE:
  case QN_DISTRIBUTION_COUNT:
    break;
  }
  g_assert_not_reached ();
}

/* The part between min and max is what lies beyond min in the tail where that is smaller. */
static double
truncated_quantile (const QnDistribution *d, double u)
{
  gboolean upper = tail (d, d->min, FALSE) > 0.5;
  double at_min = tail (d, d->min, upper), at_max = tail (d, d->max, upper);
  double x = inverse_tail (d, at_min + u * (at_max - at_min), upper);
  return CLAMP (x, d->min, d->max);
}

/* F(x) = (x - a)^2 / ((b - a)(m - a)) up to the mode m, and likewise from the other end. */
static double
triangular_quantile (const QnDistribution *d, double u)
{
  double width = d->max - d->min, left = d->first - d->min;
  return u < left / width ? d->min + sqrt (u * width * left)
                          : d->max - sqrt ((1 - u) * width * (d->max - d->first));
}

static double
discrete_quantile (const QnDistribution *d, double u)
{
  gsize i = 0;
  while (i + 1 < d->count && u >= d->cumulative[i])
    i++;
  return d->values[i];
}

double
qn_distribution_quantile (const QnDistribution *d, double u)
{
  switch (d->kind) {
  case QN_DISTRIBUTION_UNIFORM:
    return d->min + u * (d->max - d->min);
  case QN_DISTRIBUTION_TRIANGULAR:
    return triangular_quantile (d, u);
  case QN_DISTRIBUTION_DISCRETE:
    return discrete_quantile (d, u);
  case QN_DISTRIBUTION_NORMAL:
  case QN_DISTRIBUTION_LOGNORMAL:
  case QN_DISTRIBUTION_WEIBULL:
    return truncated_quantile (d, u);
  case QN_DISTRIBUTION_COUNT:
    break;
  }
  g_assert_not_reached ();
}

gboolean
qn_distribution_is_possible (const QnDistribution *d)
{
  if (d->kind == QN_DISTRIBUTION_DISCRETE)
    return d->count > 0;
  /* All values lie between these two. */
  if (!(d->min < d->max) || !isfinite (qn_distribution_quantile (d, DBL_EPSILON / 2))
      || !isfinite (qn_distribution_quantile (d, 1 - DBL_EPSILON / 2)))
    return FALSE;
  if (d->kind == QN_DISTRIBUTION_UNIFORM || d->kind == QN_DISTRIBUTION_TRIANGULAR)
    return TRUE;
  gboolean upper = tail (d, d->min, FALSE) > 0.5;
  return fabs (tail (d, d->max, upper) - tail (d, d->min, upper)) > LEAST_PROBABILITY;
}

void
qn_distribution_set_lognormal (QnDistribution *d, double mean, double deviation)
{
  double cov = deviation / mean, variance = log1p (cov * cov);
  d->kind = QN_DISTRIBUTION_LOGNORMAL;
  d->second = sqrt (variance);
  d->first = log (mean) - 0.5 * variance;
}

void
qn_distribution_set_values (QnDistribution *d, const double *values,
                            const double *weights, gsize count)
{
  double sum = 0;
  d->kind = QN_DISTRIBUTION_DISCRETE;
  d->values = g_memdup2 (values, count * sizeof *values);
  d->cumulative = g_new (double, count);
  d->count = count;
  for (gsize i = 0; i < count; i++)
    d->cumulative[i] = sum += weights != NULL ? weights[i] : 1;
  for (gsize i = 0; i < count; i++)
    d->cumulative[i] /= sum;
}

void
qn_distribution_clear (QnDistribution *d)
{
  g_free (d->values);
  g_free (d->cumulative);
  *d = (QnDistribution){ 0 };
}
