/* First loss of stability on the path of equilibria.
 *
 * A computed path continues beyond a bifurcation: a straight column stays straight above its Euler load. An
 * equilibrium is stable if all eigenvalues of the tangent stiffness are positive. At the critical
 * multiplier, a bifurcation or limit point, the lowest is zero, and its eigenvector is the buckling mode.
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
 * The result has passed qn_result_prove(): every step is stable by the inertia of its stiffness. The mode is
 * proved if the stiffness against it nearly vanishes, else the mechanism is marked as uncertain.
 *
 * Refuses limit analysis, stages, and states whose stiffness is not symmetric (slip without
 * dilatancy). *result is overwritten without being cleared, and empty on failure. */
QnStatus qn_stability_run (const QnModel *model, const QnContacts *contacts,
                           QnProgressFunc progress, void *user_data, QnResult *result,
                           QnDiag *diag);
