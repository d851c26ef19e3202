/* Analysis in time: response to ground motion or to an initial motion.
 *
 * Steps (time-step.h) have the length `time_step`, are halved for accuracy and doubled again. A step is
 * accepted if Newton's iteration converged and the local error (qn_time_step_error()) is within the
 * tolerance; rejected steps change nothing.
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

/* Starts from the equilibrium under dead load, the committed state of eq and only step of *result. Adds steps
 * and history, sets the outcome; leaves eq at the last accepted state. `moving`: NULL unless contacts follow
 * the blocks. */
QnStatus qn_dynamics_run (QnEquilibrium *eq, QnMovingContacts *moving, QnResult *result,
                          QnDiag *diag);
