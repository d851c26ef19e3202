/* The animation dialog: what moves, how many pictures of which size; then where to write them, and
 * how far that is. */
#include "app/dialogs/dialogs.h"

#include "app/forms/bound-form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "core/base/integer.h"
#include "doc/view/animation-job.h"
#include <glib/gi18n.h>

enum { FORMAT_GIF, FORMAT_WEBM, FORMAT_PICTURES };

typedef struct Dialog {
  QnBoundForm base;
  GtkWindow *parent;
  QnViewState *state;
  QnTellFunc tell;
  QnAnimationSettings settings;
  int format;
  GCancellable *cancellable; /* while it is written */
  char *path, *message;      /* message: NULL for the facts */
} Dialog;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (WHAT, "what", NULL)                                                             \
  FIELD (FORMAT, "format", NULL)                                                         \
  MEMBER (WIDTH, "width", NULL, Dialog, settings.width)                                  \
  MEMBER (HEIGHT, "height", NULL, Dialog, settings.height)                               \
  MEMBER (FRAMES, "frames", NULL, Dialog, settings.frames)                               \
  FIELD (RATE, "rate", NULL)                                                             \
  FIELD (SPEED, "speed", NULL)                                                           \
  MEMBER (SCALE, "scale", NULL, Dialog, settings.scale)                                  \
  MEMBER (ONCE, "once", NULL, Dialog, settings.once)                                     \
  MEMBER (CURVE, "curve", NULL, Dialog, settings.curve)                                  \
  MEMBER (MONOCHROME, "monochrome", NULL, Dialog, settings.monochrome)                   \
  FIELD (BOX, "fields", NULL)                                                            \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (PROGRESS, "progress", NULL)                                                     \
  FIELD (EXPORT, "export", NULL)                                                         \
  FIELD (CANCEL, "cancel", NULL)
QN_FORM_FIELDS;

static void
clear (gpointer data)
{
  Dialog *dialog = data;
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
  qn_bound_form_show (dialog);
}

/* ---- writing ---- */

static void
on_tick (int done, int total, gpointer data)
{
  Dialog *dialog = data;
  if (dialog->base.closed)
    return;
  GtkProgressBar *bar = GTK_PROGRESS_BAR (dialog->base.widgets[PROGRESS]);
  g_autofree char *text = g_strdup_printf (_ ("Picture %d of %d"), done, total);
  gtk_progress_bar_set_fraction (bar, (double) done / total);
  gtk_progress_bar_set_text (bar, text);
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
  if (done) {
    g_autofree char *message =
      g_strdup_printf (_ ("Animation written to %s"), dialog->path);
    dialog->tell (parent, message);
    if (!dialog->base.closed)
      gtk_window_destroy (GTK_WINDOW (dialog->base.root));
  } else if (!dialog->base.closed)
    say (dialog, cancelled ? _ ("Cancelled; nothing was written.") : error->message);
  qn_bound_form_unref (dialog);
}

static void
write_to (Dialog *dialog, const char *path)
{
  if (dialog->state->document->run == NULL)
    return;
  g_free (dialog->path);
  dialog->path = g_strdup (path);
  dialog->cancellable = g_cancellable_new ();
  say (dialog, NULL);
  on_tick (0, dialog->settings.frames, dialog);
  g_object_ref (dialog->parent);
  qn_animation_write_async (dialog->state, &dialog->settings, path, dialog->cancellable,
                            on_tick, dialog, on_written, g_rc_box_acquire (dialog));
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

static void
on_export (Dialog *dialog)
{
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
  return dialog->settings.view == QN_VIEW_MECHANISM ? run->result.mechanism != NULL
                                                    : run->result.step_count > 0;
}

static char *
dup_facts (const Dialog *dialog)
{
  const QnAnimationSettings *s = &dialog->settings;
  if (dialog->message != NULL)
    return g_strdup (dialog->message);
  if (!is_there (dialog))
    return g_strdup (s->view == QN_VIEW_MECHANISM ? _ ("This run has no mechanism.")
                                                  : _ ("This run has no steps."));
  return g_strdup_printf (_ ("%d pictures of %d × %d px, %.1f s"), s->frames, s->width,
                          s->height, s->frames / s->rate);
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Dialog *dialog = data;
  const QnAnimationSettings *s = &dialog->settings;
  const char *const formats[] = { _ ("GIF"), _ ("Numbered pictures (PNG)"), NULL };
  const char *const with_webm[] = { _ ("GIF"), _ ("WebM"), _ ("Numbered pictures (PNG)"),
                                    NULL };
  gboolean mechanism = s->view == QN_VIEW_MECHANISM;
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
    value->number = s->rate;
    return TRUE;
  case SPEED:
    value->number = qn_animation_speed_of (result_of (dialog), s->rate, s->frames);
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
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Dialog *dialog = data;
  QnAnimationSettings *s = &dialog->settings;
  if (field == CANCEL)
    g_cancellable_cancel (dialog->cancellable);
  else if (field == EXPORT)
    on_export (dialog);
  else if (field == WHAT)
    s->view = value->number != 0.0 ? QN_VIEW_DEFORMED : QN_VIEW_MECHANISM;
  else if (field == FORMAT)
    dialog->format = (int) value->number * (has_webm () ? 1 : 2);
  else if (field == RATE || field == SPEED) {
    const QnResult *result = result_of (dialog);
    double speed =
      field == SPEED ? value->number : qn_animation_speed_of (result, s->rate, s->frames);
    if (field == RATE)
      s->rate = value->number;
    double frames = speed > 0 ? qn_animation_frames_at (result, s->rate, speed) : 0;
    if (frames > 0)
      s->frames = (int) qn_to_integer (frames, 2, QN_MAX_FRAMES);
  }
  g_clear_pointer (&dialog->message, g_free);
  return TRUE;
}

void
qn_animation_dialog_show (GtkWindow *parent, QnViewState *state, QnTellFunc tell,
                          const char *path)
{
  static const QnFormKind kind = QN_FORM_KIND ("animation-dialog", Dialog);
  Dialog *dialog = qn_bound_form_new (&kind, NULL);
  GtkWidget *root = dialog->base.root;
  dialog->base.clear = clear;
  dialog->parent = parent;
  dialog->state = state;
  dialog->tell = tell;
  qn_animation_settings_init (&dialog->settings, state);
  g_signal_connect_swapped (root, "destroy", G_CALLBACK (on_destroy), dialog);
  qn_dialog_present (qn_bound_form_show (dialog), parent, "export",
                     dialog->base.widgets[EXPORT]);
  if (path != NULL)
    write_to (dialog, path);
}
