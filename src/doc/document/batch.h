/* Several files opened to be compared: projects, results with their projects, folders of both. What
 * has no result is solved, one after the other, each in a thread of its own.
 *
 * Emits "changed" when a document or a run is there, or a message. */
#pragma once

#include "doc/document/document.h"

#define QN_TYPE_BATCH (qn_batch_get_type ())
G_DECLARE_FINAL_TYPE (QnBatch, qn_batch, QN, BATCH, GObject)

/* Read by all, changed by the functions below alone. */
struct _QnBatch {
  GObject parent_instance;
  GPtrArray *documents; /* of QnDocument, in the order they came in */
  GPtrArray *messages;  /* of char *: what could not be opened or solved, and why */
  guint next;           /* documents before this one are solved, or cannot be */
  gboolean cancelled;
};

/* Opens a file, or every project and result of a folder. A result belongs to the project of the name
 * that it tells, in the same folder. A project that is there already is not opened again. Returns
 * how many projects and results came; what cannot be opened is told by the messages. */
guint qn_batch_add (QnBatch *batch, const char *path);
