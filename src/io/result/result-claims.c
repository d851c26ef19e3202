#include "io/result/result-claims.h"

#include "core/result/result-contact.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Rounding of places, relative to the size of coordinates. */
#define SAME_PLACE 1e-9

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

/* Where the contacts are, in which direction, and which area they stand for. */
static gboolean
check_places (const QnResultFile *file, const char *name, const QnModel *model,
              const QnContacts *contacts, GError **error)
{
  const double *deformation = qn_result_deformation (model, &file->result);
  for (size_t i = 0; i < file->result.pair_count; i++) {
    const QnResultContact *stated = &file->contacts[i];
    const QnContactPair *pair = &contacts->pairs[i];
    double area = pair->tributary * contacts->faces[pair->face].thickness;
    QnVec2 point, normal;
    qn_result_contact_place (model, contacts, i, deformation, &point, &normal);
    double size = SAME_PLACE * (1 + fabs (point.x) + fabs (point.y));
    gboolean same =
      qn_vec2_length (qn_vec2_sub (point, stated->point)) <= size
      && qn_vec2_length (qn_vec2_sub (normal, stated->normal)) <= SAME_PLACE
      && (stated->area < 0 || fabs (stated->area - area) <= SAME_PLACE * (area + 1e-3));
    if (!same)
      return refuse (
        error, name,
        g_strdup_printf (_ ("contacts[%zu]: point, normal or area are not those "
                            "of the project"),
                         i));
  }
  return TRUE;
}

gboolean
qn_result_file_find_faults (const QnResultFile *file, const char *name,
                            const QnProject *project, const QnContacts *contacts,
                            QnResultFaults *faults, GError **error)
{
  *faults = (QnResultFaults){ 0 };
  if (!qn_result_file_match (file, name, project, contacts, NULL, error)
      || !check_hash (file, name, project, error)
      || !check_places (file, name, &project->model, contacts, error))
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
