#include "render/figure/joint-plot.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

/* A block on another one, pairs at the ends; forces as an analysis would leave them. */
static void
fill (QnJointPlot *plot, QnPairResult *pairs)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag = { 0 };
  qn_model_init (&model);
  QnLaw *law = qn_model_add_law (&model, "dry");
  law->kind = QN_LAW_COULOMB;
  law->kn = law->ks = 1e7;
  law->friction = 0.6;
  law->cohesion = 50.0;
  const QnVec2 low[] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
  const QnVec2 high[] = { { 0, 1 }, { 2, 1 }, { 2, 2 }, { 0, 2 } };
  for (int i = 0; i < 2; i++) {
    QnBlock *block =
      qn_model_add_block (&model, i == 0 ? "low" : "high", i == 0 ? low : high, 4);
    block->thickness = 1.0;
    block->unit_weight = 1e4;
    block->support[0] = block->support[1] = block->support[2] = i == 0;
  }
  model.contact.law = 0;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpuint (contacts.pair_count, ==, 2);
  QnResult result = { 0 };
  g_assert_false (qn_joint_plot_fill (plot, &model, &contacts, &result, -1, 0));
  result.pairs = pairs;
  g_assert_true (qn_joint_plot_fill (plot, &model, &contacts, &result, -1, 0));
}

static void
test_fill (void)
{
  QnPairResult pairs[] = {
    { .state = QN_PAIR_SLIP, .normal_force = -1e3, .shear_force = 650.0 },
    { .state = QN_PAIR_OPEN }
  };
  QnJointPlot plot = { 0 };
  fill (&plot, pairs);
  g_assert_cmpuint (plot.count, ==, 2);
  g_assert_cmpfloat (plot.length, ==, 2.0);
  g_assert_cmpfloat (fabs (plot.points[1].along - plot.points[0].along), ==, 2.0);
  g_assert_true (plot.points[0].has_cone);
  g_assert_cmpfloat (plot.points[0].friction, ==, 0.6);
  /* A slipping pair is on its cone. */
  const QnJointPoint *p = &plot.points[0];
  g_assert_cmpfloat_with_epsilon (p->cohesion - p->friction * p->normal, p->shear, 1e-9);
  free (plot.points);
}

static guint
count_inked (const QnJointPlot *plot, int width, int height)
{
  cairo_surface_t *surface =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, MAX (width, 1), MAX (height, 1));
  cairo_t *cr = cairo_create (surface);
  qn_joint_plot_draw (plot, cr, width, height, 96.0 / 72.0);
  g_assert_cmpint (cairo_status (cr), ==, CAIRO_STATUS_SUCCESS);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  const guint8 *data = cairo_image_surface_get_data (surface);
  guint inked = 0;
  for (int i = 0; i < cairo_image_surface_get_stride (surface) * height; i += 4)
    inked += data[i + 3] > 128;
  cairo_surface_destroy (surface);
  return inked;
}

/* More pairs leave more ink; no size and no forces break it. */
static void
test_draw (void)
{
  QnPairResult pairs[] = {
    { .state = QN_PAIR_STICK, .normal_force = -1e3, .shear_force = 100.0 },
    { .state = QN_PAIR_OPEN }
  };
  QnJointPlot plot = { 0 };
  fill (&plot, pairs);
  plot.force_factor = 1e3;
  plot.length_factor = 1;
  plot.normal_label = "N";
  plot.shear_label = "T";
  plot.along_label = "along";
  guint with_two = count_inked (&plot, 300, 230);
  plot.count = 1;
  g_assert_cmpuint (with_two, >, count_inked (&plot, 300, 230));
  plot.points[0].normal = plot.points[0].shear = 0.0;
  g_assert_cmpuint (count_inked (&plot, 300, 230), >, 0);
  count_inked (&plot, 8, 8);
  free (plot.points);
}

QN_TESTS
{
  g_test_add_func ("/render/joint-plot/fill", test_fill);
  g_test_add_func ("/render/joint-plot/draw", test_draw);
}
