#include "long-analysis.h"

#define INCREMENTS 100000

static gboolean
creep (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->analysis.increments = INCREMENTS;
  model->analysis.shortcuts.growing_increments = FALSE;
  return TRUE;
}

void
long_analysis_ask (QnDocument *document)
{
  g_autoptr (GError) error = NULL;

  qn_document_edit (document, "Creep", NULL, creep, NULL, &error);
  g_assert_no_error (error);
}
