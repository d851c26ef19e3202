/* Two factorisations behind one interface.
 *
 * Block LU is several times faster on the tangents of block masonry, but pivots within
 * blocks only. Every factorisation is therefore tried out on the first system that is to be
 * solved; where the digits are not there, KLU takes over: left-looking scalar LU with threshold
 * pivoting (Davis & Palamadai Natarajan 2010), which also has the last word on what is
 * singular unless that solution proves it.
 */
#include "core/linalg/linsys.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/base/tolerance.h"
#include "core/linalg/block-lu.h"

#include <klu.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct QnLinsys {
  QnPool pool; /* of numbers */
  int32_t n;
  /* KLU takes its read-only arguments without const. */
  int32_t *ap, *ai;
  QnBlockLu *blocks;
  double *trial;        /* n: right-hand side that the last factorisation was tried on, */
  double *solution;     /* its solution where it is not requested, */
  double *left;         /* and what that leaves */
  bool pivoted;         /* the last factorisation is KLU's */
  QnSolveStatus status; /* of the last factorisation, */
  double work;          /* and what part of a whole one it took */
  klu_common common;
  klu_symbolic *symbolic; /* NULL until it is needed */
  klu_numeric *numeric;
  int parity;    /* of the permutations of rows and columns together */
  bool *visited; /* scratch of sign_of_permutation() */
};

QnLinsys *
qn_linsys_new (int32_t n, const int32_t *ap, const int32_t *ai, const QnWorkers *workers)
{
  QnLinsys *system = qn_alloc (1, sizeof *system);

  if (system == NULL)
    return NULL;
  klu_defaults (&system->common);
  system->common.btf = 0; /* the pattern is symmetric and connected: nothing to permute */
  system->common.ordering = 0; /* AMD */
  system->common.tol = 0.001;  /* prefer the diagonal, keeping the symmetric ordering */
  system->common.scale = 0;    /* degrees of freedom are scaled to one unit already */
  system->n = n;
  system->ap = (int32_t *) ap;
  system->ai = (int32_t *) ai;
  system->blocks = qn_block_lu_new (n, ap, ai, workers);
  system->trial = qn_pool_alloc (&system->pool, (size_t) n, sizeof *system->trial);
  system->solution = qn_pool_alloc (&system->pool, (size_t) n, sizeof *system->solution);
  system->left = qn_pool_alloc (&system->pool, (size_t) n, sizeof *system->left);
  system->visited = qn_pool_alloc (&system->pool, (size_t) n, sizeof *system->visited);
  if (system->blocks == NULL || system->pool.failed) {
    qn_linsys_free (system);
    return NULL;
  }
  return system;
}

void
qn_linsys_free (QnLinsys *system)
{
  if (system == NULL)
    return;
  qn_block_lu_free (system->blocks);
  klu_free_numeric (&system->numeric, &system->common);
  klu_free_symbolic (&system->symbolic, &system->common);
  qn_pool_clear (&system->pool);
  free (system);
}

/* --- KLU -------------------------------------------------------------------------------- */

/* 1 for an even permutation of n things, -1 for an odd one. A cycle of even length is odd. */
static int
sign_of_permutation (const int32_t *permutation, int32_t n, bool *visited)
{
  int sign = 1;

  memset (visited, 0, (size_t) n * sizeof *visited);
  for (int32_t i = 0; i < n; i++) {
    int32_t length = 0;
    for (int32_t k = i; !visited[k]; k = permutation[k], length++)
      visited[k] = true;
    if (length > 0 && length % 2 == 0)
      sign = -sign;
  }
  return sign;
}

static QnSolveStatus
factor_pivoting (QnLinsys *system, double *ax)
{
  if (system->symbolic == NULL)
    system->symbolic = klu_analyze (system->n, system->ap, system->ai, &system->common);
  if (system->symbolic == NULL)
    return QN_SOLVE_NO_MEMORY;
  klu_free_numeric (&system->numeric, &system->common);
  system->numeric =
    klu_factor (system->ap, system->ai, ax, system->symbolic, &system->common);
  if (system->common.status == KLU_SINGULAR)
    return QN_SOLVE_FAILED;
  if (system->numeric == NULL)
    return QN_SOLVE_NO_MEMORY;
  system->parity =
    sign_of_permutation (system->numeric->Pnum, system->n, system->visited)
    * sign_of_permutation (system->symbolic->Q, system->n, system->visited);
  klu_rcond (system->symbolic, system->numeric, &system->common);
  return system->common.rcond > QN_TOLERANCE_SINGULAR ? QN_SOLVE_CONVERGED
                                                      : QN_SOLVE_FAILED;
}

