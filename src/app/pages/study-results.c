/* What has been computed of a study and what is being computed: quoin-cli computes the cases, this page looks at
 * them; a case in the drawing; tables and figures as files. */
#include "app/pages/study-private.h"

#include "app/widgets/build-tree.h"
#include "app/widgets/chooser.h"
#include "core/base/integer.h"
#include "io/text/io-error.h"
#include "study/cases/folder.h"
#include <glib/gi18n.h>
#include <math.h>

/* ms between two looks at a study that runs. */
#define INTERVAL 250

/* ---- results ---- */

void
qn_study_page_forget_results (QnStudyPage *self)
{
  if (self->folder == NULL)
    return;
  qn_table_clear (&self->table);
  qn_study_clear (&self->study);
  g_clear_pointer (&self->folder, g_free);
  self->chosen = -1;
}

void
qn_study_page_read_results (QnStudyPage *self)
{
  QnStudy study;
  QnTable table;
  if (!qn_study_read (qn_draft_get_path (self->draft), NULL, &study, NULL))
    return;
  g_autofree char *folder =
    qn_folder_dup_of_state (&study, qn_draft_get_path (self->draft));
  gboolean same = g_strcmp0 (folder, self->folder) == 0;
  qn_study_page_forget_results (self);
  self->study = study;
  if (!qn_table_read (&table, &self->study, folder, NULL)) {
    qn_study_clear (&self->study);
    return;
  }
  self->table = table;
  self->folder = g_steal_pointer (&folder);
  if (!same) {
    self->of = self->by = 0;
    self->by_second = self->study.parameters->len > 1;
  }
}

/* ---- cases that are being computed ---- */

static void
show_progress (QnStudyPage *self, const QnStudyProgress *progress)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text, _ ("%zu of %zu cases, %zu failed"), progress->present,
                   progress->wanted, progress->failed);
  if (self->job != NULL && !isnan (progress->to_go) && progress->present > 0) {
    guint seconds = (guint) qn_to_integer (progress->to_go, 0, G_MAXINT32);
    g_string_append_printf (text, _ (", %u:%02u:%02u left"), seconds / 3600,
                            seconds / 60 % 60, seconds % 60);
  }
  qn_study_page_tell (self, text->str);
  /* The name of the page has the share that is there while it runs. */
  GtkStack *pages = GTK_STACK (gtk_widget_get_ancestor (self->base.root, GTK_TYPE_STACK));
  g_autofree char *title =
    self->job != NULL && progress->wanted > 0
      ? g_strdup_printf (_ ("Study: %zu %%"), 100 * progress->present / progress->wanted)
      : g_strdup (_ ("Study"));
  gtk_stack_page_set_title (gtk_stack_get_page (pages, self->base.root), title);
  if (progress->wanted > 0)
    self->share = (double) progress->present / (double) progress->wanted;
}

static gboolean
on_timeout (gpointer data)
{
  QnStudyPage *self = data;
  QnStudyProgress progress;
  g_autoptr (GError) error = NULL;
  const gboolean runs = qn_study_job_look (self->job, &progress, &error);
  /* What has come in since, of the study that runs. */
  QnTable table;
  if (g_strcmp0 (self->folder, self->running) != 0) {
    qn_study_page_read_results (self);
  } else if (qn_table_read (&table, &self->study, self->folder, NULL)) {
    qn_table_clear (&self->table);
    self->table = table;
  }
  if (!runs)
    g_clear_pointer (&self->job, qn_study_job_free);
  if (error != NULL)
    qn_study_page_tell (self, error->message);
  else
    show_progress (self, &progress);
  self->timeout = runs ? self->timeout : 0;
  qn_study_page_show (self);
  return runs ? G_SOURCE_CONTINUE : G_SOURCE_REMOVE;
}

/* quoin-cli, which computes the cases: beside this program, in the build tree, or in the path. */
static char *
dup_program (void)
{
  g_autofree char *own = g_file_read_link ("/proc/self/exe", NULL);
  g_autofree char *folder = g_path_get_dirname (own != NULL ? own : "");
  char *beside = g_build_filename (folder, "quoin-cli", NULL);
  if (g_file_test (beside, G_FILE_TEST_IS_EXECUTABLE))
    return beside;
  g_free (beside);
  g_autofree char *sources = qn_build_tree_dup_folder ("src");
  if (sources != NULL)
    return g_build_filename (sources, "cli", "quoin-cli", NULL);
  return g_find_program_in_path ("quoin-cli");
}

