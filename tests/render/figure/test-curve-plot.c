#include "render/figure/curve-plot.h"
#include "render/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <math.h>

static const double *
displacement (const Fixture *f, size_t step, QnCurveMotion motion)
{
  return qn_result_step_displacements (&f->result, step) + 3 * (size_t) motion.body
         + (size_t) motion.dof;
}

static void
test_curve_of_result (void)
{
  Fixture f;
  QnCurve curve;
  fixture_init_wall (&f, 4, 4);
  f.result.has_first_limit_multiplier = true;
  f.result.first_limit_multiplier = f.result.steps[2].multiplier;
  size_t last = f.result.step_count - 1;
  QnCurveMotion motion = qn_result_curve_motion (&f.model, &f.result);
  qn_curve_from_result (&curve, &f.model, &f.result, motion);
  g_assert_cmpuint (curve.count, ==, f.result.step_count);
  g_assert_cmpfloat (curve.x[last], ==,
                     *displacement (&f, last, motion) - *displacement (&f, 0, motion));
  g_assert_cmpfloat (curve.y[1], ==, f.result.steps[1].multiplier);
  g_assert_cmpint (curve.limit_point, ==, 2);
  g_assert_cmpint (curve.collapse_point, ==, (ptrdiff_t) last);
  g_assert_false (curve.since_dead);
  g_assert_false (curve.rotation);
  qn_curve_clear (&curve);

  const QnCurveMotion turning = { 3, QN_DOF_RZ, false };
  qn_curve_from_result (&curve, &f.model, &f.result, turning);
  g_assert_cmpfloat (curve.x[last], ==, *displacement (&f, last, turning));
  g_assert_true (curve.rotation);
  qn_curve_clear (&curve);
  fixture_clear (&f);
}

/* Earth pressures are the same load where their coefficient is, wherever that comes from. */
static void
test_earth_pressures (void)
{
  static const struct {
    QnEarth earth;
    double coefficient;
  } soils[] = { { QN_EARTH_AT_REST, 0 },
                { QN_EARTH_ACTIVE, 0 },
                { QN_EARTH_GIVEN, 0.5 } };
  Fixture f;
  QnCurve curves[G_N_ELEMENTS (soils)];
  fixture_init_wall (&f, 4, 4);
  QnLoad *load = &f.model.live_loads[0];
  load->kind = QN_LOAD_BACKFILL;
  load->unit_weight = 18e3;
  for (size_t i = 0; i < G_N_ELEMENTS (soils); i++) {
    load->earth = soils[i].earth;
    load->coefficient = soils[i].coefficient;
    load->friction_angle = soils[i].earth == QN_EARTH_GIVEN ? 0 : QN_PI / 6;
    qn_curve_from_result (&curves[i], &f.model, &f.result,
                          qn_result_curve_motion (&f.model, &f.result));
  }
  g_assert_false (qn_curve_shares_axes (&curves[0], &curves[1]));
  g_assert_true (qn_curve_shares_axes (&curves[0], &curves[2])); /* 1 - sin 30° */
  for (size_t i = 0; i < G_N_ELEMENTS (soils); i++)
    qn_curve_clear (&curves[i]);
  fixture_clear (&f);
}

/* Where the dead load has moved the body, the curve begins at 0 and says so. */
static void
test_since_dead_load (void)
{
  Fixture f;
  QnCurve curve;
  fixture_init_wall (&f, 4, 4);
  const QnCurveMotion total = { 3, QN_DOF_UX, false }, since = { 3, QN_DOF_UX, true };
  for (size_t s = 0; s < f.result.step_count; s++)
    *(double *) displacement (&f, s, total) -= 0.25;
  qn_curve_from_result (&curve, &f.model, &f.result, since);
  g_assert_true (curve.since_dead);
  g_assert_cmpfloat (curve.x[0], ==, 0);
  qn_curve_clear (&curve);
  qn_curve_from_result (&curve, &f.model, &f.result, total);
  g_assert_false (curve.since_dead);
  g_assert_cmpfloat (curve.x[0], ==, -0.25);
  qn_curve_clear (&curve);
  fixture_clear (&f);
}

