#include "study/cases/run.h"

#include "core/base/clock.h"
#include "io/text/io-error.h"
#include "study/cases/store.h"
#include "study/cases/worker.h"
#include "study/plan/sample.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

/* Rows are committed after so many of them, and after so long, s: a kill costs no more than what
 * came since, and writing to the disk costs little beside computing. */
#define ROWS        100
#define INTERVAL    0.5
#define INTERVAL_MS 500

typedef struct Run {
  const QnStudy *study;
  const QnStudyRunSettings *settings;
  const char *folder;
  gsize count, width; /* cases, parameters */
  double *sample;     /* values of every case */
  QnStore *store;
  guint8 *taken; /* per case: has a row, or a worker has it, or not of this slice */
  gsize next;    /* no case before it is free */
  QnWorker *workers;
  QnStudyProgress progress;
  double begun, committed;
  guint uncommitted; /* rows */
  gsize present_before;
  gboolean cancelled;
} Run;

/* The next case to be computed; FALSE where none is left. */
static gboolean
take_case (Run *run, gsize *index)
{
  while (run->next < run->count && run->taken[run->next])
    run->next++;
  if (run->next == run->count)
    return FALSE;
  *index = run->next;
  run->taken[run->next++] = 1;
  return TRUE;
}

static gboolean
keep_row (Run *run, gsize index, const QnCaseResult *result, GError **error)
{
  run->progress.present++;
  run->progress.failed += result->failed;
  run->uncommitted++;
  return qn_store_add (run->store, index, run->sample + index * run->width, result,
                       error);
}

/* Gives a case to a worker that has none, and starts it before where there is none. */
static gboolean
feed (Run *run, QnWorker *worker, GError **error)
{
  gsize index;
  if (worker->busy || !take_case (run, &index))
    return TRUE;
  if (worker->pid == 0
      && !qn_worker_start (worker, run->settings->program, run->folder,
                           run->settings->keep, error))
    return FALSE;
  qn_worker_give (worker, index, run->sample + index * run->width, run->width);
  return TRUE;
}

/* A worker has ended, or is ended for a reason (nullable): its case failed. */
static gboolean
bury (Run *run, QnWorker *worker, const char *reason, GError **error)
{
  const gboolean ready = worker->ready, busy = worker->busy;
  const gsize index = worker->index;
  g_autofree char *how = qn_worker_end (worker, reason != NULL);
  if (!ready)
    return qn_io_fail (error, QN_IO_ERROR_FILE, "%s: %s", run->settings->program,
                       how != NULL ? how : _ ("cannot be started"));
  if (!busy)
    return TRUE;
  QnCaseResult result;
  qn_case_result_fail (&result, reason != NULL ? reason
                                : how != NULL
                                  ? how
                                  : _ ("the process of the case ended early"));
  gboolean ok = keep_row (run, index, &result, error);
  qn_case_result_clear (&result);
  return ok;
}

static gboolean
hear (Run *run, QnWorker *worker, GError **error)
{
  QnCaseResult result;
  gboolean more = qn_worker_receive (worker), ok = TRUE;
  while (ok && qn_worker_answer (worker, &result)) {
    ok = keep_row (run, worker->index, &result, error);
    qn_case_result_clear (&result);
  }
  return ok && (more || bury (run, worker, NULL, error));
}

/* Ends a worker whose case takes longer than one may. */
static gboolean
check_time (Run *run, QnWorker *worker, GError **error)
{
  double allowed = run->study->seconds;
  if (!worker->busy || !worker->ready || qn_clock_seconds () - worker->begun < allowed)
    return TRUE;
  g_autofree char *reason =
    g_strdup_printf (_ ("the case took longer than %g s (limits.seconds)"), allowed);
  return bury (run, worker, reason, error);
}

static gboolean
tell (Run *run, GError **error)
{
  double now = qn_clock_seconds ();
  QnStudyProgress *progress = &run->progress;
  gsize done = progress->present - run->present_before;
  progress->seconds = now - run->begun;
  progress->to_go = done > 0 ? progress->seconds / (double) done
                                 * (double) (progress->wanted - progress->present)
                             : NAN;
  if (run->settings->progress != NULL
      && !run->settings->progress (progress, run->settings->data))
    run->cancelled = TRUE;
  if (now - run->committed < INTERVAL && run->uncommitted < ROWS)
    return TRUE;
  run->committed = now;
  run->uncommitted = 0;
  return qn_store_commit (run->store, error);
}