static gboolean
start (QnStudyPage *self, GError **error)
{
  QnStudy study;
  g_autofree char *program = dup_program ();
  const char *path = qn_draft_get_path (self->draft);
  if (qn_document_is_modified (self->document)) {
    g_set_error_literal (
      error, QN_IO_ERROR, QN_IO_ERROR_FILE,
      _ ("Save the project first: a study computes what its file says."));
    return FALSE;
  }
  if (program == NULL) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_FILE,
                         _ ("quoin-cli, which computes the cases, is not installed."));
    return FALSE;
  }
  if (!qn_draft_save (self->draft, error) || !qn_study_read (path, NULL, &study, error))
    return FALSE;
  g_free (self->running);
  self->running = qn_folder_dup_of_state (&study, path);
  qn_study_clear (&study);
  self->job =
    qn_study_job_start (path, self->running, program, g_get_num_processors (), error);
  return self->job != NULL;
}

void
qn_study_page_run (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  g_autoptr (GError) error = NULL;
  if (!start (self, &error)) {
    qn_study_page_tell (self, error->message);
    return;
  }
  qn_study_page_tell (self, "");
  self->share = 0;
  self->timeout = g_timeout_add (INTERVAL, on_timeout, self);
  qn_study_page_show (self);
}

/* ---- a case in the drawing, analysed again from the copies in its folder ---- */

typedef struct Opening {
  char *folder;
  double *values;
  QnRun *run;
} Opening;

static void
free_opening (gpointer data)
{
  Opening *opening = data;
  qn_run_unref (opening->run);
  g_free (opening->folder);
  g_free (opening->values);
  g_free (opening);
}

/* In a thread of its own. */
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
  qn_document_add_run (state->document, run);
  qn_view_state_set_view (state, qn_view_of_result (&run->result));
  g_autofree char *text = g_strdup_printf (_ ("%s is shown in the drawing."), run->name);
  gtk_label_set_text (status, text);
}

void
qn_study_page_open_case (QnStudyPage *self)
{
  if (self->folder == NULL || self->chosen < 0)
    return;
  gsize row = (gsize) self->chosen;
  Opening *opening = g_new0 (Opening, 1);
  opening->folder = g_strdup (self->folder);
  opening->values = g_memdup2 (self->table.numbers + row * self->table.width,
                               self->table.parameters * sizeof (double));
  g_autoptr (GString) name = g_string_new (NULL);
  g_string_printf (name, _ ("Case %zu"),
                   g_array_index (self->table.rows, QnRow, row).index + 1);
  for (gsize k = 0; k < self->table.parameters; k++)
    g_string_append_printf (name, ", %s %.4g", qn_table_column_name (&self->table, k),
                            opening->values[k]);
  opening->run = qn_run_new (name->str, "");
  opening->run->of_study = TRUE;
  g_autoptr (GTask) task =
    g_task_new (self->state, NULL, on_solved, g_object_ref (self->status));
  g_task_set_task_data (task, opening, free_opening);
  g_task_run_in_thread (task, solve_case);
}

/* ---- files ---- */

static gboolean
write_file (gpointer data, const char *path, GError **error)
{
  QnStudyPage *self = data;
  const char *what = self->exported;
  QnOutput output;
  QnStudyFigure figure = { .kind = QN_STUDY_FIGURE_MECHANISMS };
  if (g_str_equal (what, "table"))
    return qn_table_write (&self->table, path, error);
  qn_output_init (&output);
  if (g_str_equal (what, "figure") && !qn_study_page_chosen_figure (self, &figure)) {
    g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                         _ ("No case has this output yet."));
    return FALSE;
  }
  return qn_study_figure_export (&figure, &self->table, path, &output, error);
}

void
qn_study_page_export (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  QnStudyPage *self = data;
  const char *what = NULL, *path = NULL;
  if (g_variant_is_of_type (parameter, G_VARIANT_TYPE_STRING))
    what = g_variant_get_string (parameter, NULL);
  else
    g_variant_get (parameter, "(&s&s)", &what, &path);
  static const char *const tables[] = { ".csv", NULL };
  static const char *const figures[] = { ".png", ".svg", ".pdf", NULL };
  gboolean table = g_str_equal (what, "table");
  const QnFileQuestion question = { .title = table ? _ ("Export Table of the Study")
                                                   : _ ("Export Figure of the Study"),
                                    .accept = _ ("_Export"),
                                    .name = table ? "study.csv" : "study.png",
                                    .endings = table ? tables : figures,
                                    .use = write_file,
                                    .told = qn_study_page_tell,
                                    .given = path };
  self->exported = g_intern_string (what);
  if (path == NULL || self->folder != NULL)
    qn_chooser_ask (self->base.root, &question, self);
}
