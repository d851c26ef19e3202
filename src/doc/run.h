/* One analysis that has been run: the frozen model, its contacts and the result.
 *
 * Immutable and reference counted, so it may be read from any thread and outlives the
 * document's further edits: pictures of a stale result still show the wall that was solved.
 */
#ifndef QN_DOC_RUN_H
#define QN_DOC_RUN_H

#include "core/contacts.h"
#include "core/model.h"
#include "core/result.h"
#include <glib-object.h>

typedef struct QnRun {
  QnModel model;
  QnContacts contacts;
  QnResult result;
  char *name;        /* what the user calls it, owned */
  gboolean live;     /* replaced by the next live one */
  char *fingerprint; /* digest of the document's model when it was frozen, owned */
} QnRun;

#define QN_TYPE_RUN (qn_run_get_type ())
GType qn_run_get_type (void);

/* A run with empty members that the caller fills before sharing it. */
QnRun *qn_run_new (const char *name, const char *fingerprint);
QnRun *qn_run_ref (QnRun *run);
void qn_run_unref (QnRun *run);

G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnRun, qn_run_unref)

#endif
