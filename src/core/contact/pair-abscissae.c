#include "core/contact/pair-abscissae.h"

#include <math.h>

/* Newton steps towards a root of a Legendre polynomial; from the start below four are enough
 * for double precision. */
#define STEPS 8

static const double pi = 3.14159265358979323846;

size_t
qn_pair_rule_count (const QnPairRule *rule)
{
  return rule->placement == QN_PLACEMENT_ENDS ? 2 : (size_t) rule->count;
}

/* Legendre polynomial of degree n and its derivative by the three-term recurrence:
 *
 *   (k + 1) P[k+1] = (2k + 1) x P[k] - k P[k-1],   (x^2 - 1) P'[n] = n (x P[n] - P[n-1]) */
static double
legendre (size_t n, double x, double *derivative)
{
  double before = 1, p = x;

  for (size_t k = 1; k < n; k++) {
    double degree = (double) k, next = ((2 * degree + 1) * x * p - degree * before);
    before = p;
    p = next / (degree + 1);
  }
  *derivative = (double) n * (x * p - before) / (x * x - 1);
  return p;
}

void
qn_gauss_legendre (size_t n, size_t i, double *abscissa, double *weight)
{
  double count = (double) n, slope;
  /* Abramowitz & Stegun 22.16.6, first term. */
  double x = -cos (pi * ((double) i + 0.75) / (count + 0.5));

  if (2 * i + 1 == n)
    x = 0;
  for (int step = 0; step < STEPS && x != 0; step++) {
    double p = legendre (n, x, &slope);
    x -= p / slope;
  }
  legendre (n, x, &slope);
  *abscissa = x;
  *weight = 2 / ((1 - x * x) * slope * slope);
}

/* Share of pair i of n evenly spaced ones, at x_i in [-1, 1]: of all weights with sum x_i^2 w_i = 1/3
 * and sum w_i = 1 the ones closest to equal (least squares),
 *
 *   w_i = (1 + a (x_i^2 - m)) / n,   m = (1 - 1/n^2) / 3,   a = 15 n^2 / (4 (n^2 - 1) (n^2 - 4))
 *
 * For n = 3 and 4 this is Maclaurin's rule, 3/8 2/8 3/8 and 13/48 11/48 11/48 13/48. Two pairs
 * have no choice. */
static double
uniform_weight (double n, double x)
{
  double square = n * n;

  if (n < 3)
    return 1 / n;
  double a = 15 * square / (4 * (square - 1) * (square - 4));
  return (1 + a * (x * x - (1 - 1 / square) / 3)) / n;
}

void
qn_pair_rule_place (const QnPairRule *rule, double length, size_t i, double *position,
                    double *weight)
{
  double count = (double) qn_pair_rule_count (rule);

  *weight = 1 / count;
  switch (rule->placement) {
  case QN_PLACEMENT_ENDS:
    *position = i == 0 ? rule->offset / length : (length - rule->offset) / length;
    break;
  case QN_PLACEMENT_UNIFORM:
    *position = ((double) i + 0.5) / count;
    *weight = uniform_weight (count, 2 * *position - 1);
    break;
  case QN_PLACEMENT_GAUSS: {
    double abscissa, share;
    qn_gauss_legendre ((size_t) rule->count, i, &abscissa, &share);
    *position = 0.5 * (1 + abscissa);
    *weight = 0.5 * share;
    break;
  }
  case QN_PLACEMENT_EXPLICIT:
    *position = rule->positions[i];
    *weight = rule->weights[i];
    break;
  case QN_PLACEMENT_COUNT:
    QN_ASSERT (false);
  }
}
