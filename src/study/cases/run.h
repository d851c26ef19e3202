/* Computing the cases of a study on all cores of a machine. */
#pragma once

#include "study/cases/folder.h"

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