/* Of an analysis in time the displacement over the time; it is shown to its end. */
static void
test_history (void)
{
  Fixture f;
  g_auto (QnCurve) curve;
  fixture_init_wall (&f, 4, 4);
  f.result.history.width = QN_HISTORY_TRACK;
  for (size_t s = 0; s < f.result.step_count; s++) {
    f.result.steps[s].time = 0.5 * (double) s;
    f.result.steps[s].multiplier = 0;
  }
  qn_curve_from_result (&curve, &f.model, &f.result,
                        (QnCurveMotion){ 3, QN_DOF_UX, true });
  g_assert_true (curve.in_time);
  for (size_t s = 0; s < curve.count; s++) {
    g_assert_cmpfloat (curve.x[s], ==, 0.5 * (double) s);
    g_assert_cmpfloat (curve.y[s], ==,
                       qn_result_step_displacements (&f.result, s)[3 * 3 + QN_DOF_UX]);
  }
  qn_curve_cut_runaway (&curve);
  g_assert_false (curve.runs_on);
  fixture_clear (&f);
}

/* The peak is marked where the path passes it, though the path ends below. */
static void
test_limit_of_descending_curve (void)
{
  Fixture f;
  QnCurve curve;
  fixture_init_wall (&f, 4, 4);
  QnStep *steps = f.result.steps;
  g_assert_cmpuint (f.result.step_count, >, 3);
  for (size_t s = 0; s < f.result.step_count; s++)
    steps[s].multiplier = s == 2 ? 0.5 : s < 2 ? 0.1 * (double) s : 0.4;
  f.result.has_first_limit_multiplier = true;
  f.result.first_limit_multiplier = 0.5;
  qn_curve_from_result (&curve, &f.model, &f.result,
                        qn_result_curve_motion (&f.model, &f.result));
  g_assert_cmpint (curve.limit_point, ==, 2);
  qn_curve_clear (&curve);

  f.result.first_limit_multiplier = 0.45; /* between two steps */
  qn_curve_from_result (&curve, &f.model, &f.result,
                        qn_result_curve_motion (&f.model, &f.result));
  g_assert_cmpint (curve.limit_point, ==, 1);
  qn_curve_clear (&curve);

  /* Joints that settle as the load begins are none. */
  f.result.has_collapse_multiplier = true;
  f.result.collapse_multiplier = 0.5;
  f.result.first_limit_multiplier = 1e-5;
  qn_curve_from_result (&curve, &f.model, &f.result,
                        qn_result_curve_motion (&f.model, &f.result));
  g_assert_cmpint (curve.limit_point, ==, -1);
  qn_curve_clear (&curve);
  fixture_clear (&f);
}

static void
export_plot (const QnPlot *plot)
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
    g_assert_true (qn_plot_export (plot, path, &output, &metadata, &error));
    g_assert_no_error (error);
    g_assert_cmpint (g_unlink (path), ==, 0);
  }
  g_rmdir (folder);
}

static char *
dup_svg (const QnPlot *plot)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "c.svg", NULL);
  char *text = NULL;
  QnOutput output;
  QnMetadata metadata;
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  g_assert_true (qn_plot_export (plot, path, &output, &metadata, NULL));
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  g_unlink (path);
  g_rmdir (folder);
  return text;
}

/* What turns has a rotation on its axis, in its unit, over loads and over time. */
static void
test_units_of_motion (void)
{
  double x[2] = { 0, 0.05 }, y[2] = { 0, 0.4 };
  QnCurve curves[2] = { { .x = x, .y = y, .count = 2, .component = "rz" },
                        { .x = x, .y = y, .count = 2, .component = "ux" } };
  for (size_t i = 0; i < 2; i++)
    curves[i].limit_point = curves[i].collapse_point = curves[i].dot = -1;
  curves[0].rotation = true;
  const struct {
    size_t first, count;
    bool in_time;
    const char *label;
  } cases[] = {
    { 0, 1, false, "Rotation rz (mrad)" },
    { 0, 1, true, "Rotation rz (rad)" },
    { 0, 2, false, "Displacement or rotation (mm, mrad)" },
    { 1, 1, false, "Displacement ux (mm)" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnCurve *first = &curves[cases[i].first];
    first->in_time = cases[i].in_time;
    g_autoptr (QnPlot) plot = qn_curve_plot (first, cases[i].count, NULL, 0);
    g_autofree char *svg = dup_svg (plot);
    first->in_time = false;
    g_assert_nonnull (strstr (svg, cases[i].label));
  }
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
    g_autoptr (QnPlot) plot = qn_curve_plot (curves, n, &line, n > 1 ? 1 : 0);
    export_plot (plot);
    plot->x.log = plot->y.log = true;
    export_plot (plot);
    plot->x.log = false;
    export_plot (plot);
  }
}

