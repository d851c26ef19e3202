/* What "quoin-cli check" tells people about a model. */
#pragma once

#include "io/exchange/check-json.h"

/* To standard output. */
void qn_check_report_print (const QnCheckReport *report);
