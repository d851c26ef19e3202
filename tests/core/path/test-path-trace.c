#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

/* A stiff block rocks over its corner: lambda = tan (alpha - theta) with tan alpha = b/h, zero
 * when the diagonal is vertical. The whole curve from its peak on, within 0.5 % of that. */
static void
test_overturning_in_large_displacements (void)
{
  const double b = 0.4, h = 1, alpha = atan (b / h), radius = hypot (b, h) / 2;
  bool peak_passed = false;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  test_model_init_block_on_plane (&model, b, h);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].kn = model.laws[0].ks = 1e10;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.increments = 400;
  test_control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UX, b / 2);
  test_analyse (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (result.step_count, >, 10);
  for (size_t s = 1; s < result.step_count; s++) {
    const double *u = qn_result_step_displacements (&result, s) + 3;
    if (result.steps[s].multiplier < result.steps[s - 1].multiplier)
      peak_passed = true;
    if (!peak_passed)
      continue;
    double theta = -u[2];
    g_assert_cmpfloat_with_epsilon (result.steps[s].multiplier, tan (alpha - theta),
                                    0.002);
    g_assert_cmpfloat_with_epsilon (u[0], radius * (sin (alpha) - sin (alpha - theta)),
                                    1e-3);
  }
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, b / h, 0.002);
  g_assert_cmpfloat_with_epsilon (result.steps[result.step_count - 1].multiplier, 0,
                                  0.002);
}

/* Followed without a target the path ends where nothing of the load is left: with the diagonal
 * vertical, to the digit. */
static void
test_overturning_until_nothing_is_left (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  const double b = 0.4, h = 1, alpha = atan (b / h);

  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_block_on_plane (&model, b, h);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kn = model.laws[0].ks = 1e9;
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    test_control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    test_analyse (&model, &result);

    const double *u = qn_result_step_displacements (&result, result.step_count - 1) + 3;
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpint (result.stop, ==, QN_STOP_ZERO);
    g_assert_cmpfloat_with_epsilon (result.steps[result.step_count - 1].multiplier, 0,
                                    1e-12);
    g_assert_cmpfloat_with_epsilon (-u[2], alpha, 1e-3);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, b / h, 0.004);
  }
}

/* --- Snap-through and snap-back --------------------------------------------------------- */

/* Two bars (the centre lines of blocks hinged by single pairs) rise from abutments to a
 * keystone that moves vertically; a head pushes it down through a soft joint.
 *
 *   s = rise left,  d = sqrt (span^2 + s^2),  w = rise - s
 *   P = 2 k (l - d) s / d          k: the two pairs of a bar in series
 *   u = w + P / soft               of the head
 *
 * P (w) snaps through; u (s) turns back where dP/ds = soft. */
#define SPAN  1.0
#define RISE  0.3
#define DEPTH 0.2
#define BAR   2.5e7 /* k, N/m */
#define SOFT  1.5e6 /* N/m */
#define FORCE 1e5   /* live load, N */

static void
add_bar (QnModel *model, const char *name, double from, double to)
{
  double low = from < to ? 0 : RISE, high = RISE - low;
  double left = fmin (from, to), right = fmax (from, to);
  const QnVec2 corners[] = { { left, low - DEPTH / 2 },
                             { right, high - DEPTH / 2 },
                             { right, high + DEPTH / 2 },
                             { left, low + DEPTH / 2 } };
  QnBlock *bar = qn_model_add_block (model, name, corners, 4);
  g_assert_nonnull (bar);
  bar->thickness = 1;
}

