/* What the parts of the interior-point engine share; private to interior-point*.c.
 *
 *   interior-point.c       workspace, starting point, outcome of an iteration, projection
 *   interior-point-step.c  Newton directions of the homogeneous embedding
 *   interior-point-kkt.c   the linear systems underneath
 */
#ifndef QN_CORE_INTERIOR_POINT_INTERNAL_H
#define QN_CORE_INTERIOR_POINT_INTERNAL_H

#include "core/interior-point-kkt.h"

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
  double *hy;               /* G' (w h), cell_count x 2 */
  double *gy;               /* gradient of the gap row in y, cell_count x 2 */
  double whh;               /* sum of w h^2 */
  double curvature;         /* y'Qy */
  QnIpKktVector tau_column; /* solution for the border column of tau */
  QnIpKktVector right;      /* right-hand side being built */
  double *products;         /* right-hand side of s dz + z ds */
  double product_tau;       /* … and of tau dkappa + kappa dtau */
  QnIpVector step, trial, best;
  double best_merit;
  int32_t since_best;
};

/* Residuals of the iterate. */
void qn_ip_residuals (QnInteriorPoint *ip);

/* Predictor, corrector and centrality correctors from the present iterate: the direction is
 * left in work->step, the step length in *length. *ok is false where the linear system could
 * not be factorised. */
QnStatus qn_ip_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag);

/* out (bound_count) = G y */
void qn_ip_apply_bounds (const QnIpProblem *problem, const double *y, double *out);

/* out (cell_count x 2) += scale G'x */
void qn_ip_add_bounds_transposed (const QnIpProblem *problem, const double *x,
                                  double scale, double *out);

double qn_ip_linear_term (const QnIpProblem *problem, const double *y);    /* q'y */
double qn_ip_quadratic_term (const QnIpProblem *problem, const double *y); /* y'Qy */
double qn_ip_limit_term (const QnIpProblem *problem, const double *z);     /* h'z */
double qn_ip_dot (const double *a, const double *b, int32_t count);
double qn_ip_largest (const double *values, int32_t count); /* largest |value| */

#endif
