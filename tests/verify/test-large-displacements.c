/* Equilibrium in the deformed configuration against closed forms: Euler loads, the elastica, a
 * block turned over, and the balance of energy along an elastic path. */
#include "core/path/stability.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

/* Length, depth, width, Young's modulus; EI/L^2 = 1 N for the slender one. */
typedef struct Member {
  double length, depth, width, young, shear;
} Member;

/* Equal blocks between the centroids of the first and the last, along the x axis. */
static void
init_member (QnModel *model, Member m, int faces)
{
  double h = m.length / faces;
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "member");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = m.young,
                  .ks = m.shear };
  model->contact.law = 0;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 10 };
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  for (int i = 0; i <= faces; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    test_model_add_rectangle (model, name, (i - 0.5) * h, -m.depth / 2, h, m.depth)
      ->thickness = m.width;
  }
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    model->blocks[0].support[dof] = true;
}

static void
add_end_force (QnModel *model, double fx, double fy)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = (QnId) model->block_count - 1;
  load->vector = qn_vec2 (fx, fy);
}

/* --- Columns ---------------------------------------------------------------------------- */

typedef enum { FREE, PINNED, CLAMPED } Ends;

/* Buckling load, kN, of L = 4 m, 0.2 x 0.2 m, E = 30 GPa, stiff in shear. */
static double
buckling_load (Ends ends, int faces)
{
  const Member m = { 4, 0.2, 0.2, 30e9, 1e13 };
  g_auto (TestRun) run;
  QnDiag diag = { 0 };
  init_member (&run.model, m, faces);
  add_end_force (&run.model, -1000, 0);
  QnBlock *first = &run.model.blocks[0], *last = &run.model.blocks[faces];
  if (ends == PINNED)
    first->support[QN_DOF_RZ] = false;
  if (ends != FREE)
    last->support[QN_DOF_UY] = true;
  if (ends == CLAMPED)
    last->support[QN_DOF_RZ] = true;
  run.model.analysis.increments = 1;
  test_run_prepare (&run);
  g_assert_cmpint (
    qn_stability_run (&run.model, &run.contacts, NULL, NULL, &run.result, &diag), ==,
    QN_OK);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_SNAP);
  double load = run.result.first_limit_multiplier;
  return load;
}

static void
test_euler_loads (void)
{
  static const double exact[] = { 616.850275, 2467.401100, 9869.604401 };
  for (int ends = FREE; ends <= CLAMPED; ends++) {
    double load = buckling_load ((Ends) ends, 30);
    g_test_message ("31 blocks: %.3f kN, %+.3f %%", load, 100 * (load / exact[ends] - 1));
    g_assert_cmpfloat_with_epsilon (load / exact[ends], 1, 0.01);
  }
}

/* A chain of rigid links with rotational springs EI/h buckles at 4 EI/h^2 sin^2 (pi h/2L) where
 * the continuous column does at pi^2 EI/L^2: second order. Shortening raises both: P (1 - P/EA)
 * = what does not shorten, with the length of the links that it leaves. */
static void
test_columns_converge (void)
{
  const double EI = 30e9 * 0.2 * 0.2 * 0.2 * 0.2 / 12, EA = 30e9 * 0.04, L = 4;
  for (int faces = 8; faces <= 32; faces *= 2) {
    double h = L / faces, s = sin (G_PI * h / (2 * L));
    double chain = 4 * EI / (h * h) * s * s;
    double shortened = 0.5 * EA * (1 - sqrt (1 - 4 * chain / EA));
    double load = buckling_load (PINNED, faces) * 1000;
    g_test_message ("%d faces: %.6f of the chain", faces, load / shortened);
    g_assert_cmpfloat_with_epsilon (load / shortened, 1, 3e-4);
  }
}

/* --- Dry joints ------------------------------------------------------------------------- */

/* Multiplier of 100 kN on the top block, off centre, that a wall of 40 blocks carries: 6 x 0.2 m,
 * joints of 2e10 Pa/m. */
static double
slender_wall (double off, QnPairRule pairs, int *factorizations)
{
  enum { COUNT = 40 };
  g_auto (TestRun) run;
  QnModel *model = &run.model;
  test_model_init_stack (model, COUNT, 0.2, 6.0 / COUNT);
  QnLaw *law = &model->laws[0];
  law->basis = QN_BASIS_SURFACE;
  law->kn = law->ks = 2e10;
  law->friction = 0.7;
  model->contact.pairs = pairs;
  test_model_add_weight_loads (model, 1);
  model->live_load_count = 0;
  for (int i = 1; i <= COUNT; i++)
    model->blocks[i].unit_weight = 20e3;
  add_end_force (model, 0, -100e3);
  model->live_loads[0].moment = -100e3 * off;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  *factorizations += run.result.statistics.factorizations;
  return run.result.collapse_multiplier;
}