/* Share of dark pixels in the columns of a picture from x0 to x1 of its width. */
static double
darkness (cairo_surface_t *surface, double x0, double x1)
{
  const int width = cairo_image_surface_get_width (surface);
  const int height = cairo_image_surface_get_height (surface);
  const int stride = cairo_image_surface_get_stride (surface);
  const unsigned char *data = cairo_image_surface_get_data (surface);
  int dark = 0, all = 0;
  for (int y = height / 10; y < 8 * height / 10; y++)
    for (int x = (int) (x0 * width); x < (int) (x1 * width); x++, all++)
      dark += data[y * stride + 4 * x + 1] < 160;
  return (double) dark / all;
}

/* Over decades a power law is a straight line: as much ink at its start as at its end, where
 * linear axes press most points into one corner and leave the left half of the rest bare. */
static void
test_decades (void)
{
  double x[31], y[31];
  for (int i = 0; i <= 30; i++) {
    x[i] = pow (10, i / 10.0);
    y[i] = 1e-4 * pow (x[i], 1.5);
  }
  g_autoptr (QnPlot) plot = qn_plot_new ("x", "y");
  QnMarks marks = { .kind = QN_MARKS_LINE, .x = x, .y = y, .count = 31 };
  const QnFrame frame = { 0, 0, 400, 300 };
  double share[2];
  qn_plot_add (plot, marks);
  marks.kind = QN_MARKS_POINTS;
  qn_plot_add (plot, marks);
  for (int log = 0; log < 2; log++) {
    plot->x.log = plot->y.log = log;
    cairo_surface_t *surface = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 400, 300);
    cairo_t *cr = cairo_create (surface);
    cairo_set_source_rgb (cr, 1, 1, 1);
    cairo_paint (cr);
    qn_plot_draw (plot, cr, 1, &frame, NULL);
    cairo_destroy (cr);
    cairo_surface_flush (surface);
    share[log] = darkness (surface, 0.2, 0.5) / darkness (surface, 0.6, 0.9);
    cairo_surface_destroy (surface);
  }
  g_test_message ("ink left of right: %.2f linear, %.2f logarithmic", share[0], share[1]);
  g_assert_cmpfloat (share[1], >, 0.7);
  g_assert_cmpfloat (share[1], <, 1.4);
  g_assert_cmpfloat (share[0], <, 0.7 * share[1]);
}

/* A curve that stays at its peak while the motion runs away is cut a little beyond the peak; one
 * that descends is not, nor one whose motion stays within reach. */
