/* Products with the matrices of an interior-point problem; private to interior-point*.c. */
#ifndef QN_CORE_INTERIOR_POINT_APPLY_H
#define QN_CORE_INTERIOR_POINT_APPLY_H

#include "core/limit/interior-point.h"

/* out (cell_count x 2) += scale * B'v */
void qn_ip_add_rates (const QnIpProblem *problem, const double *v, double scale,
                      double *out);

/* out (bound_count) = G y */
void qn_ip_apply_bounds (const QnIpProblem *problem, const double *y, double *out);

/* out (cell_count x 2) += scale G'x */
void qn_ip_add_bounds_transposed (const QnIpProblem *problem, const double *x,
                                  double scale, double *out);

/* out (cell_count x 2) += scale F z, the flows of the bounds */
void qn_ip_add_flows (const QnIpProblem *problem, const double *z, double scale,
                      double *out);

/* values += factor * step */
void qn_ip_add_multiple (double *values, double factor, const double *step,
                         int32_t count);

double qn_ip_quadratic_term (const QnIpProblem *problem, const double *y); /* y'Qy */
double qn_ip_limit_term (const QnIpProblem *problem, const double *z);     /* h'z */
double qn_ip_dot (const double *a, const double *b, int32_t count);
double qn_ip_largest (const double *values, int32_t count); /* largest |value|, or NaN */

#endif
