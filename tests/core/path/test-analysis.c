#include "core/check/result-check.h"
#include "core/check/unlimited.h"
#include "core/path/analysis.h"

#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

static void
run (QnModel *model, QnResult *result)
{
  test_analyse (model, result);
  qn_model_clear (model);
}

static void
init_block (QnModel *model)
{
  test_model_init_block_on_plane (model, 2, 0.5);
  test_model_add_weight_loads (model, 1);
}

/* An analysis that needs more than it may spend ends, and keeps what had converged. */
static void
test_factorizations (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    g_auto (QnResult) whole, part;
    test_model_init_wall (&model, 1, 0);
    model.analysis.procedure = procedures[i];
    run (&model, &whole);
    g_assert_cmpint (whole.outcome, !=, QN_OUTCOME_NOT_CONVERGED);
    g_assert_cmpint (whole.statistics.factorizations, >, 10);

    test_model_init_wall (&model, 1, 0);
    model.analysis.procedure = procedures[i];
    model.analysis.max_factorizations = whole.statistics.factorizations / 2;
    run (&model, &part);
    g_assert_cmpint (part.outcome, ==, QN_OUTCOME_NOT_CONVERGED);
    g_assert_cmpint (part.stop, ==, QN_STOP_FACTORIZATIONS);
    g_assert_cmpint (part.statistics.factorizations, <=,
                     whole.statistics.factorizations / 2 + 1);
    g_assert_false (part.has_collapse_multiplier);
    g_assert_cmpuint (part.step_count, >, 1);
    g_assert_cmpuint (part.step_count, <, whole.step_count);
    for (size_t s = 0; s < part.step_count; s++)
      g_assert_cmpfloat (part.steps[s].multiplier, ==, whole.steps[s].multiplier);
  }
}

/* No clock is so coarse that an analysis takes no time at all. */
static void
test_seconds (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_LIMIT };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    g_auto (QnResult) result;
    init_block (&model);
    model.analysis.procedure = procedures[i];
    model.analysis.max_seconds = 1e-12;
    run (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_NOT_CONVERGED);
    g_assert_cmpint (result.stop, ==, QN_STOP_TIME);
  }
}

/* A load that presses a block onto its ground has no limit. */
static void
test_unbounded (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_LIMIT };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    g_auto (QnResult) result;
    init_block (&model);
    model.live_loads[0].vector = qn_vec2 (0, -1);
    model.analysis.procedure = procedures[i];
    run (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_UNBOUNDED);
    g_assert_false (result.has_collapse_multiplier);
  }
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.live_loads[0].vector = qn_vec2 (0, -1);
  model.analysis.max_multiplier = 7;
  run (&model, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
}

