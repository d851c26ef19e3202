/* Recovery files: what a crash would otherwise take.
 *
 * While a document has unsaved changes its text is kept in the user's state folder, beside a
 * note of the file it belongs to. The user's own file is never touched. A clean end removes
 * the recovery file; one that is found at the next start is offered to the user. The program that
 * wrote it holds a lock on it (flock): a file without one belongs to a program that is gone.
 */
#pragma once

#include "doc/document/document.h"

/* Folder of the recovery files; the caller frees it. */
char *qn_recovery_dup_folder (void);

/* Watches a document: writes its recovery file two seconds after the last change and removes
 * it when the document is saved or released. */
typedef struct QnRecovery QnRecovery;
QnRecovery *qn_recovery_watch (QnDocument *document);
/* Ends watching and removes the file. */
void qn_recovery_end (QnRecovery *recovery);
/* Writes what is due now; FALSE where that failed. */
gboolean qn_recovery_flush (QnRecovery *recovery);

/* Recovery files that no running program has: array of paths (char *). */
GPtrArray *qn_recovery_list (void);

/* Reads one: its text and the file that it belongs to (NULL: none, never saved). */
gboolean qn_recovery_read (const char *recovery_path, char **text, char **original,
                           GError **error);
