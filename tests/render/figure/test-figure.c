#include "render/drawing/text.h"
#include "render/figure/figure-furniture.h"
#include "render/figure/figure.h"
#include "render/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

typedef struct Picture {
  const QnFigure *figure;
  QnCamera camera;
} Picture;

static bool
draw (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  Picture *picture = data;
  QnFrame frame = { 10, 10, page->width - 20, page->height - 20 };
  return qn_figure_draw (picture->figure, cr, page, &frame, &picture->camera, error);
}

/* Whether every pixel of the page's rim is white: nothing was clipped by the page. */
static bool
rim_is_white (cairo_surface_t *surface)
{
  int width = cairo_image_surface_get_width (surface);
  int height = cairo_image_surface_get_height (surface);
  int stride = cairo_image_surface_get_stride (surface);
  const guint8 *data = cairo_image_surface_get_data (surface);
  for (int y = 0; y < height; y++) {
    const guint32 *row = (const guint32 *) (const void *) (data + y * stride);
    for (int x = 0; x < width; x++) {
      bool rim = x < 4 || y < 4 || x >= width - 4 || y >= height - 4;
      if (rim && (row[x] & 0xffffff) != 0xffffff)
        return false;
    }
  }
  return true;
}

static void
check_figure (const QnFigure *figure, int width, int height)
{
  GError *error = NULL;
  QnOutput output;
  QnPage page;
  qn_output_init (&output);
  output.width = width;
  output.height = height;
  g_assert_true (qn_output_page (&output, &page, &error));
  cairo_surface_t *surface =
    cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height);
  cairo_t *cr = cairo_create (surface);
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  Picture picture = { .figure = figure };
  g_assert_true (draw (cr, &page, &picture, &error));
  g_assert_no_error (error);
  g_assert_cmpint (cairo_status (cr), ==, CAIRO_STATUS_SUCCESS);
  cairo_surface_flush (surface);
  g_assert_true (rim_is_white (surface));

  /* The structure lies inside its viewport with everything drawn of it. */
  QnViewOptions options = figure->options;
  g_autoptr (QnScene) scene =
    qn_scene_build (figure->model, figure->contacts, figure->result, &options, &error);
  QnVec2 low = qn_camera_to_screen (&picture.camera, scene->box.min);
  QnVec2 high = qn_camera_to_screen (&picture.camera, scene->box.max);
  g_assert_cmpfloat (low.x, >=, picture.camera.x - 0.01);
  g_assert_cmpfloat (high.x, <=, picture.camera.x + picture.camera.width + 0.01);
  g_assert_cmpfloat (high.y, >=, picture.camera.y - 0.01);
  g_assert_cmpfloat (low.y, <=, picture.camera.y + picture.camera.height + 0.01);
  cairo_destroy (cr);
  cairo_surface_destroy (surface);
}

static void
test_nothing_clipped (void)
{
  static const int shapes[][2] = { { 5, 11 }, { 40, 2 }, { 2, 40 }, { 1, 1 } };
  static const int pages[][2] = { { 800, 600 }, { 300, 900 }, { 900, 300 } };
  for (size_t s = 0; s < G_N_ELEMENTS (shapes); s++) {
    Fixture f;
    fixture_init_wall (&f, shapes[s][0], shapes[s][1]);
    for (int view = 0; view < QN_VIEW_DIAGRAMS; view++) {
      for (size_t p = 0; p < G_N_ELEMENTS (pages); p++) {
        QnFigure figure;
        qn_figure_init (&figure, &f.model, &f.contacts, &f.result, (QnView) view);
        figure.options.dimensions = true;
        figure.options.loads = true;
        check_figure (&figure, pages[p][0], pages[p][1]);
      }
    }
    fixture_clear (&f);
  }
}

static double
multiplier_of (const QnFigure *figure)
{
  return qn_figure_metadata (figure, &(QnMetadata){ .multiplier = NAN }).multiplier;
}

static void
test_multiplier (void)
{
  Fixture f;
  QnFigure figure;
  fixture_init_wall (&f, 4, 4);
  qn_figure_init (&figure, &f.model, &f.contacts, &f.result, QN_VIEW_MODEL);
  g_assert_true (isnan (multiplier_of (&figure)));
  figure.options.view = QN_VIEW_MECHANISM;
  g_assert_cmpfloat (multiplier_of (&figure), ==, 0.3558);
  figure.options.view = QN_VIEW_DEFORMED;
  figure.options.step = 1;
  g_assert_cmpfloat_with_epsilon (multiplier_of (&figure), 0.3558 / 3, 1e-12);
  fixture_clear (&f);
}

