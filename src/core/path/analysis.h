/* Running an analysis: the one door to the solver. */
#ifndef QN_CORE_ANALYSIS_H
#define QN_CORE_ANALYSIS_H

#include "core/base/progress.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

/* Solves a prepared, sound model by the procedure its settings name.
 *
 * Numerical outcomes (collapse, no convergence, cancelled …) are in result->outcome with
 * QN_OK. `result` is overwritten without being cleared; `progress` may be NULL. */
QnStatus qn_analysis_run (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc progress, void *user_data, QnResult *result,
                          QnDiag *diag);

#endif
