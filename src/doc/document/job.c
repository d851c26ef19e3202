#include "doc/document/job.h"

#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "doc/edit/edit.h"

#include <glib.h>
#include <glib/gi18n-lib.h>
#include <pthread.h>

#define PROGRESS_INTERVAL_MS 50

/* Points of the live curve of an analysis in time, at most. */
#define LIVE_POINTS 2000

/* Running time before the end of an analysis in time is estimated, s. */
#define LEAST_ELAPSED 0.5

struct _QnJob {
  GObject parent_instance;

  QnRun *run; /* filled by the thread; the job's until it is finished */
  QnDiag diag;
  guint tick;
  GArray *shown; /* copy of `curve` for the main thread */

  GThread *thread; /* joined before its run is handed out */

  /* POSIX rather than GLib, so that thread checkers see the locks. */
  pthread_mutex_t mutex; /* guards what follows */
  pthread_cond_t resumed;
  gboolean paused;
  gboolean cancelled;
  gboolean fresh;
  QnProgress progress;
  GArray *curve;                   /* of QnVec2 */
  gint64 started, paused_at, idle; /* us: when, and how long it has been paused */
};

G_DEFINE_FINAL_TYPE (QnJob, qn_job, G_TYPE_OBJECT)

static void
qn_job_finalize (GObject *object)
{
  QnJob *self = QN_JOB (object);
  g_clear_handle_id (&self->tick, g_source_remove);
  g_clear_pointer (&self->run, qn_run_unref);
  g_clear_pointer (&self->shown, g_array_unref);
  g_clear_pointer (&self->curve, g_array_unref);
  pthread_mutex_destroy (&self->mutex);
  pthread_cond_destroy (&self->resumed);
  G_OBJECT_CLASS (qn_job_parent_class)->finalize (object);
}

static void
qn_job_class_init (QnJobClass *klass)
{
  G_OBJECT_CLASS (klass)->finalize = qn_job_finalize;
  g_signal_new ("progress", QN_TYPE_JOB, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                G_TYPE_NONE, 0);
}

static void
qn_job_init (QnJob *self)
{
  self->shown = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  self->curve = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  pthread_mutex_init (&self->mutex, NULL);
  pthread_cond_init (&self->resumed, NULL);
}

QnJob *
qn_job_new (const QnModel *model, const char *name, const char *fingerprint,
            GError **error)
{
  g_autoptr (QnJob) self = g_object_new (QN_TYPE_JOB, NULL);
  self->run = qn_run_new (name, fingerprint);
  if (qn_model_copy (model, &self->run->model, &self->diag) != QN_OK) {
    qn_edit_refuse_diag (error, model, &self->diag);
    return NULL;
  }
  self->run->model.analysis.workers = qn_threads_get ();
  return g_steal_pointer (&self);
}

/* In the thread, at least once per iteration. */
static bool
on_solver_progress (const QnProgress *progress, void *user_data)
{
  QnJob *self = user_data;
  pthread_mutex_lock (&self->mutex);
  while (self->paused && !self->cancelled)
    pthread_cond_wait (&self->resumed, &self->mutex);
  self->progress = *progress;
  self->fresh = TRUE;
  /* One point for every step that converged; in time for every one that lies apart. */
  if (progress->end > 0) {
    QnVec2 point = qn_vec2 (progress->time, progress->displacement);
    if (self->curve->len == 0
        || point.x - g_array_index (self->curve, QnVec2, self->curve->len - 1).x
             >= progress->end / LIVE_POINTS)
      g_array_append_val (self->curve, point);
  } else
    while (self->curve->len < (guint) MAX (progress->steps, 0)) {
      QnVec2 point = qn_vec2 (self->curve->len, progress->multiplier);
      g_array_append_val (self->curve, point);
    }
  bool go_on = !self->cancelled;
  pthread_mutex_unlock (&self->mutex);
  return go_on;
}

/* Makes a run show one of the modes. */
static QnStatus
take_mode (QnRun *run, const QnModes *modes, gsize number, QnDiag *diag)
{
  run->mode_count = (guint) modes->count;
  return qn_modes_show (modes, number, &run->model, &run->result, diag);
}

/* A result of the state alone that the structure vibrates about. */
static QnStatus
copy_state (const QnResult *from, QnResult *to, QnDiag *diag)
{
  QnStatus status = qn_result_init (to, from->block_count, 0, diag);
  to->node_count = from->node_count;
  to->outcome = from->outcome;
  to->vibration = from->vibration;
  to->statistics = from->statistics;
  if (status == QN_OK && from->step_count > 0
      && !qn_result_add_step (to, from->steps[from->step_count - 1],
                              qn_result_step_displacements (from, from->step_count - 1)))
    return qn_diag_no_memory (diag);
  return status;
}

