/* Exports besides figures: animations, drawn in a thread, and tables. */
#include "app/window-private.h"

#include "doc/figure-export.h"
#include "io/table-csv.h"
#include "render/animation.h"
#include <glib/gi18n.h>

/* ---- animation ---- */

typedef struct AnimationTask {
  QnRun *run;
  QnViewOptions options;
  QnMetadata metadata;
  char *path, *model_name, *sha256;
} AnimationTask;

static void
animation_task_free (gpointer data)
{
  AnimationTask *task = data;
  qn_run_unref (task->run);
  g_free (task->path);
  g_free (task->model_name);
  g_free (task->sha256);
  g_free (task);
}

static void
animate_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  (void) source;
  (void) cancellable;
  const AnimationTask *work = data;
  QnAnimation animation;
  QnOutput output;
  GError *error = NULL;
  qn_animation_init (&animation, &work->run->model, &work->run->contacts,
                     &work->run->result, work->options.view);
  animation.figure.options = work->options;
  qn_output_init (&output);
  output.width = 800.0;
  output.height = 600.0;
  if (qn_animation_export (&animation, work->path, &output, &work->metadata, &error))
    g_task_return_boolean (task, TRUE);
  else
    g_task_return_error (task, error);
}

static void
on_animated (GObject *source, GAsyncResult *result, gpointer data)
{
  QnWindow *self = QN_WINDOW (source);
  g_autoptr (GError) error = NULL;
  g_autofree char *path = data;
  if (!g_task_propagate_boolean (G_TASK (result), &error)) {
    qn_window_show_error (self, error->message);
    return;
  }
  g_autofree char *message = g_strdup_printf (_ ("Animation written to %s"), path);
  qn_window_show_message (self, message);
}

static void
animate_to (QnWindow *self, const char *path)
{
  QnRun *run = qn_document_get_run (self->document);
  if (run == NULL)
    return;
  AnimationTask *work = g_new0 (AnimationTask, 1);
  work->run = qn_run_ref (run);
  work->path = g_strdup (path);
  work->options = qn_view_state_get_options (self->state);
  if (!qn_view_needs_result (work->options.view) || work->options.view == QN_VIEW_FORCES)
    work->options.view =
      run->result.mechanism != NULL ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED;
  work->options.titles = true;
  work->options.phase = 1.0;
  work->options.onion = NULL;
  work->options.underlay.image = NULL; /* belongs to the main thread */
  qn_document_get_metadata (self->document, &work->metadata);
  work->model_name = g_strdup (work->metadata.model);
  work->sha256 = g_strdup (work->metadata.model_sha256);
  work->metadata.model = work->model_name;
  work->metadata.model_sha256 = work->sha256;
  g_autoptr (GTask) task = g_task_new (self, NULL, on_animated, g_strdup (path));
  g_task_set_task_data (task, work, animation_task_free);
  g_task_run_in_thread (task, animate_in_thread);
}

/* ---- tables ---- */

static void
write_curve (QnWindow *self, const char *path)
{
  QnRun *run = qn_document_get_run (self->document);
  g_autoptr (GError) error = NULL;
  /* The project as it was solved, whatever has been drawn since. */
  QnProject project = *qn_document_get_project (self->document);
  project.model = run->model;
  if (!qn_curve_csv_write (path, &project, &run->result, &error))
    qn_window_show_error (self, error->message);
}

static void
write_contacts (QnWindow *self, const char *path)
{
  QnRun *run = qn_document_get_run (self->document);
  g_autoptr (GError) error = NULL;
  QnProject project = *qn_document_get_project (self->document);
  project.model = run->model;
  if (!qn_contacts_csv_write (path, &project, &run->contacts, &run->result, &error))
    qn_window_show_error (self, error->message);
}

/* ---- choosing the file ---- */

typedef void (*WriteFunc) (QnWindow *window, const char *path);

static const struct {
  const char *name; /* parameter of the action "export-result" */
  const char *title;
  const char *file;
  WriteFunc write;
} exports[] = {
  { "animation", N_ ("Export Animation"), N_ ("collapse.gif"), animate_to },
  { "curve", N_ ("Export Curve as Table"), N_ ("curve.csv"), write_curve },
  { "contacts", N_ ("Export Contacts as Table"), N_ ("contacts.csv"), write_contacts },
};

static void
on_response (GtkNativeDialog *dialog, int response, QnWindow *self)
{
  gsize i = GPOINTER_TO_SIZE (g_object_get_data (G_OBJECT (dialog), "qn-export"));
  if (response == GTK_RESPONSE_ACCEPT && qn_document_get_run (self->document) != NULL) {
    g_autoptr (GFile) file = gtk_file_chooser_get_file (GTK_FILE_CHOOSER (dialog));
    g_autofree char *path = g_file_get_path (file);
    if (path != NULL)
      exports[i].write (self, path);
    else
      qn_window_show_error (self, _ ("Only local files can be written"));
  }
  g_clear_object (&self->chooser);
}

static void
export_result (QnWindow *self, GVariant *parameter)
{
  const char *name = g_variant_get_string (parameter, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (exports); i++) {
    if (!g_str_equal (exports[i].name, name))
      continue;
    GtkFileChooserNative *chooser =
      gtk_file_chooser_native_new (_ (exports[i].title), GTK_WINDOW (self),
                                   GTK_FILE_CHOOSER_ACTION_SAVE, _ ("_Export"), NULL);
    gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser), _ (exports[i].file));
    gtk_native_dialog_set_modal (GTK_NATIVE_DIALOG (chooser), TRUE);
    g_object_set_data (G_OBJECT (chooser), "qn-export", GSIZE_TO_POINTER (i));
    g_signal_connect (chooser, "response", G_CALLBACK (on_response), self);
    g_set_object (&self->chooser, G_OBJECT (chooser));
    g_object_unref (chooser);
    gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
  }
}

/* The same without asking: (what, path). */
static void
export_result_path (QnWindow *self, GVariant *parameter)
{
  const char *name, *path;
  g_variant_get (parameter, "(&s&s)", &name, &path);
  for (gsize i = 0; i < G_N_ELEMENTS (exports); i++) {
    if (g_str_equal (exports[i].name, name)
        && qn_document_get_run (self->document) != NULL)
      exports[i].write (self, path);
  }
}

void
qn_window_add_export_actions (QnWindow *self)
{
  static const QnWindowAction actions[] = {
    { "export-result", "s", export_result },
    { "export-result-path", "(ss)", export_result_path },
  };
  qn_window_add_action_table (self, actions, G_N_ELEMENTS (actions));
}
