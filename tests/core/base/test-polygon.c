#include "core/base/polygon.h"
#include "support/room.h"

#include <glib.h>

#define CLOSE(a, b, tolerance) g_assert_cmpfloat_with_epsilon ((a), (b), (tolerance))

static const QnVec2 l_shape[] = { { 0, 0 }, { 2, 0 }, { 2, 1 },
                                  { 1, 1 }, { 1, 3 }, { 0, 3 } };

static void
test_rectangle (void)
{
  const QnVec2 v[] = { { 1, 2 }, { 5, 2 }, { 5, 5 }, { 1, 5 } };
  QnPolygonProperties p = qn_polygon_properties (v, 4);
  CLOSE (p.area, 12, 1e-14);
  CLOSE (p.centroid.x, 3, 1e-14);
  CLOSE (p.centroid.y, 3.5, 1e-14);
  CLOSE (p.polar_moment, 4 * 3 * (16 + 9) / 12.0, 1e-13); /* bh (b2 + h2) / 12 */
}

/* Two rectangles, 2 x 1 and 1 x 2, by the theorem of parallel axes. */
static void
test_l_shape (void)
{
  QnPolygonProperties p = qn_polygon_properties (l_shape, 6);
  CLOSE (p.area, 4, 1e-14);
  CLOSE (p.centroid.x, (2 * 1 + 2 * 0.5) / 4, 1e-14);
  CLOSE (p.centroid.y, (2 * 0.5 + 2 * 2.0) / 4, 1e-14);
  double own = 2.0 * (2 * (4 + 1) / 12.0);
  double arms = 2 * (0.25 * 0.25 + 0.75 * 0.75) * 2;
  CLOSE (p.polar_moment, own + arms, 1e-13);
}

static void
test_translation_costs_nothing (void)
{
  QnVec2 v[6];
  for (int i = 0; i < 6; i++)
    v[i] = qn_vec2 (l_shape[i].x + 1048576.0, l_shape[i].y - 2097152.0);
  QnPolygonProperties here = qn_polygon_properties (l_shape, 6);
  QnPolygonProperties there = qn_polygon_properties (v, 6);
  g_assert_cmpfloat (here.area, ==, there.area);
  g_assert_cmpfloat (here.polar_moment, ==, there.polar_moment);
  CLOSE (there.centroid.x - 1048576.0, here.centroid.x, 1e-9);
  CLOSE (there.centroid.y + 2097152.0, here.centroid.y, 1e-9);
}

static void
test_reverse (void)
{
  QnVec2 v[6];
  for (int i = 0; i < 6; i++)
    v[i] = l_shape[i];
  qn_polygon_reverse (v, 6);
  g_assert_cmpfloat (v[0].x, ==, 0);
  g_assert_cmpfloat (v[1].y, ==, 3);
  QnPolygonProperties p = qn_polygon_properties (v, 6);
  CLOSE (p.area, -4, 1e-14);
  CLOSE (p.centroid.x, 0.75, 1e-14);
  g_assert_cmpfloat (p.polar_moment, <, 0);
}

static void
test_depth (void)
{
  CLOSE (qn_polygon_depth (l_shape, 6, qn_vec2 (0.4, 2)), 0.4, 1e-15);
  CLOSE (qn_polygon_depth (l_shape, 6, qn_vec2 (1.5, 1.25)), -0.25, 1e-15);
  CLOSE (qn_polygon_depth (l_shape, 6, qn_vec2 (5, 5)), -sqrt (20), 1e-14);
  CLOSE (qn_polygon_depth (l_shape, 6, qn_vec2 (1, 2)), 0, 1e-15);
  /* A ray through vertices counts each crossing once. */
  g_assert_cmpfloat (qn_polygon_depth (l_shape, 6, qn_vec2 (-1, 1)), <, 0);
  g_assert_cmpfloat (qn_polygon_depth (l_shape, 6, qn_vec2 (0.5, 1)), >, 0);
}

static void
test_inner_point (void)
{
  g_assert_cmpfloat (qn_polygon_depth (l_shape, 6, qn_polygon_inner_point (l_shape, 6)),
                     >, 0.1);
  /* A spike reaches into the triangle at the lowest corner. */
  const QnVec2 spiked[] = {
    { 0, 0 }, { 4, 1 }, { 4, 4 }, { 0.5, 0.5 }, { 1, 4 }, { 0, 4 }
  };
  g_assert_cmpfloat (qn_polygon_depth (spiked, 6, qn_polygon_inner_point (spiked, 6)), >,
                     0);
}

QN_TESTS
{
  g_test_add_func ("/polygon/properties/rectangle", test_rectangle);
  g_test_add_func ("/polygon/properties/l-shape", test_l_shape);
  g_test_add_func ("/polygon/properties/translation", test_translation_costs_nothing);
  g_test_add_func ("/polygon/reverse", test_reverse);
  g_test_add_func ("/polygon/depth", test_depth);
  g_test_add_func ("/polygon/inner-point", test_inner_point);
}
