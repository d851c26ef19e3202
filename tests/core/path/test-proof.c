/* What is left of a result that is not true: everything before the fault, and what it would have told. */
#include "core/check/result-check.h"
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

static void
solve_wall (TestRun *run, QnGeometry geometry, QnProcedure procedure)
{
  test_model_init_wall (&run->model, 1, 0);
  run->model.analysis.geometry = geometry;
  run->model.analysis.procedure = procedure;
  test_run_solve (run);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (run->result.refused_count, ==, 0);
  g_assert_false (run->result.has_unproved_multiplier);
}

static void
prove (TestRun *run)
{
  g_assert_cmpint (qn_result_prove (&run->model, &run->contacts, &run->result, NULL), ==,
                   QN_OK);
}

/* A force of one pair at one step: it is named, the steps before stay, and the rest of the result is true. */
static void
test_wrong_force (void)
{
  g_auto (TestRun) run = { 0 };
  solve_wall (&run, QN_GEOMETRY_LINEAR, QN_PROCEDURE_LOAD);
  QnResult *r = &run.result;
  size_t step = r->step_count / 2, pair = 0;
  double collapse = r->collapse_multiplier;
  while (fabs (r->step_forces[2 * (step * r->pair_count + pair)]) < 1)
    pair++;
  double *force = &r->step_forces[2 * (step * r->pair_count + pair)], found = *force;
  *force *= 1.1;
  double stated = *force;
  prove (&run);

  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_NOT_CONVERGED);
  g_assert_cmpint (r->stop, ==, QN_STOP_CHECK);
  g_assert_cmpuint (r->step_count, ==, step);
  g_assert_false (r->has_collapse_multiplier);
  g_assert_null (r->mechanism);
  g_assert_true (r->has_unproved_multiplier);
  g_assert_cmpfloat (r->unproved_multiplier, ==, collapse);
  gboolean named = FALSE;
  for (int i = 0; i < r->refused_count; i++) {
    const QnFault *fault = &r->refused[i];
    if (fault->claim != QN_CLAIM_FORCES)
      continue;
    named = TRUE;
    g_assert_cmpint (fault->step, ==, step);
    g_assert_cmpint (fault->entity, ==, QN_ENTITY_CONTACT);
    g_assert_cmpint (fault->index, ==, pair);
    g_assert_cmpfloat (fault->stated, ==, stated);
    g_assert_cmpfloat_with_epsilon (fault->found, found, 1e-3 * fabs (found));
  }
  g_assert_true (named);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

/* What is wrong with the whole alone leaves all steps. */
static void
test_wrong_multiplier (void)
{
  g_auto (TestRun) run = { 0 };
  solve_wall (&run, QN_GEOMETRY_LINEAR, QN_PROCEDURE_LOAD);
  QnResult *r = &run.result;
  size_t steps = r->step_count;
  r->collapse_multiplier *= 1.01;
  prove (&run);
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_NOT_CONVERGED);
  g_assert_cmpuint (r->step_count, ==, steps);
  g_assert_cmpint (r->refused[0].claim, ==, QN_CLAIM_COLLAPSE);
  g_assert_true (r->has_unproved_multiplier);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

/* A motion against the loads is no collapse where the path ends; far below a peak it says nothing of the
 * peak, and is uncertain. */
static void
test_motion_against_loads (void)
{
  static const QnGeometry geometries[] = { QN_GEOMETRY_LINEAR, QN_GEOMETRY_NONLINEAR };

  for (size_t g = 0; g < G_N_ELEMENTS (geometries); g++) {
    g_auto (TestRun) run = { 0 };
    solve_wall (&run, geometries[g], QN_PROCEDURE_ARC_LENGTH);
    QnResult *r = &run.result;
    double collapse = r->collapse_multiplier;
    double last = r->steps[r->step_count - 1].multiplier;
    for (size_t i = 0; i < QN_DOF_COUNT * r->block_count; i++)
      r->mechanism[i] *= -1;
    prove (&run);

    if (geometries[g] == QN_GEOMETRY_LINEAR) {
      g_assert_cmpfloat_with_epsilon (last, collapse, 1e-9);
      g_assert_cmpint (r->outcome, ==, QN_OUTCOME_NOT_CONVERGED);
      g_assert_false (r->has_collapse_multiplier);
    } else {
      g_assert_cmpfloat (last, <, 0.5 * collapse);
      g_assert_cmpint (r->outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_cmpfloat (r->collapse_multiplier, ==, collapse);
      g_assert_true (r->mechanism_uncertain);
    }
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
}

QN_TESTS
{
  g_test_add_func ("/core/proof/motion-against-loads", test_motion_against_loads);
  g_test_add_func ("/core/proof/wrong-force", test_wrong_force);
  g_test_add_func ("/core/proof/wrong-multiplier", test_wrong_multiplier);
}
