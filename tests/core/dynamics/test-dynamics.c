/* Closed forms of single bodies in time. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

#define G 9.81

static void
init_case (TestRun *c, double width, double height)
{
  *c = (TestRun){ 0 };
  test_model_init_block_on_plane (&c->model, width, height);
  c->model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
}

static void
track (TestRun *c, QnId block, QnDof dof)
{
  QnTrack *track = qn_model_add_track (&c->model);
  track->block = block;
  track->dof = dof;
}

static void
add_weight (TestRun *c)
{
  QnLoad *load = qn_model_add_dead_load (&c->model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (0, -1);
}

static double
tracked (const TestRun *c, size_t row, int which)
{
  const QnHistory *h = &c->result.history;
  return h->rows[row * h->width + QN_HISTORY_TRACK + (size_t) which];
}

/* --- Walls with every kind of joint ---------------------------------------------------------- */

/* A step that is short enough has a solution, whatever a joint does; and what is dilated or crushed between
 * the steps that are kept does not make the result wrong. */
static void
test_joints (void)
{
  static const struct {
    QnLawKind kind;
    double friction, cohesion, tension, dilatancy, compression; /* N per pair */
  } joints[] = {
    { QN_LAW_COULOMB, 0.4, 2e4, 0, 0, 0 },   { QN_LAW_COULOMB, 0.55, 3e3, 0, 0, 0 },
    { QN_LAW_COULOMB, 0.6, 1e3, 4e2, 0, 0 }, { QN_LAW_COULOMB, 0.65, 0, 0, 0.3, 0 },
    { QN_LAW_COULOMB, 0.4, 0, 0, 0.2, 0 },   { QN_LAW_MOHR_COULOMB, 0.5, 5e2, 0, 0, 6e3 },
  };
  static const double rho[] = { 0, 0.5, 0.8, 1 };
  for (gsize joint = 0; joint < G_N_ELEMENTS (joints); joint++)
    for (gsize i = 0; i < G_N_ELEMENTS (rho); i++) {
      g_auto (TestRun) c = { 0 };
      test_bond_init (&c.model, TEST_UNIT, 3, 6, 0, 0);
      QnLaw *law = &c.model.laws[0];
      law->kn = law->ks = 1e9;
      law->friction = joints[joint].friction;
      law->kind = joints[joint].kind;
      law->cohesion = joints[joint].cohesion;
      law->tension = joints[joint].tension;
      law->dilatancy = joints[joint].dilatancy;
      law->compression = joints[joint].compression;
      c.model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
      c.model.analysis.geometry = i % 2 == 0 ? QN_GEOMETRY_NONLINEAR : QN_GEOMETRY_LINEAR;
      QnDynamicSettings *dynamic = &c.model.analysis.dynamic;
      dynamic->duration = 0.6;
      dynamic->time_step = 0.005;
      dynamic->rho = rho[i];
      dynamic->joint_damping = i % 2 == 0 ? 0 : 2e-4;
      dynamic->output_interval = 0.1;
      QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
      motion->kind = QN_SIGNAL_PULSE;
      motion->direction = qn_vec2 (1, 0.3);
      motion->pulse = (QnPulse){ QN_PULSE_SINE, 7, 0.4, 0 };
      test_run_solve (&c);
      g_test_message ("joint %d, rho %g: outcome %d at %g s, energy error %.1e",
                      (int) joint, rho[i], c.result.outcome, c.result.history.end,
                      c.result.history.energy_error);
      g_assert_cmpint (c.result.outcome, !=, QN_OUTCOME_NOT_CONVERGED);
      g_assert_cmpfloat (c.result.history.energy_error, <, 1e-4);
    }
}

/* Of a bond with cohesion alone friction relieves what is left, which breaks nevertheless when it is brittle. */
static void
test_relieved_bond (void)
{
  g_auto (TestRun) c;
  init_case (&c, 0.4, 0.2);
  add_weight (&c);
  c.model.laws[0] = (QnLaw){ .name = c.model.laws[0].name,
                             .kind = QN_LAW_COULOMB,
                             .basis = QN_BASIS_SURFACE,
                             .kn = 3.4e8,
                             .ks = 1.36e8,
                             .friction = 0.5,
                             .residual_friction = 0.4,
                             .cohesion = 2e5,
                             .fracture_energy_tension = 2,
                             .fracture_energy_shear = 200,
                             .exponential = true };
  QnDynamicSettings *dynamic = &c.model.analysis.dynamic;
  dynamic->duration = 0.4;
  dynamic->time_step = 0.002;
  dynamic->rho = 0.5;
  dynamic->of = QN_DAMPING_IMPACT;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ QN_PULSE_SINE, 50, 0.3, 0 };
  test_run_solve (&c);
  g_assert_cmpint (c.result.outcome, !=, QN_OUTCOME_NOT_CONVERGED);
}

