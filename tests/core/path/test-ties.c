/* Ties against hand calculations: a block that is pushed over with a tie at its back. */
#include "core/check/result-check.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <math.h>

#define WEIGHT 20000.0 /* 1 x 2 m, 10 kN/m3 */

static QnTie *
add_tie (QnModel *model, const char *name, QnVec2 from, QnVec2 to)
{
  QnTie *tie = qn_model_add_tie (model, name);
  tie->ends[0] = (QnTieEnd){ 1, from };
  tie->ends[1] = (QnTieEnd){ QN_NONE, to };
  tie->area = 3e-4;
  tie->elasticity = 2e11;
  return tie;
}

/* A stiff block on a plane under its weight, pushed by 10 kN at its middle, so that it turns about its
 * right corner (0.5, 0). */
static void
init_pushed (QnModel *model)
{
  test_model_init_block_on_plane (model, 1, 2);
  model->laws[0].kn = model->laws[0].ks = 1e9;
  model->laws[0].friction = 10;
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  QnLoad *live = qn_model_add_live_load (model);
  live->kind = QN_LOAD_FORCE;
  live->block = 1;
  live->vector = qn_vec2 (10000, 0);
}

/* Moment of the tie's unit force about the corner, against the push. */
static double
lever (const QnTie *tie)
{
  QnVec2 along = qn_vec2_sub (tie->ends[1].at, tie->ends[0].at);
  QnVec2 arm = qn_vec2_sub (tie->ends[0].at, qn_vec2 (0.5, 0));
  return qn_vec2_cross (arm, along) / qn_vec2_length (along);
}

static void
assert_collapse (QnModel *model, double expected, double tolerance)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_LIMIT,
                                            QN_PROCEDURE_LIMIT };
  for (gsize i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (TestRun) run = { 0 };
    g_assert_cmpint (qn_model_copy (model, &run.model, NULL), ==, QN_OK);
    run.model.analysis.procedure = procedures[i];
    run.model.analysis.flow = i == 2 ? QN_FLOW_NON_ASSOCIATIVE : QN_FLOW_ASSOCIATIVE;
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, expected, tolerance);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
    const QnTieResult *ties =
      qn_result_step_ties (&run.result, run.result.step_count - 1);
    for (size_t t = 0; t < run.model.tie_count; t++) {
      const QnTie *tie = &run.model.ties[t];
      g_assert_cmpint (ties[t].state, ==, qn_tie_weakest (tie));
      g_assert_cmpfloat_with_epsilon (ties[t].force, qn_tie_strength (tie),
                                      1e-5 * WEIGHT);
    }
  }
  qn_model_clear (model);
}

/* Level, inclined, two at once, yielding and held by an anchor: when it turns over, each has its
 * strength. Push x 1 m = W x 0.5 m + sum of N x lever. */
