#include "core/solver.h"
#include "support/room.h"

#include <math.h>

static void
init_block (Solver *solver, double width, double height)
{
  QnModel model;
  test_model_init_block_on_plane (&model, width, height);
  test_model_add_weight_loads (&model, 1);
  solver_init (solver, &model);
}

/* Above the sliding multiplier the block slides: the velocity is along the plane. */
static void
test_sliding_mechanism (void)
{
  Solver solver;
  init_block (&solver, 2, 0.5);
  QnEquilibrium *eq = &solver.equilibrium;

  g_assert_cmpint (relax (eq, 0.66), ==, QN_SOLVE_MECHANISM);
  g_assert_cmpfloat (eq->motion[0], >, 0);
  g_assert_cmpfloat (fabs (eq->motion[1]), <, 1e-6 * eq->motion[0]);
  g_assert_cmpfloat (fabs (eq->motion[2]), <, 1e-6 * eq->motion[0]);
  solver_clear (&solver);
}

/* A slender block overturns about its lower right corner. */
static void
test_overturning_mechanism (void)
{
  Solver solver;
  init_block (&solver, 0.4, 1);
  QnEquilibrium *eq = &solver.equilibrium;

  g_assert_cmpint (relax (eq, 0.41), ==, QN_SOLVE_MECHANISM);
  double turning = eq->motion[2] / eq->assembly.length;
  g_assert_cmpfloat (turning, <, 0);
  /* v = w x r about the corner at (0.2, 0); the centroid is at (0, 0.5) */
  g_assert_cmpfloat_with_epsilon (eq->motion[0], -turning * 0.5, 1e-3 * fabs (turning));
  g_assert_cmpfloat_with_epsilon (eq->motion[1], -turning * 0.2, 1e-3 * fabs (turning));
  solver_clear (&solver);
}

/* Where there is an equilibrium, relaxation finds the same one as Newton. */
static void
test_settles (void)
{
  Solver solver;
  init_block (&solver, 2, 0.5);
  QnEquilibrium *eq = &solver.equilibrium;
  double settled[3];

  g_assert_cmpint (relax (eq, 0.5), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpfloat (eq->out_of_balance, <=, eq->tolerance);
  for (int i = 0; i < 3; i++)
    settled[i] = eq->u[i];
  qn_equilibrium_restore (eq);
  g_assert_cmpint (newton (eq, 0.5), ==, QN_SOLVE_CONVERGED);
  for (int i = 0; i < 3; i++)
    g_assert_cmpfloat (fabs (settled[i] - eq->u[i]), <, 1e-7 * fabs (eq->u[0]));
  solver_clear (&solver);
}

/* Joints a hundred million times softer than others give way at a velocity that hardly changes,
 * and hold all the same: the wall does not fall under its weight. */
static void
test_soft_joints_hold (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 1, 0.65);
  test_model_soften_every_other_block (&model, 1e8);
  solver_init (&solver, &model);

  g_assert_cmpint (relax (&solver.equilibrium, 0), !=, QN_SOLVE_MECHANISM);
  solver_clear (&solver);
}

/* Going back to a saved state is exact, tangent included. */
static void
test_restore (void)
{
  Solver solver;
  init_block (&solver, 2, 0.5);
  QnEquilibrium *eq = &solver.equilibrium;

  g_assert_cmpint (newton (eq, 0.3), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  double u[3] = { eq->u[0], eq->u[1], eq->u[2] };
  QnPairResponse response = eq->assembly.responses[0];
  g_assert_cmpint (relax (eq, 0.7), ==, QN_SOLVE_MECHANISM);
  qn_equilibrium_restore (eq);
  g_assert_cmpmem (u, sizeof u, eq->u, sizeof u);
  g_assert_cmpmem (&response.force, sizeof response.force,
                   &eq->assembly.responses[0].force, sizeof response.force);
  g_assert_cmpint (response.state, ==, eq->assembly.responses[0].state);
  g_assert_cmpfloat (eq->committed.multiplier, ==, 0.3);
  solver_clear (&solver);
}

QN_TESTS
{
  g_test_add_func ("/relax/sliding", test_sliding_mechanism);
  g_test_add_func ("/relax/overturning", test_overturning_mechanism);
  g_test_add_func ("/relax/settles", test_settles);
  g_test_add_func ("/relax/soft-joints-hold", test_soft_joints_hold);
  g_test_add_func ("/relax/restore", test_restore);
}
