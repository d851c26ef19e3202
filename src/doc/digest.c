#include "doc/digest.h"

char *
qn_model_digest (const QnProject *project)
{
  QnProject bare = *project;
  bare.extras = NULL;
  bare.model.title = NULL;
  gsize length = 0;
  g_autofree char *text = qn_project_to_text (&bare, &length);
  return g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *) text, length);
}
