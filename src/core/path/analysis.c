#include "core/path/analysis.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/check/result-check.h"
#include "core/dynamics/dynamics.h"
#include "core/limit/limit.h"
#include "core/path/path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- Budget ------------------------------------------------------------------------------- */

QnBudget
qn_budget_start (const QnModel *model, QnProgressFunc progress, void *user_data)
{
  return (QnBudget){ .model = model,
                     .start = qn_clock_seconds (),
                     .progress = progress,
                     .user_data = user_data,
                     .spent = QN_STOP_UNKNOWN };
}

bool
qn_budget_go_on (const QnProgress *progress, void *data)
{
  QnBudget *budget = data;

  if (progress->factorizations >= qn_model_most_factorizations (budget->model))
    budget->spent = QN_STOP_FACTORIZATIONS;
  else if (qn_clock_seconds () - budget->start > budget->model->analysis.max_seconds)
    budget->spent = QN_STOP_TIME;
  return budget->spent == QN_STOP_UNKNOWN
         && (budget->progress == NULL || budget->progress (progress, budget->user_data));
}

QnStatus
qn_budget_conclude (const QnBudget *budget, QnStatus status, const QnContacts *contacts,
                    QnResult *result, QnDiag *diag)
{
  if (status == QN_OK && result->outcome == QN_OUTCOME_CANCELLED
      && budget->spent != QN_STOP_UNKNOWN) {
    result->outcome = QN_OUTCOME_NOT_CONVERGED;
    result->stop = budget->spent;
  }
  if (status == QN_OK)
    status = qn_result_prove (budget->model, contacts, result, diag);
  if (status != QN_OK)
    qn_result_clear (result);
  return status;
}

/* --- Proof -------------------------------------------------------------------------------- */

/* What is true of a result of which nothing is concluded: the steps before the first that is not, with what
 * happened in the stages before. Where the forces of earlier steps were not kept all of them stay. Whether
 * another step is the last one now, which is checked more closely than it was. */
static bool
keep_what_is_true (const QnModel *model, QnResult *result, const QnResultFaults *faults)
{
  size_t first = result->step_count;

  for (int i = 0; i < faults->count; i++)
    if (faults->items[i].step != QN_NONE && (size_t) faults->items[i].step < first)
      first = (size_t) faults->items[i].step;
  if (first == result->step_count || result->history.width > 0
      || (first > 0 && !qn_result_has_forces (result, first - 1)))
    return false;
  for (size_t p = 0; p < result->pair_count; p++)
    result->pairs[p] =
      first > 0 ? qn_result_pair_at (result, first - 1, p) : (QnPairResult){ 0 };
  qn_result_keep_steps (result, first);
  if (first > 0)
    result->stage = result->steps[first - 1].stage;
  qn_result_judge_linearity (model, result);
  return first > 0;
}

/* A mechanism in large displacements in which joints do not flow as rigid blocks would have it: proved by
 * its second-order work, or uncertain. */
static QnStatus
prove_by_work (const QnModel *model, const QnContacts *contacts, QnResult *result,
               QnDiag *diag)
{
  QnResultFaults faults;

  result->mechanism_uncertain = false;
  result->mechanism_by_work = true;
  QnStatus status =
    qn_result_find_faults (model, contacts, result, QN_CHECK_STATED, &faults, diag);
  for (int i = 0; status == QN_OK && i < faults.count; i++)
    if (faults.items[i].claim != QN_CLAIM_FIRST_LIMIT)
      result->mechanism_uncertain = true;
  result->mechanism_by_work = !result->mechanism_uncertain;
  return status;
}