static void
make_truss (QnModel *model, QnProcedure procedure, double target)
{
  const double key = 0.4;
  test_model_init (model);
  model->laws[0].kind = QN_LAW_ELASTIC;
  model->laws[0].kn = model->laws[0].ks = 4 * BAR;
  QnLaw *soft = qn_model_add_law (model, "soft");
  g_assert_nonnull (soft);
  *soft = (QnLaw){ .name = soft->name,
                   .kind = QN_LAW_ELASTIC,
                   .basis = QN_BASIS_CONTACT,
                   .kn = 2 * SOFT,
                   .ks = 2 * SOFT };

  test_model_add_base (model, -1, -0.5, 1, 1);
  add_bar (model, "left", 0, SPAN);
  QnBlock *keystone =
    test_model_add_rectangle (model, "keystone", SPAN, RISE - DEPTH / 2, key, DEPTH);
  keystone->support[QN_DOF_UX] = keystone->support[QN_DOF_RZ] = true;
  add_bar (model, "right", 2 * SPAN + key, SPAN + key);
  QnBlock *abutment =
    test_model_add_rectangle (model, "abutment", 2 * SPAN + key, -0.5, 1, 1);
  abutment->support[QN_DOF_UX] = abutment->support[QN_DOF_UY] = true;
  abutment->support[QN_DOF_RZ] = true;
  QnBlock *head = test_model_add_rectangle (model, "head", SPAN + key / 4,
                                            RISE + DEPTH / 2, key / 2, key);
  head->support[QN_DOF_UX] = head->support[QN_DOF_RZ] = true;
  for (size_t b = 0; b < model->block_count; b++)
    model->blocks[b].unit_weight = 0;

  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 1 };
  QnFaceOverride *joint = qn_model_add_override (model);
  joint->block_a = qn_model_find_block (model, "keystone");
  joint->block_b = qn_model_find_block (model, "head");
  joint->law = 1;
  QnLoad *push = qn_model_add_live_load (model);
  push->kind = QN_LOAD_FORCE;
  push->block = qn_model_find_block (model, "head");
  push->vector = qn_vec2 (0, -FORCE);
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model->analysis.increments = 50;
  test_control (model, procedure, "head", QN_DOF_UY, target);
}

/* Every step lies on the curve; returns how often the head turns back from step to step. */
static int
check_truss (const QnModel *model, const QnResult *result)
{
  size_t key = (size_t) qn_model_find_block (model, "keystone") * QN_DOF_COUNT;
  size_t head = (size_t) qn_model_find_block (model, "head") * QN_DOF_COUNT;
  double length = hypot (SPAN, RISE), last = 0;
  int backwards = 0;

  for (size_t i = 1; i < result->step_count; i++) {
    const double *u = qn_result_step_displacements (result, i);
    double s = RISE + u[key + QN_DOF_UY], d = hypot (SPAN, s);
    double force = 2 * BAR * (length - d) * s / d;
    g_assert_cmpfloat_with_epsilon (result->steps[i].multiplier * FORCE, force, 1);
    g_assert_cmpfloat_with_epsilon (-u[head + QN_DOF_UY], RISE - s + force / SOFT, 1e-6);
    backwards += -u[head + QN_DOF_UY] < last;
    last = -u[head + QN_DOF_UY];
  }
  return backwards;
}

