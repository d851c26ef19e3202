#include "app/window/window-chooser.h"

#include "app/window/window-private.h"
#include <glib/gi18n.h>

GtkFileChooserNative *
qn_chooser_begin (GtkWindow *parent, GObject **kept, GtkFileChooserAction action,
                  const char *title, const char *accept)
{
  GtkFileChooserNative *chooser =
    gtk_file_chooser_native_new (title, parent, action, accept, NULL);
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
  g_set_object (kept, G_OBJECT (chooser));
  g_object_unref (chooser);
  return chooser;
}

void
qn_chooser_add_kind (GtkFileChooserNative *chooser, const QnFileKind *kind)
{
  g_autoptr (GtkFileFilter) filter = gtk_file_filter_new ();
  gtk_file_filter_set_name (filter, _ (kind->name));
  for (gsize i = 0; kind->suffixes[i] != NULL; i++)
    gtk_file_filter_add_suffix (filter, kind->suffixes[i]);
  gtk_file_chooser_add_filter (GTK_FILE_CHOOSER (chooser), filter);
}

static void
on_response (GtkNativeDialog *chooser, int response, QnWindow *self)
{
  const QnFileKind *kind = g_object_get_data (G_OBJECT (chooser), "qn-file-kind");
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (chooser));
    g_autofree char *path = g_file_get_path (file);
    if (path != NULL)
      gtk_widget_activate_action (GTK_WIDGET (self), kind->action, "s", path);
    else
      qn_window_show_error (self, _ ("Only local files can be opened"));
  }
  g_clear_object (&self->chooser);
}

void
qn_window_choose_file (QnWindow *self, const QnFileKind *kind)
{
  GtkFileChooserNative *chooser =
    qn_chooser_begin (GTK_WINDOW (self), &self->chooser, GTK_FILE_CHOOSER_ACTION_OPEN,
                      _ (kind->title), _ (kind->accept));
  qn_chooser_add_kind (chooser, kind);
  g_object_set_data (G_OBJECT (chooser), "qn-file-kind", (gpointer) kind);
  g_signal_connect (chooser, "response", G_CALLBACK (on_response), self);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}
