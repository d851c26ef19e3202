#include "stereotomy/linework.h"
#include "support/room.h"

#include <glib.h>

static void
add (QnSegments *segments, double x0, double y0, double x1, double y1)
{
  qn_segments_add (segments, qn_vec2 (x0, y0), qn_vec2 (x1, y1));
}

static double
polygonize (QnSegments *segments, double tolerance, size_t expected)
{
  g_auto (QnRings) faces = { 0 };
  size_t holes = 0;
  QnHealing healing = { 0 };
  g_assert_cmpint (
    qn_linework_polygonize (segments, tolerance, &faces, &holes, &healing, NULL), ==,
    QN_OK);
  g_assert_cmpuint (faces.count, ==, expected);
  double area = 0;
  for (size_t i = 0; i < faces.count; i++) {
    g_assert_cmpuint (faces.items[i].count, ==, 4);
    area += qn_ring_area (&faces.items[i]);
  }
  qn_segments_clear (segments);
  return area;
}

/* Two courses: the joints of one are no corners of the other. */
static void
test_courses (void)
{
  QnSegments segments = { 0 };
  for (int i = 0; i <= 2; i++)
    add (&segments, 0, i, 4, i);
  for (int i = 0; i <= 2; i++)
    add (&segments, 2 * i, 0, 2 * i, 1);
  add (&segments, 0, 1, 0, 2);
  add (&segments, 1, 2, 1, 1);
  add (&segments, 4, 1, 4, 2);
  g_assert_cmpfloat (polygonize (&segments, 1e-3, 4), ==, 8);
}

/* Short ends, overruns, doubled and crossing lines: right to the tolerance. */
static void
test_dirty (void)
{
  QnSegments segments = { 0 };
  add (&segments, -0.3, 0, 2.2, 0);
  add (&segments, 0, 0.0005, 0, 1.3);
  add (&segments, 2, 0.0005, 2, 0.9995);
  add (&segments, 0.0004, 1, 2.0006, 1);
  add (&segments, 2, 1, 0, 1);
  add (&segments, 1, -1, 1, 2);
  g_assert_cmpfloat_with_epsilon (polygonize (&segments, 1e-3, 2), 2, 2e-3);
}

static void
test_nothing_enclosed (void)
{
  QnSegments segments = { 0 };
  add (&segments, 0, 0, 1, 0);
  add (&segments, 1, 0, 1, 1);
  add (&segments, 3, 3, 3, 3);
  g_assert_cmpfloat (polygonize (&segments, 1e-3, 0), ==, 0);
  g_assert_cmpfloat (polygonize (&segments, 1e-3, 0), ==, 0);
}

static void
test_hole (void)
{
  QnSegments segments = { 0 };
  g_auto (QnRings) faces = { 0 };
  const double sizes[] = { 3, 1 };
  for (int i = 0; i < 2; i++) {
    double s = sizes[i];
    add (&segments, -s, -s, s, -s);
    add (&segments, s, -s, s, s);
    add (&segments, s, s, -s, s);
    add (&segments, -s, s, -s, -s);
  }
  size_t holes = 0;
  g_assert_cmpint (qn_linework_polygonize (&segments, 1e-3, &faces, &holes, NULL, NULL),
                   ==, QN_OK);
  g_assert_cmpuint (faces.count, ==, 1);
  g_assert_cmpuint (holes, ==, 1);
  qn_segments_clear (&segments);
}

/* A grid of a hundred thousand segments. */
static void
test_large (void)
{
  QnSegments segments = { 0 };
  for (int i = 0; i <= 220; i++)
    for (int k = 0; k < 220; k++) {
      add (&segments, k, i, k + 1, i);
      add (&segments, i, k, i, k + 1);
    }
  g_assert_cmpuint (segments.count, >, 97000);
  g_assert_cmpfloat (polygonize (&segments, 1e-3, 220 * 220), ==, 220 * 220);
}

QN_TESTS
{
  g_test_add_func ("/linework/courses", test_courses);
  g_test_add_func ("/linework/dirty", test_dirty);
  g_test_add_func ("/linework/nothing-enclosed", test_nothing_enclosed);
  g_test_add_func ("/linework/hole", test_hole);
  g_test_add_func ("/linework/large", test_large);
}