/* --- Which of the two ------------------------------------------------------------------- */

/* The block factorisation's solution of A x = trial, by sizes (largest numbers). */
typedef struct {
  double matrix, solution, right;
  double left; /* of trial - A x */
} Trial;

static Trial
try_blocks (QnLinsys *system, const double *ax, double *x)
{
  const int32_t *ap = system->ap, *ai = system->ai;
  double *left = system->left;
  Trial trial = { 0 };

  for (int32_t i = 0; i < system->n; i++) {
    x[i] = left[i] = system->trial[i];
    trial.right = qn_max (fabs (left[i]), trial.right);
  }
  qn_block_lu_solve (system->blocks, x);
  for (int32_t j = 0; j < system->n; j++) {
    for (int32_t p = ap[j]; p < ap[j + 1]; p++) {
      left[ai[p]] -= ax[p] * x[j];
      trial.matrix = qn_max (fabs (ax[p]), trial.matrix);
    }
    trial.solution = qn_max (fabs (x[j]), trial.solution);
  }
  for (int32_t i = 0; i < system->n; i++)
    if (!(fabs (left[i]) <= trial.left)
        && !isnan (trial.left)) /* keeps what is no number */
      trial.left = fabs (left[i]);
  return trial;
}

double
qn_linsys_work (const QnLinsys *system)
{
  return system->work;
}

static bool
is_zero (const double *b, int32_t n)
{
  int32_t i = 0;

  while (i < n && b[i] == 0)
    i++;
  return i == n;
}

QnSolveStatus
qn_linsys_factor_and_solve (QnLinsys *system, const double *ax, double *b)
{
  bool zero = b == NULL || is_zero (b, system->n);
  double pivots = qn_block_lu_refactor (system->blocks, ax, &system->work);

  if (system->work == 0 && system->n > 0) { /* the same matrix */
    if (b != NULL && system->status == QN_SOLVE_CONVERGED)
      qn_linsys_solve (system, b);
    return system->status;
  }
  for (int32_t i = 0; i < system->n; i++)
    system->trial[i] = zero ? 1 : b[i];
  system->pivoted = false;
  if (pivots > 0) {
    Trial trial = try_blocks (system, ax, zero ? system->solution : b);
    /* |trial - A x| / (|A| |x| + |trial|), Rigal & Gaches 1967 */
    if (pivots > QN_TOLERANCE_SINGULAR
        && trial.left / (trial.matrix * trial.solution + trial.right)
             < QN_TOLERANCE_BACKWARD)
      return system->status = QN_SOLVE_CONVERGED;
    /* A maps x to nothing, for |A x| is at most |trial| + |trial - A x|: then A is that
     * close to a matrix without an inverse. */
    if (isfinite (trial.solution)
        && trial.right + trial.left
             <= QN_TOLERANCE_SINGULAR * trial.matrix * trial.solution)
      return system->status = QN_SOLVE_FAILED;
  }
  system->pivoted = true;
  system->status = factor_pivoting (system, (double *) ax);
  if (!zero && system->status == QN_SOLVE_CONVERGED) {
    memcpy (b, system->trial, (size_t) system->n * sizeof *b);
    qn_linsys_solve (system, b);
  }
  return system->status;
}

QnSolveStatus
qn_linsys_factor (QnLinsys *system, const double *ax)
{
  return qn_linsys_factor_and_solve (system, ax, NULL);
}

void
qn_linsys_solve (QnLinsys *system, double *b)
{
  if (!system->pivoted) {
    qn_block_lu_solve (system->blocks, b);
    return;
  }
  QN_ASSERT (system->numeric != NULL);
  klu_solve (system->symbolic, system->numeric, system->n, 1, b, &system->common);
}

int
qn_linsys_sign (const QnLinsys *system)
{
  if (!system->pivoted)
    return qn_block_lu_sign (system->blocks);

  const double *pivots = system->numeric->Udiag;
  int sign = system->parity;
  for (int32_t i = 0; i < system->n; i++)
    sign = pivots[i] < 0 ? -sign : sign;
  return sign;
}
