#include "doc/view/animation-job.h"

#include "core/base/integer.h"
#include "doc/view/figures.h"

#define TICK_MS 50

typedef struct Work {
  QnRun *run;
  QnViewOptions options;
  QnAnimationSettings settings;
  QnMetadata metadata; /* its strings are those below */
  char *path, *model_name, *sha256;
  GCancellable *cancellable; /* of the task, or NULL */
  gint done;                 /* frames, atomic */
  QnAnimationTick tick;
  gpointer tick_data;
  guint timeout;
} Work;

static void
work_free (gpointer data)
{
  Work *work = data;
  qn_run_unref (work->run);
  g_free (work->path);
  g_free (work->model_name);
  g_free (work->sha256);
  g_free (work);
}

void
qn_animation_settings_init (QnAnimationSettings *settings, QnViewState *state)
{
  QnViewOptions shown = qn_view_state_get_options (state);
  const QnRun *run = state->document->run;
  gboolean moves = run != NULL && run->result.mechanism != NULL;
  gboolean path =
    shown.view == QN_VIEW_DEFORMED && run != NULL && run->result.step_count > 1;
  *settings =
    (QnAnimationSettings){ .view = moves && !path ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED,
                           .width = 800,
                           .height = 600,
                           .frames = 48,
                           .rate = 24,
                           .scale = shown.scale,
                           .curve = TRUE,
                           .monochrome = shown.monochrome };
  double frames =
    run != NULL ? qn_animation_frames_at (&run->result, settings->rate, 1) : 0;
  if (frames > 0)
    settings->frames = (int) qn_to_integer (frames, 2, QN_MAX_FRAMES);
}

/* ---- in the thread ---- */

static bool
on_frame (int done, int total, void *user_data)
{
  Work *work = user_data;
  g_atomic_int_set (&work->done, done);
  return !g_cancellable_is_cancelled (work->cancellable);
}

static void
write_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  Work *work = data;
  const QnAnimationSettings *s = &work->settings;
  QnAnimation animation;
  QnOutput output;
  GError *error = NULL;
  qn_animation_init (&animation, &work->run->model, &work->run->contacts,
                     &work->run->result, s->view);
  animation.figure.options = work->options;
  animation.frames = s->frames;
  animation.rate = s->rate;
  animation.once = s->once;
  animation.curve = s->curve;
  animation.progress = on_frame;
  animation.user_data = work;
  qn_output_init (&output);
  output.width = s->width;
  output.height = s->height;
  if (qn_animation_export (&animation, work->path, &output, &work->metadata, &error))
    g_task_return_boolean (task, TRUE);
  else
    g_task_return_error (task, error);
}

/* ---- in the main thread ---- */

static gboolean
on_timeout (gpointer data)
{
  Work *work = data;
  work->tick (g_atomic_int_get (&work->done), work->settings.frames, work->tick_data);
  return G_SOURCE_CONTINUE;
}

static void
on_completed (GTask *task, GParamSpec *pspec, gpointer data)
{
  Work *work = g_task_get_task_data (task);
  g_clear_handle_id (&work->timeout, g_source_remove);
}

static QnViewOptions
options_of (QnViewState *state, const QnAnimationSettings *settings)
{
  const QnRun *run = state->document->run;
  QnViewOptions options = qn_view_state_get_options (state);
  options.view = settings->view;
  options.scale = settings->scale;
  options.monochrome = settings->monochrome;
  options.titles = true;
  options.phase = 1.0;
  options.onion = NULL;
  options.underlay.image = NULL; /* belongs to the main thread */
  if (run->kind != QN_RUN_ANALYSIS && options.view == QN_VIEW_MECHANISM)
    options.symbols = false;
  return options;
}

void
qn_animation_write_async (QnViewState *state, const QnAnimationSettings *settings,
                          const char *path, GCancellable *cancellable,
                          QnAnimationTick tick, gpointer tick_data,
                          GAsyncReadyCallback callback, gpointer user_data)
{
  QnDocument *document = state->document;
  g_return_if_fail (document->run != NULL);
  Work *work = g_new0 (Work, 1);
  work->run = qn_run_ref (document->run);
  work->settings = *settings;
  work->options = options_of (state, settings);
  work->path = g_strdup (path);
  work->cancellable = cancellable;
  work->tick = tick;
  work->tick_data = tick_data;
  qn_document_get_metadata (document, &work->metadata);
  work->model_name = g_strdup (work->metadata.model);
  work->sha256 = g_strdup (work->metadata.model_sha256);
  work->metadata.model = work->model_name;
  work->metadata.model_sha256 = work->sha256;
  g_autoptr (GTask) task = g_task_new (state, cancellable, callback, user_data);
  g_task_set_check_cancellable (task, FALSE);
  g_task_set_task_data (task, work, work_free);
  g_signal_connect (task, "notify::completed", G_CALLBACK (on_completed), NULL);
  if (tick != NULL)
    work->timeout = g_timeout_add (TICK_MS, on_timeout, work);
  g_task_run_in_thread (task, write_in_thread);
}
