/* Where the path of equilibria first loses its stability.
 *
 * A load path may go on where the structure would not: a straight column stays straight beyond
 * its Euler load, in an equilibrium that nothing disturbs in a computation. The tangent
 * stiffness tells. As long as all its eigenvalues are positive the equilibrium is stable; at
 * the critical multiplier the lowest one becomes zero, at a bifurcation as well as at a limit
 * point, and its eigenvector is the way in which the structure gives way.
 */
#pragma once

#include "core/base/progress.h"
#include "core/result/result.h"

/* Follows the live load in increments, as load control does, to the critical multiplier, to the
 * largest multiplier of the settings, or to collapse. In *result:
 *
 *   outcome  SNAP: stability is lost at first_limit_multiplier (resolved to a thousandth of the
 *            multiplier tolerance), the last step is the stable equilibrium just below, and
 *            `mechanism` the buckling mode;
 *            TARGET_REACHED: the path is stable all along; others as of any path.
 *
 * Everything is proved as qn_result_prove() does: every step is stable by the inertia of its stiffness.
 * Where next to no stiffness is left against the mode, it is proved too; else (no equilibrium was found
 * beyond the last step) the mechanism is marked as uncertain.
 *
 * Refuses limit analysis, stages, and states whose stiffness is not symmetric (slip without
 * dilatancy). *result is overwritten without being cleared, and empty on failure. */
QnStatus qn_stability_run (const QnModel *model, const QnContacts *contacts,
                           QnProgressFunc progress, void *user_data, QnResult *result,
                           QnDiag *diag);
