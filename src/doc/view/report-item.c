#include "doc/view/report-item.h"

#include "doc/document/job.h"
#include "doc/document/run-file.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>
#include <string.h>

void
qn_report_item_clear (QnReportItem *item)
{
  qn_result_file_clear (&item->file);
  g_free (item->unchecked);
  g_free (item->name);
}

void
qn_report_item_check (QnReportItem *item, const QnProject *project,
                      const QnContacts *contacts, const char *path)
{
  g_autoptr (GError) error = NULL;
  if (item->file.result.history.width > 0)
    item->unchecked =
      g_strdup (_ ("an analysis in time ends in motion, not in balance; its energy is "
                   "checked on the command line"));
  else if (!qn_result_file_find_faults (&item->file, path, project, contacts,
                                        &item->faults, &error))
    item->unchecked = g_strdup (error->message);
  else if (item->file.result.step_count == 0)
    item->unchecked = g_strdup_printf ("%s: %s", project->name,
                                       _ ("the result holds no equilibrium to check"));
}

QnReportRun
qn_report_item_get_run (const QnReportItem *item, const QnProject *project,
                        const QnContacts *contacts)
{
  return (QnReportRun){
    .name = item->name,
    .project = project,
    .contacts = contacts,
    .file = &item->file,
    .faults = item->unchecked == NULL ? &item->faults : NULL,
    .unchecked = item->unchecked,
  };
}

gboolean
qn_report_item_parse (QnReportItem *item, const char *text, gsize length,
                      const char *name, const QnProject *project,
                      const QnContacts *contacts, GError **error)
{
  if (!qn_result_file_parse (text, length, name, &item->file, error))
    return FALSE;
  item->name = g_strdup (name);
  qn_report_item_check (item, project, contacts, name);
  return TRUE;
}

GBytes *
qn_report_encode_runs (const QnProject *project, const QnContacts *contacts,
                       const QnReportTemplate *plan, const QnReportRun *runs,
                       size_t count, QnUnits units, QnProgressFunc progress,
                       void *progress_data, GError **error)
{
  const QnReport report = { .project = project,
                            .contacts = contacts,
                            .runs = runs,
                            .run_count = count,
                            .plan = *plan,
                            .units = units,
                            .generator = "quoin " QN_VERSION,
                            .progress = progress,
                            .progress_data = progress_data };
  return qn_report_encode (&report, error);
}

/* ---- on a document, in a thread ---- */

/* A copy of the project, and of every run what its file would hold. */
typedef struct ReportWork {
  QnProject project;
  QnUnits units;
  QnReportTemplate plan;
  GPtrArray *runs;  /* of QnRun, as they were solved */
  GPtrArray *texts; /* of GBytes */
  char *path;
} ReportWork;

static void
report_work_free (gpointer data)
{
  ReportWork *work = data;
  qn_project_clear (&work->project);
  qn_report_template_clear (&work->plan);
  g_ptr_array_unref (work->runs);
  g_ptr_array_unref (work->texts);
  g_free (work->path);
  g_free (work);
}

/* The report as a file; the runs are read in `items`. */
static GBytes *
encode (ReportWork *work, QnReportItem *items, QnProject *projects,
        GCancellable *cancellable, GError **error)
{
  QnContacts contacts = { 0 };
  GBytes *bytes = NULL;
  gboolean done = TRUE;
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, work->runs->len + 1);
  for (guint i = 0; i < work->runs->len && done; i++) {
    const QnRun *run = work->runs->pdata[i];
    gsize length;
    const char *text = g_bytes_get_data (work->texts->pdata[i], &length);
    projects[i] = work->project;
    projects[i].model = run->model;
    done = qn_report_item_parse (&items[i], text, length, run->name, &projects[i],
                                 &run->contacts, error);
    if (done)
      runs[i] = qn_report_item_get_run (&items[i], &projects[i], &run->contacts);
  }
  if (done && qn_contacts_detect (&work->project.model, &contacts, NULL) != QN_OK) {
    g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_FAILED, _ ("not enough memory"));
    done = FALSE;
  }
  if (done)
    bytes = qn_report_encode_runs (&work->project, &contacts, &work->plan, runs,
                                   work->runs->len, work->units, qn_job_may_go_on,
                                   cancellable, error);
  qn_contacts_clear (&contacts);
  return bytes;
}

static void
write_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  ReportWork *work = data;
  GError *error = NULL;
  g_autofree QnReportItem *items = g_new0 (QnReportItem, work->runs->len + 1);
  g_autofree QnProject *projects = g_new0 (QnProject, work->runs->len + 1);
  g_autoptr (GBytes) bytes = encode (work, items, projects, cancellable, &error);
  gsize length = 0;
  const void *content = bytes != NULL ? g_bytes_get_data (bytes, &length) : NULL;
  if (content != NULL)
    qn_file_replace (work->path, content, length, &error);
  for (guint i = 0; i < work->runs->len; i++)
    qn_report_item_clear (&items[i]);
  if (error != NULL)
    g_task_return_error (task, error);
  else
    g_task_return_boolean (task, TRUE);
}

static gboolean
take_up (ReportWork *work, QnDocument *document, GError **error)
{
  const GPtrArray *all = qn_document_get_runs (document);
  if (!qn_report_template_read (&work->plan, qn_document_get_project (document), error)
      || !qn_project_copy (qn_document_get_project (document), &work->project, error))
    return FALSE;
  work->project.text = g_strdup (qn_document_get_text (document));
  work->project.text_length = strlen (work->project.text);
  work->project.sha256 = g_strdup (qn_document_get_project (document)->sha256);
  for (guint i = 0; i < all->len; i++) {
    QnRun *run = all->pdata[i];
    gsize length;
    if (run->kind != QN_RUN_ANALYSIS || qn_document_is_stale (document, run))
      continue;
    char *text = qn_document_dup_result (document, run, &length, error);
    if (text == NULL)
      return FALSE;
    g_ptr_array_add (work->texts, g_bytes_new_take (text, length));
    g_ptr_array_add (work->runs, qn_run_ref (run));
  }
  return TRUE;
}

void
qn_report_write_async (QnDocument *document, QnUnits units, const char *path,
                       GCancellable *cancellable, GAsyncReadyCallback callback,
                       gpointer user_data)
{
  ReportWork *work = g_new0 (ReportWork, 1);
  g_autoptr (GTask) task = g_task_new (NULL, cancellable, callback, user_data);
  g_task_set_check_cancellable (task, FALSE);
  GError *error = NULL;
  work->units = units;
  work->path = g_strdup (path);
  work->runs = g_ptr_array_new_with_free_func ((GDestroyNotify) qn_run_unref);
  work->texts = g_ptr_array_new_with_free_func ((GDestroyNotify) g_bytes_unref);
  g_task_set_task_data (task, work, report_work_free);
  if (take_up (work, document, &error))
    g_task_run_in_thread (task, write_in_thread);
  else
    g_task_return_error (task, error);
}

gboolean
qn_report_write_finish (GAsyncResult *result, GError **error)
{
  return g_task_propagate_boolean (G_TASK (result), error);
}
