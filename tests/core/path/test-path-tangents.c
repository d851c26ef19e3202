#include "core/path/path-tangents.h"

#include "core/solver.h"

#include <math.h>

typedef struct {
  Solver solver;
  QnPathTangents tangents;
} Fixture;

/* A block on a plane under its weight, and as much to the side times the multiplier. */
static void
set_up (Fixture *f, gconstpointer data G_GNUC_UNUSED)
{
  QnModel model;
  test_model_init_block_on_plane (&model, 2, 0.5);
  test_model_add_weight_loads (&model, 1);
  solver_init (&f->solver, &model);
  QnEquilibrium *eq = &f->solver.equilibrium;

  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  g_assert_true (qn_path_tangents_init (&f->tangents, eq));
  g_assert_true (qn_path_tangents_take_start (&f->tangents));
}

static void
tear_down (Fixture *f, gconstpointer data G_GNUC_UNUSED)
{
  qn_path_tangents_clear (&f->tangents);
  solver_clear (&f->solver);
}

/* Finds the equilibrium at `multiplier` and says what the tangents leave unexplained. */
static double
unexplained_at (Fixture *f, double multiplier)
{
  QnEquilibrium *eq = &f->solver.equilibrium;
  double increment = multiplier - eq->committed.multiplier;

  g_assert_cmpint (newton (eq, multiplier), ==, QN_SOLVE_CONVERGED);
  g_assert_true (qn_path_tangents_take_end (&f->tangents));
  g_assert_true (f->tangents.start_known && f->tangents.end_known);
  return qn_path_tangents_unexplained (&f->tangents, increment);
}

/* As long as no pair changes state the tangents explain everything, from one increment to the
 * next. */
static void
test_elastic (Fixture *f, gconstpointer data G_GNUC_UNUSED)
{
  QnEquilibrium *eq = &f->solver.equilibrium;

  g_assert_cmpfloat (unexplained_at (f, 0.1), <, 1e-9);
  qn_equilibrium_commit (eq);
  qn_path_tangents_accept (&f->tangents);
  g_assert_cmpfloat (unexplained_at (f, 0.2), <, 1e-9);
}

/* Displacements that no load has caused are left, as a part of the largest. */
static void
test_jump (Fixture *f, gconstpointer data G_GNUC_UNUSED)
{
  QnEquilibrium *eq = &f->solver.equilibrium;

  unexplained_at (f, 0.1);
  eq->u[0] += 3 * fabs (eq->u[0]) + 1;
  g_assert_cmpfloat_with_epsilon (qn_path_tangents_unexplained (&f->tangents, 0.1),
                                  1 - 0.1 * f->tangents.start[0] / eq->u[0], 1e-2);
}

/* Once all pairs slide the tangent is singular, and nothing is said. */
static void
test_singular (Fixture *f, gconstpointer data G_GNUC_UNUSED)
{
  QnEquilibrium *eq = &f->solver.equilibrium;

  eq->u[0] += 1;
  g_assert_true (qn_assembly_evaluate (&eq->assembly, eq->u));
  g_assert_true (qn_path_tangents_take_end (&f->tangents));
  g_assert_false (f->tangents.end_known);
  qn_path_tangents_accept (&f->tangents);
  g_assert_false (f->tangents.start_known);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add ("/path-tangents/elastic", Fixture, NULL, set_up, test_elastic, tear_down);
  g_test_add ("/path-tangents/jump", Fixture, NULL, set_up, test_jump, tear_down);
  g_test_add ("/path-tangents/singular", Fixture, NULL, set_up, test_singular, tear_down);
  return g_test_run ();
}
