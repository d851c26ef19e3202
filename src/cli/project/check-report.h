/* What "quoin-cli check" tells about a model, for people and for programs. */
#ifndef QN_CLI_CHECK_REPORT_H
#define QN_CLI_CHECK_REPORT_H

#include "cli/base/input.h"
#include "io/result/result-check.h"
#include "io/result/result-claims.h"

/* A model that was checked, with what was found out about a result of it. */
typedef struct QnCheckReport {
  const QnInput *input;
  gboolean sound;          /* whether it can be analysed */
  const char *result_name; /* the result file's, or NULL */
  const QnResultCheck
    *check; /* NULL where there is no result, one in time, which is in motion, or one
                             without any equilibrium */
  const QnResultFaults *faults; /* NULL where there is no result */
  GPtrArray
    *unproved; /* of char *: members of the result that nothing proves; NULL likewise */
} QnCheckReport;

/* Whether the result is an equilibrium that the joints can carry, and says nothing untrue. */
gboolean qn_check_report_passes (const QnCheckReport *report);

/* To standard output. */
void qn_check_report_print (const QnCheckReport *report);

/* To standard output as JSON, in the form that data/check-format.md describes. */
gboolean qn_check_report_write_json (const QnCheckReport *report, GError **error);

#endif
