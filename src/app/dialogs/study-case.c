/* A case of the study in the drawing: analysed again, from the copies in its folder. */
#include "app/dialogs/study-private.h"

#include "io/text/io-error.h"
#include <glib/gi18n.h>

typedef struct Opening {
  char *folder;
  gsize index;
  double *values;
  char *name;
  QnRun *run;
} Opening;

static void
free_opening (gpointer data)
{
  Opening *opening = data;
  g_clear_pointer (&opening->run, qn_run_unref);
  g_free (opening->folder);
  g_free (opening->values);
  g_free (opening->name);
  g_free (opening);
}

/* In a thread of its own: the case analysed again, from the copies in its folder. */
static void
solve_case (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  Opening *opening = data;
  QnStudy study;
  QnCaseModel model;
  QnCaseResult result;
  GError *error = NULL;
  if (!qn_folder_read_study (opening->folder, &study, &error)) {
    g_task_return_error (task, error);
    return;
  }
  qn_case_solve (&study, opening->values, NULL, &model, &result);
  if (result.failed) {
    error = g_error_new_literal (QN_IO_ERROR, QN_IO_ERROR_INVALID, result.reason);
  } else {
    opening->run = qn_run_new (opening->name, "");
    opening->run->of_study = TRUE;
    opening->run->model = model.project.model;
    opening->run->contacts = model.contacts;
    opening->run->result = model.result;
    model.project.model = (QnModel){ 0 };
    model.contacts = (QnContacts){ 0 };
    model.result = (QnResult){ 0 };
    qn_case_model_clear (&model);
  }
  qn_case_result_clear (&result);
  qn_study_clear (&study);
  if (error != NULL)
    g_task_return_error (task, error);
  else
    g_task_return_boolean (task, TRUE);
}

static void
on_solved (GObject *source, GAsyncResult *task, gpointer data)
{
  QnViewState *state = QN_VIEW_STATE (source);
  g_autoptr (GtkLabel) status = data;
  Opening *opening = g_task_get_task_data (G_TASK (task));
  g_autoptr (GError) error = NULL;
  if (!g_task_propagate_boolean (G_TASK (task), &error)) {
    gtk_label_set_text (status, error->message);
    return;
  }
  QnRun *run = opening->run;
  qn_document_add_run (qn_view_state_get_document (state), run);
  qn_view_state_set_view (state, run->result.mechanism != NULL ? QN_VIEW_MECHANISM
                                 : run->result.step_count > 0  ? QN_VIEW_DEFORMED
                                                               : QN_VIEW_MODEL);
  g_autofree char *text = g_strdup_printf (_ ("%s is shown in the drawing."), run->name);
  gtk_label_set_text (status, text);
}

void
qn_study_window_open_case (QnStudyWindow *self)
{
  if (self->folder == NULL || self->chosen < 0)
    return;
  gsize row = (gsize) self->chosen;
  Opening *opening = g_new0 (Opening, 1);
  opening->index = g_array_index (self->table.rows, QnRow, row).index;
  opening->folder = g_strdup (self->folder);
  opening->values = g_memdup2 (self->table.numbers + row * self->table.width,
                               self->table.parameters * sizeof (double));
  g_autoptr (GString) name = g_string_new (NULL);
  g_string_printf (name, _ ("Case %zu"), opening->index + 1);
  for (gsize k = 0; k < self->table.parameters; k++)
    g_string_append_printf (name, ", %s %.4g", qn_table_column_name (&self->table, k),
                            opening->values[k]);
  opening->name = g_string_free (g_steal_pointer (&name), FALSE);
  g_autoptr (GTask) task =
    g_task_new (self->parent.state, NULL, on_solved, g_object_ref (self->status));
  g_task_set_task_data (task, opening, free_opening);
  g_task_run_in_thread (task, solve_case);
}
