#include "doc/view/report.h"

#include "doc/document/document.h"
#include "doc/document/job.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>
#include <string.h>

void
qn_report_run_clear (QnReportRun *run)
{
  qn_result_file_clear (&run->file);
  g_free (run->unchecked);
  g_free (run->name);
}

void
qn_report_run_check (QnReportRun *run, const char *path)
{
  g_autoptr (GError) error = NULL;
  if (run->file.result.history.width > 0)
    run->unchecked =
      g_strdup (_ ("an analysis in time ends in motion, not in balance; its energy is "
                   "checked on the command line"));
  else if (!qn_result_file_find_faults (&run->file, path, run->project, run->contacts,
                                        &run->faults, &error))
    run->unchecked = g_strdup (error->message);
  else if (run->file.result.step_count == 0)
    run->unchecked = g_strdup_printf ("%s: %s", run->project->name,
                                      _ ("the result holds no equilibrium to check"));
}

gboolean
qn_report_run_take (QnReportRun *run, const QnResult *result, GError **error)
{
  gsize length;
  g_autofree char *text =
    qn_result_dup_text (run->project, run->contacts, result, QN_DETAIL_FORCES, &length);
  if (!qn_result_file_parse (text, length, run->name, &run->file, error))
    return FALSE;
  qn_report_run_check (run, run->name);
  return TRUE;
}

/* ---- on a document, in a thread ---- */

/* A copy of the project. */
typedef struct ReportWork {
  QnProject project;
  QnUnits units;
  QnReportTemplate plan;
  GPtrArray *runs; /* of QnRun, as they were solved */
  char *path;
} ReportWork;

static void
report_work_free (gpointer data)
{
  ReportWork *work = data;
  qn_project_clear (&work->project);
  qn_report_template_clear (&work->plan);
  g_ptr_array_unref (work->runs);
  g_free (work->path);
  g_free (work);
}

/* The report as a file; its runs are read. */
static GBytes *
encode (const ReportWork *work, QnReportRun *runs, QnProject *projects,
        GCancellable *cancellable, GError **error)
{
  QnContacts contacts = { 0 };
  GBytes *bytes = NULL;
  gboolean done = TRUE;
  for (guint i = 0; i < work->runs->len && done; i++) {
    const QnRun *run = work->runs->pdata[i];
    g_auto (GStrv) overrides = qn_run_dup_overrides (run, &work->project.model.analysis);
    projects[i] = work->project;
    projects[i].model = run->model;
    projects[i].overrides = overrides;
    runs[i] = (QnReportRun){ .project = &projects[i],
                             .contacts = &run->contacts,
                             .name = g_strdup (run->name) };
    done = qn_report_run_take (&runs[i], &run->result, error);
    projects[i].overrides = NULL;
  }
  if (done && qn_contacts_detect (&work->project.model, &contacts, NULL) != QN_OK) {
    g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_FAILED, _ ("not enough memory"));
    done = FALSE;
  }
  const QnReport report = { &work->project,   &contacts,  runs,
                            work->runs->len,  work->plan, work->units,
                            qn_job_may_go_on, cancellable };
  if (done)
    bytes = qn_report_encode (&report, error);
  qn_contacts_clear (&contacts);
  return bytes;
}

static void
write_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  const ReportWork *work = data;
  GError *error = NULL;
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, work->runs->len + 1);
  g_autofree QnProject *projects = g_new0 (QnProject, work->runs->len + 1);
  g_autoptr (GBytes) bytes = encode (work, runs, projects, cancellable, &error);
  gsize length = 0;
  const void *content = bytes != NULL ? g_bytes_get_data (bytes, &length) : NULL;
  if (content != NULL)
    qn_file_replace (work->path, content, length, &error);
  for (guint i = 0; i < work->runs->len; i++)
    qn_report_run_clear (&runs[i]);
  if (error != NULL)
    g_task_return_error (task, error);
  else
    g_task_return_boolean (task, TRUE);
}

static gboolean
take_up (ReportWork *work, QnDocument *document, GError **error)
{
  const GPtrArray *all = document->runs;
  if (!qn_report_template_read (&work->plan, qn_document_get_project (document), error)
      || !qn_project_copy (qn_document_get_project (document), &work->project, error))
    return FALSE;
  work->project.text = g_strdup (document->text->text);
  work->project.text_length = strlen (work->project.text);
  work->project.sha256 = g_strdup (qn_document_get_project (document)->sha256);
  for (guint i = 0; i < all->len; i++) {
    QnRun *run = all->pdata[i];
    if (run->kind == QN_RUN_ANALYSIS && !qn_document_is_stale (document, run))
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
  g_task_set_task_data (task, work, report_work_free);
  if (take_up (work, document, &error))
    g_task_run_in_thread (task, write_in_thread);
  else
    g_task_return_error (task, error);
}
