/* Uncertain numbers: a probability distribution or a list of values.
 *
 * Values follow from the inverse of the cumulative distribution, so that every plan (random,
 * stratified or quasi-random) needs only points of the unit interval.
 */
#pragma once

#include <glib.h>

typedef enum {
  QN_DISTRIBUTION_NORMAL,
  QN_DISTRIBUTION_LOGNORMAL,
  QN_DISTRIBUTION_UNIFORM,
  QN_DISTRIBUTION_TRIANGULAR,
  QN_DISTRIBUTION_WEIBULL,
  QN_DISTRIBUTION_DISCRETE,
  QN_DISTRIBUTION_COUNT
} QnDistributionKind;

/* In the unit of the parameter. `first` and `second` are mean and deviation (normal), those of
 * the logarithm (lognormal), scale and shape (weibull); of a triangular one `first` is the mode.
 * Nothing lies outside min .. max, which cut off normal, lognormal and weibull distributions. */
typedef struct QnDistribution {
  QnDistributionKind kind;
  double first, second;
  double min, max;    /* -INFINITY, INFINITY where nothing is cut off */
  double *values;     /* DISCRETE: `count` values, owned, ascending or not */
  double *cumulative; /* DISCRETE: probability of this value and those before it, owned */
  gsize count;
} QnDistribution;

/* Spelling in study files: "normal", … */
extern const char *const qn_distribution_kind_names[QN_DISTRIBUTION_COUNT];

/* The value that the share u (0 < u < 1) of all values does not exceed. */
double qn_distribution_quantile (const QnDistribution *distribution, double u);

/* Whether min .. max holds any probability that can be told from none, and finite values only. */
gboolean qn_distribution_is_possible (const QnDistribution *distribution);

/* The logarithm's mean and deviation of a lognormal variable with this mean (> 0) and deviation. */
void qn_distribution_set_lognormal (QnDistribution *distribution, double mean,
                                    double deviation);

/* Values, all equally probable where `weights` (none negative, one of them positive) is NULL. */
void qn_distribution_set_values (QnDistribution *distribution, const double *values,
                                 const double *weights, gsize count);

void qn_distribution_clear (QnDistribution *distribution);
