/* The animation dialog: what moves, how many pictures of which size; then where to write them, and
 * how far that is. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "core/base/integer.h"
#include "doc/view/animation-job.h"
#include <glib/gi18n.h>

#define LARGEST_SIDE 8000.0 /* px */

enum { FORMAT_GIF, FORMAT_WEBM, FORMAT_PICTURES };

typedef struct Dialog {
  GtkWindow *parent;
  QnViewState *state;
  QnTellFunc tell;
  GtkWidget *dialog; /* NULL: it has been closed */
  GtkDropDown *what, *format;
  QnQuantityEntry *width, *height, *frames, *rate, *scale;
  GtkWidget *once, *curve, *monochrome, *export, *cancel, *form;
  GtkLabel *facts;
  GtkProgressBar *progress;
  GCancellable *cancellable; /* while it is written */
  gboolean webm;
  char *path;
  GObject *chooser; /* on the screen, or NULL */
} Dialog;

static void
dialog_clear (gpointer data)
{
  Dialog *dialog = data;
  g_clear_object (&dialog->cancellable);
  g_free (dialog->path);
}

static void
dialog_unref (Dialog *dialog)
{
  g_atomic_rc_box_release_full (dialog, dialog_clear);
}

static void
on_dialog_gone (gpointer data, GObject *where)
{
  (void) where;
  Dialog *dialog = data;
  dialog->dialog = NULL;
  g_cancellable_cancel (dialog->cancellable);
  g_clear_object (&dialog->chooser);
  dialog_unref (dialog);
}

/* ---- settings ---- */

static QnAnimationSettings
take_settings (const Dialog *dialog)
{
  QnAnimationSettings s;
  qn_animation_settings_init (&s, dialog->state);
  s.view =
    gtk_drop_down_get_selected (dialog->what) == 0 ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED;
  s.width =
    (int) qn_to_integer (qn_quantity_entry_get_value (dialog->width), 0, G_MAXINT32);
  s.height =
    (int) qn_to_integer (qn_quantity_entry_get_value (dialog->height), 0, G_MAXINT32);
  s.frames =
    (int) qn_to_integer (qn_quantity_entry_get_value (dialog->frames), 0, G_MAXINT32);
  s.rate = qn_quantity_entry_get_value (dialog->rate);
  s.scale = qn_quantity_entry_get_value (dialog->scale);
  s.once = gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->once));
  s.curve = gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->curve));
  s.monochrome = gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->monochrome));
  return s;
}

static int
format_of (const Dialog *dialog)
{
  int row = (int) gtk_drop_down_get_selected (dialog->format);
  return !dialog->webm && row >= FORMAT_WEBM ? row + 1 : row;
}

/* What can be said before anything is drawn, and which rows concern what moves. */
static void
update (Dialog *dialog)
{
  const QnRun *run = qn_document_get_run (qn_view_state_get_document (dialog->state));
  QnAnimationSettings s = take_settings (dialog);
  gboolean mechanism = s.view == QN_VIEW_MECHANISM;
  gboolean there =
    run != NULL
    && (mechanism ? run->result.mechanism != NULL : run->result.step_count > 0);
  gtk_widget_set_visible (dialog->once, mechanism);
  gtk_widget_set_visible (dialog->curve, !mechanism);
  gtk_widget_set_sensitive (dialog->export, there && dialog->cancellable == NULL);
  g_autofree char *facts =
    !there ? g_strdup (mechanism ? _ ("This run has no mechanism.")
                                 : _ ("This run has no steps."))
           : g_strdup_printf (_ ("%d pictures of %d × %d px, %.1f s"), s.frames, s.width,
                              s.height, s.frames / s.rate);
  gtk_label_set_text (dialog->facts, facts);
}

static void
on_quantity (QnQuantityEntry *entry, Dialog *dialog)
{
  (void) entry;
  update (dialog);
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Dialog *dialog)
{
  (void) choice;
  (void) pspec;
  update (dialog);
}

static void
on_check (GtkCheckButton *check, Dialog *dialog)
{
  (void) check;
  update (dialog);
}

/* ---- writing ---- */

static void
show_busy (Dialog *dialog, gboolean busy)
{
  gtk_widget_set_sensitive (dialog->form, !busy);
  gtk_widget_set_visible (GTK_WIDGET (dialog->progress), busy);
  gtk_widget_set_visible (dialog->cancel, busy);
  gtk_widget_set_visible (dialog->export, !busy);
  update (dialog);
}

static void
on_tick (int done, int total, gpointer data)
{
  Dialog *dialog = data;
  if (dialog->dialog == NULL)
    return;
  g_autofree char *text = g_strdup_printf (_ ("Picture %d of %d"), done, total);
  gtk_progress_bar_set_fraction (dialog->progress, (double) done / total);
  gtk_progress_bar_set_text (dialog->progress, text);
}

