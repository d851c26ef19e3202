#include "core/path/proof.h"

#include "core/check/result-check.h"

#include <string.h>

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
  QnStatus status =
    qn_result_find_faults (model, contacts, result, QN_CHECK_STATED, &faults, diag);
  for (int i = 0; status == QN_OK && i < faults.count; i++) {
    QnClaim claim = faults.items[i].claim;
    if (claim == QN_CLAIM_FIRST_LIMIT && result->outcome != QN_OUTCOME_SNAP)
      result->has_first_limit_multiplier = false;
    else if (claim == QN_CLAIM_OVERLAP || claim == QN_CLAIM_FLOW
             || claim == QN_CLAIM_MODE)
      result->mechanism_uncertain = true;
    else
      stands = false;
  }
  if (status == QN_OK && stands && result->mechanism_uncertain
      && result->outcome == QN_OUTCOME_COLLAPSE && result->history.width == 0
      && model->analysis.geometry == QN_GEOMETRY_NONLINEAR)
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
