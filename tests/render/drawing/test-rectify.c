/* Photos of a plane, made by a camera whose place is known, seen from the front again. */
#include "render/drawing/rectify.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* A pinhole camera that looks at the plane z = 0 from `eye`, turned about two axes: a place on the
 * plane, m, to one on the photo. Written by the geometry of rays, not by the formulas under test. */
static QnVec2
photograph (double turn, double tilt, QnVec2 at)
{
  double x = at.x - 1.2, y = at.y - 0.8, z = 6;
  double across = cos (turn) * x - sin (turn) * z,
         ahead = sin (turn) * x + cos (turn) * z;
  double up = cos (tilt) * y - sin (tilt) * ahead;
  double depth = sin (tilt) * y + cos (tilt) * ahead;
  return qn_vec2 (0.5 + across / depth, 0.5 + up / depth);
}

static void
test_camera (void)
{
  for (int i = 0; i < 25; i++) {
    double turn = 0.15 * (i % 5 - 2), tilt = 0.12 * (i / 5 - 2);
    const QnVec2 corners[4] = { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } };
    QnVec2 points[4], given[4];
    for (int k = 0; k < 4; k++) {
      points[k] = photograph (turn, tilt, corners[k]);
      given[(3 * k + i) % 4] = points[k];
    }
    g_assert_true (qn_rectify_sort (given));
    for (int k = 0; k < 4; k++) {
      g_assert_cmpfloat (given[k].x, ==, points[k].x);
      g_assert_cmpfloat (given[k].y, ==, points[k].y);
    }
    for (int k = 0; k < 20; k++) {
      QnVec2 plane = { 0.37 * (k % 5) - 0.3, 0.41 * (k / 5.0) - 0.2 }, photo, back;
      QnVec2 there = photograph (turn, tilt, qn_vec2 (3 * plane.x, 2 * plane.y));
      g_assert_true (qn_rectify_to_photo (points, plane, &photo));
      g_assert_cmpfloat_with_epsilon (photo.x, there.x, 1e-12);
      g_assert_cmpfloat_with_epsilon (photo.y, there.y, 1e-12);
      g_assert_true (qn_rectify_to_plane (points, photo, &back));
      g_assert_cmpfloat_with_epsilon (back.x, plane.x, 1e-11);
      g_assert_cmpfloat_with_epsilon (back.y, plane.y, 1e-11);
    }
  }
}

/* A chessboard of 6 by 4 fields, photographed at an angle, has even fields again. */
static void
test_picture (void)
{
  enum { SIZE = 600 };
  const QnVec2 corners[4] = { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } };
  QnVec2 points[4];
  for (int k = 0; k < 4; k++)
    points[k] = photograph (0.2, -0.1, corners[k]);
  cairo_surface_t *photo = cairo_image_surface_create (CAIRO_FORMAT_ARGB32, SIZE, SIZE);
  cairo_t *cr = cairo_create (photo);
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  cairo_set_source_rgb (cr, 0, 0, 0);
  for (int i = 0; i < 24; i++) {
    int row = i / 6;
    double x = 0.5 * (i % 6), y = 0.5 * row;
    if ((i % 6 + i / 6) % 2 == 1)
      continue;
    for (int k = 0; k < 4; k++) {
      QnVec2 at = photograph (
        0.2, -0.1, qn_vec2 (x + 0.5 * corners[k].x / 3, y + 0.5 * corners[k].y / 2));
      cairo_line_to (cr, SIZE * at.x, SIZE * (1 - at.y));
    }
    cairo_close_path (cr);
    cairo_fill (cr);
  }
  cairo_destroy (cr);

  QnBox seen;
  cairo_surface_t *front = qn_rectify (photo, points, QN_RECTIFY_MARGIN, &seen);
  g_assert_nonnull (front);
  g_assert_cmpfloat (seen.min.x, <=, 0);
  g_assert_cmpfloat (seen.max.y, >=, 1);
  g_assert_cmpfloat (seen.min.x, >=, -QN_RECTIFY_MARGIN);
  int columns = cairo_image_surface_get_width (front);
  int rows = cairo_image_surface_get_height (front);
  int stride = cairo_image_surface_get_stride (front);
  const guint8 *data = cairo_image_surface_get_data (front);
  for (int i = 0; i < 24; i++) {
    QnVec2 middle = { (i % 6 + 0.5) / 6, (i / 6 + 0.5) / 4.0 };
    int x = (int) ((middle.x - seen.min.x) / (seen.max.x - seen.min.x) * columns);
    int y = (int) ((seen.max.y - middle.y) / (seen.max.y - seen.min.y) * rows);
    g_assert_cmpuint (data[y * stride + 4 * x], ==, (i % 6 + i / 6) % 2 == 0 ? 0 : 255);
  }
  cairo_surface_destroy (front);
  front = qn_rectify (photo, points, 0, &seen);
  g_assert_cmpint (cairo_image_surface_get_width (front), <, columns);
  g_assert_true (seen.min.x == 0 && seen.min.y == 0);
  g_assert_true (seen.max.x == 1 && seen.max.y == 1);
  cairo_surface_destroy (front);
  cairo_surface_destroy (photo);
}

QN_TESTS
{
  g_test_add_func ("/render/rectify/camera", test_camera);
  g_test_add_func ("/render/rectify/picture", test_picture);
}
