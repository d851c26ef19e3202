/* Following the path of equilibria: what the parts share.
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
  QnPool pool;       /* of scratch, */
  QnPool trace_pool; /* and of the arrays of a trace while it is followed */
  const QnModel *model;
  const QnAnalysisSettings *settings; /* in force: those of the model, or of the stage */
  QnAnalysisSettings own_settings;    /* what `settings` points to while a path is run */
  int32_t stage;                      /* number of the stage, from 1; 0: none */
  double origin, scale; /* the sets that are driven stand at origin + scale x the solver's
                           multiplier, which every stage starts from 0; 0 and 1 by default */
  QnEquilibrium equilibrium;
  QnMovingContacts moving;    /* where contacts follow the blocks, */
  bool follows;               /* from the dead load on */
  QnResult *result;           /* borrowed; grows by one step per accepted equilibrium */
  QnInertia *inertia;         /* of the tangent; NULL until it is asked for */
  double *displacements;      /* scratch, a row for every body; reactions too */
  int32_t iterations_at_step; /* statistics when the last step was recorded, */
  int64_t commits_at_step;    /* and commits of the assembly */
} QnPath;

/* Prepares the workspace and initialises *result. */
QnStatus qn_path_setup (QnPath *path, const QnModel *model, const QnContacts *contacts,
                        QnProgressFunc report, void *report_data, QnResult *result,
                        QnDiag *diag);

void qn_path_clear (QnPath *path);

/* Ends an analysis that began at `start` (qn_clock_seconds()) and clears the path. Where it went
 * well the result gets the pairs of the current state and the statistics, otherwise it is cleared.
 * Returns `status`. */
QnStatus qn_path_finish (QnPath *path, QnStatus status, double start);

/* Dead load: the first equilibrium. *stands is false when there is none; the outcome, and the
 * blocks that move where it is certain, are in the result then. */
QnStatus qn_path_apply_dead_load (QnPath *path, bool *stands, QnDiag *diag);

/* Whether a structure can stay at the equilibrium that the solver is at, in nonlinear geometry
 * (path-rest.c): with the loads held, or with a measure `held` . u (a direction, nullable). CONVERGED
 * unless it is proved that it cannot: MECHANISM, with eq->motion, in which it leaves, the
 * largest entry 1. Or NO_MEMORY. proves: where the stiffness is not symmetric, and little is proved, nothing
 * is spent on it; needed with a measure. */
QnSolveStatus qn_path_judge_stability (QnPath *path, const double *held, bool proves);

/* The same for a structure that is at rest under its loads. Where it leaves, it is let move by `far` (m) at
 * most: a block that stands on one edge turns until another touches. CONVERGED where it stays then. */
QnSolveStatus qn_path_stay (QnPath *path, double far);

/* Inertia of the tangent last assembled, and the motion that it resists least, of which the largest entry is 1:
 * it is next to singular. False when memory runs out; SINGULAR: it is as far as it is known. */
bool qn_path_count_inertia (QnPath *path, QnInertiaCount *count);
QnSolveStatus qn_path_lowest_motion (QnPath *path, double *motion);

/* The whole analysis but limit analysis: dead load, then the live loads or stage after stage
 * (path-stages.c). *stands is false where there is no equilibrium under dead load. */
QnStatus qn_path_run (QnPath *path, bool *stands, QnDiag *diag);

/* From the state under the dead load on contacts follow the blocks, where that is asked for and geometry is
 * not linear: after each step (core/dynamics/moving-contacts.h). */
QnStatus qn_path_begin_to_follow (QnPath *path, bool asked, QnDiag *diag);

/* Changes the contacts at the committed state. *changed: what belonged to the pairs of the assembly is to
 * be made anew. */
QnStatus qn_path_follow_contacts (QnPath *path, bool *changed, QnDiag *diag);

/* Whether friction is at its limit somewhere. */
bool qn_path_slips (const QnAssembly *assembly);

/* Accepts the current state of the solver and records it as a step. False when memory runs
 * out. */
bool qn_path_accept (QnPath *path, double multiplier, QnEvent event);

/* Keeps the collapse at the last step with this multiplier as a solution of the result. */
void qn_path_add_solution (QnPath *path, QnProcedure found_by, double multiplier);

/* Records these rates of the unknowns as the collapse mechanism. */
QnStatus qn_path_record_mechanism (QnPath *path, const double *velocity, QnDiag *diag);

/* Follows the path from the committed state under the driven loads, by the procedure of the settings
 * (path-trace.c): to the largest multiplier, the control target, a plateau, or collapse. *reverses (nullable)
 * is set, and nothing recorded, where the first step towards the control target takes work from the driven
 * loads, or their work leads away from it: the multiplier is to fall. */
QnStatus qn_path_trace (QnPath *path, bool *reverses, QnDiag *diag);

/* Adds the associative bound to the result of a path: the largest multiplier at which forces within the
 * strength of every joint are in balance, with whatever geometry, is that of rigid blocks that do not
 * move; so it bounds linear geometry alone. Nothing is added where analysis.bound asks for none, where
 * there is one already, or where limit analysis does not know the joints or does not get to its end.
 * *cancelled says whether `report` refused to go on. NO_MEMORY is the only error. */
QnStatus qn_path_add_bound (const QnModel *model, const QnContacts *contacts,
                            QnProgressFunc report, void *report_data, QnResult *result,
                            bool *cancelled, QnDiag *diag);
