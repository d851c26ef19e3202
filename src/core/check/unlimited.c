#include "core/check/unlimited.h"

#include "core/base/memory.h"

#include <stdlib.h>

static bool
is_unlimited (const QnLaw *law)
{
  return law->kind == QN_LAW_ELASTIC
         || (law->kind == QN_LAW_BILINEAR && law->hardening > 0);
}

static bool
has_only_forces (const QnModel *model)
{
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (load.moment != 0 || load.kind == QN_LOAD_SETTLEMENT)
      return false;
  }
  return true;
}

/* Whether blocks hang together with `held` ones, which it marks. */
static bool
hang_together (const QnModel *model, const QnContacts *contacts, bool *held)
{
  size_t count = 0, before;

  for (size_t b = 0; b < model->block_count; b++) {
    const bool *support = model->blocks[b].support;
    held[b] = support[QN_DOF_UX] && support[QN_DOF_UY];
    count += held[b];
  }
  do {
    before = count;
    for (size_t f = 0; f < contacts->face_count; f++) {
      const QnContactFace *face = &contacts->faces[f];
      if (held[face->a] != held[face->b]) {
        held[face->a] = held[face->b] = true;
        count++;
      }
    }
  } while (count > before);
  return count == model->block_count;
}

QnStatus
qn_check_unlimited (const QnModel *model, const QnContacts *contacts, bool *unlimited,
                    QnDiag *diag)
{
  *unlimited = false;
  if (model->analysis.follow || model->node_count > 0 || model->bar_count > 0
      || qn_model_tie_count (model) > 0 || !has_only_forces (model))
    return QN_OK;
  for (size_t f = 0; f < contacts->face_count; f++)
    if (!is_unlimited (&model->laws[contacts->faces[f].law_a])
        || !is_unlimited (&model->laws[contacts->faces[f].law_b]))
      return QN_OK;
  bool *held = qn_alloc (model->block_count, sizeof *held);
  if (held == NULL)
    return qn_diag_no_memory (diag);
  *unlimited = hang_together (model, contacts, held);
  free (held);
  return QN_OK;
}
