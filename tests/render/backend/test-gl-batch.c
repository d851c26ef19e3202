#include "render/backend/gl-batch.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Twice the area of the triangles of a filled polygon that lie within its edges, the band around them left out;
 * each is counter-clockwise. */
static double
covered (const QnVec2 *p, uint32_t n)
{
  QnGlBatch batch;
  double sum = 0;
  g_autoptr (QnScene) scene = qn_scene_new ();
  qn_scene_fill (scene, QN_LAYER_BLOCKS, p, n, qn_rgb (0));
  qn_scene_finish (scene);
  qn_gl_batch_init (&batch, scene);
  for (guint i = 0; i < batch.indices->len; i += 3) {
    QnVec2 corners[3];
    bool inner = true;
    for (guint k = 0; k < 3; k++) {
      const uint32_t index = g_array_index (batch.indices, uint32_t, i + k);
      const QnGlVertex *v = &g_array_index (batch.vertices, QnGlVertex, index);
      corners[k] = qn_vec2 (v->place[0], v->place[1]);
      inner &= n <= 4 || v->rim[0] > 0;
    }
    double twice = qn_vec2_cross (qn_vec2_sub (corners[1], corners[0]),
                                  qn_vec2_sub (corners[2], corners[0]));
    g_assert_true (!inner || n <= 4 || twice > 0);
    sum += inner ? fabs (twice) : 0;
  }
  qn_gl_batch_clear (&batch);
  return sum;
}

static void
check (const QnVec2 *p, uint32_t n)
{
  double twice = 0;
  for (uint32_t i = 0; i < n; i++)
    twice += qn_vec2_cross (p[i], p[(i + 1) % n]);
  g_assert_cmpfloat_with_epsilon (covered (p, n), fabs (twice), 1e-5);
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
  const QnVec2 line[] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 } };
  const QnVec2 collinear[] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  g_assert_cmpfloat (covered (line, 5), ==, 0);
  check (collinear, 5);
}

QN_TESTS
{
  g_test_add_func ("/render/gl-batch/shapes", test_shapes);
  g_test_add_func ("/render/gl-batch/degenerate", test_degenerate);
}
