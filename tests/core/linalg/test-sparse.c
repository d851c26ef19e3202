#include "core/linalg/sparse.h"
#include "support/room.h"

#include <glib.h>

/* Cliques {0 1}, {1 2}, {1 2} again, with fixed unknowns in between. */
static void
test_cliques (void)
{
  const int32_t first[] = { 0, QN_NONE, 1 }, second[] = { 2, 1 };
  const int32_t expected_ap[] = { 0, 2, 5, 7 }, expected_ai[] = { 0, 1, 0, 1, 2, 1, 2 };
  int32_t *ap, *ai;
  QnSparsePattern pattern;
  QnPool pool = { 0 };

  qn_sparse_pattern_init (&pattern, 3, 12, &pool);
  qn_sparse_pattern_add_clique (&pattern, first, 3);
  qn_sparse_pattern_add_clique (&pattern, second, 2);
  qn_sparse_pattern_add_clique (&pattern, second, 2);
  qn_sparse_pattern_compress (&pattern, &ap, &ai);
  g_assert_false (pool.failed);
  for (int i = 0; i < 4; i++)
    g_assert_cmpint (ap[i], ==, expected_ap[i]);
  for (int i = 0; i < 7; i++)
    g_assert_cmpint (ai[i], ==, expected_ai[i]);

  g_assert_cmpint (qn_sparse_find (ap, ai, 2, 1), ==, 4);
  g_assert_cmpint (qn_sparse_find (ap, ai, 2, 0), ==, QN_NONE);
  g_assert_cmpint (qn_sparse_find (ap, ai, QN_NONE, 0), ==, QN_NONE);
  qn_pool_clear (&pool);
}

/* Random cliques against a dense table. */
static void
test_random_pattern (void)
{
  enum { N = 40 };
  bool dense[N][N] = { { false } };
  int32_t *ap, *ai, entries = 0;
  QnSparsePattern pattern;
  QnPool pool = { 0 };
  GRand *random = g_rand_new_with_seed (7);

  qn_sparse_pattern_init (&pattern, N, 60 * 36, &pool);
  for (int k = 0; k < 60; k++) {
    int32_t unknowns[6];
    for (int i = 0; i < 6; i++)
      unknowns[i] = g_rand_int_range (random, -1, N);
    qn_sparse_pattern_add_clique (&pattern, unknowns, 6);
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++)
        if (unknowns[i] >= 0 && unknowns[j] >= 0)
          dense[unknowns[i]][unknowns[j]] = true;
  }
  qn_sparse_pattern_compress (&pattern, &ap, &ai);
  g_assert_false (pool.failed);
  for (int j = 0; j < N; j++)
    for (int i = 0; i < N; i++) {
      int32_t at = qn_sparse_find (ap, ai, i, j);
      g_assert_true ((at != QN_NONE) == dense[i][j]);
      if (at != QN_NONE)
        g_assert_cmpint (at, ==, entries++);
    }
  g_assert_cmpint (ap[N], ==, entries);
  g_rand_free (random);
  qn_pool_clear (&pool);
}

QN_TESTS
{
  g_test_add_func ("/sparse/cliques", test_cliques);
  g_test_add_func ("/sparse/random-pattern", test_random_pattern);
}
