#include "core/equilibrium/central-path.h"

#include "core/solver.h"
#include "support/room.h"
#include "support/walls.h"

#include <math.h>
#include <string.h>

static QnCentralPath *
new_path (QnEquilibrium *eq)
{
  QnCentralPath *path;
  g_assert_true (qn_central_path_new (eq, false, &path));
  return path;
}

static QnSolveStatus
follow (QnCentralPath *path, double multiplier)
{
  const QnTarget target = qn_target_multiplier (multiplier);
  return qn_central_path_solve (path, &target, 0);
}

/* From the dead load, which Newton's method solves, to a good part of the collapse load at
 * once. Balance and strength are checked with the laws' own forces. */
static void
test_one_increment (gconstpointer data)
{
  int number = GPOINTER_TO_INT (data);
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, number, 0);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);

  g_assert_nonnull (path);
  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  double multiplier = 0.85 * test_walls[number - 1].non_associative;
  g_assert_cmpint (follow (path, multiplier), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpfloat (eq->multiplier, ==, multiplier);
  g_assert_cmpfloat (eq->out_of_balance, <=, eq->tolerance);
  for (size_t p = 0; p < eq->assembly.pair_count; p++) {
    const double *force = eq->assembly.responses[p].force;
    g_assert_cmpfloat (force[0], <=, 1e-6);
    g_assert_cmpfloat (fabs (force[1]), <=, 0.65 * -force[0] + 1e-4);
  }
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* Multiplier of wall 1 in large displacements when its last block has been pushed so far, in so
 * many steps along central paths. */
static double
push_in_large_displacements (double way, int steps)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 1, 0);
  model.laws[0].kn = model.laws[0].ks = 1e8;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);
  g_autofree double *direction = g_new0 (double, (size_t) eq->assembly.unknown_count);
  direction[eq->assembly.unknown_count - QN_DOF_COUNT + QN_DOF_UX] = 1;

  g_assert_nonnull (path);
  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  for (int i = 0; i < steps; i++) {
    const QnTarget target = { .direction = direction, .advance = way / steps };
    g_assert_cmpint (qn_central_path_solve (path, &target, 0), ==, QN_SOLVE_CONVERGED);
    g_assert_cmpfloat (eq->out_of_balance, <=, eq->tolerance);
    qn_equilibrium_commit (eq);
  }
  double multiplier = eq->multiplier;
  g_test_message ("%d steps: %.6f, %d factorisations", steps, multiplier,
                  eq->statistics.factorizations);
  qn_central_path_free (path);
  solver_clear (&solver);
  return multiplier;
}

/* Past the peak of 0.64, where the multiplier falls as the wall leans, in one step as in
 * twenty: by 1.5 per m of displacement, or by nothing in linear geometry. */
static void
test_large_displacements (void)
{
  double at_once = push_in_large_displacements (0.05, 1);

  g_assert_cmpfloat_with_epsilon (at_once, 0.64 - 1.5 * 0.05, 0.02);
  g_assert_cmpfloat_with_epsilon (push_in_large_displacements (0.05, 20), at_once, 0.005);
}

/* As long as few joints change state, both methods find the same displacements. */
static void
test_agrees_with_newton (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 1, 0.65);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  size_t n = (size_t) eq->assembly.unknown_count;
  double *u = g_new (double, n), size = 0;
  QnCentralPath *path = new_path (eq);

  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  g_assert_cmpint (newton (eq, 0.1), ==, QN_SOLVE_CONVERGED);
  memcpy (u, eq->u, n * sizeof *u);
  g_assert_cmpint (follow (path, 0.1), ==, QN_SOLVE_CONVERGED);
  for (size_t i = 0; i < n; i++)
    size = fmax (size, fabs (u[i]));
  for (size_t i = 0; i < n; i++)
    g_assert_cmpfloat (fabs (eq->u[i] - u[i]), <, 1e-6 * size);
  g_free (u);
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* Prescribed work on a block that slides at once: the multiplier is the friction coefficient,
 * whatever the way. */
static void
test_work (void)
{
  QnModel model;
  Solver solver;
  test_model_init_block_on_plane (&model, 2, 0.5);
  test_model_add_weight_loads (&model, 1);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);

  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  for (double way = 1; way < 2e4; way *= 100) {
    const QnTarget target = { .direction = eq->assembly.live,
                              .advance = way * eq->assembly.force_scale };
    g_assert_cmpint (qn_central_path_solve (path, &target, 0), ==, QN_SOLVE_CONVERGED);
    g_assert_cmpfloat (fabs (eq->multiplier - 0.65), <, 1e-7);
    g_assert_cmpfloat (fabs (eq->u[0] - way), <, 1e-3 * way);
  }
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* Ten times the live load's work at once, near collapse of a bonded wall of 119 blocks. The path goes
 * on smoothly, but an iteration that aims at balance at once leaves it and gets stuck. */
