/* The one matrix that the interior-point engine factorises; private to interior-point*.c.
 *
 *     M = B H^-1 B' + r I
 *
 * with H^-1 given cell by cell. Its sparsity is that of the graph of bodies and does not change:
 * the order of elimination is chosen once, every later factorisation (CHOLMOD, Cholesky) is
 * numeric only.
 */
#ifndef QN_CORE_INTERIOR_POINT_SCHUR_H
#define QN_CORE_INTERIOR_POINT_SCHUR_H

#include "core/interior-point.h"

#include <cholmod.h>

typedef struct QnIpSchur {
  const QnIpProblem *problem; /* borrowed */
  cholmod_common common;
  bool started;
  cholmod_sparse *matrix; /* M, lower half, columns sorted */
  cholmod_factor *factor;
  cholmod_dense *right;                      /* right-hand side of M */
  cholmod_dense *solution, *work_y, *work_e; /* kept by cholmod_solve2 between calls */
  int32_t *slots;    /* group_count x 21: place of each lower entry in matrix->x, or -1 */
  int32_t *diagonal; /* row_count: place of the diagonal entry */
  int32_t factorizations;
  double seconds; /* spent in factorising and solving */
} QnIpSchur;

QnStatus qn_ip_schur_init (QnIpSchur *schur, const QnIpProblem *problem, QnDiag *diag);

/* Builds and factorises M for the compliances H^-1 (cell_count x 3: nn, nt, tt) and r. *ok is
 * false where M is not positive definite to working precision. */
QnStatus qn_ip_schur_factorize (QnIpSchur *schur, const double *compliance,
                                double regularization, bool *ok, QnDiag *diag);

/* The vector (row_count) to fill before _solve(). */
double *qn_ip_schur_get_right (QnIpSchur *schur);

/* *solution = M^-1 right, owned by `schur` and valid until the next call. */
QnStatus qn_ip_schur_solve (QnIpSchur *schur, const double **solution, QnDiag *diag);

void qn_ip_schur_clear (QnIpSchur *schur);

#endif