/* --- A mass on a spring ------------------------------------------------------------------- */

/* Error of x(t) after `steps` steps over two periods, over the first amplitude. */
static double
spring_error (double rho, double ratio, QnDampingStiffness of, int steps, double *energy)
{
  g_auto (TestRun) c;
  init_case (&c, 1, 1);
  QnLaw *law = &c.model.laws[0];
  law->kind = QN_LAW_ELASTIC;
  law->kn = law->ks = 4e6;
  double mass = 10000 / G, omega = sqrt (4e6 / mass), period = 2 * G_PI / omega;
  c.model.analysis.dynamic.duration = 2 * period;
  c.model.analysis.dynamic.time_step = 2 * period / steps;
  c.model.analysis.dynamic.adaptive = false;
  c.model.analysis.dynamic.rho = rho;
  c.model.analysis.dynamic.joint_damping = 2 * ratio / omega;
  c.model.analysis.dynamic.of = of;
  QnInitialMotion *start = qn_model_add_initial_motion (&c.model);
  start->block = 1;
  start->displacement[QN_DOF_UY] = 0.001;
  track (&c, 1, QN_DOF_UY);
  test_run_solve (&c);
  double damped = omega * sqrt (1 - ratio * ratio), worst = 0;
  const QnHistory *h = &c.result.history;
  g_assert_cmpuint (h->row_count, ==, (gsize) steps + 1);
  for (size_t i = 0; i < h->row_count; i++) {
    double t = h->rows[i * h->width];
    double exact = 0.001 * exp (-ratio * omega * t)
                   * (cos (damped * t) + ratio * omega / damped * sin (damped * t));
    worst = MAX (worst, fabs (tracked (&c, i, 0) - exact) / 0.001);
  }
  *energy = h->energy_error;
  return worst;
}

static void
test_spring (void)
{
  const double radii[] = { 1, 0.8, 0.5, 0 }, ratios[] = { 0, 0.05 };
  for (gsize r = 0; r < G_N_ELEMENTS (radii); r++)
    for (gsize d = 0; d < G_N_ELEMENTS (ratios); d++)
      for (int of = 0; of <= QN_DAMPING_INITIAL; of++) {
        double energy;
        double coarse = spring_error (radii[r], ratios[d], of, 200, &energy);
        g_assert_cmpfloat (energy, <, 1e-9);
        double fine = spring_error (radii[r], ratios[d], of, 400, &energy);
        double order = log2 (coarse / fine);
        g_test_message ("rho %g, damping %g: error %.2e, %.2e, order %.3f", radii[r],
                        ratios[d], coarse, fine, order);
        g_assert_cmpfloat (order, >, 1.95);
        g_assert_cmpfloat (order, <, 2.05);
      }
  double energy;
  g_assert_cmpfloat (spring_error (0.8, 0.05, QN_DAMPING_CURRENT, 800, &energy), <, 1e-3);
}

/* --- Newmark's sliding block -------------------------------------------------------------- */

/* A block on the ground under a pulse; its displacement is tracked. */
static void
slide (TestRun *c, QnPulse pulse, double rho, double step, gboolean adaptive)
{
  init_case (c, 2, 0.2);
  c->model.laws[0].friction = 0.3;
  c->model.laws[0].kn = c->model.laws[0].ks = 1e12;
  add_weight (c);
  c->model.analysis.dynamic.duration = 1;
  c->model.analysis.dynamic.time_step = step;
  c->model.analysis.dynamic.rho = rho;
  c->model.analysis.dynamic.adaptive = adaptive;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c->model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (-1, 0);
  motion->pulse = pulse;
  track (c, 1, QN_DOF_UX);
  test_run_solve (c);
  g_assert_cmpfloat (c->result.history.energy_error, <, 1e-6);
}

