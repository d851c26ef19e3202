#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "core/result/first-limit.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static void
run (QnModel *model, QnResult *result)
{
  g_auto (QnContacts) contacts;

  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
}

static void
control (QnModel *model, QnProcedure procedure, const char *block, QnDof dof,
         double target)
{
  model->analysis.procedure = procedure;
  model->analysis.control_block = block ? qn_model_find_block (model, block) : QN_NONE;
  model->analysis.control_dof = dof;
  model->analysis.control_target = target;
}

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
  control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UX, b / 2);
  run (&model, &result);

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
    control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    run (&model, &result);

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
  control (model, procedure, "head", QN_DOF_UY, target);
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
  run (&model, &result);

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
    control (&model, QN_PROCEDURE_DISPLACEMENT, "keystone", QN_DOF_UY, -0.5);
    run (&model, &result);
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
  run (&model, &result);

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
  run (&model, &result);
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
    run (&model, &result);
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
    control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    run (&model, &result);
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
    control (&model, procedures[i], displacement ? "w.11.4" : NULL, QN_DOF_UX, 0.05);
    model.analysis.max_multiplier = 0.2;
    run (&model, &result);
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
    control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    run (&model, &result);
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
    control (&model, procedures[i], "w.6.5", QN_DOF_UX, 0.05);
    run (&model, &result);
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
  control (&model, QN_PROCEDURE_DISPLACEMENT, NULL, QN_DOF_UX,
           top_displacement (path, last));
  model.analysis.control_block = (QnId) model.block_count - 1;
  model.analysis.increments = 8000;
  model.analysis.max_multiplier = 0.97 * collapse;
  run (&model, result);
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
      control (&model, procedures[k], NULL, QN_DOF_UX, 0);
      run (&model, &results[k]);
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

/* --- Branches on which nothing stays ----------------------------------------------------- */

#define EI 4e6 /* Nm2, of a section of 0.2 x 0.2 m */

static void
add_beam (QnModel *model, const char *name, QnId from, QnId to, int32_t elements)
{
  QnBeam *beam = qn_model_add_beam (model, name);
  beam->nodes[0] = from;
  beam->nodes[1] = to;
  beam->section = 0;
  beam->element_count = elements;
}

/* Straight, 4 m, clamped at its foot and pressed down at its head by 1 kN; or the frame of two such
 * columns under a beam of 4 m, pressed down at both corners. */
static void
init_columns (QnModel *model, int columns)
{
  QnId heads[2];

  test_model_init (model);
  QnSection *section = qn_model_add_section (model, "section");
  section->young = 3e10;
  section->width = section->height = 0.2;
  for (int i = 0; i < columns; i++) {
    QnNode *foot = qn_model_add_node (model, i == 0 ? "foot" : "foot 2");
    foot->at = qn_vec2 (4 * i, 0);
    foot->support[0] = foot->support[1] = foot->support[2] = true;
    QnNode *head = qn_model_add_node (model, i == 0 ? "head" : "head 2");
    head->at = qn_vec2 (4 * i, 4);
    heads[i] = (QnId) model->node_count - 1;
    add_beam (model, i == 0 ? "column" : "column 2", heads[i] - 1, heads[i], 24);
    QnLoad *load = qn_model_add_live_load (model);
    load->kind = QN_LOAD_NODE;
    load->node = heads[i];
    load->vector = qn_vec2 (0, -1000);
  }
  if (columns == 2)
    add_beam (model, "beam", heads[0], heads[1], 12);
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
}

/* Pressed down by a given way, straight columns stay straight for Newton's method, at many times the
 * load at which they buckle, where two eigenvalues are negative and the determinant is positive. Columns
 * bend as an elastica that shortens and shears (Runge-Kutta). The frame sways, at all increments at the
 * same load. */
