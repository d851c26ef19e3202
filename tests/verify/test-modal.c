/* Frequencies against closed forms. */
#include "core/modal/modal.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

static void
run (QnModel *model, size_t wanted, QnModes *modes)
{
  test_find_modes (model, wanted, modes);
  for (size_t i = 1; i < modes->count; i++)
    g_assert_cmpfloat (modes->omega[i], >=, modes->omega[i - 1]);
  qn_model_clear (model);
}

/* A beam of equal blocks between the centroids of the first and the last; L = 3 m, 0.2 x 0.5 m,
 * E = 30 GPa, nu = 0, k = 5/6, 7000 kg/m3. */
static void
init_beam (QnModel *model, int faces)
{
  const double L = 3, depth = 0.5, h = L / faces;
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "member");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = 30e9,
                  .ks = 15e9,
                  .shear_factor = 5. / 6 };
  model->contact.law = 0;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_GAUSS, .count = 2 };
  for (int i = 0; i <= faces; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block =
      test_model_add_rectangle (model, name, (i - 0.5) * h, -depth / 2, h, depth);
    block->thickness = 0.2;
    block->density = 7000;
    block->support[QN_DOF_UX] = true; /* transverse vibrations only */
  }
}

/* Simply supported: 315.819, 1151.685, 2304.893, 3627.124, 5036.041 rad/s. The half blocks
 * beyond the supports turn with them, which costs a little of the first order. */
static void
test_simply_supported (void)
{
  static const double exact[] = { 315.819, 1151.685, 2304.893, 3627.124, 5036.041 };
  QnModel model;
  g_auto (QnModes) modes;
  init_beam (&model, 60);
  model.blocks[0].support[QN_DOF_UY] = model.blocks[60].support[QN_DOF_UY] = true;
  run (&model, G_N_ELEMENTS (exact), &modes);
  for (size_t i = 0; i < G_N_ELEMENTS (exact); i++) {
    g_test_message ("mode %zu: %.3f, exact %.3f (%+.3f %%)", i + 1, modes.omega[i],
                    exact[i], 100 * (modes.omega[i] / exact[i] - 1));
    g_assert_cmpfloat_with_epsilon (modes.omega[i] / exact[i], 1, 0.01);
  }
}

