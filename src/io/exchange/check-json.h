/* What is found out about a project, and about a result of it, as JSON; data/check-format.md describes it
 * key by key. */
#pragma once

#include "io/result/result-file.h"

/* A project that was checked, with what was found out about a result of it; all borrowed. */
typedef struct QnCheckReport {
  const QnProject *project;
  const QnContacts *contacts;
  gboolean sound;               /* whether it can be analysed */
  const char *result_name;      /* the result file's, or NULL */
  const QnResultFaults *faults; /* NULL where there is no result */
  /* of char *: members of the result that nothing proves; NULL likewise */
  GPtrArray *unproved;
} QnCheckReport;

/* Free with g_free(). */
char *qn_check_report_dup_json (const QnCheckReport *report, gsize *length);
