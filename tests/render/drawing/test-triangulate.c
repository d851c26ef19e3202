#include "render/drawing/triangulate.h"
#include "support/room.h"

#include <glib.h>

/* The triangles cover the polygon's area, each counter-clockwise. */
static void
check (const QnVec2 *p, uint32_t n)
{
  uint32_t indices[64], order[32];
  double area = 0, covered = 0;
  for (uint32_t i = 0; i < n; i++)
    area += 0.5 * qn_vec2_cross (p[i], p[(i + 1) % n]);
  size_t count = qn_triangulate (p, n, indices, order);
  g_assert_cmpuint (count, ==, 3 * (n - 2));
  for (size_t i = 0; i < count; i += 3) {
    QnVec2 a = p[indices[i]];
    double twice = qn_vec2_cross (qn_vec2_sub (p[indices[i + 1]], a),
                                  qn_vec2_sub (p[indices[i + 2]], a));
    g_assert_cmpfloat (twice, >, 0);
    covered += 0.5 * twice;
  }
  g_assert_cmpfloat_with_epsilon (covered, fabs (area), 1e-12);
}

static void
test_shapes (void)
{
  const QnVec2 square[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const QnVec2 clockwise[] = { { 0, 1 }, { 1, 1 }, { 1, 0 }, { 0, 0 } };
  const QnVec2 ell[] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
  const QnVec2 comb[] = { { 0, 0 }, { 5, 0 }, { 5, 2 }, { 4, 2 }, { 4, 1 }, { 3, 1 },
                          { 3, 2 }, { 2, 2 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  const QnVec2 star[] = { { 0, 3 },       { -0.6, 0.8 }, { -3, 0.9 },   { -1, -0.4 },
                          { -1.8, -2.6 }, { 0, -1 },     { 1.8, -2.6 }, { 1, -0.4 },
                          { 3, 0.9 },     { 0.6, 0.8 } };
  check (square, G_N_ELEMENTS (square));
  check (clockwise, G_N_ELEMENTS (clockwise));
  check (ell, G_N_ELEMENTS (ell));
  check (comb, G_N_ELEMENTS (comb));
  check (star, G_N_ELEMENTS (star));
}

static void
test_degenerate (void)
{
  const QnVec2 line[] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 } };
  const QnVec2 collinear[] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  uint32_t indices[16], order[8];
  g_assert_cmpuint (qn_triangulate (line, 4, indices, order), ==, 0);
  g_assert_cmpuint (qn_triangulate (collinear, 5, indices, order), >=, 6);
}

QN_TESTS
{
  g_test_add_func ("/render/triangulate/shapes", test_shapes);
  g_test_add_func ("/render/triangulate/degenerate", test_degenerate);
}
