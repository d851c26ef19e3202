#include "core/base/box-tree.h"
#include "support/room.h"

#include <glib.h>

static int
compare_ids (const void *a, const void *b)
{
  return *(const QnId *) a - *(const QnId *) b;
}

/* Every query against the answer of comparing with all boxes. */
static void
check_against_all_pairs (const QnBox *boxes, size_t count)
{
  QnBoxTree tree;
  QnPool pool = { 0 };
  g_autofree QnId *found = g_new (QnId, count + 1);
  qn_box_tree_init (&tree, boxes, count, &pool);
  g_assert_false (pool.failed);
  for (size_t q = 0; q < count; q++) {
    size_t found_count = 0;
    QnBoxQuery query = qn_box_tree_query (&tree, boxes[q]);
    QnId item;
    while ((item = qn_box_query_next (&query)) != QN_NONE)
      found[found_count++] = item;
    qsort (found, found_count, sizeof *found, compare_ids);

    size_t expected = 0;
    for (size_t i = 0; i < count; i++) {
      if (qn_box_meets (boxes[i], boxes[q])) {
        g_assert_cmpuint (expected, <, found_count);
        g_assert_cmpint (found[expected++], ==, (QnId) i);
      }
    }
    g_assert_cmpuint (found_count, ==, expected);
  }
  qn_pool_clear (&pool);
}

/* The pairs of a walk of the tree against itself, with the same predicate. */
static void
check_pairs (const QnBox *boxes, size_t count, double margin)
{
  QnBoxTree tree;
  QnPool pool = { 0 };
  QnBoxPairs pairs = { 0 };
  g_autofree gboolean *met = g_new0 (gboolean, count * count);
  qn_box_tree_init (&tree, boxes, count, &pool);
  g_assert_false (pool.failed);
  g_assert_true (qn_box_tree_pairs (&tree, margin, SIZE_MAX, &pairs));
  for (size_t i = 0; i < pairs.count; i++) {
    size_t a = (size_t) pairs.items[i][0], b = (size_t) pairs.items[i][1];
    g_assert_cmpuint (a, !=, b);
    g_assert_false (met[a * count + b]);
    met[a * count + b] = met[b * count + a] = TRUE;
  }
  for (size_t a = 0; a < count; a++) {
    QnBox box = qn_box_grow (boxes[a], margin);
    for (size_t b = 0; b < count; b++)
      g_assert_true (met[a * count + b] == (a != b && qn_box_meets (box, boxes[b])));
  }
  qn_box_pairs_clear (&pairs);
  qn_pool_clear (&pool);
}

/* Sizes over six decades, crowded in places. */
static void
test_all_sizes (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (7);
  const size_t counts[] = { 1, 7, 8, 9, 64, 65, 1500 };
  for (size_t c = 0; c < G_N_ELEMENTS (counts); c++) {
    g_autofree QnBox *boxes = g_new (QnBox, counts[c]);
    for (size_t i = 0; i < counts[c]; i++) {
      double size = pow (10, g_rand_double_range (random, -4, 1));
      double spread = i % 3 == 0 ? 0.01 : 10;
      QnVec2 p = { spread * g_rand_double (random), spread * g_rand_double (random) };
      boxes[i] = qn_box_of_segment (p, qn_vec2 (p.x + size, p.y - size / 3));
    }
    check_against_all_pairs (boxes, counts[c]);
    check_pairs (boxes, counts[c], 0);
    check_pairs (boxes, counts[c], 0.125);
  }
}

static void
test_equal_boxes (void)
{
  QnBox boxes[100];
  for (int i = 0; i < 100; i++)
    boxes[i] = (QnBox){ { 3, 3 }, { 3, 3 } };
  check_against_all_pairs (boxes, 100);
  check_pairs (boxes, 100, 0);
}

static void
test_empty (void)
{
  QnBoxTree tree;
  QnPool pool = { 0 };
  qn_box_tree_init (&tree, NULL, 0, &pool);
  g_assert_false (pool.failed);
  QnBoxQuery query = qn_box_tree_query (&tree, (QnBox){ { 0, 0 }, { 1, 1 } });
  g_assert_cmpint (qn_box_query_next (&query), ==, QN_NONE);
  QnBoxPairs pairs = { 0 };
  g_assert_true (qn_box_tree_pairs (&tree, 1, SIZE_MAX, &pairs));
  g_assert_cmpuint (pairs.count, ==, 0);
  qn_pool_clear (&pool);
}

static void
test_touching_counts (void)
{
  const QnBox box = { { 0, 0 }, { 1, 1 } };
  g_assert_true (qn_box_meets (box, (QnBox){ { 1, 1 }, { 2, 2 } }));
  g_assert_false (qn_box_meets (box, (QnBox){ { 1.001, 0 }, { 2, 1 } }));
  g_assert_true (
    qn_box_meets (qn_box_grow (box, 0.001), (QnBox){ { 1.001, 0 }, { 2, 1 } }));
}

QN_TESTS
{
  g_test_add_func ("/box-tree/all-sizes", test_all_sizes);
  g_test_add_func ("/box-tree/equal-boxes", test_equal_boxes);
  g_test_add_func ("/box-tree/empty", test_empty);
  g_test_add_func ("/box-tree/touching-counts", test_touching_counts);
}
