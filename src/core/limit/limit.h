/* Limit analysis of rigid blocks: the multiplier at which a structure collapses, directly.
 *
 * Associative flow (dilatancy = friction). The static theorem makes the multiplier the optimum
 * of a linear program,
 *
 *     maximise lambda  such that  the pair forces balance dead + lambda x live load
 *                                 on every free block and respect every pair's strength,
 *
 * whose dual is the kinematic theorem: among the mechanisms on which the live load does unit
 * power, the one with the least (dissipation - power of the dead load). Any admissible
 * forces give a lower bound, any admissible mechanism an upper bound, and at the optimum they
 * meet. Elastic stiffness plays no part and geometry is that of the undeformed structure.
 *
 * What the numbers guarantee, for rigid blocks, the model's joints and small displacements:
 *
 *   associative lower bound       equilibrium exists up to it. With true (dilatancy < friction)
 *                                 Coulomb friction it is still necessary for equilibrium to
 *                                 exist, but no longer sufficient for the structure to stand.
 *   associative upper bound       no equilibrium exists above it, whatever the dilatancy: the
 *                                 associative value bounds every other one from above.
 *   non-associative collapses     at each one, equilibrium forces and a mechanism that obeys the
 *                                 flow rule exist together. There may be many; neither the least
 *                                 nor the greatest found is a bound on the multipliers at which a
 *                                 real path may collapse.
 *
 * Source: Livesley 1978 (the static program).
 */
#pragma once

#include "core/limit/limit-problem.h"
#include "core/result/result.h"

/* Errors of the solution, dimensionless. */
typedef struct QnLimitCheck {
  double static_residual;  /* out-of-balance of the forces, relative to the loads */
  double static_violation; /* largest excess over the strength, relative to the loads */
  double kinematic_violation; /* largest inadmissible rate, relative to the velocities */
  double gap;                 /* (upper - lower) / (1 + |upper|) in scaled multipliers */
} QnLimitCheck;

/* Most collapses that one analysis tells. */
#define QN_LIMIT_STARTS 4

typedef struct QnLimitSolution {
  QnOutcome outcome;  /* COLLAPSE, ~_UNSTABLE, UNBOUNDED, CANCELLED, NOT_CONVERGED */
  double lower_bound; /* COLLAPSE: carried by `forces`; UNBOUNDED: INFINITY */
  double upper_bound; /* COLLAPSE: proved by `velocities`, or the largest collapse */
  double associative; /* upper bound of the associative program; 0: none */
  double multipliers[QN_LIMIT_STARTS]; /* of collapses, as they were found */
  int32_t count;
  /* By so much stiffer joints, and forces and motion that agree better, may change the lower bound. */
  double uncertainty;
  /* A row for every pair and then tie: normal and shear force, N, as in QnPairResult; UNBOUNDED: the growth
   * of the forces per unit of the multiplier. */
  double *forces;
  /* block_count x 3; COLLAPSE: the mechanism, live load at unit power in scaled terms; DEAD_LOAD_UNSTABLE:
   * how the blocks give way. */
  double *velocities;
  QnLimitCheck check;
  QnStatistics effort; /* iterations, factorisations and factor_seconds alone */
} QnLimitSolution;

void qn_limit_solution_clear (QnLimitSolution *solution);

/* Accuracy of the program. The bounds that are reported are proved afterwards, from forces put
 * into equilibrium and velocities summed up; they come out within 1e-6 of each other, most of them
 * within 1e-7. */
#define QN_LIMIT_TOLERANCE 1e-8

/* Solves the program as it stands, with certificates for every outcome. With `from_dead_load`,
 * DEAD_LOAD_UNSTABLE is also the outcome where equilibrium exists under some live load but not
 * without. `solution` is overwritten without being cleared. */
QnStatus qn_limit_solve (QnLimitProblem *limit, bool from_dead_load,
                         QnLimitSolution *solution, QnDiag *diag);

/* The associative limit analysis of a model from beginning to end. */
QnStatus qn_limit_associative (const QnModel *model, const QnContacts *contacts,
                               QnProgressFunc progress, void *user_data,
                               QnLimitSolution *solution, QnDiag *diag);

/* The collapses without associativity that are found directly (collapse.h), from rest, with joints so stiff
 * that the multiplier does not depend on them any more, by the model's multiplier tolerance. The solution is the
 * lowest, its upper bound the highest collapse; the outcome that of the associative program where this has no
 * optimum, DEAD_LOAD_UNSTABLE where a mechanism goes on without live load. Where `known` is finite (another
 * collapse), only one that lies below it for certain is sought, by one start. */
QnStatus qn_limit_non_associative (const QnModel *model, const QnContacts *contacts,
                                   double known, QnProgressFunc progress, void *user_data,
                                   QnLimitSolution *solution, QnDiag *diag);

/* The collapse to which elastic joints come that have these forces (pair_count x 2, N) at a multiplier now,
 * sought likewise. solution->velocities are displacements, m and rad, so large that the multiplier
 * depends on the stiffness of joints no more; together with the forces they are an equilibrium. The effort
 * of `solution` on entry is added to. COLLAPSE, DEAD_LOAD_UNSTABLE, CANCELLED or NOT_CONVERGED. */
QnStatus qn_limit_go_on (const QnModel *model, const QnContacts *contacts,
                         const double *forces, double multiplier, QnProgressFunc progress,
                         void *user_data, QnLimitSolution *solution);

/* The mechanism that goes with forces at collapse (`pairs`) without dilatancy, by one program whose
 * shear lines pass through them: where it carries no more than `multiplier`, the forces are among its
 * optimal ones, and its velocities move joints where these reach their strength alone. *velocities:
 * block_count x 3, of the caller; NULL where there is none. */
QnStatus qn_limit_find_mechanism (const QnModel *model, const QnContacts *contacts,
                                  const QnPairResult *pairs, double multiplier,
                                  QnProgressFunc progress, void *user_data,
                                  double **velocities);

/* The limit analysis of the model's settings, as a result: steps at the dead load and at collapse
 * (rigid blocks have not moved yet), pair forces, mechanism, bounds. `known`: as above. */
QnStatus qn_limit_run (const QnModel *model, const QnContacts *contacts, double known,
                       QnProgressFunc progress, void *user_data, QnResult *result,
                       QnDiag *diag);
