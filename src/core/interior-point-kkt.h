/* The linear algebra of the interior-point engine; private to interior-point*.c.
 *
 * Solves   [ H  B' 0 ] [ dy ]   [ ry ]
 *          [ B  0  f ] [ dv ] = [ rv ]      H = Q + G' diag (w) G
 *          [ 0  f' 0 ] [ dl ]   [ rl ]
 *
 * (without the last row and column where there is no load f) by one Cholesky factorisation of
 * M = B H^-1 B' (CHOLMOD), f bordered, and iterative refinement on the whole system. Near the
 * optimum M loses its stiffness along the mechanism, and with it all its digits there; the
 * bordered system does not, which is why refinement must see it whole. Three kinds of singularity are regularised in the factorisation only, so that
 * refinement removes their effect: cells with a free direction (H singular), redundant rows
 * and empty rows (M singular).
 */
#ifndef QN_CORE_INTERIOR_POINT_KKT_H
#define QN_CORE_INTERIOR_POINT_KKT_H

#include "core/interior-point.h"

#include <cholmod.h>

typedef struct QnIpKkt {
  const QnIpProblem *problem; /* borrowed */
  cholmod_common common;
  bool started;
  cholmod_sparse *matrix; /* M, lower half, columns sorted */
  cholmod_factor *factor;
  cholmod_dense *right;                      /* right-hand side of M */
  cholmod_dense *solution, *work_y, *work_e; /* kept by cholmod_solve2 between calls */
  int32_t *slots;    /* group_count x 21: place of each lower entry in matrix->x, or -1 */
  int32_t *diagonal; /* row_count: place of the diagonal entry */
  double *stiffness; /* cell_count x 3: nn, nt, tt of H */
  double *compliance; /* cell_count x 3: nn, nt, tt of the (regularised) inverse */
  double *residual_y, *residual_v, *step_y, *rates, *local;
  bool bordered;       /* the multiplier is an unknown; set by _factorize() */
  double *border;      /* M^-1 f, row_count */
  double border_power; /* f'M^-1 f */
  double residual_lambda, step_lambda;
  double *step_v;
  double
    regularization; /* added to the diagonal of H, subtracted as that of the v block */
  double error;     /* largest relative residual left since the last _factorize() */
  int32_t factorizations;
} QnIpKkt;

QnStatus qn_ip_kkt_init (QnIpKkt *kkt, const QnIpProblem *problem, QnDiag *diag);

/* Factorises for the weights w (bound_count). *ok is false where the matrix could not be
 * made positive definite. */
QnStatus qn_ip_kkt_factorize (QnIpKkt *kkt, const double *w, bool *ok, QnDiag *diag);

/* Unknowns or right-hand side of the system. */
typedef struct QnIpKktVector {
  double *y;     /* cell_count x 2 */
  double *v;     /* row_count */
  double lambda; /* 0 without a load */
} QnIpKktVector;

/* Solves for one right-hand side; `out` must not overlap it. */
QnStatus qn_ip_kkt_solve (QnIpKkt *kkt, const QnIpKktVector *right, QnIpKktVector *out,
                          QnDiag *diag);

void qn_ip_kkt_clear (QnIpKkt *kkt);

/* out (row_count) += scale * B y */
void qn_ip_add_forces (const QnIpProblem *problem, const double *y, double scale,
                       double *out);

/* out (cell_count x 2) += scale * B'v */
void qn_ip_add_rates (const QnIpProblem *problem, const double *v, double scale,
                      double *out);

#endif