static void
test_beyond_buckling (void)
{
  static const int increments[] = { 10, 20, 100, 200, 1000 };
  static const struct {
    int columns;
    bool pinned;
    double way, exact;
  } forms[] = { { 1, false, -2.5, 915.336 },
                { 1, true, -2.5, 3646.047 },
                { 2, false, -1, NAN } };
  double sways = NAN;

  for (size_t f = 0; f < G_N_ELEMENTS (forms); f++)
    for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
      g_auto (QnModel) model;
      g_auto (QnResult) result;
      init_columns (&model, forms[f].columns);
      if (forms[f].pinned) {
        model.nodes[0].support[QN_DOF_RZ] = false;
        model.nodes[1].support[QN_DOF_UX] = true;
        model.beams[0].element_count = 48; /* as many to a quarter of a wave */
      }
      control (&model, QN_PROCEDURE_DISPLACEMENT, NULL, QN_DOF_UY, forms[f].way);
      model.analysis.control_node = 1;
      model.analysis.increments = increments[i];
      run (&model, &result);
      double multiplier = result.steps[result.step_count - 1].multiplier;
      double exact = isnan (forms[f].exact) ? sways : forms[f].exact;
      g_test_message ("form %zu, %d increments: %.3f, %d factorisations", f,
                      increments[i], multiplier, result.statistics.factorizations);
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
      if (isnan (exact))
        sways = multiplier;
      else
        g_assert_cmpfloat_with_epsilon (multiplier, exact, 1e-3 * exact);
    }
  /* Clamped feet, heads that turn against the beam: between once and four times a column alone. */
  g_assert_cmpfloat (sways, >, G_PI * G_PI * EI / 64 / 1000);
  g_assert_cmpfloat (sways, <, 4 * G_PI * G_PI * EI / 64 / 1000 * 2);
}

/* The same under a prescribed load: what was called "without collapse" is bent. */
static void
test_loaded_beyond_buckling (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  init_columns (&model, 1);
  model.analysis.max_multiplier = 916.62;
  run (&model, &result);
  const double *head = qn_result_step_displacements (&result, result.step_count - 1) + 3;
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat_with_epsilon (head[1], -2.5, 0.01);
}

/* Whatever the procedure and its increments: where the straight branch ends is told, at the multiplier that
 * the search for the loss of stability finds, Euler's load of a column alone. A column that is pushed aside
 * as well bends from the start and loses nothing. */
static void
test_end_of_branch (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  static const int increments[] = { 1, 20, 200 };
  const double euler = G_PI * G_PI * EI / 64 / 1000;

  for (int columns = 1; columns <= 2; columns++)
    for (gsize p = 0; p < G_N_ELEMENTS (procedures); p++)
      for (gsize i = 0; i < 2 * G_N_ELEMENTS (increments); i++) {
        bool aside = i % 2 == 1;
        double end = columns == 1 ? 1.1 * euler : 4 * euler;
        g_auto (QnModel) model;
        g_auto (QnContacts) contacts;
        g_auto (QnResult) result, search;
        init_columns (&model, columns);
        if (aside)
          model.live_loads[0].vector.x = 1;
        control (&model, procedures[p], NULL, QN_DOF_UY, -0.3);
        model.analysis.control_node = 1;
        model.analysis.max_multiplier = end;
        model.analysis.increments = increments[i / 2];
        run (&model, &result);
        const QnPathEvent *buckling = qn_result_find_buckling (&result);
        g_assert_true ((buckling != NULL) == !aside);
        if (aside)
          continue;
        const double multiplier = buckling->multiplier;
        g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
        g_assert_cmpint (qn_stability_run (&model, &contacts, NULL, NULL, &search, NULL),
                         ==, QN_OK);
        g_test_message ("%d columns, procedure %d: %.4f, search %.4f, Euler %.4f",
                        columns, (int) procedures[p], multiplier,
                        search.first_limit_multiplier, euler);
        g_assert_cmpfloat_with_epsilon (multiplier / search.first_limit_multiplier, 1,
                                        model.analysis.multiplier_tolerance);
        if (columns == 1)
          g_assert_cmpfloat_with_epsilon (multiplier / euler, 1, 1e-3);
        else
          g_assert_cmpfloat (multiplier, >, 1.01 * euler);
        /* It is that of a step, and who asks to stop there stops there. */
        model.analysis.snap = QN_SNAP_THROUGH_STOP;
        qn_result_clear (&result);
        run (&model, &result);
        g_assert_cmpint (result.outcome, ==, QN_OUTCOME_SNAP);
        g_assert_cmpfloat (result.first_limit_multiplier, ==, multiplier);
        g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==,
                           multiplier);
      }
}

