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
#ifndef QN_CORE_DYNAMICS_H
#define QN_CORE_DYNAMICS_H

#include "core/assembly/assembly.h"
#include "core/base/progress.h"
#include "core/linalg/linsys.h"

/* Speed below which a structure is at rest, in sqrt(g x characteristic length); rotations times the
 * length that they are scaled with. */
#define QN_REST_SPEED 1e-5

/* From the equilibrium under dead load, at displacements u0, that the assembly was last evaluated
 * and committed at, and that is the only step of *result. `linsys` has the assembly's pattern.
 * Adds steps and history to the result; sets its outcome, and its statistics but for the time.
 * The assembly is left at the last accepted state, u0 overwritten with its displacements. */
QnStatus qn_dynamics_run (QnAssembly *assembly, QnLinsys *linsys, double *u0,
                          QnProgressFunc report, void *report_data, QnResult *result,
                          QnDiag *diag);

#endif
