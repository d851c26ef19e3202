#include "solver.h"

#include <math.h>

/* While nothing changes phase the problem is linear: one iteration, and none the second time. */
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

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/newton/linear-problem", test_linear_problem_takes_one_iteration);
  g_test_add_func ("/newton/no-equilibrium", test_no_equilibrium_fails);
  g_test_add_func ("/newton/cancel", test_cancel);
  return g_test_run ();
}
