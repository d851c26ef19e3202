/* Figures, results and drawings as files, and results read again. */
#include "app/window/window-private.h"

#include "app/dialogs/dialogs.h"
#include "app/widgets/dialog.h"
#include "app/widgets/settings.h"
#include "doc/document/document.h"
#include "doc/view/figures.h"
#include "doc/view/report.h"
#include "doc/view/sheet.h"
#include "io/exchange/dxf-export.h"
#include "io/exchange/table-csv.h"
#include "io/exchange/vtu.h"
#include <glib/gi18n.h>

/* Of what keeps a report from being written: where it goes. */
#define PATH "qn-path"

/* ---- what is written ---- */

static void
tell_written (QnWindow *self, const char *path)
{
  g_autofree char *message = g_strdup_printf (_ ("Written to %s"), path);
  qn_window_show_message (self, message);
}

static void
on_report_written (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (QnWindow) self = data;
  g_autoptr (GError) error = NULL;
  gboolean done = g_task_propagate_boolean (G_TASK (result), &error);
  g_autofree char *path = g_strdup (g_object_get_data (G_OBJECT (self->reporting), PATH));
  g_clear_object (&self->reporting);
  if (gtk_widget_in_destruction (GTK_WIDGET (self)) || self->document == NULL)
    return;
  qn_window_update_actions (self);
  if (done)
    tell_written (self, path);
  else if (g_error_matches (error, G_IO_ERROR, G_IO_ERROR_CANCELLED))
    qn_window_show_message (self, _ ("Cancelled: no report is written"));
  else
    qn_window_show_error (self, error->message);
}

/* All that was computed of the model as it is now, in the background, for combinations are analysed. */
static gboolean
write_report (gpointer data, const char *path, GError **error)
{
  QnWindow *self = data;
  if (self->reporting != NULL) {
    qn_window_show_message (self, _ ("A report is being written; Shift+F5 cancels it"));
    return TRUE;
  }
  self->reporting = g_cancellable_new ();
  g_object_set_data_full (G_OBJECT (self->reporting), PATH, g_strdup (path), g_free);
  qn_report_write_async (self->document, qn_settings_get_units (), path, self->reporting,
                         on_report_written, g_object_ref (self));
  qn_window_show_message (self, _ ("Writing the report… Shift+F5 cancels"));
  qn_window_update_actions (self);
  return TRUE;
}

/* ---- choosing the file ---- */

enum { RESULT, REPORT, STEPS, CURVE, CONTACTS, CRACKS, BEAMS, DRAWING };

/* By the parameter of the action "export-result". */
static const struct {
  const char *name, *title, *file;
  const char *endings[2];
} exports[] = {
  [RESULT] = { "result", N_ ("Export Result File"), N_ ("result.json"), { ".json" } },
  [REPORT] = { "report", N_ ("Export Report"), N_ ("report.pdf"), { ".pdf" } },
  [STEPS] = { "steps", N_ ("Export Steps for ParaView"), N_ ("steps.pvd"), { ".pvd" } },
  [CURVE] = { "curve", N_ ("Export Curve as Table"), N_ ("curve.csv"), { ".csv" } },
  [CONTACTS] = { "contacts",
                 N_ ("Export Contacts as Table"),
                 N_ ("contacts.csv"),
                 { ".csv" } },
  [CRACKS] = { "cracks", N_ ("Export Cracks as Table"), N_ ("cracks.csv"), { ".csv" } },
  [BEAMS] = { "beams",
              N_ ("Export Section Forces as Table"),
              N_ ("beams.csv"),
              { ".csv" } },
  [DRAWING] = { "drawing", N_ ("Export Drawing as DXF"), N_ ("drawing.dxf"), { ".dxf" } },
};

/* Results with the project as it was solved, whatever has been drawn since; the drawing in metres. */
static gboolean
write_file (gpointer data, const char *path, GError **error)
{
  QnWindow *self = data;
  const QnRun *run = self->document->run;
  QnProject project = *qn_document_get_project (self->document);
  if (self->exported == DRAWING)
    return qn_dxf_export (&project.model, &self->document->contacts, NULL, 1.0, 1.0, path,
                          error);
  project.model = run->model;
  switch (self->exported) {
  case RESULT:
    return qn_document_write_result (self->document, run, path, error);
  case STEPS:
    return qn_vtu_export (&run->model, &run->contacts, &run->result, path, error);
  case CURVE:
  case BEAMS:
  case CONTACTS:
    return qn_result_table_write (path,
                                  self->exported == CURVE   ? QN_TABLE_CURVE
                                  : self->exported == BEAMS ? QN_TABLE_BEAMS
                                                            : QN_TABLE_CONTACTS,
                                  &project, &run->contacts, &run->result, error);
  default:
    return qn_cracks_csv_write (path, &project, &run->contacts, &run->result, error);
  }
}

