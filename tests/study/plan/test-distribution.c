/* Distributions: quantiles against closed forms, truncation in both tails. */
#include "study/plan/distribution.h"
#include "support/room.h"

#include <math.h>

static void
assert_near (double value, double expected)
{
  g_assert_cmpfloat_with_epsilon (value, expected, 1e-12 * fmax (1, fabs (expected)));
}

/* Mean and deviation by the midpoint rule over the unit interval. */
static void
moments (const QnDistribution *d, double *mean, double *deviation)
{
  enum { POINTS = 200000 };
  double sum = 0, square = 0;
  for (int i = 0; i < POINTS; i++) {
    double x = qn_distribution_quantile (d, (i + 0.5) / POINTS);
    sum += x;
    square += x * x;
  }
  *mean = sum / POINTS;
  *deviation = sqrt (square / POINTS - *mean * *mean);
}

static void
test_normal (void)
{
  QnDistribution d = { .kind = QN_DISTRIBUTION_NORMAL,
                       .first = 3,
                       .second = 2,
                       .min = -INFINITY,
                       .max = INFINITY };
  assert_near (qn_distribution_quantile (&d, 0.5), 3);
  assert_near (qn_distribution_quantile (&d, 0.975), 3 + 2 * 1.959963984540054);
  assert_near (qn_distribution_quantile (&d, 1e-10), 3 - 2 * 6.361340902404056);
}

static void
test_lognormal (void)
{
  double mean, deviation;
  QnDistribution d = { .min = -INFINITY, .max = INFINITY };
  qn_distribution_set_lognormal (&d, 0.65, 0.13);
  moments (&d, &mean, &deviation);
  g_assert_cmpfloat_with_epsilon (mean, 0.65, 1e-5);
  g_assert_cmpfloat_with_epsilon (deviation, 0.13, 1e-4);
}

static void
test_bounded (void)
{
  double mean, deviation;
  QnDistribution d = { .kind = QN_DISTRIBUTION_UNIFORM, .min = 2, .max = 6 };
  assert_near (qn_distribution_quantile (&d, 0.25), 3);
  d = (QnDistribution){
    .kind = QN_DISTRIBUTION_TRIANGULAR, .first = 3, .min = 2, .max = 6
  };
  assert_near (qn_distribution_quantile (&d, 0.25), 3); /* (3 - 2) / (6 - 2) */
  moments (&d, &mean, &deviation);
  g_assert_cmpfloat_with_epsilon (mean, (2 + 6 + 3) / 3.0, 1e-6);
  /* A mode at an end. */
  d.first = 2;
  assert_near (qn_distribution_quantile (&d, 0.75), 6 - 4 * sqrt (0.25));
}

static void
test_weibull (void)
{
  QnDistribution d = { .kind = QN_DISTRIBUTION_WEIBULL,
                       .first = 5,
                       .second = 2,
                       .min = -INFINITY,
                       .max = INFINITY };
  assert_near (qn_distribution_quantile (&d, 1 - exp (-1)), 5);
}

/* Numbers that a double cannot hold are none that a distribution may give. */
static void
test_overflow (void)
{
  QnDistribution uniform = { .kind = QN_DISTRIBUTION_UNIFORM,
                             .min = -1e308,
                             .max = 1e308 };
  g_assert_false (qn_distribution_is_possible (&uniform));
  uniform.max = 0;
  g_assert_true (qn_distribution_is_possible (&uniform));
  QnDistribution lognormal = { .min = -INFINITY, .max = INFINITY };
  qn_distribution_set_lognormal (&lognormal, 1e-300, 0.1);
  g_assert_false (qn_distribution_is_possible (&lognormal));
  qn_distribution_set_lognormal (&lognormal, 1e-3, 0.1);
  g_assert_true (qn_distribution_is_possible (&lognormal));
}

/* What is cut off is gone, and the shares of the rest keep their proportions; far out in either tail
 * too, where differences of probabilities near 1 would be nothing. */
static void
test_truncation (void)
{
  for (int sign = -1; sign <= 1; sign += 2) {
    QnDistribution d = { .kind = QN_DISTRIBUTION_NORMAL,
                         .first = 0,
                         .second = 1,
                         .min = sign > 0 ? 6 : -7,
                         .max = sign > 0 ? 7 : -6 };
    g_assert_true (qn_distribution_is_possible (&d));
    /* 9.8659e-10 lies beyond 6, 1.2798e-12 beyond 7; half of the difference is passed at: */
    double x = qn_distribution_quantile (&d, 0.5);
    g_assert_cmpfloat_with_epsilon (0.5 * erfc (fabs (x) / sqrt (2)),
                                    0.5 * (9.865876450376946e-10 + 1.279812543885835e-12),
                                    1e-15);
  }
  QnDistribution none = {
    .kind = QN_DISTRIBUTION_LOGNORMAL, .first = 0, .second = 0.1, .min = -2, .max = -1
  };
  g_assert_false (qn_distribution_is_possible (&none));
}

static void
test_discrete (void)
{
  const double values[] = { 5, 1, 3 }, weights[] = { 1, 2, 1 };
  QnDistribution d = { 0 };
  qn_distribution_set_values (&d, values, weights, 3);
  assert_near (qn_distribution_quantile (&d, 0.2), 5);
  assert_near (qn_distribution_quantile (&d, 0.26), 1);
  assert_near (qn_distribution_quantile (&d, 0.74), 1);
  assert_near (qn_distribution_quantile (&d, 0.76), 3);
  assert_near (qn_distribution_quantile (&d, 0.999999), 3);
  qn_distribution_clear (&d);
}

QN_TESTS
{
  g_test_add_func ("/study/distribution/normal", test_normal);
  g_test_add_func ("/study/distribution/lognormal", test_lognormal);
  g_test_add_func ("/study/distribution/bounded", test_bounded);
  g_test_add_func ("/study/distribution/weibull", test_weibull);
  g_test_add_func ("/study/distribution/overflow", test_overflow);
  g_test_add_func ("/study/distribution/truncation", test_truncation);
  g_test_add_func ("/study/distribution/discrete", test_discrete);
}
