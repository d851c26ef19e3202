#include "doc/document/job.h"

#include "core/linalg/block-lu.h"
#include "core/linalg/sparse.h"
#include "support/room.h"

#include <glib.h>

enum { COUNT = 1000, CALLERS = 4, ROUNDS = 200 };

static void
count_part (void *data, int32_t i)
{
  ((int *) data)[i]++;
}

/* Every part is done once, however many callers share the threads. */
static gpointer
call (gpointer data)
{
  (void) data;
  for (int round = 0; round < ROUNDS; round++) {
    int counts[COUNT] = { 0 }, count = round % 2 == 0 ? COUNT : round % 7;
    qn_workers_run (qn_threads_get (), count, count_part, counts);
    for (int i = 0; i < COUNT; i++)
      g_assert_cmpint (counts[i], ==, i < count);
  }
  return NULL;
}

static void
test_callers (void)
{
  GThread *threads[CALLERS];
  for (int i = 0; i < CALLERS; i++)
    threads[i] = g_thread_new ("caller", call, NULL);
  for (int i = 0; i < CALLERS; i++)
    g_thread_join (threads[i]);
}

/* A factorisation in all threads and its solutions are those in one thread, to the bit. */
static void
test_factorisation (void)
{
  enum { SIDE = 200 };
  int32_t *ap, *ai, n = SIDE * SIDE;
  QnSparsePattern pattern;
  QnPool pool = { 0 };
  g_autoptr (GRand) random = g_rand_new_with_seed (23);
  qn_sparse_pattern_init (&pattern, n, (size_t) (16 * n), &pool);
  for (int32_t i = 0; i < n; i++)
    for (int step = 1; step <= SIDE + 1; step += SIDE - 1)
      if (i + step < n) {
        int32_t both[] = { i, i + step };
        qn_sparse_pattern_add_clique (&pattern, both, 2);
      }
  qn_sparse_pattern_compress (&pattern, &ap, &ai);
  g_assert_false (pool.failed);
  g_autofree double *ax = g_new (double, ap[n]), *x = g_new (double, n),
                    *y = g_new (double, n);
  QnBlockLu *one = qn_block_lu_new (n, ap, ai, NULL);
  QnBlockLu *all = qn_block_lu_new (n, ap, ai, qn_threads_get ());
  for (int round = 0; round < 3; round++) {
    for (int32_t j = 0; j < n; j++)
      for (int32_t p = ap[j]; p < ap[j + 1]; p++)
        ax[p] = g_rand_double_range (random, -1, 1) + (ai[p] == j ? 12 : 0);
    for (int32_t i = 0; i < n; i++)
      x[i] = y[i] = g_rand_double (random);
    g_assert_cmpfloat (qn_block_lu_factor (one, ax), ==, qn_block_lu_factor (all, ax));
    qn_block_lu_solve (one, x);
    qn_block_lu_solve (all, y);
    g_assert_cmpmem (x, (gsize) n * sizeof *x, y, (gsize) n * sizeof *y);
  }
  qn_block_lu_free (one);
  qn_block_lu_free (all);
  qn_pool_clear (&pool);
}

QN_TESTS
{
  g_test_add_func ("/threads/callers", test_callers);
  g_test_add_func ("/threads/factorisation", test_factorisation);
}
