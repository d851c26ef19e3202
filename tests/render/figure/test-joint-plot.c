#include "render/figure/joint-plot.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* The plots of a joint of 2 m with pairs at its ends; forces as an analysis would leave them. */
static void
make (QnPlot *plots[2], const QnPairResult *pairs)
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
  qn_joint_plots_init (plots, &model, &contacts, pairs, 0);
  plots[0]->x.label = plots[1]->y.label = "N";
  plots[0]->y.label = "T";
  plots[1]->x.label = "along";
}

static void
clear (QnPlot *plots[2])
{
  qn_plot_free (plots[1]);
  qn_plot_free (plots[0]);
}

static const QnMarks *
marks_of (const QnPlot *plot, guint index)
{
  return &g_array_index (plot->marks, QnMarks, index);
}

static void
test_fill (void)
{
  QnPairResult pairs[] = {
    { .state = QN_PAIR_SLIP, .normal_force = -1e3, .shear_force = 650.0 },
    { .state = QN_PAIR_OPEN }
  };
  QnPlot *plots[2];
  make (plots, pairs);
  g_assert_cmpuint (plots[0]->marks->len, ==, 3); /* one cone, two pairs */
  const QnMarks *cone = marks_of (plots[0], 0), *slips = marks_of (plots[0], 1);
  const double slope = (cone->y[0] - cone->y[1]) / (cone->x[1] - cone->x[0]);
  g_assert_cmpfloat_with_epsilon (slope, 0.6, 1e-12);
  /* A slipping pair is on its cone. */
  g_assert_cmpfloat (slips->x[0], ==, -1e3);
  g_assert_cmpfloat_with_epsilon (cone->y[0] + slope * (cone->x[0] - slips->x[0]),
                                  slips->y[0], 1e-9);
  g_assert_cmpint (slips->marker, ==, QN_MARKER_SQUARE);
  g_assert_cmpint (marks_of (plots[0], 2)->marker, ==, QN_MARKER_RING);
  const QnMarks *shear = marks_of (plots[1], 1);
  g_assert_cmpuint (shear->count, ==, 2);
  g_assert_cmpfloat (fabs (shear->x[1] - shear->x[0]), ==, 2.0);
  g_assert_cmpfloat (shear->y[0], ==, 650.0);
  clear (plots);
}

static guint
count_inked (QnPlot *const plots[2], int width, int height)
{
  cairo_surface_t *surface =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, MAX (width, 1), MAX (height, 1));
  cairo_t *cr = cairo_create (surface);
  qn_joint_plots_draw (plots, cr, width, height, 96.0 / 72.0);
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

/* Fewer pairs leave less ink; no size and no forces break it. */
static void
test_draw (void)
{
  QnPairResult pairs[] = {
    { .state = QN_PAIR_STICK, .normal_force = -1e3, .shear_force = 100.0 },
    { .state = QN_PAIR_OPEN }
  };
  QnPlot *plots[2];
  make (plots, pairs);
  guint with_two = count_inked (plots, 300, 230);
  count_inked (plots, 8, 8);
  g_array_set_size (plots[0]->marks, 2);
  g_assert_cmpuint (with_two, >, count_inked (plots, 300, 230));
  clear (plots);
  pairs[0].normal_force = pairs[0].shear_force = 0.0;
  make (plots, pairs);
  g_assert_cmpuint (count_inked (plots, 300, 230), >, 0);
  clear (plots);
}

QN_TESTS
{
  g_test_add_func ("/render/joint-plot/fill", test_fill);
  g_test_add_func ("/render/joint-plot/draw", test_draw);
}
