/* The report on what a document holds. */
#pragma once

#include "doc/document/document.h"
#include "doc/view/report.h"

/* Writes the report on the document as its template says, with all of its runs that belong to the
 * model as it is now, in a thread of its own: combinations are analysed there. FALSE with
 * G_IO_ERROR_CANCELLED where it was cancelled; nothing is written then. */
void qn_report_write_async (QnDocument *document, QnUnits units, const char *path,
                            GCancellable *cancellable, GAsyncReadyCallback callback,
                            gpointer user_data);
gboolean qn_report_write_finish (GAsyncResult *result, GError **error);
