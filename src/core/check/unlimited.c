#include "core/check/unlimited.h"

#include "core/base/memory.h"
#include "core/base/union-find.h"

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
  QnId *sets = qn_alloc (model->block_count + 1, sizeof *sets);
  if (sets == NULL)
    return qn_diag_no_memory (diag);
  /* Whether all blocks hang together with such as are held. sets: of the blocks and,
   * behind them, the ground. */
  QnId ground = (QnId) model->block_count;
  *unlimited = true;
  qn_sets_init (sets, model->block_count + 1);
  for (QnId b = 0; b < ground; b++)
    if (model->blocks[b].support[QN_DOF_UX] && model->blocks[b].support[QN_DOF_UY])
      qn_sets_join (sets, b, ground);
  for (size_t f = 0; f < contacts->face_count; f++)
    qn_sets_join (sets, contacts->faces[f].a, contacts->faces[f].b);
  for (QnId b = 0; b < ground; b++)
    *unlimited &= qn_sets_root (sets, b) == qn_sets_root (sets, ground);
  free (sets);
  return QN_OK;
}
