#include "core/linalg/inertia.h"

#include "core/assembly/assembly.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* LAPACK, as in lanczos.c. */
void dsyev_ (const char *job, const char *part, const int *n, double *a, const int *lda,
             double *w, double *work, const int *lwork, int *info, size_t job_length,
             size_t part_length);

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
  int32_t ap[N + 1], ai[3 * N];
  QnInertiaCount found;
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
    g_assert_cmpint (found.negative, ==, expected);
    g_assert_cmpint (found.zero, ==, 0);
  }
  qn_inertia_free (inertia);
}

/* Of an indefinite matrix, too. */
static void
test_solve (void)
{
  int32_t ap[N + 1], ai[3 * N];
  QnInertiaCount found;
  double ax[3 * N], b[N], product[N] = { 0 };
  fill_chain (1.1, ap, ai, ax);
  QnInertia *inertia = qn_inertia_new (N, ap, ai);
  g_assert_true (qn_inertia_count (inertia, ax, &found));
  g_assert_cmpint (found.negative, >, 0);
  for (int i = 0; i < N; i++)
    b[i] = i + 1;
  g_assert_cmpint (qn_inertia_solve (inertia, b), ==, QN_SOLVE_CONVERGED);
  for (int32_t j = 0; j < N; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      product[ai[k]] += ax[k] * b[j];
  for (int i = 0; i < N; i++)
    g_assert_cmpfloat_with_epsilon (product[i], i + 1, 1e-12);
  qn_inertia_free (inertia);
}

/* --- Against all eigenvalues --------------------------------------------------------------- */

typedef struct {
  int32_t negative, positive; /* eigenvalues beyond the margin */
} Signs;

/* Of the symmetric part, by LAPACK; what is nearer to zero than `margin` times the largest entry has
 * no sign. */
static Signs
eigenvalue_signs (int32_t n, const int32_t *ap, const int32_t *ai, const double *ax,
                  double margin)
{
  size_t size = (size_t) n;
  g_autofree double *a = g_new0 (double, size *size);
  g_autofree double *values = g_new0 (double, size);
  g_autofree double *work = g_new0 (double, 8 * size + 8);
  int length = 8 * n + 8, info;
  double largest = 0;
  Signs signs = { 0, 0 };

  for (int32_t j = 0; j < n; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++) {
      a[(size_t) j * size + (size_t) ai[k]] += 0.5 * ax[k];
      a[(size_t) ai[k] * size + (size_t) j] += 0.5 * ax[k];
      largest = MAX (largest, fabs (ax[k]));
    }
  dsyev_ ("N", "U", &n, a, &n, values, work, &length, &info, 1, 1);
  g_assert_cmpint (info, ==, 0);
  for (size_t i = 0; i < size; i++) {
    signs.negative += values[i] < -margin * largest;
    signs.positive += values[i] > margin * largest;
  }
  return signs;
}

/* The count lies between what certainly is negative and what may be. */
static void
compare_with_eigenvalues (int32_t n, const int32_t *ap, const int32_t *ai,
                          const double *ax)
{
  QnInertiaCount count;
  QnInertia *inertia = qn_inertia_new (n, ap, ai);
  g_assert_nonnull (inertia);
  g_assert_true (qn_inertia_count (inertia, ax, &count));
  g_assert_cmpfloat (count.rounding, <=, 1e-12);
  Signs signs = eigenvalue_signs (n, ap, ai, ax, 1e-13 * n);
  g_assert_cmpint (count.negative, <=, n - signs.positive);
  g_assert_cmpint (count.negative + count.zero, >=, signs.negative);
  g_assert_cmpint (count.negative, >=, signs.negative - count.zero);
  g_assert_cmpint (signs.positive + signs.negative, >=, n - 6 - count.zero);
  qn_inertia_free (inertia);
}

enum { LARGEST = 60, KINDS = 5 };

/* A random pattern, and values of one kind: dominant diagonal; none; diagonal shifted about zero;
 * no diagonal at all, where no pivot can be taken as it comes; not symmetric. */
static void
fill_random (GRand *rand, int kind, int32_t n, int32_t *ap, int32_t *ai, double *ax)
{
  static gboolean full[LARGEST][LARGEST];
  static double value[LARGEST][LARGEST];
  int32_t next = 0;
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      full[i][j] = full[j][i] = i == j || g_rand_double (rand) < 0.1;
      value[i][j] = value[j][i] = g_rand_double_range (rand, -1, 1);
      if (kind == 4)
        value[j][i] = g_rand_double_range (rand, -1, 1);
    }
  for (int i = 0; i < n; i++)
    value[i][i] = kind == 0   ? 20
                  : kind == 1 ? value[i][i]
                  : kind == 3 ? 0
                              : g_rand_double_range (rand, -1, 3);
  for (int32_t j = 0; j < n; j++) {
    ap[j] = next;
    for (int32_t i = 0; i < n; i++)
      if (full[i][j]) {
        ai[next] = i;
        ax[next++] = value[i][j];
      }
  }
  ap[n] = next;
}

