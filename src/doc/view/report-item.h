/* Results as reports tell of them: each read as a file would be and checked, and the report on what a
 * document holds. */
#pragma once

#include "doc/document/document.h"
#include "doc/view/report.h"
#include "io/result/result-file.h"

typedef struct QnReportItem {
  QnResultFile file;
  QnResultFaults faults;
  char *unchecked; /* why it is not checked; NULL: it is */
  char *name;
} QnReportItem;

/* Checks `file`, which the caller has read from `path`, against its project. */
void qn_report_item_check (QnReportItem *item, const QnProject *project,
                           const QnContacts *contacts, const char *path);

/* What a file with this text would hold, read and checked: neither the check nor the report sees more of
 * an analysis than its file. */
gboolean qn_report_item_parse (QnReportItem *item, const char *text, gsize length,
                               const char *name, const QnProject *project,
                               const QnContacts *contacts, GError **error);

/* As the report takes it; all borrowed. */
QnReportRun qn_report_item_get_run (const QnReportItem *item, const QnProject *project,
                                    const QnContacts *contacts);

/* The units that reports of the command line have. */
#define QN_UNITS_REPORT ((QnUnits){ QN_LENGTH_M, QN_FORCE_KN, QN_STRESS_MPA })

/* The report on these runs as a file. `progress` (nullable) as in QnReport. */
GBytes *qn_report_encode_runs (const QnProject *project, const QnContacts *contacts,
                               const QnReportTemplate *plan, const QnReportRun *runs,
                               size_t count, QnUnits units, QnProgressFunc progress,
                               void *progress_data, GError **error);

void qn_report_item_clear (QnReportItem *item);

/* Writes the report on the document as its template says, with all of its runs that belong to the
 * model as it is now, in a thread of its own: combinations are analysed there. FALSE with
 * G_IO_ERROR_CANCELLED where it was cancelled; nothing is written then. */
void qn_report_write_async (QnDocument *document, QnUnits units, const char *path,
                            GCancellable *cancellable, GAsyncReadyCallback callback,
                            gpointer user_data);
gboolean qn_report_write_finish (GAsyncResult *result, GError **error);