/* Arc length follows the curve through both turns of the load and both of the head. */
static void
test_snap_back_by_arc_length (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  double least = INFINITY, most = -INFINITY;
  make_truss (&model, QN_PROCEDURE_ARC_LENGTH, -0.65);
  test_analyse (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (result.stop, ==, QN_STOP_DISPLACEMENT);
  g_assert_cmpint (check_truss (&model, &result), >, 3);
  for (size_t i = 0; i < result.step_count; i++) {
    g_assert_cmpint (result.steps[i].event, ==, QN_EVENT_NONE);
    least = fmin (least, result.steps[i].multiplier);
    most = fmax (most, result.steps[i].multiplier);
  }
  /* Peak and valley: l SPAN^2 = d^3. */
  double d = cbrt (hypot (SPAN, RISE) * SPAN * SPAN);
  double peak =
    2 * BAR * (hypot (SPAN, RISE) / d - 1) * sqrt (d * d - SPAN * SPAN) / FORCE;
  g_assert_cmpfloat_with_epsilon (most, peak, 0.02 * peak);
  g_assert_cmpfloat_with_epsilon (least, -peak, 0.02 * peak);
  g_test_message ("%zu steps, %d factorisations", result.step_count,
                  result.statistics.factorizations);
  g_assert_cmpint (result.statistics.factorizations, <, 6 * (int) result.step_count);
}

/* What the springs hold, J. */
static double
stored_energy (const QnResult *result)
{
  double energy = 0;

  for (size_t p = 0; p < result->pair_count; p++) {
    const QnPairResult *pair = &result->pairs[p];
    double normal = pair->elongation_a[0] + pair->elongation_b[0];
    double tangential = pair->elongation_a[1] + pair->elongation_b[1];
    energy += 0.5 * (pair->normal_force * normal + pair->shear_force * tangential);
  }
  return energy;
}

/* The work of the load on the head, J, by trapezoids. */
static double
work_on_head (const QnModel *model, const QnResult *result)
{
  size_t head = (size_t) qn_model_find_block (model, "head") * QN_DOF_COUNT;
  double work = 0;

  for (size_t s = 1; s < result->step_count; s++) {
    double before = qn_result_step_displacements (result, s - 1)[head + QN_DOF_UY];
    double after = qn_result_step_displacements (result, s)[head + QN_DOF_UY];
    double mean = 0.5 * (result->steps[s - 1].multiplier + result->steps[s].multiplier);
    work += mean * -FORCE * (after - before);
  }
  return work;
}

/* What the press puts in is what the springs hold, when it pulls and when it pushes, past both
 * turns of the load and both of the head: the keystone is what is controlled. The difference is
 * the trapezoids': about a quarter for half the increment, the first steps and those next to a peak being
 * smaller. */
static void
test_energy_of_displacements (void)
{
  double first = 0;

  for (int increments = 100; increments <= 400; increments *= 2) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    make_truss (&model, QN_PROCEDURE_DISPLACEMENT, 0);
    model.analysis.increments = increments;
    test_control (&model, QN_PROCEDURE_DISPLACEMENT, "keystone", QN_DOF_UY, -0.5);
    test_analyse (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    double stored = stored_energy (&result), work = work_on_head (&model, &result);
    double error = work / stored - 1;
    g_test_message ("%d increments: stored %.9g J, work %.9g J, %.2e", increments, stored,
                    work, error);
    g_assert_cmpfloat (fabs (error), <, 100.0 / (increments * increments));
    if (increments == 100)
      first = error;
    else if (increments == 400)
      g_assert_cmpfloat (first / error, >, 9);
  }
}

/* Held by its head, the structure jumps where the head would have to turn back. */
static void
test_snap_under_held_displacement (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  int jumps = 0;
  make_truss (&model, QN_PROCEDURE_DISPLACEMENT, -0.65);
  test_analyse (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (check_truss (&model, &result), ==, 0);
  /* du/ds = 0:  l SPAN^2 / d^3 = 1 + SOFT / 2 k */
  double d = cbrt (hypot (SPAN, RISE) * SPAN * SPAN / (1 + SOFT / (2 * BAR)));
  double s = sqrt (d * d - SPAN * SPAN);
  double turn = RISE - s + 2 * BAR / SOFT * (hypot (SPAN, RISE) / d - 1) * s;
  size_t head = (size_t) qn_model_find_block (&model, "head") * QN_DOF_COUNT;
  for (size_t i = 1; i < result.step_count; i++)
    if (result.steps[i].event == QN_EVENT_SNAP) {
      jumps++;
      g_assert_cmpfloat_with_epsilon (
        -qn_result_step_displacements (&result, i)[head + QN_DOF_UY], turn, 1e-3);
      g_assert_cmpfloat (result.steps[i].multiplier, <, 0);
      g_assert_cmpfloat (result.steps[i - 1].multiplier, >, 1);
    }
  g_assert_cmpint (jumps, ==, 1);
}

/* Asked to stop at limit points, it stops at the peak and not at the turn. */
static void
test_stop_at_limit_point (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  make_truss (&model, QN_PROCEDURE_DISPLACEMENT, -0.65);
  model.analysis.snap = QN_SNAP_THROUGH_STOP;
  test_analyse (&model, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_SNAP);
  g_assert_cmpint (result.stop, ==, QN_STOP_LIMIT_POINT);
  g_assert_true (result.has_first_limit_multiplier);
  g_assert_cmpfloat (result.first_limit_multiplier, >, 2.2);
}

/* --- Plateaus, peaks -------------------------------------------------------------------- */

/* Low blocks on each other slide when the live load is their friction, whichever measure is prescribed:
 * the multiplier that stays is the same, however little it still changes. */
static void
test_sliding_courses (void)
{
  const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                     QN_PROCEDURE_ARC_LENGTH };
  for (int i = 0; i < 4 * (int) G_N_ELEMENTS (procedures); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    double friction = i / 2 % 2 == 0 ? 0.3 : 0.65;
    test_model_init_stack (&model, 2, 1, 0.25);
    model.laws[0].friction = friction;
    model.laws[0].kn = model.laws[0].ks = 1e9;
    test_model_add_weight_loads (&model, 1);
    model.analysis.procedure = procedures[i / 4];
    model.analysis.geometry = i % 2 == 0 ? QN_GEOMETRY_LINEAR : QN_GEOMETRY_NONLINEAR;
    test_analyse (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, friction,
                                    1e-4 * friction);
  }
}

/* Work and arc-length control end on the plateau of a sliding block. */
static void
test_plateau (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_block_on_plane (&model, 2, 0.5);
    test_model_add_weight_loads (&model, 1);
    test_control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    test_analyse (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.65, 1e-6);
    g_assert_cmpfloat_with_epsilon (result.mechanism[3], 1, 1e-3);
  }
}