/* --- Joints without tension --------------------------------------------------------------- */

/* A block, and a stack, whose joints lose their shear forces at once when they open: they rock at
 * width / height, by every procedure. */
static void
test_no_tension (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH,
                                            QN_PROCEDURE_DISPLACEMENT };
  static const struct {
    int blocks;
    double width, height;
  } stacks[] = { { 1, 0.4, 1.2 }, { 4, 0.6, 0.3 }, { 12, 1, 0.3 } };

  for (size_t i = 0; i < 2 * G_N_ELEMENTS (procedures) * G_N_ELEMENTS (stacks); i++) {
    size_t s = i / 2 % G_N_ELEMENTS (stacks), p = i / 2 / G_N_ELEMENTS (stacks);
    double exact = stacks[s].width / (stacks[s].blocks * stacks[s].height), highest = 0;
    bool held = procedures[p] == QN_PROCEDURE_DISPLACEMENT;
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_stack (&model, stacks[s].blocks, stacks[s].width, stacks[s].height);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kind = QN_LAW_NO_TENSION;
    model.laws[0].kn = model.laws[0].ks = 1e9;
    model.analysis.increments = i % 2 ? 100 : 10;
    control (&model, procedures[p], NULL, QN_DOF_UX, 0.2);
    if (held)
      model.analysis.control_block = (QnId) model.block_count - 1;
    run (&model, &result);
    for (size_t step = 0; step < result.step_count; step++)
      highest = fmax (highest, result.steps[step].multiplier);
    g_assert_cmpint (result.outcome, ==,
                     held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (highest, exact, 1e-6);
  }
}

#define VOUSSOIRS 15

/* Semicircular, radii 0.9 and 1.1 m, joints without tension. */
static void
init_arch (QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1.2, -0.3, 2.4, 0.3);
  for (int i = 0; i < VOUSSOIRS; i++) {
    double from = G_PI * (1 - (double) i / VOUSSOIRS);
    double to = G_PI * (1 - (double) (i + 1) / VOUSSOIRS);
    const QnVec2 vertices[] = { qn_vec2 (0.9 * cos (from), 0.9 * sin (from)),
                                qn_vec2 (0.9 * cos (to), 0.9 * sin (to)),
                                qn_vec2 (1.1 * cos (to), 1.1 * sin (to)),
                                qn_vec2 (1.1 * cos (from), 1.1 * sin (from)) };
    g_autofree char *name = g_strdup_printf ("v%d", i);
    QnBlock *block = qn_model_add_block (model, name, vertices, 4);
    block->thickness = 1;
    block->unit_weight = 10000;
  }
  test_model_add_weight_loads (model, 1);
  model->laws[0].kind = QN_LAW_NO_TENSION;
  model->laws[0].kn = model->laws[0].ks = 1e9;
}

/* An arch of such joints comes to the load of limit analysis by every procedure; in large displacements to
 * one peak just below. */
static void
test_no_tension_arch (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH,
                                            QN_PROCEDURE_DISPLACEMENT };
  double exact, peak = NAN;
  g_auto (QnModel) rigid;
  g_auto (QnResult) limit;
  init_arch (&rigid);
  rigid.analysis.procedure = QN_PROCEDURE_LIMIT;
  run (&rigid, &limit);
  exact = limit.collapse_multiplier;
  g_assert_cmpfloat (exact, >, 0.05);

  for (size_t i = 0; i < 4 * G_N_ELEMENTS (procedures); i++) {
    QnProcedure procedure = procedures[i / 4];
    bool held = procedure == QN_PROCEDURE_DISPLACEMENT, moves = i % 2 == 1;
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    init_arch (&model);
    control (&model, procedure, held ? "v7" : NULL, QN_DOF_UX, 0.02);
    model.analysis.increments = i / 2 % 2 == 0 ? 10 : 100;
    model.analysis.geometry = moves ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
    double highest = 0;
    run (&model, &result);
    for (size_t step = 0; step < result.step_count; step++)
      highest = fmax (highest, result.steps[step].multiplier);
    g_test_message (
      "procedure %d, %d increments, moves %d: %.6f of %.6f, %d factorisations", procedure,
      model.analysis.increments, moves, highest, exact, result.statistics.factorizations);
    g_assert_cmpint (result.outcome, ==,
                     held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
    if (!moves)
      g_assert_cmpfloat_with_epsilon (highest, exact, 1e-4 * exact);
    else if (isnan (peak))
      peak = highest;
    else
      g_assert_cmpfloat_with_epsilon (highest, peak, 2e-4 * peak);
  }
  g_assert_cmpfloat (peak, <, exact);
  g_assert_cmpfloat (peak, >, 0.98 * exact);
}