/* The second mode and those behind it are further runs. */
static QnStatus
split_modes (QnJob *self, const QnModes *modes, GPtrArray *runs)
{
  QnStatus status = take_mode (self->run, modes, 0, &self->diag);
  for (gsize i = 1; i < modes->count && status == QN_OK; i++) {
    QnRun *run = qn_run_new_beside (self->run, self->run->name);
    g_ptr_array_add (runs, run);
    run->loaded = self->run->loaded;
    status = copy_state (&self->run->result, &run->result, &self->diag);
    if (status == QN_OK)
      status = take_mode (run, modes, i, &self->diag);
  }
  return status;
}

static QnStatus
solve_modes (QnJob *self, GPtrArray *runs)
{
  QnRun *run = self->run;
  QnModes modes;
  QnStatus status = qn_modal_run (
    &run->model, &run->contacts, run->loaded ? QN_MODAL_LOADED : QN_MODAL_DEAD_LOAD,
    run->mode_count, on_solver_progress, self, &modes, &run->result, &self->diag);
  if (status == QN_OK && modes.count > 0)
    status = split_modes (self, &modes, runs);
  if (status == QN_OK && run->result.outcome == QN_OUTCOME_CANCELLED)
    status = QN_ERROR_CANCELLED;
  qn_modes_clear (&modes);
  return status;
}

static QnStatus
solve (QnJob *self, GPtrArray *runs)
{
  QnRun *run = self->run;
  QnStatus status = qn_contacts_detect (&run->model, &run->contacts, &self->diag);
  if (status == QN_OK && run->kind == QN_RUN_MODE) /* free structures vibrate too */
    return solve_modes (self, runs);
  if (status == QN_OK)
    status = qn_contacts_require_sound (&run->model, &run->contacts, &self->diag);
  if (status != QN_OK)
    return status;
  return (run->kind == QN_RUN_STABILITY ? qn_stability_run : qn_analysis_run) (
    &run->model, &run->contacts, on_solver_progress, self, &run->result, &self->diag);
}

static gpointer
run_in_thread (gpointer data)
{
  g_autoptr (GTask) task = data;
  QnJob *self = g_task_get_source_object (task);
  g_autoptr (GPtrArray) runs =
    g_ptr_array_new_with_free_func ((GDestroyNotify) qn_run_unref);
  g_ptr_array_add (runs, qn_run_ref (self->run));
  QnStatus status = solve (self, runs);
  if (status == QN_OK) {
    g_task_return_pointer (task, g_steal_pointer (&runs),
                           (GDestroyNotify) g_ptr_array_unref);
  } else if (status == QN_ERROR_CANCELLED) {
    g_task_return_new_error (task, G_IO_ERROR, G_IO_ERROR_CANCELLED, "%s",
                             _ ("The analysis was cancelled before its first step"));
  } else {
    GError *error = NULL;
    qn_edit_refuse_diag (&error, &self->run->model, &self->diag);
    g_task_return_error (task, error);
  }
  return NULL;
}

static gboolean
on_tick (gpointer data)
{
  QnJob *self = data;
  pthread_mutex_lock (&self->mutex);
  gboolean fresh = self->fresh;
  self->fresh = FALSE;
  g_array_set_size (self->shown, 0);
  g_array_append_vals (self->shown, self->curve->data, self->curve->len);
  pthread_mutex_unlock (&self->mutex);
  if (fresh)
    g_signal_emit_by_name (self, "progress");
  return G_SOURCE_CONTINUE;
}

void
qn_job_start (QnJob *self, GAsyncReadyCallback callback, gpointer user_data)
{
  g_return_if_fail (QN_IS_JOB (self) && self->thread == NULL && self->tick == 0);

  g_autoptr (GTask) task = g_task_new (self, NULL, callback, user_data);
  self->started = g_get_monotonic_time ();
  self->tick = g_timeout_add (PROGRESS_INTERVAL_MS, on_tick, self);
  self->thread = g_thread_new ("analysis", run_in_thread, g_steal_pointer (&task));
}

GPtrArray *
qn_job_finish (QnJob *self, GAsyncResult *result, QnDiag *diag, GError **error)
{
  g_return_val_if_fail (g_task_is_valid (result, self), NULL);
  g_clear_handle_id (&self->tick, g_source_remove);
  g_clear_pointer (&self->thread, g_thread_join);
  *diag = self->diag;
  return g_task_propagate_pointer (G_TASK (result), error);
}

void
qn_job_cancel (QnJob *self)
{
  g_return_if_fail (QN_IS_JOB (self));
  pthread_mutex_lock (&self->mutex);
  self->cancelled = TRUE;
  pthread_cond_signal (&self->resumed);
  pthread_mutex_unlock (&self->mutex);
}