/* The default pairs carry a slender wall within 0.5 % of what 40 even ones do, at no more than twice
 * the factorisations of end pairs, which say three and five times as much: they bend and come to their
 * peak, which is bisected. */
static void
test_slender_wall (void)
{
  static const double off[] = { 0.002, 0.05 }, times[] = { 3.3, 5 };
  int by_default = 0, by_ends = 0, by_many = 0;
  for (size_t i = 0; i < G_N_ELEMENTS (off); i++) {
    double many = slender_wall (
      off[i], (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 40 }, &by_many);
    double found = slender_wall (off[i], (QnPairRule){ 0 }, &by_default);
    double ends =
      slender_wall (off[i], (QnPairRule){ .placement = QN_PLACEMENT_ENDS }, &by_ends);
    g_test_message ("%.3f m: %.4f, many pairs %.4f, ends %.4f", off[i], found, many,
                    ends);
    g_assert_cmpfloat_with_epsilon (found / many, 1, 0.005);
    g_assert_cmpfloat (ends, >, times[i] * many);
  }
  g_test_message ("factorisations: %d, %d, %d", by_default, by_many, by_ends);
  g_assert_cmpint (by_default, <=, 2 * by_ends);
}

/* --- Elastica --------------------------------------------------------------------------- */

static void
test_elastica (void)
{
  static const double exact[][4] = { { 1, 0.30172, 0.05643, 0.46135 },
                                     { 2, 0.49346, 0.16064, 0.78175 },
                                     { 5, 0.71379, 0.38763, 1.21537 },
                                     { 10, 0.81061, 0.55500, 1.43029 } };
  const Member m = { 1, 0.02, 0.1, 12e9, 12e9 };
  const double EI = 12e9 * 0.1 * 0.02 * 0.02 * 0.02 / 12;
  TestRun run;
  init_member (&run.model, m, 40);
  add_end_force (&run.model, 0, -EI);
  for (int i = 0; i < 4; i++) {
    QnStage *stage = qn_model_add_stage (&run.model, NULL);
    stage->sets = 1;
    stage->has_target = true;
    stage->target = exact[i][0];
    stage->increments = 5;
  }
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  int found = 0;
  for (size_t s = 0; s < run.result.step_count; s++) {
    const double *u = qn_result_step_displacements (&run.result, s) + 3 * 40;
    for (int i = 0; i < 4; i++) {
      if (fabs (run.result.steps[s].multiplier - exact[i][0]) > 1e-9)
        continue;
      g_assert_cmpfloat_with_epsilon (-u[1] / exact[i][1], 1, 0.005);
      g_assert_cmpfloat_with_epsilon (-u[0] / exact[i][2], 1, 0.005);
      g_assert_cmpfloat_with_epsilon (-u[2] / exact[i][3], 1, 0.005);
      found++;
    }
  }
  g_assert_cmpint (found, ==, 4);
  test_run_clear (&run);
}

/* A member so slender that it swings by more than 1e5 times what its joints give under the same
 * force; increments that Newton's method does not solve are no collapse. Two evenly spaced pairs
 * have three quarters of the section's second moment. */
