/* One analysis that has been run: the frozen model, its contacts and the result.
 *
 * Reference counted and, but for what it is called, immutable, so it may be read from any thread and
 * outlives the document's further edits: pictures of a stale result still show the wall that was
 * solved.
 */
#pragma once

#include "core/contact/contacts.h"
#include "core/model/model.h"
#include "core/result/result.h"
#include "doc/text/units.h"

#include <glib-object.h>

/* Requested analysis. */
typedef enum {
  QN_RUN_ANALYSIS,  /* what the settings of the analysis say */
  QN_RUN_STABILITY, /* where the path loses its stability (core/path/stability.h) */
  QN_RUN_MODE, /* one mode of small vibrations (core/modal/modal.h), as the mechanism */
} QnRunKind;

typedef struct QnRun {
  QnRunKind kind;
  QnModel model;
  QnContacts contacts;
  QnResult result;
  guint mode_count; /* MODE: one of so many; which one, the result knows */
  gboolean
    loaded; /* MODE: about the last equilibrium of the analysis, not the dead load's */
  struct QnRun *base; /* holds model and contacts of this one, or NULL */
  char *name;         /* what it is called: label and method; owned, as are … */
  char *label; /* … what the user says instead of `proposed`; NULL: it has no label */
  char *proposed, *method;
  char *text;        /* of the project, or NULL */
  gboolean of_study; /* one case of a study: with numbers of its own */
  gboolean live;     /* replaced by the next live one */
  char *fingerprint; /* the document's when the model was frozen, owned */
} QnRun;

/* A run with empty members that the caller fills before sharing it. */
QnRun *qn_run_new (const char *name, const char *fingerprint);
/* Another run that shares model and contacts. */
QnRun *qn_run_new_beside (QnRun *base, const char *name);
QnRun *qn_run_ref (QnRun *run);
void qn_run_unref (QnRun *run);

/* Whether it is an analysis in time; its kept step that is nearest to a time, s. */
gboolean qn_run_is_in_time (const QnRun *run);
int qn_result_step_at (const QnResult *result, double time);

G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnRun, qn_run_unref)

/* "Run 1, load control: 0.3558", "Run 2, modes: mode 1, 12.3 Hz". The caller frees it. */
char *qn_run_dup_title (const QnRun *run);

/* The outcome in one or two sentences. The caller frees it. */
char *qn_run_dup_explanation (const QnRun *run);

/* The mechanism in one sentence, NULL where there is none, and of modes and buckling, in which nothing
 * slides or opens. The caller frees it. */
char *qn_run_dup_mechanism_sentence (const QnRun *run);

/* Events of the path: a line for each reported event (qn_result_is_felt(); *told of them) with
 * multiplier, motion and number of moving blocks, and a line with the number of the others. The caller frees
 * it. */
char *qn_run_dup_events (const QnRun *run, QnUnits units, guint *told);

/* Whether it followed a path that has a curve. */
gboolean qn_run_has_curve (const QnRun *run);
