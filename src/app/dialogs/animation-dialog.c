/* The animation dialog: what moves, how many pictures of which size; then where to write them, in a thread of
 * its own, and how far that is. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "core/base/integer.h"
#include "doc/view/figures.h"
#include "render/movie/animation.h"
#include <glib/gi18n.h>

#define TICK_MS 50

enum { FORMAT_GIF, FORMAT_WEBM, FORMAT_PICTURES };

typedef struct Dialog {
  QnForm base;
  GtkWindow *parent;
  QnViewState *state;
  QnTellFunc tell;
  QnAnimation animation; /* what the fields say, and while it is written all of it */
  QnOutput output;
  int format;
  char *path, *message; /* message: NULL for the facts */
  /* While it is written: nothing else of the dialog changes meanwhile. */
  GCancellable *cancellable;
  QnRun *run;
  QnMetadata metadata; /* its strings are those below */
  char *model, *sha256;
  gint done; /* frames, atomic */
  guint timeout;
} Dialog;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (WHAT, "what", NULL)                                                             \
  FIELD (FORMAT, "format", NULL)                                                         \
  MEMBER (WIDTH, "width", NULL, Dialog, output.width)                                    \
  MEMBER (HEIGHT, "height", NULL, Dialog, output.height)                                 \
  MEMBER (FRAMES, "frames", NULL, Dialog, animation.frames)                              \
  FIELD (RATE, "rate", NULL)                                                             \
  FIELD (SPEED, "speed", NULL)                                                           \
  MEMBER (SCALE, "scale", NULL, Dialog, animation.figure.options.scale)                  \
  MEMBER (ONCE, "once", NULL, Dialog, animation.once)                                    \
  MEMBER (CURVE, "curve", NULL, Dialog, animation.curve)                                 \
  MEMBER (MONOCHROME, "monochrome", NULL, Dialog, animation.figure.options.monochrome)   \
  FIELD (BOX, "fields", NULL)                                                            \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (PROGRESS, "progress", NULL)                                                     \
  FIELD (EXPORT, "export", NULL)                                                         \
  FIELD (CANCEL, "cancel", NULL)
QN_FORM_FIELDS;

static void
clear (QnForm *data)
{
  Dialog *dialog = (Dialog *) data;
  g_free (dialog->path);
  g_free (dialog->message);
}

static void
on_destroy (Dialog *dialog)
{
  g_cancellable_cancel (dialog->cancellable);
}

/* What there is to say besides the facts; NULL for nothing. */
static void
say (gpointer data, const char *message)
{
  Dialog *dialog = data;
  g_free (dialog->message);
  dialog->message = g_strdup (message);
  qn_form_show (dialog);
}

/* ---- writing ---- */

static gboolean
on_tick (gpointer data)
{
  Dialog *dialog = data;
  const int done = g_atomic_int_get (&dialog->done), total = dialog->animation.frames;
  if (dialog->base.closed)
    return G_SOURCE_CONTINUE;
  GtkProgressBar *bar = GTK_PROGRESS_BAR (dialog->base.widgets[PROGRESS]);
  g_autofree char *text = g_strdup_printf (_ ("Picture %d of %d"), done, total);
  gtk_progress_bar_set_fraction (bar, (double) done / total);
  gtk_progress_bar_set_text (bar, text);
  return G_SOURCE_CONTINUE;
}

/* In the thread. */
static bool
on_frame (int done, int total, void *data)
{
  Dialog *dialog = data;
  g_atomic_int_set (&dialog->done, done);
  return !g_cancellable_is_cancelled (dialog->cancellable);
}

static void
write_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  const Dialog *dialog = data;
  GError *error = NULL;
  if (qn_animation_export (&dialog->animation, dialog->path, &dialog->output,
                           &dialog->metadata, &error))
    g_task_return_boolean (task, TRUE);
  else
    g_task_return_error (task, error);
}

static void
on_written (GObject *source, GAsyncResult *result, gpointer data)
{
  Dialog *dialog = data;
  g_autoptr (GtkWindow) parent = dialog->parent;
  g_autoptr (GError) error = NULL;
  gboolean done = g_task_propagate_boolean (G_TASK (result), &error);
  gboolean cancelled = g_cancellable_is_cancelled (dialog->cancellable);
  g_clear_object (&dialog->cancellable);
  g_clear_handle_id (&dialog->timeout, g_source_remove);
  g_clear_pointer (&dialog->run, qn_run_unref);
  g_free (dialog->model);
  g_free (dialog->sha256);
  if (done) {
    g_autofree char *message =
      g_strdup_printf (_ ("Animation written to %s"), dialog->path);
    dialog->tell (parent, message);
    if (!dialog->base.closed)
      gtk_window_destroy (GTK_WINDOW (dialog->base.root));
  } else if (!dialog->base.closed)
    say (dialog, cancelled ? _ ("Cancelled; nothing was written.") : error->message);
  qn_form_unref (dialog);
}