/* Error of the slip that is left. */
static double
slide_error (QnPulse pulse, double rho, double step, gboolean adaptive, double exact)
{
  g_auto (TestRun) c;
  slide (&c, pulse, rho, step, adaptive);
  double slip = tracked (&c, c.result.history.row_count - 1, 0);
  g_test_message ("rho %g, step %g: %.7f m of %.7f m", rho, step, slip, exact);
  return fabs (slip / exact - 1);
}

static void
test_slide_rectangle (void)
{
  const QnPulse pulse = { QN_PULSE_RECTANGLE, 5, 0.2, 0.05 };
  const double exact = 0.5 * 5 * 0.2 * 0.2 * (5 / (0.3 * G) - 1);
  const double radii[] = { 1, 0.8, 0.5 };
  for (gsize i = 0; i < G_N_ELEMENTS (radii); i++)
    g_assert_cmpfloat (slide_error (pulse, radii[i], 0.005, TRUE, exact), <, 1e-3);
  /* Where pulse and steps begin together nothing but the order is left. */
  double coarse = slide_error (pulse, 0.8, 0.01, FALSE, exact);
  double fine = slide_error (pulse, 0.8, 0.005, FALSE, exact);
  g_assert_cmpfloat (log2 (coarse / fine), >, 1.8);
}

/* A base that has settled under the dead load moves its block along as one that has not: the same sliding, lower
 * by the settlement. */
static void
test_settled_base (void)
{
  g_auto (TestRun) still = { 0 };
  g_auto (TestRun) lowered = { 0 };
  TestRun *const runs[] = { &still, &lowered };
  for (int settled = 0; settled < 2; settled++) {
    TestRun *c = runs[settled];
    init_case (c, 2, 0.2);
    c->model.laws[0].friction = 0.3;
    add_weight (c);
    if (settled) {
      QnLoad *load = qn_model_add_dead_load (&c->model);
      load->kind = QN_LOAD_SETTLEMENT;
      load->block = 0;
      load->dof = QN_DOF_UY;
      load->value = -0.02;
    }
    track (c, 1, QN_DOF_UX);
    track (c, 1, QN_DOF_UY);
    c->model.analysis.dynamic.duration = 0.3;
    c->model.analysis.dynamic.time_step = 0.005;
    QnGroundMotion *motion = qn_model_add_ground_motion (&c->model);
    motion->kind = QN_SIGNAL_PULSE;
    motion->direction = qn_vec2 (1, 0);
    motion->pulse = (QnPulse){ QN_PULSE_RECTANGLE, 5, 0.2, 0.05 };
    test_run_solve (c);
    g_assert_cmpint (c->result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpint (test_run_count_faults (c), ==, 0);
  }
  const size_t last = runs[0]->result.history.row_count - 1;
  g_assert_cmpuint (runs[1]->result.history.row_count, ==, last + 1);
  g_assert_cmpfloat (fabs (tracked (runs[0], last, 0)), >, 0.01);
  g_assert_cmpfloat_with_epsilon (tracked (runs[1], last, 0), tracked (runs[0], last, 0),
                                  1e-6);
  g_assert_cmpfloat_with_epsilon (tracked (runs[1], last, 1),
                                  tracked (runs[0], last, 1) - 0.02, 1e-6);
}

/* Factorisations of a hundred steps under a pulse, without those of the dead load. */
static int
count_factorizations (double amplitude, QnGeometry geometry, double damping)
{
  g_auto (TestRun) c;
  init_case (&c, 2, 0.2);
  c.model.laws[0].friction = 0.3;
  c.model.laws[0].kn = c.model.laws[0].ks = 1e9;
  add_weight (&c);
  QnDynamicSettings *dynamic = &c.model.analysis.dynamic;
  c.model.analysis.geometry = geometry;
  dynamic->duration = 0.5;
  dynamic->time_step = 0.005;
  dynamic->adaptive = false;
  dynamic->joint_damping = damping;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ QN_PULSE_RECTANGLE, amplitude, 0.2, 0.05 };
  test_run_solve (&c);
  g_assert_cmpint (c.result.history.steps, ==, 100);
  g_assert_cmpint (c.result.statistics.iterations, >=, 50);
  int count = c.result.statistics.factorizations;
  double slipped = c.result.history.largest_slip;
  g_test_message ("amplitude %g, geometry %d, damping %g: %d factorisations, slip %.2g",
                  amplitude, geometry, damping, count, slipped);
  g_assert_true ((slipped > 0) == (amplitude > 0.3 * G));
  return count;
}

/* Where nothing changes state nothing is factorised again; where a block begins to slide and comes to
 * rest, for those changes and not for the steps between. */