static void
test_overturning (void)
{
  QnModel model;
  init_pushed (&model);
  QnTie *level = add_tie (&model, "level", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
  level->yield = 2e7; /* 6 kN */
  assert_collapse (&model, (WEIGHT * 0.5 + 6000 * 1.5) / 1e4, 1e-5);

  /* A strip: 0.1 m sqrt (2 x 230 GPa x 0.17 mm x 300 J/m2) = 15,316.66 N. */
  init_pushed (&model);
  QnTie *strip = add_tie (&model, "strip", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
  strip->area = 1.7e-5;
  strip->elasticity = 2.3e11;
  strip->yield = 3e9;
  strip->strip = (QnTieStrip){ 0.1, 300 };
  g_assert_cmpfloat_with_epsilon (qn_tie_strength (strip), 15316.66, 0.01);
  g_assert_cmpint (qn_tie_weakest (strip), ==, QN_TIE_ANCHOR);
  strip->strip.fracture_energy = 0; /* not known: 3 GPa of the fibres */
  g_assert_cmpfloat_with_epsilon (qn_tie_strength (strip), 51000, 1e-6);
  strip->strip.fracture_energy = 300;
  assert_collapse (&model, (WEIGHT * 0.5 + 15316.6576 * 1.5) / 1e4, 1e-5);

  init_pushed (&model);
  QnTie *first = add_tie (&model, "inclined", qn_vec2 (-0.5, 2), qn_vec2 (-2.5, 0));
  first->yield = 1e9;
  first->anchor = 8000;
  first->prestress = 5000;
  double moment = WEIGHT * 0.5 + 8000 * lever (first);
  QnTie *second = add_tie (&model, "low", qn_vec2 (0, 0.5), qn_vec2 (-2, 0.3));
  second->yield = 1e7;
  moment += 3000 * lever (second);
  assert_collapse (&model, moment / 1e4, 1e-5);

  /* It turns by much before this one is taut, under a load that does not grow meanwhile. */
  init_pushed (&model);
  level = add_tie (&model, "late", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
  level->yield = 2e7;
  level->slack = 0.01;
  assert_collapse (&model, (WEIGHT * 0.5 + 6000 * 1.5) / 1e4, 1e-5);
}

/* What the tie cannot give: pushed the other way it hangs slack, and the block turns over alone. */
static void
test_slack (void)
{
  g_auto (TestRun) run = { 0 };
  init_pushed (&run.model);
  run.model.live_loads[0].vector.x = -10000;
  add_tie (&run.model, "level", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
  test_run_solve (&run);
  g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, 1, 1e-5);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  const QnTieResult *tie = qn_result_step_ties (&run.result, run.result.step_count - 1);
  g_assert_cmpfloat (tie->force, ==, 0);
  g_assert_cmpfloat (tie->elongation, <, 0);
  g_assert_cmpint (tie->state, ==, QN_TIE_SLACK);
}

/* Elongation and force go together: N = EA/L (e - slack), and from the prestress on after the dead
 * load; steel that has yielded keeps what is plastic when the load goes back. */
static void
test_force (void)
{
  for (int prestressed = 0; prestressed < 2; prestressed++) {
    g_auto (TestRun) run = { 0 };
    init_pushed (&run.model);
    run.model.analysis.geometry =
      prestressed ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    run.model.analysis.max_multiplier = 1.3;
    QnTie *tie = add_tie (&run.model, "level", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
    tie->prestress = prestressed ? 2000 : 0;
    tie->slack = prestressed ? 0 : 1e-4;
    double k = qn_tie_stiffness (tie), slack = tie->slack;
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
    const QnTieResult *ties = run.result.ties;
    g_assert_cmpfloat (ties[0].force, ==, prestressed ? 2000 : 0);
    double first = prestressed ? ties[0].elongation : slack;
    for (size_t s = 1; s < run.result.step_count; s++) {
      double force = ties[0].force + k * fmax (0, ties[s].elongation - first);
      g_assert_cmpfloat_with_epsilon (ties[s].force, force, 1e-6 * WEIGHT);
    }
    QnTieResult *last = &run.result.ties[run.result.step_count - 1];
    g_assert_cmpfloat (last->force, >, ties[0].force + 1000);

    /* The balance is that of the stated force, although elongations tell no difference so small. */
    last->force += 5e-6 * WEIGHT;
    QnResultFaults faults;
    g_assert_cmpint (qn_result_find_faults (&run.model, &run.contacts, &run.result,
                                            QN_CHECK_STATED, &faults, NULL),
                     ==, QN_OK);
    g_assert_cmpint (faults.count, ==, 1);
    g_assert_cmpint (faults.items[0].claim, ==, QN_CLAIM_BALANCE);
  }
}

/* Punching as it is computed in Master Magazine 7, pages 75 and 99; the least of all limits counts. */
static void
test_plate (void)
{
  const QnTiePlate first = { 0.10, 0.30, 7400, 0 }, second = { 0.30, 0.32, 14800, 1e5 };
  QnTie tie = { .ends = { { 0, { 0, 0 } }, { 1, { 1, 0 } } },
                .area = 1e-4,
                .plate = first };
  g_assert_cmpfloat_with_epsilon (qn_tie_plate_punching (&first), 2790, 5);
  g_assert_cmpfloat_with_epsilon (qn_tie_plate_punching (&second), 9220, 5);
  g_assert_true (isinf (qn_tie_plate_bearing (&first)));
  g_assert_cmpfloat_with_epsilon (qn_tie_plate_bearing (&second), 7068.58, 0.01);
  g_assert_cmpfloat (qn_tie_strength (&tie), ==, qn_tie_plate_punching (&first));
  tie.plate = second;
  tie.anchor = 8000;
  g_assert_cmpfloat (qn_tie_strength (&tie), ==, qn_tie_plate_bearing (&second));
  g_assert_cmpint (qn_tie_weakest (&tie), ==, QN_TIE_ANCHOR);
  tie.yield = 5e7;
  g_assert_cmpfloat (qn_tie_strength (&tie), ==, 5000);
  g_assert_cmpint (qn_tie_weakest (&tie), ==, QN_TIE_YIELDS);
}

static void
add_stage (QnModel *model, double target)
{
  QnStage *stage = qn_model_add_stage (model, NULL);
  stage->sets = 1;
  stage->procedure = QN_PROCEDURE_LOAD;
  stage->has_target = true;
  stage->target = target;
  stage->control.block = stage->control.node = QN_NONE;
}

/* A block that hangs: its tie yields under more than its strength only as long as a second one takes the
 * rest; after unloading it is longer. */
static void
test_unloading (void)
{
  g_auto (TestRun) run = { 0 };
  init_pushed (&run.model);
  QnTie *soft = add_tie (&run.model, "soft", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
  soft->yield = 1e7; /* 3 kN */
  add_tie (&run.model, "strong", qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5))->elasticity =
    2e10;
  add_stage (&run.model, 1.8);
  add_stage (&run.model, 0.1);
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  bool yielded = false;
  for (size_t s = 0; s < run.result.step_count; s++)
    yielded |= run.result.ties[2 * s].state == QN_TIE_YIELDS;
  g_assert_true (yielded);
  const QnTieResult *end = run.result.ties + 2 * (run.result.step_count - 1);
  g_assert_cmpint (end[0].state, ==, QN_TIE_SLACK);
  /* 1.8 x 10 kNm = 10 + 3 x 1.5 + N x 1.5: the strong one had 2.33 kN. */
  double most = 0;
  for (size_t s = 0; s < run.result.step_count; s++)
    most = fmax (most, run.result.ties[2 * s + 1].force);
  g_assert_cmpfloat_with_epsilon (most, (18000 - 10000 - 4500) / 1.5, 30);
}

/* Many ties cost as many times one: the work of the linear systems is that of the blocks. */
static void
test_growth (void)
{
  int32_t iterations[2];
  for (int many = 0; many < 2; many++) {
    g_auto (TestRun) run = { 0 };
    init_pushed (&run.model);
    int count = many ? 400 : 4;
    for (int i = 0; i < count; i++) {
      g_autofree char *name = g_strdup_printf ("t%d", i);
      QnTie *tie = add_tie (&run.model, name, qn_vec2 (-0.5, 1.5), qn_vec2 (-4, 1.5));
      tie->area = 3e-4 / count;
      tie->yield = 2e7;
    }
    run.model.analysis.procedure = QN_PROCEDURE_LIMIT;
    test_run_solve (&run);
    g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, 1.9, 1e-5);
    iterations[many] = run.result.statistics.factorizations;
  }
  g_test_message ("%d and %d factorisations", iterations[0], iterations[1]);
  g_assert_cmpint (iterations[1], <=, 2 * iterations[0]);
}

QN_TESTS
{
  g_test_add_func ("/ties/overturning", test_overturning);
  g_test_add_func ("/ties/slack", test_slack);
  g_test_add_func ("/ties/force", test_force);
  g_test_add_func ("/ties/unloading", test_unloading);
  g_test_add_func ("/ties/plate", test_plate);
  g_test_add_func ("/ties/growth", test_growth);
}
