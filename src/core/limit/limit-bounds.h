/* From an interior-point iterate to two numbers that are bounds; private to limit*.c. */
#ifndef QN_CORE_LIMIT_BOUNDS_H
#define QN_CORE_LIMIT_BOUNDS_H

#include "core/limit/limit.h"

/* Draws forces y (cell_count x 2) that leave the strength by rounding, or by the tolerance of the
 * program, back towards `anchor` (nullable), which lies within the strength and carries
 * anchor_lambda as y carries lambda. Returns the scaled multiplier that the drawn forces carry;
 * what excess remains is in check->static_violation. */
double qn_limit_draw_inside (const QnLimitProblem *limit, const double *anchor,
                             double anchor_lambda, double lambda, double *y,
                             QnLimitCheck *check);

/* Mirrors forces that exceed a strength at its bound; equilibrium is lost. */
void qn_limit_move_inside (const QnLimitProblem *limit, double *y);

/* The scaled multiplier at which the mechanism v (row_count; rescaled in place to unit power
 * of the live load) balances its power: the dissipation belongs to v, not to the iterate. Of the
 * iterate's forces y / tau there is only what they do on rates that no flow rule knows, so that
 * no rounding of v brings the bound below what these forces carry.
 *
 * rates: cell_count x 2 out */
double qn_limit_upper_bound (const QnLimitProblem *limit, double *v, const double *y,
                             double tau, double *rates, QnLimitCheck *check);

#endif
