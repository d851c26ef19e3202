#include "study/cases/run.h"

#include "core/base/clock.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"
#include "study/cases/folder.h"
#include "study/cases/store.h"
#include "study/plan/sample.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- workers ---- */

/* Of a result: whether it failed, seconds; outcome, reason, kind and shape of the mechanism; numbers. */
#define RESULT "(bdmsmsmsms@ad)"

static void
print_result (FILE *output, const QnCaseResult *result)
{
  /* Names in a reason may have any bytes. */
  g_autofree char *reason =
    g_utf8_make_valid (result->reason != NULL ? result->reason : "", -1);
  g_strdelimit (reason, "\t\r\n", ' ');
  g_autoptr (GVariant) fields = g_variant_ref_sink (g_variant_new (
    RESULT, result->failed, result->seconds, result->outcome,
    *reason != '\0' ? reason : NULL, result->mechanism, result->shape,
    g_variant_new_fixed_array (G_VARIANT_TYPE_DOUBLE, result->numbers,
                               QN_STUDY_OUTPUT_COUNT, sizeof *result->numbers)));
  g_autofree char *line = g_variant_print (fields, FALSE);
  fprintf (output, "%s\n", line);
  fflush (output);
}

static gboolean
parse_result (const char *line, QnCaseResult *result)
{
  gsize count = 0;
  g_autoptr (GVariant) numbers = NULL;
  g_autoptr (GVariant) fields =
    g_variant_parse (G_VARIANT_TYPE ("(bdmsmsmsmsad)"), line, NULL, NULL, NULL);
  if (fields == NULL)
    return FALSE;
  g_variant_get (fields, RESULT, &result->failed, &result->seconds, &result->outcome,
                 &result->reason, &result->mechanism, &result->shape, &numbers);
  const double *values =
    g_variant_get_fixed_array (numbers, &count, sizeof *result->numbers);
  memcpy (result->numbers, values,
          MIN (count, QN_STUDY_OUTPUT_COUNT) * sizeof *result->numbers);
  return TRUE;
}

void
qn_worker_serve (const QnStudy *study, const char *folder, gboolean keep, FILE *input,
                 FILE *output)
{
  char *line = NULL;
  size_t size = 0;
  g_autofree double *values = g_new (double, study->parameters->len);

  fputs ("ready\n", output);
  fflush (output);
  while (getline (&line, &size, input) > 0) {
    QnCaseResult result;
    char *at = line;
    gsize number = (gsize) g_ascii_strtoull (at, &at, 10);
    for (guint i = 0; i < study->parameters->len; i++)
      values[i] = g_ascii_strtod (at, &at);
    g_autofree char *path = keep ? qn_folder_dup_result (folder, number) : NULL;
    qn_case_solve (study, values, path, NULL, &result);
    print_result (output, &result);
    qn_case_result_clear (&result);
  }
  free (line);
}

typedef struct Worker {
  int pid;           /* 0: none */
  int input, output; /* to write to and to read from; -1 */
  gboolean ready, busy;
  GString *received; /* what has come of the next line */
  gsize index;       /* place of its case, where it is busy, */
  double begun;      /* and when that began, where it is ready; qn_clock_seconds() */
} Worker;

/* In the child, before it becomes the worker: only what is safe after a fork. */
static void
set_up_child (gpointer data)
{
  const pid_t *parent = data;
  prctl (PR_SET_PDEATHSIG, SIGKILL);
  signal (SIGINT, SIG_IGN);
  signal (SIGPIPE, SIG_DFL);
  if (getppid () != *parent)
    _exit (1);
}

/* Starts `program` with the arguments of a worker. */
static gboolean
start_worker (Worker *worker, const char *program, const char *folder, gboolean keep,
              GError **error)
{
  const char *arguments[] = { program, "study", "worker", folder, keep ? "--keep" : NULL,
                              NULL };
  pid_t parent = getpid ();
  g_autoptr (GError) cause = NULL;
  /* As many workers as cores: libraries are not to start threads of their own beside them. */
  g_auto (GStrv) variables =
    g_environ_setenv (g_get_environ (), "OPENBLAS_NUM_THREADS", "1", TRUE);
  *worker = (Worker){ .input = -1, .output = -1 };
  if (!g_spawn_async_with_pipes (NULL, (char **) arguments, variables,
                                 G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_CLOEXEC_PIPES,
                                 set_up_child, &parent, &worker->pid, &worker->input,
                                 &worker->output, NULL, &cause))
    return qn_io_fail (error, QN_IO_ERROR_FILE, "%s: %s: %s", program,
                       _ ("cannot be started"), cause->message);
  worker->received = g_string_new (NULL);
  return TRUE;
}