QnStatus
qn_result_prove (const QnModel *model, const QnContacts *contacts, QnResult *result,
                 QnDiag *diag)
{
  QnResultFaults faults;
  bool stands = true;

  if (result->outcome == QN_OUTCOME_CANCELLED)
    return QN_OK;
  /* What moves away from a peak says nothing of the peak, and may move against the loads. */
  double peak = result->has_collapse_multiplier ? result->collapse_multiplier : NAN;
  bool away = result->step_count > 0
              && fabs (result->steps[result->step_count - 1].multiplier - peak)
                   > model->analysis.multiplier_tolerance * fabs (peak);
  QnStatus status =
    qn_result_find_faults (model, contacts, result, QN_CHECK_STATED, &faults, diag);
  for (int i = 0; status == QN_OK && i < faults.count; i++) {
    QnClaim claim = faults.items[i].claim;
    if (claim == QN_CLAIM_FIRST_LIMIT && result->outcome != QN_OUTCOME_SNAP)
      result->has_first_limit_multiplier = false;
    else if (claim == QN_CLAIM_OVERLAP || claim == QN_CLAIM_FLOW || claim == QN_CLAIM_MODE
             || (claim == QN_CLAIM_WORK && away))
      result->mechanism_uncertain = true;
    else
      stands = false;
  }
  if (status == QN_OK && stands && result->mechanism_uncertain
      && result->outcome == QN_OUTCOME_COLLAPSE && result->history.width == 0)
    return prove_by_work (model, contacts, result, diag);
  if (status != QN_OK || stands)
    return status;
  result->stop = QN_STOP_CHECK;
  result->outcome = QN_OUTCOME_NOT_CONVERGED;
  result->stability = QN_STABILITY_UNKNOWN;
  result->has_associative_bound = false;
  result->has_unproved_multiplier = result->has_collapse_multiplier;
  result->unproved_multiplier = result->collapse_multiplier;
  qn_result_clear_collapse (result);
  qn_result_clear_events (result);
  for (size_t i = 0; i < result->step_count; i++)
    result->steps[i].event = QN_EVENT_NONE;
  memcpy (result->refused, faults.items, sizeof faults.items);
  result->refused_count = faults.count;
  while (status == QN_OK && keep_what_is_true (model, result, &faults))
    status =
      qn_result_find_faults (model, contacts, result, QN_CHECK_STATED, &faults, diag);
  return status;
}

/* --- Bounds ------------------------------------------------------------------------------- */

static bool
wants_bound (const QnModel *model, const QnContacts *contacts, const QnResult *result)
{
  const QnAnalysisSettings *settings = &model->analysis;

  for (size_t i = 0; i < model->live_load_count; i++)
    if (model->live_loads[i].kind == QN_LOAD_SETTLEMENT)
      return false;
  return !result->has_associative_bound && settings->geometry == QN_GEOMETRY_LINEAR
         && model->stage_count == 0 && model->element_count == 0
         && (settings->bound == QN_BOUND_ALWAYS
             || (settings->bound == QN_BOUND_AUTO
                 && contacts->pair_count <= QN_BOUND_PAIRS));
}

/* Limit analysis beside a path, whose time counts with it: the associative bound and, where `known` is finite,
 * collapses below it that are proved; neither, if cancelled. NO_MEMORY is the only error. */
static QnStatus
solve_rigid (const QnModel *model, const QnContacts *contacts, double known,
             QnBudget *budget, QnResult *found, QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds ();
  QnModel rigid = *model;

  rigid.analysis.procedure = QN_PROCEDURE_LIMIT;
  rigid.analysis.flow = known < INFINITY ? QN_FLOW_NON_ASSOCIATIVE : QN_FLOW_ASSOCIATIVE;
  *found = (QnResult){ 0 };
  QnStatus status =
    qn_limit_run (&rigid, contacts, known, qn_budget_go_on, budget, found, NULL);
  bool bounded = status == QN_OK && found->has_associative_bound
                 && found->outcome != QN_OUTCOME_CANCELLED;
  if (status == QN_OK && known < INFINITY)
    status = qn_result_prove (&rigid, contacts, found, NULL);
  if (status != QN_OK)
    found->outcome = QN_OUTCOME_NOT_CONVERGED;
  if (found->mechanism_uncertain)
    found->solution_count = 0;
  found->has_associative_bound = bounded;
  result->statistics.seconds += qn_clock_seconds () - start;
  return status == QN_ERROR_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}

/* Adds the associative bound (the largest multiplier with forces in balance and within the strength of all
 * joints, in the undeformed geometry), unless it is not asked for or limit analysis does not apply, and proved
 * collapses below that of the path. */
static QnStatus
add_bound (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
           QnResult *result, QnDiag *diag)
{
  QnResult found;
  bool may_be_lower =
    result->outcome == QN_OUTCOME_COLLAPSE && result->has_collapse_multiplier
    && model->analysis.procedure == QN_PROCEDURE_LOAD
    && qn_model_is_non_associative (model) && !qn_model_has_bonds (model);

  if (!wants_bound (model, contacts, result))
    return QN_OK;
  QnStatus status =
    solve_rigid (model, contacts, may_be_lower ? result->collapse_multiplier : INFINITY,
                 budget, &found, result, diag);
  result->has_associative_bound = found.has_associative_bound;
  result->associative_bound = found.has_associative_bound ? found.associative_bound : 0;
  for (int32_t i = 0; may_be_lower && i < found.solution_count; i++)
    if (found.solutions[i].multiplier < result->collapse_multiplier)
      qn_result_add_solution (result, found.solutions[i]);
  qn_result_clear (&found);
  return status;
}

