/* What the parts of the interior-point engine share; private to interior-point*.c.
 *
 *   interior-point.c          workspace, starting point, iteration, projection
 *   interior-point-measure.c  residuals of an iterate, certificates, outcome
 *   interior-point-step.c     Newton directions of the homogeneous embedding
 *   interior-point-kkt.c      the linear systems underneath
 *   interior-point-schur.c    the matrix that is factorised
 *   interior-point-apply.c    products with the problem's matrices
 */
#ifndef QN_CORE_INTERIOR_POINT_INTERNAL_H
#define QN_CORE_INTERIOR_POINT_INTERNAL_H

#include "core/limit/interior-point-apply.h"
#include "core/limit/interior-point-kkt.h"

/* A point or a direction of the homogeneous space. */
typedef struct QnIpVector {
  double *y, *v, *s, *z;
  double lambda, tau, kappa;
} QnIpVector;

struct QnInteriorPointWork {
  const QnIpProblem *problem; /* borrowed */
  QnIpSettings settings;
  QnIpKkt kkt;
  double *w;                /* z / s */
  double *ry, *rv, *rz;     /* residuals of the iterate, minus the left-hand sides */
  double r_lambda, r_tau;   /* the two scalar ones */
  double *gy;               /* gradient of the objective in y, cell_count x 2 */
  double curvature;         /* y'Qy */
  QnIpKktVector tau_column; /* solution for the border column of tau */
  QnIpKktRight right;       /* right-hand side being built */
  double *products;         /* right-hand side of s dz + z ds */
  double product_tau;       /* … and of tau dkappa + kappa dtau */
  QnIpVector step, trial, best;
  double best_merit;
  int32_t since_best;
};

/* Residuals of the iterate. */
void qn_ip_residuals (QnInteriorPoint *ip);

/* ip->measures from the residuals. */
void qn_ip_measure (QnInteriorPoint *ip);

/* Whether v and z prove that no forces keep equilibrium under any multiplier. */
bool qn_ip_proves_infeasible (const QnInteriorPoint *ip);

/* Whether y and lambda prove that the multiplier has no bound. */
bool qn_ip_proves_unbounded (const QnInteriorPoint *ip);

/* Predictor, corrector and centrality correctors from the present iterate: the direction is
 * left in work->step, the step length in *length. *ok is false where the linear system could
 * not be factorised. */
QnStatus qn_ip_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag);

#endif
