#include "core/linalg/inertia.h"

#include "core/base/memory.h"
#include "core/linalg/sparse.h"

#include <cholmod.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Factors whose |L| |D| |L'| exceeds the matrix by more than this have lost too many digits. */
#define GROWTH 1e3

/* Largest matrix that is factorised as a dense one. */
#define DENSE 900

/* Pivots below so many units in the last place of what they are the sum of are zero. */
#define ZERO (64 * DBL_EPSILON)

/* Stands for a pivot that vanishes: its reciprocal squared does not overflow. */
#define VANISHED 1e-80

/* LAPACK: L D L' with exchanges of a dense symmetric matrix. The length of the text comes last. */
void dsytrf_ (const char *part, const int *n, double *a, const int *lda, int *pivots,
              double *work, const int *work_length, int *info, size_t);

struct QnInertia {
  QnPool pool; /* of all that is not CHOLMOD's */
  int32_t n;
  const int32_t *ap, *ai;
  cholmod_common common;
  cholmod_sparse *upper; /* columns of the upper triangle */
  cholmod_factor *factor;
  cholmod_dense *right;
  double *sums;    /* n: diagonal of |L| |D| |L'| */
  int32_t *places; /* in ax, of the upper triangle's entries; and */
  int32_t *mirror; /* where the transpose of every entry stands there */
};

