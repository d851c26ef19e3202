/* One trace of the path of equilibria, for every procedure; shared by path-trace.c (loop and conclusion),
 * path-step.c (one step) and path-end.c (end of the path). */
#pragma once

#include "core/limit/limit.h"
#include "core/path/path-events.h"
#include "core/path/path-measure.h"
#include "core/path/path-predictor.h"

/* Method that found the last state. */
typedef enum {
  QN_FOUND_BY_NEWTON,
  QN_FOUND_BY_CENTRAL_PATH,
  QN_FOUND_BY_RELAXATION
} QnFoundBy;

typedef struct QnPathTrace {
  QnPath *path;
  QnPathMeasure measure;
  QnPathPredictor predictor; /* large displacements without load control */
  QnPathEvents events;
  QnFall fall;            /* with the load last held above the highest multiplier */
  QnCentralPath *central; /* NULL where it does not apply */
  bool load_control;
  bool may_jump;   /* qn_assembly_may_jump() */
  bool may_soften; /* qn_assembly_may_soften() */
  bool jumped;     /* the last step was a jump */
  bool *reverses;  /* until the first step is solved: see qn_path_trace(); nullable */
  double end;      /* largest multiplier */
  double extent;   /* m: the path ends beyond it where no load is a limit (unlimited.h) */
  double
    unit; /* multiplier at which the largest live load on a block equals the dead load */
  double step;    /* next step */
  double largest; /* step so far */
  double pace;    /* motion per unit of the measure in the last smooth step; 0: unknown */
  double slope;   /* of the multiplier over the measure after the last step; 0: unknown */
  double *buckling; /* unstable motion of an unstable equilibrium */
  int looks;        /* remaining searches for the loss of stability; 0: it is reported */
  bool refused;     /* an equilibrium of the step is unstable */
  bool ends_branch; /* stability is lost just beyond the solved step */
  int orientation;  /* QnEquilibrium.orientation at the start; 0: unknown */
  QnFoundBy means;
  double above;  /* the load held next exceeds the highest one by so many tolerances */
  bool moved_on; /* a plateau was met, and rest above its peak */
  bool sought;   /* `direct` has been computed */
  QnLimitSolution direct;
  size_t leads_from;      /* number of steps after which the path leads to `direct` */
  double last_multiplier; /* before the last accepted step */
  double plateau_multiplier, plateau_motion; /* at the begin of the present plateau */
  QnStop stop;                               /* UNKNOWN while the path goes on */
  /* Load control: the state with the highest multiplier, the highest one before that, and the lower one that the
   * path had come to when the load was held. */
  QnEquilibriumState highest, before, lower;
  /* The highest equilibrium reached under a slowly growing load; the last step while the load is held. */
  QnEquilibriumState sure, ahead;
  bool doubt;    /* doubtful whether equilibria since `sure` are reached so */
  int32_t aside; /* factorisations with the load held, not counted for the path */
  QnPool states; /* memory of these five */
} QnPathTrace;

static inline bool
qn_path_trace_is_linear (const QnPathTrace *trace)
{
  return !trace->path->equilibrium.assembly.nonlinear;
}

/* How far the last step advanced the measure; 0 before the first. */
double qn_path_last_advance (const QnPathTrace *trace);

/* --- One step (path-step.c) -------------------------------------------------------------- */

/* Solves the next step of a measure of motion, of size *step (on return: size tried last). Leaves the outcome
 * as the current state: CONVERGED, with trace->means and trace->jumped; MECHANISM: the structure falls with
 * the measure held; FAILED, CANCELLED or NO_MEMORY. */
QnSolveStatus qn_path_step_solve (QnPathTrace *trace, double *step);

/* Solves a step of load control to the multiplier `target` by Newton's method alone. *easy: it converged
 * within QN_NEWTON_EASY iterations. */
QnSolveStatus qn_path_step_solve_load (QnPathTrace *trace, double target, bool *easy);

/* Whether the next step may be longer than the solved one, which took so many iterations. */
bool qn_path_step_was_easy (const QnPathTrace *trace, int32_t iterations);

/* After a solved step of this size: shortens the next one to just before the first bond breaks, extrapolated
 * linearly, or just beyond if that is very near. */
void qn_path_step_aim (QnPathTrace *trace, double step);

/* Solves a step that passes the end of the path again, to end there. FAILED, with the state unchanged, if a
 * shorter step is needed: *share of this one. */
QnSolveStatus qn_path_step_land (QnPathTrace *trace, double *share);

/* Load control in linear geometry (path-hold.c): if a structure loaded slowly may not reach the solved state,
 * relaxes it under this load. If it falls the path ends at the highest multiplier at which it rests. False
 * when memory runs out. */
bool qn_path_hold (QnPathTrace *trace);

/* --- Where the path ends (path-end.c) ----------------------------------------------------- */

/* Call after a step was accepted: sets outcome and trace->stop at a target, plateau or collapse. */
void qn_path_end_check (QnPathTrace *trace);

/* Ends the path after an unsolved step, or at a jump if the settings stop there. This and the functions
 * below return false when memory runs out. */
bool qn_path_end_give_up (QnPathTrace *trace, QnSolveStatus status);

/* What the multiplier gained last, as a part of itself, for each doubling of the motion since the stage began;
 * INFINITY before it has doubled. If the multiplier follows collapse - constant / motion, the remaining gain is as
 * large. */
double qn_path_end_gain (const QnPathTrace *trace);

/* Linear geometry: ends a path that creeps, or with `last` cannot continue, at a collapse found by limit
 * analysis with elastic joints (path-direct.c), if that collapse is ahead of the path. */
bool qn_path_end_direct (QnPathTrace *trace, bool last);

/* Whether a path in linear geometry has spent QN_PATH_EFFORT factorisations. */
bool qn_path_end_is_spent (const QnPathTrace *trace);

/* Accepts the current state of the solver (path-trace.c). False when memory runs out. */
bool qn_path_trace_accept (QnPathTrace *trace);

void qn_path_end_finish (QnPathTrace *trace, QnOutcome outcome, QnStop stop);
