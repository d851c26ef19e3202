#include "app/window/window-private.h"

#include "app/widgets/dialog.h"
#include "doc/view/figures.h"
#include <glib/gi18n.h>

/* ---- opening ---- */

static const QnFileKind kinds[] = {
  { "open",
    N_ ("Open"),
    N_ ("_Open"),
    N_ ("Quoin projects"),
    { "quoin" },
    "win.open-path" },
  { "import",
    N_ ("Import Drawing"),
    N_ ("_Import"),
    N_ ("Drawings: DXF, SVG, COMPAS, HybriDFEM"),
    { "dxf", "svg", "svgz", "json", "txt" },
    "win.take-path" },
  { "picture",
    N_ ("Picture behind the Drawing"),
    N_ ("_Open"),
    N_ ("Pictures"),
    { "png", "jpg", "jpeg", "tif", "bmp", "tiff", "webp" },
    "win.take-path" },
  { "open-result",
    N_ ("Open Result"),
    N_ ("_Open"),
    N_ ("Result files"),
    { "json" },
    "win.open-result-path" },
};

static gboolean
use_chosen (gpointer data, const char *path, GError **error)
{
  QnWindow *self = data;
  return gtk_widget_activate_action (data, self->chosen_kind->action, "s", path);
}

void
qn_window_choose_file (QnWindow *self, const char *name)
{
  const QnFileKind *kind = kinds;
  while (!g_str_equal (kind->asked, name))
    kind++;
  const QnFileQuestion question = { .title = _ (kind->title),
                                    .accept = _ (kind->accept),
                                    .use = use_chosen,
                                    .failed = qn_window_show_error,
                                    .kind = kind };
  self->chosen_kind = kind;
  qn_chooser_ask (GTK_WIDGET (self), &question, self);
}

QnWindow *
qn_window_find_path (GtkApplication *application, const char *path)
{
  g_autofree char *absolute = g_canonicalize_filename (path, NULL);
  for (GList *l = gtk_application_get_windows (application); l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data)
        && g_strcmp0 (QN_WINDOW (l->data)->document->path, absolute) == 0)
      return l->data;
  return NULL;
}

void
qn_window_open_with (QnWindow *self, const char *path,
                     gboolean (*open) (QnWindow *, const char *))
{
  if (qn_window_is_blank (self)) {
    open (self, path);
    gtk_window_present (GTK_WINDOW (self));
    return;
  }
  QnWindow *opened = qn_window_new (gtk_window_get_application (GTK_WINDOW (self)));
  if (open (opened, path))
    return;
  qn_window_show_error (self, gtk_label_get_text (opened->info_label));
  gtk_window_destroy (GTK_WINDOW (opened));
}

void
qn_window_open (QnWindow *self, const char *path)
{
  QnWindow *shown =
    qn_window_find_path (gtk_window_get_application (GTK_WINDOW (self)), path);
  if (shown != NULL)
    gtk_window_present (GTK_WINDOW (shown));
  else
    qn_window_open_with (self, path, qn_window_open_path);
}

/* An example opens as a drawing of its own, which is saved elsewhere. */
static void
open_example (QnWindow *self, const char *path)
{
  qn_window_open_with (self, path, qn_window_open_copy);
}

void
qn_window_remember_recent (const char *path)
{
  g_autofree char *uri = g_filename_to_uri (path, NULL, NULL);
  qn_chooser_begin_beside (path);
  if (uri == NULL)
    return;
  GtkRecentData data = { .mime_type = (char *) "application/x-quoin",
                         .app_name = (char *) "Quoin",
                         .app_exec = (char *) "quoin %u" };
  gtk_recent_manager_add_full (gtk_recent_manager_get_default (), uri, &data);
}

/* Dialogs must be gone before the window that they stand over. */
static gboolean
on_close_idle (gpointer data)
{
  gtk_window_close (GTK_WINDOW (data));
  return G_SOURCE_REMOVE;
}

static void
close_soon (QnWindow *self)
{
  self->closing = QN_CLOSING_NOW;
  g_idle_add_full (G_PRIORITY_DEFAULT_IDLE, on_close_idle, g_object_ref (self),
                   g_object_unref);
}