static void
test_factorizations (void)
{
  for (int geometry = 0; geometry <= QN_GEOMETRY_NONLINEAR; geometry++)
    for (int damped = 0; damped < 2; damped++) {
      double damping = 1e-4 * damped;
      g_assert_cmpint (count_factorizations (1, (QnGeometry) geometry, damping), <=, 3);
      g_assert_cmpint (count_factorizations (5, (QnGeometry) geometry, damping), <=, 20);
    }
}

/* Under a sine it slides to and fro; beside its own equation of motion, by small steps. Where it
 * turns, friction changes sign within a step, which counts to first order: the steps are short. */
static void
test_slide_sine (void)
{
  const QnPulse pulse = { QN_PULSE_SINE, 6, 0.4, 0.02 };
  const double h = 1e-6, limit = 0.3 * G;
  double v = 0, u = 0, farthest = 0, worst = 0;
  TestRun c;
  slide (&c, pulse, 0.8, 0.00025, TRUE);
  const QnHistory *history = &c.result.history;
  double t = 0;
  for (size_t row = 0; row < history->row_count; row++) {
    for (; t < history->rows[row * history->width] - 0.5 * h; t += h) {
      double s = (t + 0.5 * h - pulse.start) / pulse.duration;
      double a = s < 0 || s > 1 ? 0 : pulse.amplitude * sin (2 * G_PI * s), before = v;
      if (v == 0 && fabs (a) <= limit)
        continue;
      v += h * (a - copysign (limit, v != 0 ? v : a));
      if (before * v < 0)
        v = 0; /* it has stopped */
      u += 0.5 * h * (before + v);
    }
    farthest = MAX (farthest, fabs (u));
    worst = MAX (worst, fabs (tracked (&c, row, 0) - u));
  }
  g_test_message ("%.2e m of %.4f m", worst, farthest);
  g_assert_cmpfloat (farthest, >, 0.03);
  g_assert_cmpfloat (worst / farthest, <, 1e-3);
  test_run_clear (&c);
}

/* A wall without loads, on ground that is accelerated upwards until the wall rests upon it: what is
 * balanced then are forces of its weight, and motion that dies away is measured by them. */
static void
test_rising_ground (void)
{
  g_auto (TestRun) c = { 0 };
  test_model_init_wall (&c.model, 1, 0);
  c.model.dead_load_count = c.model.live_load_count = 0;
  c.model.laws[0].kn = c.model.laws[0].ks = 1e9;
  c.model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
  QnDynamicSettings *dynamic = &c.model.analysis.dynamic;
  dynamic->duration = 2;
  dynamic->time_step = 0.01;
  dynamic->mass_damping = 5;
  dynamic->joint_damping = 2e-4;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->direction = qn_vec2 (0, 1);
  qn_ground_motion_add_point (motion, 0, 0);
  qn_ground_motion_add_point (motion, 1, G);
  qn_ground_motion_add_point (motion, 3, G);
  test_run_solve (&c);
  g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (c.result.history.rejected, ==, 0);
}

/* --- The rocking block -------------------------------------------------------------------- */

#define WIDTH  0.2
#define HEIGHT 1.0

/* When a rigid block that is let go at theta comes to stand on its base, s:
 * 4/3 R theta'' = -g sin(alpha - theta), by Runge and Kutta's method. */
static double
quarter_period (double theta)
{
  const double h = 1e-5, alpha = atan (WIDTH / HEIGHT);
  const double factor = -0.75 * G / (0.5 * hypot (WIDTH, HEIGHT));
  double t = 0, v = 0, before = theta;
  while (theta > 0) {
    double k1 = factor * sin (alpha - theta);
    double k2 = factor * sin (alpha - theta - 0.5 * h * v);
    double k3 = factor * sin (alpha - theta - 0.5 * h * v - 0.25 * h * h * k1);
    double k4 = factor * sin (alpha - theta - h * v - 0.5 * h * h * k2);
    before = theta;
    theta += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    t += h;
  }
  return t - h * theta / (theta - before);
}

