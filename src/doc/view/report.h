/* A report on a project and what was computed of it: one PDF with model, materials, loads, findings,
 * contacts, every result with its curve and mechanism, the forces of joints, the independent check, a comparison, and the
 * files it was made of. */
#pragma once

#include "core/base/progress.h"
#include "doc/text/units.h"
#include "doc/view/report-template.h"
#include "io/project/project.h"
#include "io/result/result-file.h"
#include "render/figure/pages.h"

/* One result with the project as it was computed, overrides included; all borrowed. */
typedef struct QnReportRun {
  const char *name; /* of the result file */
  const QnProject *project;
  const QnContacts *contacts;
  const QnResultFile *file;
  const QnResultFaults *faults; /* NULL: not checked, for the reason in `unchecked` */
  const char *unchecked;
} QnReportRun;

typedef struct QnReport {
  const QnProject *project;
  const QnContacts *contacts;
  const QnReportRun *runs;
  size_t run_count;
  QnReportTemplate plan; /* borrowed */
  QnUnits units;
  const char *generator;   /* "quoin 0.1.0" */
  QnProgressFunc progress; /* of the combinations, which are analysed here; NULL: none */
  void *progress_data;
} QnReport;

/* The PDF, or NULL with an error, G_IO_ERROR_CANCELLED where the progress function says so. */
GBytes *qn_report_encode (const QnReport *report, GError **error);
