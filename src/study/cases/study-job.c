#include "study/cases/study-job.h"

struct QnStudyJob {
  QnStudy study;
  char *folder, *program;
  guint jobs;
  GThread *thread;
  GMutex lock; /* of what follows */
  QnStudyProgress progress;
  gboolean cancel, ended;
  GError *error;
};

static gboolean
note_progress (const QnStudyProgress *progress, gpointer data)
{
  QnStudyJob *job = data;
  g_mutex_lock (&job->lock);
  job->progress = *progress;
  gboolean go_on = !job->cancel;
  g_mutex_unlock (&job->lock);
  return go_on;
}

static gpointer
compute_in_thread (gpointer data)
{
  QnStudyJob *job = data;
  QnStudyProgress progress = { 0 };
  gboolean cancelled = FALSE;
  GError *error = NULL;
  const QnStudyRunSettings settings = { .program = job->program,
                                        .jobs = job->jobs,
                                        .shard = { 0, 1 },
                                        .progress = note_progress,
                                        .data = job };
  gboolean ok =
    qn_study_run (&job->study, job->folder, &settings, &progress, &cancelled, &error);
  g_mutex_lock (&job->lock);
  if (ok)
    job->progress = progress;
  job->ended = TRUE;
  job->error = error;
  g_mutex_unlock (&job->lock);
  return NULL;
}

QnStudyJob *
qn_study_job_start (const char *study_path, const char *folder, const char *program,
                    guint jobs, GError **error)
{
  QnStudyJob *job = g_new0 (QnStudyJob, 1);
  if (!qn_study_read (study_path, NULL, &job->study, error)) {
    g_free (job);
    return NULL;
  }
  job->folder = g_strdup (folder);
  job->program = g_strdup (program);
  job->jobs = jobs;
  g_mutex_init (&job->lock);
  job->thread = g_thread_new ("study", compute_in_thread, job);
  return job;
}

gboolean
qn_study_job_look (QnStudyJob *job, QnStudyProgress *progress, GError **error)
{
  g_mutex_lock (&job->lock);
  const gboolean runs = !job->ended;
  *progress = job->progress;
  if (job->error != NULL && error != NULL)
    *error = g_error_copy (job->error);
  g_mutex_unlock (&job->lock);
  return runs;
}

void
qn_study_job_cancel (QnStudyJob *job)
{
  g_mutex_lock (&job->lock);
  job->cancel = TRUE;
  g_mutex_unlock (&job->lock);
}

void
qn_study_job_free (QnStudyJob *job)
{
  if (job == NULL)
    return;
  qn_study_job_cancel (job);
  g_thread_join (job->thread);
  g_mutex_clear (&job->lock);
  g_clear_error (&job->error);
  qn_study_clear (&job->study);
  g_free (job->folder);
  g_free (job->program);
  g_free (job);
}
