#include "core/solver.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

/* While no pair changes its branch the problem is linear: one iteration, and none the second time. */
static void
test_linear_problem_takes_one_iteration (void)
{
  QnModel model;
  Solver solver;
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;

  g_assert_cmpint (newton (eq, 0.1), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpint (eq->statistics.iterations, ==, 1);
  g_assert_cmpfloat (eq->out_of_balance, <, 1e-12);
  g_assert_cmpint (newton (eq, 0.1), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpint (eq->statistics.iterations, ==, 1);

  /* Another load on the same tangent needs no second factorisation. */
  g_assert_cmpint (newton (eq, 0.2), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpint (eq->statistics.iterations, ==, 2);
  g_assert_cmpint (eq->statistics.factorizations, ==, 1);
  solver_clear (&solver);
}

/* There is no equilibrium above the sliding multiplier, and Newton says so. */
static void
test_no_equilibrium_fails (void)
{
  QnModel model;
  Solver solver;
  test_model_init_block_on_plane (&model, 1, 0.5);
  test_model_add_weight_loads (&model, 1);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;

  g_assert_cmpint (newton (eq, 0.7), ==, QN_SOLVE_FAILED);
  qn_equilibrium_restore (eq);
  g_assert_cmpint (newton (eq, 0.6), ==, QN_SOLVE_CONVERGED);
  solver_clear (&solver);
}

/* The top of a stack of n blocks sinks by n (n + 1) / 2 times what one block shortens one joint: short
 * ones have run away by the standards of a joint, tall ones by their own, the tallest as far as there
 * are digits. */
static void
test_runaway (void)
{
  const int counts[] = { 10, 100, 1000 };
  for (size_t i = 0; i < G_N_ELEMENTS (counts); i++) {
    QnModel model;
    Solver solver;
    test_model_init_stack (&model, counts[i], 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    solver_init (&solver, &model);
    QnEquilibrium *eq = &solver.equilibrium;
    double n = counts[i];
    double pairs =
      (double) solver.contacts.pair_count / (double) solver.contacts.face_count;
    double mean_weight = (n + 3) / (n + 1); /* the base is as long as three blocks */
    double whole = 300 * n * (n + 1) / (2 * pairs * mean_weight);

    g_assert_cmpfloat (eq->runaway, ==, QN_RUNAWAY);
    g_assert_true (qn_equilibrium_set_runaway (eq));
    g_assert_cmpfloat (fabs (eq->runaway / CLAMP (whole, QN_RUNAWAY, QN_FARTHEST) - 1), <,
                       1e-9);
    g_assert_true ((whole < QN_RUNAWAY) == (i == 0) && (whole > QN_FARTHEST) == (i == 2));
    solver_clear (&solver);
  }
}

/* A support that settles by a metre carries the blocks along: nothing deforms. */
static void
test_runaway_without_settlement (void)
{
  double runaway[2];
  for (int settles = 0; settles < 2; settles++) {
    QnModel model;
    Solver solver;
    test_model_init_stack (&model, 100, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    if (settles == 1) {
      QnLoad *load = qn_model_add_dead_load (&model);
      load->kind = QN_LOAD_SETTLEMENT;
      load->block = 0;
      load->dof = QN_DOF_UY;
      load->value = -1;
    }
    solver_init (&solver, &model);
    g_assert_true (qn_equilibrium_set_runaway (&solver.equilibrium));
    runaway[settles] = solver.equilibrium.runaway;
    solver_clear (&solver);
  }
  g_assert_cmpfloat (runaway[0], >, QN_RUNAWAY);
  g_assert_cmpfloat (fabs (runaway[1] / runaway[0] - 1), <, 1e-9);
}

/* A chain of elastic blocks in large displacements under an eccentric load that grows. */
static void
make_chain (QnModel *model)
{
  test_model_init_stack (model, 4, 0.4, 0.5);
  test_model_add_weight_loads (model, 0.3);
  model->laws[0].kind = QN_LAW_ELASTIC;
  model->laws[0].kn = model->laws[0].ks = 1e6;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 4;
  load->vector = qn_vec2 (300, -200);
  load->has_at = true;
  load->at = qn_vec2 (0.2, 2);
}

/* The state where a measure has advanced so far. */
static void
advance (QnEquilibrium *eq, const double *direction, double advance)
{
  const QnTarget target = { .direction = direction, .advance = advance };

  qn_equilibrium_restore (eq);
  g_assert_cmpint (qn_equilibrium_newton (eq, &target, 0, 50), ==, QN_SOLVE_CONVERGED);
}

/* How displacements and multiplier follow a measure, by the bordered tangent and by differences:
 * a measure of all displacements. */
static void
test_tangent_of_a_measure (void)
{
  enum { UNKNOWNS = 12 };
  const double way = 0.3, h = 1e-5;
  QnModel model;
  Solver solver;
  make_chain (&model);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  eq->tolerance = 1e-12;
  g_assert_cmpint (eq->assembly.unknown_count, ==, UNKNOWNS);
  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);

  double direction[UNKNOWNS], slope[UNKNOWNS], rate[UNKNOWNS], fastest = 0;
  double along = 0;
  for (int i = 0; i < UNKNOWNS; i++)
    direction[i] = i % 3 == 1 ? 0.2 : 1;

  advance (eq, direction, way - h);
  double multiplier = eq->multiplier;
  memcpy (slope, eq->u, sizeof slope);
  advance (eq, direction, way + h);
  double multiplier_slope = (eq->multiplier - multiplier) / (2 * h);
  for (int i = 0; i < UNKNOWNS; i++)
    slope[i] = (eq->u[i] - slope[i]) / (2 * h);

  advance (eq, direction, way);
  g_assert_cmpint (qn_equilibrium_rate (eq, rate), ==, QN_SOLVE_CONVERGED);
  for (int i = 0; i < UNKNOWNS; i++) {
    along += direction[i] * rate[i];
    fastest = fmax (fastest, fabs (rate[i]));
  }
  g_test_message ("multiplier %.4f, slope %.8f, by differences %.8f", eq->multiplier,
                  1 / along, multiplier_slope);
  g_assert_cmpfloat_with_epsilon (multiplier_slope * along, 1, 1e-6);
  for (int i = 0; i < UNKNOWNS; i++)
    g_assert_cmpfloat_with_epsilon (slope[i] * along / fastest, rate[i] / fastest, 1e-6);
  solver_clear (&solver);
}

static bool
refuse (const QnProgress *progress, void *data)
{
  int *left = data;
  g_assert_cmpint (progress->iterations, >, 0);
  return (*left)-- > 0;
}

static void
test_cancel (void)
{
  QnModel model;
  Solver solver;
  int left = 1;
  test_model_init_wall (&model, 1, 0);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  eq->report = refuse;
  eq->report_data = &left;

  g_assert_cmpint (newton (eq, 0.3), ==, QN_SOLVE_CANCELLED);
  g_assert_cmpint (eq->statistics.iterations, ==, 2);
  solver_clear (&solver);
}

QN_TESTS
{
  g_test_add_func ("/newton/linear-problem", test_linear_problem_takes_one_iteration);
  g_test_add_func ("/newton/no-equilibrium", test_no_equilibrium_fails);
  g_test_add_func ("/newton/tangent-of-a-measure", test_tangent_of_a_measure);
  g_test_add_func ("/newton/cancel", test_cancel);
  g_test_add_func ("/newton/runaway", test_runaway);
  g_test_add_func ("/newton/runaway-without-settlement", test_runaway_without_settlement);
}
