/* Retaining walls under earth pressure, against closed forms. */
#include "support/earthquakes.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

#define FRICTION 0.65
#define SOIL     18000.0 /* N/m3 */
#define STONE    10000.0

/* A wall of courses, width x height, on a plane, under backfill of its height as live load. */
static void
init_wall (QnModel *model, double width, double height, int courses, QnBlockSide side,
           double surcharge)
{
  test_model_init_stack (model, courses, width, height / courses);
  QnLoad *weight = qn_model_add_dead_load (model);
  weight->kind = QN_LOAD_WEIGHT;
  weight->vector = qn_vec2 (0, -1);
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_BACKFILL;
  load->side = side;
  load->span[0] = 0;
  load->span[1] = height;
  load->unit_weight = SOIL;
  load->pressure = surcharge;
  load->earth = QN_EARTH_ACTIVE;
  load->friction_angle = G_PI / 6;
}

/* The least of overturning and sliding on all bed joints, at depth z: W = stone b z against
 * P = K (soil z^2 / 2 + q z) with the moment K (soil z^3 / 6 + q z^2 / 2). */
static double
closed_form (double b, double height, int courses, double q)
{
  const double k = 1.0 / 3;
  double least = INFINITY;
  for (int i = 1; i <= courses; i++) {
    double z = height * i / courses, weight = STONE * b * z;
    double push = k * (SOIL * z * z / 2 + q * z);
    double moment = k * (SOIL * z * z * z / 6 + q * z * z / 2);
    least = fmin (least, fmin (weight * b / 2 / moment, FRICTION * weight / push));
  }
  return least;
}

static void
test_limit (void)
{
  static const struct {
    double width, height, surcharge;
    int courses;
  } walls[] = {
    { 1, 3, 0, 1 },     /* overturns */
    { 1, 3, 0, 6 },     /* on its lowest joint */
    { 2.5, 2, 0, 4 },   /* slides */
    { 1, 3, 10000, 6 }, /* with traffic behind it */
    { 2.5, 2, 10000, 4 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (walls); i++) {
    double expected =
      closed_form (walls[i].width, walls[i].height, walls[i].courses, walls[i].surcharge);
    for (int right = 0; right < 2; right++) {
      g_auto (TestRun) run;
      init_wall (&run.model, walls[i].width, walls[i].height, walls[i].courses,
                 right ? QN_BLOCK_SIDE_RIGHT : QN_BLOCK_SIDE_LEFT, walls[i].surcharge);
      run.model.analysis.procedure = QN_PROCEDURE_LIMIT;
      test_run_solve (&run);
      g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, expected,
                                      1e-6 * expected);
    }
  }
}

/* The path finds what limit analysis finds; the factor of a case divides it. */
static void
test_path (void)
{
  for (int doubled = 0; doubled < 2; doubled++) {
    g_auto (TestRun) run;
    init_wall (&run.model, 1, 3, 3, QN_BLOCK_SIDE_LEFT, 0);
    run.model.laws[0].kn = run.model.laws[0].ks = 1e9;
    if (doubled) {
      run.model.live_loads[0].load_case = qn_model_add_load_case (&run.model, "earth");
      run.model.load_cases[0].factor = 2;
    }
    double expected = closed_form (1, 3, 3, 0) / (doubled ? 2 : 1);
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, expected,
                                    1e-3 * expected);
  }
}

/* A linear load on the side of a rocking block and two hundred forces in its place go the same way in
 * large displacements. */