/* Every procedure ends right at the largest multiplier. */
static void
test_largest_multiplier (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    bool displacement = procedures[i] == QN_PROCEDURE_DISPLACEMENT;
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_wall (&model, 3, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    test_control (&model, procedures[i], displacement ? "w.11.4" : NULL, QN_DOF_UX, 0.05);
    model.analysis.max_multiplier = 0.2;
    test_analyse (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpint (result.stop, ==, QN_STOP_MULTIPLIER);
    g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==, 0.2);
  }
}

/* A slender elastic member bends by far more than 1e5 times what its joints give, and carries
 * every load in linear geometry. */
static void
test_elastic_member_never_collapses (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_stack (&model, 50, 0.05, 0.1);
    model.laws[0].kind = QN_LAW_ELASTIC;
    test_model_add_weight_loads (&model, 1);
    test_control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    test_analyse (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_UNBOUNDED);
    g_assert_cmpint (result.stop, ==, QN_STOP_MULTIPLIER);
    g_assert_false (result.has_collapse_multiplier);
    g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==, 1e9);
  }
}

/* Every procedure finds the same peak on a wall whose path is smooth. */
static void
test_peak_of_a_wall (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_wall (&model, 1, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    test_control (&model, procedures[i], "w.6.5", QN_DOF_UX, 0.05);
    test_analyse (&model, &result);
    double peak = 0;
    for (size_t s = 0; s < result.step_count; s++)
      peak = fmax (peak, result.steps[s].multiplier);
    g_test_message ("procedure %d: outcome %d, %zu steps, peak %.5f, %d factorisations",
                    procedures[i], result.outcome, result.step_count, peak,
                    result.statistics.factorizations);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpfloat_with_epsilon (peak, 0.6415, 1e-3);
  }
}

/* --- Walls to collapse ------------------------------------------------------------------ */

static double
top_displacement (const QnResult *result, size_t step)
{
  const double *u = qn_result_step_displacements (result, step);

  return u[QN_DOF_COUNT * (result->block_count - 1) + QN_DOF_UX];
}

/* Multiplier of the path where the last block has moved so far, between steps by a straight
 * line. */
static double
multiplier_at (const QnResult *path, double displacement)
{
  size_t i = 1;

  while (i + 1 < path->step_count && top_displacement (path, i) < displacement)
    i++;
  double from = top_displacement (path, i - 1), to = top_displacement (path, i);
  double low = path->steps[i - 1].multiplier, high = path->steps[i].multiplier;
  return low + (high - low) * (displacement - from) / (to - from);
}

