#include "core/linalg/inertia.h"

#include "core/base/memory.h"
#include "core/linalg/sparse.h"

#include <cholmod.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Orders of elimination that are tried where the factors of one lose digits. */
#define ORDERS 3

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

/* One order of elimination. */
typedef struct {
  cholmod_sparse *upper; /* columns of the upper triangle */
  cholmod_factor *factor;
  int32_t *position; /* n: where each unknown stands in it */
  int32_t *places;   /* of its entries in ax */
} Order;

struct QnInertia {
  QnPool pool; /* of all that is not CHOLMOD's */
  int32_t n;
  const int32_t *ap, *ai;
  cholmod_common common;
  Order orders[ORDERS];
  int used; /* the order of the last factorisation */
  cholmod_dense *right;
  double *sums;    /* n: diagonal of |L| |D| |L'| */
  int32_t *mirror; /* where the transpose of every entry stands in ax */
};

/* The unknowns shuffled, another way for every number; as they are for 0. */
static void
shuffle (int32_t *position, int32_t n, int number)
{
  uint64_t state = 0x9e3779b97f4a7c15u * (uint64_t) number;

  for (int32_t i = 0; i < n; i++) {
    int32_t other = i;
    if (number > 0) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      other = (int32_t) ((state >> 33) % (uint64_t) (i + 1));
    }
    position[i] = position[other];
    position[other] = i;
  }
}

/* Copies the upper triangle of the pattern with its unknowns at their positions. */
static bool
take_pattern (QnInertia *inertia, Order *order, int number)
{
  size_t n = (size_t) inertia->n, count = 0;
  const int32_t *ap = inertia->ap, *ai = inertia->ai;
  int32_t *position = qn_pool_alloc (&inertia->pool, n, sizeof *position);

  if (position == NULL)
    return false;
  order->position = position;
  shuffle (position, inertia->n, number);
  for (int32_t j = 0; j < inertia->n; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      count += position[ai[k]] <= position[j];
  order->upper =
    cholmod_allocate_sparse (n, n, count, 0, 1, 1, CHOLMOD_REAL, &inertia->common);
  order->places = qn_pool_alloc (&inertia->pool, count, sizeof *order->places);
  int32_t *column = qn_alloc (n, sizeof *column);
  bool ok = order->upper && order->places && column;
  if (ok) {
    int32_t *up = order->upper->p, *ui = order->upper->i, next = 0;
    for (int32_t j = 0; j < inertia->n; j++)
      column[position[j]] = j;
    for (int32_t c = 0; c < inertia->n; c++) {
      up[c] = next;
      for (int32_t k = ap[column[c]]; k < ap[column[c] + 1]; k++)
        if (position[ai[k]] <= c) {
          ui[next] = position[ai[k]];
          order->places[next++] = k;
        }
    }
    up[inertia->n] = next;
    memset (order->upper->x, 0, count * sizeof (double));
  }
  free (column);
  return ok;
}

static bool
set_up_order (QnInertia *inertia, int number)
{
  Order *order = &inertia->orders[number];

  if (order->factor != NULL)
    return true;
  if (take_pattern (inertia, order, number))
    order->factor = cholmod_analyze (order->upper, &inertia->common);
  return order->factor != NULL;
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
    if (set_up_order (inertia, 0))
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
  for (int i = 0; i < ORDERS; i++) {
    Order *order = &inertia->orders[i];
    cholmod_free_sparse (&order->upper, &inertia->common);
    cholmod_free_factor (&order->factor, &inertia->common);
  }
  cholmod_free_dense (&inertia->right, &inertia->common);
  cholmod_finish (&inertia->common);
  qn_pool_clear (&inertia->pool);
  free (inertia);
}

/* Signs of the pivots of a factor, of which each counts as zero that is no more than rounding of
 * the terms it is the sum of, S_kk = sum l^2 d. */
static void
count_pivots (QnInertia *inertia, const cholmod_factor *factor, double largest,
              QnInertiaCount *count)
{
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
  double largest = 0;

  for (int number = 0; number < ORDERS; number++) {
    if (!set_up_order (inertia, number))
      return false;
    Order *order = &inertia->orders[number];
    const int32_t *up = order->upper->p;
    double *ux = order->upper->x;
    for (int32_t k = 0; k < up[inertia->n]; k++) {
      ux[k] = 0.5 * (ax[order->places[k]] + ax[inertia->mirror[order->places[k]]]);
      largest = fmax (largest, fabs (ux[k]));
    }
    cholmod_factorize (order->upper, order->factor, &inertia->common);
    if (inertia->common.status < CHOLMOD_OK || order->factor->x == NULL)
      return false;
    inertia->used = number;
    count_pivots (inertia, order->factor, largest, count);
    if (count->rounding <= GROWTH * DBL_EPSILON)
      return true;
  }
  return inertia->n > DENSE || count_dense (inertia, ax, largest, count);
}

QnSolveStatus
qn_inertia_solve (QnInertia *inertia, double *b)
{
  const Order *order = &inertia->orders[inertia->used];
  double *right = inertia->right->x;

  for (int32_t i = 0; i < inertia->n; i++)
    right[order->position[i]] = b[i];
  cholmod_dense *solution =
    cholmod_solve (CHOLMOD_A, order->factor, inertia->right, &inertia->common);
  if (solution == NULL)
    return QN_SOLVE_NO_MEMORY;
  const double *x = solution->x;
  bool finite = true;
  for (int32_t i = 0; i < inertia->n; i++) {
    b[i] = x[order->position[i]];
    finite = finite && isfinite (b[i]);
  }
  cholmod_free_dense (&solution, &inertia->common);
  return finite ? QN_SOLVE_CONVERGED : QN_SOLVE_FAILED;
}
