#include "core/contact/contact-side.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static void
init_sides (QnModel *model, QnSides *sides, const QnVec2 *vertices, size_t count,
            double tolerance, QnPool *room)
{
  test_model_init (model);
  QnBlock *block = qn_model_add_block (model, "b", vertices, count);
  block->thickness = 1;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  qn_sides_init (sides, model, tolerance, room);
  g_assert_false (room->failed);
}

static void
clear (QnModel *model, QnPool *room)
{
  qn_pool_clear (room);
  qn_model_clear (model);
}

static void
test_rectangle (void)
{
  QnModel model;
  QnSides sides;
  QnPool room = { 0 };
  const QnVec2 v[] = { { 0, 0 }, { 4, 0 }, { 4, 3 }, { 0, 3 } };
  init_sides (&model, &sides, v, 4, 1e-6, &room);
  g_assert_cmpuint (sides.count, ==, 4);
  for (int i = 0; i < 4; i++) {
    g_assert_cmpint (sides.items[i].vertex, ==, i);
    g_assert_cmpfloat (sides.items[i].length, ==, i % 2 == 0 ? 4 : 3);
  }
  g_assert_cmpfloat (sides.items[1].direction.y, ==, 1);
  clear (&model, &room);
}

/* Straight-angle vertices everywhere, the first vertex among them. */
static void
test_collinear_run (void)
{
  const QnVec2 v[] = { { 2, 0 }, { 3, 0 }, { 4, 0 }, { 4, 1 }, { 4, 3 },
                       { 1, 3 }, { 0, 3 }, { 0, 0 }, { 1, 0 } };
  for (int turn = 0; turn < 12; turn++) {
    QnVec2 turned[9];
    for (int i = 0; i < 9; i++)
      turned[i] = qn_vec2_rotate (v[i], cos (turn * G_PI / 6), sin (turn * G_PI / 6));
    QnModel model;
    QnSides sides;
    QnPool room = { 0 };
    init_sides (&model, &sides, turned, 9, 1e-6, &room);
    g_assert_cmpuint (sides.count, ==, 4);
    g_assert_cmpint (sides.items[3].vertex, ==, 7);
    g_assert_cmpfloat_with_epsilon (sides.items[3].length, 4, 1e-14);
    clear (&model, &room);
  }
}

/* A circle of fine facets: no two of its vertices may drift from the polygon, and a facet deeper
 * than the tolerance stays a side. */
static void
test_arc_stays_round (void)
{
  enum { COUNT = 720 };
  g_autofree QnVec2 *v = g_new (QnVec2, COUNT);
  for (int i = 0; i < COUNT; i++)
    v[i] = qn_vec2 (cos (2 * G_PI * i / COUNT), sin (2 * G_PI * i / COUNT));

  QnModel model;
  QnSides sides;
  QnPool room = { 0 };
  init_sides (&model, &sides, v, COUNT, 1e-6, &room); /* one facet is 9.5e-6 deep */
  g_assert_cmpuint (sides.count, ==, COUNT);

  /* With a coarser tolerance runs grow, but every vertex stays within it. */
  const double tolerance = 1e-3;
  qn_sides_init (&sides, &model, tolerance, &room);
  g_assert_cmpuint (sides.count, <, COUNT / 5);
  for (size_t s = 0; s < sides.count; s++) {
    const QnSide *side = &sides.items[s];
    QnId end = s + 1 < sides.count ? sides.items[s + 1].vertex : COUNT;
    for (QnId i = side->vertex; i < end; i++) {
      double off = qn_vec2_cross (side->direction, qn_vec2_sub (v[i], side->start));
      g_assert_cmpfloat (fabs (off), <=, 2 * tolerance);
    }
  }
  clear (&model, &room);
}

/* A hundred thousand vertices on one line are merged in linear time. */
static void
test_long_run (void)
{
  enum { COUNT = 100000 };
  g_autofree QnVec2 *v = g_new (QnVec2, COUNT + 2);
  for (int i = 0; i < COUNT; i++)
    v[i] = qn_vec2 (i * 1e-3, 0);
  v[COUNT] = qn_vec2 (100, 50);
  v[COUNT + 1] = qn_vec2 (0, 50);
  QnModel model;
  QnSides sides;
  QnPool room = { 0 };
  init_sides (&model, &sides, v, COUNT + 2, 1e-6, &room);
  g_assert_cmpuint (sides.count, ==, 4);
  clear (&model, &room);
}

/* Steps shallower than the tolerance do not bend a side; deeper ones do. */
static void
test_shallow_corner (void)
{
  const double depths[] = { 0.5e-6, 3e-6 };
  for (int i = 0; i < 2; i++) {
    const QnVec2 v[] = { { 0, 0 }, { 1, -depths[i] }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
    QnModel model;
    QnSides sides;
    QnPool room = { 0 };
    init_sides (&model, &sides, v, 5, 1e-6, &room);
    g_assert_cmpuint (sides.count, ==, i == 0 ? 4 : 5);
    clear (&model, &room);
  }
}

QN_TESTS
{
  g_test_add_func ("/contact-side/rectangle", test_rectangle);
  g_test_add_func ("/contact-side/collinear-run", test_collinear_run);
  g_test_add_func ("/contact-side/arc-stays-round", test_arc_stays_round);
  g_test_add_func ("/contact-side/long-run", test_long_run);
  g_test_add_func ("/contact-side/shallow-corner", test_shallow_corner);
}
