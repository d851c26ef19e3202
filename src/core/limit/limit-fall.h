/* How a structure begins to move that does not stand under its dead load; private to limit*.c. */
#pragma once

#include "core/limit/limit-problem.h"

/* Accelerations from rest under the dead load: of all forces within the strength, the joints
 * exert those that leave the least imbalance in the metric of the inverse masses (Gauss's
 * principle of least constraint, flow being associative), and what is left accelerates. Blocks
 * that can stand stay at rest exactly, which shows which blocks fall.
 *
 * At the optimum this is a certificate too: the dead load does positive power along it, and
 * no joint resists with more than that.
 *
 * v: row_count, out, unchanged where the program has not come to its end; *proved: whether v is such a
 * certificate. `go_on` is called with `user_data` once an iteration; false ends the search, nothing
 * found. */
QnStatus qn_limit_fall (const QnLimitProblem *limit, bool (*go_on) (void *user_data),
                        void *user_data, double *v, bool *proved, QnDiag *diag);
