#include "doc/view/report-item.h"

#include "doc/document/run-file.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>

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
    item->unchecked = g_strdup (_ ("an analysis in time ends in motion; check --result "
                                   "follows its balance of energy"));
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
                       size_t count, GError **error)
{
  QnReport report = { .project = project,
                      .contacts = contacts,
                      .runs = runs,
                      .run_count = count,
                      .plan = *plan,
                      .units = QN_UNITS_SI,
                      .generator = "quoin " QN_VERSION };
  report.units.force = QN_FORCE_KN;
  report.units.stress = QN_STRESS_MPA;
  return qn_report_encode (&report, error);
}

static gboolean
load_item (QnReportItem *item, QnDocument *document, const QnRun *run,
           const QnProject *project, GError **error)
{
  gsize length;
  g_autofree char *text = qn_document_dup_result (document, run, &length, error);
  return text != NULL
         && qn_report_item_parse (item, text, length, run->name, project, &run->contacts,
                                  error);
}

gboolean
qn_report_write (QnDocument *document, QnUnits units, const char *path, GError **error)
{
  QnReportTemplate plan;
  if (!qn_report_template_read (&plan, qn_document_get_project (document), error)) {
    qn_report_template_clear (&plan);
    return FALSE;
  }
  const GPtrArray *all = qn_document_get_runs (document);
  g_autofree QnReportItem *items = g_new0 (QnReportItem, all->len + 1);
  g_autofree QnProject *projects = g_new0 (QnProject, all->len + 1);
  g_autofree QnReportRun *runs = g_new0 (QnReportRun, all->len + 1);
  guint count = 0;
  gboolean done = TRUE;
  for (guint i = 0; i < all->len && done; i++) {
    const QnRun *run = all->pdata[i];
    if (run->kind != QN_RUN_ANALYSIS || qn_document_is_stale (document, run))
      continue;
    projects[count] = *qn_document_get_project (document); /* as it was solved */
    projects[count].model = run->model;
    done = load_item (&items[count], document, run, &projects[count], error);
    if (done)
      runs[count] =
        qn_report_item_get_run (&items[count], &projects[count], &run->contacts);
    count += done;
  }
  QnReport report = { .project = qn_document_get_project (document),
                      .contacts = qn_document_get_contacts (document),
                      .runs = runs,
                      .run_count = count,
                      .plan = plan,
                      .units = units,
                      .generator = "quoin " QN_VERSION };
  g_autoptr (GBytes) bytes = done ? qn_report_encode (&report, error) : NULL;
  gsize length = 0;
  const void *data = bytes != NULL ? g_bytes_get_data (bytes, &length) : NULL;
  done = data != NULL && qn_file_replace (path, data, length, error);
  for (guint i = 0; i < count; i++)
    qn_report_item_clear (&items[i]);
  qn_report_template_clear (&plan);
  return done;
}