/* One window that stays keeps those that were to close after it. */
static void
stop_closing (gpointer data)
{
  QnWindow *self = data;
  self->closing = QN_CLOSING_NOT;
  g_clear_pointer (&self->after_save, g_free);
  for (GList *l =
         gtk_application_get_windows (gtk_window_get_application (GTK_WINDOW (self)));
       l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data) && QN_WINDOW (l->data)->closing == QN_CLOSING_LATER)
      QN_WINDOW (l->data)->closing = QN_CLOSING_NOT;
}

/* ---- saving ---- */

static gboolean
save_to (QnWindow *self, const char *path)
{
  g_autoptr (GError) error = NULL;
  if (qn_document_carry_files (self->document, path, &error)
      && qn_document_save (self->document, path, &error)) {
    qn_window_remember_recent (path);
    g_autofree char *action = g_steal_pointer (&self->after_save), *name = NULL;
    g_autoptr (GVariant) parameter = NULL;
    if (action != NULL && g_action_parse_detailed_name (action, &name, &parameter, NULL))
      g_action_group_activate_action (G_ACTION_GROUP (self), name, parameter);
    return TRUE;
  }
  stop_closing (self);
  qn_window_show_error (self, error->message);
  return FALSE;
}

static gboolean
use_saved (gpointer data, const char *path, GError **error)
{
  QnWindow *self = data;
  const gboolean closes = self->closing == QN_CLOSING_NOW;
  if (save_to (self, path) && closes)
    close_soon (self);
  else
    stop_closing (self);
  return TRUE;
}

static void
save_as (QnWindow *self, const char *name)
{
  static const char *const endings[] = { ".quoin", ".json", NULL };
  qn_window_commit_entry (self);
  const QnFileQuestion question = { .title = _ ("Save As"),
                                    .accept = _ ("_Save"),
                                    .name = _ ("untitled.quoin"),
                                    .endings = endings,
                                    .use = use_saved,
                                    .failed = qn_window_show_error,
                                    .left = stop_closing,
                                    .kind = &kinds[0],
                                    .path = self->document->path };
  qn_chooser_ask (GTK_WIDGET (self), &question, self);
}

/* Over the file that it came from, and closes then where that is wanted. */
static void
save_over (QnWindow *self)
{
  g_autofree char *path = g_strdup (self->document->path);
  if (save_to (self, path) && self->closing == QN_CLOSING_NOW)
    close_soon (self);
}

/* ---- questions ---- */

static void
on_changed_answer (QnAnswer answer, gpointer data)
{
  QnWindow *self = data;
  if (answer == QN_ANSWER_REJECT)
    save_over (self);
  else if (answer == QN_ANSWER_ACCEPT)
    save_as (self, NULL);
  else
    stop_closing (self);
}

static void
save (QnWindow *self, const char *action)
{
  qn_window_commit_entry (self);
  if (self->document->path == NULL)
    save_as (self, action);
  else if (qn_document_is_changed_elsewhere (self->document)) {
    /* What somebody else has written since must not be lost without a word. */
    g_autofree char *name = g_path_get_basename (self->document->path);
    g_autofree char *question =
      g_strdup_printf (_ ("“%s” has changed since it was opened here"), name);
    qn_dialog_ask (
      GTK_WINDOW (self), question,
      _ (
        "Another window or program has written the file. Saving replaces what it wrote."),
      _ ("_Overwrite"), _ ("Save _As…"), NULL, on_changed_answer, self);
  } else
    save_over (self);
}

/* For tests and scripts: saves to a given path without asking. */
static void
save_to_path (QnWindow *self, const char *path)
{
  save_to (self, path);
}

/* ---- closing ---- */

static void
on_unsaved_answer (QnAnswer answer, gpointer data)
{
  QnWindow *self = data;
  if (answer == QN_ANSWER_REJECT)
    close_soon (self);
  else if (answer == QN_ANSWER_ACCEPT) {
    self->closing = QN_CLOSING_NOW;
    save (self, NULL);
  }
}

static gboolean
has_unsaved (QnWindow *self)
{
  return !qn_window_is_blank (self) && qn_document_is_modified (self->document);
}

static void
ask_one (QnWindow *self, QnAnswered answered)
{
  g_autofree char *name = qn_document_dup_display_name (self->document);
  g_autofree char *question = g_strdup_printf (_ ("Save changes to “%s”?"), name);
  qn_dialog_ask (GTK_WINDOW (self), question, _ ("Unsaved changes will be lost."),
                 _ ("_Discard"), _ ("_Save"), NULL, answered, self);
}

