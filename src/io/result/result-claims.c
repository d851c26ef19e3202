#include "io/result/result-claims.h"

#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>

static gboolean
refuse (GError **error, const char *name, char *message)
{
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s: %s", name, message);
  g_free (message);
  return FALSE;
}

static gboolean
check_hash (const QnResultFile *file, const char *name, const QnProject *project,
            GError **error)
{
  if (g_strcmp0 (file->model_sha256, project->sha256) == 0)
    return TRUE;
  return refuse (
    error, name,
    g_strdup_printf (_ ("this was computed from another project than %s, which has the "
                        "SHA-256 %s instead of %s"),
                     project->name, project->sha256 != NULL ? project->sha256 : "–",
                     file->model_sha256 != NULL ? file->model_sha256 : "–"));
}

gboolean
qn_result_file_find_faults (const QnResultFile *file, const char *name,
                            const QnProject *project, const QnContacts *contacts,
                            QnResultFaults *faults, GError **error)
{
  *faults = (QnResultFaults){ 0 };
  if (!qn_result_file_match (file, name, project, contacts, NULL, error)
      || !check_hash (file, name, project, error))
    return FALSE;
  if (file->result.step_count > 0 && file->result.pair_count != contacts->pair_count)
    return refuse (error, name,
                   g_strdup (_ ("the result holds no forces of the contacts")));
  if (qn_result_find_faults (&project->model, contacts, &file->result,
                             QN_CHECK_RECOMPUTED, faults, NULL)
      == QN_OK)
    return TRUE;
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", name,
               _ ("not enough memory"));
  return FALSE;
}
