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

/* A state that can be restored. It includes the responses: evaluated anew, pairs at their slip strength have
 * the elastic tangent, with which an iteration diverges. */
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
  QnPool pool;      /* vectors of unknowns */
  QnPool pair_pool; /* arrays by pair, states included */
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
  double *motion;    /* of the last viscous step or unstable equilibrium, any length */
  double runaway;    /* motion that counts as collapse, in elastic displacements */

  QnEquilibriumState committed; /* last accepted equilibrium */
  QnEquilibriumState recorded;  /* last equilibrium in the result */
  QnEquilibriumState anchor;    /* start of the viscous step */

  /* Sign of the determinant of the bordered tangent in the last iteration with a prescribed measure. It
   * changes where equilibrium with the measure held becomes unstable. */
  int orientation;

  double slope; /* d multiplier / d measure in that iteration; 0: unknown */

  QnPairResponse *factored_pairs; /* and viscosity, of the last factorised tangent */
  double factored_viscosity;
  bool factored;
  bool keeps_forces; /* since last cleared, some forces differ from the law's */

  double out_of_balance; /* of the current state, relative */
  QnProgress progress;
  QnProgressFunc report;
  void *report_data;
  bool cancelled;
  QnStatistics statistics;
} QnEquilibrium;

/* Numbers the unknowns, analyses the pattern and allocates everything. Initial state: undeformed, multiplier
 * 0, not in equilibrium. `report` (nullable) may cancel. Model and contacts must outlive the workspace,
 * which is overwritten without being cleared; on failure it is empty. */
QnStatus qn_equilibrium_setup (QnEquilibrium *eq, const QnModel *model,
                               const QnContacts *contacts, QnProgressFunc report,
                               void *report_data, QnDiag *diag);

void qn_equilibrium_clear (QnEquilibrium *eq);

/* In the committed state: replaces the assembly by one with other pairs of the same model, and the linear
 * system. Evaluate next. Takes over `assembly`, or clears it and changes nothing when memory runs out. */
QnStatus qn_equilibrium_exchange (QnEquilibrium *eq, QnAssembly *assembly, QnDiag *diag);

/* Evaluates new pairs in the committed state, which remains the start of the next step although it is out
 * of balance by their forces. */
void qn_equilibrium_renew (QnEquilibrium *eq);

/* The equation of Newton's method: statics and viscous motion (newton.c), or a time step
 * (core/dynamics/time-step.c). */
struct QnStepEquation {
  QnEquilibrium *eq;
  double relative; /* residual over the forces */
  double norm;     /* of the residual; not finite: the iteration fails */
  void (*measure) (QnStepEquation *);        /* sets both, with the present bonds */
  QnSolveStatus (*solve) (QnStepEquation *); /* finds a direction */
  /* To this part of the direction, 1 at first and then halves of it, and measures. */
  void (*move) (QnStepEquation *, double part);
  void (*refine) (QnStepEquation *); /* after convergence; nullable */
};

/* Newton iterations of a step; of an easy one, after which the next is longer, and from a predicted state. */
#define QN_NEWTON_BUDGET 20
#define QN_NEWTON_EASY   6

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

/* Advance missing to the target; 0 if the multiplier is prescribed. */
double qn_equilibrium_target_lack (const QnEquilibrium *eq, const QnTarget *target);

/* Second half of the bordered system of a target other than the multiplier,
 *
 *   K step - F_live multiplier_step             = residual
 *   direction . step                            = lack
 *
 * from eq->step = K \\ residual and eq->live_step = K \\ F_live: completes eq->step and returns
 * multiplier_step, 0 where *along_live = direction . live_step vanishes. */
double qn_equilibrium_complete_step (QnEquilibrium *eq, const QnTarget *target,
                                     double lack, double *along_live);

/* Default and minimum of eq->runaway, in elastic displacements (of one joint under one block): 0.1 mm has
 * become 10 m. */
#define QN_RUNAWAY 1e5

