/* A report on a project and what was computed of it: one PDF with model, materials, loads, findings,
 * contacts, every result with its curve and mechanism, the forces of joints, the independent check, a comparison, and the
 * files it was made of. */
#pragma once

#include "core/base/progress.h"
#include "doc/document/document.h"
#include "doc/text/units.h"
#include "doc/view/report-template.h"
#include "io/project/project.h"
#include "io/result/result-file.h"
#include "render/figure/pages.h"

#include <gio/gio.h>

/* One result with the project as it was computed, overrides included; zeroed before it is filled. */
typedef struct QnReportRun {
  const QnProject *project; /* borrowed, as the contacts are */
  const QnContacts *contacts;
  char *name; /* of the result file; owned, as is what follows */
  QnResultFile file;
  QnResultFaults faults;
  char *unchecked; /* why it is not checked; NULL: it is */
} QnReportRun;

/* Checks `file`, which was read from `path`, against its project. */
void qn_report_run_check (QnReportRun *run, const char *path);

/* What a file of this result would hold, read and checked: neither the check nor the report sees more of an
 * analysis than its file. Name, project and contacts are there already. */
gboolean qn_report_run_take (QnReportRun *run, const QnResult *result, GError **error);
void qn_report_run_clear (QnReportRun *run);

/* The units that reports of the command line have. */
#define QN_UNITS_REPORT ((QnUnits){ QN_LENGTH_M, QN_FORCE_KN, QN_STRESS_MPA })

typedef struct QnReport {
  const QnProject *project;
  const QnContacts *contacts;
  const QnReportRun *runs;
  size_t run_count;
  QnReportTemplate plan; /* borrowed */
  QnUnits units;
  QnProgressFunc progress; /* of the combinations, which are analysed here; NULL: none */
  void *progress_data;
} QnReport;

/* The PDF, or NULL with an error, G_IO_ERROR_CANCELLED where the progress function says so. */
GBytes *qn_report_encode (const QnReport *report, GError **error);

/* Writes the report on the document as its template says, with all of its runs that belong to the
 * model as it is now, in a thread of its own: combinations are analysed there. A GTask of a gboolean, FALSE
 * with G_IO_ERROR_CANCELLED where it was cancelled; nothing is written then. */
void qn_report_write_async (QnDocument *document, QnUnits units, const char *path,
                            GCancellable *cancellable, GAsyncReadyCallback callback,
                            gpointer user_data);
