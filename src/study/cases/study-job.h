/* A study computed in a background thread, which the caller polls. */
#pragma once

#include "study/cases/run.h"

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
