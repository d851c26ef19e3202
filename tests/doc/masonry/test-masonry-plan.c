#include "core/base/box.h"
#include "doc/masonry/masonry-plan.h"
#include "doc/masonry/masonry-shape.h"
#include "stereotomy/masonry.h"
#include "support/room.h"

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
  g_auto (QnMasonry) wall;
  /* Dragged to the left and down: it ends where the drag began. */
  qn_plan_wall (&wall, &style, qn_vec2 (5.0, 3.0), qn_vec2 (2.93, 1.55));
  g_assert_cmpfloat_with_epsilon (wall.wall.leaves[0].length, 2.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.wall.height, 1.4, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.origin.x, 3.0, 1e-12);
  g_assert_cmpfloat_with_epsilon (wall.origin.y, 1.6, 1e-12);
  g_assert_cmpfloat (wall.foundation, ==, 0.2);
  g_assert_cmpfloat_with_epsilon (qn_masonry_estimate_blocks (&wall), 35.0, 1.0);
}

/* A lintel where there is wall above, none where there is not. */
static void
test_opening (void)
{
  g_auto (QnMasonry) wall;
  QnOpening opening;
  qn_plan_wall (&wall, &style, qn_vec2 (0, 0), qn_vec2 (4.0, 2.0));
  g_assert_true (qn_plan_opening (&wall, &style, qn_vec2 (1.0, 0.6), qn_vec2 (2.0, 1.4),
                                  TRUE, &opening));
  g_assert_cmpint (opening.span, ==, QN_SPAN_LINTEL);
  g_assert_cmpfloat (opening.depth, ==, 0.2);
  g_assert_true (qn_plan_opening (&wall, &style, qn_vec2 (1.0, 0.6), qn_vec2 (2.0, 2.0),
                                  TRUE, &opening));
  g_assert_cmpint (opening.span, ==, QN_SPAN_NONE);
  g_assert_false (qn_plan_opening (&wall, &style, qn_vec2 (9.0, 0.6), qn_vec2 (9.5, 2.0),
                                   TRUE, &opening));
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
  qn_plan_arch (&arch, &style, left, right, rise);
  g_assert_cmpfloat_with_epsilon (arch.arch.span, 5.0, 1e-12);
  QnVec2 crown = qn_masonry_to_model (&arch, qn_vec2 (2.5, 1.0));
  g_assert_cmpfloat_with_epsilon (crown.x, at.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (crown.y, at.y, 1e-12);
  qn_masonry_clear (&arch);

  qn_plan_arch (&arch, &style, left, right, 4.0);
  g_assert_cmpint (arch.arch.shape, ==, QN_ARCH_POINTED);
  qn_masonry_clear (&arch);
  qn_plan_arch (&arch, &style, left, right, -1.0);
  g_assert_cmpfloat (arch.arch.rise, >, 0.0);
  qn_masonry_clear (&arch);
}

/* Blocks of what a rectangle becomes, and the box around those that are not fixed. */
static gsize
lay (int kind, QnVec2 from, QnVec2 to, QnBox *box)
{
  QnMasonryStyle asked = style;
  g_auto (QnMasonry) masonry;
  QnModel model;
  gsize count = 0;
  asked.kind = kind;
  qn_plan_in_box (&masonry, &asked, from, to);
  qn_model_init (&model);
  masonry.name = g_strdup ("it");
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, NULL), ==, QN_OK);
  *box = QN_BOX_EMPTY;
  for (QnId i = 0; i < (QnId) model.block_count; i++) {
    const QnVec2 *v = qn_model_block_vertices (&model, i);
    for (QnId k = 0; !model.blocks[i].support[0] && k < model.blocks[i].vertex_count; k++)
      qn_box_add_point (box, v[k]);
    count += !model.blocks[i].support[0];
  }
  qn_model_clear (&model);
  g_clear_pointer (&masonry.name, g_free);
  return count;
}

/* All of them fill the rectangle, whichever corner it was begun at. */
static void
test_in_box (void)
{
  static const struct {
    int kind;
    gsize least, most; /* blocks */
  } cases[] = { { QN_MASONRY_COLUMN, 11, 11 },
                { QN_MASONRY_BUTTRESS, 11, 11 },
                { QN_MASONRY_PORTAL, 2 * 9 + 1, 2 * 10 + 1 },
                { QN_MASONRY_RUBBLE, 10, 40 },
                { QN_MASONRY_GRID, 4 * 11, 4 * 11 },
                { QN_MASONRY_VORONOI, 10, 40 } };
  const QnVec2 corners[] = { { 1, 0 }, { 2.5, 0 }, { 2.5, 2.1 }, { 1, 2.1 } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    for (gsize c = 0; c < G_N_ELEMENTS (corners); c++) {
      QnBox box;
      gsize count = lay (cases[i].kind, corners[c], corners[(c + 2) % 4], &box);
      g_assert_cmpuint (count, >=, cases[i].least);
      g_assert_cmpuint (count, <=, cases[i].most);
      g_assert_cmpfloat_with_epsilon (box.min.x, 1.0, 1e-9);
      g_assert_cmpfloat_with_epsilon (box.max.x, 2.5, 1e-9);
      g_assert_cmpfloat_with_epsilon (box.min.y, 0.0, 1e-9);
      g_assert_cmpfloat_with_epsilon (box.max.y, 2.1, 1e-9);
    }
}

QN_TESTS
{
  g_test_add_func ("/doc/masonry-plan/wall", test_wall);
  g_test_add_func ("/doc/masonry-plan/opening", test_opening);
  g_test_add_func ("/doc/masonry-plan/arch", test_arch);
  g_test_add_func ("/doc/masonry-plan/in-box", test_in_box);
}
