/* Workspace of the equilibrium solver: semismooth Newton with a line search, and relaxation
 * across jumps, towards a multiplier or another target.
 *
 * The workspace always holds one committed equilibrium (displacements, multiplier, memory of
 * pairs and beams). The solving functions try to go on from there and leave their outcome as the
 * current state; qn_equilibrium_commit() accepts it, qn_equilibrium_restore() goes back.
 * Nothing is allocated after qn_equilibrium_setup(), except inside SuiteSparse.
 */
#pragma once

#include "core/assembly/assembly.h"
#include "core/base/progress.h"
#include "core/linalg/linsys.h"

/* All that makes a state: to go on from it, or to come back to it. The responses belong to
 * it because they hold the tangent that led there: pairs that slip right at their strength
 * look stuck when they are evaluated anew, and an iteration that starts from that stiffness
 * diverges. */
typedef struct QnEquilibriumState {
  double *u;
  double multiplier;
  double out_of_balance;
  QnPairMemory *memory;
  QnPairResponse *responses;
  QnBeamState beams;
} QnEquilibriumState;

/* What closes the system of equations besides equilibrium: a prescribed multiplier, or a linear
 * combination of displacements that has advanced by a given amount since the committed state:
 *
 *   direction . (u - committed.u) = advance
 *
 * A unit direction prescribes one displacement, the live load prescribes its work, the tangent
 * of the path a length along it. */
typedef struct QnTarget {
  const double *direction; /* NULL: `multiplier` is prescribed */
  double advance;
  double multiplier;
} QnTarget;

static inline QnTarget
qn_target_multiplier (double multiplier)
{
  return (QnTarget){ .multiplier = multiplier };
}

typedef struct QnCentralPath QnCentralPath;
typedef struct QnStepEquation QnStepEquation;

typedef struct QnEquilibrium {
  QnPool pool;      /* of vectors of unknowns, */
  QnPool pair_pool; /* and of what has the size of the assembly's pairs, as states */
  QnAssembly assembly;
  QnLinsys *linsys;
  double tolerance; /* largest out-of-balance, relative to the loads */

  double *u;         /* current displacements */
  double multiplier; /* current multiplier, lambda */
  double *residual;  /* of the last evaluation, viscous part included */
  double *step;      /* Newton direction */
  double *trial;     /* u + alpha step */
  double *live_step; /* K \\ F_live: displacements per multiplier */
  double *gaps;      /* of pairs, then of ties, before the last step of motion, m */
  double *motion; /* how it moves on, of any length: in the last viscous step, or from an
                     unstable equilibrium */
  double runaway; /* elastic displacements from which on the structure has run away */

  QnEquilibriumState committed; /* last accepted equilibrium */
  QnEquilibriumState recorded;  /* the last one that the result tells */
  QnEquilibriumState anchor;    /* where the viscous step started */

  /* Sign of the determinant of the bordered tangent of the last iteration towards a measure: it keeps as
   * long as a structure would stay there with the measure held, and turns with the path. */
  int orientation;

  double slope; /* of the multiplier over the measure there; 0: not known */

  int16_t *factored_phases; /* phases and viscosity of the last factorised tangent */
  double factored_viscosity;
  bool factored;
  bool keeps_forces; /* some forces the laws do not find again, since last cleared */

  double out_of_balance; /* of the current state, relative */
  QnProgress progress;
  QnProgressFunc report;
  void *report_data;
  bool cancelled;
  QnStatistics statistics;
} QnEquilibrium;

/* Numbers the unknowns, analyses the pattern and allocates everything. The state is the structure
 * at rest, at multiplier 0, not in equilibrium yet. `report` (nullable) is asked whether to go
 * on. Model and contacts must outlive the workspace, which is overwritten without being cleared;
 * on failure it is empty. */
QnStatus qn_equilibrium_setup (QnEquilibrium *eq, const QnModel *model,
                               const QnContacts *contacts, QnProgressFunc report,
                               void *report_data, QnDiag *diag);

void qn_equilibrium_clear (QnEquilibrium *eq);

/* In the committed state: takes another assembly of the same model, with other pairs and their responses,
 * and makes a linear system for it. To be evaluated. Where memory runs out all is as it was; the assembly is
 * taken over or cleared. */
QnStatus qn_equilibrium_exchange (QnEquilibrium *eq, QnAssembly *assembly, QnDiag *diag);

/* Evaluates pairs that have begun to carry in the committed state, which is one to go on from then: in
 * equilibrium once a next one is found. */
void qn_equilibrium_renew (QnEquilibrium *eq);

/* What Newton's method solves: equilibrium, and what motion adds to it. newton.c has the equation of statics
 * and of viscous motion, core/dynamics/time-step.c that of a step in time. */
struct QnStepEquation {
  QnEquilibrium *eq;
  double relative; /* what is out of balance over the forces, and */
  double norm;     /* what says whether it can be had at all (finite) */
  void (*measure) (QnStepEquation *);        /* sets both, with bonds as they are now */
  QnSolveStatus (*solve) (QnStepEquation *); /* finds a direction, */
  bool (*advance) (QnStepEquation *, int iteration); /* goes along it and measures; false
                                                        where no part of it leads on */
  void (*refine) (QnStepEquation *);                 /* once it is solved; nullable */
};

/* Newton's iteration of an equation that was measured with bonds held (qn_assembly_hold_bonds()),
 * and again for each set of them that breaks: CONVERGED, FAILED, CANCELLED or NO_MEMORY. */
QnSolveStatus qn_equilibrium_iterate (QnStepEquation *equation, int budget);

