#include "doc/edit/edit-face.h"

#include <glib/gi18n-lib.h>

gboolean
qn_override_concerns (const QnFaceOverride *override, QnId a, QnId b)
{
  return (override->block_a == a && override->block_b == b)
         || (override->block_a == b && override->block_b == a);
}

/* Of two exceptions for the same blocks the later counts. */
const QnFaceOverride *
qn_model_find_override (const QnModel *model, const QnContactFace *face)
{
  for (gsize i = model->override_count; i > 0; i--) {
    if (qn_override_concerns (&model->overrides[i - 1], face->a, face->b))
      return &model->overrides[i - 1];
  }
  return NULL;
}

/* Puts an exception in the place of those there were. */
static gboolean
replace_override (QnModel *model, const QnContactFace *face, QnFaceOverride override,
                  GError **error)
{
  override.block_a = face->a;
  override.block_b = face->b;
  gboolean wanted = override.law != QN_NONE || override.has_pairs;
  gsize kept = 0;
  for (gsize i = 0; i < model->override_count; i++) {
    if (!qn_override_concerns (&model->overrides[i], face->a, face->b))
      model->overrides[kept++] = model->overrides[i];
    else if (wanted) {
      model->overrides[kept++] = override;
      wanted = FALSE;
    }
  }
  model->override_count = kept;
  if (!wanted)
    return TRUE;
  QnFaceOverride *added = qn_model_add_override (model);
  if (added == NULL)
    return qn_edit_no_memory (error);
  *added = override;
  return TRUE;
}

gboolean
qn_edit_set_faces (QnModel *model, QnFaceSet set, const QnId *law, const QnPairRule *rule,
                   GError **error)
{
  if (set.count == 0)
    return qn_edit_refuse (error, _ ("No contact face is selected"));
  for (guint i = 0; i < set.count; i++) {
    if ((gsize) set.ids[i] >= set.contacts->face_count)
      continue;
    const QnContactFace *face = &set.contacts->faces[set.ids[i]];
    const QnFaceOverride *old = qn_model_find_override (model, face);
    QnFaceOverride override = old != NULL ? *old : (QnFaceOverride){ .law = QN_NONE };
    if (law != NULL)
      override.law = *law;
    else {
      override.has_pairs = rule != NULL;
      override.pairs = rule != NULL ? *rule : (QnPairRule){ 0 };
    }
    if (!replace_override (model, face, override, error))
      return FALSE;
  }
  return TRUE;
}
