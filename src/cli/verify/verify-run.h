/* Computing what a case of "quoin-cli verify" compares. */
#pragma once

#include "cli/base/input.h"
#include "cli/verify/verify-cases.h"
#include "core/base/progress.h"
#include "core/result/result.h"

/* Runs the analysis that the case asks for. *value is not-a-number where it did not come to
 * what is compared. *result is overwritten, empty on failure. */
QnStatus qn_verify_run (const QnVerifyCase *test, const QnInput *input,
                        QnProgressFunc progress, void *user_data, QnResult *result,
                        double *value, QnDiag *diag);
