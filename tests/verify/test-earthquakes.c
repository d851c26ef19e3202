/* Analyses in time beside published values and independent integration, with contacts that stay where
 * they are drawn and with contacts that follow the blocks. */
#include "support/auto-clear.h"
#include "support/earthquakes.h"
#include "support/room.h"

#include <math.h>

/* Twenty frequencies from p to 10.5 p: it stands at 5 % less than the exact least amplitude, and
 * overturns at 5 % more. */
static void
test_overturning_boundary (gconstpointer follow)
{
  const double p = test_earthquake_block_frequency ();
  double energy_error = 0;
  for (int i = 0; i < 20; i++) {
    double omega = p * (1 + 0.5 * i), pulse = G_PI / omega;
    int impacts;
    double exact = test_earthquake_exact_boundary (1, pulse, &impacts);
    g_test_message ("omega/p %.1f: least amplitude %.4f g, %d impacts", omega / p,
                    exact / TEST_G, impacts);
    g_assert_cmpint (impacts, ==, 0);
    for (int k = 0; k < 2; k++) {
      QnModel model;
      test_earthquake_init_block (&model, (k == 0 ? 0.95 : 1.05) * exact, pulse);
      g_assert_cmpint (test_earthquake_overturns (&model, follow != NULL, &energy_error),
                       ==, k);
    }
  }
  g_test_message ("largest error of the energy balance %.1e", energy_error);
  g_assert_cmpfloat (energy_error, <, 1e-3);
}

/* The same under a full sine that overturns it after one impact: what damping by impact leaves decides. */
static void
test_overturning_after_impact (gconstpointer follow)
{
  const double p = test_earthquake_block_frequency ();
  double energy_error = 0;
  for (int i = 2; i < 6; i++) {
    double pulse = 2 * G_PI / (p * i);
    int impacts;
    double exact = test_earthquake_exact_boundary (2, pulse, &impacts);
    g_assert_cmpint (impacts, ==, 1);
    for (int k = 0; k < 2; k++) {
      QnModel model;
      test_earthquake_init_block_sine (&model, (k == 0 ? 0.98 : 1.02) * exact, pulse);
      g_assert_cmpint (test_earthquake_overturns (&model, follow != NULL, &energy_error),
                       ==, k);
    }
  }
  g_assert_cmpfloat (energy_error, <, 1e-3);
}

/* It stands at 5 % less than the least of the three, and overturns at 5 % more than the greatest.
 * Where the mode changes, around 0.34 s, standing and overturning alternate: docs/method/dynamics.md
 * reports that. */
static void
test_column (gconstpointer follow)
{
  double energy_error = 0;
  for (gsize i = 0; i < TEST_COLUMNS; i++)
    for (int k = 0; k < 2; k++) {
      const TestColumn *known = &test_columns[i];
      QnModel model;
      g_test_message ("impulse of %g s", known->duration);
      test_earthquake_init_column (
        &model, k == 0 ? 0.95 * known->least : 1.05 * known->greatest, known->duration);
      g_assert_cmpint (test_earthquake_overturns (&model, follow != NULL, &energy_error),
                       ==, k);
    }
  g_test_message ("largest error of the energy balance %.1e", energy_error);
  g_assert_cmpfloat (energy_error, <, 1e-3);
}

static void
test_arch (gconstpointer follow)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  double peaks[2], times[2];
  test_earthquake_init_arch (&model);
  test_earthquake_solve (&model, follow != NULL, &result);
  test_earthquake_arch_peaks (&model, &result.history, peaks, times);
  g_test_message ("%.2f mm at %.3f s, %.2f mm at %.3f s", 1e3 * peaks[0], times[0],
                  1e3 * peaks[1], times[1]);
  g_assert_cmpfloat (fabs (peaks[0] / TEST_ARCH_FIRST - 1), <, 0.1);
  g_assert_cmpfloat (fabs (times[0] / TEST_ARCH_FIRST_TIME - 1), <, 0.1);
  g_assert_cmpfloat (fabs (peaks[1] / TEST_ARCH_SECOND - 1), <, 0.1);
  g_assert_cmpfloat (fabs (times[1] / TEST_ARCH_SECOND_TIME - 1), <, 0.1);
  g_assert_cmpfloat (result.history.energy_error, <, 1e-3);
}

QN_TESTS
{
  static const struct {
    const char *name;
    GTestDataFunc test;
  } tests[] = { { "overturning-boundary", test_overturning_boundary },
                { "overturning-after-impact", test_overturning_after_impact },
                { "column", test_column },
                { "arch", test_arch } };
  for (gsize i = 0; i < G_N_ELEMENTS (tests); i++) {
    g_autofree char *fixed = g_strdup_printf ("/earthquakes/%s/fixed", tests[i].name);
    g_autofree char *follow = g_strdup_printf ("/earthquakes/%s/follow", tests[i].name);
    g_test_add_data_func (fixed, NULL, tests[i].test);
    g_test_add_data_func (follow, "", tests[i].test);
  }
}
