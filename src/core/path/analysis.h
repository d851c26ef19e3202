/* Running an analysis: the one door to the solver. */
#pragma once

#include "core/base/progress.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

/* What an analysis may spend: factorisations and seconds, as its settings say. A budget calls the progress
 * function of the analysis's caller, and cancels when it is spent. */
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

/* Ends an analysis: the outcome of a result that a spent budget has cancelled is NOT_CONVERGED, with what was
 * reached; it is proved, and cleared on failure. Returns `status`, or that of the proof. */
QnStatus qn_budget_conclude (const QnBudget *budget, QnStatus status,
                             const QnContacts *contacts, QnResult *result, QnDiag *diag);

/* Checks everything that a result says but its bounds. What is not true and can be left out is: a first
 * limit point; a mechanism is marked as uncertain. Of any other result nothing is concluded: its outcome
 * becomes NOT_CONVERGED, its stop CHECK, what is refused is named, and its collapse multiplier is told as
 * one that is not proved. The steps before the first that is not true are kept, where the forces of steps
 * are known, with the stages that ended there; CANCELLED results stay as they are. */
QnStatus qn_result_prove (const QnModel *model, const QnContacts *contacts,
                          QnResult *result, QnDiag *diag);

/* Solves a prepared, sound model by the procedure its settings name.
 *
 * What a result says is compared with the model before anybody reads it (core/check). What is not true
 * of its mechanism or of its first limit point is taken back: the mechanism is uncertain then, the limit
 * point not known. Where anything else is not true nothing is concluded from it: the outcome becomes
 * NOT_CONVERGED, with QN_STOP_CHECK.
 *
 * The collapse of a path in linear geometry gets its associative bound where analysis.bound asks for
 * it. The statistics count its time, not its iterations and factorisations.
 *
 * Numerical outcomes (collapse, no convergence, cancelled …) are in result->outcome with
 * QN_OK. `result` is overwritten without being cleared; `progress` may be NULL. */
QnStatus qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc progress, void *user_data, QnResult *result,
                          QnDiag *diag);