static void
init_rocking_of (TestRun *c, double width, double theta)
{
  init_case (c, width, HEIGHT);
  c->model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  c->model.laws[0].kn = c->model.laws[0].ks = 1e9;
  add_weight (c);
  track (c, 1, QN_DOF_RZ);
  if (theta == 0)
    return;
  QnInitialMotion *start = qn_model_add_initial_motion (&c->model);
  start->block = 1; /* about the lower left corner */
  start->displacement[QN_DOF_RZ] = theta;
  start->displacement[QN_DOF_UX] =
    0.5 * (width * cos (theta) - HEIGHT * sin (theta) - width);
  start->displacement[QN_DOF_UY] =
    0.5 * (width * sin (theta) + HEIGHT * cos (theta) - HEIGHT);
}

static void
init_rocking (TestRun *c, double theta)
{
  init_rocking_of (c, WIDTH, theta);
}

static void
test_rock (void)
{
  double theta = 0.5 * atan (WIDTH / HEIGHT), exact = quarter_period (theta), found = 0;
  g_auto (TestRun) c;
  init_rocking (&c, theta);
  c.model.analysis.dynamic.duration = 3;
  c.model.analysis.dynamic.time_step = 0.002;
  c.model.analysis.dynamic.joint_damping = 1e-4;
  test_run_solve (&c);
  const QnHistory *h = &c.result.history;
  for (size_t i = 1; i < h->row_count && found == 0; i++) {
    double a = tracked (&c, i - 1, 0), b = tracked (&c, i, 0);
    if (b <= 0)
      found = h->rows[(i - 1) * h->width] + 0.002 * a / (a - b);
  }
  g_test_message ("impact at %.5f s of %.5f s; energy error %.1e", found, exact,
                  h->energy_error);
  g_assert_cmpfloat (fabs (exact - 0.3467), <, 1e-3); /* Housner's, linearised */
  g_assert_cmpfloat (fabs (found / exact - 1), <, 0.01);
  g_assert_cmpfloat (h->energy_error, <, 1e-3);
  g_assert_cmpfloat (h->largest_slip, <, 0.05);
  g_assert_cmpfloat (h->peak_time, ==, 0); /* it comes back to less each time */
}

/* Damping by impact leaves what Housner's impact does, whatever the slenderness and the stiffness: the
 * energy at the next standstill over that of the first. */
static void
test_impact (void)
{
  static const double widths[] = { 0.1, 0.15, 0.2, 0.3, 0.35, 0.4, 0.5 },
                      stiffness[] = { 1e7, 1e8, 1e10 };
  for (gsize i = 0; i < G_N_ELEMENTS (widths); i++)
    for (gsize k = 0; k < G_N_ELEMENTS (stiffness); k++) {
      g_auto (TestRun) c;
      double alpha = atan (widths[i] / HEIGHT), theta = 0.5 * alpha, back = 0;
      double kept = pow (1 - 1.5 * pow (sin (alpha), 2), 2);
      init_rocking_of (&c, widths[i], theta);
      c.model.laws[0].kn = c.model.laws[0].ks = stiffness[k];
      c.model.laws[0].friction = 3;
      c.model.analysis.dynamic.duration = 0.9;
      c.model.analysis.dynamic.time_step = 0.002;
      c.model.analysis.dynamic.of = QN_DAMPING_IMPACT;
      test_run_solve (&c);
      const QnHistory *h = &c.result.history;
      for (size_t row = 0; row < h->row_count; row++)
        back = fmax (back, -tracked (&c, row, 0));
      double found =
        (cos (alpha - back) - cos (alpha)) / (cos (alpha - theta) - cos (alpha));
      g_test_message ("width %g, %g N/m: %.4f of %.4f", widths[i], stiffness[k], found,
                      kept);
      g_assert_cmpfloat (fabs (found / kept - 1), <, 0.02);
      g_assert_cmpfloat (h->energy_error, <, 1e-3);
    }
}

/* Beside a wall as high as it the block nearly stops: the impulses of ground and wall that bring it to rest all
 * push, so impacts without rebound leave nothing. */
