#include "core/assembly/inertia.h"

#include "core/base/memory.h"

#include <cholmod.h>
#include <stdlib.h>
#include <string.h>

struct QnInertia {
  int32_t n;
  cholmod_common common;
  cholmod_sparse *upper; /* columns of the upper triangle */
  cholmod_factor *factor;
  cholmod_dense *right;
  int32_t *places; /* of its entries in ax */
};

/* Copies the upper triangle of the pattern. */
static bool
take_pattern (QnInertia *inertia, const int32_t *ap, const int32_t *ai)
{
  size_t n = (size_t) inertia->n, count = 0;

  for (int32_t j = 0; j < inertia->n; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      count += ai[k] <= j;
  inertia->upper =
    cholmod_allocate_sparse (n, n, count, 1, 1, 1, CHOLMOD_REAL, &inertia->common);
  inertia->places = qn_alloc (count, sizeof *inertia->places);
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
  return true;
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
  /* One ordering: where memory for the first runs out, others would be tried silently. */
  inertia->common.nmethods = 1;
  inertia->common.method[0].ordering = CHOLMOD_AMD;
  inertia->n = n;
  bool ok = take_pattern (inertia, ap, ai);
  if (ok) {
    memset (inertia->upper->x, 0, inertia->upper->nzmax * sizeof (double));
    inertia->factor = cholmod_analyze (inertia->upper, &inertia->common);
    inertia->right = cholmod_zeros ((size_t) n, 1, CHOLMOD_REAL, &inertia->common);
  }
  if (!ok || inertia->factor == NULL || inertia->right == NULL) {
    qn_inertia_free (inertia);
    return NULL;
  }
  return inertia;
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
  free (inertia->places);
  free (inertia);
}

bool
qn_inertia_count (QnInertia *inertia, const double *ax, int32_t *negative)
{
  cholmod_sparse *upper = inertia->upper;
  const int32_t *up = upper->p;
  double *ux = upper->x;

  for (int32_t k = 0; k < up[inertia->n]; k++)
    ux[k] = ax[inertia->places[k]];
  cholmod_factorize (upper, inertia->factor, &inertia->common);
  if (inertia->common.status < CHOLMOD_OK || inertia->factor->x == NULL)
    return false;

  /* The diagonal of D stands first in every column. */
  const int32_t *lp = inertia->factor->p;
  const double *lx = inertia->factor->x;
  *negative = 0;
  for (int32_t j = 0; j < inertia->n; j++)
    *negative += !(lx[lp[j]] > 0);
  if (inertia->factor->minor < (size_t) inertia->n && *negative == 0)
    *negative = 1;
  return true;
}

QnFactorStatus
qn_inertia_solve (QnInertia *inertia, double *b)
{
  size_t bytes = (size_t) inertia->n * sizeof *b;

  memcpy (inertia->right->x, b, bytes);
  cholmod_dense *solution =
    cholmod_solve (CHOLMOD_A, inertia->factor, inertia->right, &inertia->common);
  if (solution == NULL)
    return QN_FACTOR_NO_MEMORY;
  memcpy (b, solution->x, bytes);
  cholmod_free_dense (&solution, &inertia->common);
  for (int32_t i = 0; i < inertia->n; i++)
    if (!isfinite (b[i]))
      return QN_FACTOR_SINGULAR;
  return QN_FACTOR_OK;
}
