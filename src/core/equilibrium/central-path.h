/* Equilibrium of a whole increment by a primal–dual interior-point iteration.
 *
 * One increment of Coulomb joints is the problem of interior-point.h, with Q = 1/k and the elongations of pairs
 * less plastic ones, q - q_p, in place of B'v. Newton's method on s z = mu, mu -> 0, approaches the solution along
 * the central path without choosing an active set. It converges for any number of pairs that change state and for
 * large increments, where Newton's method on the law may diverge; it cannot start from the last solution. The flow
 * need not be associative: the flexibility H of a pair
 * is unsymmetric then and so is the tangent stiffness, whose pattern is the usual one. Without
 * associativity there may be several solutions or none, and no guarantee.
 *
 * Without associativity, in linear geometry and with a prescribed measure of motion, all residuals are
 * reduced at the rate of mu. Otherwise an infeasible start reaches the boundary of some pairs early, steps
 * become very short, and the path seems to turn back.
 *
 * The step is that of limit analysis. For interior points on friction without
 * associativity: Kleinert, Simeon & Obermayr 2014, on rigid bodies in time.
 */
#pragma once

#include "core/equilibrium/equilibrium.h"

/* A workspace for `eq`, which must outlive it; *path = NULL without Coulomb joints. Pairs of other laws enter
 * by their tangent. `together`: residuals are reduced at the rate of mu in nonlinear geometry, too: more and
 * longer steps converge on walls of hundreds of blocks, but more steps end beyond a jump
 * (docs/experiments/path-control.md). False when memory runs out. */
bool qn_central_path_new (QnEquilibrium *eq, bool together, QnCentralPath **path);

void qn_central_path_free (QnCentralPath *path);

/* Solves R(u, lambda) - viscosity C (u - anchor.u) = 0 and the target by at most QN_TRIED factorisations,
 * then qn_equilibrium_newton() to the residual tolerance. viscosity = 0: equilibrium, from the committed
 * state; else a viscous step from the current state (the anchor) with the velocity eq->motion. The current
 * state is the outcome: CONVERGED, FAILED, CANCELLED or NO_MEMORY. */
QnSolveStatus qn_central_path_solve (QnCentralPath *path, const QnTarget *target,
                                     double viscosity);