/* What the window shows of the run, with what the fields say. */
static void
choose_figure (Dialog *dialog)
{
  QnFigure *figure = &dialog->animation.figure;
  const QnRun *run = dialog->run;
  QnViewOptions options = qn_view_state_get_options (dialog->state);
  options.view = figure->options.view;
  options.scale = figure->options.scale;
  options.monochrome = figure->options.monochrome;
  options.titles = true;
  options.phase = 1.0;
  options.onion = NULL;
  options.underlay.image = NULL; /* belongs to the main thread */
  if (run->kind != QN_RUN_ANALYSIS && options.view == QN_VIEW_MECHANISM)
    options.symbols = false;
  *figure = (QnFigure){ .model = &run->model,
                        .contacts = &run->contacts,
                        .result = &run->result,
                        .options = options };
}

static void
write_to (Dialog *dialog, const char *path)
{
  if (dialog->state->document->run == NULL)
    return;
  g_free (dialog->path);
  dialog->path = g_strdup (path);
  dialog->cancellable = g_cancellable_new ();
  dialog->run = qn_run_ref (dialog->state->document->run);
  dialog->done = 0;
  choose_figure (dialog);
  qn_document_get_metadata (dialog->state->document, &dialog->metadata);
  dialog->metadata.model = dialog->model = g_strdup (dialog->metadata.model);
  dialog->metadata.model_sha256 = dialog->sha256 =
    g_strdup (dialog->metadata.model_sha256);
  say (dialog, NULL);
  on_tick (dialog);
  dialog->timeout = g_timeout_add (TICK_MS, on_tick, dialog);
  g_object_ref (dialog->parent);
  g_autoptr (GTask) task =
    g_task_new (NULL, dialog->cancellable, on_written, g_rc_box_acquire (dialog));
  g_task_set_check_cancellable (task, FALSE);
  g_task_set_task_data (task, dialog, NULL);
  g_task_run_in_thread (task, write_in_thread);
}

/* Numbered pictures go into a folder. */
static gboolean
use_chosen (gpointer data, const char *path, GError **error)
{
  Dialog *dialog = data;
  g_autofree char *whole =
    g_strconcat (path, dialog->format == FORMAT_PICTURES ? G_DIR_SEPARATOR_S : "", NULL);
  write_to (dialog, whole);
  return TRUE;
}

/* ---- fields ---- */

/* WebM is offered where it can be written. */
static gboolean
has_webm (void)
{
  return qn_animation_check_path ("x.webm", NULL);
}

static const QnResult *
result_of (const Dialog *dialog)
{
  const QnRun *run = dialog->state->document->run;
  return run != NULL ? &run->result : NULL;
}

/* Whether the current run has what is to move. */
static gboolean
is_there (const Dialog *dialog)
{
  const QnRun *run = dialog->state->document->run;
  if (run == NULL)
    return FALSE;
  return dialog->animation.figure.options.view == QN_VIEW_MECHANISM
           ? run->result.mechanism != NULL
           : run->result.step_count > 0;
}

