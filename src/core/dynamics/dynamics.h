/* An analysis in time: what a structure does under ground motion, or after it has been let go.
 *
 * Steps are those of time-step.h, as long as `time_step` where that is accurate enough, halved
 * where it is not, and doubled again where they may. A step is accepted when Newton's iteration
 * converged and its local error (qn_time_step_error()) is within the tolerance; one that is
 * not leaves no trace.
 *
 * The analysis ends at `duration` (TARGET_REACHED); at REST, when the ground has stopped and for
 * the time sqrt(height / g) nothing has moved faster than a hundred-thousandth of
 * sqrt(g x characteristic length); or with COLLAPSE, when a block has turned by a right angle
 * since the dead load, or is farther from all blocks that it touched than its own size:
 * contacts stay where they were on their blocks, and cannot say what it falls on.
 */
#pragma once

#include "core/dynamics/moving-contacts.h"

/* Speed below which a structure is at rest, in sqrt(g x characteristic length); rotations times the
 * length that they are scaled with. */
#define QN_REST_SPEED 1e-5

/* From the equilibrium under dead load that eq was last evaluated and committed at, and that is the only step
 * of *result. Adds steps and history to the result, and sets its outcome. eq is left at the last accepted
 * state. Where contacts follow the blocks `moving` is theirs, else NULL. */
QnStatus qn_dynamics_run (QnEquilibrium *eq, QnMovingContacts *moving, QnResult *result,
                          QnDiag *diag);
