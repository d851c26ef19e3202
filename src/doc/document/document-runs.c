/* Analyses of a document and the runs that they leave. */
#include "doc/document/document.h"

#include "doc/edit/edit.h"
#include "doc/text/explain.h"
#include "io/exchange/record.h"
#include <glib/gi18n-lib.h>
#include <string.h>

void
qn_document_drop_job (QnDocument *self)
{
  if (self->job == NULL)
    return;
  g_signal_handlers_disconnect_by_data (self->job, self);
  qn_job_cancel (self->job);
  g_clear_object (&self->job);
}

static void
on_job_progress (QnJob *job, QnDocument *self)
{
  g_signal_emit_by_name (self, "job-progress");
}

/* There is one live run at most. */
static void
drop_live_run (QnDocument *self)
{
  for (guint i = 0; i < self->runs->len; i++) {
    const QnRun *run = g_ptr_array_index (self->runs, i);
    if (run->live) {
      g_ptr_array_remove_index (self->runs, i);
      return;
    }
  }
}

static void
on_job_done (GObject *source, GAsyncResult *result, gpointer user_data)
{
  QnJob *job = QN_JOB (source);
  g_autoptr (QnDocument) self = user_data;
  g_autoptr (GError) error = NULL;
  QnDiag diag;
  g_autoptr (GPtrArray) runs = qn_job_finish (job, result, &diag, &error);
  if (self->job != job)
    return; /* replaced or dropped meanwhile */

  self->job_diag = diag;
  g_signal_handlers_disconnect_by_data (job, self);
  g_clear_object (&self->job);
  if (runs != NULL) {
    QnRun *run = runs->pdata[0];
    if (run->live)
      drop_live_run (self);
    else
      qn_document_take_run (self, run, self->job_text);
    for (guint i = 1; i < runs->len; i++) {
      QnRun *other = runs->pdata[i];
      other->proposed = g_strdup (run->proposed);
      other->method = g_strdup (run->method);
    }
    g_ptr_array_extend_and_steal (self->runs, g_steal_pointer (&runs));
    qn_document_name_runs (self);
    qn_document_set_run (self, run);
  } else if (!g_error_matches (error, G_IO_ERROR, G_IO_ERROR_CANCELLED)) {
    self->job_error = g_steal_pointer (&error);
  }
  g_signal_emit_by_name (self, "job-changed");
}

/* Starts an analysis of the model, as its kind, modes and `live` say, that leaves a run of this name. */
static gboolean
start (QnDocument *self, const QnModel *model, const char *name, const QnRun *as,
       GError **error)
{
  if (model->block_count == 0 && model->beam_count == 0)
    return qn_edit_refuse (error, _ ("There is nothing to analyse: draw a wall first"));
  QnJob *job = qn_job_new (model, name, qn_document_get_fingerprint (self), error);
  if (job == NULL)
    return FALSE;
  QnRun *run = qn_job_get_run (job);
  run->kind = as->kind;
  run->mode_count = as->mode_count;
  run->loaded = as->loaded;
  run->live = as->live;
  qn_document_drop_job (self);
  g_clear_error (&self->job_error);
  self->job = job;
  g_free (self->job_text);
  self->job_text = run->live ? NULL : g_strdup (self->text->text);
  g_signal_connect (job, "progress", G_CALLBACK (on_job_progress), self);
  qn_job_start (job, on_job_done, g_object_ref (self));
  g_signal_emit_by_name (self, "job-changed");
  return TRUE;
}

gboolean
qn_document_analyse (QnDocument *self, GError **error)
{
  const QnAnalysisSettings *own = &self->project.model.analysis;
  if (own->procedure == QN_PROCEDURE_DYNAMIC
      && !qn_project_read_records (&self->project, self->folder, FALSE, error))
    return FALSE;
  return qn_document_analyse_with (self, own->procedure, own->flow, error);
}

