#include "core/solver.h"
#include "support/room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Small random displacements that open, close and slide joints, pressed together so that
 * every state occurs. */
static void
random_displacements (const QnAssembly *as, GRand *random, double *u)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    u[i] = g_rand_double_range (random, -1e-4, 1e-4);
}

static double
entry (const QnAssembly *as, int32_t row, int32_t column)
{
  for (int32_t k = as->ap[column]; k < as->ap[column + 1]; k++)
    if (as->ai[k] == row)
      return as->ax[k];
  return 0;
}

/* A dead and a live force away from a centroid: their moments change when the block turns. */
static void
add_eccentric_loads (QnModel *model)
{
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  for (int live = 0; live < 2; live++) {
    QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
    *load = (QnLoad){ .kind = QN_LOAD_FORCE,
                      .vector = qn_vec2 (4e6, -7e6),
                      .block = 3 + live,
                      .has_at = true,
                      .at = qn_vec2 (0.31, 0.9) };
  }
}

/* Adds a rotation of every free block about the origin: large, and nearly rigid. */
static void
turn_everything (const Solver *solver, double angle, double *u)
{
  const QnAssembly *as = &solver->equilibrium.assembly;
  for (size_t b = 0; b < solver->model.block_count; b++) {
    QnVec2 c = solver->model.blocks[b].centroid;
    QnVec2 move = qn_vec2_sub (qn_vec2_rotate (c, cos (angle), sin (angle)), c);
    const double motion[3] = { move.x, move.y, angle * as->length };
    for (int i = 0; i < 3; i++)
      if (as->unknown[3 * b + (size_t) i] != QN_NONE)
        u[as->unknown[3 * b + (size_t) i]] += motion[i];
  }
}

/* K against central differences of R, column by column, on a wall in a random state. Columns
 * whose difference straddles a change of a pair's tangent are left out, and must be few. */
static void
check_tangent (double dilatancy, QnGeometry geometry)
{
  const double multiplier = 0.3;
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 3, dilatancy);
  model.analysis.geometry = geometry;
  if (geometry == QN_GEOMETRY_NONLINEAR)
    add_eccentric_loads (&model);
  solver_init (&solver, &model);
  QnAssembly *as = &solver.equilibrium.assembly;
  int32_t n = as->unknown_count;
  g_autofree double *u = g_new0 (double, n), *plus = g_new0 (double, n),
                    *minus = g_new0 (double, n);
  g_autofree QnPairResponse *at = g_new0 (QnPairResponse, as->pair_count);
  GRand *random = g_rand_new_with_seed (11);
  int checked = 0;

  random_displacements (as, random, u);
  if (geometry == QN_GEOMETRY_NONLINEAR)
    turn_everything (&solver, 0.8, u);
  g_assert_true (qn_assembly_evaluate (as, u));
  qn_assembly_tangent (as, multiplier, 0);
  for (size_t p = 0; p < as->pair_count; p++)
    at[p] = as->responses[p];

  for (int32_t j = 0; j < n; j++) {
    double h = 1e-9, kept = u[j];
    bool same = true;
    for (int side = 0; side < 2; side++) {
      u[j] = kept + (side ? -h : h);
      g_assert_true (qn_assembly_evaluate (as, u));
      qn_assembly_residual (as, multiplier, side ? minus : plus);
      for (size_t p = 0; p < as->pair_count; p++)
        same =
          same
          && memcmp (at[p].tangent, as->responses[p].tangent, sizeof at[p].tangent) == 0;
    }
    u[j] = kept;
    if (!same)
      continue;
    checked++;
    for (int32_t i = 0; i < n; i++)
      g_assert_cmpfloat (fabs (entry (as, i, j) + (plus[i] - minus[i]) / (2 * h)), <,
                         1e-6 * 1e7);
  }
  g_assert_cmpint (checked, >, n * 9 / 10);

  bool symmetric = true;
  for (int32_t j = 0; j < n && symmetric; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1] && symmetric; k++)
      symmetric = fabs (as->ax[k] - entry (as, j, as->ai[k])) < 1e-9 * 1e7;
  g_assert_true (symmetric == (dilatancy > 0));
  g_rand_free (random);
  solver_clear (&solver);
}

