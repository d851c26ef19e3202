/* Tables and figures of a study as files. */
#include "app/dialogs/study-private.h"

#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>

static gboolean
write_to (QnStudyWindow *self, const char *what, const char *path, GError **error)
{
  QnOutput output;
  QnStudyFigure figure = { .kind = QN_STUDY_FIGURE_MECHANISMS };
  if (g_str_equal (what, "table"))
    return qn_table_write (&self->table, path, error);
  qn_output_init (&output);
  if (g_str_equal (what, "figure") && !qn_study_window_chosen_figure (self, &figure)) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                         _ ("No case has this output yet."));
    return FALSE;
  }
  return qn_study_figure_export (&figure, &self->table, path, &output, error);
}

void
qn_study_window_export_to (QnStudyWindow *self, const char *what, const char *path)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *text = NULL;
  if (self->folder == NULL)
    return;
  if (write_to (self, what, path, &error))
    text = g_strdup_printf (_ ("Written to %s"), path);
  qn_study_window_tell (self, text != NULL ? text : error->message);
}

static void
on_export_response (GtkNativeDialog *dialog, int response, QnStudyWindow *self)
{
  static const char *const tables[] = { ".csv", NULL };
  static const char *const figures[] = { ".png", ".svg", ".pdf", NULL };
  const char *what = g_object_get_data (G_OBJECT (dialog), "qn-what");
  g_autoptr (GError) error = NULL;
  if (response == GTK_RESPONSE_ACCEPT) {
    g_autofree char *path = qn_dialog_dup_chosen_path (
      dialog, g_str_equal (what, "table") ? tables : figures, &error);
    if (path != NULL)
      qn_study_window_export_to (self, what, path);
    else
      qn_study_window_tell (self, error->message);
  }
  g_clear_object (&self->chooser);
}

void
qn_study_window_export (QnStudyWindow *self, const char *what)
{
  gboolean table = g_str_equal (what, "table");
  GtkFileChooserNative *chooser = qn_chooser_begin (
    self->window, &self->chooser, GTK_FILE_CHOOSER_ACTION_SAVE,
    table ? _ ("Export Table of the Study") : _ ("Export Figure of the Study"),
    _ ("_Export"));
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser),
                                     table ? "study.csv" : "study.png");
  g_object_set_data_full (G_OBJECT (chooser), "qn-what", g_strdup (what), g_free);
  g_signal_connect (chooser, "response", G_CALLBACK (on_export_response), self);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}
