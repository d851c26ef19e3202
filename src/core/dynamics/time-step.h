/* One step in time: the generalised-alpha method with Newton's iteration.
 *
 *   M a_(1-am) + C v_(1-af) + P_(1-af) = F_(1-af) - M i g
 *
 * x_(1-s) = (1 - s) x1 + s x0, P the forces of joints and beams, F the dead loads, i g the
 * acceleration of the ground, u, v, a relative to the ground, with Newmark's
 *
 *   u1 = u0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),   v1 = v0 + h ((1 - gamma) a0 + gamma a1)
 *
 * and, of the spectral radius rho at infinite frequency (Chung & Hulbert 1993, Journal of Applied
 * Mechanics 60, 371-375), second order for any rho:
 *
 *   am = (2 rho - 1)/(rho + 1)       af = rho/(rho + 1)
 *   gamma = 1/2 - am + af            beta = (1 - am + af)^2 / 4
 *
 * Internal forces are taken at the two ends of the step, not at a state between them: the memory of joints is
 * that of the end, committed once per accepted step. Forces added by pairs: pair-motion.h. Contact pairs
 * stay fixed to their blocks unless moving-contacts.h changes them between two steps.
 *
 * A factorisation is reused while all pairs keep their branches, the step its length, and each iteration
 * reduces the residual to a tenth: tangents of open and sliding pairs, in large displacements of all, change
 * without a change of state.
 *
 * Energy. With [x] = x1 - x0, du = [u], and R = P - F + M i g,
 *
 *   [v' M v]/2 = -du' (R0 + R1)/2 - D,
 *   D = (1/2 - af) du' ([R] + M [a]) + h (beta - gamma/2) [a]' M [v]
 *
 * follows from the equations above; D: energy dissipated by the integration.
 */
#pragma once

#include "core/dynamics/ground.h"
#include "core/dynamics/pair-motion.h"
#include "core/equilibrium/equilibrium.h"

/* Numbers that tell the branch of a pair. */
#define QN_BRANCH 5

typedef struct QnTimeScheme {
  double alpha_m, alpha_f, beta, gamma;
} QnTimeScheme;

/* The structure at one time. */
typedef struct QnInstant {
  QnEquilibriumState at;
  double *v, *a;       /* unknown_count: m/s, m/s2, rotations scaled */
  double *dead;        /* dead loads as they have turned, N */
  double *residual;    /* F - P, N */
  double *elongations; /* pair_count x 2, m */
  double *rates;       /* pair_count x 2, m/s */
  double beam_energy;  /* elastic energy of beams, J */
} QnInstant;

static inline QnPairInstant
qn_instant_pair (const QnInstant *instant, const QnPairResponse *responses, size_t p)
{
  return (
    QnPairInstant){ .q = { instant->elongations[2 * p], instant->elongations[2 * p + 1] },
                    .rate = { instant->rates[2 * p], instant->rates[2 * p + 1] },
                    .response = &responses[p] };
}

typedef struct QnTimeStep {
  QnStepEquation equation; /* with the workspace, borrowed */
  QnPool pool;             /* of all that follows */
  QnTimeScheme scheme;
  const QnDynamicSettings *settings;
  double h;      /* length of the step tried, s */
  QnVec2 ground; /* the ground's acceleration within it, m/s2 */

  double *mass;         /* M, in the pattern of K */
  double *beam_damping; /* of beams, over the damping's factor: K, in the pattern of K */
  double *inertia[2];   /* M i for the ground's acceleration in x, y: unknown_count, kg */
  QnPairElasticity *elasticity;
  double *damping;      /* a of every pair's dashpot, s */
  QnInstant start, end; /* the state that was accepted, and the one tried */

  double *increment;    /* end.u - start.u without cancellation, for accelerations */
  QnPairForces *forces; /* of all pairs */
  double *branches; /* pair_count x QN_BRANCH: tangents of their laws, qn_pair_branch() */
  double *factored; /* `branches` of the last factorisation */
  double factored_length; /* length of its step; 0: no factorisation */
  bool kept;              /* the last iteration reused a factorisation */
  bool stale;             /* such an iteration converged slowly, */
  double before;          /* from this residual */
} QnTimeStep;

/* Prepares a step from the committed state of eq plus the initial motion of the model. Refuses bodies without
 * mass. `step` is overwritten without being cleared. */
QnStatus qn_time_step_setup (QnTimeStep *step, QnEquilibrium *eq, QnDiag *diag);

void qn_time_step_clear (QnTimeStep *step);

/* Evaluates the state at the start again after contacts, or the assembly, have changed. */
QnStatus qn_time_step_renew (QnTimeStep *step, QnDiag *diag);

/* Accelerations at the start, from equilibrium under the ground's acceleration. */
QnSolveStatus qn_time_step_start (QnTimeStep *step, QnVec2 ground);

/* Computes `end`, h seconds after `start`, without committing it. ground: acceleration within the step,
 * mean + (1/2 - af) change, m/s2. */
QnSolveStatus qn_time_step_try (QnTimeStep *step, double h, QnVec2 ground);

/* Error of the step just tried, m: the largest local error of its displacements,
 * |beta - 1/6| h^2 [acceleration], accelerations being those of equilibrium at both ends
 * (Zienkiewicz & Xie 1991, Earthquake Engineering and Structural Dynamics 20, 871-887). */
double qn_time_step_error (const QnTimeStep *step, double h, QnVec2 ground_change);

/* Makes `end` the start of the next step and commits the memory of joints and beams. */
void qn_time_step_accept (QnTimeStep *step);
