#include "core/path/stability.h"

#include "core/path/analysis.h"
#include "core/path/path.h"

typedef struct {
  QnPath path;
  double unstable; /* lowest multiplier found not to be stable, or infinity */
  double end;
  bool finished;
} Search;

/* Whether the stiffness of the current state has positive eigenvalues only. */
static QnStatus
check_state (Search *search, bool *stable, QnDiag *diag)
{
  QnEquilibrium *eq = &search->path.equilibrium;
  QnAssembly *as = &eq->assembly;
  QnInertiaCount count;

  qn_assembly_tangent_at_rest (as, eq->multiplier);
  if (!qn_assembly_is_symmetric (as) && qn_path_slips (as))
    return qn_refuse (diag, QN_PROBLEM_STATE_SLIPS, QN_ENTITY_MODEL, QN_NONE);
  if (!qn_path_count_inertia (&search->path, &count))
    return qn_diag_no_memory (diag);
  *stable = count.negative + count.zero == 0;
  return QN_OK;
}

/* The state at `target`: whether one is *found from here, and is *stable. */
static QnStatus
try_state (Search *search, double target, bool *found, bool *stable, QnDiag *diag)
{
  QnEquilibrium *eq = &search->path.equilibrium;
  const QnTarget goal = qn_target_multiplier (target);

  QnSolveStatus solved = qn_equilibrium_newton (eq, &goal, 0, QN_NEWTON_BUDGET);
  *stable = false;
  *found = solved == QN_SOLVE_CONVERGED;
  search->finished = solved == QN_SOLVE_CANCELLED;
  if (*found)
    return check_state (search, stable, diag);
  if (search->finished)
    search->path.result->outcome = QN_OUTCOME_CANCELLED;
  return solved == QN_SOLVE_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}

/* The buckling mode is that of the last stable state: next to the critical multiplier its eigenvalue is much
 * smaller than all others. */
static QnStatus
record_mode (Search *search, QnDiag *diag)
{
  QnEquilibrium *eq = &search->path.equilibrium;
  bool stable;

  qn_equilibrium_restore (eq);
  QnStatus status = check_state (search, &stable, diag);
  if (status != QN_OK)
    return status;
  QnSolveStatus solved = qn_path_lowest_motion (&search->path, eq->motion);
  if (solved == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  return solved == QN_SOLVE_CONVERGED
           ? qn_path_record_mechanism (&search->path, eq->motion, diag)
           : QN_OK;
}

static QnStatus
set_unstable (Search *search, QnDiag *diag)
{
  QnPath *path = &search->path;
  QnResult *result = path->result;
  double stable = path->equilibrium.committed.multiplier;

  search->finished = true;
  result->outcome = QN_OUTCOME_SNAP;
  result->stability = QN_STABILITY_LOST;
  qn_result_set_first_limit (result, 0.5 * (stable + search->unstable));
  result->steps[result->step_count - 1].event = QN_EVENT_SNAP;
  return record_mode (search, diag);
}

/* One increment, or one bisection once there is an upper bound. Where no equilibrium is found the increment
 * was too long, until it is as short as the critical multiplier is resolved. */
static QnStatus
load_further (Search *search, double *increment, QnDiag *diag)
{
  QnPath *path = &search->path;
  QnEquilibrium *eq = &path->equilibrium;
  double from = eq->committed.multiplier, target = fmin (from + *increment, search->end);
  const QnAnalysisSettings *settings = path->settings;
  double shortest = QN_PATH_RESOLUTION * settings->multiplier_tolerance
                    * fmax (fabs (target), 1.0 / settings->increments);
  bool found, stable;

  if (isfinite (search->unstable))
    target = fmin (target, 0.5 * (from + search->unstable));
  QnStatus status = try_state (search, target, &found, &stable, diag);
  if (status != QN_OK || search->finished || !stable) {
    qn_equilibrium_restore (eq);
    if (found || target - from <= shortest)
      search->unstable = target;
    *increment = 0.5 * (target - from);
    return status;
  }
  if (!qn_path_accept (path, target, QN_EVENT_NONE))
    return qn_diag_no_memory (diag);
  *increment *= QN_PATH_GROWTH;
  if (target >= search->end) {
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    path->result->stability = QN_STABILITY_KEPT;
    search->finished = true;
  }
  return QN_OK;
}

static QnStatus
search_path (Search *search, QnDiag *diag)
{
  QnPath *path = &search->path;
  QnEquilibrium *eq = &path->equilibrium;
  const QnAnalysisSettings *settings = path->settings;
  double increment = 1.0 / settings->increments;
  bool stands, stable = false;
  QnStatus status = qn_path_apply_dead_load (path, &stands, diag);

  if (status != QN_OK || !stands)
    return status;
  status = check_state (search, &stable, diag);
  if (status == QN_OK && !stable)
    search->unstable = 0;
  search->end = fmin (settings->max_multiplier, QN_UNBOUNDED);
  while (status == QN_OK && !search->finished) {
    double bracket = search->unstable - eq->committed.multiplier;
    if (isfinite (bracket)
        && bracket
             <= QN_PATH_RESOLUTION * settings->multiplier_tolerance * search->unstable)
      status = set_unstable (search, diag);
    else
      status = load_further (search, &increment, diag);
  }
  return status;
}

static QnStatus
refuse_settings (const QnModel *model, QnDiag *diag)
{
  if (model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_diag_set_field (diag, QN_PROBLEM_LIMIT_WITHOUT_STATE, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return qn_diag_set_field (diag, QN_PROBLEM_TIME_WITHOUT_STATE, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  if (model->stage_count > 0)
    return qn_diag_set_field (diag, QN_PROBLEM_STABILITY_STAGES, QN_ENTITY_ANALYSIS,
                              QN_NONE, "stages", 0);
  return QN_OK;
}

QnStatus
qn_stability_run (const QnModel *model, const QnContacts *contacts,
                  QnProgressFunc progress, void *user_data, QnResult *result,
                  QnDiag *diag)
{
  QnBudget budget = qn_budget_start (model, progress, user_data);
  Search search = { .unstable = INFINITY };

  *result = (QnResult){ 0 };
  QnStatus status = refuse_settings (model, diag);
  if (status != QN_OK)
    return status;
  status =
    qn_path_setup (&search.path, model, contacts, qn_budget_go_on, &budget, result, diag);
  if (status == QN_OK)
    status = search_path (&search, diag);
  if (status == QN_OK)
    qn_equilibrium_restore (&search.path.equilibrium);
  status = qn_path_finish (&search.path, status, budget.start);
  return qn_budget_conclude (&budget, status, contacts, result, diag);
}
