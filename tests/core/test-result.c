#include "core/result.h"

#include <glib.h>
#include <math.h>

static void
test_steps_are_kept (void)
{
  QnResult result;
  double row[6];

  g_assert_cmpint (qn_result_init (&result, 2, 4, NULL), ==, QN_OK);
  for (int s = 0; s < 100; s++) {
    for (int i = 0; i < 6; i++)
      row[i] = 10 * s + i;
    g_assert_true (qn_result_add_step (&result, (QnStep){ .multiplier = s }, row));
  }
  g_assert_cmpuint (result.step_count, ==, 100);
  for (size_t s = 0; s < 100; s++) {
    g_assert_cmpfloat (result.steps[s].multiplier, ==, s);
    g_assert_cmpfloat (qn_result_step_displacements (&result, s)[5], ==, 10.0 * s + 5);
  }
  qn_result_clear (&result);
}

static void
test_mechanism_scale (void)
{
  QnResult result;
  const double moving[6] = { 0, 0, 0, 3, -4, 20 }, turning[6] = { 0, 0, 2, 0, 0, -1 };
  const double resting[6] = { 0 };

  g_assert_cmpint (qn_result_init (&result, 2, 0, NULL), ==, QN_OK);
  g_assert_cmpint (qn_result_set_mechanism (&result, moving, 0.5, NULL), ==, QN_OK);
  g_assert_cmpfloat_with_epsilon (hypot (result.mechanism[3], result.mechanism[4]), 1,
                                  1e-15);
  g_assert_cmpfloat_with_epsilon (result.mechanism[5], 4, 1e-15);

  /* Blocks that only turn are scaled by their turning. */
  g_assert_cmpint (qn_result_set_mechanism (&result, turning, 0.5, NULL), ==, QN_OK);
  g_assert_cmpfloat_with_epsilon (result.mechanism[2] * 0.5, 1, 1e-15);

  g_assert_cmpint (qn_result_set_mechanism (&result, resting, 0.5, NULL), ==, QN_OK);
  for (int i = 0; i < 6; i++)
    g_assert_cmpfloat (result.mechanism[i], ==, 0);
  qn_result_clear (&result);
}

static void
test_names (void)
{
  for (int i = 0; i < QN_OUTCOME_COUNT; i++)
    for (int j = 0; j < i; j++)
      g_assert_cmpstr (qn_outcome_name ((QnOutcome) i), !=,
                       qn_outcome_name ((QnOutcome) j));
  g_assert_cmpstr (qn_pair_state_name (QN_PAIR_OPEN), ==, "open");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/result/steps", test_steps_are_kept);
  g_test_add_func ("/result/mechanism-scale", test_mechanism_scale);
  g_test_add_func ("/result/names", test_names);
  return g_test_run ();
}
