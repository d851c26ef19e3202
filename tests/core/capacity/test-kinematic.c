/* Mechanisms by code against hand numbers; docs/method/capacity.md has the same. */
#include "core/capacity/capacity.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

#define G 9.81

static void
check_close (double value, double expected, double tolerance)
{
  g_test_message ("%.8g, by hand %.8g", value, expected);
  g_assert_cmpfloat (fabs (value / expected - 1), <, tolerance);
}

/* By limit analysis, then by virtual work: both find the same multiplier. */
static void
find_with_ties (TestRun *run, QnCapacity *capacity, QnId control, double tie_strain)
{
  run->model.analysis.procedure = QN_PROCEDURE_LIMIT;
  test_run_solve (run);
  g_assert_cmpint (qn_capacity_init_kinematic (capacity, &run->model, &run->contacts,
                                               &run->result, control, tie_strain, NULL),
                   ==, QN_OK);
  check_close (capacity->found, capacity->activation, 1e-5);
}

static void
find (TestRun *run, QnCapacity *capacity, QnId control)
{
  find_with_ties (run, capacity, control, 0);
}

static void
add_force (QnModel *model, bool live, QnId block, QnVec2 at, QnVec2 force)
{
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = block;
  load->vector = force;
  load->has_at = true;
  load->at = at;
}

static void
add_tie (QnModel *model, QnId block, QnVec2 at, QnVec2 ground, double anchor)
{
  QnTie *tie = qn_model_add_tie (model, "tie");
  tie->ends[0] = (QnTieEnd){ block, at };
  tie->ends[1].at = ground;
  tie->area = 1e-4;
  tie->elasticity = 2e11;
  tie->anchor = anchor;
}

static void
init_block (TestRun *run)
{
  test_model_init_block_on_plane (&run->model, 0.6, 3);
  test_model_add_weight_loads (&run->model, 1);
}

/* 0.6 x 3 m, 18 kN: alpha0 = b/h; alpha = tan (atan 0.2 - theta), the centroid having moved by
 * R (sin alpha - sin (alpha - theta)), as of the path in test-capacity.c. */
static void
test_rocking_wall (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  init_block (&run);
  find (&run, &capacity, QN_NONE);
  check_close (capacity.activation, 0.2, 1e-9);
  check_close (capacity.works[QN_WORK_DEAD], 18000 * 0.2, 1e-9);
  check_close (capacity.share, 1, 1e-12);
  g_assert_true (capacity.reaches_zero);
  check_close (capacity.end, 0.3, 1e-4);
  check_close (qn_capacity_acceleration (&capacity, 0.12), 0.118493 * G, 1e-4);
  const QnSpectrum spectrum = { .kind = QN_SPECTRUM_EN_1,
                                .ground_acceleration = 0.25 * G,
                                .soil = QN_SOIL_C,
                                .damping = 0.05 };
  check_close (qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV).ratio, 0.66036,
               2e-4);
  /* a0* = 0.2 g/1.35 against 0.25 g 1.15 */
  QnLinearCheck linear = qn_capacity_check_linear (&capacity, &spectrum, 1.35, 0);
  check_close (linear.capacity, 0.2 * G / 1.35, 1e-9);
  check_close (linear.sld, 0.2 / 1.35 / (0.25 * 1.15), 1e-9);
  check_close (linear.slv, 2 * linear.sld, 1e-12);
  qn_capacity_clear (&capacity);
}

/* To the left, and half the weight at multiplier 1: the same acceleration. */
static void
test_direction (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  init_block (&run);
  run.model.live_loads[0].vector.x = -0.5;
  find (&run, &capacity, QN_NONE);
  check_close (capacity.activation, 0.4, 1e-9);
  check_close (capacity.points[0].acceleration, 0.2 * G, 1e-9);
  check_close (capacity.end, 0.3, 1e-4);
  qn_capacity_clear (&capacity);
}

/* A tie of 2 kN at a height of 2.9 m, back to the ground: alpha0 = (18 0.3 + 2 2.9)/(18 1.5). The curve
 * is that of the wall alone. */
static void
test_tie (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  init_block (&run);
  add_tie (&run.model, 1, qn_vec2 (-0.3, 2.9), qn_vec2 (-4, 2.9), 2000);
  find (&run, &capacity, QN_NONE);
  check_close (capacity.activation, (18 * 0.3 + 2 * 2.9) / (18 * 1.5), 1e-6);
  check_close (capacity.points[0].multiplier, 0.2, 1e-6);
  check_close (capacity.end, 0.3, 1e-4);
  const QnSpectrum spectrum = { .kind = QN_SPECTRUM_EN_1,
                                .ground_acceleration = 0.25 * G,
                                .soil = QN_SOIL_C,
                                .damping = 0.05 };
  check_close (qn_capacity_check_linear (&capacity, &spectrum, 1, 0).capacity,
               (18 * 0.3 + 2 * 2.9) / (18 * 1.5) * G, 1e-6);
  qn_capacity_clear (&capacity);
}

