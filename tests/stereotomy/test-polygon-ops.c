#include "stereotomy/polygon-ops.h"
#include "support/room.h"

#include <glib.h>
#include <stdlib.h>

static QnRing
box (double x0, double y0, double x1, double y1)
{
  const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  return qn_ring_of (corners, 4);
}

static double
total_area (const QnRings *rings)
{
  double area = 0;
  for (size_t i = 0; i < rings->count; i++) {
    g_assert_cmpint (qn_ring_check (&rings->items[i], 0, NULL), ==, QN_OK);
    g_assert_cmpfloat (qn_ring_area (&rings->items[i]), >, 0);
    area += qn_ring_area (&rings->items[i]);
  }
  return area;
}

static void
test_difference (void)
{
  QnRing unit = box (0, 0, 1, 1), notch = box (0.5, 0.5, 2, 2),
         hole = box (0.25, 0.25, 0.5, 0.5);
  QnRings out = { 0 };
  g_assert_cmpint (
    qn_polygon_difference (&unit, &(QnRings){ .items = &notch, .count = 1 }, &out, NULL),
    ==, QN_OK);
  g_assert_cmpuint (out.count, ==, 1);
  g_assert_cmpuint (out.items[0].count, ==, 6);
  g_assert_cmpfloat (total_area (&out), ==, 0.75);
  qn_rings_clear (&out);

  /* A hole parts the rest in two. */
  g_assert_cmpint (
    qn_polygon_difference (&unit, &(QnRings){ .items = &hole, .count = 1 }, &out, NULL),
    ==, QN_OK);
  g_assert_cmpuint (out.count, ==, 2);
  g_assert_cmpfloat_with_epsilon (total_area (&out), 1 - 0.0625, 1e-15);
  qn_rings_clear (&out);

  QnRing both[] = { box (-1, -1, 0.6, 2), box (0.5, -1, 2, 2) };
  g_assert_cmpint (
    qn_polygon_difference (&unit, &(QnRings){ .items = both, .count = 2 }, &out, NULL),
    ==, QN_OK);
  g_assert_cmpuint (out.count, ==, 0);

  free (both[0].points);
  free (both[1].points);
  qn_ring_clear (&unit);
  qn_ring_clear (&notch);
  qn_ring_clear (&hole);
}

static void
test_union (void)
{
  QnRing parts[] = { box (0, 0, 1, 1), box (1, 0, 2, 1), box (3, 0, 4, 1) }, joined;
  QnDiag diag = { 0 };
  g_assert_cmpint (
    qn_polygons_union (&(QnRings){ .items = parts, .count = 2 }, &joined, &diag), ==,
    QN_OK);
  g_assert_cmpuint (joined.count, ==, 4);
  g_assert_cmpfloat (qn_ring_area (&joined), ==, 2);
  qn_ring_clear (&joined);

  g_assert_cmpint (
    qn_polygons_union (&(QnRings){ .items = parts, .count = 3 }, &joined, &diag), ==,
    QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_GEOMETRY_SEVERAL);

  QnRing around[] = { box (0, 0, 3, 1), box (0, 2, 3, 3), box (0, 1, 1, 2),
                      box (2, 1, 3, 2) };
  g_assert_cmpint (
    qn_polygons_union (&(QnRings){ .items = around, .count = 4 }, &joined, &diag), ==,
    QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_GEOMETRY_HOLE);

  /* Corner to corner is no joint. */
  QnRing corners[] = { box (0, 0, 1, 1), box (1, 1, 2, 2) };
  g_assert_cmpint (
    qn_polygons_union (&(QnRings){ .items = corners, .count = 2 }, &joined, &diag), ==,
    QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_GEOMETRY_SEVERAL);
  for (int i = 0; i < 4; i++)
    qn_ring_clear (&around[i]);
  for (int i = 0; i < 3; i++)
    qn_ring_clear (&parts[i]);
  for (int i = 0; i < 2; i++)
    qn_ring_clear (&corners[i]);
}

static void
test_cut (void)
{
  QnRing unit = box (0, 0, 2, 1);
  QnRings out = { 0 };
  g_assert_cmpint (
    qn_polygon_cut (&unit, qn_vec2 (0.5, 100), qn_vec2 (0.5, 101), &out, NULL), ==,
    QN_OK);
  g_assert_cmpuint (out.count, ==, 2);
  g_assert_cmpfloat_with_epsilon (total_area (&out), 2, 1e-12);
  qn_rings_clear (&out);
  g_assert_cmpint (qn_polygon_cut (&unit, qn_vec2 (0, 5), qn_vec2 (1, 5), &out, NULL), ==,
                   QN_OK);
  g_assert_cmpuint (out.count, ==, 1);
  g_assert_cmpuint (out.items[0].count, ==, 4);
  qn_rings_clear (&out);
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_polygon_cut (&unit, qn_vec2 (0, 5), qn_vec2 (0, 5), &out, &diag),
                   ==, QN_ERROR_INVALID);
  qn_ring_clear (&unit);
}

static void
test_refuses (void)
{
  const QnVec2 bow[] = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
  const QnVec2 unknown[] = { { 0, 0 }, { NAN, 0 }, { 1, 1 } };
  const QnVec2 huge[] = { { 0, 0 }, { 1e300, 0 }, { 1e300, 1e300 } };
  const struct {
    const QnVec2 *points;
    size_t count;
    QnProblem problem;
  } cases[] = { { bow, 4, QN_PROBLEM_SELF_CROSSING },
                { unknown, 3, QN_PROBLEM_NOT_FINITE },
                { huge, 3, QN_PROBLEM_TOO_LARGE },
                { bow, 2, QN_PROBLEM_TOO_FEW_VERTICES } };
  QnRing unit = box (0, 0, 1, 1);
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnRing) bad = qn_ring_of (cases[i].points, cases[i].count);
    QnRings out = { 0 };
    QnDiag diag = { 0 };
    g_assert_cmpint (
      qn_polygon_difference (&unit, &(QnRings){ .items = &bad, .count = 1 }, &out, &diag),
      ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, cases[i].problem);
    g_assert_cmpint (qn_polygon_cut (&bad, qn_vec2 (0, 0), qn_vec2 (1, 0), &out, &diag),
                     ==, QN_ERROR_INVALID);
    g_assert_cmpuint (out.count, ==, 0);
  }
  qn_ring_clear (&unit);
}

QN_TESTS
{
  g_test_add_func ("/polygon-ops/difference", test_difference);
  g_test_add_func ("/polygon-ops/union", test_union);
  g_test_add_func ("/polygon-ops/cut", test_cut);
  g_test_add_func ("/polygon-ops/refuses", test_refuses);
}
