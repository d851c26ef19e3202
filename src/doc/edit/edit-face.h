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

/* Whether an exception is for these two blocks. */
gboolean qn_override_concerns (const QnFaceOverride *override, QnId a, QnId b);

/* The law where one is given, QN_NONE for that of the blocks or of all contacts; else the pairs, NULL for
 * those of all contacts. */
gboolean qn_edit_set_faces (QnModel *model, QnFaceSet set, const QnId *law,
                            const QnPairRule *rule, GError **error);
