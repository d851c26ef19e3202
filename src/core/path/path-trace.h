/* One trace of the path of equilibria, for every procedure: what its parts share.
 *
 * path-trace.c drives and concludes, path-step.c solves one step, path-end.c tells where the path ends.
 */
#pragma once

#include "core/limit/limit.h"
#include "core/path/path-events.h"
#include "core/path/path-measure.h"
#include "core/path/path-predictor.h"

/* How the last state was found. */
typedef enum {
  QN_FOUND_BY_NEWTON,
  QN_FOUND_BY_CENTRAL_PATH,
  QN_FOUND_BY_RELAXATION
} QnFoundBy;

typedef struct QnPathTrace {
  QnPath *path;
  QnPathMeasure measure;
  QnPathPredictor predictor; /* of large displacements, but not of load control */
  QnPathEvents events;
  QnFall fall;            /* with the load last held above the highest multiplier */
  QnCentralPath *central; /* NULL where it does not apply */
  bool load_control;
  bool may_jump;   /* some joint is not associative, or not known to be */
  bool may_soften; /* some joint may lose strength */
  bool jumped;     /* the last step moved on by a jump */
  bool *reverses;  /* until the first step is solved: see qn_path_trace(); nullable */
  double end;      /* largest multiplier */
  /* Whether no load brings it down (core/check/unlimited.h) and it is followed to no end of its own: then
   * until it has moved as far as it is large, m. */
  bool unlimited;
  double extent;
  double unit; /* that at which the largest live load on a block equals the dead load */
  double step; /* to try next */
  double largest; /* step so far */
  double to_fall; /* the shortest step known to let the structure fall; INFINITY: none */
  double pace;    /* motion per unit of the measure in the last smooth step; 0: unknown */
  double slope;   /* of the multiplier over the measure after the last step; 0: unknown */
  double *buckling; /* the motion in which an unstable equilibrium is left */
  int looks;    /* left, for where the branch loses its stability; 0: it has been told */
  bool refused; /* an equilibrium of the step is unstable */
  bool ends_branch; /* the step just solved does: stability is lost with it */
  int orientation;  /* of the path where it began; 0: unknown */
  QnFoundBy means;
  bool straight; /* the last step went on as the one before */
  double above;  /* tolerances by which the load is held above the highest one next */
  bool sought;   /* a collapse, directly; what was found: */
  QnLimitSolution direct;
  double last_multiplier;                    /* before the last accepted step */
  double plateau_multiplier, plateau_motion; /* where the present plateau began */
  QnStop stop;                               /* UNKNOWN while the path goes on */
  /* Load control: the state with the highest multiplier, and one below it: in linear geometry that from
   * which on the multiplier holds still, in large displacements the first. */
  QnEquilibriumState highest, lower;
  /* The highest equilibrium to which a structure is known to come that is loaded slowly, and whether that is in
   * doubt for the steps since then; what the last one has come to, while the load is held. */
  QnEquilibriumState sure, ahead;
  bool doubt;
  int32_t aside; /* factorisations with the load held, no part of the way to collapse */
  QnPool states; /* of these four */
} QnPathTrace;

static inline bool
qn_path_trace_is_linear (const QnPathTrace *trace)
{
  return !trace->path->equilibrium.assembly.nonlinear;
}

/* How far the last step advanced the measure; 0 before the first. */
double qn_path_last_advance (const QnPathTrace *trace);

/* --- One step (path-step.c) -------------------------------------------------------------- */

/* Solves the next step of a measure of motion, *step on entry, and leaves the outcome as the current state:
 * CONVERGED, with trace->means and trace->jumped; MECHANISM where the structure falls with the measure
 * held; FAILED; CANCELLED or NO_MEMORY. On return *step is the size that was tried last. */
QnSolveStatus qn_path_step_solve (QnPathTrace *trace, double *step);

/* The same for one of load control, to the multiplier `target`, by Newton's method alone. *easy: the next
 * one may grow. */
QnSolveStatus qn_path_step_solve_load (QnPathTrace *trace, double target, bool *easy);

/* Whether the step just solved, which took so many iterations, lets the next one grow. */
bool qn_path_step_was_easy (const QnPathTrace *trace, int32_t iterations);

/* Shortens the next step, after one of this size that was solved, to where the first bond breaks if all go on
 * as they did in it: to just before, or just beyond where that is next. */
void qn_path_step_aim (QnPathTrace *trace, double step);

/* A step that passes the end of the path is solved once more, to end right there. FAILED where that
 * takes a shorter step, *share of this one; the state is then the one that was given. */
QnSolveStatus qn_path_step_land (QnPathTrace *trace, double *share);

/* Under load control in linear geometry: whether a structure under the load of the state just solved comes to rest,
 * where that is doubtful (path-hold.c). Where it falls the path ends, at the highest multiplier at which it
 * rests. False when memory runs out. */
bool qn_path_hold (QnPathTrace *trace);

/* --- Where the path ends (path-end.c) ----------------------------------------------------- */

/* Sets outcome and trace->stop where the path has arrived where it was meant to go, or has nowhere to
 * go: to be called after a step was accepted. */
void qn_path_end_check (QnPathTrace *trace);

/* The same where the next step was not solved, or jumps where the path is to stop at jumps. False where
 * memory has run out, as in all that follows. */
bool qn_path_end_give_up (QnPathTrace *trace, QnSolveStatus status);

/* A path that led nowhere has come to collapse all the same where its highest multiplier is the
 * associative bound, to multiplier_tolerance, for none is larger. How the structure moves on is not known
 * then. */
bool qn_path_end_at_bound (QnPathTrace *trace);

/* Whether the multiplier has climbed by no more than this part while the motion doubled last:
 * where it goes like collapse - constant / motion, as much is left to gain. The structure then
 * has a collapse multiplier, although no step shows how it moves on. */
bool qn_path_end_creeps (const QnPathTrace *trace, double part);

/* Where the path creeps in linear geometry, or is at its last: ends it at a collapse found directly
 * (path-direct.c), if that is where it leads. */
bool qn_path_end_direct (QnPathTrace *trace, bool last);

/* Whether a path that settles in one place after the other has taken more than it may. */
bool qn_path_end_is_spent (const QnPathTrace *trace);

/* Accepts the current state of the solver (path-trace.c). False when memory runs out. */
bool qn_path_trace_accept (QnPathTrace *trace);

void qn_path_end_finish (QnPathTrace *trace, QnOutcome outcome, QnStop stop);