/* One block on two springs: rocking, sliding and bouncing, in closed form. */
static void
check_one_block (QnLawKind kind, double push)
{
  const double b = 1, h = 0.4, k = 1e7;
  QnModel model;
  g_auto (QnModes) modes;
  test_model_init_block_on_plane (&model, b, h);
  model.laws[0].kind = kind;
  model.laws[0].friction = 0.6;
  model.gravity = 10;
  QnLoad *load = qn_model_add_dead_load (&model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (push, -1);
  run (&model, 2, &modes);
  g_assert_cmpuint (modes.open, ==, 0);
  g_assert_cmpuint (modes.slides, ==, push > 0);

  /* kn = ks: two pairs of k/2 each; mass = weight / g. About the centroid, rotation r and
   * translation x couple through the arm h/2: [k, k h/2; k h/2, k (h^2 + b^2)/4]. */
  double mass = 10000 * b * h / 10, inertia = mass * (b * b + h * h) / 12;
  double a11 = k / mass, a22 = k * (h * h + b * b) / 4 / inertia;
  double a12 = k * h / 2 / sqrt (mass * inertia);
  double low = 0.5 * (a11 + a22) - sqrt (0.25 * (a11 - a22) * (a11 - a22) + a12 * a12);
  g_assert_cmpfloat_with_epsilon (modes.omega[0] / sqrt (low), 1, 1e-9);
  g_assert_cmpfloat_with_epsilon (modes.omega[1] / sqrt (k / mass), 1, 1e-9);
}

/* A block whose centroid is held turns alone: no translation takes part. Held altogether it has no modes. */
static void
test_held (void)
{
  const double b = 1, h = 0.4, k = 1e7, inertia = 1000 * b * h * (b * b + h * h) / 12;
  for (int all = 0; all < 2; all++) {
    g_auto (TestRun) run = { 0 };
    g_auto (QnModes) modes = { 0 };
    QnDiag diag = { 0 };
    test_model_init_block_on_plane (&run.model, b, h);
    run.model.laws[0].kind = QN_LAW_ELASTIC;
    run.model.gravity = 10;
    test_model_add_weight_loads (&run.model, 1);
    bool *held = run.model.blocks[1].support;
    held[QN_DOF_UX] = held[QN_DOF_UY] = true;
    held[QN_DOF_RZ] = all == 1;
    test_run_prepare (&run);
    QnStatus status = qn_modal_run (&run.model, &run.contacts, QN_MODAL_DEAD_LOAD, 3,
                                    NULL, NULL, &modes, &run.result, &diag);
    g_assert_cmpint (status, ==, all == 1 ? QN_ERROR_INVALID : QN_OK);
    g_assert_cmpuint (modes.count, ==, all == 1 ? 0 : 1);
    if (all == 1) {
      g_assert_cmpint (diag.problem, ==, QN_PROBLEM_TOO_FEW_UNKNOWNS);
      continue;
    }
    double exact = sqrt (k * (h * h + b * b) / 4 / inertia);
    g_assert_cmpfloat_with_epsilon (modes.omega[0] / exact, 1, 1e-9);
    g_assert_cmpfloat (modes.masses[1] + modes.masses[2], ==, 0);
  }
}

/* Damping of a rigid motion, of three modes and of the last one alone: between the first mode that is none and
 * the last it is less than asked for. The main mode is the one with most of the mass along x. */
static void
test_damping (void)
{
  double omega[] = { 0, 10, 20, 40 };
  double masses[] = { 9, 900, 0, 9, 50, 800, 9, 70, 0, 9, 60, 0 };
  QnModes modes = { .count = 4, .omega = omega, .masses = masses };
  QnModesDamping damping = qn_modes_damping (&modes, 0.05);
  g_assert_cmpuint (damping.first, ==, 1);
  g_assert_cmpuint (damping.last, ==, 3);
  for (int i = 1; i < 4; i++) {
    double ratio = (damping.mass / omega[i] + damping.stiffness * omega[i]) / 2;
    if (i == 2)
      g_assert_cmpfloat (ratio, <, 0.05);
    else
      g_assert_cmpfloat_with_epsilon (ratio, 0.05, 1e-15);
  }
  g_assert_cmpuint (qn_modes_main (&modes), ==, 2);
  modes.count = 1;
  g_assert_cmpuint (qn_modes_main (&modes), ==, 1);
  damping = qn_modes_damping (&modes, 0.05);
  g_assert_cmpfloat (damping.mass + damping.stiffness, ==, 0);
}

/* Joints that are closed are elastic, the one as well that slides because the push relieves it. */
static void
test_one_block (void)
{
  check_one_block (QN_LAW_ELASTIC, 0);
  check_one_block (QN_LAW_COULOMB, 0);
  check_one_block (QN_LAW_COULOMB, 0.5);
  check_one_block (QN_LAW_NO_TENSION, 0);
}

/* A wall of 635 blocks without tension, which stands, vibrates as one with friction: the joints between
 * blocks of one course carry nothing. */
static void
test_dry_wall (void)
{
  static const QnLawKind kinds[] = { QN_LAW_COULOMB, QN_LAW_NO_TENSION };
  QnModes modes[2];
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    QnModel model;
    test_bond_init (&model, qn_vec2 (0.4, 0.2), 25, 25, 0, 0);
    model.laws[0].kind = kinds[i];
    model.laws[0].basis = QN_BASIS_SURFACE;
    model.laws[0].kn = model.laws[0].ks = 2e10;
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    run (&model, 3, &modes[i]);
    g_assert_cmpuint (modes[i].count, ==, 3);
    g_assert_cmpfloat (modes[i].omega[0], >, 0);
  }
  g_test_message ("%.6f and %.6f rad/s; %zu and %zu pairs left out", modes[0].omega[0],
                  modes[1].omega[0], modes[0].open, modes[1].open);
  g_assert_cmpuint (modes[0].open, ==, modes[1].open);
  for (int mode = 0; mode < 3; mode++)
    g_assert_cmpfloat (fabs (modes[0].omega[mode] / modes[1].omega[mode] - 1), <, 1e-6);
  qn_modes_clear (&modes[0]);
  qn_modes_clear (&modes[1]);
}

/* Four bricks, free: three rigid motions first, then frequencies that a scaling of the joints
 * moves by its root. 0.25 x 0.055 m, depth 0.12 m, 1800 kg/m3, joints E/t and G/t. */
