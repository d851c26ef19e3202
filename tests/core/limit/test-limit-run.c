#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static QnResult
run (QnModel *model)
{
  g_auto (QnContacts) contacts;
  QnResult result;

  model->analysis.procedure = QN_PROCEDURE_LIMIT;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  qn_model_clear (model);
  return result;
}

static void
test_collapse (void)
{
  QnModel model;

  test_model_init_wall (&model, 1, 0);
  g_auto (QnResult) result = run (&model);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_true (result.has_collapse_multiplier);
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, test_walls[0].associative,
                                  1e-6);
  g_assert_true (result.limit.given);
  g_assert_cmpint (result.limit.flow, ==, QN_FLOW_ASSOCIATIVE);
  g_assert_true (result.has_associative_bound);
  g_assert_cmpfloat (result.limit.lower_bound, ==, result.collapse_multiplier);
  g_assert_cmpfloat_with_epsilon (result.limit.upper_bound, result.limit.lower_bound,
                                  1e-6);
  g_assert_cmpint (result.statistics.factorizations, >, 5);
  g_assert_cmpfloat (result.statistics.factor_seconds, >, 0);
  g_assert_cmpfloat (result.statistics.factor_seconds, <, result.statistics.seconds);
  g_assert_cmpuint (result.step_count, ==, 2);
  g_assert_cmpfloat (result.steps[1].multiplier, ==, result.collapse_multiplier);
  g_assert_cmpint (result.steps[1].event, ==, QN_EVENT_COLLAPSE);
  double fastest = 0;
  for (size_t b = 0; b < result.block_count; b++)
    fastest =
      fmax (fastest, hypot (result.mechanism[3 * b], result.mechanism[3 * b + 1]));
  g_assert_cmpfloat_with_epsilon (fastest, 1, 1e-12);
  for (size_t p = 0; p < result.pair_count; p++)
    g_assert_cmpfloat (result.pairs[p].normal_force, <=, 0);
}

static void
test_pair_states (void)
{
  QnModel model;

  /* A wide block slides on both pairs, a slender one turns on one and leaves the other. */
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  QnResult result = run (&model);
  g_assert_cmpint (result.pairs[0].state, ==, QN_PAIR_SLIP);
  g_assert_cmpint (result.pairs[1].state, ==, QN_PAIR_SLIP);
  qn_result_clear (&result);

  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  result = run (&model);
  int open = result.pairs[0].state == QN_PAIR_OPEN ? 0 : 1;
  g_assert_cmpint (result.pairs[open].state, ==, QN_PAIR_OPEN);
  g_assert_cmpint (result.pairs[1 - open].state, ==, QN_PAIR_STICK);
  qn_result_clear (&result);
}

static void
test_unstable (void)
{
  QnModel model;

  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 4, 1);
  test_model_add_rectangle (&model, "good", 0, 0, 1, 1);
  test_model_add_rectangle (&model, "bad", 3.6, 0, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_auto (QnResult) result = run (&model);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  g_assert_false (result.has_collapse_multiplier);
  g_assert_false (result.limit.given);
  g_assert_cmpuint (result.unstable_count, ==, 1);
  g_assert_cmpint (result.unstable_blocks[0], ==, 2);
  g_assert_nonnull (result.mechanism);
}

static void
test_unbounded (void)
{
  QnModel model;

  test_model_init_stack (&model, 2, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, -1);
  g_auto (QnResult) result = run (&model);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_UNBOUNDED);
  g_assert_false (result.has_collapse_multiplier);
  g_assert_cmpstr (qn_outcome_names[result.outcome], ==, "unbounded");
}

static void
test_non_associative (void)
{
  QnModel model;

  test_model_init_wall (&model, 3, 0);
  model.analysis.flow = QN_FLOW_NON_ASSOCIATIVE;
  g_auto (QnResult) result = run (&model);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (result.limit.flow, ==, QN_FLOW_NON_ASSOCIATIVE);
  g_assert_true (result.has_associative_bound);
  g_assert_cmpfloat_with_epsilon (result.associative_bound, test_walls[2].associative,
                                  1e-6);
  g_assert_cmpfloat (result.collapse_multiplier, ==, result.limit.lower_bound);
  g_assert_cmpfloat (result.limit.lower_bound, <=, result.limit.upper_bound);
  g_assert_cmpfloat (result.limit.upper_bound, <=, result.associative_bound);
  g_assert_cmpint (result.solution_count, >=, 1);
  g_assert_cmpfloat (result.limit.uncertainty, >, 0);
  g_assert_cmpfloat (result.limit.uncertainty, <=, 1e-5 * result.collapse_multiplier);
}

QN_TESTS
{
  g_test_add_func ("/limit-run/collapse", test_collapse);
  g_test_add_func ("/limit-run/pair-states", test_pair_states);
  g_test_add_func ("/limit-run/unstable", test_unstable);
  g_test_add_func ("/limit-run/unbounded", test_unbounded);
  g_test_add_func ("/limit-run/non-associative", test_non_associative);
}
