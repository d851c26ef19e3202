#include "render/drawing/scene-fit.h"
#include "render/drawing/text.h"
#include "support/room.h"

#include <glib.h>

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
  g_test_add_func ("/render/scene-fit/labels", test_labels_fit);
}
