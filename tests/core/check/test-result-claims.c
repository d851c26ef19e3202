/* What a result states as a whole: numbers, and what its outcome needs. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

/* A block of 1 x 0.5 m that slides: friction 0.4 of its weight of 5 kN. */
static void
init_sliding (TestRun *run)
{
  test_model_init_block_on_plane (&run->model, 1, 0.5);
  run->model.laws[0].friction = 0.4;
  test_model_add_weight_loads (&run->model, 1);
  test_run_solve (run);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (run->result.collapse_multiplier, 0.4, 1e-9);
  g_assert_cmpint (test_run_count_faults (run), ==, 0);
}

/* Every number that a result states is one: not a number and infinity are told, wherever they stand. */
static void
test_numbers (void)
{
  g_auto (TestRun) run = { 0 };
  init_sliding (&run);
  QnResult *r = &run.result;
  r->first_limit_multiplier = r->collapse_multiplier;
  r->has_first_limit_multiplier = true;
  double *const numbers[] = {
    &r->collapse_multiplier,         &r->first_limit_multiplier,
    &r->steps[0].multiplier,         &r->steps[r->step_count - 1].time,
    &r->pairs[0].normal_force,       &r->pairs[1].shear_force,
    &r->displacements[QN_DOF_COUNT], &r->mechanism[QN_DOF_COUNT]
  };
  for (guint i = 0; i < G_N_ELEMENTS (numbers); i++)
    for (int infinite = 0; infinite < 2; infinite++) {
      const double right = *numbers[i];
      g_assert_false (test_run_tells (&run, QN_CLAIM_NUMBERS));
      *numbers[i] = infinite ? INFINITY : NAN;
      g_assert_true (test_run_tells (&run, QN_CLAIM_NUMBERS));
      *numbers[i] = right;
    }
}

/* What each outcome needs: a collapse its motion, a snap its multiplier, a rest a history, an unstable dead load
 * no step. Without a step there is no multiplier, no event, no stability. */
static void
test_outcomes (void)
{
  g_auto (TestRun) run = { 0 };
  init_sliding (&run);
  QnResult *r = &run.result;
  double *mechanism = r->mechanism;
  g_assert_false (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->mechanism = NULL;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->mechanism = mechanism;
  static const QnOutcome wrong[] = { QN_OUTCOME_TARGET_REACHED,     QN_OUTCOME_SNAP,
                                     QN_OUTCOME_DEAD_LOAD_UNSTABLE, QN_OUTCOME_REST,
                                     QN_OUTCOME_UNBOUNDED,          QN_OUTCOME_COUNT };
  for (guint i = 0; i < G_N_ELEMENTS (wrong); i++) {
    r->outcome = wrong[i];
    g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  }
  r->outcome = QN_OUTCOME_SNAP;
  r->has_first_limit_multiplier = true;
  r->first_limit_multiplier = r->collapse_multiplier;
  r->steps[r->step_count - 1].event = QN_EVENT_SNAP;
  g_assert_false (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->stability = QN_STABILITY_KEPT;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->stability = QN_STABILITY_UNKNOWN;

  const size_t steps = r->step_count, events = r->event_count;
  r->outcome = QN_OUTCOME_NOT_CONVERGED;
  r->step_count = r->event_count = r->solution_count = 0;
  r->has_collapse_multiplier = r->has_first_limit_multiplier = false;
  r->mechanism = NULL;
  g_assert_false (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->has_collapse_multiplier = true;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->has_collapse_multiplier = false;
  r->has_first_limit_multiplier = true;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->has_first_limit_multiplier = false;
  r->event_count = events;
  g_assert_cmpuint (events, >, 0);
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->event_count = 0;
  r->stability = QN_STABILITY_LOST;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->stability = QN_STABILITY_UNKNOWN;
  r->outcome = QN_OUTCOME_COLLAPSE;
  g_assert_true (test_run_tells (&run, QN_CLAIM_OUTCOME));
  r->mechanism = mechanism;
  r->event_count = events;
  r->step_count = steps;
}

QN_TESTS
{
  g_test_add_func ("/core/result-claims/numbers", test_numbers);
  g_test_add_func ("/core/result-claims/outcomes", test_outcomes);
}
