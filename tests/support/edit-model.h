/* Edits of a document that concern its model alone. */
#pragma once

#include "doc/document/document.h"

typedef gboolean (*ModelEdit) (QnModel *model, gpointer data, GError **error);

static inline gboolean
edit_model (QnDocument *document, const char *name, const char *key, ModelEdit func,
            gpointer data, GError **error)
{
  QnProject draft;
  return qn_document_begin_edit (document, &draft, error)
         && qn_document_end_edit (document, &draft, name, key,
                                  func (&draft.model, data, error), error);
}