/* Hands over a case to a worker that has none. One that has gone is found at the end of its output. */
static void
give (Worker *worker, gsize index, const double *values, gsize width)
{
  g_autoptr (GString) line = g_string_new (NULL);
  char number[QN_NUMBER_TEXT_SIZE];
  g_string_printf (line, "%" G_GSIZE_FORMAT, index + 1);
  for (gsize i = 0; i < width; i++)
    g_string_append_printf (line, "\t%s", qn_number_text (values[i], number));
  g_string_append_c (line, '\n');
  worker->begun = qn_clock_seconds ();
  worker->index = index;
  worker->busy = TRUE;
  for (gsize sent = 0; sent < line->len;) {
    ssize_t count = write (worker->input, line->str + sent, line->len - sent);
    if (count < 0 && errno != EINTR)
      return;
    sent += count > 0 ? (gsize) count : 0;
  }
}

/* Reads the worker's output. FALSE at its end. */
static gboolean
receive (Worker *worker)
{
  char bytes[4096];
  ssize_t count = read (worker->output, bytes, sizeof bytes);
  if (count > 0)
    g_string_append_len (worker->received, bytes, count);
  return count > 0 || (count < 0 && errno == EINTR);
}

/* The result of the worker's case, once that is complete: it is free for the next one then. FALSE where
 * there is none. *result is overwritten; to be cleared. */
static gboolean
take_answer (Worker *worker, QnCaseResult *result)
{
  for (;;) {
    const char *end = memchr (worker->received->str, '\n', worker->received->len);
    if (end == NULL)
      return FALSE;
    const gsize length = (gsize) (end - worker->received->str);
    g_autofree char *line = g_strndup (worker->received->str, length);
    g_string_erase (worker->received, 0, (gssize) length + 1);
    if (strcmp (line, "ready") == 0) {
      worker->ready = TRUE;
      worker->begun = qn_clock_seconds ();
    } else if (worker->busy && parse_result (line, result)) {
      worker->busy = FALSE;
      return TRUE;
    }
  }
}

/* Waits for a worker that has ended, or kills it first; how it ended, in words, or NULL where it ended as it
 * should. */
static char *
end_worker (Worker *worker, gboolean kill_it)
{
  int status = 0;
  if (kill_it)
    kill (worker->pid, SIGKILL);
  close (worker->input);
  close (worker->output);
  while (waitpid (worker->pid, &status, 0) < 0 && errno == EINTR)
    ;
  g_string_free (worker->received, TRUE);
  *worker = (Worker){ .input = -1, .output = -1 };
  if (WIFSIGNALED (status))
    return g_strdup_printf (_ ("the process of the case was ended by signal %d (%s)"),
                            WTERMSIG (status), strsignal (WTERMSIG (status)));
  if (WIFEXITED (status) && WEXITSTATUS (status) != 0)
    return g_strdup_printf (_ ("the process of the case ended with status %d"),
                            WEXITSTATUS (status));
  return NULL;
}

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
  Worker *workers;
  QnStudyProgress progress;
  double begun, committed;
  guint uncommitted; /* rows */
  gsize present_before;
  gboolean cancelled;
} Run;

static gboolean
keep_row (Run *run, gsize index, const QnCaseResult *result, GError **error)
{
  run->progress.present++;
  run->progress.failed += result->failed;
  run->uncommitted++;
  return qn_store_add (run->store, index, run->sample + index * run->width, result,
                       error);
}

/* Gives the next case to a worker that has none, and starts it before where there is none. */
static gboolean
feed (Run *run, Worker *worker, GError **error)
{
  if (worker->busy)
    return TRUE;
  while (run->next < run->count && run->taken[run->next])
    run->next++;
  if (run->next == run->count)
    return TRUE;
  const gsize index = run->next++;
  run->taken[index] = 1;
  if (worker->pid == 0
      && !start_worker (worker, run->settings->program, run->folder, run->settings->keep,
                        error))
    return FALSE;
  give (worker, index, run->sample + index * run->width, run->width);
  return TRUE;
}

/* A worker has ended, or is ended for a reason (nullable): its case failed. */
static gboolean
bury (Run *run, Worker *worker, const char *reason, GError **error)
{
  const gboolean ready = worker->ready, busy = worker->busy;
  const gsize index = worker->index;
  g_autofree char *how = end_worker (worker, reason != NULL);
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
hear (Run *run, Worker *worker, GError **error)
{
  QnCaseResult result;
  gboolean more = receive (worker), ok = TRUE;
  while (ok && take_answer (worker, &result)) {
    ok = keep_row (run, worker->index, &result, error);
    qn_case_result_clear (&result);
  }
  return ok && (more || bury (run, worker, NULL, error));
}

/* Ends a worker whose case takes longer than one may. */
static gboolean
check_time (Run *run, Worker *worker, GError **error)
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
      g_free (end_worker (&run->workers[i], run->cancelled || !ok));
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
  run.workers = g_new (Worker, settings->jobs);
  for (guint i = 0; i < settings->jobs; i++)
    run.workers[i] = (Worker){ .input = -1, .output = -1 };
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
