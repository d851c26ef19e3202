/* From an interior-point iterate to two numbers that are bounds; private to limit*.c. */
#ifndef QN_CORE_LIMIT_BOUNDS_H
#define QN_CORE_LIMIT_BOUNDS_H

#include "core/limit/limit.h"

/* Moves forces y (cell_count x 2) that exceed the strength by rounding, or by the tolerance of the
 * program, towards `anchor` (nullable), which is within the strength. y is in equilibrium with
 * lambda, the anchor with anchor_lambda. Returns the scaled multiplier of the moved forces; the
 * excess that remains is in check->static_violation. */
double qn_limit_draw_inside (const QnLimitProblem *limit, const double *anchor,
                             double anchor_lambda, double lambda, double *y,
                             QnLimitCheck *check);

/* Mirrors forces that exceed a strength at its bound; equilibrium is lost. */
void qn_limit_move_inside (const QnLimitProblem *limit, double *y);

/* The scaled multiplier at which the mechanism v (row_count; rescaled in place to unit power of the
 * live load) balances its power. The dissipation is that of v. The power of the iterate's forces y
 * / tau on rates that no flow rule allows is added, so that rounding of v does not bring the bound
 * below the multiplier of these forces.
 *
 * rates: cell_count x 2 out */
double qn_limit_upper_bound (const QnLimitProblem *limit, double *v, const double *y,
                             double tau, double *rates, QnLimitCheck *check);

#endif
