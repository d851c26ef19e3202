#include "doc/document/digest.h"

#include "io/project/project-extras.h"
#include "io/project/project-masonry.h"

/* Of what the file says besides the model, masonry is what blocks follow from. */
static struct cJSON *
masonry_alone (const QnProject *project)
{
  QnProject empty = { 0 };
  g_autofree char *json = qn_project_dup_extra (project, QN_MASONRY_MEMBER);
  return json != NULL ? qn_project_extras_with (&empty, QN_MASONRY_MEMBER, json, NULL)
                      : NULL;
}

char *
qn_model_digest_like (const QnProject *project, const char *text)
{
  QnProject bare = *project;
  bare.extras = masonry_alone (project);
  bare.model.title = NULL;
  gsize length = 0;
  g_autofree char *canonical = text != NULL
                                 ? qn_project_to_text_like (&bare, project, text, &length)
                                 : qn_project_to_text (&bare, &length);
  qn_project_extras_free (bare.extras);
  return g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *) canonical,
                                      length);
}

char *
qn_model_digest (const QnProject *project)
{
  return qn_model_digest_like (project, NULL);
}
