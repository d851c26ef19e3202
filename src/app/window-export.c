/* Exports besides figures: tables; animations have a dialog of their own. */
#include "app/window-private.h"

#include "io/table-csv.h"
#include <glib/gi18n.h>

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

static void
write_beams (QnWindow *self, const char *path)
{
  QnRun *run = qn_document_get_run (self->document);
  g_autoptr (GError) error = NULL;
  QnProject project = *qn_document_get_project (self->document);
  project.model = run->model;
  if (!qn_beams_csv_write (path, &project, &run->result, &error))
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
  { "animation", NULL, NULL, qn_animation_export_to },
  { "curve", N_ ("Export Curve as Table"), N_ ("curve.csv"), write_curve },
  { "contacts", N_ ("Export Contacts as Table"), N_ ("contacts.csv"), write_contacts },
  { "beams", N_ ("Export Section Forces as Table"), N_ ("beams.csv"), write_beams },
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
  if (g_str_equal (name, "animation")) {
    qn_animation_dialog_show (self);
    return;
  }
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
