/* The engine on programs whose answers are known by hand, bodies being single rows here. */
#include "core/limit/collapse.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Two rows (forces along x and y on a point) and one cell whose normal acts along y and whose
 * shear acts along x; the point weighs 1 and is pushed sideways by lambda. */
typedef struct Slider {
  QnIpGroup group;
  QnIpCell cell;
  QnIpBound bounds[3];
  double constant[2], load[2];
  QnIpProblem problem;
} Slider;

static void
slider_init (Slider *slider, double friction, double cohesion)
{
  *slider = (Slider){
    .group = { .rows = { 0, 1, -1, -1, -1, -1 }, .cell_count = 1 },
    .cell = { .map = { { 0, 1 }, { -1, 0 } }, .bound_count = 2 },
    .bounds = { { friction, 1, cohesion, friction },
                { friction, -1, cohesion, friction } },
    .constant = { 0, -1 },
    .load = { 1, 0 },
  };
  slider->problem = (QnIpProblem){
    .row_count = 2,
    .group_count = 1,
    .cell_count = 1,
    .bound_count = 2,
    .groups = &slider->group,
    .cells = &slider->cell,
    .bounds = slider->bounds,
    .constant = slider->constant,
    .load = slider->load,
    .load_gain = 1,
  };
}

static QnOutcome
follow (QnCollapse *engine)
{
  qn_collapse_start (engine, NULL, 0, 1, 1);
  return qn_collapse_follow (engine, 1e-9, 100, NULL, NULL);
}

static QnOutcome
solve (QnCollapse *engine, const QnIpProblem *problem)
{
  g_assert_cmpint (qn_collapse_init (engine, problem, NULL), ==, QN_OK);
  return follow (engine);
}

static void
test_optimum (void)
{
  Slider slider;
  QnCollapse engine;

  slider_init (&slider, 0.65, 0.1);
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.lambda, 0.75, 1e-8);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[0], -1, 1e-8);
  g_assert_cmpfloat_with_epsilon (fabs (engine.ip.at.y[1]), 0.75, 1e-8);
  /* The mechanism slides and, flow being associative, lifts by the friction. */
  g_assert_cmpfloat_with_epsilon (engine.ip.at.v[0], 1, 1e-7);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.v[1], 0.65, 1e-7);
  g_assert_cmpfloat (engine.ip.power, <, 1e-9);
  qn_collapse_clear (&engine);
}

/* Pulled upwards by twice its weight, a block without tension lifts off: no forces carry it. */
static void
test_infeasible (void)
{
  Slider slider;
  QnCollapse engine;
  double rates[2];

  slider_init (&slider, 0.65, 0);
  slider.constant[1] = 2;
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  double power = slider.constant[1] * engine.ip.at.v[1];
  g_assert_cmpfloat (power, >, 0);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.v[0] / engine.ip.at.v[1], 0, 1e-6);
  rates[0] = rates[1] = 0;
  qn_ip_add_rates (&slider.problem, engine.ip.at.v, -1, rates);
  g_assert_cmpfloat (rates[0], >, 0.65 * fabs (rates[1]));
  qn_collapse_clear (&engine);
}

static void
test_unbounded (void)
{
  Slider slider;
  QnCollapse engine;

  slider_init (&slider, 0.65, 0);
  slider.load[0] = 0.6;
  slider.load[1] = -1;
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_UNBOUNDED);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[0] / engine.ip.at.lambda, -1, 1e-6);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[1] / engine.ip.at.lambda, -0.6, 1e-6);
  qn_collapse_clear (&engine);
}

/* A cell without bounds carries whatever it must. */
static void
test_no_bounds (void)
{
  Slider slider;
  QnCollapse engine;

  slider_init (&slider, 0.65, 0);
  slider.cell.bound_count = 0;
  slider.problem.bound_count = 0;
  slider.problem.load = NULL;
  slider.problem.load_gain = 0;
  slider.constant[0] = 3;
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[0], -1, 1e-7);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[1], -3, 1e-7);
  qn_collapse_clear (&engine);
}

/* Two equal cells side by side share a weight as their compliances ask, which is what the
 * quadratic term is for: 1/2 (y1^2/k1 + y2^2/k2) is least for y1 : y2 = k1 : k2. */
