/* A block on soft joints stands upright under its weight as long as these hold it:
 *
 *   W h / 2 < 2 k (b / 2)^2,   k = kn / 2: two springs in series
 */
#include "core/path/analysis.h"
#include "support/models.h"

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
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    QnResult result;
    solve (kinds[i], 1.02, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    qn_result_clear (&result);

    solve (kinds[i], 0.9, &result);
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

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/path-rest/upright", test_upright);
  return g_test_run ();
}