/* Waits until a worker reports, or progress is due. */
static gboolean
wait_for_workers (Run *run, gboolean *busy, GError **error)
{
  guint jobs = run->settings->jobs;
  g_autofree struct pollfd *polls = g_new0 (struct pollfd, jobs);
  *busy = FALSE;
  for (guint i = 0; i < jobs; i++) {
    polls[i] = (struct pollfd){ .fd = run->workers[i].output, .events = POLLIN };
    *busy |= run->workers[i].busy;
  }
  if (!*busy)
    return TRUE;
  if (poll (polls, jobs, INTERVAL_MS) < 0 && errno != EINTR)
    return qn_io_error_set_errno (error, run->folder, _ ("cannot be read"), errno);
  for (guint i = 0; i < jobs; i++)
    if ((polls[i].revents != 0 && !hear (run, &run->workers[i], error))
        || !check_time (run, &run->workers[i], error))
      return FALSE;
  return TRUE;
}

static gboolean
compute (Run *run, GError **error)
{
  gboolean busy = TRUE, ok = TRUE;
  while (ok && busy && !run->cancelled) {
    for (guint i = 0; ok && i < run->settings->jobs; i++)
      ok = feed (run, &run->workers[i], error);
    ok = ok && wait_for_workers (run, &busy, error) && tell (run, error);
  }
  for (guint i = 0; i < run->settings->jobs; i++)
    if (run->workers[i].pid != 0)
      g_free (qn_worker_end (&run->workers[i], run->cancelled || !ok));
  /* What came in before something went wrong is kept if it can be. */
  return qn_store_commit (run->store, ok ? error : NULL) && ok;
}

/* Marks what there is, and what is of another slice. */
static gboolean
survey (Run *run, GError **error)
{
  QnShard shard = run->settings->shard;
  if (run->settings->retry && !qn_store_forget_failed (run->store, error))
    return FALSE;
  if (!qn_store_mark_present (run->store, run->taken, run->count, error))
    return FALSE;
  for (gsize i = 0; i < run->count; i++) {
    gboolean ours = i % shard.count == shard.index;
    run->progress.wanted += ours;
    run->progress.present += ours && run->taken[i];
    if (!ours)
      run->taken[i] = 1;
  }
  run->present_before = run->progress.present;
  return TRUE;
}

static gboolean
make_results_folder (const Run *run, GError **error)
{
  g_autofree char *path = g_build_filename (run->folder, "results", NULL);
  if (!run->settings->keep || g_mkdir_with_parents (path, 0777) == 0)
    return TRUE;
  return qn_io_error_set_errno (error, path, _ ("cannot be written"), errno);
}

gboolean
qn_study_run (const QnStudy *study, const char *folder,
              const QnStudyRunSettings *settings, QnStudyProgress *progress,
              gboolean *cancelled, GError **error)
{
  Run run = { .study = study,
              .settings = settings,
              .folder = folder,
              .count = qn_study_case_count (study),
              .width = study->parameters->len,
              .begun = qn_clock_seconds () };
  if (!qn_folder_prepare (folder, study, error))
    return FALSE;
  g_autofree char *database = qn_folder_dup_database (folder, settings->shard);
  int lock = qn_folder_lock (database, error);
  if (lock < 0)
    return FALSE;

  /* A worker that has gone is noticed by its output. */
  void (*before) (int) = signal (SIGPIPE, SIG_IGN);
  run.sample = qn_sample_dup (study);
  run.taken = g_new0 (guint8, run.count);
  run.workers = g_new (QnWorker, settings->jobs);
  for (guint i = 0; i < settings->jobs; i++)
    run.workers[i] = (QnWorker){ .input = -1, .output = -1 };
  run.store = qn_store_open (database, study, TRUE, error);
  gboolean ok = run.store != NULL && make_results_folder (&run, error)
                && survey (&run, error) && compute (&run, error);
  run.progress.seconds = qn_clock_seconds () - run.begun;
  *progress = run.progress;
  *cancelled = run.cancelled;

  qn_store_close (run.store);
  g_free (run.sample);
  g_free (run.workers);
  g_free (run.taken);
  signal (SIGPIPE, before);
  close (lock);
  return ok;
}

/* ---- in a thread ---- */

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