static void
test_stays_on_the_path (void)
{
  QnModel model;
  Solver solver;
  test_bond_init (&model, TEST_UNIT, 7, 16, 0, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);
  int32_t n = eq->assembly.unknown_count;
  double *start = g_new (double, (size_t) n), work = 0;

  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  memcpy (start, eq->u, (size_t) n * sizeof *start);
  g_assert_cmpint (follow (path, 0.45), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  for (int32_t i = 0; i < n; i++)
    work += eq->assembly.live[i] * (eq->u[i] - start[i]);
  const QnTarget target = { .direction = eq->assembly.live, .advance = 9 * work };
  g_assert_cmpint (qn_central_path_solve (path, &target, 0), ==, QN_SOLVE_CONVERGED);
  g_assert_cmpfloat (eq->out_of_balance, <=, eq->tolerance);
  g_assert_cmpfloat (eq->multiplier, >, 0.5);
  g_free (start);
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* Above the collapse load there is nothing to find, and that is said in good time. */
static void
test_no_equilibrium_fails (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 3, 0.65);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);

  g_assert_cmpint (newton (eq, 0), ==, QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (eq);
  int32_t before = eq->statistics.factorizations;
  g_assert_cmpint (follow (path, 1.01 * test_walls[2].associative), ==, QN_SOLVE_FAILED);
  g_assert_cmpint (eq->statistics.factorizations - before, <=, 60);
  g_assert_cmpint (follow (path, 0.99 * test_walls[2].associative), ==,
                   QN_SOLVE_CONVERGED);
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* A joint without friction carries no shear, and one without any live load is at rest. */
static void
test_frictionless (void)
{
  QnModel model;
  Solver solver;
  test_model_init_stack (&model, 3, 1, 0.5);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].friction = 0;
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);

  g_assert_cmpint (follow (path, 0), ==, QN_SOLVE_CONVERGED);
  for (size_t p = 0; p < eq->assembly.pair_count; p++) {
    g_assert_cmpfloat (eq->assembly.responses[p].force[0], <, 0);
    g_assert_cmpfloat (eq->assembly.responses[p].force[1], ==, 0);
  }
  g_assert_cmpint (follow (path, 0.1), ==, QN_SOLVE_FAILED);
  qn_central_path_free (path);
  solver_clear (&solver);
}

static bool
refuse (const QnProgress *progress, void *data)
{
  (void) progress;
  return (*(int *) data)-- > 0;
}

static void
test_cancel (void)
{
  QnModel model;
  Solver solver;
  int left = 3;
  test_model_init_wall (&model, 1, 0);
  solver_init (&solver, &model);
  QnEquilibrium *eq = &solver.equilibrium;
  QnCentralPath *path = new_path (eq);

  eq->report = refuse;
  eq->report_data = &left;
  g_assert_cmpint (follow (path, 0.5), ==, QN_SOLVE_CANCELLED);
  g_assert_cmpint (eq->statistics.factorizations, ==, 3);
  qn_central_path_free (path);
  solver_clear (&solver);
}

/* Joints of other laws are left to Newton's method. */
static void
test_applies (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 1, 0);
  model.laws[0].kind = QN_LAW_ELASTIC;
  solver_init (&solver, &model);
  g_assert_null (new_path (&solver.equilibrium));
  solver_clear (&solver);
}

QN_TESTS
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_autofree char *name = g_strdup_printf ("/central-path/one-increment/%d", number);
    g_test_add_data_func (name, GINT_TO_POINTER (number), test_one_increment);
  }
  g_test_add_func ("/central-path/large-displacements", test_large_displacements);
  g_test_add_func ("/central-path/agrees-with-newton", test_agrees_with_newton);
  g_test_add_func ("/central-path/work", test_work);
  g_test_add_func ("/central-path/stays-on-the-path", test_stays_on_the_path);
  g_test_add_func ("/central-path/no-equilibrium-fails", test_no_equilibrium_fails);
  g_test_add_func ("/central-path/frictionless", test_frictionless);
  g_test_add_func ("/central-path/cancel", test_cancel);
  g_test_add_func ("/central-path/applies", test_applies);
}