static void
test_tangent_non_associative (void)
{
  check_tangent (0, QN_GEOMETRY_LINEAR);
}

static void
test_tangent_associative (void)
{
  check_tangent (0.65, QN_GEOMETRY_LINEAR);
}

static void
test_tangent_nonlinear (void)
{
  check_tangent (0, QN_GEOMETRY_NONLINEAR);
}

/* A rigid motion of everything strains nothing. */
static void
test_rigid_motion (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 1, 0);
  test_model_rotate (&model, 0.3);
  QnModel *free_model = &model;
  g_assert_cmpint (qn_model_prepare (free_model, NULL), ==, QN_OK);
  for (size_t b = 0; b < model.block_count; b++)
    memset (model.blocks[b].support, 0, sizeof model.blocks[b].support);
  g_assert_cmpint (qn_contacts_detect (&model, &solver.contacts, NULL), ==, QN_OK);
  solver.model = model;
  QnAssembly as;
  g_assert_cmpint (qn_assembly_setup (&as, &solver.model, &solver.contacts, NULL), ==,
                   QN_OK);

  const double turn = 1e-3, dx = 2, dy = -3;
  g_autofree double *u = g_new0 (double, as.unknown_count);
  for (size_t b = 0; b < solver.model.block_count; b++) {
    QnVec2 c = solver.model.blocks[b].centroid;
    u[3 * b] = dx - turn * c.y;
    u[3 * b + 1] = dy + turn * c.x;
    u[3 * b + 2] = turn * as.length;
  }
  g_assert_true (qn_assembly_evaluate (&as, u));
  for (size_t p = 0; p < as.pair_count; p++) {
    g_assert_cmpfloat (fabs (as.responses[p].force[0]), <, 1e7 * 1e-14);
    g_assert_cmpfloat (fabs (as.responses[p].force[1]), <, 1e7 * 1e-14);
  }
  qn_assembly_clear (&as);
  qn_contacts_clear (&solver.contacts);
  qn_model_clear (&solver.model);
}

/* Evaluating any number of times from the same committed state changes nothing. */
static void
test_evaluation_has_no_memory (void)
{
  QnModel model;
  Solver solver;
  test_model_init_wall (&model, 2, 0.65);
  solver_init (&solver, &model);
  QnAssembly *as = &solver.equilibrium.assembly;
  g_autofree double *u = g_new0 (double, as->unknown_count);
  g_autofree double *first = g_new0 (double, as->unknown_count);
  g_autofree double *again = g_new0 (double, as->unknown_count);
  g_autofree double *elsewhere = g_new0 (double, as->unknown_count);
  g_autoptr (GRand) random = g_rand_new_with_seed (13);

  random_displacements (as, random, u);
  qn_assembly_evaluate (as, u);
  qn_assembly_residual (as, 0.1, first);
  for (int k = 0; k < 5; k++) {
    random_displacements (as, random, elsewhere);
    qn_assembly_evaluate (as, elsewhere);
  }
  qn_assembly_evaluate (as, u);
  qn_assembly_residual (as, 0.1, again);
  g_assert_cmpmem (first, (size_t) as->unknown_count * sizeof *first, again,
                   (size_t) as->unknown_count * sizeof *again);
  solver_clear (&solver);
}

/* The weight of a block on the softest of its springs is one elastic displacement or so, whichever
 * direction that is. */
/* A body's translation counts as a whole, so that a structure turned with its loads has the same. */
static void
test_largest (void)
{
  static const double v[] = { 3, -4, 2 }, other[] = { 3, -4, 9 };
  QnModel model;
  Solver solver;

  test_model_init_block_on_plane (&model, 1, 1);
  solver_init (&solver, &model);
  const QnAssembly *as = &solver.equilibrium.assembly;
  g_assert_cmpint (as->unknown_count, ==, 3);
  g_assert_cmpfloat (qn_assembly_largest (as, v, NULL), ==, 5);
  g_assert_cmpfloat (qn_assembly_largest (as, other, NULL), ==, 9);
  g_assert_cmpfloat (qn_assembly_largest (as, other, v), ==, 7);
  g_assert_cmpfloat (qn_assembly_total (as, v), ==, 5);
  solver_clear (&solver);
}

