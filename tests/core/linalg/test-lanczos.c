#include "core/linalg/lanczos.h"
#include "support/room.h"

#include <float.h>
#include <glib.h>
#include <math.h>

/* Diagonal pencils: the operator's arithmetic is trivial, the iteration's is not. */
typedef struct Diagonal {
  int n;
  double *k, *m;
  double shift;
  int products, allowed;
} Diagonal;

static void
multiply (void *data, const double *x, double *y)
{
  const Diagonal *d = data;
  for (int i = 0; i < d->n; i++)
    y[i] = d->m[i] * x[i];
}

static void
solve (void *data, double *b)
{
  const Diagonal *d = data;
  for (int i = 0; i < d->n; i++)
    b[i] /= d->k[i] - d->shift * d->m[i];
}

static bool
go_on (void *data)
{
  Diagonal *d = data;
  return ++d->products != d->allowed;
}

static void
diagonal_init (Diagonal *d, int n, double shift)
{
  *d = (Diagonal){ .n = n, .shift = shift };
  d->k = g_new (double, n);
  d->m = g_new (double, n);
  for (int i = 0; i < n; i++) {
    d->m[i] = 1 + i % 3;
    d->k[i] = d->m[i] * (i + 1);
  }
}

static void
diagonal_clear (Diagonal *d)
{
  g_free (d->k);
  g_free (d->m);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Diagonal, diagonal_clear)

/* What rounding of the largest eigenvalue of the operator makes of that of `value`. */
static double
rounding (const Diagonal *d, double least, double value)
{
  double spread = (value - d->shift) / (least - d->shift);
  return 100 * DBL_EPSILON * (fabs (spread * value) + fabs (d->shift));
}

/* Values, and that the vectors are orthonormal in M and lie along the axes of their values. */
static void
check (Diagonal *d, size_t wanted, const double *expected, size_t count)
{
  const QnLanczosProblem problem = {
    .n = d->n, .shift = d->shift, .multiply = multiply, .solve = solve, .data = d
  };
  size_t n = (size_t) d->n, found = 0;
  double *values = g_new0 (double, wanted), *vectors = g_new0 (double, wanted *n);
  g_assert_cmpint (qn_lanczos_run (&problem, wanted, &found, values, vectors), ==,
                   QN_SOLVE_CONVERGED);
  g_assert_cmpuint (found, ==, count);
  for (size_t a = 0; a < count; a++) {
    const double *x = vectors + a * n;
    g_test_message ("%zu: %.15g", a, values[a]);
    g_assert_cmpfloat_with_epsilon (values[a], expected[a],
                                    rounding (d, expected[0], expected[a]));
    for (size_t b = 0; b < count; b++) {
      double product = 0;
      for (size_t i = 0; i < n; i++)
        product += x[i] * d->m[i] * vectors[b * n + i];
      g_assert_cmpfloat_with_epsilon (product, a == b, 1e-12);
    }
    for (size_t i = 0; i < n; i++)
      if (d->m[i] > 0
          && fabs (d->k[i] / d->m[i] - values[a]) > 1e-3 * (1 + fabs (values[a])))
        g_assert_cmpfloat (fabs (x[i]), <, 1e-7);
  }
  g_free (values);
  g_free (vectors);
}

static void
test_simple (void)
{
  g_auto (Diagonal) d;
  diagonal_init (&d, 500, -0.5);
  check (&d, 6, (const double[]){ 1, 2, 3, 4, 5, 6 }, 6);
}

/* More unknowns than the basis has room for, and values that come four times: no Krylov space
 * of one start holds more than one vector of each. */
static void
test_multiple (void)
{
  g_auto (Diagonal) d;
  diagonal_init (&d, 800, -1e-3);
  for (int i = 0; i < d.n; i++)
    d.k[i] = d.m[i] * (i / 4);
  check (&d, 10, (const double[]){ 0, 0, 0, 0, 1, 1, 1, 1, 2, 2 }, 10);
}

/* Every one that there is, also where all are the same. */
static void
test_all (void)
{
  g_auto (Diagonal) d;
  diagonal_init (&d, 4, -1);
  check (&d, 9, (const double[]){ 1, 2, 3, 4 }, 4);
  for (int i = 0; i < 4; i++)
    d.k[i] = 7 * d.m[i];
  check (&d, 9, (const double[]){ 7, 7, 7, 7 }, 4);
  d.n = 1;
  check (&d, 1, (const double[]){ 7 }, 1);
}

/* What has no mass does not vibrate. */
static void
test_without_mass (void)
{
  g_auto (Diagonal) d;
  diagonal_init (&d, 60, -1);
  for (int i = 3; i < d.n; i++)
    d.m[i] = 0;
  check (&d, 5, (const double[]){ 1, 2, 3 }, 3);
  for (int i = 0; i < 3; i++)
    d.m[i] = 0;
  check (&d, 5, NULL, 0);
}

/* Rigid motions a hundred million times softer than the rest. */
static void
test_far_apart (void)
{
  g_auto (Diagonal) d;
  diagonal_init (&d, 300, -10);
  for (int i = 0; i < d.n; i++)
    d.k[i] = i < 3 ? 0 : d.m[i] * 1e8 * i;
  check (&d, 5, (const double[]){ 0, 0, 0, 3e8, 4e8 }, 5);
}

/* The iteration can be left at every product. */
static void
test_cancel (void)
{
  enum { WANTED = 4, N = 300 };
  g_auto (Diagonal) d;
  double values[WANTED], vectors[WANTED * N];
  size_t found;
  diagonal_init (&d, N, -1);
  const QnLanczosProblem problem = {
    .n = N, .shift = -1, .multiply = multiply, .solve = solve, .go_on = go_on, .data = &d
  };
  g_assert_cmpint (qn_lanczos_run (&problem, WANTED, &found, values, vectors), ==,
                   QN_SOLVE_CONVERGED);
  int products = d.products;
  g_assert_cmpint (products, >, 20);
  for (d.allowed = 1; d.allowed <= products; d.allowed++) {
    d.products = 0;
    g_assert_cmpint (qn_lanczos_run (&problem, WANTED, &found, values, vectors), ==,
                     QN_SOLVE_CANCELLED);
    g_assert_cmpint (d.products, ==, d.allowed);
    g_assert_cmpuint (found, ==, 0);
  }
}

QN_TESTS
{
  g_test_add_func ("/lanczos/simple", test_simple);
  g_test_add_func ("/lanczos/multiple", test_multiple);
  g_test_add_func ("/lanczos/all", test_all);
  g_test_add_func ("/lanczos/without-mass", test_without_mass);
  g_test_add_func ("/lanczos/far-apart", test_far_apart);
  g_test_add_func ("/lanczos/cancel", test_cancel);
}