/* Where the associative bound is known and joints have a bond, which it takes as ductile: adds the same of
 * joints whose bonds are broken, unless analysis.bound asks for none. */
static QnStatus
add_broken_bound (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
                  QnResult *result, QnDiag *diag)
{
  QnModel dry = *model; /* but for its laws */
  QnResult found;

  if (!qn_model_has_bonds (model) || !result->has_associative_bound
      || model->analysis.bound == QN_BOUND_NEVER)
    return QN_OK;
  dry.laws = qn_alloc (model->law_count, sizeof *dry.laws);
  if (dry.laws == NULL)
    return qn_diag_no_memory (diag);
  memcpy (dry.laws, model->laws, model->law_count * sizeof *dry.laws);
  for (size_t i = 0; i < model->law_count; i++)
    qn_law_break_bond (&dry.laws[i]);
  QnStatus status = solve_rigid (&dry, contacts, INFINITY, budget, &found, result, diag);
  bool collapses = found.outcome == QN_OUTCOME_COLLAPSE;
  result->has_broken_bound = collapses || found.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  result->broken_bound = collapses ? found.collapse_multiplier : 0;
  qn_result_clear (&found);
  free (dry.laws);
  return status;
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
                             qn_budget_go_on, budget, &velocities);
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

static QnStatus
follow_load (const QnModel *model, const QnContacts *contacts, QnBudget *budget,
             QnResult *result, QnDiag *diag)
{
  QnPath path;
  bool stands;
  bool in_time = model->analysis.procedure == QN_PROCEDURE_DYNAMIC;
  QnStatus status =
    qn_path_setup (&path, model, contacts, qn_budget_go_on, budget, result, diag);

  if (status == QN_OK)
    status = in_time ? qn_path_apply_dead_load (&path, &stands, diag)
                     : qn_path_run (&path, &stands, diag);
  in_time &= status == QN_OK && stands;
  if (in_time)
    status = qn_path_begin_to_follow (&path, model->analysis.dynamic.follow, diag);
  if (in_time && status == QN_OK)
    status = qn_dynamics_run (&path.equilibrium, path.follows ? &path.moving : NULL,
                              result, diag);
  return qn_path_finish (&path, status, budget->start);
}

static QnStatus
run (const QnModel *model, const QnContacts *contacts, QnBudget *budget, QnResult *result,
     QnDiag *diag)
{
  if (model->analysis.procedure == QN_PROCEDURE_LIMIT) {
    QnStatus status =
      qn_limit_run (model, contacts, INFINITY, qn_budget_go_on, budget, result, diag);
    return status == QN_OK && result->outcome != QN_OUTCOME_CANCELLED
             ? add_broken_bound (model, contacts, budget, result, diag)
             : status;
  }
  QnStatus status = follow_load (model, contacts, budget, result, diag);
  /* A path that was to go on to collapse may have come to the largest multiplier there is. */
  bool has_end = model->stage_count > 0 ? model->stages[model->stage_count - 1].has_target
                                        : model->analysis.max_multiplier < QN_UNBOUNDED;
  if (status == QN_OK && result->outcome == QN_OUTCOME_TARGET_REACHED && !has_end
      && result->step_count > 0
      && result->steps[result->step_count - 1].multiplier
           >= QN_UNBOUNDED * (1 - QN_TOLERANCE_TARGET))
    result->outcome = QN_OUTCOME_UNBOUNDED;
  if (status == QN_OK && result->has_collapse_multiplier)
    status = add_bound (model, contacts, budget, result, diag);
  return status == QN_OK && result->has_collapse_multiplier
           ? add_broken_bound (model, contacts, budget, result, diag)
           : status;
}

QnStatus
qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                 QnProgressFunc progress, void *user_data, QnResult *result, QnDiag *diag)
{
  QnBudget budget = qn_budget_start (model, progress, user_data);

  *result = (QnResult){ 0 };
  QnStatus status = run (model, contacts, &budget, result, diag);
  if (status == QN_OK)
    qn_result_judge_linearity (model, result);
  status = qn_budget_conclude (&budget, status, contacts, result, diag);
  if (status == QN_OK)
    status = settle_mechanism (model, contacts, &budget, result, diag);
  if (status != QN_OK)
    qn_result_clear (result);
  return status;
}