static void
test_impact_beside_wall (void)
{
  for (double width = 0.1; width < 0.6; width += 0.2) {
    g_auto (TestRun) c;
    double alpha = atan (width / HEIGHT), theta = 0.5 * alpha, back = 0;
    init_rocking_of (&c, width, theta);
    c.model.laws[0].friction = 3;
    QnBlock *wall =
      test_model_add_rectangle (&c.model, "wall", width / 2, 0, width, HEIGHT);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      wall->support[dof] = true;
    c.model.analysis.dynamic.duration = 0.6;
    c.model.analysis.dynamic.time_step = 0.002;
    c.model.analysis.dynamic.tolerance = 1e-7;
    c.model.analysis.dynamic.of = QN_DAMPING_IMPACT;
    test_run_solve (&c);
    gboolean landed = FALSE;
    for (size_t row = 0; row < c.result.history.row_count; row++) {
      landed = landed || tracked (&c, row, 0) < 0.005 * alpha;
      back = fmax (back, landed ? tracked (&c, row, 0) : 0);
    }
    double speed =
      sqrt ((cos (alpha - back) - cos (alpha)) / (cos (alpha - theta) - cos (alpha)));
    g_test_message ("width %g beside a wall: %.3f of its speed", width, speed);
    g_assert_true (landed);
    g_assert_cmpfloat (speed, <, 0.15);
  }
}

/* Let go just beyond its balance it falls; and at once where it hangs over by far. */
static void
test_overturn (void)
{
  g_auto (TestRun) c;
  init_rocking (&c, 1.02 * atan (WIDTH / HEIGHT));
  c.model.analysis.dynamic.duration = 10;
  c.model.analysis.dynamic.time_step = 0.01;
  test_run_solve (&c);
  const QnHistory *h = &c.result.history;
  g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (h->collapse_time, >, 0.5);
  g_assert_cmpfloat (h->collapse_time, <, 3);
  g_assert_cmpfloat (h->collapse_time, ==, h->end);
  g_assert_cmpfloat (h->peak_time, ==, h->end);
  g_assert_cmpfloat (h->energy_error, <, 1e-3);
  g_assert_nonnull (c.result.mechanism);
  g_assert_cmpint (c.result.steps[c.result.step_count - 1].event, ==, QN_EVENT_COLLAPSE);
}

/* --- Beams --------------------------------------------------------------------------------- */

/* A cantilever that is let go vibrates at its lowest frequency, and keeps its energy or, with `ratio` of the
 * critical damping, goes less beyond its rest. */
static void
check_beam (double ratio)
{
  g_auto (TestRun) c = { 0 };
  test_model_init (&c.model);
  QnSection *section = qn_model_add_section (&c.model, "s");
  section->young = 1e10;
  section->poisson = 0.2;
  section->area = 0.04;
  section->inertia = 0.04 * 0.04 / 12;
  section->unit_weight = 20000;
  const QnId fixed = test_model_add_node (&c.model, "a", 0, 0, "xyr");
  const QnId end = test_model_add_node (&c.model, "b", 4, 0, "");
  QnBeam *beam = qn_model_add_beam (&c.model, "beam");
  beam->kind = QN_BEAM_EULER_BERNOULLI;
  beam->nodes[0] = fixed;
  beam->nodes[1] = end;
  beam->section = 0;
  beam->element_count = 8;
  c.model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
  c.model.analysis.dynamic.duration = 0.2;
  c.model.analysis.dynamic.time_step = 0.0005;
  c.model.analysis.dynamic.adaptive = FALSE;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (0, 1);
  motion->pulse = (QnPulse){ QN_PULSE_RECTANGLE, 1, 10, 0 };
  /* Under a constant acceleration it swings about its deflection m g l^4/(8 EI) and comes back. */
  double mass = 20000 * 0.04 / G, bending = section->young * section->inertia;
  double omega = 3.516015 / 16 * sqrt (bending / mass), slower = sqrt (1 - ratio * ratio);
  c.model.analysis.dynamic.joint_damping = 2 * ratio / omega;
  test_run_solve (&c);

  double still = -mass * 256 / (8 * bending), lowest = 0, when = 0;
  for (size_t i = 0; i < c.result.step_count; i++) {
    double uy = qn_result_step_displacements (&c.result, i)[3 * end + QN_DOF_UY];
    if (uy < lowest) {
      lowest = uy;
      when = c.result.steps[i].time;
    }
  }
  double peak = still * (1 + exp (-G_PI * ratio / slower)),
         half = G_PI / (omega * slower);
  g_test_message ("lowest %.4g of %.4g m at %.4f of %.4f s", lowest, peak, when, half);
  g_assert_cmpfloat (fabs (lowest / peak - 1), <, 0.05);
  g_assert_cmpfloat (fabs (when / half - 1), <, 0.05);
  g_assert_cmpfloat (c.result.history.energy_error, <, 1e-9);
}

static void
test_beam (void)
{
  check_beam (0);
  check_beam (0.2);
}