static char *
dup_facts (const Dialog *dialog)
{
  const QnAnimation *a = &dialog->animation;
  const gboolean mechanism = a->figure.options.view == QN_VIEW_MECHANISM;
  if (dialog->message != NULL)
    return g_strdup (dialog->message);
  if (!is_there (dialog))
    return g_strdup (mechanism ? _ ("This run has no mechanism.")
                               : _ ("This run has no steps."));
  return g_strdup_printf (_ ("%d pictures of %d × %d px, %.1f s"), a->frames,
                          (int) dialog->output.width, (int) dialog->output.height,
                          a->frames / a->rate);
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Dialog *dialog = (const Dialog *) data;
  const QnAnimation *a = &dialog->animation;
  const char *const formats[] = { _ ("GIF"), _ ("Numbered pictures (PNG)"), NULL };
  const char *const with_webm[] = { _ ("GIF"), _ ("WebM"), _ ("Numbered pictures (PNG)"),
                                    NULL };
  gboolean mechanism = a->figure.options.view == QN_VIEW_MECHANISM;
  gboolean busy = dialog->cancellable != NULL;
  switch (field) {
  case WHAT:
    value->number = mechanism ? 0 : 1;
    return TRUE;
  case FORMAT:
    value->rows = g_strdupv ((char **) (has_webm () ? with_webm : formats));
    value->number = has_webm () ? dialog->format : dialog->format / 2;
    return TRUE;
  case RATE:
    value->number = a->rate;
    return TRUE;
  case SPEED:
    value->number = qn_animation_speed_of (result_of (dialog), a->rate, a->frames);
    return !mechanism && value->number > 0;
  case WIDTH:
  case HEIGHT:
  case FRAMES:
  case SCALE:
  case MONOCHROME:
    return TRUE;
  case ONCE:
    return mechanism;
  case CURVE:
    return !mechanism;
  case BOX:
    value->disabled = busy;
    return TRUE;
  case FACTS:
    value->text = dup_facts (dialog);
    return TRUE;
  case EXPORT:
    value->disabled = !is_there (dialog);
    return !busy;
  default:
    return busy;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Dialog *dialog = (Dialog *) data;
  QnAnimation *a = &dialog->animation;
  if (field == CANCEL)
    g_cancellable_cancel (dialog->cancellable);
  else if (field == EXPORT) {
    static const char *const endings[][3] = { { ".gif", ".webm" }, { ".webm", ".gif" } };
    static const char *const names[] = { N_ ("collapse.gif"), N_ ("collapse.webm") };
    const gboolean folder = dialog->format == FORMAT_PICTURES;
    const QnFileQuestion question = { .title = folder ? _ ("Folder for the Pictures")
                                                      : _ ("Export Animation"),
                                      .accept = _ ("_Export"),
                                      .name = folder ? NULL : _ (names[dialog->format]),
                                      .endings = folder ? NULL : endings[dialog->format],
                                      .use = use_chosen,
                                      .failed = say,
                                      .folder = folder };
    qn_chooser_ask (dialog->base.root, &question, dialog);
  } else if (field == WHAT)
    a->figure.options.view = value->number != 0.0 ? QN_VIEW_DEFORMED : QN_VIEW_MECHANISM;
  else if (field == WIDTH || field == HEIGHT) /* whole pixels */
    *(field == WIDTH ? &dialog->output.width : &dialog->output.height) =
      qn_value_int (value);
  else if (field == FORMAT)
    dialog->format = (int) value->number * (has_webm () ? 1 : 2);
  else if (field == RATE || field == SPEED) {
    const QnResult *result = result_of (dialog);
    double speed =
      field == SPEED ? value->number : qn_animation_speed_of (result, a->rate, a->frames);
    if (field == RATE)
      a->rate = value->number;
    double frames = speed > 0 ? qn_animation_frames_at (result, a->rate, speed) : 0;
    if (frames > 0)
      a->frames = (int) qn_to_integer (frames, 2, QN_MAX_FRAMES);
  }
  g_clear_pointer (&dialog->message, g_free);
  return TRUE;
}

/* What the window shows, 800 x 600 px, 48 frames in 2 s; analyses in time second for second. */
static void
init (Dialog *dialog, QnViewState *state)
{
  const QnViewOptions shown = qn_view_state_get_options (state);
  const QnRun *run = state->document->run;
  const gboolean moves = run != NULL && run->result.mechanism != NULL;
  const gboolean path =
    shown.view == QN_VIEW_DEFORMED && run != NULL && run->result.step_count > 1;
  QnAnimation *a = &dialog->animation;
  qn_animation_init (a, NULL, NULL, NULL,
                     moves && !path ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED);
  a->figure.options.scale = shown.scale;
  a->figure.options.monochrome = shown.monochrome;
  a->progress = on_frame;
  a->user_data = dialog;
  qn_output_init (&dialog->output);
  dialog->output.width = 800;
  dialog->output.height = 600;
  double frames = run != NULL ? qn_animation_frames_at (&run->result, a->rate, 1) : 0;
  if (frames > 0)
    a->frames = (int) qn_to_integer (frames, 2, QN_MAX_FRAMES);
}

void
qn_animation_dialog_show (GtkWindow *parent, QnViewState *state, QnTellFunc tell,
                          const char *path)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("animation-dialog", Dialog, .clear = clear);
  Dialog *dialog = qn_form_new (&kind, NULL);
  GtkWidget *root = dialog->base.root;
  dialog->parent = parent;
  dialog->state = state;
  dialog->tell = tell;
  init (dialog, state);
  g_signal_connect_swapped (root, "destroy", G_CALLBACK (on_destroy), dialog);
  qn_dialog_present (qn_form_show (dialog), parent, "export",
                     dialog->base.widgets[EXPORT]);
  if (path != NULL)
    write_to (dialog, path);
}