/* The pattern of the upper triangle, and its elimination. False where memory runs out. */
static bool
analyze (QnInertia *inertia)
{
  size_t n = (size_t) inertia->n, count = 0;
  const int32_t *ap = inertia->ap, *ai = inertia->ai;

  for (int32_t j = 0; j < inertia->n; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      count += ai[k] <= j;
  inertia->upper =
    cholmod_allocate_sparse (n, n, count, 1, 1, 1, CHOLMOD_REAL, &inertia->common);
  inertia->places = qn_pool_alloc (&inertia->pool, count, sizeof *inertia->places);
  if (inertia->upper == NULL || inertia->places == NULL)
    return false;
  int32_t *up = inertia->upper->p, *ui = inertia->upper->i, next = 0;
  for (int32_t j = 0; j < inertia->n; j++) {
    up[j] = next;
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      if (ai[k] <= j) {
        ui[next] = ai[k];
        inertia->places[next++] = k;
      }
  }
  up[inertia->n] = next;
  memset (inertia->upper->x, 0, count * sizeof (double));
  inertia->factor = cholmod_analyze (inertia->upper, &inertia->common);
  return inertia->factor != NULL;
}

QnInertia *
qn_inertia_new (int32_t n, const int32_t *ap, const int32_t *ai)
{
  QnInertia *inertia = qn_alloc (1, sizeof *inertia);

  if (inertia == NULL)
    return NULL;
  cholmod_start (&inertia->common);
  inertia->common.print = 0;
  /* Not L L', which stops at the first negative pivot. */
  inertia->common.supernodal = CHOLMOD_SIMPLICIAL;
  inertia->common.final_ll = 0;
  inertia->common.quick_return_if_not_posdef = 0;
  inertia->common.dbound = VANISHED;
  /* One ordering: where memory for the first runs out, others would be tried silently. */
  inertia->common.nmethods = 1;
  inertia->common.method[0].ordering = CHOLMOD_AMD;
  inertia->n = n;
  inertia->ap = ap;
  inertia->ai = ai;
  inertia->right = cholmod_zeros ((size_t) n, 1, CHOLMOD_REAL, &inertia->common);
  inertia->sums = qn_pool_alloc (&inertia->pool, (size_t) n, sizeof *inertia->sums);
  inertia->mirror = qn_pool_alloc (&inertia->pool, (size_t) ap[n], sizeof (int32_t));
  int32_t *next = qn_pool_alloc (&inertia->pool, (size_t) n, sizeof *next);
  if (inertia->right != NULL && !inertia->pool.failed) {
    qn_sparse_mirror (n, ap, ai, next, inertia->mirror);
    if (analyze (inertia))
      return inertia;
  }
  qn_inertia_free (inertia);
  return NULL;
}

void
qn_inertia_free (QnInertia *inertia)
{
  if (inertia == NULL)
    return;
  cholmod_free_sparse (&inertia->upper, &inertia->common);
  cholmod_free_factor (&inertia->factor, &inertia->common);
  cholmod_free_dense (&inertia->right, &inertia->common);
  cholmod_finish (&inertia->common);
  qn_pool_clear (&inertia->pool);
  free (inertia);
}

/* The same by a dense factorisation with exchanges. Its blocks of two have an eigenvalue of either
 * sign: that is why they were chosen. */
static bool
count_dense (const QnInertia *inertia, const double *ax, double largest,
             QnInertiaCount *count)
{
  int n = inertia->n, length = 32 * n, info;
  size_t size = (size_t) n;
  QnPool room = { 0 };
  double *a = qn_pool_alloc (&room, size * size, sizeof *a),
         *work = qn_pool_alloc (&room, 32 * size, sizeof *work);
  int *pivots = qn_pool_alloc (&room, size, sizeof *pivots);
  bool ok = !room.failed;

  if (ok) {
    for (int32_t j = 0; j < n; j++)
      for (int32_t k = inertia->ap[j]; k < inertia->ap[j + 1]; k++)
        a[(size_t) j * size + (size_t) inertia->ai[k]] =
          0.5 * (ax[k] + ax[inertia->mirror[k]]);
    dsytrf_ ("L", &n, a, &n, pivots, work, &length, &info, 1);
    *count = (QnInertiaCount){ .rounding = DBL_EPSILON };
    for (size_t j = 0; j < size; j++) {
      double pivot = a[j * size + j];
      if (pivots[j] < 0) {
        count->negative++;
        j++;
      } else if (fabs (pivot) <= ZERO * largest) {
        count->zero++;
      } else if (!(pivot > 0)) {
        count->negative++;
      }
    }
  }
  qn_pool_clear (&room);
  return ok;
}

bool
qn_inertia_count (QnInertia *inertia, const double *ax, QnInertiaCount *count)
{
  const int32_t *up = inertia->upper->p, *places = inertia->places;
  double *ux = inertia->upper->x, largest = 0;

  for (int32_t k = 0; k < up[inertia->n]; k++) {
    ux[k] = 0.5 * (ax[places[k]] + ax[inertia->mirror[places[k]]]);
    largest = fmax (largest, fabs (ux[k]));
  }
  cholmod_factorize (inertia->upper, inertia->factor, &inertia->common);
  if (inertia->common.status < CHOLMOD_OK || inertia->factor->x == NULL)
    return false;
  /* Signs of the pivots of a factor, of which each counts as zero that is no more than
   * rounding of the terms it is the sum of, S_kk = sum l^2 d. */
  const cholmod_factor *factor = inertia->factor;
  const int32_t *lp = factor->p, *li = factor->i, *lnz = factor->nz;
  const double *lx = factor->x;
  double *sums = inertia->sums, most = 0;
  memset (sums, 0, (size_t) inertia->n * sizeof *sums);
  for (int32_t j = 0; j < inertia->n; j++) {
    double pivot = fabs (lx[lp[j]]);
    sums[j] += pivot;
    for (int32_t k = lp[j] + 1; k < lp[j] + lnz[j]; k++)
      sums[li[k]] += lx[k] * lx[k] * pivot;
  }
  *count = (QnInertiaCount){ 0 };
  for (int32_t j = 0; j < inertia->n; j++) {
    double pivot = lx[lp[j]];
    most = sums[j] <= most ? most : sums[j]; /* keeps what is no number */
    if (fabs (pivot) <= ZERO * sums[j] || fabs (pivot) <= VANISHED)
      count->zero++;
    else if (!(pivot > 0))
      count->negative++;
  }
  count->rounding = largest > 0 ? DBL_EPSILON * most / largest : 0;
  return count->rounding <= GROWTH * DBL_EPSILON || inertia->n > DENSE
         || count_dense (inertia, ax, largest, count);
}

QnSolveStatus
qn_inertia_solve (QnInertia *inertia, double *b)
{
  size_t bytes = (size_t) inertia->n * sizeof *b;
  bool finite = true;

  memcpy (inertia->right->x, b, bytes);
  cholmod_dense *solution =
    cholmod_solve (CHOLMOD_A, inertia->factor, inertia->right, &inertia->common);
  if (solution == NULL)
    return QN_SOLVE_NO_MEMORY;
  memcpy (b, solution->x, bytes);
  for (int32_t i = 0; i < inertia->n; i++)
    finite = finite && isfinite (b[i]);
  cholmod_free_dense (&solution, &inertia->common);
  return finite ? QN_SOLVE_CONVERGED : QN_SOLVE_FAILED;
}