/* Maximum of eq->runaway: beyond it rounding of forces exceeds the default tolerance. */
#define QN_FARTHEST 1e7

/* Sets eq->runaway by the elastic displacement of the undeformed structure under its dead load, without
 * settlements; QN_RUNAWAY without dead load. False when memory runs out. */
bool qn_equilibrium_set_runaway (QnEquilibrium *eq);

/* Factorises the tangent of the assembly, overwrites b with its solution, and counts both. */
QnSolveStatus qn_equilibrium_factor (QnEquilibrium *eq, double *b);

/* Overwrites b with the solution by the last factorisation. */
void qn_equilibrium_solve (QnEquilibrium *eq, double *b);

/* Counts an iteration and reports it; false when the analysis is to be cancelled. */
bool qn_equilibrium_go_on (QnEquilibrium *eq);

/* Displacements per multiplier, rate = K \ F_live (unknown_count), by the static tangent K and the
 * live load of the current state. CONVERGED, FAILED (K is singular; rate is not to be used) or
 * NO_MEMORY. */
QnSolveStatus qn_equilibrium_rate (QnEquilibrium *eq, double *rate);

/* Updates eq->slope if joints have changed state since the last factorisation. False when memory runs
 * out. */
bool qn_equilibrium_update_slope (QnEquilibrium *eq, const double *direction);

/* Displacements at which a motion first exceeded `far` / 4^i, i = 0 … 11. The smallest is far below an
 * elastic displacement, since stiff joints curve the motion early. */
#define QN_FALL_STATES 12
typedef struct QnFall {
  double *u[QN_FALL_STATES]; /* unknown_count each */
  int first;                 /* states from this index on are valid */
} QnFall;

void qn_fall_init (QnFall *fall, const QnAssembly *assembly, QnPool *pool);

/* Viscous steps of a relaxation whose answer decides the outcome; those, and factorisations along a central path,
 * that are tried before something else is. */
#define QN_RELAX_BUDGET 300
#define QN_TRIED        40

/* Viscous motion from the current state with the target held and decreasing viscosity, until the structure
 * rests (CONVERGED) or is a mechanism (MECHANISM, with eq->motion); FAILED if neither is certain after
 * `budget` steps. Steps that Newton's method cannot solve use `central` (nullable). In nonlinear geometry
 * a finite `far` (m, rotations x L) makes any larger motion a MECHANISM, and no smaller one. `fall`
 * (nullable) records the motion up to `far`. */
QnSolveStatus qn_equilibrium_relax (QnEquilibrium *eq, QnCentralPath *central,
                                    const QnTarget *target, double far, QnFall *fall,
                                    int budget);

/* Notes the present gaps of joints and slack of ties; whether one of them will close within `horizon` at its
 * mean rate since then, over `time_step`. */
void qn_equilibrium_note_gaps (QnEquilibrium *eq);
bool qn_equilibrium_will_close (const QnEquilibrium *eq, double time_step,
                                double horizon);

/* Largest motion of a body since the committed state, m (qn_assembly_largest()). */
double qn_equilibrium_motion (const QnEquilibrium *eq);

void qn_equilibrium_state_init (QnEquilibriumState *state, const QnAssembly *assembly,
                                QnPool *pool);

/* Work of the driven loads at multiplier 1 between these unknowns and the current ones, J. The multiplier is
 * that of the stage. */
double qn_equilibrium_live_work (const QnEquilibrium *eq, const double *from);

/* Copies the current state into `state`, or makes `state` the current one. */
void qn_equilibrium_save (const QnEquilibrium *eq, QnEquilibriumState *state);
void qn_equilibrium_set_state (QnEquilibrium *eq, const QnEquilibriumState *state);

/* Accepts the current state as an equilibrium, or goes back to the last accepted one. */
void qn_equilibrium_commit (QnEquilibrium *eq);
void qn_equilibrium_record (
  QnEquilibrium *eq); /* also notes it as the last one in the result */
void qn_equilibrium_restore (QnEquilibrium *eq);