static void
test_dead_load_alone (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.analysis.max_multiplier = 0;
  run (&model, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (result.step_count, ==, 1);
  g_assert_cmpfloat (result.steps[0].multiplier, ==, 0);
}

/* What an analysis says has passed the check of its own numbers; the same with another displacement
 * does not. */
static void
test_proved (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnResultFaults faults;
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  for (int forged = 0; forged < 2; forged++) {
    if (forged)
      result.displacements[result.block_count * QN_DOF_COUNT + 4] += 1e-3;
    g_assert_cmpint (
      qn_result_find_faults (&model, &contacts, &result, QN_CHECK_STATED, &faults, NULL),
      ==, QN_OK);
    g_assert_true ((faults.count > 0) == forged);
  }
}

/* Of long paths the forces of steps before the last are not kept. What slid in a relaxed step is then not
 * known until the last, and a true result is not called false. */
static void
test_forces_not_kept (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnResultFaults faults;
  int relaxed = 0;
  test_model_init_wall (&model, 2, 0);
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.laws[0].kn = model.laws[0].ks = 1e9;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  for (size_t i = 0; i + 1 < result.step_count; i++)
    relaxed += result.steps[i].relaxed;
  g_assert_cmpint (relaxed, >, 0);
  result.forces_dropped = true;
  g_clear_pointer (&result.step_forces, free);
  g_clear_pointer (&result.step_states, free);
  g_assert_false (qn_result_has_forces (&result, 0));
  for (int forged = 0; forged < 2; forged++) {
    if (forged)
      result.pairs[0].normal_force *= 1.1;
    g_assert_cmpint (
      qn_result_find_faults (&model, &contacts, &result, QN_CHECK_STATED, &faults, NULL),
      ==, QN_OK);
    g_assert_true (faults.forces_unknown);
    g_assert_true ((faults.count > 0) == forged);
  }
}

/* The collapse of a path lies between the least solution and the associative bound, which is there
 * where it was asked for. */
static void
test_interval (void)
{
  QnModel model;
  QnContacts contacts;
  QnResult result;
  QnProcedure found_by;
  double least, bound;
  for (int choice = 0; choice < QN_BOUND_CHOICE_COUNT; choice++) {
    test_model_init_wall (&model, 3, 0);
    model.analysis.bound = (QnBoundChoice) choice;
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    qn_result_collapse_interval (&result, &least, &found_by, &bound);
    g_assert_cmpint (result.solution_count, ==, 1);
    g_assert_cmpfloat (least, ==, result.collapse_multiplier);
    g_assert_cmpint (found_by, ==, QN_PROCEDURE_WORK);
    g_assert_cmpfloat (result.solutions[0].displacement, >, 0);
    if (choice == QN_BOUND_NEVER)
      g_assert_true (isnan (bound));
    else
      g_assert_cmpfloat_with_epsilon (bound, test_walls[2].associative, 1e-6);
    qn_result_clear (&result);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

/* Soft joints let blocks move by more than a tenth of their width long before collapse; stiff ones do
 * not. In large displacements that does not matter. */
static void
test_linearity (void)
{
  const struct {
    double stiffness;
    QnGeometry geometry;
    QnLinearity linearity;
  } cases[] = {
    { 1e6, QN_GEOMETRY_LINEAR, QN_LINEARITY_BEYOND },
    { 1e10, QN_GEOMETRY_LINEAR, QN_LINEARITY_HOLDS },
    { 1e6, QN_GEOMETRY_NONLINEAR, QN_LINEARITY_HOLDS },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnResult) result;
    test_model_init_wall (&model, 1, 0);
    model.laws[0].kn = model.laws[0].ks = cases[i].stiffness;
    model.analysis.geometry = cases[i].geometry;
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    g_assert_cmpint (result.linearity, ==, cases[i].linearity);
    if (cases[i].linearity == QN_LINEARITY_BEYOND) {
      g_assert_cmpfloat (result.beyond_linear_multiplier, >, 0);
      g_assert_cmpfloat (result.beyond_linear_multiplier, <,
                         (1 - QN_SETTLED) * result.collapse_multiplier);
      g_assert_cmpfloat (qn_result_motion (&result, 0, result.step_count - 1), >,
                         QN_LINEAR_MOTION * 0.175);
    }
  }
}

/* Wall 1 with joints of this stiffness, in linear geometry. */
static void
solve_wall (double stiffness, QnResult *result)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_wall (&model, 1, 0);
  model.laws[0].kn = model.laws[0].ks = stiffness;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
}

/* Displacements go like one over the stiffness. Where they leave linear geometry just before the last
 * step the multiplier is settled, and no other one is told. */
static void
test_settled (void)
{
  QnResult result;
  solve_wall (1e7, &result);
  size_t last = result.step_count - 1;
  double before = qn_result_motion (&result, 0, last - 1);
  double after = qn_result_motion (&result, 0, last);
  qn_result_clear (&result);
  double moved = before + 0.999 * (after - before);
  solve_wall (1e7 * moved / (QN_LINEAR_MOTION * 0.175), &result);
  g_assert_cmpuint (result.step_count, ==, last + 1);
  g_assert_cmpint (result.linearity, ==, QN_LINEARITY_HOLDS);
  g_assert_cmpfloat (result.beyond_linear_multiplier, ==, 0);
  qn_result_clear (&result);
}

/* A tower of blocks that stick together. */
static void
init_glued (QnModel *model, QnLawKind kind, double moment)
{
  test_model_init_stack (model, 4, 1, 1);
  test_model_add_weight_loads (model, 1);
  model->laws[0].kind = kind;
  model->laws[0].yield = kind == QN_LAW_BILINEAR ? 1e3 : 0;
  model->laws[0].hardening = kind == QN_LAW_BILINEAR ? 0.05 : 0;
  model->laws[0].friction = kind == QN_LAW_COULOMB ? 0.5 : 0;
  model->live_loads[0].moment = moment;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
}

/* No force brings it down, and it is not followed far to be told so; a statement that no load does of one
 * whose joints open is not true. */
static void
test_unlimited (void)
{
  static const QnLawKind kinds[] = { QN_LAW_ELASTIC, QN_LAW_BILINEAR, QN_LAW_COULOMB };
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    bool is_glued = kinds[i] != QN_LAW_COULOMB;
    QnModel model;
    QnContacts contacts;
    QnResult result;
    QnResultFaults faults;
    init_glued (&model, kinds[i], 0);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    g_assert_cmpint (result.outcome, ==,
                     is_glued ? QN_OUTCOME_UNBOUNDED : QN_OUTCOME_COLLAPSE);
    if (is_glued) {
      double moved = qn_result_motion (&result, 0, result.step_count - 1);
      g_assert_cmpfloat (moved, >, 3); /* from the lowest centroid to the highest */
      g_assert_cmpfloat (moved, <, 5);
      g_assert_cmpint (result.statistics.factorizations, <, 2000);
    }
    qn_result_clear_collapse (&result);
    qn_result_clear_events (&result);
    result.steps[result.step_count - 1].event = QN_EVENT_NONE;
    result.outcome = QN_OUTCOME_UNBOUNDED;
    g_assert_cmpint (
      qn_result_find_faults (&model, &contacts, &result, QN_CHECK_STATED, &faults, NULL),
      ==, QN_OK);
    g_assert_cmpint (faults.count, ==, is_glued ? 0 : 1);
    if (!is_glued)
      g_assert_cmpint (faults.items[0].claim, ==, QN_CLAIM_OUTCOME);
    qn_result_clear (&result);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

static bool
is_unlimited (QnModel *model)
{
  QnContacts contacts;
  bool unlimited;

  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_check_unlimited (model, &contacts, &unlimited, NULL), ==, QN_OK);
  qn_contacts_clear (&contacts);
  qn_model_clear (model);
  return unlimited;
}

/* A moment turns a block on and on; a tower on rollers slides away; contacts that follow leave joints. */
static void
test_limited (void)
{
  QnModel model;
  init_glued (&model, QN_LAW_ELASTIC, 0);
  g_assert_true (is_unlimited (&model));
  init_glued (&model, QN_LAW_ELASTIC, 1);
  g_assert_false (is_unlimited (&model));
  init_glued (&model, QN_LAW_ELASTIC, 0);
  model.blocks[0].support[QN_DOF_UX] = false;
  g_assert_false (is_unlimited (&model));
  init_glued (&model, QN_LAW_ELASTIC, 0);
  model.analysis.follow = true;
  g_assert_false (is_unlimited (&model));
  init_glued (&model, QN_LAW_BILINEAR, 0);
  model.laws[0].hardening = 0;
  g_assert_false (is_unlimited (&model));
}

/* Limit analysis is made once more with broken bonds, unless no bound is asked for: a study reads none. */
static void
test_bound_of_broken_bonds (void)
{
  static const QnBoundChoice choices[] = { QN_BOUND_AUTO, QN_BOUND_NEVER };

  for (size_t i = 0; i < G_N_ELEMENTS (choices); i++) {
    QnModel model;
    g_auto (QnResult) result;
    init_block (&model);
    model.laws[0].cohesion = model.laws[0].tension = 1;
    model.analysis.procedure = QN_PROCEDURE_LIMIT;
    model.analysis.bound = choices[i];
    run (&model, &result);
    g_assert_true (result.has_associative_bound);
    g_assert_true (result.has_broken_bound == (choices[i] == QN_BOUND_AUTO));
  }
}

QN_TESTS
{
  g_test_add_func ("/analysis/bound-of-broken-bonds", test_bound_of_broken_bonds);
  g_test_add_func ("/analysis/factorizations", test_factorizations);
  g_test_add_func ("/analysis/seconds", test_seconds);
  g_test_add_func ("/analysis/unbounded", test_unbounded);
  g_test_add_func ("/analysis/unlimited", test_unlimited);
  g_test_add_func ("/analysis/limited", test_limited);
  g_test_add_func ("/analysis/dead-load-alone", test_dead_load_alone);
  g_test_add_func ("/analysis/proved", test_proved);
  g_test_add_func ("/analysis/forces-not-kept", test_forces_not_kept);
  g_test_add_func ("/analysis/settled", test_settled);
  g_test_add_func ("/analysis/interval", test_interval);
  g_test_add_func ("/analysis/linearity", test_linearity);
}
