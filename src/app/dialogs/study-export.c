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
on_chosen (gpointer data, const char *path, const GError *error)
{
  QnStudyWindow *self = data;
  if (path != NULL)
    qn_study_window_export_to (self, self->exported, path);
  else
    qn_study_window_tell (self, error->message);
}

void
qn_study_window_export (QnStudyWindow *self, const char *what)
{
  static const char *const tables[] = { ".csv", NULL };
  static const char *const figures[] = { ".png", ".svg", ".pdf", NULL };
  gboolean table = g_str_equal (what, "table");
  const QnFileQuestion question = { table ? _ ("Export Table of the Study")
                                          : _ ("Export Figure of the Study"),
                                    _ ("_Export"), table ? "study.csv" : "study.png",
                                    table ? tables : figures, on_chosen };
  self->exported = g_intern_string (what);
  qn_chooser_ask (self->window, &self->chooser, &question, self);
}