gboolean
qn_window_may_close (QnWindow *self)
{
  if (self->closing == QN_CLOSING_NOW || !has_unsaved (self))
    return TRUE;
  ask_one (self, on_unsaved_answer);
  return FALSE;
}

/* ---- quitting ---- */

#define CHECK "qn-check" /* of a window in the list, while that is on the screen */

void
qn_window_save_next (GtkApplication *application)
{
  for (GList *l = gtk_application_get_windows (application); l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data) && QN_WINDOW (l->data)->closing == QN_CLOSING_LATER) {
      QnWindow *self = l->data;
      self->closing = QN_CLOSING_NOW;
      gtk_window_present (GTK_WINDOW (self));
      save (self, NULL);
      return;
    }
}

/* Windows that are to be saved close one after another, for each may ask where; the others do at once. */
static void
on_quit_answer (QnAnswer answer, gpointer self)
{
  GtkApplication *application = gtk_window_get_application (GTK_WINDOW (self));
  for (GList *l = gtk_application_get_windows (application); l != NULL; l = l->next) {
    if (!QN_IS_WINDOW (l->data))
      continue;
    QnWindow *each = l->data;
    GtkCheckButton *check = g_object_get_data (G_OBJECT (each), CHECK);
    gboolean wanted = check == NULL || gtk_check_button_get_active (check);
    g_object_set_data (G_OBJECT (each), CHECK, NULL);
    if (answer == QN_ANSWER_ACCEPT && has_unsaved (each) && wanted)
      each->closing = QN_CLOSING_LATER;
    else if (answer != QN_ANSWER_CANCEL)
      close_soon (each);
  }
  qn_window_save_next (application);
}

static void
ask_all (const GPtrArray *unsaved)
{
  QnWindow *self = g_ptr_array_index (unsaved, 0);
  g_autofree char *question =
    g_strdup_printf (ngettext ("Save changes to %u drawing?",
                               "Save changes to %u drawings?", unsaved->len),
                     unsaved->len);
  GtkWidget *list = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  for (guint i = 0; i < unsaved->len; i++) {
    QnWindow *each = g_ptr_array_index (unsaved, i);
    g_autofree char *name = qn_document_dup_display_name (each->document);
    GtkWidget *check = gtk_check_button_new_with_label (name);
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check), TRUE);
    gtk_widget_set_tooltip_text (check, each->document->path);
    gtk_box_append (GTK_BOX (list), check);
    g_object_set_data_full (G_OBJECT (each), CHECK, g_object_ref (check), g_object_unref);
  }
  GtkWidget *scroller = gtk_scrolled_window_new ();
  g_object_set (scroller, "hscrollbar-policy", GTK_POLICY_NEVER, "max-content-height",
                300, "propagate-natural-height", TRUE, "child", list, NULL);
  qn_dialog_ask (GTK_WINDOW (self), question,
                 _ ("Changes to those not ticked will be lost."), _ ("_Discard All"),
                 _ ("_Save"), scroller, on_quit_answer, self);
}

void
qn_window_quit (GtkApplication *application)
{
  GList *windows = gtk_application_get_windows (application);
  g_autoptr (GPtrArray) unsaved = g_ptr_array_new ();
  for (GList *l = windows; l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data)) {
      qn_window_commit_entry (l->data);
      if (has_unsaved (l->data))
        g_ptr_array_add (unsaved, l->data);
    }
  if (unsaved->len == 1)
    ask_one (g_ptr_array_index (unsaved, 0), on_quit_answer);
  else if (unsaved->len > 1)
    ask_all (unsaved);
  else
    for (GList *l = windows; l != NULL; l = l->next)
      if (QN_IS_WINDOW (l->data))
        close_soon (l->data);
}

static void
close_window (QnWindow *self, const char *name)
{
  GtkWidget *apart = self->page_window;
  gboolean page = apart != NULL && gtk_window_is_active (GTK_WINDOW (apart));
  gtk_window_close (page ? GTK_WINDOW (apart) : GTK_WINDOW (self));
}

const QnWindowAction qn_window_file_actions[] = {
  { "open", NULL, { qn_window_choose_file }, 0 },
  { "open-path", "s", { qn_window_open }, 0 },
  { "open-example", "s", { open_example }, 0 },
  { "save", NULL, { save }, QN_NEEDS_WORK },
  { "save-as", NULL, { save_as }, QN_NEEDS_WORK },
  { "save-path", "s", { save_to_path }, 0 },
  { "close", NULL, { close_window }, 0 },
  { .name = NULL },
};
