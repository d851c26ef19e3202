#include "core/result/result.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static void
test_steps_are_kept (void)
{
  g_auto (QnResult) result;
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
}

static void
test_mechanism_scale (void)
{
  g_auto (QnResult) result;
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
}

/* Forces of all steps are kept up to the budget, beyond it only where all are wanted. */
static void
test_force_budget (void)
{
  for (int all = 0; all < 2; all++) {
    g_auto (QnResult) result;
    size_t pairs = QN_RESULT_FORCE_BUDGET / 3;
    const double row[3] = { 0 };
    g_assert_cmpint (qn_result_init (&result, 1, pairs, NULL), ==, QN_OK);
    for (int s = 0; s < 4; s++) {
      for (size_t p = 0; p < pairs; p++)
        result.pairs[p] = (QnPairResult){ .state = QN_PAIR_SLIP, .normal_force = -s };
      g_assert_true (qn_result_add_step (&result, (QnStep){ .multiplier = s }, row));
      g_assert_true (qn_result_add_forces (&result, all));
      g_assert_true (qn_result_has_forces (&result, (size_t) s));
      g_assert_cmpint (qn_result_has_forces (&result, 0), ==, s < 3 || all);
    }
    g_assert_false (qn_result_has_forces (&result, 4));
    g_assert_cmpfloat (qn_result_pair_at (&result, 3, 7).normal_force, ==, -3);
    if (all) {
      QnPairResult pair = qn_result_pair_at (&result, 1, pairs - 1);
      g_assert_cmpfloat (pair.normal_force, ==, -1);
      g_assert_cmpint (pair.state, ==, QN_PAIR_SLIP);
      g_assert_false (pair.has_springs);
    }
  }
}

/* Of two bodies the one moves by 5 m, the other, which turns, by 1 m; what the next step moves, and by how much
 * blocks turn, does not count. */
static void
test_motion (void)
{
  static const double rows[][6] = { { 0 },
                                    { 1, 0, 50, 3, -4, 0 },
                                    { 90, 0, 0, 3, -2, 0 } };
  g_auto (QnResult) result;

  g_assert_cmpint (qn_result_init (&result, 2, 0, NULL), ==, QN_OK);
  for (int s = 0; s < 3; s++)
    g_assert_true (qn_result_add_step (&result, (QnStep){ .multiplier = s }, rows[s]));
  g_assert_cmpfloat_with_epsilon (qn_result_motion (&result, 0, 1), 5, 1e-15);
  g_assert_cmpfloat_with_epsilon (qn_result_motion (&result, 1, 2), 89, 1e-15);
}

static void
test_names (void)
{
  for (int i = 0; i < QN_OUTCOME_COUNT; i++)
    for (int j = 0; j < i; j++)
      g_assert_cmpstr (qn_outcome_names[i], !=, qn_outcome_names[j]);
  g_assert_cmpstr (qn_pair_state_names[QN_PAIR_OPEN], ==, "open");
}

/* A first limit point is told of from a thousandth of the collapse multiplier on. */
static void
test_felt_limit (void)
{
  QnResult result = { .first_limit_multiplier = 1e-5, .collapse_multiplier = -0.4 };
  g_assert_false (qn_result_has_felt_limit (&result));
  result.has_first_limit_multiplier = true;
  g_assert_true (qn_result_has_felt_limit (&result)); /* of what, is not known */
  result.has_collapse_multiplier = true;
  g_assert_false (qn_result_has_felt_limit (&result));
  result.first_limit_multiplier = -0.001;
  g_assert_true (qn_result_has_felt_limit (&result));
}

QN_TESTS
{
  g_test_add_func ("/result/steps", test_steps_are_kept);
  g_test_add_func ("/result/mechanism-scale", test_mechanism_scale);
  g_test_add_func ("/result/motion", test_motion);
  g_test_add_func ("/result/names", test_names);
  g_test_add_func ("/result/felt-limit", test_felt_limit);
  g_test_add_func ("/result/force-budget", test_force_budget);
}
