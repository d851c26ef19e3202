#include "render/backend/draw-cairo.h"
#include "support/room.h"

#include <glib.h>

static const QnColor black = { 0, 0, 0, 255 };

/* What the labels of a scene cover, px, with a point to the px and 100 px to the metre. */
static cairo_rectangle_t
extents_of (QnScene *scene)
{
  cairo_surface_t *page =
    cairo_recording_surface_create (CAIRO_CONTENT_COLOR_ALPHA, NULL);
  cairo_t *cr = cairo_create (page);
  const QnCamera camera = {
    .width = 400, .height = 300, .scale = 100, .unit = 1, .center = { 2.0, 1.5 }
  };
  cairo_rectangle_t box;
  qn_scene_finish (scene);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, cr);
  cairo_recording_surface_ink_extents (page, &box.x, &box.y, &box.width, &box.height);
  cairo_destroy (cr);
  cairo_surface_destroy (page);
  qn_scene_free (scene);
  return box;
}

/* Dashes of 4 pt and gaps of 2.5 pt, in a picture with two px to the point. */
static void
test_dashes (void)
{
  cairo_surface_t *page = cairo_image_surface_create (CAIRO_FORMAT_A8, 130, 20);
  cairo_t *cr = cairo_create (page);
  const QnCamera camera = {
    .width = 130, .height = 20, .scale = 1, .unit = 2, .center = { 65, 10 }
  };
  const QnVec2 line[] = { { 0, 10 }, { 130, 10 } };
  QnScene *scene = qn_scene_new ();
  qn_scene_stroke (scene, QN_LAYER_BLOCKS, line, 2, false, 4, black)->dashed = true;
  qn_scene_finish (scene);
  cairo_set_antialias (cr, CAIRO_ANTIALIAS_NONE);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, cr);
  cairo_surface_flush (page);
  const guchar *row =
    cairo_image_surface_get_data (page) + 10 * cairo_image_surface_get_stride (page);
  for (int x = 0; x < 130; x++)
    g_assert_cmpint (row[x] > 0, ==, x % 13 < 8);
  qn_scene_free (scene);
  cairo_destroy (cr);
  cairo_surface_destroy (page);
}

/* Labels of loads at one place, then of a joint, which may be left out. */
static QnScene *
create_labels (int count, int optional, double angle)
{
  QnScene *scene = qn_scene_new ();
  for (int i = 0; i < count + optional; i++) {
    QnCommand *label =
      qn_scene_text (scene, QN_LAYER_LABELS, qn_vec2 (2.0, 1.5), 10, "18 kPa", black);
    label->angle = (float) angle;
    label->extent = i < count ? 0 : 1;
  }
  return scene;
}

/* Labels at one place stand one above the other, and those of joints give way. */
static void
test_labels_keep_clear (void)
{
  cairo_rectangle_t one = extents_of (create_labels (1, 0, 0));
  cairo_rectangle_t three = extents_of (create_labels (3, 0, 0));
  cairo_rectangle_t more = extents_of (create_labels (3, 2, 0));
  g_assert_cmpfloat (one.height, >, 5.0);
  g_assert_cmpfloat (three.height, >, 2.7 * one.height);
  g_assert_cmpfloat (three.width, ==, one.width);
  g_assert_cmpfloat (more.height, ==, three.height);
}

/* Labels along upright lines move sideways. */
static void
test_upright_labels (void)
{
  cairo_rectangle_t one = extents_of (create_labels (1, 0, G_PI_2));
  cairo_rectangle_t two = extents_of (create_labels (2, 0, G_PI_2));
  g_assert_cmpfloat (one.height, >, one.width);
  g_assert_cmpfloat (two.width, >, 1.8 * one.width);
  g_assert_cmpfloat (two.height, ==, one.height);
}

