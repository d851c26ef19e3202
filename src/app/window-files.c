#include "app/window-private.h"

#include "doc/picture.h"
#include <glib/gi18n.h>

static void save_as (QnWindow *self, GVariant *parameter);

static GtkFileFilter *
project_filter (void)
{
  GtkFileFilter *filter = gtk_file_filter_new ();
  gtk_file_filter_set_name (filter, _ ("Quoin projects"));
  gtk_file_filter_add_pattern (filter, "*.quoin");
  return filter;
}

static GtkFileChooserNative *
begin_chooser (QnWindow *self, const char *title, GtkFileChooserAction action,
               const char *accept, GCallback response)
{
  GtkFileChooserNative *chooser =
    gtk_file_chooser_native_new (title, GTK_WINDOW (self), action, accept, NULL);
  g_autoptr (GtkFileFilter) filter = project_filter ();
  gtk_file_chooser_add_filter (GTK_FILE_CHOOSER (chooser), filter);
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
  g_signal_connect (chooser, "response", response, self);
  g_set_object (&self->chooser, G_OBJECT (chooser));
  g_object_unref (chooser);
  return chooser;
}

/* ---- opening ---- */

/* Files open in this window while it is blank, in a new one otherwise. */
static void
open_path (QnWindow *self, GVariant *parameter)
{
  const char *path = g_variant_get_string (parameter, NULL);
  QnWindow *target = self;
  if (!qn_window_is_blank (self)) {
    target = qn_window_new (gtk_window_get_application (GTK_WINDOW (self)));
    gtk_window_present (GTK_WINDOW (target));
  }
  qn_window_open_path (target, path);
}

static void
on_open_response (GtkNativeDialog *dialog, int response, QnWindow *self)
{
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (dialog));
    g_autofree char *path = g_file_get_path (file);
    if (path != NULL)
      gtk_widget_activate_action (GTK_WIDGET (self), "win.open-path", "s", path);
    else
      qn_window_show_error (self, _ ("Only local files can be opened"));
  }
  g_clear_object (&self->chooser);
}

static void
open_dialog (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  GtkFileChooserNative *chooser =
    begin_chooser (self, _ ("Open"), GTK_FILE_CHOOSER_ACTION_OPEN, _ ("_Open"),
                   G_CALLBACK (on_open_response));
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

void
qn_window_remember_recent (const char *path)
{
  g_autofree char *uri = g_filename_to_uri (path, NULL, NULL);
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
  self->closing = TRUE;
  g_idle_add_full (G_PRIORITY_DEFAULT_IDLE, on_close_idle, g_object_ref (self),
                   g_object_unref);
}

/* ---- saving ---- */

static gboolean
save_to (QnWindow *self, const char *path)
{
  g_autoptr (GError) error = NULL;
  if (qn_document_carry_picture (self->document, path, &error)
      && qn_document_save (self->document, path, &error)) {
    qn_window_remember_recent (path);
    return TRUE;
  }
  self->closing = FALSE;
  qn_window_show_error (self, error->message);
  return FALSE;
}

static void
on_save_response (GtkNativeDialog *dialog, int response, QnWindow *self)
{
  gboolean close_after = self->closing;
  self->closing = FALSE;
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (dialog));
    g_autofree char *path = g_file_get_path (file);
    if (path == NULL)
      qn_window_show_error (self, _ ("Only local files can be written"));
    else if (save_to (self, path) && close_after)
      close_soon (self);
  }
  g_clear_object (&self->chooser);
}

static void
save_as (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  GtkFileChooserNative *chooser =
    begin_chooser (self, _ ("Save As"), GTK_FILE_CHOOSER_ACTION_SAVE, _ ("_Save"),
                   G_CALLBACK (on_save_response));
  const char *path = qn_document_get_path (self->document);
  if (path != NULL) {
    g_autoptr (GFile) file = g_file_new_for_path (path);
    gtk_file_chooser_set_file (GTK_FILE_CHOOSER (chooser), file, NULL);
  } else
    gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), _ ("untitled.quoin"));
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

