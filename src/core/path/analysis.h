/* Running an analysis: the one door to the solver. */
#pragma once

#include "core/base/progress.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

/* Budget of an analysis: factorisations and seconds of its settings. Calls the caller's progress function;
 * cancels when it is spent. */
typedef struct QnBudget {
  const QnModel *model;
  double start;            /* s, qn_clock_seconds() */
  QnProgressFunc progress; /* the caller's; may be NULL */
  void *user_data;
  QnStop spent; /* the budget that ended the analysis, or UNKNOWN */
} QnBudget;

/* Starts the clock. */
QnBudget qn_budget_start (const QnModel *model, QnProgressFunc progress, void *user_data);

/* A QnProgressFunc whose user data is the budget. */
bool qn_budget_go_on (const QnProgress *progress, void *budget);

/* Ends an analysis: a result cancelled by the budget becomes NOT_CONVERGED and keeps its steps. Proves the
 * result, clears it on failure. Returns `status`, or the status of the proof. */
QnStatus qn_budget_conclude (const QnBudget *budget, QnStatus status,
                             const QnContacts *contacts, QnResult *result, QnDiag *diag);

/* Checks all claims of a result but its bounds. A false first limit point is removed, a false mechanism marked
 * as uncertain. Any other false claim makes the outcome NOT_CONVERGED with stop CHECK; the false claims are
 * listed, the collapse multiplier is kept as unproved, and the steps before the first false one, and their
 * stages, are kept if the forces of steps are known. CANCELLED results are not changed. */
QnStatus qn_result_prove (const QnModel *model, const QnContacts *contacts,
                          QnResult *result, QnDiag *diag);

/* Solves a prepared, sound model by the procedure its settings name.
 *
 * The result has passed qn_result_prove(). The collapse of a path in linear geometry gets its associative
 * bound if analysis.bound asks for it; the statistics count its time, not its iterations and factorisations.
 *
 * Numerical outcomes (collapse, no convergence, cancelled …) are in result->outcome with
 * QN_OK. `result` is overwritten without being cleared; `progress` may be NULL. */
QnStatus qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc progress, void *user_data, QnResult *result,
                          QnDiag *diag);
