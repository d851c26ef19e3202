#include "core/base/polygon.h"
#include "support/room.h"

#include <glib.h>

typedef struct {
  const char *name;
  QnProblem problem;
  size_t count;
  QnVec2 vertices[8];
} Case;

static const Case cases[] = {
  { "triangle", QN_PROBLEM_NONE, 3, { { 0, 0 }, { 1, 0 }, { 0, 1 } } },
  { "clockwise", QN_PROBLEM_NONE, 3, { { 0, 0 }, { 0, 1 }, { 1, 0 } } },
  { "collinear-vertex", QN_PROBLEM_NONE, 4, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } } },
  { "thin", QN_PROBLEM_NONE, 4, { { 0, 0 }, { 1, 0 }, { 1, 1e-6 }, { 0, 1e-6 } } },
  { "two", QN_PROBLEM_TOO_FEW_VERTICES, 2, { { 0, 0 }, { 1, 0 } } },
  { "none", QN_PROBLEM_TOO_FEW_VERTICES, 0, { { 0, 0 } } },
  { "nan", QN_PROBLEM_NOT_FINITE, 3, { { 0, 0 }, { NAN, 0 }, { 0, 1 } } },
  { "infinite", QN_PROBLEM_NOT_FINITE, 3, { { 0, 0 }, { 1, INFINITY }, { 0, 1 } } },
  { "far", QN_PROBLEM_TOO_LARGE, 3, { { 0, 0 }, { 1e300, 0 }, { 0, 1 } } },
  { "line", QN_PROBLEM_ZERO_AREA, 3, { { 0, 0 }, { 1, 1 }, { 3, 3 } } },
  { "folded-line", QN_PROBLEM_ZERO_AREA, 4, { { 0, 0 }, { 2, 0 }, { 1, 0 }, { 3, 0 } } },
  { "closed",
    QN_PROBLEM_DUPLICATE_VERTEX,
    4,
    { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } } },
  { "repeat",
    QN_PROBLEM_DUPLICATE_VERTEX,
    4,
    { { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0, 1 } } },
  { "eight",
    QN_PROBLEM_DUPLICATE_VERTEX,
    6,
    { { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 1, 1 }, { 0, 2 } } },
  { "bow-tie", QN_PROBLEM_SELF_CROSSING, 4, { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } } },
  { "crossed",
    QN_PROBLEM_SELF_CROSSING,
    5,
    { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, -1 }, { 0, 4 } } },
  { "spike",
    QN_PROBLEM_SELF_CROSSING,
    5,
    { { 0, 0 }, { 3, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } },
  { "touches-own-edge",
    QN_PROBLEM_SELF_CROSSING,
    5,
    { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0 }, { 0, 2 } } },
};

static void
test_flaw (const void *data)
{
  const Case *c = data;
  const double scales[] = { 1, 1e-3, 1e3 };
  for (size_t s = 0; s < G_N_ELEMENTS (scales); s++) {
    QnVec2 v[8];
    for (size_t i = 0; i < c->count; i++)
      v[i] =
        qn_vec2_rotate (qn_vec2_scale (scales[s], c->vertices[i]), cos (0.3), sin (0.3));
    g_assert_cmpint (qn_polygon_check (v, c->count).problem, ==, c->problem);
  }
}

static void
test_flaw_names_vertices (void)
{
  QnPolygonFlaw flaw = qn_polygon_check (cases[12].vertices, 4);
  g_assert_cmpint (flaw.vertex, ==, 2);
  g_assert_cmpint (flaw.other, ==, 1);
}

/* A star of many vertices, with one pair of them exchanged or not. */
static void
test_many_vertices (void)
{
  enum { COUNT = 20000 };
  g_autofree QnVec2 *v = g_new (QnVec2, COUNT);
  for (int i = 0; i < COUNT; i++) {
    double angle = 2 * G_PI * i / COUNT, radius = i % 2 == 0 ? 10 : 9;
    v[i] = qn_vec2 (radius * cos (angle), radius * sin (angle));
  }
  g_assert_cmpint (qn_polygon_check (v, COUNT).problem, ==, QN_PROBLEM_NONE);
  QnVec2 swap = v[12000];
  v[12000] = v[12004];
  v[12004] = swap;
  g_assert_cmpint (qn_polygon_check (v, COUNT).problem, ==, QN_PROBLEM_SELF_CROSSING);
  v[12004] = v[3];
  g_assert_cmpint (qn_polygon_check (v, COUNT).problem, !=, QN_PROBLEM_NONE);
}

QN_TESTS
{
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *path = g_strconcat ("/polygon-check/", cases[i].name, NULL);
    g_test_add_data_func (path, &cases[i], test_flaw);
  }
  g_test_add_func ("/polygon-check/names-vertices", test_flaw_names_vertices);
  g_test_add_func ("/polygon-check/many-vertices", test_many_vertices);
}