/* What a result without a collapse multiplier means stands beside its picture. */
static void
test_without_collapse (void)
{
  Fixture f;
  QnFigure figure;
  fixture_init_wall (&f, 4, 4);
  qn_figure_init (&figure, &f.model, &f.contacts, &f.result, QN_VIEW_MECHANISM);
  g_autoptr (QnScene) scene =
    qn_scene_build (&f.model, &f.contacts, &f.result, &figure.options, NULL);
  f.result.outcome = QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  g_autofree char *unstable = qn_figure_dup_caption (&figure, scene, true);
  g_assert_true (g_str_has_suffix (unstable, " · no equilibrium under the dead load"));
  f.result.outcome = QN_OUTCOME_UNBOUNDED;
  figure.options.view = QN_VIEW_FORCES;
  g_autofree char *unbounded = qn_figure_dup_caption (&figure, scene, false);
  g_assert_true (
    g_str_has_suffix (unbounded, "any multiple of the live load is carried"));
  figure.options.step = 0;
  g_autofree char *first = qn_figure_dup_caption (&figure, scene, false);
  g_assert_null (strstr (first, "any multiple"));
  fixture_clear (&f);
}

/* A mechanism that was not settled is told from one that was. */
static void
test_uncertain (void)
{
  Fixture f;
  QnFigure figure;
  fixture_init_wall (&f, 4, 4);
  qn_figure_init (&figure, &f.model, &f.contacts, &f.result, QN_VIEW_MECHANISM);
  g_autoptr (QnScene) scene =
    qn_scene_build (&f.model, &f.contacts, &f.result, &figure.options, NULL);
  g_autofree char *settled = qn_figure_dup_caption (&figure, scene, true);
  f.result.mechanism_uncertain = true;
  g_autofree char *uncertain = qn_figure_dup_caption (&figure, scene, true);
  g_autofree char *expected = g_strconcat (settled, " · last motion", NULL);
  g_assert_cmpstr (uncertain, ==, expected);
  figure.options.view = QN_VIEW_DEFORMED;
  g_autofree char *deformed = qn_figure_dup_caption (&figure, scene, true);
  g_assert_null (strstr (deformed, "last motion"));
  fixture_clear (&f);
}

/* An analysis in time is told by its time, not by a multiplier that it does not have. */
static void
test_time (void)
{
  Fixture f;
  QnFigure figure;
  fixture_init_wall (&f, 4, 4);
  f.result.history.width = QN_HISTORY_TRACK;
  for (size_t s = 0; s < f.result.step_count; s++)
    f.result.steps[s].time = 0.25 * (double) s;
  qn_figure_init (&figure, &f.model, &f.contacts, &f.result, QN_VIEW_DEFORMED);
  figure.options.step = 1;
  g_autoptr (QnScene) scene =
    qn_scene_build (&f.model, &f.contacts, &f.result, &figure.options, NULL);
  g_autofree char *caption = qn_figure_dup_caption (&figure, scene, false);
  g_assert_nonnull (strstr (caption, "t = 0.250 s"));
  g_assert_null (strstr (caption, "multiplier"));
  g_assert_null (strstr (caption, "overturned"));
  g_assert_true (isnan (multiplier_of (&figure)));
  f.result.steps[1].event = QN_EVENT_COLLAPSE;
  g_autofree char *last = qn_figure_dup_caption (&figure, scene, true);
  g_assert_nonnull (strstr (last, "overturned"));
  fixture_clear (&f);
}

static void
test_failed_export_leaves_nothing (void)
{
  Fixture f;
  QnFigure figure;
  QnOutput output;
  QnMetadata metadata;
  GError *error = NULL;
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "a.png", NULL);
  fixture_init_wall (&f, 2, 2);
  qn_figure_init (&figure, &f.model, &f.contacts, NULL, QN_VIEW_MECHANISM);
  qn_output_init (&output);
  qn_metadata_init (&metadata);
  g_assert_false (qn_figure_export (&figure, path, &output, &metadata, &error));
  g_assert_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE);
  g_assert_false (g_file_test (path, G_FILE_TEST_EXISTS));
  g_clear_error (&error);
  fixture_clear (&f);
  g_assert_cmpint (g_rmdir (folder), ==, 0);
}

