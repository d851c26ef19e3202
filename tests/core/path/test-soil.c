/* Soil beside a block that is pushed over, by hand: into it, and away from it. */
#include "core/model/soil.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <math.h>

/* 1 x 2 m of 10 kN/m3 on a plane, pushed by 10 kN at its middle; on its right soil of 3 kN/m3 and 30
 * degrees up to its top, so that the vertical stress sums up to 6 kN, 2/3 m above the plane. */
static QnLoad *
init_pushed (QnModel *model, double push, double mobilisation)
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
  live->vector = qn_vec2 (push, 0);
  QnLoad *fill = qn_model_add_dead_load (model);
  fill->kind = QN_LOAD_FILL;
  fill->unit_weight = 3000;
  fill->friction_angle = G_PI / 6;
  fill->mobilisation = mobilisation;
  fill->span[0] = 0;
  fill->surface_count = 2;
  fill->surface[0] = qn_vec2 (-0.5, 2);
  fill->surface[1] = qn_vec2 (9, 2);
  return fill;
}

/* Paths and limit analysis; the soil that is pushed has its strength, other soil none. QN_TIE_STATE_COUNT: one
 * of both sides does. */
static void
assert_collapse (QnModel *model, double expected, QnTieState state)
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
    g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, expected, 1e-4);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
    const QnTieResult *ties =
      qn_result_step_ties (&run.result, run.result.step_count - 1);
    if (state == QN_TIE_STATE_COUNT)
      g_assert_cmpint (ties[0].state + ties[1].state, ==, QN_TIE_SLACK + QN_TIE_YIELDS);
    else
      for (size_t t = 0; t < run.model.soil_tie_count; t++)
        g_assert_cmpint (ties[t].state, ==, state);
  }
  qn_model_clear (model);
}

/* 10 kN x 1 m against 20 kN x 0.5 m and the soil on the other side of the corner: active 1/3 of 6 kN,
 * mobilised 0.5 Kp = 1.5 times, at 2/3 m. */
static void
test_overturning (void)
{
  QnModel model;
  init_pushed (&model, 10e3, 0.5);
  assert_collapse (&model, (10 + 1.5 * 6 * 2 / 3) / 10, QN_TIE_YIELDS);
  init_pushed (&model, 10e3, 1);
  assert_collapse (&model, (10 + 3 * 6.0 * 2 / 3) / 10, QN_TIE_YIELDS);
  init_pushed (&model, 10e3, 0);
  assert_collapse (&model, (10 + 6.0 / 3 * 2 / 3) / 10, QN_TIE_YIELDS);
  /* Away from the soil: only its active pressure follows. */
  init_pushed (&model, -10e3, 0.5);
  assert_collapse (&model, (10 - 6.0 / 3 * 2 / 3) / 10, QN_TIE_SLACK);
}

/* Between two spans, with soil on both faces: that behind follows with its active pressure, that before
 * resists, whichever way it goes. */
static void
test_between (void)
{
  for (int way = -1; way <= 1; way += 2) {
    QnModel model;
    QnLoad *fill = init_pushed (&model, way * 10e3, 0.5);
    fill->surface[0].x = -9;
    assert_collapse (&model, (10 + (1.5 - 1.0 / 3) * 6 * 2 / 3) / 10, QN_TIE_STATE_COUNT);
  }
}

/* At rest under the dead load: K0 = 1/2, active 1/3 and what is above it in a tie. */
static void
test_at_rest (void)
{
  g_auto (TestRun) run = { 0 };
  init_pushed (&run.model, 10e3, 1);
  run.model.analysis.max_multiplier = 0;
  test_run_solve (&run);
  g_assert_cmpint (run.result.tie_count, ==, 1);
  const QnTieResult *ties = qn_result_step_ties (&run.result, 0);
  g_assert_cmpfloat_with_epsilon (ties[0].force, (0.5 - 1.0 / 3) * 6000, 0.5);
  g_assert_cmpstr (run.model.soil_ties[0].name, ==, "soil.block");
  g_assert_cmpfloat_with_epsilon (run.model.soil_ties[0].ends[0].at.y, 2.0 / 3, 1e-12);
}

/* Prepared again, a model has the soil once; the factor of a case counts. */
static void
test_again (void)
{
  g_auto (QnModel) model, copy;
  QnLoad *fill = init_pushed (&model, 10e3, 1);
  fill->load_case = qn_model_add_load_case (&model, "soil");
  model.load_cases[0].factor = 1.5;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_prepare (&copy, NULL), ==, QN_OK);
  g_assert_cmpuint (copy.soil_tie_count, ==, 1);
  g_assert_cmpuint (qn_model_tie_count (&copy), ==, 1);
  g_assert_cmpfloat_with_epsilon (qn_tie_strength (qn_model_tie (&copy, 0)),
                                  1.5 * (3 - 1.0 / 3) * 6000, 1e-6);
}

/* A rigid foundation of B = 2 m on soil that does not pull, k = 3e7 Pa/m, under 100 kN at the eccentricity e:
 * up to B/6 all of it bears; beyond, c = 3 (B/2 - e) under 2 N/c at the edge (Winkler's springs). */
static void
check_foundation (double e, double middle, double rotation, double tolerance)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  test_model_init_block_on_plane (model, 2, 1);
  model->laws[0].kind = QN_LAW_NO_TENSION;
  model->laws[0].basis = QN_BASIS_SURFACE;
  model->laws[0].kn = model->laws[0].ks = 2 * 3e7;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 100 };
  QnLoad *dead = qn_model_add_dead_load (model);
  dead->kind = QN_LOAD_FORCE;
  dead->block = 1;
  dead->vector = qn_vec2 (0, -100e3);
  dead->moment = -100e3 * e;
  model->analysis.max_multiplier = 0;
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  const double *u = qn_result_step_displacements (&run.result, 0) + QN_DOF_COUNT;
  g_test_message ("e %g: %.6g m, %.6g rad", e, u[QN_DOF_UY], u[QN_DOF_RZ]);
  g_assert_cmpfloat (fabs (u[QN_DOF_UY] / -middle - 1), <, tolerance);
  if (rotation > 0)
    g_assert_cmpfloat (fabs (u[QN_DOF_RZ] / -rotation - 1), <, tolerance);
}

static void
test_winkler (void)
{
  const double n = 100e3, b = 2, k = 3e7;
  const double within[] = { 0, 0.2, 1.0 / 3 }, beyond[] = { 0.4, 0.5, 0.7 };
  for (int i = 0; i < 3; i++) {
    check_foundation (within[i], n / (k * b), 12 * n * within[i] / (k * b * b * b), 2e-4);
    double bears = 3 * (b / 2 - beyond[i]), edge = 2 * n / bears / k;
    check_foundation (beyond[i], edge - edge / bears * b / 2, edge / bears, 2e-3);
  }
}

QN_TESTS
{
  g_test_add_func ("/soil/winkler", test_winkler);
  g_test_add_func ("/soil/overturning", test_overturning);
  g_test_add_func ("/soil/between", test_between);
  g_test_add_func ("/soil/at-rest", test_at_rest);
  g_test_add_func ("/soil/again", test_again);
}
