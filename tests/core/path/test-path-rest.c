/* A block on soft joints stands upright under its weight as long as these hold it:
 *
 *   W h / 2 < 2 k (b / 2)^2,   k = kn / 2: two springs in series
 */
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

#define WIDTH  0.5
#define HEIGHT 3.0

static void
solve (QnLawKind kind, double part, QnResult *result)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init_block_on_plane (&model, WIDTH, HEIGHT);
  double weight = 10000 * WIDTH * HEIGHT;
  model.laws[0].kind = kind;
  model.laws[0].kn = part * weight * HEIGHT / 2 / (WIDTH * WIDTH / 4);
  model.laws[0].ks = model.laws[0].kn;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.max_multiplier = 0;
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
}

static void
test_upright (void)
{
  const QnLawKind kinds[] = { QN_LAW_ELASTIC, QN_LAW_NO_TENSION, QN_LAW_COULOMB };
  const double parts[] = { 1.02, 1.001, 0.999, 0.98, 0.9 };
  for (gsize i = 0; i < G_N_ELEMENTS (kinds) * G_N_ELEMENTS (parts); i++) {
    double part = parts[i % G_N_ELEMENTS (parts)];
    QnResult result;
    solve (kinds[i / G_N_ELEMENTS (parts)], part, &result);
    if (part > 1) {
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
      qn_result_clear (&result);
      continue;
    }
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
    g_assert_cmpuint (result.step_count, ==, 0);
    g_assert_cmpuint (result.unstable_count, ==, 1);
    g_assert_cmpint (result.unstable_blocks[0], ==, 1);
    /* It turns about its foot. */
    g_assert_nonnull (result.mechanism);
    g_assert_cmpfloat_with_epsilon (fabs (result.mechanism[3]), 1, 1e-6);
    g_assert_cmpfloat_with_epsilon (result.mechanism[4], 0, 1e-6);
    qn_result_clear (&result);
  }
}

/* Twelve blocks that lean by 0.7 m against their load, on joints without tension that begin to open. */
static void
solve_stack (double kn, QnProcedure procedure, int increments, QnResult *result)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_model_init (&model);
  test_model_add_base (&model, -1, -0.5, 3, 0.5);
  for (int b = 0; b < 12; b++) {
    g_autofree char *name = g_strdup_printf ("b%d", b);
    test_model_add_rectangle (&model, name, -0.7 * b / 12, 0.3 * b, 1, 0.3);
  }
  test_model_add_weight_loads (&model, 1);
  for (size_t b = 0; b < model.block_count; b++)
    model.blocks[b].unit_weight = 20000;
  model.laws[0].kind = QN_LAW_NO_TENSION;
  model.laws[0].kn = model.laws[0].ks = kn;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.procedure = procedure;
  model.analysis.increments = increments;
  if (procedure == QN_PROCEDURE_DISPLACEMENT)
    model.analysis.control.block = (QnId) model.block_count - 1;
  model.analysis.control.target = 0.5;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
}

/* Soft joints let it fall under its weight, which is said; on stiff ones every procedure comes to the load
 * at which it turns, that of `stability` (test-stability.c), in 10 to 1,000 increments. */
static void
test_leaning_stack (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  static const int increments[] = { 10, 100, 1000 };
  /* Softer ones bend far and fall as a whole; of the others blocks come down one by one. */
  static const double soft[] = { 1e5, 3e5, 5e5, 7e5, 8e5, 1e6, 2e6, 3e6, 4e6, 5e6 };
  static const struct {
    double kn, turns;
  } stiff[] = { { 1e7, 0.406734 }, { 1e8, 0.451034 }, { 1e9, 0.455524 } };

  for (gsize i = 0; i < G_N_ELEMENTS (procedures) * G_N_ELEMENTS (increments); i++) {
    QnProcedure procedure = procedures[i / G_N_ELEMENTS (increments)];
    int count = increments[i % G_N_ELEMENTS (increments)];
    bool held = procedure == QN_PROCEDURE_DISPLACEMENT;
    QnResult result;
    for (gsize k = 0; k < G_N_ELEMENTS (soft); k++) {
      solve_stack (soft[k], procedure, count, &result);
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
      g_assert_cmpuint (result.unstable_count, >=, 10);
      g_assert_cmpuint (result.step_count, ==, 0);
      qn_result_clear (&result);
    }
    for (gsize k = 0; k < G_N_ELEMENTS (stiff); k++) {
      solve_stack (stiff[k].kn, procedure, count, &result);
      g_test_message ("kn %g, procedure %d, %d increments: %.6f, %d factorisations",
                      stiff[k].kn, procedure, count, result.collapse_multiplier,
                      result.statistics.factorizations);
      g_assert_cmpint (result.outcome, ==,
                       held ? QN_OUTCOME_TARGET_REACHED : QN_OUTCOME_COLLAPSE);
      g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, stiff[k].turns,
                                      1e-4 * stiff[k].turns);
      qn_result_clear (&result);
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/path-rest/upright", test_upright);
  g_test_add_func ("/path-rest/leaning-stack", test_leaning_stack);
}