/* In large displacements stacks carry a little less than width / height, and lean on at once: long steps
 * would pass that peak. Every procedure finds it to the tolerance of the multiplier, whatever its steps. */
static void
test_peaks_between_steps (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH, QN_PROCEDURE_LOAD };
  static const int increments[] = { 5, 10, 100 };
  static const QnLawKind laws[] = { QN_LAW_NO_TENSION, QN_LAW_COULOMB };
  static const struct {
    int blocks;
    double width, height, peak; /* of joints of 1e9 N/m, found in 1,000 increments too */
  } stacks[] = { { 1, 0.4, 1.2, 0.33330 },
                 { 4, 0.6, 0.3, 0.49996 },
                 { 12, 1, 0.3, 0.27756 } };

  for (size_t s = 0; s < G_N_ELEMENTS (stacks); s++)
    for (size_t l = 0; l < G_N_ELEMENTS (laws); l++)
      for (size_t p = 0; p < G_N_ELEMENTS (procedures); p++)
        for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
          bool held = procedures[p] == QN_PROCEDURE_DISPLACEMENT;
          g_auto (QnModel) model;
          g_auto (QnResult) result;
          test_model_init_stack (&model, stacks[s].blocks, stacks[s].width,
                                 stacks[s].height);
          test_model_add_weight_loads (&model, 1);
          model.laws[0].kind = laws[l];
          model.laws[0].friction = 2;
          model.laws[0].kn = model.laws[0].ks = 1e9;
          model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
          model.analysis.increments = increments[i];
          control (&model, procedures[p], NULL, QN_DOF_UX, 0.15 * stacks[s].width);
          if (held)
            model.analysis.control_block = (QnId) model.block_count - 1;
          run (&model, &result);
          g_test_message ("%d blocks, law %d, procedure %d, %d increments: %.6f, %d "
                          "factorisations",
                          stacks[s].blocks, laws[l], procedures[p], increments[i],
                          result.collapse_multiplier, result.statistics.factorizations);
          g_assert_cmpint (result.outcome, ==,
                           held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
          g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, stacks[s].peak,
                                          2e-4 * stacks[s].peak);
        }
}

/* A wall that lies turned with its loads takes the same steps: no measure knows of the axes. A collapse
 * found directly is exact to a part of the tolerance of the multiplier. */
static void
test_turned (void)
{
  for (int wall = 1; wall <= 5; wall++) {
    QnResult results[2];
    for (int turned = 0; turned < 2; turned++) {
      g_auto (QnModel) model;
      test_model_init_wall (&model, wall, 0);
      g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
      if (turned)
        test_model_rotate (&model, 2.4);
      run (&model, &results[turned]);
    }
    g_assert_cmpuint (results[0].step_count, ==, results[1].step_count);
    for (size_t s = 0; s < results[0].step_count; s++)
      g_assert_cmpfloat_with_epsilon (results[0].steps[s].multiplier,
                                      results[1].steps[s].multiplier, 1e-6);
    qn_result_clear (&results[0]);
    qn_result_clear (&results[1]);
  }
}

/* --- Bonds ------------------------------------------------------------------------------- */

/* A block b x h stuck to its base at two pairs, each with the tension ft: its heel comes off at
 * lambda = b (ft + W/2) / (W h/2), and from then on it rocks at b/h, by every procedure. */