static void
on_written (GObject *source, GAsyncResult *result, gpointer data)
{
  Dialog *dialog = data;
  GtkWindow *parent = dialog->parent;
  g_autoptr (GError) error = NULL;
  gboolean done = qn_animation_write_finish (QN_VIEW_STATE (source), result, &error);
  gboolean cancelled = g_cancellable_is_cancelled (dialog->cancellable);
  g_clear_object (&dialog->cancellable);
  if (done) {
    g_autofree char *message =
      g_strdup_printf (_ ("Animation written to %s"), dialog->path);
    dialog->tell (parent, message, FALSE);
    if (dialog->dialog != NULL)
      gtk_window_destroy (GTK_WINDOW (dialog->dialog));
  } else if (dialog->dialog != NULL) {
    show_busy (dialog, FALSE);
    gtk_label_set_text (dialog->facts, cancelled ? _ ("Cancelled; nothing was written.")
                                                 : error->message);
  } else if (!cancelled)
    dialog->tell (parent, error->message, TRUE);
  g_object_unref (parent);
  dialog_unref (dialog);
}

static void
write_to (Dialog *dialog, const char *path)
{
  QnAnimationSettings settings = take_settings (dialog);
  if (qn_document_get_run (qn_view_state_get_document (dialog->state)) == NULL)
    return;
  g_free (dialog->path);
  dialog->path = g_strdup (path);
  dialog->cancellable = g_cancellable_new ();
  show_busy (dialog, TRUE);
  on_tick (0, settings.frames, dialog);
  g_object_ref (dialog->parent);
  qn_animation_write_async (dialog->state, &settings, path, dialog->cancellable, on_tick,
                            dialog, on_written, g_atomic_rc_box_acquire (dialog));
}

/* Numbered pictures go into a folder. */
static char *
dup_chosen_path (Dialog *dialog, GtkNativeDialog *chooser, GError **error)
{
  static const char *const endings[][3] = { { ".gif", ".webm" }, { ".webm", ".gif" } };
  if (format_of (dialog) != FORMAT_PICTURES)
    return qn_dialog_dup_chosen_path (chooser, endings[format_of (dialog)], error);
  const char *const any[] = { "", NULL };
  g_autofree char *folder = qn_dialog_dup_chosen_path (chooser, any, error);
  return folder != NULL ? g_strconcat (folder, G_DIR_SEPARATOR_S, NULL) : NULL;
}

static void
on_response (GtkNativeDialog *chooser, int response, Dialog *dialog)
{
  if (response == GTK_RESPONSE_ACCEPT && dialog->dialog != NULL) {
    g_autoptr (GError) error = NULL;
    g_autofree char *path = dup_chosen_path (dialog, chooser, &error);
    if (path != NULL)
      write_to (dialog, path);
    else
      gtk_label_set_text (dialog->facts, error->message);
  }
  g_clear_object (&dialog->chooser);
}

static void
on_export (Dialog *dialog)
{
  static const char *const names[] = { N_ ("collapse.gif"), N_ ("collapse.webm") };
  int format = format_of (dialog);
  gboolean folder = format == FORMAT_PICTURES;
  GtkFileChooserNative *chooser = qn_chooser_begin (
    GTK_WINDOW (dialog->dialog), &dialog->chooser,
    folder ? GTK_FILE_CHOOSER_ACTION_SELECT_FOLDER : GTK_FILE_CHOOSER_ACTION_SAVE,
    folder ? _ ("Folder for the Pictures") : _ ("Export Animation"), _ ("_Export"));
  if (!folder)
    gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), _ (names[format]));
  g_signal_connect_data (chooser, "response", G_CALLBACK (on_response),
                         g_atomic_rc_box_acquire (dialog),
                         (GClosureNotify) (gpointer) dialog_unref, 0);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

static void
on_cancel (Dialog *dialog)
{
  g_cancellable_cancel (dialog->cancellable);
}

/* ---- building ---- */

static GtkWidget *
add_check (Dialog *dialog, const char *label, gboolean active)
{
  return qn_form_add_check (dialog->form, label, active, G_CALLBACK (on_check), dialog);
}