/* What rounds to nothing has no sign. */
static void
test_label_numbers (void)
{
  static const struct {
    const char *format;
    double value;
    const char *text;
  } cases[] = {
    { "%.4f", -1e-9, "0.0000" },
    { "%.4f", -0.00006, "-0.0001" },
    { "%g", -0.0, "0" },
    { "%.5g", 12.5, "12.5" },
    { "%g", -(double) INFINITY, "-inf" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = qn_label_number (cases[i].format, cases[i].value);
    g_assert_cmpstr (text, ==, cases[i].text);
  }
}

/* A legend that is narrow wraps between words: a single word is not broken. */
static void
test_narrow_legend (void)
{
  g_autoptr (QnScene) scene = qn_scene_new ();
  const QnColor black = { 0, 0, 0, 255 };
  QnFurniture furniture;
  qn_scene_legend (scene, QN_COMMAND_STROKE, 1.5, black, "undeformed");
  qn_scene_legend (scene, QN_COMMAND_STROKE, 1.5, black, "line of thrust");
  qn_scene_legend (scene, QN_COMMAND_STROKE, 1.5, black, "live load: weight × (1, 0)");
  cairo_surface_t *surface = cairo_recording_surface_create (CAIRO_CONTENT_COLOR, NULL);
  cairo_t *cr = cairo_create (surface);
  qn_furniture_init (&furniture, scene, cr, 1, 1000, false);
  double row = furniture.heights[0], width = furniture.widths[0];
  g_assert_cmpfloat (furniture.heights[1], ==, row);
  qn_furniture_clear (&furniture);
  qn_furniture_init (&furniture, scene, cr, 1, 60, false);
  g_assert_cmpfloat (furniture.heights[0], ==, row);
  g_assert_cmpfloat_with_epsilon (furniture.widths[0], width, 1e-6);
  g_assert_cmpfloat (furniture.heights[1], >, row);
  g_assert_cmpfloat (furniture.widths[1], <=, 60);
  /* Three lines, none of them cut. */
  g_assert_cmpfloat (furniture.heights[2], >, 1.3 * furniture.heights[1]);
  qn_furniture_clear (&furniture);
  cairo_destroy (cr);
  cairo_surface_destroy (surface);
}

/* A label that begins at the edge of what is drawn ends at the edge of the page, level to the right and
 * upright above. */
static void
test_labels_fit (void)
{
  const QnVec2 square[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  cairo_surface_t *page =
    cairo_recording_surface_create (CAIRO_CONTENT_COLOR_ALPHA, NULL);
  cairo_t *cr = cairo_create (page);
  for (int upright = 0; upright < 2; upright++) {
    double w, h;
    const QnVec2 at = upright ? qn_vec2 (0.5, 1) : qn_vec2 (1, 0.5);
    QnCamera camera = { .width = 200, .height = 200, .unit = 2 };
    QnScene *scene = qn_scene_new ();
    qn_scene_fill (scene, QN_LAYER_BLOCKS, square, 4, qn_rgb (0));
    QnCommand *label =
      qn_scene_text (scene, QN_LAYER_LABELS, at, 10, "18 kPa", qn_rgb (0));
    label->angle = upright ? (float) G_PI_2 : 0;
    label->align_x = 0;
    label->align_y = 0.5f;
    qn_scene_finish (scene);
    qn_scene_fit (&camera, scene, cr, 0);
    qn_text_measure (cr, &(QnTextStyle){ .size = 20 }, "18 kPa", &w, &h);
    QnVec2 s = qn_camera_to_screen (&camera, at);
    g_assert_cmpfloat (w, >, 2 * h);
    g_assert_cmpfloat_with_epsilon (upright ? s.y : 200 - s.x, w, 1e-6);
    g_assert_cmpfloat_with_epsilon (camera.scale, 200 - w, 1e-6);
    qn_scene_free (scene);
  }
  cairo_destroy (cr);
  cairo_surface_destroy (page);
}

QN_TESTS
{
  g_test_add_func ("/render/figure/nothing-clipped", test_nothing_clipped);
  g_test_add_func ("/render/figure/multiplier", test_multiplier);
  g_test_add_func ("/render/figure/without-collapse", test_without_collapse);
  g_test_add_func ("/render/figure/uncertain", test_uncertain);
  g_test_add_func ("/render/figure/failed-export", test_failed_export_leaves_nothing);
  g_test_add_func ("/render/figure/label-numbers", test_label_numbers);
  g_test_add_func ("/render/figure/time", test_time);
  g_test_add_func ("/render/figure/narrow-legend", test_narrow_legend);
  g_test_add_func ("/render/figure/labels-fit", test_labels_fit);
}
