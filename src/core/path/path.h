/* Following the path of equilibria: workspace shared by its parts.
 *
 * The path (path-trace.c), stage by stage where there are any (path-stages.c), drives the equilibrium
 * solver from the state under dead load and records every accepted equilibrium in the result.
 */
#pragma once

#include "core/dynamics/moving-contacts.h"
#include "core/equilibrium/central-path.h"
#include "core/linalg/inertia.h"
#include "core/path/tuning.h"
#include "core/result/result.h"

/* A multiplier at which a path without a prescribed end counts as unbounded. */
#define QN_UNBOUNDED 1e9

typedef struct QnPath {
  QnPool pool;       /* scratch */
  QnPool trace_pool; /* arrays of the current trace */
  const QnModel *model;
  const QnAnalysisSettings *settings; /* of the model or of the current stage */
  QnAnalysisSettings own_settings;    /* target of `settings` while a path is run */
  int32_t stage;                      /* number of the stage, from 1; 0: none */
  double origin, scale; /* factor of the driven sets = origin + scale x the solver's
                           multiplier, which is 0 at the start of every stage */
  QnEquilibrium equilibrium;
  QnMovingContacts moving;    /* if `follows` */
  bool follows;               /* contacts follow the blocks, from the dead load on */
  QnResult *result;           /* borrowed; grows by one step per accepted equilibrium */
  QnInertia *inertia;         /* of the tangent; NULL until it is asked for */
  double *displacements;      /* scratch, a row for every body; reactions too */
  int32_t iterations_at_step; /* statistics at the last recorded step */
  int64_t commits_at_step;    /* commits of the assembly at the last recorded step */
} QnPath;

/* Prepares the workspace and initialises *result. */
QnStatus qn_path_setup (QnPath *path, const QnModel *model, const QnContacts *contacts,
                        QnProgressFunc report, void *report_data, QnResult *result,
                        QnDiag *diag);

void qn_path_clear (QnPath *path);

/* Ends an analysis that began at `start` (qn_clock_seconds()) and clears the path. QN_OK: the result gets the
 * pairs of the current state and the statistics; else it is cleared. Returns `status`. */
QnStatus qn_path_finish (QnPath *path, QnStatus status, double start);

/* First equilibrium, under dead load. *stands = false: there is none; the result has the outcome and, if
 * certain, the moving blocks. */
QnStatus qn_path_apply_dead_load (QnPath *path, bool *stands, QnDiag *diag);

/* Stability of the solver's equilibrium in nonlinear geometry (path-rest.c), with the loads held or the
 * measure `held` . u (nullable). MECHANISM: proved unstable, eq->motion is an unstable motion with largest
 * entry 1; else CONVERGED, or NO_MEMORY. `proves`, required with a measure: CONVERGED at once if the
 * stiffness is unsymmetric, which proves little. */
QnSolveStatus qn_path_judge_stability (QnPath *path, const double *held, bool proves);

/* Stability of a structure at rest under its loads. From an unstable equilibrium it may move by at most `far`
 * (m) to a stable one: a block on one edge turns until another edge touches. CONVERGED: it rests. */
QnSolveStatus qn_path_stay (QnPath *path, double far);

/* Inertia of the last assembled tangent, false when memory runs out; its motion of least resistance if it is
 * nearly singular, largest entry 1. */
bool qn_path_count_inertia (QnPath *path, QnInertiaCount *count);
QnSolveStatus qn_path_lowest_motion (QnPath *path, double *motion);

/* The whole analysis but limit analysis: dead load, then the live loads or all stages (path-stages.c).
 * *stands = false: no equilibrium under dead load. */
QnStatus qn_path_run (QnPath *path, bool *stands, QnDiag *diag);

/* Call in the state under dead load. If `asked`, in nonlinear geometry, contacts follow the blocks from then
 * on, after each step (core/dynamics/moving-contacts.h). */
QnStatus qn_path_begin_to_follow (QnPath *path, bool asked, QnDiag *diag);

/* Updates the contacts at the committed state. *changed: arrays by pair are invalid. */
QnStatus qn_path_follow_contacts (QnPath *path, bool *changed);

/* Whether friction is at its limit somewhere. */
bool qn_path_slips (const QnAssembly *assembly);

/* Accepts the current state of the solver and records it as a step. False when memory runs
 * out. */
bool qn_path_accept (QnPath *path, double multiplier, QnEvent event);

/* Adds collapse at the last step, with this multiplier, to the solutions of the result. */
void qn_path_add_solution (QnPath *path, QnProcedure found_by, double multiplier);

/* Records these rates of the unknowns as the collapse mechanism. */
QnStatus qn_path_record_mechanism (QnPath *path, const double *velocity, QnDiag *diag);

/* Follows the path from the committed state under the driven loads, by the procedure of the settings
 * (path-trace.c), to the largest multiplier, the control target, a plateau, or collapse. *reverses (nullable)
 * is set and nothing recorded if the multiplier must fall to reach the control target: the driven loads do
 * negative work in the first step, or positive work leads away from the target. */
QnStatus qn_path_trace (QnPath *path, bool *reverses, QnDiag *diag);