static void
build_form (Dialog *dialog)
{
  const char *const whats[] = { _ ("Mechanism"), _ ("Path, step by step"), NULL };
  const char *formats[] = { _ ("GIF"), _ ("WebM"), _ ("Numbered pictures (PNG)"), NULL };
  GCallback chosen = G_CALLBACK (on_choice), changed = G_CALLBACK (on_quantity);
  QnAnimationSettings s;
  qn_animation_settings_init (&s, dialog->state);
  dialog->webm = qn_animation_check_path ("x.webm", NULL);
  if (!dialog->webm) {
    formats[FORMAT_WEBM] = formats[FORMAT_PICTURES];
    formats[FORMAT_PICTURES] = NULL;
  }
  GtkWidget *form = dialog->form = qn_form_new ();
  dialog->what = qn_form_add_choice (form, _ ("_Moves"), whats, chosen, dialog);
  dialog->format = qn_form_add_choice (form, _ ("_Format"), formats, chosen, dialog);
  dialog->width = qn_form_add_quantity (form, _ ("_Width (px)"), QN_QUANTITY_NUMBER, 16.0,
                                        LARGEST_SIDE, changed, dialog);
  dialog->height = qn_form_add_quantity (form, _ ("_Height (px)"), QN_QUANTITY_NUMBER,
                                         16.0, LARGEST_SIDE, changed, dialog);
  dialog->frames = qn_form_add_quantity (form, _ ("_Pictures"), QN_QUANTITY_NUMBER, 2.0,
                                         QN_MAX_FRAMES, changed, dialog);
  dialog->rate = qn_form_add_quantity (form, _ ("Pictures per _second"),
                                       QN_QUANTITY_NUMBER, 1.0, 60.0, changed, dialog);
  dialog->scale = qn_form_add_quantity (form, _ ("S_cale (0: fitting)"),
                                        QN_QUANTITY_NUMBER, 0.0, 1e9, changed, dialog);
  dialog->once = add_check (dialog, _ ("_Once, not back and forth"), s.once);
  dialog->curve = add_check (dialog, _ ("With the c_urve"), s.curve);
  dialog->monochrome = add_check (dialog, _ ("_Black and white"), s.monochrome);
  qn_form_set_choice (dialog->what, s.view == QN_VIEW_MECHANISM ? 0 : 1, dialog);
  qn_quantity_entry_set_value (dialog->width, s.width);
  qn_quantity_entry_set_value (dialog->height, s.height);
  qn_quantity_entry_set_value (dialog->frames, s.frames);
  qn_quantity_entry_set_value (dialog->rate, s.rate);
  qn_quantity_entry_set_value (dialog->scale, s.scale);
}

static GtkWidget *
build_header (Dialog *dialog)
{
  GtkWidget *header = gtk_header_bar_new ();
  dialog->export = gtk_button_new_with_mnemonic (_ ("_Export…"));
  gtk_widget_add_css_class (dialog->export, "suggested-action");
  g_signal_connect_swapped (dialog->export, "clicked", G_CALLBACK (on_export), dialog);
  dialog->cancel = gtk_button_new_with_mnemonic (_ ("_Cancel"));
  gtk_widget_add_css_class (dialog->cancel, "destructive-action");
  g_signal_connect_swapped (dialog->cancel, "clicked", G_CALLBACK (on_cancel), dialog);
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), dialog->export);
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), dialog->cancel);
  return header;
}

/* Facts and progress below the form. */
static GtkWidget *
build_foot (Dialog *dialog)
{
  GtkWidget *foot = qn_form_new ();
  dialog->facts = qn_form_add_text (foot);
  /* Otherwise room is kept for it in a column of single letters. */
  gtk_label_set_width_chars (dialog->facts, 30);
  dialog->progress = GTK_PROGRESS_BAR (gtk_progress_bar_new ());
  gtk_progress_bar_set_show_text (dialog->progress, TRUE);
  gtk_widget_set_hexpand (GTK_WIDGET (dialog->progress), TRUE);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog->progress),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Progress"), -1);
  qn_form_add_wide (foot, GTK_WIDGET (dialog->progress));
  return foot;
}

void
qn_animation_dialog_show (GtkWindow *parent, QnViewState *state, QnTellFunc tell,
                          const char *path)
{
  Dialog *dialog = g_atomic_rc_box_new0 (Dialog);
  dialog->parent = parent;
  dialog->state = state;
  dialog->tell = tell;
  dialog->dialog = qn_dialog_new (parent, _ ("Export Animation"), 420, -1);
  gtk_window_set_titlebar (GTK_WINDOW (dialog->dialog), build_header (dialog));
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  build_form (dialog);
  gtk_box_append (GTK_BOX (box), dialog->form);
  gtk_box_append (GTK_BOX (box), build_foot (dialog));
  gtk_window_set_child (GTK_WINDOW (dialog->dialog), box);
  g_object_weak_ref (G_OBJECT (box), on_dialog_gone, dialog);
  show_busy (dialog, FALSE);
  gtk_window_present (GTK_WINDOW (dialog->dialog));
  if (path != NULL)
    write_to (dialog, path);
}
