#include "app/widgets/chooser.h"

#include "app/widgets/dialog.h"
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

typedef struct Asked {
  QnFileQuestion question;
  GObject **kept;
  gpointer data;
} Asked;

static void
on_answered (GtkNativeDialog *chooser, int response, const Asked *asked)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *path = NULL;
  if (response == GTK_RESPONSE_ACCEPT && asked->question.name != NULL)
    path = qn_dialog_dup_chosen_path (chooser, asked->question.endings, &error);
  else if (response == GTK_RESPONSE_ACCEPT) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (chooser));
    path = g_file_get_path (file);
    if (path == NULL)
      g_set_error_literal (&error, G_IO_ERROR, G_IO_ERROR_NOT_SUPPORTED,
                           _ ("Only local files can be opened"));
  }
  g_clear_object (asked->kept);
  if (path != NULL || error != NULL)
    asked->question.chosen (asked->data, path, error);
}

void
qn_chooser_ask (GtkWindow *parent, GObject **kept, const QnFileQuestion *question,
                gpointer data)
{
  GtkFileChooserNative *chooser = qn_chooser_begin (
    parent, kept,
    question->name != NULL ? GTK_FILE_CHOOSER_ACTION_SAVE : GTK_FILE_CHOOSER_ACTION_OPEN,
    question->title, question->accept);
  Asked *asked = g_new (Asked, 1);
  *asked = (Asked){ *question, kept, data };
  if (question->name != NULL)
    gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), question->name);
  g_signal_connect_data (chooser, "response", G_CALLBACK (on_answered), asked,
                         (GClosureNotify) (void (*) (void)) g_free, 0);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
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
