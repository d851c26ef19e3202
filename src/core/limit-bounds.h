/* From an interior-point iterate to two numbers that are bounds; private to limit*.c. */
#ifndef QN_CORE_LIMIT_BOUNDS_H
#define QN_CORE_LIMIT_BOUNDS_H

#include "core/limit.h"

/* Forces in equilibrium and within the strength, and the scaled multiplier they carry.
 *
 * y: cell_count x 2 out. `anchor` (nullable) is a state known to lie within the strength at
 * multiplier 0: forces that leave the strength by rounding are drawn back towards it. What
 * excess remains is in check->static_violation. */
QnStatus qn_limit_lower_bound (QnInteriorPoint *ip, const QnLimitProblem *limit,
                               const double *anchor, double *y, double *lambda,
                               QnLimitCheck *check, QnDiag *diag);

/* The scaled multiplier at which the mechanism v (row_count; rescaled in place to unit power
 * of the live load) balances its power: the dissipation belongs to v, not to the iterate. */
double qn_limit_upper_bound (const QnLimitProblem *limit, double *v, double *rates,
                             QnLimitCheck *check);

#endif
