/* Findings about a project and faults of a result of it, as JSON; keys: data/check-format.md. */
#pragma once

#include "io/result/result-file.h"

/* A project that was checked, and the faults of a result of it; all borrowed. */
typedef struct QnCheckReport {
  const QnProject *project;
  const QnContacts *contacts;
  gboolean sound;               /* whether it can be analysed */
  const char *result_name;      /* the result file's, or NULL */
  const QnResultFaults *faults; /* NULL where there is no result */
  /* of char *: members of the result without proof; NULL where there is no result */
  GPtrArray *unproved;
} QnCheckReport;

/* Free with g_free(). */
char *qn_check_report_dup_json (const QnCheckReport *report, gsize *length);
