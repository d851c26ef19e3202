#include "core/linalg/linsys.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

enum { N = 30 };

/* A full matrix as a pattern: every entry may be anything, zero included. */
typedef struct {
  int32_t ap[N + 1], ai[N * N];
  double ax[N * N], x[N], b[N];
} Dense;

static void
dense_pattern (Dense *d)
{
  for (int j = 0; j <= N; j++)
    d->ap[j] = j * N;
  for (int k = 0; k < N * N; k++)
    d->ai[k] = k % N;
}

/* Random values, and b = A x for a random x. */
static void
dense_random (Dense *d, GRand *random)
{
  for (int k = 0; k < N * N; k++)
    d->ax[k] = g_rand_double_range (random, -1, 1);
  for (int i = 0; i < N; i++)
    d->x[i] = g_rand_double_range (random, -1, 1);
  for (int i = 0; i < N; i++) {
    d->b[i] = 0;
    for (int j = 0; j < N; j++)
      d->b[i] += d->ax[j * N + i] * d->x[j];
  }
}

/* The same system with new values each time: refactorisation must choose new pivots where the
 * old ones have become small. */
static void
test_refactorisation (void)
{
  Dense d;
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  dense_pattern (&d);
  QnLinsys *system = qn_linsys_new (N, d.ap, d.ai, NULL);
  g_assert_nonnull (system);

  for (int k = 0; k < 50; k++) {
    dense_random (&d, random);
    if (k % 3 == 2)
      d.b[0] -= d.ax[0] * d.x[0], d.ax[0] = 0; /* no diagonal pivot */
    g_assert_cmpint (qn_linsys_factor (system, d.ax), ==, QN_SOLVE_CONVERGED);
    qn_linsys_solve (system, d.b);
    for (int i = 0; i < N; i++)
      g_assert_cmpfloat (fabs (d.b[i] - d.x[i]), <, 1e-8);
  }
  qn_linsys_free (system);
}

/* Elimination with row exchanges, the textbook way. */
static int
sign_of_determinant (const Dense *d)
{
  double a[N][N];
  int sign = 1;

  for (int k = 0; k < N * N; k++)
    a[k % N][k / N] = d->ax[k];
  for (int c = 0; c < N; c++) {
    int pivot = c;
    for (int r = c + 1; r < N; r++)
      if (fabs (a[r][c]) > fabs (a[pivot][c]))
        pivot = r;
    for (int k = 0; k < N; k++) {
      double value = a[pivot][k];
      a[pivot][k] = a[c][k];
      a[c][k] = value;
    }
    if ((pivot != c) != (a[c][c] < 0))
      sign = -sign;
    for (int r = c + 1; r < N; r++)
      for (int k = N - 1; k >= c; k--)
        a[r][k] -= a[r][c] / a[c][c] * a[c][k];
  }
  return sign;
}

/* Of matrices that blocks factorise (with a weight on the diagonal) and that KLU must, both
 * with old pivots and with new ones. */
static void
test_sign (void)
{
  Dense d;
  int negative = 0;
  g_autoptr (GRand) random = g_rand_new_with_seed (7);
  dense_pattern (&d);
  QnLinsys *system = qn_linsys_new (N, d.ap, d.ai, NULL);

  for (int k = 0; k < 60; k++) {
    dense_random (&d, random);
    for (int i = 0; i < N && k % 2 == 0; i++)
      d.ax[i * N + i] += g_rand_boolean (random) ? 9 : -9;
    g_assert_cmpint (qn_linsys_factor (system, d.ax), ==, QN_SOLVE_CONVERGED);
    g_assert_cmpint (qn_linsys_sign (system), ==, sign_of_determinant (&d));
    negative += qn_linsys_sign (system) < 0;
  }
  g_assert_cmpint (negative, >, 15);
  g_assert_cmpint (negative, <, 45);
  qn_linsys_free (system);
}

/* Factorising and solving at once, with and without KLU; a right-hand side of zeros says
 * nothing about factors, and has its solution all the same. */
static void
test_at_once (void)
{
  Dense d;
  g_autoptr (GRand) random = g_rand_new_with_seed (9);
  dense_pattern (&d);
  QnLinsys *system = qn_linsys_new (N, d.ap, d.ai, NULL);

  for (int k = 0; k < 40; k++) {
    double zeros[N] = { 0 };
    dense_random (&d, random);
    for (int i = 0; i < N && k % 2 == 0; i++)
      d.b[i] += 9 * d.x[i], d.ax[i * N + i] += 9;
    g_assert_cmpint (qn_linsys_factor_and_solve (system, d.ax, zeros), ==,
                     QN_SOLVE_CONVERGED);
    for (int again = 0; again < 2; again++) { /* the second time the factors are there */
      double b[N];
      memcpy (b, d.b, sizeof b);
      g_assert_cmpint (qn_linsys_factor_and_solve (system, d.ax, b), ==,
                       QN_SOLVE_CONVERGED);
      for (int i = 0; i < N; i++) {
        g_assert_cmpfloat (zeros[i], ==, 0);
        g_assert_cmpfloat (fabs (b[i] - d.x[i]), <, 1e-8);
      }
      g_assert_cmpfloat (qn_linsys_work (system), ==, 0);
    }
  }
  qn_linsys_free (system);
}

static void
test_singular (void)
{
  Dense d;
  g_autoptr (GRand) random = g_rand_new_with_seed (5);
  dense_pattern (&d);
  dense_random (&d, random);
  QnLinsys *system = qn_linsys_new (N, d.ap, d.ai, NULL);

  g_assert_cmpint (qn_linsys_factor (system, d.ax), ==, QN_SOLVE_CONVERGED);
  for (int i = 0; i < N; i++)
    d.ax[3 * N + i] = 2 * d.ax[7 * N + i]; /* two parallel columns */
  g_assert_cmpint (qn_linsys_factor (system, d.ax), ==, QN_SOLVE_FAILED);

  dense_random (&d, random); /* and the system is as good as before afterwards */
  g_assert_cmpint (qn_linsys_factor (system, d.ax), ==, QN_SOLVE_CONVERGED);
  qn_linsys_solve (system, d.b);
  for (int i = 0; i < N; i++)
    g_assert_cmpfloat (fabs (d.b[i] - d.x[i]), <, 1e-8);
  qn_linsys_free (system);
}

/* An unknown that nothing holds, pushed and not: the solution of the first proves it by its size, that
 * of the other does not. */
static void
test_free_unknown (void)
{
  Dense d;
  g_autoptr (GRand) random = g_rand_new_with_seed (6);
  dense_pattern (&d);
  dense_random (&d, random);
  QnLinsys *system = qn_linsys_new (N, d.ap, d.ai, NULL);

  for (int i = 0; i < N; i++)
    d.ax[5 * N + i] = d.ax[i * N + 5] = 0;
  for (int pushed = 0; pushed < 2; pushed++) {
    d.b[5] = pushed;
    for (int again = 0; again < 2;
         again++) { /* the same matrix is as singular as before */
      double b[N];
      memcpy (b, d.b, sizeof b);
      g_assert_cmpint (qn_linsys_factor_and_solve (system, d.ax, b), ==, QN_SOLVE_FAILED);
    }
  }
  qn_linsys_free (system);
}

QN_TESTS
{
  g_test_add_func ("/linsys/refactorisation", test_refactorisation);
  g_test_add_func ("/linsys/at-once", test_at_once);
  g_test_add_func ("/linsys/singular", test_singular);
  g_test_add_func ("/linsys/free-unknown", test_free_unknown);
  g_test_add_func ("/linsys/sign", test_sign);
}