static void
test_random (void)
{
  static int32_t ap[LARGEST + 1], ai[LARGEST * LARGEST];
  static double ax[LARGEST * LARGEST];
  g_autoptr (GRand) rand = g_rand_new_with_seed (7);
  for (int i = 0; i < 1000; i++) {
    int32_t n = g_rand_int_range (rand, 1, LARGEST + 1);
    fill_random (rand, i % KINDS, n, ap, ai, ax);
    compare_with_eigenvalues (n, ap, ai, ax);
  }
}

/* Zero pivots that only exchanges get past. */
static void
test_exchanges (void)
{
  const int32_t ap[] = { 0, 2, 4 }, ai[] = { 0, 1, 0, 1 };
  const double ax[] = { 0, 1, 1, 0 }, nothing[] = { 0, 0, 0, 0 };
  QnInertiaCount count;
  QnInertia *inertia = qn_inertia_new (2, ap, ai);
  g_assert_true (qn_inertia_count (inertia, ax, &count));
  g_assert_cmpint (count.negative, ==, 1);
  g_assert_cmpint (count.zero, ==, 0);
  g_assert_true (qn_inertia_count (inertia, nothing, &count));
  g_assert_cmpint (count.negative, ==, 0);
  g_assert_cmpint (count.zero, ==, 2);
  qn_inertia_free (inertia);
}

/* Tangents of the walls as they are displaced at random: joints stick, slide and open. */
static void
test_tangents (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (3);
  int indefinite = 0;
  for (int number = 1; number <= TEST_WALL_COUNT; number++)
    for (int associative = 0; associative < 2; associative++) {
      g_auto (QnModel) model;
      g_auto (QnContacts) contacts;
      QnAssembly as;
      test_model_init_wall (&model, number, associative ? 0.65 : 0);
      model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
      g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
      g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
      g_assert_cmpint (qn_assembly_setup (&as, &model, &contacts, NULL), ==, QN_OK);
      int32_t n = as.unknown_count;
      g_autofree double *u = g_new (double, n);
      for (int k = 0; k < 2; k++) {
        for (int32_t i = 0; i < n; i++)
          u[i] = (i % 3 == 1 ? -1e-3 * i / n : 0)
                 + g_rand_double_range (rand, -3e-4, 3e-4) * k;
        g_assert_true (qn_assembly_evaluate (&as, u));
        qn_assembly_tangent (&as, 0.1, 0);
        compare_with_eigenvalues (n, as.ap, as.ai, as.ax);
        indefinite += eigenvalue_signs (n, as.ap, as.ai, as.ax, 1e-9).negative > 0;
      }
      qn_assembly_clear (&as);
    }
  g_test_message ("%d tangents are indefinite", indefinite);
  g_assert_cmpint (indefinite, >, 3);
}

QN_TESTS
{
  g_test_add_func ("/inertia/chain", test_chain);
  g_test_add_func ("/inertia/solve", test_solve);
  g_test_add_func ("/inertia/random", test_random);
  g_test_add_func ("/inertia/exchanges", test_exchanges);
  g_test_add_func ("/inertia/tangents", test_tangents);
}
