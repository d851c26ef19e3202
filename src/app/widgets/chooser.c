#include "app/widgets/chooser.h"

#include <glib/gi18n.h>

/* Where the next chooser begins, or NULL. */
static GFile *folder;

void
qn_chooser_begin_beside (const char *path)
{
  g_autoptr (GFile) file = g_file_new_for_path (path);
  g_clear_object (&folder);
  folder = g_file_get_parent (file);
}

static void
on_response (GtkNativeDialog *chooser, int response, gpointer data)
{
  GFile *chosen = response == GTK_RESPONSE_ACCEPT
                    ? gtk_file_chooser_get_current_folder (GTK_FILE_CHOOSER (chooser))
                    : NULL;
  if (chosen != NULL) {
    g_clear_object (&folder);
    folder = chosen;
  }
}

GtkFileChooserNative *
qn_chooser_begin (GtkWindow *parent, GObject **kept, GtkFileChooserAction action,
                  const char *title, const char *accept)
{
  GtkFileChooserNative *chooser =
    gtk_file_chooser_native_new (title, parent, action, accept, NULL);
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
  if (folder != NULL)
    gtk_file_chooser_set_current_folder (GTK_FILE_CHOOSER (chooser), folder, NULL);
  g_signal_connect (chooser, "response", G_CALLBACK (on_response), NULL);
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

/* Who takes what is dropped. */
typedef struct Taker {
  QnTakeFile take;
  gpointer data;
} Taker;

static gboolean
on_drop (GtkDropTarget *target, const GValue *value, double x, double y,
         const Taker *taker)
{
  gboolean taken = FALSE;
  for (GSList *l = g_value_get_boxed (value); l != NULL; l = l->next)
    taken |= taker->take (l->data, taker->data);
  return taken;
}

void
qn_accept_files (GtkWidget *widget, QnTakeFile take, gpointer data)
{
  GtkDropTarget *target = gtk_drop_target_new (GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
  Taker *taker = g_new (Taker, 1);
  *taker = (Taker){ take, data };
  g_signal_connect_data (target, "drop", G_CALLBACK (on_drop), taker,
                         (GClosureNotify) (void (*) (void)) g_free, 0);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (target));
}