/* A block hangs on a tie, and the ground is lifted: it swings about its new elongation m (g + a) L / EA
 * and keeps its energy. Let go again it flies until the tie catches it; the energy adds up then too. */
static void
test_tie (void)
{
  for (int flies = 0; flies < 2; flies++) {
    g_auto (TestRun) c = { 0 };
    test_model_init (&c.model);
    test_model_add_rectangle (&c.model, "block", -0.5, 0, 1, 1);
    QnTie *tie = qn_model_add_tie (&c.model, "tie");
    tie->ends[0] = (QnTieEnd){ 0, qn_vec2 (0, 1) };
    tie->ends[1] = (QnTieEnd){ QN_NONE, qn_vec2 (0, 3) };
    tie->area = 1e-4;
    tie->elasticity = 2e11;
    QnLoad *dead = qn_model_add_dead_load (&c.model);
    dead->kind = QN_LOAD_WEIGHT;
    dead->vector = qn_vec2 (0, -1);
    c.model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
    c.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    c.model.analysis.dynamic.duration = flies ? 1 : 0.2;
    c.model.analysis.dynamic.time_step = 0.0005;
    c.model.analysis.dynamic.adaptive = flies;
    QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
    motion->kind = QN_SIGNAL_PULSE;
    motion->direction = qn_vec2 (0, flies ? -1 : 1);
    motion->pulse = (QnPulse){ QN_PULSE_RECTANGLE, flies ? 20 : 1, flies ? 0.05 : 10, 0 };
    test_run_solve (&c);
    g_assert_cmpint (test_run_count_faults (&c), ==, 0);
    double mass = c.model.blocks[0].weight / G, k = qn_tie_stiffness (tie), most = 0;
    bool slack = false;
    for (size_t i = 0; i < c.result.step_count; i++) {
      most = fmax (most, c.result.ties[i].elongation);
      slack |= c.result.ties[i].state == QN_TIE_SLACK;
    }
    g_test_message ("most %.6g mm, slack %d, energy error %.1e", 1e3 * most, slack,
                    c.result.history.energy_error);
    g_assert_true (slack == flies);
    if (!flies)
      g_assert_cmpfloat_with_epsilon (most, mass * (G + 2) / k, 2e-3 * mass * G / k);
    g_assert_cmpfloat (c.result.history.energy_error, <, flies ? 1e-4 : 1e-9);
  }
}

/* --- What ends it, and what is refused ------------------------------------------------------ */

static bool
stop_after (const QnProgress *progress, void *user_data)
{
  return progress->iterations < *(int *) user_data;
}

/* A cancelled analysis keeps what it has, which is the beginning of the whole one. */
static void
test_cancel (void)
{
  g_auto (TestRun) whole, part;
  QnDiag diag;
  int budget = 300;
  init_rocking (&whole, 0.05);
  init_rocking (&part, 0.05);
  whole.model.analysis.dynamic.duration = part.model.analysis.dynamic.duration = 1;
  whole.model.analysis.dynamic.time_step = part.model.analysis.dynamic.time_step = 0.01;
  test_run_solve (&whole);
  g_assert_cmpint (qn_model_prepare (&part.model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&part.model, &part.contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&part.model, &part.contacts, stop_after, &budget,
                                    &part.result, &diag),
                   ==, QN_OK);
  g_assert_cmpint (part.result.outcome, ==, QN_OUTCOME_CANCELLED);
  const QnHistory *a = &whole.result.history, *b = &part.result.history;
  g_assert_cmpuint (b->row_count, >, 1);
  g_assert_cmpuint (b->row_count, <, a->row_count);
  g_assert_cmpmem (a->rows, b->row_count * b->width * sizeof (double), b->rows,
                   b->row_count * b->width * sizeof (double));
}

static QnProblem
refusal (TestRun *c)
{
  QnDiag diag = { 0 };
  QnStatus status = qn_model_prepare (&c->model, &diag);
  if (status == QN_OK)
    status = qn_contacts_detect (&c->model, &c->contacts, &diag);
  if (status == QN_OK)
    status = qn_analysis_run (&c->model, &c->contacts, NULL, NULL, &c->result, &diag);
  g_assert_cmpint (status, ==, QN_ERROR_INVALID);
  test_run_clear (c);
  return diag.problem;
}

static void
init_refused (TestRun *c)
{
  init_case (c, 1, 1);
  c->model.analysis.dynamic.duration = 1;
  c->model.analysis.dynamic.time_step = 0.01;
}

