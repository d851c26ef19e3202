/* What an analysis reports is proved by the check of results, in one place for all kinds. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"

/* Checks everything that a result says but its bounds. What is not true and can be left out is: a first
 * limit point; a mechanism is marked as uncertain. Of any other result nothing is concluded: its outcome
 * becomes NOT_CONVERGED, its stop CHECK, what is refused is named, and its collapse multiplier is told as
 * one that is not proved. The steps before the first that is not true are kept, where the forces of steps
 * are known, with the stages that ended there; CANCELLED results stay as they are. */
QnStatus qn_result_prove (const QnModel *model, const QnContacts *contacts,
                          QnResult *result, QnDiag *diag);
