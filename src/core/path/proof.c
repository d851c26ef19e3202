#include "core/path/proof.h"

#include "core/check/result-check.h"

/* A result of which nothing is concluded. */
static void
withdraw (QnResult *result)
{
  result->outcome = QN_OUTCOME_NOT_CONVERGED;
  result->stop = QN_STOP_CHECK;
  result->stability = QN_STABILITY_UNKNOWN;
  result->has_associative_bound = false;
  qn_result_clear_collapse (result);
  qn_result_clear_events (result);
  if (result->step_count > 0)
    result->steps[result->step_count - 1].event = QN_EVENT_NONE;
}

QnStatus
qn_result_prove (const QnModel *model, const QnContacts *contacts, QnResult *result,
                 QnDiag *diag)
{
  QnResultFaults faults;
  bool stands = true;

  if (result->outcome == QN_OUTCOME_CANCELLED
      || result->outcome == QN_OUTCOME_NOT_CONVERGED)
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
  if (status == QN_OK && !stands)
    withdraw (result);
  return status;
}
