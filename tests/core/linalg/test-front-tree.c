#include "core/linalg/front-tree.h"

#include "core/linalg/sparse.h"
#include "support/room.h"

#include <glib.h>

enum { SIDE = 15, BODIES = SIDE * SIDE };

/* Bodies in running bond; some are of one or two unknowns only, and some alone. */
static int32_t
make_pattern (GRand *random, int32_t **ap, int32_t **ai, QnPool *pool)
{
  static int32_t unknown[BODIES][3];
  QnSparsePattern pattern;
  int32_t n = 0;

  for (int b = 0; b < SIDE * SIDE; b++)
    for (int d = 0; d < 3; d++)
      unknown[b][d] = g_rand_int_range (random, 0, 6) == 0 ? QN_NONE : n++;
  qn_sparse_pattern_init (&pattern, n, SIDE * SIDE * (9 + 3 * 36), pool);
  for (int b = 0; b < SIDE * SIDE; b++) {
    bool shifted = b / SIDE % 2 == 1; /* running bond: the other block below */
    int below = b >= SIDE ? b - SIDE : b, next = shifted ? below + 1 : below - 1;
    bool has_next = b >= SIDE && next / SIDE == below / SIDE && next >= 0;
    const int others[] = { b % SIDE > 0 ? b - 1 : b, below, has_next ? next : b };
    qn_sparse_pattern_add_clique (&pattern, unknown[b], 3);
    for (size_t k = 0; k < G_N_ELEMENTS (others); k++) {
      int32_t both[6];
      if (g_rand_int_range (random, 0, 9) == 0)
        continue;
      for (int d = 0; d < 3; d++) {
        both[d] = unknown[b][d];
        both[3 + d] = others[k] == b ? QN_NONE : unknown[others[k]][d];
      }
      qn_sparse_pattern_add_clique (&pattern, both, 6);
    }
  }
  qn_sparse_pattern_compress (&pattern, ap, ai);
  g_assert_false (pool->failed);
  return n;
}

/* Every front comes right after the subtrees of its children: S of a factorisation waits on a
 * stack. */
static void
check_postorder (const QnFrontTree *tree)
{
  g_autofree int32_t *size = g_new0 (int32_t, tree->front_count);

  for (int32_t f = 0; f < tree->front_count; f++) {
    int32_t last = QN_NONE;
    size[f] = 1;
    for (int32_t c = tree->fronts[f].child; c != QN_NONE; c = tree->fronts[c].sibling) {
      g_assert_cmpint (tree->fronts[c].parent, ==, f);
      size[f] += size[c];
      last = MAX (last, c);
    }
    if (last != QN_NONE)
      g_assert_cmpint (last, ==, f - 1);
    for (int32_t c = tree->fronts[f].child; c != QN_NONE; c = tree->fronts[c].sibling) {
      gboolean follows = c - size[c] == f - size[f];
      for (int32_t d = tree->fronts[f].child; d != QN_NONE; d = tree->fronts[d].sibling)
        follows = follows || c - size[c] == d;
      g_assert_true (follows);
    }
  }
}

/* Every position is eliminated once, rests are ascending, and go where their places say. */
static void
check_fronts (const QnFrontTree *tree)
{
  int32_t next = 0;

  for (int32_t f = 0; f < tree->front_count; f++) {
    const QnFront *front = &tree->fronts[f];
    g_assert_cmpint (front->first, ==, next);
    g_assert_cmpint (front->pivots, >, 0);
    next += front->pivots;
    g_assert_cmpint (front->parent == QN_NONE, ==, front->rest == 0);
    for (int32_t r = 0; r < front->rest; r++) {
      int32_t k = front->first_row + r, row = tree->rows[k], place = tree->places[k];
      const QnFront *parent = &tree->fronts[front->parent];
      g_assert_cmpint (front->parent, >, f);
      g_assert_cmpint (row, >=, r == 0 ? next : tree->rows[k - 1] + 1);
      g_assert_cmpint (row, ==,
                       place < parent->pivots
                         ? parent->first + place
                         : tree->rows[parent->first_row + place - parent->pivots]);
    }
  }
  g_assert_cmpint (next, ==, tree->n);
}

static int32_t
front_of (const QnFrontTree *tree, int32_t position)
{
  int32_t f = 0;
  while (position >= tree->fronts[f].first + tree->fronts[f].pivots)
    f++;
  return f;
}

/* Entries of the matrix find a place in the front that eliminates the first of their two
 * unknowns. */
static void
check_entries (const QnFrontTree *tree, const int32_t *ap, const int32_t *ai)
{
  for (int32_t j = 0; j < tree->n; j++)
    for (int32_t p = ap[j]; p < ap[j + 1]; p++) {
      int32_t one = tree->position[j], other = tree->position[ai[p]];
      const QnFront *front = &tree->fronts[front_of (tree, MIN (one, other))];
      int32_t later = MAX (one, other);
      gboolean found = later < front->first + front->pivots;
      for (int32_t r = 0; r < front->rest && !found; r++)
        found = tree->rows[front->first_row + r] == later;
      g_assert_true (found);
    }
}

static void
test_random (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (23);

  for (int structure = 0; structure < 10; structure++) {
    QnPool pool = { 0 };
    int32_t *ap, *ai, n = make_pattern (random, &ap, &ai, &pool);
    QnFrontTree tree;
    g_assert_true (qn_front_tree_init (&tree, n, ap, ai));
    g_assert_cmpint (tree.n, ==, n);
    check_fronts (&tree);
    check_entries (&tree, ap, ai);
    check_postorder (&tree);
    qn_front_tree_clear (&tree);
    qn_pool_clear (&pool);
  }
}

static void
test_empty (void)
{
  const int32_t ap[] = { 0 }, ai[] = { 0 };
  QnFrontTree tree;

  g_assert_true (qn_front_tree_init (&tree, 0, ap, ai));
  g_assert_cmpint (tree.front_count, ==, 0);
  qn_front_tree_clear (&tree);
}

QN_TESTS
{
  g_test_add_func ("/front-tree/random", test_random);
  g_test_add_func ("/front-tree/empty", test_empty);
}