/* The tie of before, and what it adds to the multiplier of the wall as it turns by theta about its toe
 * at (0.3, 0): its end at (-0.6, 2.9) from the toe moves to (x, y), the force along the line to
 * (-4.3, 2.9) has the arm -(x - a) y' + ..., all by the law of cosines. */
static double
multiplier_with_tie (double theta, double stiffness, double strength)
{
  const double end[2] = { -0.6 * cos (theta) + 2.9 * sin (theta),
                          0.6 * sin (theta) + 2.9 * cos (theta) };
  const double line[2] = { -4.3 - end[0], 2.9 - end[1] };
  double length = hypot (line[0], line[1]);
  double force = fmin (stiffness * (length - 3.7), strength);
  double moment =
    force * (end[0] * line[1] - end[1] * line[0]) / length; /* to the left */
  double alpha = atan (0.2) - theta, radius = hypot (0.3, 1.5);
  return (18000 * radius * sin (alpha) + moment) / (18000 * radius * cos (alpha));
}

/* A soft tie: its force grows with its elongation until 2 kN, at 0.15 m; it breaks at a strain of 0.1,
 * 0.37 m. Then the curve is that of the wall alone, and SLV is where it breaks. */
static void
test_tie_in_curve (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  size_t before = 0;
  init_block (&run);
  add_tie (&run.model, 1, qn_vec2 (-0.3, 2.9), qn_vec2 (-4, 2.9), 2000);
  run.model.ties[0].elasticity = 2000 / 0.15 * 3.7 / run.model.ties[0].area;
  find_with_ties (&run, &capacity, QN_NONE, 0.1);
  check_close (capacity.points[0].multiplier, 0.2, 1e-6);
  for (size_t i = 1; i < capacity.count; i++) {
    double theta =
      atan (0.2)
      - asin (sin (atan (0.2)) - capacity.points[i].control / hypot (0.3, 1.5));
    double reach = hypot (-4.3 + 0.6 * cos (theta) - 2.9 * sin (theta),
                          2.9 - 0.6 * sin (theta) - 2.9 * cos (theta));
    if (reach < 3.7 * 1.1) {
      check_close (capacity.points[i].multiplier,
                   multiplier_with_tie (theta, 2000 / 0.15, 2000), 1e-6);
      before = i;
    } else if (capacity.points[i].multiplier > 0)
      check_close (capacity.points[i].multiplier, tan (atan (0.2) - theta), 1e-5);
  }
  g_assert_cmpuint (before, >, 20);
  g_assert_cmpuint (before, <, capacity.count - 5);
  check_close (capacity.end, 0.3, 1e-4);
  check_close (capacity.broken, capacity.points[before].displacement, 1e-12);
  /* 0.4 d0* = 0.12 m is before that: the break does not decide; a tie that breaks at once does */
  const QnSpectrum spectrum = {
    .kind = QN_SPECTRUM_EN_1, .ground_acceleration = 2, .soil = QN_SOIL_B, .damping = 0.05
  };
  check_close (qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV).capacity,
               fmin (0.12, capacity.broken), 1e-4);
  capacity.broken = 0.05;
  check_close (qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV).capacity, 0.05,
               1e-12);
  check_close (qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLC).capacity, 0.18,
               1e-4);
  qn_capacity_clear (&capacity);
}

/* The wall 6 m up in a building of 9 m with three storeys, T1 = 0.3 s and damping of 0.05; ag S = 1.2,
 * soil B: gamma = 9/7, Se(T1) = 3, aZ = 3 9/7 2/3 sqrt(1.01) = 2.584254 m/s2. A part that vibrates at
 * 0.3 s has A = 1.1/sqrt(0.05) = 4.91935 times that. Sa of EN 1998-1: 1.2 (3 (1 + 2/3)/2 - 0.5) where
 * rigid, 1.2 (5 - 0.5) at 0.3 s. */
