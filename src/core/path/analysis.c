#include "core/path/analysis.h"

#include "core/base/clock.h"
#include "core/base/tolerance.h"
#include "core/check/result-check.h"
#include "core/dynamics/dynamics.h"
#include "core/limit/limit.h"
#include "core/path/bound.h"
#include "core/path/budget.h"
#include "core/path/path.h"
#include "core/path/proof.h"

#include <math.h>
#include <stdlib.h>

/* Whether a path that was to go on to collapse came to the largest multiplier there is. */
static bool
is_unbounded (const QnModel *model, const QnResult *result)
{
  bool has_end = model->stage_count > 0 ? model->stages[model->stage_count - 1].has_target
                                        : model->analysis.max_multiplier < QN_UNBOUNDED;
  return result->outcome == QN_OUTCOME_TARGET_REACHED && !has_end
         && result->step_count > 0
         && result->steps[result->step_count - 1].multiplier
              >= QN_UNBOUNDED * (1 - QN_TOLERANCE_TARGET);
}

/* Dead load, then time. */
static QnStatus
run_in_time (QnPath *path, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  bool stands;
  QnStatus status = qn_path_apply_dead_load (path, &stands, diag);

  if (status != QN_OK || !stands)
    return status;
  status = qn_path_begin_to_follow (path, path->model->analysis.dynamic.follow, diag);
  return status == QN_OK ? qn_dynamics_run (eq, path->follows ? &path->moving : NULL,
                                            path->result, diag)
                         : status;
}

/* --- How it moves ------------------------------------------------------------------------- */

/* How the structure was seen to move beyond its collapse may be the motion of a later state. The
 * mechanism of the collapse itself is asked of limit analysis, where that gave the bound, and takes its
 * place where it is proved. */
static QnStatus
settle_mechanism (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
                  QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds (), *velocities = NULL, *seen = result->mechanism;
  QnResultFaults faults = { .count = 1 };

  if (result->outcome != QN_OUTCOME_COLLAPSE || !result->mechanism_uncertain
      || !result->has_associative_bound || result->limit.given)
    return QN_OK;
  QnStatus status =
    qn_limit_find_mechanism (model, contacts, result->pairs, result->collapse_multiplier,
                             qn_budget_go_on, budget, &velocities, NULL);
  result->mechanism = NULL;
  result->mechanism_uncertain = false;
  if (status == QN_OK && velocities != NULL)
    status =
      qn_result_set_mechanism (result, velocities, model->characteristic_length, diag);
  if (status == QN_OK && result->mechanism != NULL)
    status =
      qn_result_find_faults (model, contacts, result, QN_CHECK_STATED, &faults, diag);
  free (velocities);
  if (faults.count > 0) {
    free (result->mechanism);
    result->mechanism = seen;
    result->mechanism_uncertain = true;
  } else
    free (seen);
  result->statistics.seconds += qn_clock_seconds () - start;
  return status == QN_ERROR_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}

/* --- The whole ---------------------------------------------------------------------------- */

/* *softens: whether joints may lose strength. */
static QnStatus
follow (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
        QnResult *result, bool *softens, QnDiag *diag)
{
  QnPath path;
  bool stands;
  QnStatus status =
    qn_path_setup (&path, model, contacts, qn_budget_go_on, budget, result, diag);

  *softens = status == QN_OK && qn_assembly_may_soften (&path.equilibrium.assembly);
  if (status == QN_OK && model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    status = run_in_time (&path, diag);
  else if (status == QN_OK)
    status = qn_path_run (&path, &stands, diag);
  return qn_path_finish (&path, status, budget->start);
}

/* Where bonds break, a load that is held may drive the structure farther than steps can follow. A jack that
 * advances slowly loses load then: what it finds is told, where that is a collapse, and not below an
 * equilibrium under the load that was held. */
static QnStatus
follow_jack (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
             QnResult *result, QnDiag *diag)
{
  QnModel jacked = *model;
  QnResult found;
  bool softens;

  jacked.analysis.procedure = QN_PROCEDURE_WORK;
  double reached = result->step_count > 0
                     ? result->steps[result->step_count - 1].multiplier
                         * (1 - model->analysis.multiplier_tolerance)
                     : 0;
  QnStatus status = follow (&jacked, contacts, budget, &found, &softens, diag);
  if (status != QN_OK)
    return status;
  qn_statistics_add (&found.statistics, &result->statistics);
  if (found.outcome == QN_OUTCOME_COLLAPSE && found.collapse_multiplier >= reached) {
    QnResult held = *result;
    *result = found;
    found = held;
  } else if (found.outcome == QN_OUTCOME_CANCELLED)
    result->outcome = QN_OUTCOME_CANCELLED;
  qn_result_clear (&found);
  return QN_OK;
}

static QnStatus
run (const QnModel *model, const QnContacts *contacts, QnBudget *budget, QnResult *result,
     QnDiag *diag)
{
  bool softens;

  if (model->analysis.procedure == QN_PROCEDURE_LIMIT) {
    QnStatus status =
      qn_limit_run (model, contacts, qn_budget_go_on, budget, result, diag);
    return status == QN_OK && result->outcome != QN_OUTCOME_CANCELLED
             ? qn_path_add_broken_bound (model, contacts, qn_budget_go_on, budget, result,
                                         diag)
             : status;
  }
  QnStatus status = follow (model, contacts, budget, result, &softens, diag);
  if (status == QN_OK && softens && model->analysis.procedure == QN_PROCEDURE_LOAD
      && model->stage_count == 0 && result->outcome == QN_OUTCOME_NOT_CONVERGED)
    status = follow_jack (model, contacts, budget, result, diag);
  if (status == QN_OK && is_unbounded (model, result))
    result->outcome = QN_OUTCOME_UNBOUNDED;
  if (status == QN_OK && result->has_collapse_multiplier)
    status =
      qn_path_add_bound (model, contacts, qn_budget_go_on, budget, result, NULL, diag);
  if (status == QN_OK && result->has_collapse_multiplier)
    status =
      qn_path_add_broken_bound (model, contacts, qn_budget_go_on, budget, result, diag);
  return status;
}

QnStatus
qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                 QnProgressFunc progress, void *user_data, QnResult *result, QnDiag *diag)
{
  QnBudget budget = qn_budget_start (model, progress, user_data);

  *result = (QnResult){ 0 };
  QnStatus status = run (model, contacts, &budget, result, diag);
  if (status == QN_OK) {
    qn_budget_conclude (&budget, result);
    qn_result_judge_linearity (model, result);
    status = qn_result_prove (model, contacts, result, diag);
    if (status == QN_OK)
      status = settle_mechanism (model, contacts, &budget, result, diag);
  }
  if (status != QN_OK)
    qn_result_clear (result);
  return status;
}