static void
save (QnWindow *self, GVariant *parameter)
{
  const char *path = qn_document_get_path (self->document);
  if (path == NULL) {
    save_as (self, parameter);
    return;
  }
  g_autofree char *copy = g_strdup (path);
  save_to (self, copy);
}

/* For tests and scripts: saves to a given path without asking. */
static void
save_to_path (QnWindow *self, GVariant *parameter)
{
  save_to (self, g_variant_get_string (parameter, NULL));
}

/* ---- closing ---- */

static void
on_unsaved_response (GtkDialog *dialog, int response, QnWindow *self)
{
  gtk_window_destroy (GTK_WINDOW (dialog));
  if (response == GTK_RESPONSE_REJECT)
    close_soon (self);
  else if (response == GTK_RESPONSE_ACCEPT) {
    const char *path = qn_document_get_path (self->document);
    self->closing = TRUE;
    if (path == NULL)
      save_as (self, NULL);
    else {
      g_autofree char *copy = g_strdup (path);
      if (save_to (self, copy))
        close_soon (self);
    }
  }
}

gboolean
qn_window_may_close (QnWindow *self)
{
  if (self->closing || qn_window_is_blank (self)
      || !qn_document_is_modified (self->document))
    return TRUE;
  g_autofree char *name = qn_document_dup_display_name (self->document);
  GtkWidget *dialog = gtk_message_dialog_new (
    GTK_WINDOW (self), GTK_DIALOG_MODAL | GTK_DIALOG_DESTROY_WITH_PARENT,
    GTK_MESSAGE_QUESTION, GTK_BUTTONS_NONE, _ ("Save changes to “%s”?"), name);
  gtk_message_dialog_format_secondary_text (GTK_MESSAGE_DIALOG (dialog), "%s",
                                            _ ("What is not saved will be lost."));
  gtk_dialog_add_buttons (GTK_DIALOG (dialog), _ ("_Discard"), GTK_RESPONSE_REJECT,
                          _ ("_Cancel"), GTK_RESPONSE_CANCEL, _ ("_Save"),
                          GTK_RESPONSE_ACCEPT, NULL);
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
  gtk_widget_add_css_class (
    gtk_dialog_get_widget_for_response (GTK_DIALOG (dialog), GTK_RESPONSE_REJECT),
    "destructive-action");
  gtk_widget_add_css_class (
    gtk_dialog_get_widget_for_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT),
    "suggested-action");
  g_signal_connect (dialog, "response", G_CALLBACK (on_unsaved_response), self);
  gtk_window_present (GTK_WINDOW (dialog));
  return FALSE;
}

static void
close_window (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  gtk_window_close (GTK_WINDOW (self));
}

/* ---- history in the file ---- */

static void
on_keep_history (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  g_simple_action_set_state (action, value);
  qn_document_set_keeps_history (self->document, g_variant_get_boolean (value));
}

static void
update_keep_history (QnWindow *self)
{
  GAction *action = g_action_map_lookup_action (G_ACTION_MAP (self), "keep-history");
  g_simple_action_set_state (
    G_SIMPLE_ACTION (action),
    g_variant_new_boolean (qn_document_get_keeps_history (self->document)));
}

static void
add_keep_history (QnWindow *self)
{
  const GActionEntry entry = { .name = "keep-history",
                               .state = "false",
                               .change_state = on_keep_history };
  g_action_map_add_action_entries (G_ACTION_MAP (self), &entry, 1, self);
  g_signal_connect_object (self->document, "history-changed",
                           G_CALLBACK (update_keep_history), self, G_CONNECT_SWAPPED);
}

void
qn_window_add_file_actions (QnWindow *self)
{
  add_keep_history (self);
  static const QnWindowAction actions[] = {
    { "open", NULL, open_dialog },
    { "open-path", "s", open_path },
    { "save", NULL, save },
    { "save-as", NULL, save_as },
    { "save-path", "s", save_to_path },
    { "close", NULL, close_window },
  };
  qn_window_add_action_table (self, actions, G_N_ELEMENTS (actions));
}