static void
test_above_ground (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  QnSpectrum spectrum = { .kind = QN_SPECTRUM_EN_1,
                          .ground_acceleration = 1,
                          .soil = QN_SOIL_B,
                          .damping = 0.05,
                          .floor = { 6, 9, 3, 0.3, 0.05 } };
  init_block (&run);
  find (&run, &capacity, QN_NONE);
  QnLinearCheck linear = qn_capacity_check_linear (&capacity, &spectrum, 1.35, 0);
  check_close (linear.demand, 2.584254, 1e-5);
  check_close (linear.sld, 0.2 * G / 1.35 / 2.584254, 1e-5);
  check_close (linear.en_demand, 1.2 * 2, 1e-9);
  check_close (linear.en_ratio, 0.2 * G / 1.35 / 2.4, 1e-9);
  linear = qn_capacity_check_linear (&capacity, &spectrum, 1.35, 0.3);
  check_close (linear.demand, 4.919350 * 2.584254, 1e-5);
  check_close (linear.en_demand, 1.2 * 4.5, 1e-9);
  /* T = 1.6958 s of SLV, as at the ground: SeZ = 12.7125/(1 + 3.91935 (1.6958/0.33 - 1)^1.2) = 0.5611
     is below Se = 3 0.5/T = 0.88454, which is 0.064435 m; more is b T1 = 0.33 s: 12.7125 m/s2 over
     (2 pi/0.33)^2 = 0.035067 m, less again */
  check_close (qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV).demand,
               3 * 0.5 / 1.6958 * 1.6958 * 1.6958 / (4 * QN_PI * QN_PI), 2e-4);
  qn_capacity_clear (&capacity);
}

/* A floor of 10 kN 0.2 m behind the toe, with its mass: alpha0 = (18 0.3 + 10 0.2)/(18 1.5 + 10 3),
 * e* = 57^2/(28 (18 1.5^2 + 10 3^2)). */
static void
test_floor (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  init_block (&run);
  add_force (&run.model, false, 1, qn_vec2 (0.1, 3), qn_vec2 (0, -10000));
  add_force (&run.model, true, 1, qn_vec2 (0.1, 3), qn_vec2 (10000, 0));
  find (&run, &capacity, QN_NONE);
  check_close (capacity.activation, 7.4 / 57, 1e-6);
  check_close (capacity.share, 57.0 * 57 / (28 * (18 * 2.25 + 90)), 1e-6);
  check_close (capacity.moving_mass, 28000 / G, 1e-9);
  check_close (capacity.points[0].acceleration, 7.4 / 57 * G / capacity.share, 1e-6);
  qn_capacity_clear (&capacity);
}

/* Vertical bending between floors: two halves of h = 1.5 m and t = 0.3 m, W = 4.5 kN each, under a floor
 * of N = 20 kN that goes up and down alone. The hinge is at mid-height: alpha0 = 2 t (W + N)/(W h),
 * e* = 2 W/(2 W + N). All is upright together, where the hinge has moved by t and the centroids by
 * t/2. */
static void
test_bending (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  test_model_init (&run.model);
  test_model_add_base (&run.model, 0, -0.2, 0.3, 0.2);
  test_model_add_rectangle (&run.model, "low", 0, 0, 0.3, 1.5);
  test_model_add_rectangle (&run.model, "high", 0, 1.5, 0.3, 1.5);
  QnBlock *floor = test_model_add_rectangle (&run.model, "floor", 0, 3, 0.3, 0.2);
  floor->unit_weight = 20000 / (0.3 * 0.2);
  floor->support[QN_DOF_UX] = floor->support[QN_DOF_RZ] = true;
  test_model_add_weight_loads (&run.model, 1);
  find (&run, &capacity, 1);
  check_close (capacity.activation, 2 * 0.3 * 24.5 / (4.5 * 1.5), 1e-6);
  check_close (capacity.share, 9.0 / 29, 1e-6);
  g_assert_true (capacity.reaches_zero);
  check_close (capacity.end, 0.15, 1e-4);
  g_assert_cmpuint (capacity.participating, ==, 3);
  qn_capacity_clear (&capacity);
}

/* An arch folds as three bodies at four hinges; its multiplier falls as it moves. */
static void
test_arch (void)
{
  g_auto (TestRun) run = { 0 };
  QnCapacity capacity;
  QnMechanism mechanism;
  test_arch_init (&run.model, 0.15, 27, 1);
  run.model.laws[0].friction = 2;
  find (&run, &capacity, QN_NONE);
  g_assert_cmpint (
    qn_mechanism_of_result (&mechanism, &run.model, &run.contacts, &run.result, NULL), ==,
    QN_OK);
  g_assert_cmpuint (mechanism.body_count, ==, 3);
  g_assert_true (capacity.reaches_zero);
  for (size_t i = 1; i < capacity.count; i++)
    g_assert_cmpfloat (capacity.points[i].multiplier, <,
                       capacity.points[i - 1].multiplier);
  qn_mechanism_clear (&mechanism);
  qn_capacity_clear (&capacity);
}

