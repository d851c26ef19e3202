/* Check of a result: all its claims are recomputed from the model and the displacements, by the laws alone,
 * and compared. No system is solved. Of the events, only the first snap is compared.
 *
 *   numbers        all are finite
 *   steps          the first is the dead load; stages and times come in order
 *   displacements  supports are fixed or have their settlement; nodes on blocks move with them
 *   forces         of every pair, tie and beam, by the laws from the displacements; the memory of laws is
 *                  replayed step by step. After a jump the slip is unknown: it is computed from the
 *                  stated shear forces; normal forces, strengths and balance are still compared
 *   strength       forces of joints are within their law; states agree with the forces
 *   balance        of every free body, summed from the model without the solver, with the loads at the
 *                  step's multipliers; not in time, where most steps are not kept (see history)
 *   reactions      are the sum of forces and loads
 *   outcome        agrees with the steps and the multipliers of collapse and first limit point
 *   mechanism      joints do not overlap; they slide and open where their strength is reached, in the
 *                  sense of their forces and with their dilatancy; the live load does work on it
 *   modes          of vibration belong to the stiffness of the state; its inertia proves that none below is
 *                  missing. Stability analyses: every step is stable, and the stiffness against the
 *                  buckling mode nearly vanishes
 *   bounds         of limit analysis: forces in the result prove the lower one, the mechanism the
 *                  upper one; all are in order
 *   interval       no solution is below the collapse multiplier or above the associative bound; each
 *                  of a path is that of a step
 *   linearity      multiplier at which displacements exceed the validity of linear geometry
 *   history        energies add up within the stated error; at every kept step the kinetic energy agrees with
 *                  the velocities, the elastic energy with the forces; peaks and tracks agree with the
 *                  steps; a structure at rest is slow
 */
#pragma once

#include "core/result/result.h"

/* Balance and strength at the last step. */
typedef struct QnLastForces {
  double multiplier; /* NAN: without any step, or in time, there is no equilibrium */
  double scale;      /* N: largest force, in the loads or in joints, beams and ties */
  /* Largest over the free degrees of freedom, over `scale`; moments count with the arm
   * QnModel.characteristic_length. */
  double out_of_balance;
  QnEntity entity;      /* QN_ENTITY_BLOCK, _NODE or _BEAM: `index` counts the elements */
  QnId index;           /* where, or QN_NONE: nowhere */
  double contact_scale; /* N: largest force of a contact */
  double yield_violation; /* largest excess over a strength, over `contact_scale` */
  QnId pair;              /* where, or QN_NONE */
} QnLastForces;

typedef struct QnResultFaults {
  QnFault items[QN_CLAIM_COUNT]; /* at most one of every claim */
  int count;
  bool forces_unknown; /* of the steps before the last: not kept, not compared */
  bool in_time;        /* the balance is that of a motion and was not checked */
  QnLastForces last;
} QnResultFaults;

/* Depth of a check. */
typedef enum {
  QN_CHECK_STATED,    /* all claims that need no linear program */
  QN_CHECK_RECOMPUTED /* also the bounds, by solving the linear program again */
} QnCheckDepth;

/* Checks a result of a prepared model with the contacts of the analysis. NO_MEMORY is the only error. */
QnStatus qn_result_find_faults (const QnModel *model, const QnContacts *contacts,
                                const QnResult *result, QnCheckDepth depth,
                                QnResultFaults *faults, QnDiag *diag);
