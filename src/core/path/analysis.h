/* Running an analysis: the one door to the solver. */
#pragma once

#include "core/base/progress.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

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