/* Of a stack of three blocks that have been moved apart below the second, the upper two are loose; pressed
 * together by less than a hundredth of a weight they still are, and by more they are held. */
static void
test_largest_loose (void)
{
  static const struct {
    double part; /* of a weight that presses on the second joint's pairs */
    bool held;
  } cases[] = { { -1, false }, { 0.005, false }, { 0.05, true } };

  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnModel model;
    Solver solver;
    test_model_init_stack (&model, 3, 1, 0.5);
    test_model_add_weight_loads (&model, 1);
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    solver_init (&solver, &model);
    QnAssembly *as = &solver.equilibrium.assembly;
    double u[9] = { 0 }, pressed = model.blocks[1].weight / (model.laws[0].kn / 2);
    g_assert_cmpint (as->unknown_count, ==, 9);
    u[1] = -pressed;                       /* the first stands on the ground, */
    u[4] = u[1] - cases[i].part * pressed; /* the second has come up or not, */
    u[7] = u[4] - pressed;                 /* and the third stands on it */
    g_assert_true (qn_assembly_evaluate (as, u));
    double largest = qn_assembly_largest_loose (as, u, NULL);
    g_assert_cmpfloat (largest, ==, cases[i].held ? 0 : fmax (fabs (u[4]), fabs (u[7])));
    solver_clear (&solver);
  }
}

static void
test_elastic_displacements (void)
{
  static const double stiffness[][2] = { { 1e7, 1e7 }, { 1e9, 1e4 }, { 1e5, 1e10 } };

  for (size_t i = 0; i < G_N_ELEMENTS (stiffness); i++) {
    QnModel model;
    Solver solver;
    test_model_init_block_on_plane (&model, 1, 1);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kn = stiffness[i][0];
    model.laws[0].ks = stiffness[i][1];
    solver_init (&solver, &model);
    const QnAssembly *as = &solver.equilibrium.assembly;
    double softest = fmin (stiffness[i][0], stiffness[i][1]) / 2; /* two in series */
    double v[] = { 0, model.blocks[1].weight / softest, 0 };
    g_assert_cmpint (as->unknown_count, ==, 3);
    double measure = qn_assembly_elastic_displacements (as, v, NULL);
    g_assert_cmpfloat (measure, >, 0.25);
    g_assert_cmpfloat (measure, <, 4);
    solver_clear (&solver);
  }
}

/* One block whose joints slip without dilatancy among others, whichever side of its pairs it is. */
static void
test_may_jump (void)
{
  for (QnId changed = QN_NONE; changed < 5; changed++) {
    QnModel model;
    Solver solver;
    test_model_init_wall (&model, 1, 0.65);
    if (changed != QN_NONE) {
      QnLaw *law = qn_model_add_law (&model, "other");
      const char *name = law->name;
      *law = model.laws[0];
      law->name = (char *) name;
      law->dilatancy = 0;
      g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
      model.blocks[changed].law = (QnId) model.law_count - 1;
    }
    solver_init (&solver, &model);
    g_assert_true (qn_assembly_may_jump (&solver.equilibrium.assembly)
                   == (changed != QN_NONE));
    solver_clear (&solver);
  }
}

QN_TESTS
{
  g_test_add_func ("/assembly/tangent/non-associative", test_tangent_non_associative);
  g_test_add_func ("/assembly/tangent/associative", test_tangent_associative);
  g_test_add_func ("/assembly/tangent/nonlinear", test_tangent_nonlinear);
  g_test_add_func ("/assembly/rigid-motion", test_rigid_motion);
  g_test_add_func ("/assembly/largest", test_largest);
  g_test_add_func ("/assembly/largest-loose", test_largest_loose);
  g_test_add_func ("/assembly/elastic-displacements", test_elastic_displacements);
  g_test_add_func ("/assembly/evaluation-has-no-memory", test_evaluation_has_no_memory);
  g_test_add_func ("/assembly/may-jump", test_may_jump);
}
