#include "render/drawing/camera.h"
#include "support/room.h"

#include <glib.h>

static QnCamera
camera_200_by_100 (void)
{
  return (
    QnCamera){ .scale = 1, .unit = 1, .x = 10, .y = 20, .width = 200, .height = 100 };
}

static void
assert_point (QnVec2 p, double x, double y)
{
  g_assert_cmpfloat_with_epsilon (p.x, x, 1e-9);
  g_assert_cmpfloat_with_epsilon (p.y, y, 1e-9);
}

static void
test_fit (void)
{
  QnCamera camera = camera_200_by_100 ();
  qn_camera_fit (&camera, (QnBox){ { 0, 0 }, { 4, 1 } }, 0);
  g_assert_cmpfloat (camera.scale, ==, 50);
  assert_point (qn_camera_to_screen (&camera, qn_vec2 (0, 0)), 10, 95);
  assert_point (qn_camera_to_screen (&camera, qn_vec2 (4, 1)), 210, 45);

  qn_camera_fit (&camera, (QnBox){ { 0, 0 }, { 1, 1 } }, 10);
  g_assert_cmpfloat (camera.scale, ==, 80);
  qn_camera_fit (&camera, (QnBox){ { 3, 3 }, { 3, 3 } }, 0);
  g_assert_cmpfloat (camera.scale, ==, 200);
  qn_camera_fit (&camera, QN_BOX_EMPTY, 0);
  g_assert_true (isfinite (camera.scale) && isfinite (camera.center.x));
}

static void
test_there_and_back (void)
{
  QnCamera camera = camera_200_by_100 ();
  qn_camera_fit (&camera, (QnBox){ { 1e6, -2 }, { 1e6 + 3, 7 } }, 4);
  QnVec2 p = { 1e6 + 1.25, 3.5 };
  QnVec2 back = qn_camera_to_model (&camera, qn_camera_to_screen (&camera, p));
  g_assert_cmpfloat_with_epsilon (back.x, p.x, 1e-8);
  g_assert_cmpfloat_with_epsilon (back.y, p.y, 1e-8);
}

static void
test_zoom_keeps_the_point (void)
{
  QnCamera camera = camera_200_by_100 ();
  qn_camera_fit (&camera, (QnBox){ { 0, 0 }, { 4, 1 } }, 0);
  QnVec2 s = { 37, 81 }, before = qn_camera_to_model (&camera, s);
  qn_camera_zoom_at (&camera, s, 3.5);
  assert_point (qn_camera_to_model (&camera, s), before.x, before.y);
  g_assert_cmpfloat (camera.scale, ==, 175);
  qn_camera_pan (&camera, qn_vec2 (5, -7));
  assert_point (qn_camera_to_screen (&camera, before), s.x + 5, s.y - 7);
}

QN_TESTS
{
  g_test_add_func ("/render/camera/fit", test_fit);
  g_test_add_func ("/render/camera/there-and-back", test_there_and_back);
  g_test_add_func ("/render/camera/zoom", test_zoom_keeps_the_point);
}
