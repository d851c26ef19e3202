#include "core/path/stability.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* A rigid block of height 2a on a joint that is elastic in tension too, two pairs at its ends: a
 * weightless inverted pendulum. The force P at its centroid turns it over when
 *
 *   P a = K,   K = 2 k (b/2)^2,
 *
 * k the stiffness of a pair of springs. */
#define WIDTH  0.4
#define HEIGHT 2.0
#define K      1e6

static void
init_pendulum (QnModel *model)
{
  test_model_init_block_on_plane (model, WIDTH, HEIGHT);
  model->laws[0].kind = QN_LAW_ELASTIC;
  model->laws[0].kn = 2 * K;
  model->laws[0].ks = 2e3 * K; /* sliding adds a negligible part */
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 1;
  load->vector = qn_vec2 (0, -1000);
}

static QnStatus
run (QnModel *model, QnResult *result, QnDiag *diag)
{
  g_auto (QnContacts) contacts;
  memset (diag, 0, sizeof *diag);
  g_assert_cmpint (qn_model_prepare (model, diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, diag), ==, QN_OK);
  QnStatus status = qn_stability_run (model, &contacts, NULL, NULL, result, diag);
  qn_model_clear (model);
  return status;
}

/* The pairs shorten under the load by P/2k, which lowers the block: P (a - P/2k) = K at first
 * order. */
static void
test_pendulum (void)
{
  QnModel model;
  g_auto (QnResult) result;
  QnDiag diag;
  init_pendulum (&model);
  g_assert_cmpint (run (&model, &result, &diag), ==, QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_SNAP);
  g_assert_true (result.has_first_limit_multiplier);
  double stiffness = 2 * K * (WIDTH / 2) * (WIDTH / 2), a = HEIGHT / 2;
  double critical = stiffness / a / 1000;
  g_test_message ("%.6f, rigid pivot %.6f", result.first_limit_multiplier, critical);
  g_assert_cmpfloat_with_epsilon (result.first_limit_multiplier / critical, 1, 0.02);
  /* The mode: it turns about its foot, without sinking. */
  g_assert_nonnull (result.mechanism);
  g_assert_cmpfloat_with_epsilon (fabs (result.mechanism[3]), 1, 1e-6);
  g_assert_cmpfloat_with_epsilon (result.mechanism[4], 0, 1e-3);
  /* The step below is stable, and straight. */
  const double *u = qn_result_step_displacements (&result, result.step_count - 1);
  g_assert_cmpfloat_with_epsilon (u[3], 0, 1e-9);
  g_assert_cmpint (result.steps[result.step_count - 1].event, ==, QN_EVENT_SNAP);
}

static void
test_stable (void)
{
  QnModel model;
  g_auto (QnResult) result;
  QnDiag diag;
  init_pendulum (&model);
  model.analysis.max_multiplier = 50;
  g_assert_cmpint (run (&model, &result, &diag), ==, QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_false (result.has_first_limit_multiplier);
}

/* In linear geometry nothing buckles, however far. */
static void
test_linear (void)
{
  QnModel model;
  g_auto (QnResult) result;
  QnDiag diag;
  init_pendulum (&model);
  model.analysis.geometry = QN_GEOMETRY_LINEAR;
  model.analysis.max_multiplier = 1e6;
  g_assert_cmpint (run (&model, &result, &diag), ==, QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
}

static void
test_refused (void)
{
  QnModel model;
  QnResult result;
  QnDiag diag;
  init_pendulum (&model);
  QnStage *stage = qn_model_add_stage (&model, "s");
  stage->sets = 1;
  g_assert_cmpint (run (&model, &result, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_STABILITY_STAGES);
}

/* A stack of twelve that leans, on joints without tension: the same critical load from 10 to 1,000
 * increments, where a joint begins to let go. */
static void
test_leaning_stack (void)
{
  static const int increments[] = { 10, 30, 100, 1000 };
  static const double leans[] = { -0.7, 0.3 }, critical[] = { 0.451032, 0.196925 };

  for (size_t i = 0; i < G_N_ELEMENTS (leans) * G_N_ELEMENTS (increments); i++) {
    size_t l = i / G_N_ELEMENTS (increments);
    QnModel model;
    g_auto (QnResult) result;
    QnDiag diag;
    test_model_init (&model);
    test_model_add_base (&model, -1, -0.5, 3, 0.5);
    for (int b = 0; b < 12; b++) {
      g_autofree char *name = g_strdup_printf ("b%d", b);
      test_model_add_rectangle (&model, name, leans[l] * b / 12, 0.3 * b, 1, 0.3);
    }
    test_model_add_weight_loads (&model, 1);
    for (size_t b = 0; b < model.block_count; b++)
      model.blocks[b].unit_weight = 20000;
    model.laws[0].kind = QN_LAW_NO_TENSION;
    model.laws[0].basis = QN_BASIS_CONTACT;
    model.laws[0].kn = model.laws[0].ks = 1e8;
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    model.analysis.increments = increments[i % G_N_ELEMENTS (increments)];
    g_assert_cmpint (run (&model, &result, &diag), ==, QN_OK);
    g_test_message ("leans by %g: %.6f", leans[l], result.first_limit_multiplier);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_SNAP);
    g_assert_cmpfloat_with_epsilon (result.first_limit_multiplier, critical[l],
                                    1e-4 * critical[l]);
  }
}

/* Twelve blocks on soft joints, pushed sideways: that no equilibrium is found far beyond the last one says
 * nothing. Whatever the increments, the blocks slide before stability is lost, and nothing is said. */
static void
test_soft_stack (void)
{
  static const int increments[] = { 10, 40, 100, 400, 1000 };
  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
    QnModel model;
    g_auto (QnResult) result;
    QnDiag diag;
    test_model_init_stack (&model, 12, 0.5, 0.25);
    test_model_add_weight_loads (&model, 1);
    model.laws[0].kn = model.laws[0].ks = 1.5e6;
    model.laws[0].friction = 0.8;
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    model.analysis.increments = increments[i];
    g_assert_cmpint (run (&model, &result, &diag), !=, QN_OK);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_STATE_SLIPS);
  }
}

QN_TESTS
{
  g_test_add_func ("/stability/soft-stack", test_soft_stack);
  g_test_add_func ("/stability/pendulum", test_pendulum);
  g_test_add_func ("/stability/stable", test_stable);
  g_test_add_func ("/stability/linear", test_linear);
  g_test_add_func ("/stability/refused", test_refused);
  g_test_add_func ("/stability/leaning-stack", test_leaning_stack);
}
