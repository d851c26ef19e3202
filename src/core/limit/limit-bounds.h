/* The upper bound that velocities prove; private to limit.c. */
#ifndef QN_CORE_LIMIT_BOUNDS_H
#define QN_CORE_LIMIT_BOUNDS_H

#include "core/limit/limit.h"

/* The scaled multiplier at which the mechanism v (row_count; rescaled in place to unit power of the
 * live load) balances its power. The dissipation is that of v. The power of the iterate's forces y
 * on rates that no flow rule allows is added, so that rounding of v does not bring the bound
 * below the multiplier of these forces.
 *
 * rates: cell_count x 2 out */
double qn_limit_upper_bound (const QnLimitProblem *limit, double *v, const double *y,
                             double *rates, QnLimitCheck *check);

#endif