/* Checks the block with a motion that is given; returns why it is refused. */
static QnProblem
refusal (TestRun *run, const double motion[QN_DOF_COUNT], bool ended)
{
  QnCapacity capacity;
  QnDiag diag = { 0 };
  double velocities[2 * QN_DOF_COUNT] = { 0, 0, 0, motion[0], motion[1], motion[2] };
  test_run_prepare (run);
  g_assert_cmpint (qn_result_init (&run->result, 2, run->contacts.pair_count, &diag), ==,
                   QN_OK);
  if (ended)
    g_assert_cmpint (qn_result_set_mechanism (&run->result, velocities, 1, NULL), ==,
                     QN_OK);
  g_assert_cmpint (qn_capacity_init_kinematic (&capacity, &run->model, &run->contacts,
                                               &run->result, QN_NONE, 0, &diag),
                   ==, QN_ERROR_INVALID);
  g_assert_null (capacity.points);
  test_run_clear (run);
  *run = (TestRun){ 0 };
  return diag.problem;
}

static void
test_refuse (void)
{
  const double turns[] = { 1.5, 0.3, -1 }, slides[] = { 1, 0, 0 },
               back[] = { -1.5, 0.3, 1 };
  TestRun run = { 0 };
  init_block (&run);
  g_assert_cmpint (refusal (&run, turns, false), ==, QN_PROBLEM_MECHANISM_MISSING);
  init_block (&run);
  g_assert_cmpint (refusal (&run, slides, true), ==, QN_PROBLEM_MECHANISM_SLIDES);
  init_block (&run);
  g_assert_cmpint (refusal (&run, back, true), ==, QN_PROBLEM_CAPACITY_MOTION);
  init_block (&run);
  run.model.dead_load_count = 0;
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_MECHANISM_WEIGHT);
  init_block (&run);
  add_tie (&run.model, 1, qn_vec2 (-0.3, 2.9), qn_vec2 (-4, 2.9), 0);
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_MECHANISM_TIE);
  init_block (&run);
  add_force (&run.model, true, 1, qn_vec2 (0, 3), qn_vec2 (0, 1));
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_CAPACITY_LOADS);
  /* Against the weights, turning, and weights of two directions that leave none. */
  init_block (&run);
  add_force (&run.model, true, 1, qn_vec2 (0, 3), qn_vec2 (-1, 0));
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_CAPACITY_LOADS);
  init_block (&run);
  add_force (&run.model, true, 1, qn_vec2 (0, 3), qn_vec2 (1, 0));
  run.model.live_loads[1].moment = 1;
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_CAPACITY_LOADS);
  init_block (&run);
  QnLoad *against = qn_model_add_live_load (&run.model);
  *against = run.model.live_loads[0];
  against->vector.x = -1;
  g_assert_cmpint (refusal (&run, turns, true), ==, QN_PROBLEM_CAPACITY_LOADS);
}

/* The motion of a mode, of buckling, or of an analysis in time is no mechanism. */
static void
test_no_mechanism (void)
{
  const double velocities[2 * QN_DOF_COUNT] = { 0, 0, 0, 1.5, 0.3, -1 };
  for (int why = 0; why < 3; why++) {
    g_auto (TestRun) run = { 0 };
    QnCapacity capacity;
    QnDiag diag = { 0 };
    init_block (&run);
    test_run_prepare (&run);
    QnResult *r = &run.result;
    g_assert_cmpint (qn_result_init (r, 2, run.contacts.pair_count, NULL), ==, QN_OK);
    g_assert_cmpint (qn_result_set_mechanism (r, velocities, 1, NULL), ==, QN_OK);
    r->vibration.mode = why == 0;
    r->stability = why == 1 ? QN_STABILITY_LOST : QN_STABILITY_UNKNOWN;
    r->history.width = why == 2;
    g_assert_cmpint (qn_capacity_init_kinematic (&capacity, &run.model, &run.contacts, r,
                                                 QN_NONE, 0, &diag),
                     ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_MECHANISM_MISSING);
  }
}

QN_TESTS
{
  g_test_add_func ("/kinematic/no-mechanism", test_no_mechanism);
  g_test_add_func ("/kinematic/rocking-wall", test_rocking_wall);
  g_test_add_func ("/kinematic/direction", test_direction);
  g_test_add_func ("/kinematic/tie", test_tie);
  g_test_add_func ("/kinematic/tie-in-curve", test_tie_in_curve);
  g_test_add_func ("/kinematic/above-ground", test_above_ground);
  g_test_add_func ("/kinematic/floor", test_floor);
  g_test_add_func ("/kinematic/bending", test_bending);
  g_test_add_func ("/kinematic/arch", test_arch);
  g_test_add_func ("/kinematic/refuse", test_refuse);
}