gboolean
qn_document_analyse_live (QnDocument *self, GError **error)
{
  if (self->project.model.analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return qn_edit_refuse (error,
                           _ ("An analysis in time does not follow every edit: run it"));
  QnModel model = self->project.model;
  model.analysis.flow = QN_FLOW_NON_ASSOCIATIVE; /* its bound comes with it */
  return start (self, &model, _ ("After an edit"), &(QnRun){ .live = TRUE }, error);
}

gboolean
qn_document_analyse_with (QnDocument *self, QnProcedure procedure, QnFlow flow,
                          GError **error)
{
  QnModel model = self->project.model;
  model.analysis.procedure = procedure;
  model.analysis.flow = flow;
  return start (self, &model, qn_explain_procedure (&model.analysis),
                &(QnRun){ .kind = QN_RUN_ANALYSIS }, error);
}

gboolean
qn_document_find_modes (QnDocument *self, guint count, gboolean loaded, GError **error)
{
  const QnRun as = { .kind = QN_RUN_MODE, .mode_count = count, .loaded = loaded };
  return start (self, &self->project.model, loaded ? _ ("modes under load") : _ ("modes"),
                &as, error);
}

gboolean
qn_document_find_stability (QnDocument *self, GError **error)
{
  QnModel model = self->project.model;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  return start (self, &model, _ ("stability"), &(QnRun){ .kind = QN_RUN_STABILITY },
                error);
}

void
qn_document_cancel (QnDocument *self)
{
  if (self->job != NULL)
    qn_job_cancel (self->job);
}

void
qn_document_set_run (QnDocument *self, QnRun *run)
{
  if (run != NULL)
    qn_run_ref (run);
  g_clear_pointer (&self->run, qn_run_unref);
  self->run = run;
  g_signal_emit_by_name (self, "runs-changed");
}

void
qn_document_add_run (QnDocument *self, QnRun *run)
{
  g_ptr_array_add (self->runs, qn_run_ref (run));
  qn_document_set_run (self, run);
}

void
qn_document_remove_run (QnDocument *self, QnRun *run)
{
  g_autoptr (QnRun) kept = qn_run_ref (run);
  g_ptr_array_remove (self->runs, run);
  if (self->run == kept) {
    guint left = self->runs->len;
    qn_document_set_run (self,
                         left > 0 ? g_ptr_array_index (self->runs, left - 1) : NULL);
  } else
    g_signal_emit_by_name (self, "runs-changed");
}

QnRun *
qn_document_find_run (QnDocument *self, QnProcedure procedure, QnFlow flow, gboolean live)
{
  for (guint i = self->runs->len; i-- > 0;) {
    QnRun *run = g_ptr_array_index (self->runs, i);
    const QnAnalysisSettings *by = &run->model.analysis;
    if (run->kind == QN_RUN_ANALYSIS && (live || !run->live) && by->procedure == procedure
        && (procedure != QN_PROCEDURE_LIMIT || by->flow == flow)
        && run->result.outcome != QN_OUTCOME_CANCELLED
        && !qn_document_is_stale (self, run))
      return run;
  }
  return NULL;
}

QnRunAge
qn_document_get_run_age (QnDocument *self, const QnRun *run)
{
  const char *own = qn_document_get_fingerprint (self);
  if (run->of_study)
    return QN_RUN_OF_STUDY;
  if (g_strcmp0 (run->fingerprint, own) == 0)
    return QN_RUN_CURRENT;
  const char *structure = strchr (own, ' ');
  return run->fingerprint != NULL && g_str_has_suffix (run->fingerprint, structure)
           ? QN_RUN_OTHER_SETTINGS
           : QN_RUN_OTHER_MODEL;
}

static QnRun *
base_of (QnRun *run)
{
  return run->base != NULL ? run->base : run;
}

double *
qn_document_dup_omegas (QnDocument *self, gsize *count)
{
  g_autoptr (GArray) omegas = g_array_new (FALSE, FALSE, sizeof (double));
  const QnRun *found = NULL;
  for (guint i = self->runs->len; i-- > 0;) {
    QnRun *run = g_ptr_array_index (self->runs, i);
    if (run->kind != QN_RUN_MODE || run->loaded
        || (found != NULL && base_of (run) != found)
        || qn_document_get_run_age (self, run) > QN_RUN_OTHER_SETTINGS)
      continue;
    found = base_of (run);
    g_array_prepend_val (omegas, run->result.vibration.omega);
  }
  *count = omegas->len;
  return omegas->len > 0 ? (double *) g_array_free (g_steal_pointer (&omegas), FALSE)
                         : NULL;
}

gboolean
qn_document_is_stale (QnDocument *self, const QnRun *run)
{
  return qn_document_get_run_age (self, run) != QN_RUN_CURRENT;
}

const char *
qn_run_age_text (QnRunAge age)
{
  switch (age) {
  case QN_RUN_OTHER_SETTINGS:
    return _ ("The settings of the analysis have changed since this run.");
  case QN_RUN_OTHER_MODEL:
    return _ ("Outdated: the model has changed since this run.");
  case QN_RUN_OF_STUDY:
    return _ ("A case of the study, with numbers of its own.");
  case QN_RUN_CURRENT:
    break;
  }
  return "";
}