/* To a file that is asked for, where `path` is NULL. */
static void
export_to (QnWindow *self, gsize i, const char *path)
{
  const QnFileQuestion question = { .title = _ (exports[i].title),
                                    .accept = _ ("_Export"),
                                    .name = _ (exports[i].file),
                                    .endings = exports[i].endings,
                                    .use = i == REPORT ? write_report : write_file,
                                    .told = i == REPORT ? NULL : qn_window_show_message,
                                    .failed = qn_window_show_error,
                                    .given = path };
  if (i != DRAWING && self->document->run == NULL)
    return;
  self->exported = i;
  qn_chooser_ask (GTK_WIDGET (self), &question, self);
}

/* ---- figures and what else has a dialog of its own ---- */

static void
repeat_export (QnWindow *self, const char *name)
{
  g_autoptr (GError) error = NULL;
  if (self->last_export == NULL)
    return;
  if (!qn_view_state_export_as (self->state, self->last_recipe, self->last_export,
                                &error)) {
    qn_window_show_error (self, error->message);
    return;
  }
  tell_written (self, self->last_export);
  qn_window_update_actions (self);
}

static void
write_figure (GtkWindow *window, const char *path, QnRecipe *recipe)
{
  QnWindow *self = QN_WINDOW (window);
  g_free (self->last_export);
  self->last_export = g_strdup (path);
  g_clear_pointer (&self->last_recipe, qn_recipe_free);
  self->last_recipe = recipe;
  repeat_export (self, NULL);
}

static void
export_figure (QnWindow *self, const char *name)
{
  qn_export_dialog_show (GTK_WINDOW (self), self->state, write_figure,
                         qn_window_show_message);
}

static void
choose_report (GtkWindow *window)
{
  export_to (QN_WINDOW (window), REPORT, NULL);
}

static void
export_result (QnWindow *self, const char *name)
{
  if (g_str_equal (name, "animation")) {
    qn_animation_dialog_show (GTK_WINDOW (self), self->state, qn_window_show_message,
                              NULL);
    return;
  }
  if (g_str_equal (name, "report")) {
    qn_report_dialog_show (GTK_WINDOW (self), self->document, choose_report);
    return;
  }
  for (gsize i = 0; i < DRAWING; i++)
    if (g_str_equal (exports[i].name, name))
      export_to (self, i, NULL);
}

static void
export_drawing (QnWindow *self, const char *name)
{
  export_to (self, DRAWING, NULL);
}

/* The same without asking: (what, path). */
static void
export_path (QnWindow *self, GVariant *parameter)
{
  const char *name, *path;
  g_variant_get (parameter, "(&s&s)", &name, &path);
  if (g_str_equal (name, "animation") && self->document->run != NULL)
    qn_animation_dialog_show (GTK_WINDOW (self), self->state, qn_window_show_message,
                              path);
  for (gsize i = 0; i < G_N_ELEMENTS (exports); i++)
    if (g_str_equal (exports[i].name, name))
      export_to (self, i, path);
}

/* ---- opening a result ---- */

void
qn_window_open_result (QnWindow *self, const char *path)
{
  g_autoptr (GError) error = NULL;
  if (!qn_document_open_result (self->document, path, &error)) {
    qn_window_show_work (self);
    qn_window_show_error (self, error->message);
    return;
  }
  const QnRun *run = self->document->run;
  gtk_stack_set_visible_child_name (self->side_stack, "result");
  if (run->result.outcome != QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    qn_view_state_set_view (self->state, qn_view_of_result (&run->result));
}

const QnWindowAction qn_window_export_actions[] = {
  { "export", NULL, { export_figure }, QN_NEEDS_DRAWN },
  { "repeat-export", NULL, { repeat_export }, QN_NEEDS_WORK | QN_NEEDS_EXPORTED },
  { "export-result", "s", { export_result }, QN_NEEDS_RUN },
  { "export-drawing", NULL, { export_drawing }, QN_NEEDS_DRAWN },
  { "export-path", "(ss)", { .take = export_path }, 0 },
  { "open-result", NULL, { qn_window_choose_file }, QN_NEEDS_DRAWN },
  { "open-result-path", "s", { qn_window_open_result }, QN_NEEDS_DRAWN },
  { .name = NULL },
};
