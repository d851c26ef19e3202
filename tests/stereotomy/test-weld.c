#include "stereotomy/weld.h"
#include "support/room.h"

#include <glib.h>

static void
add_box (QnRings *rings, double x0, double y0, double x1, double y1)
{
  const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  qn_rings_add (rings, corners, 4);
}

static void
test_majority_wins (void)
{
  g_auto (QnRings) rings = { 0 };
  add_box (&rings, 0, 0, 1.0003, 1); /* the stray one comes first */
  add_box (&rings, 1, 0, 2, 1);
  add_box (&rings, 1, 1, 2, 2);
  add_box (&rings, 0, 1, 1, 2);
  QnHealing healing = { 0 };
  qn_weld_vertices (&rings, 0, 0.001, NULL, &healing);
  g_assert_cmpfloat (rings.items[0].points[2].x, ==, 1);
  g_assert_cmpfloat (rings.items[0].points[2].y, ==, 1);
  g_assert_cmpuint (healing.count, >=, 1);
  g_assert_cmpfloat_with_epsilon (healing.farthest, 0.0003, 1e-9);
}

static void
test_clean_stays (void)
{
  g_auto (QnRings) rings = { 0 };
  for (int row = 0; row < 4; row++)
    for (int i = 0; i < 5; i++) {
      double shift = row % 2 * 0.05;
      add_box (&rings, 0.1 * i + shift, 0.07 * row, 0.1 * (i + 1) + shift,
               0.07 * (row + 1));
    }
  g_auto (QnRings) before = { 0 };
  for (size_t i = 0; i < rings.count; i++)
    qn_rings_add (&before, rings.items[i].points, rings.items[i].count);
  QnHealing healing = { 0 };
  qn_snap_neighbours (&rings, 0.001, &healing);
  g_assert_cmpuint (healing.count, ==, 0);
  for (size_t i = 0; i < rings.count; i++)
    g_assert_cmpmem (rings.items[i].points, rings.items[i].count * sizeof (QnVec2),
                     before.items[i].points, before.items[i].count * sizeof (QnVec2));
}

static void
test_gap_closes (void)
{
  /* A running bond whose second course floats half a millimetre too high. */
  g_auto (QnRings) rings = { 0 };
  add_box (&rings, 0, 0, 1, 1);
  add_box (&rings, 1, 0, 2, 1);
  add_box (&rings, 0.5, 1.0005, 1.5, 2);
  QnHealing healing = { 0 };
  qn_snap_neighbours (&rings, 0.001, &healing);
  g_assert_cmpuint (rings.items[2].count, ==, 4);
  g_assert_cmpfloat (rings.items[2].points[0].y, ==, 1);
  g_assert_cmpfloat (rings.items[2].points[1].y, ==, 1);
  g_assert_cmpfloat_with_epsilon (
    qn_joint_length (&rings.items[0], &rings.items[2], 1e-9), 0.5, 1e-12);
}

static void
test_edge_meets_vertex (void)
{
  /* A long lintel on two piers of slightly different height. */
  g_auto (QnRings) rings = { 0 };
  add_box (&rings, 1, 0, 2, 1);
  add_box (&rings, 3, 0, 4, 1.0004);
  add_box (&rings, 0, 1, 5, 2);
  QnHealing healing = { 0 };
  qn_snap_neighbours (&rings, 0.001, &healing);
  g_assert_cmpfloat_with_epsilon (
    qn_joint_length (&rings.items[1], &rings.items[2], 1e-9), 1, 1e-6);
}

static void
test_collapse (void)
{
  g_auto (QnRings) rings = { 0 };
  add_box (&rings, 0, 0, 1, 1);
  add_box (&rings, 1, 0, 1.0001, 1);
  qn_weld_vertices (&rings, 0, 0.001, NULL, NULL);
  qn_drop_collapsed (&rings);
  g_assert_cmpuint (rings.count, ==, 1);
}

/* A vertex on a straight side stays where nothing of its ring moves; where a corner is welded it goes. */
static void
test_vertex_on_a_side (void)
{
  const QnVec2 lower[] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 0, 1 } };
  for (int moved = 0; moved < 2; moved++) {
    g_auto (QnRings) rings = { 0 };
    qn_rings_add (&rings, lower, 5);
    rings.items[0].points[1].x += 3e-4 * moved;
    add_box (&rings, 2, 0, 3, 1);
    add_box (&rings, 2, -1, 3, 0);
    qn_weld_vertices (&rings, 0, 0.001, NULL, NULL);
    g_assert_cmpuint (rings.items[0].count, ==, moved ? 4 : 5);
  }
}

QN_TESTS
{
  g_test_add_func ("/weld/majority-wins", test_majority_wins);
  g_test_add_func ("/weld/clean-stays", test_clean_stays);
  g_test_add_func ("/weld/gap-closes", test_gap_closes);
  g_test_add_func ("/weld/edge-meets-vertex", test_edge_meets_vertex);
  g_test_add_func ("/weld/collapse", test_collapse);
  g_test_add_func ("/weld/vertex-on-a-side", test_vertex_on_a_side);
}
