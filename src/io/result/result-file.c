#include "io/result/result-file.h"

#include "core/result/result-contact.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

void
qn_result_file_clear (QnResultFile *file)
{
  g_free (file->generator);
  g_free (file->model);
  g_free (file->model_sha256);
  g_strfreev (file->overrides);
  g_strfreev (file->block_names);
  g_strfreev (file->node_names);
  free (file->contacts);
  qn_result_clear (&file->result);
  *file = (QnResultFile){ 0 };
}

static gboolean
fail (GError **error, const char *name, const char *message)
{
  return qn_io_fail (error, QN_IO_ERROR_INVALID, "%s: %s", name, message);
}

static gboolean
match_beams (const QnResultFile *file, const char *name, const QnModel *model,
             GError **error)
{
  gboolean same = file->result.node_count == model->node_count
                  && file->result.element_count == model->element_count;
  for (size_t i = 0; same && i < model->node_count; i++)
    same = strcmp (file->node_names[i], model->nodes[i].name) == 0;
  return same
         || fail (error, name, _ ("the result is of another model: it has other beams"));
}

static gboolean
match_blocks (const QnResultFile *file, const char *name, const QnModel *model,
              GError **error)
{
  if (file->result.block_count != model->block_count)
    return fail (error, name, _ ("the result is of another model: it has other blocks"));
  for (size_t i = 0; i < model->block_count; i++) {
    if (strcmp (file->block_names[i], model->blocks[i].name) != 0)
      return fail (error, name,
                   _ ("the result is of another model: its blocks have other names"));
  }
  return match_beams (file, name, model, error)
         && (qn_result_found_exist (&file->result, model)
             || fail (error, name,
                      _ ("the result is of another model: it has found other contacts")));
}

static gboolean
match_contacts (const QnResultFile *file, const char *name, const QnContacts *contacts,
                GError **error)
{
  /* Without any equilibrium there are no contacts to compare. */
  if (file->result.pair_count == 0)
    return TRUE;
  gboolean same = file->result.pair_count == contacts->pair_count;
  for (size_t i = 0; same && i < contacts->pair_count; i++) {
    const QnResultContact *contact = &file->contacts[i];
    const QnContactFace *face = &contacts->faces[contacts->pairs[i].face];
    same = contact->face == contacts->pairs[i].face && contact->blocks[0] == face->a
           && contact->blocks[1] == face->b && contact->bar == contacts->pairs[i].bar;
  }
  return same
         || fail (error, name,
                  _ ("the result is of another model: it has other contacts"));
}

gboolean
qn_result_file_match (const QnResultFile *file, const char *name,
                      const QnProject *project, const QnContacts *contacts,
                      gboolean *same_bytes, GError **error)
{
  if (same_bytes != NULL)
    *same_bytes = g_strcmp0 (file->model_sha256, project->sha256) == 0;
  return match_blocks (file, name, &project->model, error)
         && (contacts == NULL || match_contacts (file, name, contacts, error));
}

static gboolean
check_hash (const QnResultFile *file, const char *name, const QnProject *project,
            GError **error)
{
  if (g_strcmp0 (file->model_sha256, project->sha256) == 0)
    return TRUE;
  g_autofree char *message = g_strdup_printf (
    _ ("this was computed from another project than %s, which has the SHA-256 %s instead "
       "of %s"),
    project->name, project->sha256 != NULL ? project->sha256 : "–",
    file->model_sha256 != NULL ? file->model_sha256 : "–");
  return fail (error, name, message);
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
    return fail (error, name, _ ("the result holds no forces of the contacts"));
  if (qn_result_find_faults (&project->model, contacts, &file->result,
                             QN_CHECK_RECOMPUTED, faults, NULL)
      == QN_OK)
    return TRUE;
  return qn_io_fail (error, QN_IO_ERROR_NO_MEMORY, "%s: %s", name,
                     _ ("not enough memory"));
}
