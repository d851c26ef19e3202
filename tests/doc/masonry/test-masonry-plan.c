#include "doc/masonry/masonry-plan.h"
#include "doc/masonry/masonry-shape.h"

#include <math.h>

static const QnMasonryStyle style = { .unit = { 0.4, 0.2 },
                                      .bond = QN_BOND_RUNNING,
                                      .lap = 0.5,
                                      .thickness = 0.3,
                                      .unit_weight = 2e4,
                                      .law = QN_NONE,
                                      .base = TRUE,
                                      .head = QN_HEAD_FLAT,
                                      .span = QN_SPAN_LINTEL,
                                      .shape = QN_ARCH_CIRCULAR,
                                      .ring = 0.25,
                                      .voussoirs = 9,
                                      .top_to_foot = 0.8 };

static void
test_wall (void)
{
  QnMasonry wall;
  /* Dragged to the left and down: it ends where the drag began. */
  g_assert_true (qn_plan_wall (&wall, &style, qn_vec2 (5.0, 3.0), qn_vec2 (2.93, 1.55)));
  g_assert_cmpfloat_with_epsilon (wall.wall.leaves[0].length, 2.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.wall.height, 1.4, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.origin.x, 3.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.origin.y, 1.6, 1e-12);
  g_assert_cmpfloat (wall.foundation, ==, 0.2);
  g_assert_cmpfloat_with_epsilon (qn_masonry_estimate_blocks (&wall), 35.0, 1.0);
  qn_masonry_clear (&wall);
}

/* A lintel where there is wall above, none where there is not. */
static void
test_opening (void)
{
  QnMasonry wall;
  QnOpening opening;
  g_assert_true (qn_plan_wall (&wall, &style, qn_vec2 (0, 0), qn_vec2 (4.0, 2.0)));
  g_assert_true (qn_plan_opening (&wall, &style, qn_vec2 (1.0, 0.6), qn_vec2 (2.0, 1.4),
                                  TRUE, &opening));
  g_assert_cmpint (opening.span, ==, QN_SPAN_LINTEL);
  g_assert_cmpfloat (opening.depth, ==, 0.2);
  g_assert_true (qn_plan_opening (&wall, &style, qn_vec2 (1.0, 0.6), qn_vec2 (2.0, 2.0),
                                  TRUE, &opening));
  g_assert_cmpint (opening.span, ==, QN_SPAN_NONE);
  g_assert_false (qn_plan_opening (&wall, &style, qn_vec2 (9.0, 0.6), qn_vec2 (9.5, 2.0),
                                   TRUE, &opening));
  qn_masonry_clear (&wall);
}

static void
test_arch (void)
{
  QnVec2 left = { 1.0, 1.0 }, right = { 4.0, 5.0 };
  /* A point a metre off the middle of a chord of 5 m. */
  QnVec2 at = { 2.5 - 0.8, 3.0 + 0.6 };
  double rise = qn_plan_arch_rise (left, right, at);
  g_assert_cmpfloat_with_epsilon (rise, 1.0, 1e-12);
  QnMasonry arch;
  g_assert_true (qn_plan_arch (&arch, &style, left, right, rise));
  g_assert_cmpfloat_with_epsilon (arch.arch.span, 5.0, 1e-12);
  QnVec2 crown = qn_masonry_to_model (&arch, qn_vec2 (2.5, 1.0));
  g_assert_cmpfloat_with_epsilon (crown.x, at.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (crown.y, at.y, 1e-12);
  qn_masonry_clear (&arch);

  g_assert_true (qn_plan_arch (&arch, &style, left, right, 4.0));
  g_assert_cmpint (arch.arch.shape, ==, QN_ARCH_POINTED);
  qn_masonry_clear (&arch);
  g_assert_true (qn_plan_arch (&arch, &style, left, right, -1.0));
  g_assert_cmpfloat (arch.arch.rise, >, 0.0);
  qn_masonry_clear (&arch);
}

static void
test_column (void)
{
  QnMasonry column;
  g_assert_true (
    qn_plan_column (&column, &style, qn_vec2 (1.0, 0.0), qn_vec2 (1.5, 2.1)));
  g_assert_cmpint (column.column.drums, ==, 11);
  g_assert_cmpfloat_with_epsilon (column.column.top, 0.4, 1e-12);
  g_assert_cmpfloat_with_epsilon (column.origin.x, 1.25, 1e-12);
  qn_masonry_clear (&column);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/masonry-plan/wall", test_wall);
  g_test_add_func ("/doc/masonry-plan/opening", test_opening);
  g_test_add_func ("/doc/masonry-plan/arch", test_arch);
  g_test_add_func ("/doc/masonry-plan/column", test_column);
  return g_test_run ();
}
