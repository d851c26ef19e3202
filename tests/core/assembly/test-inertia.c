#include "core/assembly/inertia.h"

#include <glib.h>
#include <math.h>

#define N 6

/* A chain of springs with a shift: tridiagonal, diagonal 2 - s, beside it -1; eigenvalues
 * 2 - s - 2 cos (k pi / (N + 1)). */
static void
fill_chain (double shift, int32_t *ap, int32_t *ai, double *ax)
{
  int32_t next = 0;
  for (int32_t j = 0; j < N; j++) {
    ap[j] = next;
    for (int32_t i = MAX (j - 1, 0); i <= MIN (j + 1, N - 1); i++) {
      ai[next] = i;
      ax[next++] = i == j ? 2 - shift : -1;
    }
  }
  ap[N] = next;
}

static void
test_chain (void)
{
  int32_t ap[N + 1], ai[3 * N], found;
  double ax[3 * N];
  fill_chain (0, ap, ai, ax);
  QnInertia *inertia = qn_inertia_new (N, ap, ai);
  g_assert_nonnull (inertia);
  for (double shift = 0; shift < 4.2; shift += 0.03) {
    int expected = 0;
    for (int k = 1; k <= N; k++)
      expected += 2 - shift - 2 * cos (k * G_PI / (N + 1)) < 0;
    fill_chain (shift, ap, ai, ax);
    g_assert_true (qn_inertia_count (inertia, ax, &found));
    g_assert_cmpint (found, ==, expected);
  }
  qn_inertia_free (inertia);
}

/* Of an indefinite matrix, too. */
static void
test_solve (void)
{
  int32_t ap[N + 1], ai[3 * N], found;
  double ax[3 * N], b[N], product[N] = { 0 };
  fill_chain (1.1, ap, ai, ax);
  QnInertia *inertia = qn_inertia_new (N, ap, ai);
  g_assert_true (qn_inertia_count (inertia, ax, &found));
  g_assert_cmpint (found, >, 0);
  for (int i = 0; i < N; i++)
    b[i] = i + 1;
  g_assert_cmpint (qn_inertia_solve (inertia, b), ==, QN_FACTOR_OK);
  for (int32_t j = 0; j < N; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      product[ai[k]] += ax[k] * b[j];
  for (int i = 0; i < N; i++)
    g_assert_cmpfloat_with_epsilon (product[i], i + 1, 1e-12);
  qn_inertia_free (inertia);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/inertia/chain", test_chain);
  g_test_add_func ("/inertia/solve", test_solve);
  return g_test_run ();
}
