#include "render/curve-plot.h"
#include "render/fixture.h"

#include <glib/gstdio.h>
#include <math.h>

static void
test_curve_of_result (void)
{
  Fixture f;
  QnCurve curve;
  QnId block;
  QnDof dof;
  fixture_init_wall (&f, 4, 4);
  f.result.has_first_limit_multiplier = true;
  f.result.first_limit_multiplier = f.result.steps[2].multiplier;
  g_assert_true (
    qn_curve_from_result (&curve, &f.result, QN_NONE, QN_DOF_UX, &block, &dof));
  g_assert_cmpuint (curve.count, ==, f.result.step_count);
  const double *last = qn_result_step_displacements (&f.result, curve.count - 1);
  for (size_t b = 0; b < f.model.block_count; b++)
    for (int k = 0; k < 2; k++)
      g_assert_cmpfloat (fabs (last[3 * b + k]), <=, fabs (last[3 * block + dof]));
  g_assert_cmpfloat (curve.x[curve.count - 1], ==, last[3 * block + dof]);
  g_assert_cmpfloat (curve.y[1], ==, f.result.steps[1].multiplier);
  g_assert_cmpint (curve.limit_point, ==, 2);
  g_assert_cmpint (curve.collapse_point, ==, (ptrdiff_t) curve.count - 1);
  qn_curve_clear (&curve);

  g_assert_true (qn_curve_from_result (&curve, &f.result, 3, QN_DOF_RZ, &block, &dof));
  g_assert_cmpint (block, ==, 3);
  g_assert_cmpfloat (curve.x[curve.count - 1], ==, last[3 * 3 + QN_DOF_RZ]);
  qn_curve_clear (&curve);
  fixture_clear (&f);
}

static void
export_plot (const QnCurvePlot *plot)
{
  static const char *const names[] = { "c.png", "c.svg", "c.pdf" };
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  QnOutput output;
  QnMetadata metadata;
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  for (size_t i = 0; i < G_N_ELEMENTS (names); i++) {
    GError *error = NULL;
    g_autofree char *path = g_build_filename (folder, names[i], NULL);
    g_assert_true (qn_curve_export (plot, path, &output, &metadata, &error));
    g_assert_no_error (error);
    g_assert_cmpint (g_unlink (path), ==, 0);
  }
  g_rmdir (folder);
}

/* No data, one point, not-a-number, a vertical drop: a plot is still drawn. */
static void
test_odd_data (void)
{
  double x[4] = { 0, 0.5, (double) NAN, 0.5 }, y[4] = { 0, 0.4, 0.1, -0.2 };
  QnCurve curves[3] = { { .limit_point = -1, .collapse_point = -1, .dot = -1 },
                        { .x = x, .y = y, .count = 1, .limit_point = 0, .dot = 9 },
                        { .x = x, .y = y, .count = 4, .collapse_point = 3, .dot = 1 } };
  QnReferenceLine line = { 0.3, "reference" };
  for (size_t n = 0; n <= 3; n++) {
    QnCurvePlot plot = { .curves = curves,
                         .curve_count = n,
                         .references = &line,
                         .reference_count = n > 1 ? 1 : 0 };
    export_plot (&plot);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/render/curve-plot/result", test_curve_of_result);
  g_test_add_func ("/render/curve-plot/odd-data", test_odd_data);
  return g_test_run ();
}