static void
test_quadratic (void)
{
  const double k1 = 3, k2 = 1;
  QnIpGroup group = { .rows = { 0, -1, -1, -1, -1, -1 }, .cell_count = 2 };
  QnIpCell cells[2] = {
    { .map = { { -1, 0 } },
      .quadratic = { 1 / k1, 0 },
      .bound_count = 1,
      .no_shear = true },
    { .map = { { -1, 0 } },
      .quadratic = { 1 / k2, 0 },
      .first_bound = 1,
      .bound_count = 1,
      .no_shear = true },
  };
  QnIpBound bounds[2] = { { 1, 0, 0, 1 }, { 1, 0, 0, 1 } };
  double constant = -1;
  QnIpProblem problem = { .row_count = 1,
                          .group_count = 1,
                          .cell_count = 2,
                          .bound_count = 2,
                          .groups = &group,
                          .cells = cells,
                          .bounds = bounds,
                          .constant = &constant };
  QnCollapse engine;

  g_assert_cmpint (solve (&engine, &problem), ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[0], -0.75, 1e-6);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.y[2], -0.25, 1e-6);
  qn_collapse_clear (&engine);
}

/* A row that no cell acts on, and a row that repeats another: both harmless while their loads
 * fit, the first a reason of infeasibility where it is loaded. */
static void
test_empty_row (void)
{
  Slider slider;
  QnCollapse engine;
  double constant[3] = { 0, -1, 0 }, load[3] = { 1, 0, 0 };

  slider_init (&slider, 0.65, 0);
  slider.problem.row_count = 3;
  slider.problem.constant = constant;
  slider.problem.load = load;
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.lambda, 0.65, 1e-8);
  constant[2] = 0.1;
  g_assert_cmpint (follow (&engine), ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  g_assert_cmpfloat (engine.ip.at.v[2] * constant[2], >, 0);
  qn_collapse_clear (&engine);
}

static void
test_redundant_row (void)
{
  Slider slider;
  QnCollapse engine;
  double constant[3] = { 0, -1, -1 }, load[3] = { 1, 0, 0 };

  slider_init (&slider, 0.65, 0);
  slider.group.rows[2] = 2;
  slider.cell.map[2][0] = -1;
  slider.problem.row_count = 3;
  slider.problem.constant = constant;
  slider.problem.load = load;
  g_assert_cmpint (solve (&engine, &slider.problem), ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (engine.ip.at.lambda, 0.65, 1e-8);
  constant[2] = -2;
  g_assert_cmpint (follow (&engine), ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  qn_collapse_clear (&engine);
}

/* The projection keeps equilibrium exactly and tells whether a multiplier can be carried. Its
 * metric is that of the iterate, so it is asked while that is still well inside. */
static void
test_project (void)
{
  Slider slider;
  QnCollapse engine;
  double y[2];
  QnCollapseForces forces = { .y = y, .lambda = 0.5 };

  slider_init (&slider, 0.65, 0);
  g_assert_cmpint (qn_collapse_init (&engine, &slider.problem, NULL), ==, QN_OK);
  qn_collapse_start (&engine, NULL, 0, 1, 1);
  g_assert_cmpint (qn_collapse_follow (&engine, 1e-9, 2, NULL, NULL), ==,
                   QN_OUTCOME_NOT_CONVERGED);
  qn_collapse_project (&engine, true, &forces);
  g_assert_cmpfloat (forces.residual, <, 1e-12);
  g_assert_cmpfloat (forces.lambda, ==, 0.5);
  g_assert_cmpfloat_with_epsilon (forces.slack, 0.15, 1e-9);
  forces.lambda = 0.7;
  qn_collapse_project (&engine, true, &forces);
  g_assert_cmpfloat_with_epsilon (forces.slack, -0.05, 1e-9);
  qn_collapse_clear (&engine);
}

static void
test_repeat (void)
{
  Slider slider;
  QnCollapse a, b;

  slider_init (&slider, 0.65, 0.1);
  solve (&a, &slider.problem);
  solve (&b, &slider.problem);
  g_assert_true (a.ip.at.lambda == b.ip.at.lambda && a.ip.at.v[0] == b.ip.at.v[0]);
  follow (&a);
  g_assert_true (a.ip.at.lambda == b.ip.at.lambda && a.ip.at.v[0] == b.ip.at.v[0]);
  qn_collapse_clear (&a);
  qn_collapse_clear (&b);
}

QN_TESTS
{
  g_test_add_func ("/collapse/optimum", test_optimum);
  g_test_add_func ("/collapse/infeasible", test_infeasible);
  g_test_add_func ("/collapse/unbounded", test_unbounded);
  g_test_add_func ("/collapse/no-bounds", test_no_bounds);
  g_test_add_func ("/collapse/quadratic", test_quadratic);
  g_test_add_func ("/collapse/empty-row", test_empty_row);
  g_test_add_func ("/collapse/redundant-row", test_redundant_row);
  g_test_add_func ("/collapse/project", test_project);
  g_test_add_func ("/collapse/repeat", test_repeat);
}
