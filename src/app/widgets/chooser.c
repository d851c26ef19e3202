#include "app/widgets/chooser.h"

#include "doc/document/import.h"

#include <glib/gi18n.h>
#include <string.h>

/* Where the next chooser begins, or NULL. */
static GFile *folder;

void
qn_chooser_begin_beside (const char *path)
{
  g_autoptr (GFile) file = g_file_new_for_path (path);
  g_clear_object (&folder);
  folder = g_file_get_parent (file);
}

/* What was asked, and whom. */
typedef struct Asked {
  QnFileQuestion question;
  GtkWidget *widget;
  gpointer data;
} Asked;

static Asked *
new_asked (GtkWidget *widget, const QnFileQuestion *question, gpointer data)
{
  const Asked asked = { *question, widget, data };
  return g_memdup2 (&asked, sizeof asked);
}

char *
qn_chooser_complete_path (const char *path, const char *const *endings, GError **error)
{
  const gsize ending = qn_ending_of (path, endings);
  /* Choosers keep the ending of the name that they propose behind another one that is typed. */
  g_autofree char *typed = g_strndup (path, strlen (path) - ending);
  if (ending > 0 && qn_ending_of (typed, endings) == 0)
    return g_strdup (path);
  g_autofree char *whole = g_strconcat (typed, ending > 0 ? "" : endings[0], NULL);
  if (g_file_test (whole, G_FILE_TEST_EXISTS)) {
    g_set_error (error, G_IO_ERROR, G_IO_ERROR_EXISTS,
                 _ ("%s exists already: choose it to replace it"), whole);
    return NULL;
  }
  return g_steal_pointer (&whole);
}

/* The file, or NULL with the reason why it is none. */
static void
hand_over (const QnFileQuestion *question, gpointer data, const char *path,
           const GError *refused)
{
  g_autoptr (GError) error = NULL;
  const gboolean used = path != NULL && question->use (data, path, &error);
  g_autofree char *where = g_strdup_printf (_ ("Written to %s"), path);
  if (!used)
    (question->failed != NULL ? question->failed : question->told) (
      data, (error != NULL ? error : refused)->message);
  else if (question->told != NULL)
    question->told (data, where);
  if (!used && question->left != NULL)
    question->left (data);
}

static void
tell (const Asked *asked, GFile *file)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *chosen = g_file_get_path (file), *path = NULL;
  if (chosen == NULL)
    g_set_error_literal (&error, G_IO_ERROR, G_IO_ERROR_NOT_SUPPORTED,
                         asked->question.name != NULL
                           ? _ ("Only local files can be written")
                           : _ ("Only local files can be opened"));
  else if (asked->question.name != NULL)
    path = qn_chooser_complete_path (chosen, asked->question.endings, &error);
  else
    path = g_steal_pointer (&chosen);
  hand_over (&asked->question, asked->data, path, error);
}

static void
drop (GtkWidget *widget)
{
  g_object_set_data (G_OBJECT (widget), QN_CHOOSER, NULL);
}

/* GTK 4.10 has GtkFileDialog in its place, which GTK 4.8 has not; this one is there in all of GTK 4. */
G_GNUC_BEGIN_IGNORE_DEPRECATIONS

/* The chooser is gone before anybody hears of what was chosen. */
static void
on_response (GtkNativeDialog *chooser, int response, const Asked *asked)
{
  g_autoptr (GListModel) files =
    response == GTK_RESPONSE_ACCEPT
      ? gtk_file_chooser_get_files (GTK_FILE_CHOOSER (chooser))
      : NULL;
  const guint count = files != NULL ? g_list_model_get_n_items (files) : 0;
  drop (asked->widget);
  for (guint i = 0; i < count; i++) {
    g_autoptr (GFile) file = g_list_model_get_item (files, i);
    g_clear_object (&folder);
    folder = g_file_get_parent (file);
    tell (asked, file);
  }
  if (count == 0 && asked->question.left != NULL)
    asked->question.left (asked->data);
}

static void
show (GtkWidget *widget, const QnFileQuestion *question, gpointer data)
{
  GtkFileChooserNative *native = gtk_file_chooser_native_new (
    question->title, GTK_WINDOW (gtk_widget_get_root (widget)),
    question->name != NULL ? GTK_FILE_CHOOSER_ACTION_SAVE
    : question->folder     ? GTK_FILE_CHOOSER_ACTION_SELECT_FOLDER
                           : GTK_FILE_CHOOSER_ACTION_OPEN,
    question->accept, NULL);
  GtkFileChooser *chooser = GTK_FILE_CHOOSER (native);
  gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (native), TRUE);
  gtk_file_chooser_set_select_multiple (chooser, question->many);
  /* Not as a file: GTK reads its folder twice then, and complains of the first time. */
  if (question->path != NULL)
    qn_chooser_begin_beside (question->path);
  if (folder != NULL)
    gtk_file_chooser_set_current_folder (chooser, folder, NULL);
  g_autofree char *name =
    g_path_get_basename (question->path != NULL ? question->path : "");
  if (question->name != NULL)
    gtk_file_chooser_set_current_name (chooser,
                                       question->path != NULL ? name : question->name);
  if (question->kind != NULL) {
    g_autoptr (GtkFileFilter) filter = gtk_file_filter_new ();
    gtk_file_filter_set_name (filter, _ (question->kind->name));
    for (gsize i = 0; question->kind->suffixes[i] != NULL; i++)
      gtk_file_filter_add_suffix (filter, question->kind->suffixes[i]);
    gtk_file_chooser_add_filter (chooser, filter);
  }
  g_signal_connect_data (native, "response", G_CALLBACK (on_response),
                         new_asked (widget, question, data),
                         (GClosureNotify) (void (*) (void)) g_free, 0);
  g_signal_connect_object (widget, "destroy", G_CALLBACK (drop), native, 0);
  g_object_set_data_full (G_OBJECT (widget), QN_CHOOSER, native, g_object_unref);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (native));
}

G_GNUC_END_IGNORE_DEPRECATIONS

void
qn_chooser_ask (GtkWidget *widget, const QnFileQuestion *question, gpointer data)
{
  if (question->given != NULL)
    hand_over (question, data, question->given, NULL);
  else
    show (widget, question, data);
}

static gboolean
on_drop (GtkDropTarget *target, const GValue *value, double x, double y,
         const Asked *asked)
{
  for (GSList *l = g_value_get_boxed (value); l != NULL; l = l->next)
    tell (asked, l->data);
  return TRUE;
}

void
qn_accept_files (GtkWidget *widget, const QnFileQuestion *question, gpointer data)
{
  GtkDropTarget *target = gtk_drop_target_new (GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
  g_signal_connect_data (target, "drop", G_CALLBACK (on_drop),
                         new_asked (widget, question, data),
                         (GClosureNotify) (void (*) (void)) g_free, 0);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (target));
}