static void
test_refuse (void)
{
  TestRun c;
  init_refused (&c);
  c.model.blocks[1].unit_weight = 0;
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_BLOCK_WITHOUT_MASS);

  init_refused (&c);
  c.model.analysis.dynamic.duration = 0;
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_NOT_POSITIVE);

  init_refused (&c);
  c.model.analysis.dynamic.rho = 1.5;
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_RADIUS_RANGE);

  init_refused (&c);
  c.model.analysis.dynamic.time_step = 1e-12;
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_TOO_MANY_TIME_STEPS);

  init_refused (&c);
  qn_model_add_ground_motion (&c.model)->direction = qn_vec2 (1, 0);
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_SIGNAL_EMPTY);

  init_refused (&c);
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->direction = qn_vec2 (1, 0);
  qn_ground_motion_add_point (motion, 0, 0);
  qn_ground_motion_add_point (motion, 1, 1);
  qn_ground_motion_add_point (motion, 1, 2);
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_SIGNAL_ORDER);

  init_refused (&c);
  motion = qn_model_add_ground_motion (&c.model);
  motion->direction = qn_vec2 (1, 0);
  qn_ground_motion_add_point (motion, 0, 0);
  qn_ground_motion_add_point (motion, 1, NAN);
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_NOT_FINITE);

  init_refused (&c);
  motion = qn_model_add_ground_motion (&c.model);
  motion->direction = qn_vec2 (1, 0);
  qn_ground_motion_add_point (motion, 0, 1e300);
  qn_ground_motion_add_point (motion, 1, 1e300);
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_TOO_LARGE);

  init_refused (&c);
  motion = qn_model_add_ground_motion (&c.model);
  motion->record = qn_strdup ("missing.csv"); /* never read */
  motion->kind = QN_SIGNAL_RECORD;
  motion->direction = qn_vec2 (1, 0);
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_SIGNAL_EMPTY);

  init_refused (&c);
  QnInitialMotion *start = qn_model_add_initial_motion (&c.model);
  start->block = 0;
  start->velocity[0] = 1;
  g_assert_cmpint (refusal (&c), ==, QN_PROBLEM_INITIAL_FIXED);
}

/* A step that arithmetic cannot serve has not converged, and nothing of it is kept. */
static void
test_not_finite (void)
{
  g_auto (TestRun) c;
  init_case (&c, 1, 1);
  add_weight (&c);
  c.model.analysis.dynamic.duration = 1e-300;
  c.model.analysis.dynamic.time_step = 0.005;
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->kind = QN_SIGNAL_POINTS;
  motion->direction = qn_vec2 (1, 0);
  g_assert_true (qn_ground_motion_add_point (motion, 0, 1));
  g_assert_true (qn_ground_motion_add_point (motion, 10, 1));
  test_run_solve (&c);
  g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_NOT_CONVERGED);
  g_assert_cmpint (c.result.stop, !=, QN_STOP_CHECK);
  for (size_t step = 0; step < c.result.step_count; step++)
    for (size_t k = 0; k < 2 * QN_DOF_COUNT; k++)
      g_assert_true (isfinite (qn_result_step_displacements (&c.result, step)[k]));
}

QN_TESTS
{
  g_test_add_func ("/dynamics/relieved-bond", test_relieved_bond);
  g_test_add_func ("/dynamics/not-finite", test_not_finite);
  g_test_add_func ("/dynamics/joints", test_joints);
  g_test_add_func ("/dynamics/spring", test_spring);
  g_test_add_func ("/dynamics/slide-rectangle", test_slide_rectangle);
  g_test_add_func ("/dynamics/settled-base", test_settled_base);
  g_test_add_func ("/dynamics/slide-sine", test_slide_sine);
  g_test_add_func ("/dynamics/rising-ground", test_rising_ground);
  g_test_add_func ("/dynamics/factorizations", test_factorizations);
  g_test_add_func ("/dynamics/rock", test_rock);
  g_test_add_func ("/dynamics/impact", test_impact);
  g_test_add_func ("/dynamics/impact-beside-wall", test_impact_beside_wall);
  g_test_add_func ("/dynamics/overturn", test_overturn);
  g_test_add_func ("/dynamics/beam", test_beam);
  g_test_add_func ("/dynamics/tie", test_tie);
  g_test_add_func ("/dynamics/cancel", test_cancel);
  g_test_add_func ("/dynamics/refuse", test_refuse);
}