void
qn_job_set_paused (QnJob *self, gboolean paused)
{
  g_return_if_fail (QN_IS_JOB (self));
  pthread_mutex_lock (&self->mutex);
  gint64 now = g_get_monotonic_time ();
  if (self->paused && !paused)
    self->idle += now - MAX (self->paused_at, self->started);
  if (paused && !self->paused)
    self->paused_at = now;
  self->paused = paused;
  pthread_cond_signal (&self->resumed);
  pthread_mutex_unlock (&self->mutex);
}

gboolean
qn_job_is_paused (QnJob *self)
{
  pthread_mutex_lock (&self->mutex);
  gboolean paused = self->paused;
  pthread_mutex_unlock (&self->mutex);
  return paused;
}

QnProgress
qn_job_get_progress (QnJob *self)
{
  pthread_mutex_lock (&self->mutex);
  QnProgress progress = self->progress;
  pthread_mutex_unlock (&self->mutex);
  return progress;
}

const QnVec2 *
qn_job_get_curve (QnJob *self, gsize *count)
{
  *count = self->shown->len;
  return (const QnVec2 *) (const void *) self->shown->data;
}

QnRun *
qn_job_get_run (QnJob *self)
{
  return self->run;
}

double
qn_job_get_followed (QnJob *self, QnId *block, QnDof *dof)
{
  const QnModel *model = &self->run->model;
  size_t body = SIZE_MAX;
  *dof = QN_DOF_UX;
  qn_model_followed (model, &body, dof);
  *block = body != SIZE_MAX ? (QnId) body : QN_NONE;
  gboolean in_time = self->run->kind == QN_RUN_ANALYSIS
                     && model->analysis.procedure == QN_PROCEDURE_DYNAMIC;
  return in_time ? qn_model_duration (model) : 0.0;
}

double
qn_job_get_remaining (QnJob *self)
{
  pthread_mutex_lock (&self->mutex);
  QnProgress progress = self->progress;
  gint64 now = self->paused ? self->paused_at : g_get_monotonic_time ();
  double elapsed = (double) (now - self->started - self->idle) / G_USEC_PER_SEC;
  pthread_mutex_unlock (&self->mutex);
  return progress.time > 0.0 && elapsed >= LEAST_ELAPSED
           ? elapsed * (progress.end - progress.time) / progress.time
           : -1.0;
}

/* More than the parts that one structure is taken to gain nothing. */
#define MOST_THREADS 16

/* Work of one caller. */
typedef struct Batch {
  void (*part) (void *data, int32_t i);
  void *data;
  int count, next; /* parts, and how many have been begun */
  int helpers;     /* threads that work on it beside the caller's */
} Batch;

static pthread_mutex_t mutex =
  PTHREAD_MUTEX_INITIALIZER; /* guards what follows, and helpers */
static pthread_cond_t begun = PTHREAD_COND_INITIALIZER, ended = PTHREAD_COND_INITIALIZER;
static Batch *helped; /* whose caller is at work, with all helpers; NULL: none */

static void
work (Batch *batch)
{
  for (int i = g_atomic_int_add (&batch->next, 1); i < batch->count;
       i = g_atomic_int_add (&batch->next, 1))
    batch->part (batch->data, i);
}

static gpointer
help (gpointer data)
{
  pthread_mutex_lock (&mutex);
  for (;;) {
    Batch *batch = helped;
    if (batch == NULL || g_atomic_int_get (&batch->next) >= batch->count) {
      pthread_cond_wait (&begun, &mutex);
      continue;
    }
    batch->helpers++;
    pthread_mutex_unlock (&mutex);
    work (batch);
    pthread_mutex_lock (&mutex);
    if (--batch->helpers == 0)
      pthread_cond_broadcast (&ended);
  }
  return data;
}

/* As many as can be started. */
static gpointer
start (gpointer data)
{
  for (guint i = 1; i < MIN (g_get_num_processors (), MOST_THREADS); i++) {
    GThread *thread = g_thread_try_new ("helper", help, NULL, NULL);
    if (thread != NULL)
      g_thread_unref (thread);
  }
  return data;
}

static void
run (void *pool, int32_t count, void (*part) (void *data, int32_t i), void *data)
{
  static GOnce once = G_ONCE_INIT;
  Batch batch = { .part = part, .data = data, .count = count };
  g_once (&once, start, NULL);
  pthread_mutex_lock (&mutex);
  if (helped == NULL) {
    helped = &batch;
    pthread_cond_broadcast (&begun);
  }
  pthread_mutex_unlock (&mutex);

  work (&batch);

  pthread_mutex_lock (&mutex);
  helped = helped == &batch ? NULL : helped;
  while (batch.helpers > 0)
    pthread_cond_wait (&ended, &mutex);
  pthread_mutex_unlock (&mutex);
}

const QnWorkers *
qn_threads_get (void)
{
  static const QnWorkers workers = { .run = run };
  return &workers;
}

bool
qn_job_may_go_on (const QnProgress *progress, void *cancellable)
{
  return !g_cancellable_is_cancelled (cancellable);
}