static void
init_wallet (QnModel *model, double stiffness)
{
  const double b = 0.25, h = 0.055, young = 1e9 * stiffness, t = 0.01;
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "mortar");
  /* Each of the two springs of a pair has twice the stiffness of the joint. */
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_SURFACE,
                  .kn = 2 * young / t,
                  .ks = 2 * young / 2.4 / t };
  model->contact.law = 0;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_GAUSS, .count = 2 };
  static const double corners[][2] = { { 0, 0 }, { -0.5, 1 }, { 0.5, 1 }, { 0, 2 } };
  for (int i = 0; i < 4; i++) {
    g_autofree char *name = g_strdup_printf ("brick %d", i + 1);
    QnBlock *block =
      test_model_add_rectangle (model, name, corners[i][0] * b, corners[i][1] * h, b, h);
    block->thickness = 0.12;
    block->density = 1800;
  }
}

static void
test_wallet (void)
{
  QnModel model;
  g_auto (QnModes) modes, stiffer;
  init_wallet (&model, 1);
  run (&model, 20, &modes);
  init_wallet (&model, 4);
  run (&model, 20, &stiffer);
  g_assert_cmpuint (modes.count, ==, 12);
  for (size_t i = 0; i < modes.count; i++) {
    g_test_message ("mode %zu: %.1f Hz", i + 1, modes.omega[i] / (2 * G_PI));
    if (i < 3)
      g_assert_cmpfloat (modes.omega[i], ==, 0);
    else
      g_assert_cmpfloat_with_epsilon (stiffer.omega[i] / modes.omega[i], 2, 1e-6);
  }
  g_assert_cmpfloat (modes.omega[3], >, 0);
}

/* Limit analysis and analyses in time end in no state to vibrate about. */
static void
test_without_state (void)
{
  static const struct {
    QnProcedure procedure;
    QnProblem problem;
  } cases[] = { { QN_PROCEDURE_LIMIT, QN_PROBLEM_LIMIT_WITHOUT_STATE },
                { QN_PROCEDURE_DYNAMIC, QN_PROBLEM_TIME_WITHOUT_STATE } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (TestRun) run = { 0 };
    g_auto (QnModes) modes = { 0 };
    QnDiag diag = { 0 };
    test_model_init_block_on_plane (&run.model, 1, 1);
    test_model_add_weight_loads (&run.model, 1);
    test_run_prepare (&run);
    run.model.analysis.procedure = cases[i].procedure;
    g_assert_cmpint (qn_modal_run (&run.model, &run.contacts, QN_MODAL_LOADED, 1, NULL,
                                   NULL, &modes, &run.result, &diag),
                     ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, cases[i].problem);
    g_assert_cmpuint (modes.count, ==, 0);
  }
}

/* Whether `left` calls remain. */
static bool
count_down (const QnProgress *progress, void *left)
{
  (void) progress;
  return --*(int *) left > 0;
}

/* Whenever it is cancelled, under the dead load or among the modes, the result says so and has no modes. */
static void
test_cancel (void)
{
  bool cancelled = true;
  for (int calls = 1; cancelled; calls++) {
    g_auto (TestRun) run = { 0 };
    g_auto (QnModes) modes = { 0 };
    int left = calls;
    init_beam (&run.model, 20);
    run.model.blocks[0].support[QN_DOF_UY] = run.model.blocks[20].support[QN_DOF_UY] =
      true;
    test_run_prepare (&run);
    g_assert_cmpint (qn_modal_run (&run.model, &run.contacts, QN_MODAL_DEAD_LOAD, 3,
                                   count_down, &left, &modes, &run.result, NULL),
                     ==, QN_OK);
    cancelled = left <= 0;
    g_assert_cmpint (run.result.outcome, ==,
                     cancelled ? QN_OUTCOME_CANCELLED : QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpuint (modes.count, ==, cancelled ? 0 : 3);
    g_test_message ("%d calls", calls);
  }
}

QN_TESTS
{
  g_test_add_func ("/verify/modal/simply-supported", test_simply_supported);
  g_test_add_func ("/verify/modal/cancel", test_cancel);
  g_test_add_func ("/verify/modal/without-state", test_without_state);
  g_test_add_func ("/verify/modal/one-block", test_one_block);
  g_test_add_func ("/verify/modal/held", test_held);
  g_test_add_func ("/verify/modal/damping", test_damping);
  g_test_add_func ("/verify/modal/dry-wall", test_dry_wall);
  g_test_add_func ("/verify/modal/wallet", test_wallet);
}
