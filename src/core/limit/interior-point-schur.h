/* The one matrix that the interior-point engine factorises; private to interior-point*.c.
 *
 *     M = B H^-1 B' + r I
 *
 * with H^-1 given cell by cell. It is symmetric and positive definite, its sparsity is that of the
 * graph of bodies and does not change: the order of elimination is chosen once, every later
 * factorisation is numeric only. It is done in dense fronts (block-lu.h), twice the arithmetic of
 * Cholesky's, of which the processor does far more at a time than of the sparse one's.
 */
#ifndef QN_CORE_INTERIOR_POINT_SCHUR_H
#define QN_CORE_INTERIOR_POINT_SCHUR_H

#include "core/limit/interior-point.h"
#include "core/linalg/block-lu.h"

typedef struct QnIpSchur {
  const QnIpProblem *problem; /* borrowed */
  int32_t *columns, *rows;    /* pattern of M, both halves */
  double *values;
  QnBlockLu *lu;
  double *right, *solution; /* row_count */
  int32_t *slots;           /* group_count x 36: place of each entry in values, or -1 */
  int32_t *diagonal;        /* row_count: place of the diagonal entry */
  int32_t factorizations;
  double seconds; /* spent in factorising and solving */
} QnIpSchur;

QnStatus qn_ip_schur_init (QnIpSchur *schur, const QnIpProblem *problem, QnDiag *diag);

/* Builds and factorises M for the compliances H^-1 (cell_count x 3: nn, nt, tt) and r. *ok is
 * false where M is singular to working precision. */
QnStatus qn_ip_schur_factorize (QnIpSchur *schur, const double *compliance,
                                double regularization, bool *ok, QnDiag *diag);

/* The vector (row_count) to fill before _solve(). */
double *qn_ip_schur_get_right (QnIpSchur *schur);

/* *solution = M^-1 right, owned by `schur` and valid until the next call. */
QnStatus qn_ip_schur_solve (QnIpSchur *schur, const double **solution, QnDiag *diag);

void qn_ip_schur_clear (QnIpSchur *schur);

#endif
