/* What an analysis may spend: factorisations and seconds, as its settings say.
 *
 * A budget calls the progress function of the analysis's caller, and cancels when it is spent. The
 * outcome is then NOT_CONVERGED, not CANCELLED, with what was reached.
 */
#pragma once

#include "core/base/progress.h"
#include "core/result/result.h"

typedef struct QnBudget {
  const QnModel *model;
  double start;            /* s, qn_clock_seconds() */
  QnProgressFunc progress; /* the caller's; may be NULL */
  void *user_data;
  QnStop spent; /* which budget ended the analysis, or UNKNOWN */
} QnBudget;

/* Time counts from now on. */
QnBudget qn_budget_start (const QnModel *model, QnProgressFunc progress, void *user_data);

/* A QnProgressFunc whose user data is the budget. */
bool qn_budget_go_on (const QnProgress *progress, void *budget);

/* Gives a result that a spent budget has cancelled its outcome. */
void qn_budget_conclude (const QnBudget *budget, QnResult *result);