/* Numbers of joints at one place stand around it, and none covers another. */
static void
test_numbers_of_joints (void)
{
  enum { COUNT = 30 };
  QnScene *scene = create_labels (COUNT, 0, 0), *first = create_labels (1, 0, 0);
  for (guint i = 0; i < COUNT; i++)
    qn_command_set_pick (&g_array_index (scene->commands, QnCommand, i), QN_PICK_FACE, 0);
  cairo_rectangle_t one = extents_of (first), all = extents_of (scene);
  g_assert_cmpfloat (all.width * all.height, >, 0.75 * COUNT * one.width * one.height);
  g_assert_cmpfloat (all.width, >, 2.5 * one.width);
  g_assert_cmpfloat (all.height, >, 4 * one.height);
}

/* A label whose place arrows of a load cross stands above them, but for that of loads in weights, which
 * lie in blocks as names do. */
static void
test_labels_beside_loads (void)
{
  for (int in_weights = 0; in_weights < 2; in_weights++) {
    const QnVec2 from = { 1.9, 1.7 }, to = { 2.1, 1.4 };
    QnScene *scene = qn_scene_new (), *with_label = create_labels (1, 0, 0);
    for (int i = 0; i < 2; i++)
      qn_scene_arrow (i == 0 ? scene : with_label, QN_LAYER_LOADS, from, to, 1, black,
                      QN_PICK_NOTHING, 0, in_weights);
    cairo_rectangle_t load = extents_of (scene), both = extents_of (with_label);
    g_assert_cmpfloat (load.height, >, 20);
    if (in_weights)
      g_assert_cmpfloat (both.height, ==, load.height);
    else
      g_assert_cmpfloat (both.height, >, load.height + 5);
  }
}

/* A label beside a place through which a line of force runs stands in a quarter that it leaves free;
 * without one it is left out. Thin lines do not matter. */
static void
test_labels_beside_forces (void)
{
  const QnVec2 at = { 2.0, 1.5 };
  static const struct {
    QnVec2 lines[3]; /* from the place to there and as far to the other side */
    double width;
    int side,
      above; /* where the label stands: 1 right, above; -1; 0 between; 2: nowhere */
  } cases[] = {
    { { { 0 } }, 1.5, 1, 0 },       { { { 0, 1 } }, 1.5, 1, 0 },
    { { { 1, 0 } }, 1.5, 1, 1 },    { { { 1, 0 } }, 0.5, 1, 0 },
    { { { 1, 0.3 } }, 1.5, 1, -1 }, { { { 1, 0.3 }, { 1, -0.3 } }, 1.5, 2, 2 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnScene *scene = qn_scene_new ();
    for (int k = 0; k < 2; k++) {
      const QnVec2 d = cases[i].lines[k];
      const QnVec2 line[2] = { qn_vec2_add (at, d), qn_vec2_sub (at, d) };
      if (qn_vec2_length (d) > 0) /* without colour: the label alone is measured */
        qn_scene_stroke (scene, QN_LAYER_FORCES, line, 2, false, cases[i].width,
                         (QnColor){ 0, 0, 0, 0 });
    }
    QnCommand *label = qn_scene_text (scene, QN_LAYER_LABELS, at, 10, "2.45 kN", black);
    label->align_x = -0.2F;
    label->extent = 1;
    cairo_rectangle_t box = extents_of (scene);
    if (cases[i].side == 2) {
      g_assert_cmpfloat (box.width, ==, 0);
      continue;
    }
    g_assert_cmpfloat (box.width, >, 20);
    double x = box.x + box.width / 2 - 200, y = 150 - (box.y + box.height / 2);
    g_assert_cmpint (x > 0 ? 1 : -1, ==, cases[i].side);
    g_assert_cmpint (y > 3 ? 1 : y < -3 ? -1 : 0, ==, cases[i].above);
  }
}

QN_TESTS
{
  g_test_add_func ("/render/draw-cairo/dashes", test_dashes);
  g_test_add_func ("/render/draw-cairo/labels", test_labels_keep_clear);
  g_test_add_func ("/render/draw-cairo/upright-labels", test_upright_labels);
  g_test_add_func ("/render/draw-cairo/numbers-of-joints", test_numbers_of_joints);
  g_test_add_func ("/render/draw-cairo/labels-beside-loads", test_labels_beside_loads);
  g_test_add_func ("/render/draw-cairo/labels-beside-forces", test_labels_beside_forces);
}
