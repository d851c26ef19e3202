#include "core/path/budget.h"

#include "core/base/clock.h"

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

void
qn_budget_conclude (const QnBudget *budget, QnResult *result)
{
  if (result->outcome != QN_OUTCOME_CANCELLED || budget->spent == QN_STOP_UNKNOWN)
    return;
  result->outcome = QN_OUTCOME_NOT_CONVERGED;
  result->stop = budget->spent;
}
