#include "doc/document/document.h"

#include "doc/edit/edit.h"
#include "io/project/project-members.h"
#include "io/result/result-file.h"
#include "io/text/file-writer.h"

#include <glib/gi18n-lib.h>

/* ---- writing ---- */

char **
qn_run_dup_overrides (const QnRun *run, const QnAnalysisSettings *projects)
{
  const QnAnalysisSettings *own = &run->model.analysis;
  if (own->procedure == projects->procedure && own->flow == projects->flow)
    return NULL;
  char *overrides[] = {
    g_strdup_printf ("analysis.procedure=%s", qn_procedure_names[own->procedure]),
    g_strdup_printf ("analysis.flow=%s", qn_flow_names[own->flow]), NULL
  };
  return g_memdup2 (overrides, sizeof overrides);
}

gboolean
qn_document_write_result (QnDocument *self, const QnRun *run, const char *path,
                          GError **error)
{
  if (run->kind != QN_RUN_ANALYSIS)
    return qn_edit_refuse (error,
                           _ ("Only load paths and limit analyses have result files"));
  if (qn_document_is_stale (self, run))
    return qn_edit_refuse (error,
                           _ ("The model has changed since this run: solve it again, or "
                              "undo the changes, before its result is kept"));
  gsize length;
  QnProject project = *qn_document_get_project (self);
  g_auto (GStrv) overrides = qn_run_dup_overrides (run, &project.model.analysis);
  project.model = run->model;
  project.overrides = overrides;
  if (self->path != NULL)
    project.name = self->path;
  g_autofree char *text = qn_result_dup_text (&project, &run->contacts, &run->result,
                                              QN_DETAIL_FORCES, &length);
  return qn_file_write (path, text, length, error);
}

/* ---- reading ---- */

/* Bytes within which the format is named. */
#define HEAD_BYTES 256

gboolean
qn_is_result_file (const char *path)
{
  char head[HEAD_BYTES];
  gsize length = 0;
  g_autoptr (GFile) file = g_file_new_for_path (path);
  g_autoptr (GFileInputStream) stream = g_file_read (file, NULL, NULL);
  return stream != NULL
         && g_input_stream_read_all (G_INPUT_STREAM (stream), head, sizeof head, &length,
                                     NULL, NULL)
         && g_strstr_len (head, (gssize) length, "\"quoin-result\"") != NULL;
}

/* The project as the result was computed with. Cleared by the caller. */
static gboolean
read_project (QnDocument *self, const QnResultFile *file, QnProject *project,
              GError **error)
{
  const char *name = self->path != NULL ? self->path : _ ("Untitled");
  return qn_project_parse (self->text->text, self->text->length, name,
                           (const char *const *) file->overrides, project, error);
}

static gboolean
fill_contacts (QnRun *run, GError **error)
{
  QnDiag diag = { 0 };
  if (qn_contacts_detect (&run->model, &run->contacts, &diag) == QN_OK)
    return TRUE;
  return qn_edit_refuse_diag (error, &run->model, &diag);
}

/* A procedure that is run once is no change of the model. */
static gboolean
changes_model (const QnResultFile *file)
{
  for (char **o = file->overrides; o != NULL && *o != NULL; o++)
    if (!g_str_has_prefix (*o, "analysis.procedure=")
        && !g_str_has_prefix (*o, "analysis.flow="))
      return TRUE;
  return FALSE;
}

/* A digest that no model has stands for another state of the project. */
static const char *
fingerprint_of (QnDocument *self, const QnResultFile *file)
{
  gboolean same =
    g_strcmp0 (file->model_sha256, qn_document_get_project (self)->sha256) == 0
    || (!qn_document_is_modified (self)
        && g_strcmp0 (file->model_sha256, self->file_digest) == 0);
  return same && !changes_model (file) ? qn_document_get_fingerprint (self)
                                       : file->model_sha256;
}

/* A run of what the file says; `file` gives its result away. */
static QnRun *
make_run (QnDocument *self, QnResultFile *file, const char *path, GError **error)
{
  QnProject project;
  if (!read_project (self, file, &project, error))
    return NULL;
  g_autofree char *name = g_path_get_basename (path);
  g_autoptr (QnRun) run = qn_run_new (name, fingerprint_of (self, file));
  run->model = project.model; /* given away */
  project.model = (QnModel){ 0 };
  qn_project_clear (&project);

  QnProject solved = self->project;
  solved.model = run->model;
  if (!fill_contacts (run, error)
      || !qn_result_file_match (file, path, &solved, &run->contacts, NULL, error))
    return NULL;
  run->result = file->result;
  file->result = (QnResult){ 0 };
  return g_steal_pointer (&run);
}

gboolean
qn_document_open_result (QnDocument *self, const char *path, GError **error)
{
  QnResultFile file;
  if (self->project.model.block_count == 0 && self->project.model.beam_count == 0)
    return qn_edit_refuse (error,
                           _ ("Open the project that the result belongs to first"));
  if (!qn_result_file_read (path, &file, error))
    return FALSE;
  g_autoptr (QnRun) run = make_run (self, &file, path, error);
  qn_result_file_clear (&file);
  if (run == NULL)
    return FALSE;
  g_ptr_array_add (self->runs, qn_run_ref (run));
  qn_document_set_run (self, run);
  return TRUE;
}
