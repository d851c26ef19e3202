/* The springs that the laws make of the pairs of a face, and what must not be. */
#include "core/contact/contact-search.h"

#include <math.h>

QnId
qn_contacts_pair_law (const QnModel *model, const QnContacts *contacts, size_t pair,
                      int side)
{
  const QnContactPair *p = &contacts->pairs[pair];
  const QnContactFace *face = &contacts->faces[p->face];

  if (p->bar != QN_NONE)
    return model->bars[p->bar].law;
  return side == 0 ? face->law_a : face->law_b;
}

/* Extent of a block along a direction, m. */
static double
block_extent (const QnModel *model, QnId block, QnVec2 direction)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  double low = 0, high = 0;

  for (QnId i = 0; i < model->blocks[block].vertex_count; i++) {
    double s = qn_vec2_dot (qn_vec2_sub (v[i], v[0]), direction);
    low = fmin (low, s);
    high = fmax (high, s);
  }
  return high - low;
}

QnPairSprings
qn_contacts_pair_springs (const QnModel *model, const QnContacts *contacts, size_t pair)
{
  const QnContactPair *p = &contacts->pairs[pair];
  const QnContactFace *face = &contacts->faces[p->face];
  const QnId blocks[2] = { face->a, face->b };
  double area = p->tributary * face->thickness;
  QnSpring springs[2];

  for (int side = 0; side < 2; side++) {
    const QnLaw *law = &model->laws[qn_contacts_pair_law (model, contacts, pair, side)];
    /* The side of a block reaches to its middle; the other half belongs to the far side. */
    double length = 0.5 * block_extent (model, blocks[side], face->normal);
    springs[side] = qn_spring_from_law (law, area, length);
  }
  return qn_pair_springs (springs[0], springs[1]);
}

static QnStatus
refuse (const QnContactFace *face, QnProblem problem, QnDiag *diag)
{
  qn_diag_set_field (diag, problem, QN_ENTITY_BLOCK, face->a, NULL, face->length);
  if (diag != NULL) {
    diag->other = face->b;
    diag->at = qn_vec2_lerp (face->start, face->end, 0.5);
  }
  return QN_ERROR_INVALID;
}

/* Whether the springs on either side of a pair may soften, as far as the kinds of law tell. */
static bool
may_soften (const QnModel *model, const QnContacts *contacts, QnId pair)
{
  for (int side = 0; side < 2; side++) {
    QnId law = qn_contacts_pair_law (model, contacts, (size_t) pair, side);
    if (qn_law_softens (model->laws[law].kind))
      return true;
  }
  return false;
}

QnStatus
qn_contacts_check_springs (const QnModel *model, const QnContacts *contacts, QnId index,
                           QnDiag *diag)
{
  const QnContactFace *face = &contacts->faces[index];

  if (model->laws[face->law_a].basis != model->laws[face->law_b].basis)
    return refuse (face, QN_PROBLEM_BASES_DIFFER, diag);
  for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
    /* Whether a pair snaps back does not depend on its area: the first one and the bars show it. */
    if ((p > face->first_pair && contacts->pairs[p].bar == QN_NONE)
        || !may_soften (model, contacts, p))
      continue;
    QnPairSprings springs = qn_contacts_pair_springs (model, contacts, (size_t) p);
    if (qn_pair_springs_snap_back (&springs))
      return refuse (face, QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL, diag);
  }
  return QN_OK;
}
