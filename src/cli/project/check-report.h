/* What "quoin-cli check" tells people about a model. */
#ifndef QN_CLI_CHECK_REPORT_H
#define QN_CLI_CHECK_REPORT_H

#include "io/exchange/check-json.h"

/* To standard output. */
void qn_check_report_print (const QnCheckReport *report);

#endif