/* Newton iterations from the current displacements towards
 *
 *   R(u, lambda) - viscosity C (u - anchor.u) = 0
 *
 * and the target, with at most `budget` iterations, and one more where that is cheap. With
 * QN_MEASURE_ONLY it judges the state and forces as they are. Viscosity 0 gives static equilibrium. */
#define QN_MEASURE_ONLY (-1)
QnSolveStatus qn_equilibrium_newton (QnEquilibrium *eq, const QnTarget *target,
                                     double viscosity, int budget);

/* What the target lacks at displacements u; 0 where the multiplier is prescribed. */
double qn_equilibrium_target_lack (const QnEquilibrium *eq, const QnTarget *target,
                                   const double *u);

/* The second half of the bordered system of a target other than the multiplier,
 *
 *   K step - F_live multiplier_step             = residual
 *   direction . step                            = lack
 *
 * from eq->step = K \\ residual and eq->live_step = K \\ F_live: completes eq->step and returns
 * multiplier_step, 0 where *along_live = direction . live_step vanishes. */
double qn_equilibrium_complete_step (QnEquilibrium *eq, const QnTarget *target,
                                     double lack, double *along_live);

/* Motion, in elastic displacements of single joints under single blocks, that leaves the structure that
 * was to be analysed if nothing is known of the whole: a tenth of a millimetre has become ten metres. */
#define QN_RUNAWAY 1e5

/* Motion beyond which rounding leaves no digit between forces and the default tolerance. */
#define QN_FARTHEST 1e7

/* Sets eq->runaway by the elasticity of the whole under its dead load, settlements aside, from the state
 * at rest; QN_RUNAWAY until then, and where there is no dead load. False when memory runs out. */
bool qn_equilibrium_set_runaway (QnEquilibrium *eq);

/* Factorises the tangent of the assembly, overwrites b with its solution, and counts both. */
QnSolveStatus qn_equilibrium_factor (QnEquilibrium *eq, QnLinsysReuse reuse, double *b);

/* Overwrites b with the solution of what was factorised last. */
void qn_equilibrium_solve (QnEquilibrium *eq, double *b);

/* Counts an iteration and reports it; false when the analysis is to be cancelled. */
bool qn_equilibrium_go_on (QnEquilibrium *eq);

/* Displacements per multiplier, rate = K \ F_live (unknown_count), by the static tangent K and the
 * live load of the current state. CONVERGED, FAILED (K is singular; rate is not to be used) or
 * NO_MEMORY. */
QnSolveStatus qn_equilibrium_rate (QnEquilibrium *eq, double *rate);

/* Brings eq->slope to the current state where joints have changed their state
 * since the last factorisation. False when memory runs out. */
bool qn_equilibrium_update_slope (QnEquilibrium *eq, const double *direction);

/* Where a motion was when it had first gone farther than a distance (0), than a quarter of it (1), than a
 * quarter of that (2), and so on: to far less than an elastic displacement, as stiff joints bend the motion
 * early. */
#define QN_FALL_STATES 12
typedef struct QnFall {
  double *u[QN_FALL_STATES]; /* displacements, unknown_count each, */
  int first;                 /* from this one on */
} QnFall;

void qn_fall_init (QnFall *fall, const QnAssembly *assembly, QnPool *pool);

/* Viscous steps until relaxation gives up when its answer decides. */
#define QN_RELAX_BUDGET 300

/* Lets the structure move from the current state while the target holds, with viscosity that
 * fades as the motion dies down, until it rests (CONVERGED) or moves on for good (MECHANISM,
 * with eq->motion). A step that Newton's method does not solve is taken along the central path, unless
 * that is NULL. Where only rests near by count, `far` is finite: in large displacements what has
 * moved by more, m or characteristic lengths of rotation, moves on; what seems to fall before may still
 * come to rest. FAILED when neither is certain after `budget` viscous steps. `fall` (nullable) keeps
 * where it has been on the way to `far`. */
QnSolveStatus qn_equilibrium_relax (QnEquilibrium *eq, QnCentralPath *central,
                                    const QnTarget *target, double far, QnFall *fall,
                                    int budget);

/* Notes how far joints stand open and ties hang slack now; and whether one will close, or be taut, within
 * `horizon` if it goes on as it did since then, in `time_step`. */
void qn_equilibrium_note_gaps (QnEquilibrium *eq);
bool qn_equilibrium_will_close (const QnEquilibrium *eq, double time_step,
                                double horizon);

/* Whether a joint that does not stand open has closed by more than `least` since then, m. */
bool qn_equilibrium_is_closing (const QnEquilibrium *eq, double least);

/* Largest motion of a body since the committed state, m (qn_assembly_largest()). */
double qn_equilibrium_motion (const QnEquilibrium *eq);

/* The same in elastic displacements. */
double qn_equilibrium_elastic_displacements (const QnEquilibrium *eq);

/* Room for a state of this structure, from a pool. */
void qn_equilibrium_state_init (QnEquilibriumState *state, const QnAssembly *assembly,
                                QnPool *pool);

/* Work of the driven loads, as they are at a multiplier of 1, from these unknowns to the current ones, J.
 * Where a stage scales its multiplier, so are its loads. */
double qn_equilibrium_live_work (const QnEquilibrium *eq, const double *from);

/* Copies the current state into `state`, or makes `state` the current one. */
void qn_equilibrium_save (const QnEquilibrium *eq, QnEquilibriumState *state);
void qn_equilibrium_set_state (QnEquilibrium *eq, const QnEquilibriumState *state);

/* Accepts the current state as an equilibrium, or goes back to the last accepted one. */
void qn_equilibrium_commit (QnEquilibrium *eq);
void qn_equilibrium_record (QnEquilibrium *eq); /* and the result tells it */
void qn_equilibrium_restore (QnEquilibrium *eq);
