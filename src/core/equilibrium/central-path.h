/* Equilibrium of a whole increment by a primal–dual interior-point iteration.
 *
 * One increment of Coulomb joints is a complementarity problem: every pair has strengths s and
 * plastic flows z of which one vanishes,
 *
 *   y = k (q - q_p - flow z)      forces from the elongations q of the pair
 *   G y + s = h,  s >= 0          strength: cap of the normal force, friction both ways
 *   z >= 0,  s z = 0              flow only at the strength
 *
 * together with equilibrium. Newton's method on s z = mu instead, with mu taken to zero,
 * approaches the solution along the central path, on which the active set is still undecided.
 * It is indifferent to how many pairs change state, where Newton's method on the law itself
 * may diverge, and takes increments of any size; the price is that it starts anew each time.
 * The flow need not be associative: the flexibility of a pair,
 *
 *   H = 1/k + flow diag (z/s) G   (2 x 2, inverted in closed form)
 *
 * is unsymmetric then and so is the tangent stiffness, whose pattern is the usual one. Without
 * associativity there may be several solutions or none, and no guarantee.
 *
 * Without associativity, in linear geometry and towards a measure that advances, the residuals of
 * all equations go down at the rate of mu, so that iterates stay close to the one curve along
 * which both vanish (an infeasible start otherwise runs into the corners that some pairs leave to
 * the others, steps become nothing, and a path that goes on looks as if it turned back).
 *
 * Mehrotra's predictor and corrector (Mehrotra 1992), Gondzio's centrality correctors (Gondzio
 * 1996). For interior points on friction without associativity: Kleinert, Simeon & Obermayr
 * 2014, on rigid bodies in time.
 */
#pragma once

#include "core/equilibrium/equilibrium.h"

/* A workspace for `eq`, which must outlive it; NULL without Coulomb joints. Pairs of other laws take part as
 * Newton's method would have it. In nonlinear geometry the iteration takes up the deformed configuration as that
 * does; it pays in steps that are not too long. `together`: there, too, residuals go down at the rate of
 * complementarity where a measure advances. On walls of hundreds of blocks more steps get through, and longer ones;
 * a branch that is followed step by step comes to rest beyond a jump more often
 * (docs/experiments/path-control.md). False when memory runs out. */
bool qn_central_path_new (QnEquilibrium *eq, bool together, QnCentralPath **path);

void qn_central_path_free (QnCentralPath *path);

/* With viscosity 0 equilibrium at the target, from the committed state; else one viscous step of
 * qn_equilibrium_relax(), from the current state, which is the anchor, eq->motion the velocity so far: to
 *
 *   R(u, lambda) - viscosity C (u - anchor.u) = 0
 *
 * and the target. With at most `budget` factorisations, and then to the residual tolerance by
 * qn_equilibrium_newton(). Leaves the outcome as the current state: CONVERGED, FAILED, CANCELLED or NO_MEMORY. */
QnSolveStatus qn_central_path_solve (QnCentralPath *path, const QnTarget *target,
                                     double viscosity, int budget);
