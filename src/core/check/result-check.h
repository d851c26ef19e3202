/* Is what a result says true?
 *
 * A result says more than its multiplier: displacements, forces and states of joints at every step,
 * reactions, an outcome, a mechanism, bounds. Each is recomputed from the model and from the
 * displacements, by the laws alone, and compared. Nothing is solved, and events, which tell of the way
 * between steps, are not compared but for the first snap:
 *
 *   numbers        all are finite
 *   steps          the first is the dead load; stages and times come in order
 *   displacements  supports stay, or settle as they are told to; nodes on blocks ride with them
 *   forces         of every pair, tie and beam, as the laws answer the displacements. What a law remembers
 *                  is replayed from step to step. Once a structure has jumped, joints have slid on a
 *                  way that no result tells: from there on the slip that explains the shear forces is
 *                  taken, and the normal forces, the strengths and the balance remain to be met
 *   strength       no joint carries more than its law allows, and its state is that of its forces
 *   balance        of every free body, summed from the model without the solver, with the loads at the
 *                  step's multipliers; not in time, where
 *                  inertia and damping belong to it and equilibrium is that of a whole step, most of
 *                  which are not kept; there the energies are recomputed (history)
 *   reactions      as forces and loads leave them
 *   outcome        what the steps say, and the multipliers of collapse and first limit point
 *   mechanism      joints do not overlap; they slide and open where their strength is reached, in the
 *                  sense of their forces and with their dilatancy; the live load does work on it
 *   modes          of vibration are those of the stiffness at the state, and the inertia of the
 *                  stiffness tells that none below is missing; where stability is sought, every step is
 *                  stable, and next to none is left against the buckling mode where it is lost
 *   bounds         of limit analysis: forces in the result prove the lower one, the mechanism the
 *                  upper one; all are in order
 *   interval       no solution is below the collapse multiplier or above the associative bound; each
 *                  of a path is that of a step
 *   linearity      where blocks leave the displacements that linear geometry holds for
 *   history        energies add up to within the error that is told; at every step that is kept the
 *                  kinetic one is that of the velocities, the elastic one that of the forces; peaks
 *                  and tracks are those of the steps; what is at rest is slow
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
  double yield_violation; /* most that one has above its strength, over `contact_scale` */
  QnId pair;              /* where, or QN_NONE */
} QnLastForces;

typedef struct QnResultFaults {
  QnFault items[QN_CLAIM_COUNT]; /* at most one of every claim */
  int count;
  bool forces_unknown; /* of the steps before the last: not kept, not compared */
  bool in_time;        /* the balance is that of a motion and was not checked */
  QnLastForces last;
} QnResultFaults;

/* How far a check goes. */
typedef enum {
  QN_CHECK_STATED,    /* what follows from the result and the model */
  QN_CHECK_RECOMPUTED /* also the bounds that a linear program gives, by solving it again */
} QnCheckDepth;

/* Compares everything that a result of `model` says. The model is prepared, its contacts are those
 * of the analysis. Fails when memory runs out alone. */
QnStatus qn_result_find_faults (const QnModel *model, const QnContacts *contacts,
                                const QnResult *result, QnCheckDepth depth,
                                QnResultFaults *faults, QnDiag *diag);
