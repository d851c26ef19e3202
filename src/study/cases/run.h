/* Computing the cases of a study on all cores of a machine. */
#pragma once

#include "study/cases/case.h"
#include "study/cases/folder.h"

#include <stdio.h>

typedef struct QnStudyProgress {
  gsize wanted;   /* cases of this slice */
  gsize present;  /* of these, rows that are there */
  gsize failed;   /* of those computed now */
  double seconds; /* since the run began */
  double to_go;   /* s, estimated from this run; NaN: not known yet */
} QnStudyProgress;

/* Returns FALSE to end the run; computed cases are kept. */
typedef gboolean (*QnStudyProgressFunc) (const QnStudyProgress *progress, gpointer data);

typedef struct QnStudyRunSettings {
  const char *program; /* quoin-cli: it is started as `study worker FOLDER` */
  guint jobs;          /* worker processes, >= 1 */
  QnShard shard;
  gboolean keep;                /* full results of every case */
  gboolean retry;               /* cases that failed before are computed again */
  QnStudyProgressFunc progress; /* nullable */
  gpointer data;
} QnStudyRunSettings;

/* Computes all cases that have no row yet, in the folder of the study, which is made where there is
 * none. *progress says how far it came; *cancelled whether `progress` ended it. A case that fails
 * is a row that says why. Errors, QN_IO_ERROR: the folder cannot be used; what was computed until
 * then is kept as far as it could be written. */
gboolean qn_study_run (const QnStudy *study, const char *folder,
                       const QnStudyRunSettings *settings, QnStudyProgress *progress,
                       gboolean *cancelled, GError **error);

/* ---- in a thread ---- */

typedef struct QnStudyJob QnStudyJob;

/* Starts computing what is missing in the folder, on `jobs` processes of `program`. The study is
 * read from its file; errors come from there. */
QnStudyJob *qn_study_job_start (const char *study_path, const char *folder,
                                const char *program, guint jobs, GError **error);

/* Its progress; whether it still runs. Where it has failed, *error (nullable) has the reason. */
gboolean qn_study_job_look (QnStudyJob *job, QnStudyProgress *progress, GError **error);

/* Asks it to end soon; computed cases are kept. */
void qn_study_job_cancel (QnStudyJob *job);

/* Cancels, waits for the end, and frees. */
void qn_study_job_free (QnStudyJob *job);

/* ---- workers ---- */

/* Each computes one case after the other, so that a case that crashes or takes all memory ends its worker and
 * nothing else. A worker is this program again (`quoin-cli study worker FOLDER`). It says "ready", then reads
 * lines "number, values" from standard input and answers each with one line on standard output, a GVariant as
 * text. It ends with its input, or with the process that started it.
 *
 * The worker's side: serves until `input` ends. With `keep`, full results go to the folder. */
void qn_worker_serve (const QnStudy *study, const char *folder, gboolean keep,
                      FILE *input, FILE *output);