static void
test_bond_of_a_rocking_block (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  const double b = 1, h = 2, weight = 2e4, tension = 5e3;
  const double first = b * (tension + weight / 2) / (weight * h / 2);

  for (size_t i = 0; i < 2 * G_N_ELEMENTS (procedures); i++) {
    bool tough = i >= G_N_ELEMENTS (procedures);
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_block_on_plane (&model, b, h);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kn = model.laws[0].ks = 1e9;
    model.laws[0].friction = 1;
    model.laws[0].cohesion = 2e4;
    model.laws[0].tension = tension;
    model.laws[0].fracture_energy_tension =
      tough ? 0.05 : 0; /* ten times the elastic one */
    control (&model, procedures[i % G_N_ELEMENTS (procedures)],
             i % G_N_ELEMENTS (procedures) > 0 ? "block" : NULL, QN_DOF_UX, 0.01);
    run (&model, &result);

    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, first, 2e-3 * first);
    g_assert_true (result.has_broken_bound);
    g_assert_cmpfloat_with_epsilon (result.broken_bound, b / h, 1e-6);
    if (i % G_N_ELEMENTS (procedures) == 0)
      continue;
    g_assert_true (result.outcome == QN_OUTCOME_TARGET_REACHED
                   || result.stop == QN_STOP_PLATEAU);
    const QnStep *last = &result.steps[result.step_count - 1];
    g_assert_cmpfloat_with_epsilon (last->multiplier, b / h, 1e-6);
    int broken = 0;
    for (size_t s = 0; s < result.step_count; s++)
      for (size_t p = 0; p < 2; p++) {
        QnPairResult pair = qn_result_pair_at (&result, s, p);
        if (pair.damage < 1 || pair.state != QN_PAIR_OPEN)
          continue;
        broken++;
        g_assert_cmpfloat (pair.normal_force, ==, 0);
        g_assert_cmpfloat (pair.shear_force, ==, 0);
      }
    g_assert_cmpint (broken, >, 5);
  }
}

/* What it takes to pull a block straight off its base is the fracture energy of both pairs,
 * besides its weight. */
static void
test_fracture_energy_of_a_joint (void)
{
  const double weight = 2e4, energy = 2;
  double work = 0;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  test_model_init_block_on_plane (&model, 1, 2);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, 1);
  model.blocks[1].support[QN_DOF_UX] = model.blocks[1].support[QN_DOF_RZ] = true;
  model.laws[0].kn = model.laws[0].ks = 1e8;
  model.laws[0].cohesion = 1e5;
  model.laws[0].tension = 5e3;
  model.laws[0].fracture_energy_tension = energy;
  model.analysis.increments = 400;
  control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UY, 1e-3);
  run (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  for (size_t s = 1; s < result.step_count; s++) {
    double rise = qn_result_step_displacements (&result, s)[4]
                  - qn_result_step_displacements (&result, s - 1)[4];
    double mean = 0.5 * (result.steps[s].multiplier + result.steps[s - 1].multiplier);
    work += (mean - 1) * weight * rise;
  }
  double stored = 0.5 * weight * weight / (2 * 5e7); /* by the weight, before */
  g_assert_cmpfloat_with_epsilon (work + stored, 2 * energy, 5e-3 * energy);
  for (size_t p = 0; p < 2; p++)
    g_assert_cmpfloat (result.pairs[p].damage, ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/path-control/bond-of-a-rocking-block", test_bond_of_a_rocking_block);
  g_test_add_func ("/path-control/fracture-energy", test_fracture_energy_of_a_joint);
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
  g_test_add_func ("/path-control/beyond-buckling", test_beyond_buckling);
  g_test_add_func ("/path-control/loaded-beyond-buckling", test_loaded_beyond_buckling);
  g_test_add_func ("/path-control/end-of-branch", test_end_of_branch);
  g_test_add_func ("/path-control/no-tension", test_no_tension);
  g_test_add_func ("/path-control/no-tension-arch", test_no_tension_arch);
  g_test_add_func ("/path-control/peaks-between-steps", test_peaks_between_steps);
  g_test_add_func ("/path-control/turned", test_turned);
}
