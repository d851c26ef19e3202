/* KLU back end: left-looking sparse LU without supernodes. Block masonry gives very sparse
 * matrices (four to six neighbours a block), for which it is the fastest of SuiteSparse's
 * unsymmetric solvers up to some ten thousand unknowns, and its refactorisation reuses the
 * pivot order while it stays accurate. */
#include "core/linsys.h"

#include "core/memory.h"
#include "core/tolerance.h"

#include <klu.h>
#include <stdlib.h>

struct QnLinsys {
  int32_t n;
  /* KLU takes its read-only arguments without const. */
  int32_t *ap, *ai;
  klu_common common;
  klu_symbolic *symbolic;
  klu_numeric *numeric;
};

QnLinsys *
qn_linsys_new (int32_t n, const int32_t *ap, const int32_t *ai)
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
  system->symbolic = klu_analyze (n, system->ap, system->ai, &system->common);
  if (system->symbolic == NULL) {
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
  klu_free_numeric (&system->numeric, &system->common);
  klu_free_symbolic (&system->symbolic, &system->common);
  free (system);
}

static QnFactorStatus
factor_anew (QnLinsys *system, double *ax)
{
  klu_free_numeric (&system->numeric, &system->common);
  system->numeric =
    klu_factor (system->ap, system->ai, ax, system->symbolic, &system->common);
  if (system->common.status == KLU_SINGULAR)
    return QN_FACTOR_SINGULAR;
  if (system->numeric == NULL)
    return QN_FACTOR_NO_MEMORY;
  klu_rcond (system->symbolic, system->numeric, &system->common);
  return system->common.rcond > QN_TOLERANCE_SINGULAR ? QN_FACTOR_OK : QN_FACTOR_SINGULAR;
}

QnFactorStatus
qn_linsys_factor (QnLinsys *system, const double *values)
{
  double *ax = (double *) values;

  if (system->numeric == NULL)
    return factor_anew (system, ax);

  /* Same pivots as last time, as long as that does not amplify rounding. */
  if (klu_refactor (system->ap, system->ai, ax, system->symbolic, system->numeric,
                    &system->common)
      && system->common.status == KLU_OK
      && klu_rgrowth (system->ap, system->ai, ax, system->symbolic, system->numeric,
                      &system->common)
      && system->common.rgrowth > QN_TOLERANCE_PIVOT_GROWTH
      && klu_rcond (system->symbolic, system->numeric, &system->common)
      && system->common.rcond > QN_TOLERANCE_SINGULAR)
    return QN_FACTOR_OK;
  return factor_anew (system, ax);
}

void
qn_linsys_solve (QnLinsys *system, double *b)
{
  QN_ASSERT (system->numeric != NULL);
  klu_solve (system->symbolic, system->numeric, system->n, 1, b, &system->common);
}
