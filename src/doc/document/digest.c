#include "doc/document/digest.h"

#include "io/project/project-masonry.h"
#include "io/project/project.h"

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
qn_model_digest_like (const QnProject *project, const QnProjectText *text)
{
  QnProject bare = *project;
  bare.extras = masonry_alone (project);
  bare.model.title = NULL;
  /* Neither title nor sources change an answer. */
  g_autofree QnLaw *laws =
    g_memdup2 (bare.model.laws, bare.model.law_count * sizeof *laws);
  for (gsize i = 0; i < bare.model.law_count; i++)
    laws[i].source = NULL;
  bare.model.laws = laws;
  QnProjectText *canonical = qn_project_write (&bare, project, text);
  qn_project_extras_free (bare.extras);
  char *digest = g_compute_checksum_for_data (
    G_CHECKSUM_SHA256, (const guchar *) canonical->text, canonical->length);
  qn_project_text_free (canonical);
  return digest;
}

char *
qn_structure_digest_like (const QnProject *project, const QnProjectText *text)
{
  QnModel fresh;
  QnProject bare = *project;
  qn_model_init (&fresh);
  bare.model.analysis = fresh.analysis;
  qn_model_clear (&fresh);
  return qn_model_digest_like (&bare, text);
}

char *
qn_model_digest (const QnProject *project)
{
  return qn_model_digest_like (project, NULL);
}
