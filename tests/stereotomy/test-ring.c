#include "stereotomy/ring.h"
#include "support/room.h"

#include <glib.h>

static void
test_measures (void)
{
  /* An L of three unit squares, far from the origin. */
  const QnVec2 corners[] = { { 1e6, 1e6 },         { 1e6 + 2, 1e6 },
                             { 1e6 + 2, 1e6 + 1 }, { 1e6 + 1, 1e6 + 1 },
                             { 1e6 + 1, 1e6 + 2 }, { 1e6, 1e6 + 2 } };
  g_auto (QnRing) ring = qn_ring_of (corners, 6);
  g_assert_cmpfloat (qn_ring_area (&ring), ==, 3);
  g_assert_cmpfloat (qn_ring_perimeter (&ring), ==, 8);
  g_assert_cmpfloat_with_epsilon (qn_ring_centroid (&ring).x, 1e6 + 5. / 6, 1e-9);
  qn_ring_orient (&ring);
  g_assert_cmpfloat (ring.points[1].x, ==, 1e6 + 2);
}

static void
test_orient_and_normalize (void)
{
  const QnVec2 clockwise[] = { { 1, 1 }, { 1, 0 }, { 0, 0 }, { 0, 1 } };
  g_auto (QnRing) ring = qn_ring_of (clockwise, 4);
  qn_ring_orient (&ring);
  g_assert_cmpfloat (qn_ring_area (&ring), ==, 1);
  qn_ring_normalize (&ring);
  const QnVec2 expected[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (int i = 0; i < 4; i++) {
    g_assert_cmpfloat (ring.points[i].x, ==, expected[i].x);
    g_assert_cmpfloat (ring.points[i].y, ==, expected[i].y);
  }
}

static void
test_simplify (void)
{
  /* A unit square with a repeated vertex, one in the middle of a side, and a spike. */
  const QnVec2 points[] = { { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 1, 0 },
                            { 1, 1 }, { 3, 1 },   { 1, 1 }, { 0, 1 } };
  QnRing ring = qn_ring_of (points, G_N_ELEMENTS (points));
  g_assert_cmpuint (qn_ring_simplify (&ring, 1e-9), ==, 4);
  g_assert_cmpuint (ring.count, ==, 4);
  g_assert_cmpfloat (qn_ring_area (&ring), ==, 1);
  g_assert_cmpuint (qn_ring_simplify (&ring, 1e-9), ==, 0);
  qn_ring_clear (&ring);

  const QnVec2 flat[] = { { 0, 0 }, { 1, 0 }, { 2, 1e-12 } };
  ring = qn_ring_of (flat, 3);
  qn_ring_simplify (&ring, 1e-9);
  g_assert_cmpuint (ring.count, <, 3);
  qn_ring_clear (&ring);
}

static void
test_list (void)
{
  QnRings rings = { 0 };
  const QnVec2 a[] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
  const QnVec2 b[] = { { 4, 4 }, { 5, 4 }, { 4, 6 } };
  qn_rings_add (&rings, a, 3);
  qn_rings_add (&rings, b, 3);
  QnBox bounds = qn_rings_bounds (&rings);
  g_assert_cmpfloat (bounds.max.y, ==, 6);
  qn_rings_remove (&rings, 0);
  g_assert_cmpuint (rings.count, ==, 1);
  g_assert_cmpfloat (rings.items[0].points[0].x, ==, 4);
  qn_rings_clear (&rings);
  g_assert_cmpfloat (qn_box_size (qn_rings_bounds (&rings)), ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/ring/measures", test_measures);
  g_test_add_func ("/ring/orient-and-normalize", test_orient_and_normalize);
  g_test_add_func ("/ring/simplify", test_simplify);
  g_test_add_func ("/ring/list", test_list);
}
