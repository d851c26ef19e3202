#include "core/analysis.h"
#include "support/models.h"

#include <glib.h>
#include <math.h>

static void
run (QnModel *model, QnResult *result)
{
  QnContacts contacts;

  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
  qn_contacts_clear (&contacts);
}

static void
control (QnModel *model, QnProcedure procedure, const char *block, QnDof dof,
         double target)
{
  model->analysis.procedure = procedure;
  model->analysis.control_block = block ? qn_model_find_block (model, block) : QN_NONE;
  model->analysis.control_dof = dof;
  model->analysis.control_target = target;
}

/* A stiff block rocks over its corner: lambda = tan (alpha - theta) with tan alpha = b/h, zero
 * when the diagonal is vertical. The whole curve, within 0.5 % of its peak. */
static void
test_overturning_in_large_displacements (void)
{
  const double b = 0.4, h = 1, alpha = atan (b / h), radius = hypot (b, h) / 2;
  QnModel model;
  QnResult result;
  test_model_init_block_on_plane (&model, b, h);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].kn = model.laws[0].ks = 1e10;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model.analysis.increments = 400;
  control (&model, QN_PROCEDURE_DISPLACEMENT, "block", QN_DOF_UX, b / 2);
  run (&model, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (result.step_count, >, 10);
  for (size_t s = 1; s < result.step_count; s++) {
    const double *u = qn_result_step_displacements (&result, s) + 3;
    double theta = -u[2];
    g_assert_cmpfloat_with_epsilon (result.steps[s].multiplier, tan (alpha - theta),
                                    0.002);
    g_assert_cmpfloat_with_epsilon (u[0], radius * (sin (alpha) - sin (alpha - theta)),
                                    1e-3);
  }
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, b / h, 0.002);
  g_assert_cmpfloat_with_epsilon (result.steps[result.step_count - 1].multiplier, 0,
                                  0.002);
  qn_result_clear (&result);
  qn_model_clear (&model);
}

/* Work and arc-length control end on the plateau of a sliding block. */
static void
test_plateau (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_WORK, QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    QnResult result;
    test_model_init_block_on_plane (&model, 2, 0.5);
    test_model_add_weight_loads (&model, 1);
    control (&model, procedures[i], NULL, QN_DOF_UX, 0);
    run (&model, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.65, 1e-6);
    g_assert_cmpfloat_with_epsilon (result.mechanism[3], 1, 1e-3);
    qn_result_clear (&result);
    qn_model_clear (&model);
  }
}

/* Every procedure finds the same peak on a wall whose path is smooth. */
static void
test_peak_of_a_wall (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    QnResult result;
    test_model_init_wall (&model, 1, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    control (&model, procedures[i], "w.6.5", QN_DOF_UX, 0.05);
    run (&model, &result);
    double peak = 0;
    for (size_t s = 0; s < result.step_count; s++)
      peak = fmax (peak, result.steps[s].multiplier);
    g_test_message ("procedure %d: outcome %d, %zu steps, peak %.5f, %d factorisations",
                    procedures[i], result.outcome, result.step_count, peak,
                    result.statistics.factorizations);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_assert_cmpfloat_with_epsilon (peak, 0.6415, 1e-3);
    qn_result_clear (&result);
    qn_model_clear (&model);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/path-control/overturning", test_overturning_in_large_displacements);
  g_test_add_func ("/path-control/plateau", test_plateau);
  g_test_add_func ("/path-control/peak-of-a-wall", test_peak_of_a_wall);
  return g_test_run ();
}
