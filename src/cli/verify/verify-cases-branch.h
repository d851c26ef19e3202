/* Cases of "quoin-cli verify" that follow walls far beyond their peak. */
#ifndef QN_CLI_VERIFY_CASES_BRANCH_H
#define QN_CLI_VERIFY_CASES_BRANCH_H

#include "cli/verify/verify-cases.h"
#include "core/model/model.h"
#include "core/result/result.h"

#define QN_VERIFY_BRANCH_CASES 12

extern const QnVerifyCase qn_verify_branches[QN_VERIFY_BRANCH_CASES];

/* What a case of QN_VERIFY_BRANCH compares; not-a-number where the path does not come there. */
double qn_verify_read_branch (const QnVerifyCase *test, const QnModel *model,
                              const QnResult *result);

#endif