static void
test_runaway (void)
{
  const struct {
    double x[5], y[5];
    bool cut;
    double end;
  } cases[] = {
    { { 0, 1, 2, 30, 90 }, { 0, 0.5, 1, 1, 1 }, true, 3.2 },
    { { 0, -1, -2, -30, -90 }, { 0, 0.5, 1, 1, 1 }, true, -3.2 },
    { { 0.5, 1, 2, 30, 90 }, { 0, 0.5, 0.998, 1, 1 }, true, 2.9 },
    { { 0, 1, 2, 30, 90 }, { 0, 0.5, 0.98, 0.98, 1 }, true, 3.2 },
    { { 0, 1, 2, 30, 90 }, { 0, 0.5, 1, 0.7, 0.1 }, false, 0 },
    { { 0, 1, 2, 3, 4 }, { 0, 0.5, 1, 1, 1 }, false, 0 },
    { { 0, 1, 2, 3, 90 }, { 0, 0.25, 0.5, 0.75, 1 }, false, 0 },
    { { 0, 0, 0, 0, 90 }, { 0, 0.25, 0.5, 1, 1 }, false, 0 },
    { { 0, 1, 2, 3, 4 }, { 0, 0, 0, 0, 0 }, false, 0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnCurve)
      curve = { .count = 5, .limit_point = 2, .collapse_point = 4, .dot = -1 };
    curve.x = g_memdup2 (cases[i].x, sizeof cases[i].x);
    curve.y = g_memdup2 (cases[i].y, sizeof cases[i].y);
    qn_curve_cut_runaway (&curve);
    g_assert_true (curve.runs_on == cases[i].cut);
    if (cases[i].cut) {
      g_assert_cmpuint (curve.count, ==, 4);
      g_assert_cmpfloat_with_epsilon (curve.x[3], cases[i].end, 1e-12);
      g_assert_cmpint (curve.limit_point, ==, 2);
      g_assert_cmpint (curve.collapse_point, ==, 3);
    } else
      g_assert_cmpuint (curve.count, ==, 5);
  }
}

/* The names of the axes of a small plot stay on its page. */
static void
test_small (void)
{
  const double x[2] = { 0, 1 }, y[2] = { 0, 1 };
  g_autoptr (QnPlot) plot =
    qn_plot_new ("Displacement of the crown since the dead load (mm)",
                 "Share of all cases that have collapsed before this value");
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_LINE, .x = x, .y = y, .count = 2 });
  for (double height = 60; height < 400; height *= 1.2) {
    const double width = 1.3 * height;
    cairo_rectangle_t ink;
    cairo_surface_t *surface =
      cairo_recording_surface_create (CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cr = cairo_create (surface);
    const QnFrame frame = { 0, 0, width, height };
    qn_plot_draw (plot, cr, 1, &frame, NULL);
    cairo_recording_surface_ink_extents (surface, &ink.x, &ink.y, &ink.width,
                                         &ink.height);
    g_assert_cmpfloat (ink.x, >=, -1);
    g_assert_cmpfloat (ink.y, >=, -1);
    g_assert_cmpfloat (ink.x + ink.width, <=, width + 1);
    g_assert_cmpfloat (ink.y + ink.height, <=, height + 1);
    cairo_destroy (cr);
    cairo_surface_destroy (surface);
  }
}

static void
test_reference_line (void)
{
  static const struct {
    const char *text;
    double y; /* NaN: it is none */
    const char *label;
  } cases[] = { { "0.36", 0.36, NULL },
                { "-1e-2=a=b", -0.01, "a=b" },
                { "1=", 1, "" },
                { "", (double) NAN, NULL },
                { "=a", (double) NAN, NULL },
                { "1 m", (double) NAN, NULL },
                { "inf=a", (double) NAN, NULL } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnReferenceLine line;
    bool known = isfinite (cases[i].y);
    g_assert_cmpint (qn_reference_line_parse (cases[i].text, &line), ==, known);
    g_assert_true (!known || line.y == cases[i].y);
    if (known)
      g_assert_cmpstr (line.label, ==, cases[i].label);
  }
}

QN_TESTS
{
  g_test_add_func ("/render/curve-plot/result", test_curve_of_result);
  g_test_add_func ("/render/curve-plot/earth-pressures", test_earth_pressures);
  g_test_add_func ("/render/curve-plot/since-dead-load", test_since_dead_load);
  g_test_add_func ("/render/curve-plot/limit-of-descending-curve",
                   test_limit_of_descending_curve);
  g_test_add_func ("/render/curve-plot/runaway", test_runaway);
  g_test_add_func ("/render/curve-plot/units", test_units_of_motion);
  g_test_add_func ("/render/curve-plot/odd-data", test_odd_data);
  g_test_add_func ("/render/curve-plot/decades", test_decades);
  g_test_add_func ("/render/curve-plot/history", test_history);
  g_test_add_func ("/render/curve-plot/small", test_small);
  g_test_add_func ("/render/curve-plot/reference-line", test_reference_line);
}