static void
test_many_forces (void)
{
  enum { PIECES = 200 };
  double found[2];
  for (int pieces = 0; pieces < 2; pieces++) {
    g_auto (TestRun) run;
    test_model_init_block_on_plane (&run.model, 1, 3);
    QnLoad *weight = qn_model_add_dead_load (&run.model);
    weight->kind = QN_LOAD_WEIGHT;
    weight->vector = qn_vec2 (0, -1);
    for (int i = 0; i < (pieces ? PIECES : 1); i++) {
      QnLoad *load = qn_model_add_live_load (&run.model);
      load->block = 1;
      if (pieces) { /* from the top down, 0 to 2 kN/m, each in the middle of its piece */
        double s = (i + 0.5) / PIECES;
        load->kind = QN_LOAD_FORCE;
        load->vector = qn_vec2 (2000 * s * 3 / PIECES, 0);
        load->has_at = true;
        load->at = qn_vec2 (-0.5, 3 * (1 - s));
      } else {
        load->kind = QN_LOAD_EDGE;
        load->has_side = true;
        load->side = QN_BLOCK_SIDE_LEFT;
        load->intensity[1] = 2000;
        load->normal = false;
        load->vector = qn_vec2 (1, 0);
      }
    }
    run.model.analysis = (QnAnalysisSettings){ .procedure = QN_PROCEDURE_DISPLACEMENT,
                                               .geometry = QN_GEOMETRY_NONLINEAR,
                                               .increments = 20,
                                               .max_multiplier = INFINITY,
                                               .multiplier_tolerance = 1e-4,
                                               .residual_tolerance = 1e-8,
                                               .max_factorizations = 50000,
                                               .max_seconds = INFINITY,
                                               .control.block = 1,
                                               .control.node = QN_NONE,
                                               .control.dof = QN_DOF_UX,
                                               .control.target = 0.2 };
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    found[pieces] = run.result.steps[run.result.step_count - 1].multiplier;
  }
  g_assert_cmpfloat (found[0], >, 0.1);
  /* Midpoints give the moment to 1 / (2 n^2). */
  g_assert_cmpfloat_with_epsilon (found[0], found[1], 1e-4 * found[0]);
}

/* Pressure at right angles into the block turns with the structure as drawn. */
static void
test_turned (void)
{
  double found[2];
  for (int turned = 0; turned < 2; turned++) {
    g_auto (TestRun) run;
    test_model_init_stack (&run.model, 3, 1, 1);
    test_model_add_weight_loads (&run.model, 0);
    run.model.live_load_count = 0;
    for (QnId block = 1; block <= 3; block++) {
      QnLoad *load = qn_model_add_live_load (&run.model);
      load->kind = QN_LOAD_EDGE;
      load->block = block;
      load->edge = 3;
      load->intensity[0] = 1000;
      load->intensity[1] = 500;
      load->normal = true;
    }
    run.model.analysis.procedure = QN_PROCEDURE_LIMIT;
    if (turned)
      test_model_rotate (&run.model, 0.7);
    test_run_solve (&run);
    found[turned] = run.result.collapse_multiplier;
  }
  g_assert_cmpfloat_with_epsilon (found[0], found[1], 1e-6 * found[0]);
}

/* In time a load on an edge acts as its resultant does: a block that rocks under a pulse moves alike. */
static void
test_in_time (void)
{
  double found[2][QN_DOF_COUNT];
  for (int single = 0; single < 2; single++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_earthquake_init_block (&model, 3, 0.3);
    model.analysis.dynamic.duration = 0.6;
    QnLoad *load = qn_model_add_dead_load (&model);
    load->block = 1;
    if (single) { /* 0 to 200 N/m, downwards over 1 m */
      load->kind = QN_LOAD_FORCE;
      load->vector = qn_vec2 (100, 0);
      load->has_at = true;
      load->at = qn_vec2 (-0.1, 1.0 / 3);
    } else {
      load->kind = QN_LOAD_EDGE;
      load->has_side = true;
      load->side = QN_BLOCK_SIDE_LEFT;
      load->intensity[1] = 200;
      load->normal = true;
    }
    test_earthquake_solve (&model, FALSE, &result);
    const size_t last = result.step_count - 1;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      found[single][dof] =
        result
          .displacements[(last * model.block_count + 1) * QN_DOF_COUNT + (size_t) dof];
  }
  g_assert_cmpfloat (fabs (found[0][QN_DOF_RZ]), >, 1e-3); /* it rocks */
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    g_assert_cmpfloat_with_epsilon (found[0][dof], found[1][dof], 1e-9);
}

QN_TESTS
{
  g_test_add_func ("/verify/loads/limit", test_limit);
  g_test_add_func ("/verify/loads/path", test_path);
  g_test_add_func ("/verify/loads/many-forces", test_many_forces);
  g_test_add_func ("/verify/loads/turned", test_turned);
  g_test_add_func ("/verify/loads/in-time", test_in_time);
}
