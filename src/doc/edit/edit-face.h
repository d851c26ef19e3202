/* Edits of contact faces: exceptions from the general law and placement of pairs.
 *
 * A face is told by its two blocks; an exception holds for all faces between them. Exceptions
 * that say nothing any more are removed. */
#pragma once

#include "core/contact/contacts.h"
#include "doc/edit/edit.h"

/* A set of faces by their blocks; numbers that the contacts do not have are passed over. */
typedef struct QnFaceSet {
  const QnContacts *contacts;
  const QnId *ids;
  guint count;
} QnFaceSet;

/* The exception for a face, or NULL. */
const QnFaceOverride *qn_model_find_override (const QnModel *model,
                                              const QnContactFace *face);

/* QN_NONE: the laws of the blocks or of all contacts. */
gboolean qn_edit_set_face_law (QnModel *model, QnFaceSet set, QnId law, GError **error);

/* NULL: as all contacts. */
gboolean qn_edit_set_face_pairs (QnModel *model, QnFaceSet set, const QnPairRule *rule,
                                 GError **error);
