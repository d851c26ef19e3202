/* Statistics against closed forms and published values. */
#include "study/report/statistics.h"
#include "support/room.h"

#include <math.h>

static void
test_moments (void)
{
  const double values[] = { 1, 2, 3, 4, 5 };
  QnMoments m = qn_moments (values, 5);
  g_assert_cmpfloat_with_epsilon (m.mean, 3, 1e-15);
  g_assert_cmpfloat_with_epsilon (m.deviation, sqrt (2.5), 1e-14);
  /* t (4 degrees, 0.975) = 2.7764451 */
  g_assert_cmpfloat_with_epsilon (m.of_mean.high, 3 + 2.7764451 * sqrt (2.5 / 5), 1e-6);
  g_assert_true (isnan (qn_moments (values, 0).mean));
  g_assert_true (isnan (qn_moments (values, 1).deviation));
}

/* For the median of 20 values the 6th and the 15th (Conover, Practical Nonparametric Statistics). */
static void
test_quantiles (void)
{
  double sorted[20];
  for (int i = 0; i < 20; i++)
    sorted[i] = i + 1;
  g_assert_cmpfloat_with_epsilon (qn_quantile (sorted, 20, 0.5), 10.5, 1e-12);
  QnInterval interval = qn_quantile_interval (sorted, 20, 0.5);
  g_assert_cmpfloat (interval.low, ==, 6);
  g_assert_cmpfloat (interval.high, ==, 15);
  /* No value of five bounds the 99 % quantile from above. */
  g_assert_true (isinf (qn_quantile_interval (sorted, 5, 0.99).high));
  g_assert_cmpuint (qn_count_up_to (sorted, 20, 0.5), ==, 0);
  g_assert_cmpuint (qn_count_up_to (sorted, 20, 7), ==, 7);
  g_assert_cmpuint (qn_count_up_to (sorted, 20, 99), ==, 20);
}

/* Clopper and Pearson: 0 of n gives 1 - 0.025^(1/n); 5 of 10 gives 0.1871 to 0.8129. */
static void
test_shares (void)
{
  QnInterval none = qn_share_interval (0, 30), half = qn_share_interval (5, 10);
  g_assert_cmpfloat (none.low, ==, 0);
  g_assert_cmpfloat_with_epsilon (none.high, 1 - pow (0.025, 1.0 / 30), 1e-9);
  g_assert_cmpfloat_with_epsilon (half.low, 0.1870860, 1e-6);
  g_assert_cmpfloat_with_epsilon (half.high, 0.8129140, 1e-6);
  g_assert_cmpfloat (qn_share_interval (30, 30).high, ==, 1);
  for (gsize i = 1; i <= 1000; i++) {
    QnInterval interval = qn_share_interval (i, 1000);
    g_assert_cmpfloat (interval.low, <, (double) i / 1000);
    g_assert_cmpfloat (interval.high, >=, (double) i / 1000);
  }
}

static void
test_rank_correlation (void)
{
  const double a[] = { 1, 2, 3, 4 }, b[] = { 1, 8, 27, 64 }, c[] = { 4, 3, 2, 1 };
  const double same[] = { 1, 1, 1, 1 };
  g_assert_cmpfloat_with_epsilon (qn_rank_correlation (a, b, 4), 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (qn_rank_correlation (a, c, 4), -1, 1e-12);
  g_assert_true (isnan (qn_rank_correlation (a, same, 4)));
  g_assert_true (isnan (qn_rank_correlation (a, b, 2)));
}

/* What does not vary has no indices; a block with a hole is left out. */
static void
test_sobol_holes (void)
{
  double values[4 * 20], hole[4 * 20];
  QnSobolIndex indices[2];
  for (int i = 0; i < 80; i++)
    values[i] = 3;
  g_assert_false (qn_sobol_indices (values, 20, 2, indices));
  for (int i = 0; i < 80; i++)
    values[i] = hole[i] = sin (i);
  hole[40] = NAN;
  g_assert_true (qn_sobol_indices (hole, 20, 2, indices));
  g_assert_true (isfinite (indices[0].first) && isfinite (indices[1].of_total.high));
  g_assert_false (qn_sobol_indices (values, 7, 2, indices));
}

QN_TESTS
{
  g_test_add_func ("/study/statistics/moments", test_moments);
  g_test_add_func ("/study/statistics/quantiles", test_quantiles);
  g_test_add_func ("/study/statistics/shares", test_shares);
  g_test_add_func ("/study/statistics/rank-correlation", test_rank_correlation);
  g_test_add_func ("/study/statistics/sobol-holes", test_sobol_holes);
}