/* Displacement control of the top in small increments, up to 97 % of collapse. */
static void
follow_closely (int wall, double dilatancy, double collapse, const QnResult *path,
                QnResult *result)
{
  g_auto (QnModel) model;
  size_t last = 1;

  while (path->steps[last].multiplier < 0.97 * collapse)
    last++;
  test_model_init_wall (&model, wall, dilatancy);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  test_control (&model, QN_PROCEDURE_DISPLACEMENT, NULL, QN_DOF_UX,
                top_displacement (path, last));
  model.analysis.control.block = (QnId) model.block_count - 1;
  model.analysis.increments = 8000;
  model.analysis.max_multiplier = 0.97 * collapse;
  test_analyse (&model, result);
  g_assert_cmpint (result->outcome, ==, QN_OUTCOME_TARGET_REACHED);
}

/* Work and arc-length control run along the path of load control and on to its collapse, with
 * no more effort, although one of the two may lead through equilibria where Newton's method gets
 * nowhere. */
static void
test_walls_to_collapse (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  static const double by_load_control[] = { 0.64148, 0.56402, 0.35582,
                                            0.26374, 0.21520, 0.29633 };

  for (int i = 0; i < 2 * TEST_WALL_COUNT; i++) {
    int wall = i / 2 + 1;
    bool associative = i % 2 == 1;
    double dilatancy = associative ? 0.65 : 0;
    double collapse =
      associative ? test_walls[wall - 1].associative : by_load_control[wall - 1];
    double farthest[2] = { 0 };
    QnResult results[2];
    g_auto (QnResult) close;
    for (int k = 0; k < 2; k++) {
      g_auto (QnModel) model;
      const QnResult *result = &results[k];
      test_model_init_wall (&model, wall, dilatancy);
      test_control (&model, procedures[k], NULL, QN_DOF_UX, 0);
      test_analyse (&model, &results[k]);
      g_test_message ("wall %d, dilatancy %g, procedure %d: %.6f, %d factorisations",
                      wall, dilatancy, procedures[k], result->collapse_multiplier,
                      result->statistics.factorizations);
      g_assert_cmpint (result->outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_cmpint (result->stop, ==, QN_STOP_PLATEAU);
      g_assert_cmpfloat_with_epsilon (result->collapse_multiplier, collapse,
                                      (associative ? 1e-6 : 2e-3) * collapse);
      g_assert_cmpint (result->statistics.factorizations, <, wall == 6 ? 450 : 200);
      for (size_t s = 1; s < result->step_count; s++)
        if (result->steps[s].multiplier < 0.97 * collapse)
          farthest[k] = top_displacement (result, s);
    }
    follow_closely (wall, dilatancy, collapse, &results[farthest[1] > farthest[0]],
                    &close);
    for (int k = 0; k < 2; k++)
      for (size_t s = 1; s < results[k].step_count; s++)
        if (results[k].steps[s].multiplier < 0.97 * collapse)
          g_assert_cmpfloat_with_epsilon (
            multiplier_at (&close, top_displacement (&results[k], s)),
            results[k].steps[s].multiplier, 1.5e-3 * collapse);
    for (int k = 0; k < 2; k++)
      qn_result_clear (&results[k]);
  }
}

QN_TESTS
{
  g_test_add_func ("/path-control/overturning", test_overturning_in_large_displacements);
  g_test_add_func ("/path-control/overturning-until-nothing-is-left",
                   test_overturning_until_nothing_is_left);
  g_test_add_func ("/path-control/snap-back-by-arc-length", test_snap_back_by_arc_length);
  g_test_add_func ("/path-control/energy-of-displacements", test_energy_of_displacements);
  g_test_add_func ("/path-control/snap-under-held-displacement",
                   test_snap_under_held_displacement);
  g_test_add_func ("/path-control/stop-at-limit-point", test_stop_at_limit_point);
  g_test_add_func ("/path-control/plateau", test_plateau);
  g_test_add_func ("/path-control/largest-multiplier", test_largest_multiplier);
  g_test_add_func ("/path-control/elastic-member", test_elastic_member_never_collapses);
  g_test_add_func ("/path-control/sliding-courses", test_sliding_courses);
  g_test_add_func ("/path-control/peak-of-a-wall", test_peak_of_a_wall);
  g_test_add_func ("/path-control/walls-to-collapse", test_walls_to_collapse);
}
