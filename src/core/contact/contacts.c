#include "core/contact/contacts.h"

#include "core/contact/contact-bars.h"
#include "core/contact/contact-search.h"
#include "core/contact/plausible.h"

#include <math.h>
#include <stdlib.h>

/* A centroid less far behind a face than this part of the block's extent says nothing of how much
 * deforms there. */
#define LEAST_DEPTH 0.05

QnStatus
qn_contacts_detect (const QnModel *model, QnContacts *contacts, QnDiag *diag)
{
  *contacts = (QnContacts){ 0 };
  if (model->block_count == 0 && model->node_count == 0)
    return QN_OK;

  QnStatus status = QN_OK;
  if (model->block_count > 0) {
    QnContactSearch search;
    qn_contact_search_init (&search, model, qn_contact_lengths (model), &contacts->room);
    if (!contacts->room.failed)
      status = qn_contact_search_all (&search, contacts, diag);
    if (status == QN_OK && !contacts->room.failed)
      status = qn_contacts_place_pairs (model, contacts, diag);
  }
  if (status == QN_OK && !contacts->room.failed) {
    qn_contacts_report_loose (model, contacts);
    qn_contacts_report_doubts (model, contacts);
  }
  if (contacts->room.failed)
    status = qn_diag_no_memory (diag);
  qn_pool_clear (&contacts->room);
  if (status != QN_OK)
    qn_contacts_clear (contacts);
  return status;
}

void
qn_contacts_report (QnContacts *contacts, QnFinding finding)
{
  QnFindings *findings = &contacts->findings;

  contacts->room.failed |=
    !QN_ARRAY_PUSH (findings->items, findings->count, findings->capacity, finding);
}

bool
qn_contacts_reserve_pairs (QnContacts *contacts, size_t count)
{
  size_t need = contacts->pair_count + count;
  bool room = need <= INT32_MAX
              && qn_array_reserve (&contacts->pairs, &contacts->pair_capacity, need,
                                   sizeof *contacts->pairs);

  contacts->room.failed |= !room;
  return room;
}

/* The first finding of a kind, or NULL. */
static const QnFinding *
first_finding (const QnFindings *findings, QnProblem problem)
{
  for (size_t i = 0; i < findings->count; i++) {
    if (findings->items[i].problem == problem)
      return &findings->items[i];
  }
  return NULL;
}

QnStatus
qn_contacts_require_sound (const QnModel *model, const QnContacts *contacts, QnDiag *diag)
{
  static const QnProblem fatal[] = { QN_PROBLEM_BLOCKS_OVERLAP, QN_PROBLEM_NO_SUPPORT,
                                     QN_PROBLEM_BLOCK_FLOATING,
                                     QN_PROBLEM_BEAM_FLOATING };
  if (model->block_count == 0 && model->beam_count == 0)
    return qn_diag_set_field (diag, QN_PROBLEM_NO_BLOCKS, QN_ENTITY_MODEL, QN_NONE,
                              "blocks", 0);
  for (size_t i = 0; i < QN_N_ELEMENTS (fatal); i++) {
    const QnFinding *finding = first_finding (&contacts->findings, fatal[i]);
    if (finding == NULL)
      continue;
    if (finding->problem == QN_PROBLEM_BEAM_FLOATING)
      qn_refuse (diag, finding->problem, QN_ENTITY_BEAM, finding->subject);
    else
      qn_diag_set_field (diag, finding->problem,
                         finding->block_a == QN_NONE ? QN_ENTITY_MODEL : QN_ENTITY_BLOCK,
                         finding->block_a, NULL, finding->value);
    if (diag != NULL) {
      diag->other = finding->block_b;
      diag->at = finding->at;
    }
    return QN_ERROR_INVALID;
  }
  return QN_OK;
}

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

double
qn_contacts_block_extent (const QnModel *model, QnId block, QnVec2 direction)
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

/* How far the side of a block reaches behind a face: to its centroid, so that the two sides together
 * reach from centroid to centroid. Where a hollow outline leaves the centroid in front of the face,
 * half of its extent. */
static double
side_length (const QnModel *model, const QnContactFace *face, int side)
{
  QnId block = side == 0 ? face->a : face->b;
  QnVec2 inwards = side == 0 ? qn_vec2_scale (-1, face->normal) : face->normal;
  QnVec2 behind = qn_vec2_sub (model->blocks[block].centroid, face->start);
  double extent = qn_contacts_block_extent (model, block, face->normal);
  double depth = qn_vec2_dot (behind, inwards);

  return depth > LEAST_DEPTH * extent ? depth : 0.5 * extent;
}

QnPairSprings
qn_contacts_pair_springs (const QnModel *model, const QnContacts *contacts, size_t pair)
{
  const QnContactPair *p = &contacts->pairs[pair];
  const QnContactFace *face = &contacts->faces[p->face];
  const QnId blocks[2] = { face->a, face->b };
  double area = p->tributary * face->thickness;
  QnSpring springs[2];
  bool rigid[2] = { false, false };

  for (int side = 0; side < 2; side++) {
    const QnLaw *law = &model->laws[qn_contacts_pair_law (model, contacts, pair, side)];
    bool by_length = law->basis == QN_BASIS_MATERIAL;
    double length =
      by_length ? side_length (model, face, side) / sqrt (1 - p->slant * p->slant) : 0;
    rigid[side] = by_length && model->blocks[blocks[side]].rigid;
    springs[side] = qn_spring_from_law (law, area, length);
    if (p->found)
      qn_spring_lose_bond (&springs[side]);
    if (p->bar != QN_NONE)
      springs[side].ks = QN_BAR_DOWEL * springs[side].kn;
  }
  /* The spring of the side that deforms stands for the whole pair. */
  QnSpring soft = springs[rigid[0] ? 1 : 0];
  QnPairSprings pair_springs = { .a = soft, .b = soft, .equal = true };
  if (rigid[0] == rigid[1])
    pair_springs = qn_pair_springs (springs[0], springs[1]);
  else if (rigid[1])
    pair_springs.b.kn = INFINITY;
  pair_springs.slant = p->slant;
  return pair_springs;
}

void
qn_contacts_clear (QnContacts *contacts)
{
  free (contacts->faces);
  free (contacts->pairs);
  free (contacts->findings.items);
  qn_pool_clear (&contacts->room);
  *contacts = (QnContacts){ 0 };
}
