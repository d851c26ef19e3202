#include "app/widgets/chooser.h"

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