static void
test_slender_member_swings (void)
{
  const Member m = { 1, 0.005, 0.1, 200e9, 100e9 };
  const double EI = 0.75 * 200e9 * 0.1 * 0.005 * 0.005 * 0.005 / 12;
  g_auto (TestRun) run;
  init_member (&run.model, m, 127);
  add_end_force (&run.model, 0, -8. / 3 * EI);
  run.model.contact.pairs.count = 2;
  run.model.analysis.increments = 100;
  run.model.analysis.max_multiplier = 0.75;
  test_run_solve (&run);

  const QnResult *result = &run.result;
  g_assert_cmpint (result->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  const double *u = qn_result_step_displacements (result, result->step_count - 1);
  g_assert_cmpfloat_with_epsilon (-u[3 * 127 + 1], 0.49346, 1e-4);
  g_assert_cmpfloat_with_epsilon (-u[3 * 127], 0.16064, 1e-4);
  g_assert_cmpfloat_with_epsilon (-u[3 * 127 + 2], 0.78175, 1e-4);
}

/* --- Energy ----------------------------------------------------------------------------- */

/* What the springs hold, J: an elastic pair of springs is one of half the stiffness. */
static double
stored_energy (const TestRun *run)
{
  double energy = 0;
  for (size_t p = 0; p < run->contacts.pair_count; p++) {
    const QnPairResult *pair = &run->result.pairs[p];
    for (int i = 0; i < 2; i++) {
      double force = i == 0 ? pair->normal_force : pair->shear_force;
      energy += 0.5 * force * (pair->elongation_a[i] + pair->elongation_b[i]);
    }
  }
  return energy;
}

/* Work of the end force along the path, J, by trapezoids. */
static double
work_of_load (const TestRun *run, double force)
{
  const QnResult *result = &run->result;
  size_t last = result->block_count - 1;
  double work = 0;
  for (size_t s = 1; s < result->step_count; s++) {
    double before = qn_result_step_displacements (result, s - 1)[3 * last + 1];
    double after = qn_result_step_displacements (result, s)[3 * last + 1];
    double mean = 0.5 * (result->steps[s - 1].multiplier + result->steps[s].multiplier);
    work += mean * force * (after - before);
  }
  return work;
}

/* The work of the load is what is stored, rotations up to 80 degrees: the difference is the
 * trapezoids', and falls with the square of the increment, to nothing. */
static void
test_energy_balance (void)
{
  const Member m = { 1, 0.02, 0.1, 12e9, 12e9 };
  const double EI = 12e9 * 0.1 * 0.02 * 0.02 * 0.02 / 12;
  double before = 0;
  for (int steps = 50; steps <= 400; steps *= 2) {
    g_auto (TestRun) run;
    init_member (&run.model, m, 20);
    add_end_force (&run.model, 0, -10 * EI);
    for (int i = 1; i <= steps; i++) {
      QnStage *stage = qn_model_add_stage (&run.model, NULL);
      stage->sets = 1;
      stage->has_target = true;
      stage->target = (double) i / steps;
      stage->increments = 1;
    }
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpuint (run.result.step_count, ==, steps + 1);
    double stored = stored_energy (&run), work = work_of_load (&run, -10 * EI);
    double error = work / stored - 1;
    g_test_message ("%d steps: stored %.9g J, work %.9g J, %.2e", steps, stored, work,
                    error);
    g_assert_cmpfloat (fabs (error), <, 2.0 / ((double) steps * steps));
    if (before != 0)
      g_assert_cmpfloat_with_epsilon (before / error, 4, 0.1);
    before = error;
  }
}

/* --- Block turned over ------------------------------------------------------------------ */

/* tan (alpha - theta), the whole curve, to where the diagonal is upright. */
static void
test_overturning (void)
{
  const double b = 0.5, h = 1, alpha = atan2 (b, h), radius = hypot (b, h) / 2;
  TestRun run;
  test_model_init_block_on_plane (&run.model, b, h);
  test_model_add_weight_loads (&run.model, 1);
  run.model.laws[0].kn = run.model.laws[0].ks = 1e9;
  QnAnalysisSettings *analysis = &run.model.analysis;
  analysis->geometry = QN_GEOMETRY_NONLINEAR;
  analysis->procedure = QN_PROCEDURE_DISPLACEMENT;
  analysis->increments = 100;
  analysis->control.block = 1;
  analysis->control.dof = QN_DOF_UX;
  analysis->control.target = b / 2;
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);

  size_t compared = 0;
  for (size_t s = 0; s < run.result.step_count; s++) {
    double ux = qn_result_step_displacements (&run.result, s)[3];
    double theta = alpha - asin (sin (alpha) - ux / radius);
    if (ux < 1e-3) /* while it still leans on the elastic joint */
      continue;
    g_assert_cmpfloat_with_epsilon (run.result.steps[s].multiplier, tan (alpha - theta),
                                    0.005 * b / h);
    compared++;
  }
  g_assert_cmpuint (compared, >, 20);
  const QnStep *last = &run.result.steps[run.result.step_count - 1];
  g_assert_cmpfloat_with_epsilon (last->multiplier, 0, 1e-6);
  test_run_clear (&run);
}

QN_TESTS
{
  g_test_add_func ("/verify/large-displacements/euler-loads", test_euler_loads);
  g_test_add_func ("/verify/large-displacements/columns-converge", test_columns_converge);
  g_test_add_func ("/verify/large-displacements/slender-wall", test_slender_wall);
  g_test_add_func ("/verify/large-displacements/elastica", test_elastica);
  g_test_add_func ("/verify/large-displacements/slender-member-swings",
                   test_slender_member_swings);
  g_test_add_func ("/verify/large-displacements/energy-balance", test_energy_balance);
  g_test_add_func ("/verify/large-displacements/overturning", test_overturning);
}
