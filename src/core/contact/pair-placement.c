#include "core/contact/contact-search.h"

#include "core/contact/contact-bars.h"
#include "core/contact/contact-follow.h"
#include "core/contact/pair-abscissae.h"

/* What pairs may make of the bending stiffness and of the moment of a crushed joint before that is a
 * finding. Two evenly spaced pairs have 3/4 of the stiffness, two Gauss points 1.15 times the moment. */
static const double least_bending = 0.8, most_bending = 1.25, most_crushing = 1.1;

/* Sine of the angle between two faces of a block from which on its neighbours lie in two directions. */
#define SIDEWAYS 0.5

static QnId
law_of_side (const QnModel *model, QnId block, QnId other,
             const QnFaceOverride *exception)
{
  return exception != NULL && exception->law != QN_NONE
           ? exception->law
           : qn_model_side_law (model, block, other);
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

static QnStatus
place_pairs (QnContacts *contacts, size_t index, const QnPairRule *rule, QnDiag *diag)
{
  QnContactFace *face = &contacts->faces[index];
  size_t count = qn_pair_rule_count (rule);

  if (rule->placement == QN_PLACEMENT_ENDS && 2 * rule->offset >= face->length)
    return refuse (face, QN_PROBLEM_PAIR_OFFSET_TOO_LARGE, diag);
  if (!qn_contacts_reserve_pairs (contacts, count))
    return QN_OK;
  face->first_pair = (QnId) contacts->pair_count;
  face->pair_count = (int32_t) count;
  for (size_t i = 0; i < count; i++) {
    double position, weight;
    qn_pair_rule_place (rule, face->length, i, &position, &weight);
    contacts->pairs[contacts->pair_count++] = (QnContactPair){
      .face = (QnId) index,
      .point = qn_vec2_lerp (face->start, face->end, position),
      .abscissa = position * face->length,
      .tributary = weight * face->length,
      .bar = QN_NONE,
    };
  }
  return QN_OK;
}

/* Whether the kinds of law of both springs of a pair may soften. */
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

/* Whether a joint is all by contact, by area, or by material. */
static bool
is_of_one_basis (const QnModel *model, const QnContactFace *face)
{
  return model->laws[face->law_a].basis == model->laws[face->law_b].basis;
}

/* Refuses a joint by material whose two sides do not deform, and springs that would snap back. */
static QnStatus
check_springs (const QnModel *model, const QnContacts *contacts, QnId index, QnDiag *diag)
{
  const QnContactFace *face = &contacts->faces[index];
  const QnBlock *a = &model->blocks[face->a], *b = &model->blocks[face->b];

  if (a->rigid && b->rigid && is_of_one_basis (model, face)
      && model->laws[face->law_a].basis == QN_BASIS_MATERIAL
      && !(qn_support_is_full (a->support) && qn_support_is_full (b->support)))
    return refuse (face, QN_PROBLEM_RIGID_JOINT, diag);
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

/* Counts a face in the finding, which is at the worst one: furthest from 1. */
static void
count_in (QnFinding *finding, const QnContactFace *face, double value)
{
  finding->subject++;
  if (finding->block_a != QN_NONE && fabs (log (value)) <= fabs (log (finding->value)))
    return;
  finding->block_a = face->a;
  finding->block_b = face->b;
  finding->at = qn_vec2_lerp (face->start, face->end, 0.5);
  finding->value = value;
}

/* The law that says how many pairs a face has where the rule does not: stiffness per pair is that of a
 * pair at an end, and crushing needs more of them. */
static const QnLaw *
deciding_law (const QnModel *model, const QnContactFace *face)
{
  const QnLaw *a = &model->laws[face->law_a], *b = &model->laws[face->law_b];

  if ((a->basis == QN_BASIS_CONTACT) != (b->basis == QN_BASIS_CONTACT))
    return a->basis == QN_BASIS_CONTACT ? a : b;
  return qn_law_yields (a->kind) ? a : b;
}

/* Everything about the pairs of one face. */
static QnStatus
furnish_face (const QnModel *model, QnContacts *contacts, size_t index,
              const QnFaceOverride *exception, QnBarSearch *bars, QnFinding judged[2],
              QnDiag *diag)
{
  QnContactFace *face = &contacts->faces[index];
  bool own_pairs = exception != NULL && exception->has_pairs;

  face->law_a = law_of_side (model, face->a, face->b, exception);
  face->law_b = law_of_side (model, face->b, face->a, exception);
  QnPairRule rule = qn_pair_rule_by_law (
    own_pairs ? &exception->pairs : &model->contact.pairs, deciding_law (model, face));
  QnStatus status = place_pairs (contacts, index, &rule, diag);
  if (status != QN_OK)
    return status;
  /* What the pairs misstate. Bending stiffness counts in large displacements;
   * Gauss-Lobatto pairs have that of the face between its rounded edges. */
  const QnLaw *a = &model->laws[face->law_a], *b = &model->laws[face->law_b];
  bool per_pair = a->basis == QN_BASIS_CONTACT || b->basis == QN_BASIS_CONTACT;
  if (!per_pair && model->analysis.geometry == QN_GEOMETRY_NONLINEAR
      && rule.placement != QN_PLACEMENT_LOBATTO) {
    double stiffness = qn_pair_rule_bending (&rule, face->length);
    if (stiffness < least_bending || stiffness > most_bending)
      count_in (&judged[0], face, stiffness);
  }
  if (qn_law_yields (a->kind) || qn_law_yields (b->kind)) {
    double moment = qn_pair_rule_crushing (&rule, face->length, per_pair);
    if (moment > most_crushing)
      count_in (&judged[1], face, moment);
  }
  qn_bar_search_cross (bars, model, contacts, (QnId) index);
  return check_springs (model, contacts, (QnId) index, diag);
}

/* What laws are used for: the sides of faces with each, and those that make its blocks have neighbours in
 * two directions. */
typedef struct LawUse {
  QnId block; /* the first; of a chain the first with neighbours in two directions */
  size_t sides, sideways;
} LawUse;

static void
report_use (QnContacts *contacts, const QnLaw *law, QnId id, const LawUse *use)
{
  const bool chain = law->arrangement == QN_ARRANGEMENT_CHAIN;
  QnFinding finding = { .block_a = use->block,
                        .block_b = QN_NONE,
                        .subject = id,
                        .problem = chain ? QN_PROBLEM_LAW_CHAIN : QN_PROBLEM_LAW_GRID };

  if (use->sides > 0 && law->elasticity > 0 && chain == (use->sideways > 0))
    qn_contacts_report (contacts, finding);
  finding.problem = QN_PROBLEM_LAW_SHEAR;
  if (qn_law_yields (law->kind) && !qn_law_may_bond (law->kind)
      && 4 * use->sideways > use->sides)
    qn_contacts_report (contacts, finding);
}

/* A face of a block, the first one of those with its law. */
typedef struct FirstFace {
  QnVec2 normal;
  QnId law;
} FirstFace;

/* How the blocks lie that laws join. It is a finding of the first block where a law of a chain joins blocks
 * that have neighbours in two directions, or one of a grid blocks where none has; and where many blocks of
 * a law that is elastic in shear have, which is more than the corners of frames. */
static void
judge_arrangements (const QnModel *model, QnContacts *contacts)
{
  FirstFace *first = qn_pool_alloc (&contacts->room, model->block_count, sizeof *first);
  LawUse *uses = qn_pool_alloc (&contacts->room, model->law_count, sizeof *uses);

  if (contacts->room.failed)
    return;
  for (size_t i = 0; i < 2 * contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i / 2];
    QnId block = i % 2 == 0 ? face->a : face->b;
    QnId id = i % 2 == 0 ? face->law_a : face->law_b;
    LawUse *use = &uses[id];
    if (model->blocks[block].rigid || !is_of_one_basis (model, face))
      continue;
    if (use->sides++ == 0)
      use->block = block;
    if (qn_vec2_length (first[block].normal) == 0)
      first[block] = (FirstFace){ face->normal, id };
    else if (first[block].law == id
             && fabs (qn_vec2_cross (first[block].normal, face->normal)) > SIDEWAYS
             && use->sideways++ == 0
             && model->laws[id].arrangement == QN_ARRANGEMENT_CHAIN)
      use->block = block;
  }
  for (size_t i = 0; i < model->law_count; i++)
    report_use (contacts, &model->laws[i], (QnId) i, &uses[i]);
}

QnStatus
qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts, QnDiag *diag)
{
  const QnFaceOverride **own =
    qn_pool_alloc (&contacts->room, contacts->face_count, sizeof *own);
  QnStatus status = QN_OK;
  QnBarSearch bars;
  QnFinding judged[2] = {
    { .problem = QN_PROBLEM_PAIRS_BENDING, .block_a = QN_NONE, .block_b = QN_NONE },
    { .problem = QN_PROBLEM_PAIRS_CRUSHING, .block_a = QN_NONE, .block_b = QN_NONE },
  };

  qn_bar_search_init (&bars, model, &contacts->room);
  if (own != NULL) {
    /* Fills the exception of each face, NULL where there is none; of two for the same
     * blocks the later one counts. Those without a face are findings. */
    for (size_t i = 0; i < model->override_count; i++) {
      const QnFaceOverride *override = &model->overrides[i];
      QnId a = override->block_a, b = override->block_b;
      size_t face, end;
      if (a > b)
        a = override->block_b, b = override->block_a;
      QnVec2 at =
        qn_vec2_lerp (model->blocks[a].centroid, model->blocks[b].centroid, 0.5);
      qn_contacts_between (contacts, a, b, &face, &end);
      if (face == end)
        qn_contacts_tell (contacts, QN_PROBLEM_OVERRIDE_UNUSED, a, b, QN_NONE, at, 0);
      for (; face < end; face++)
        own[face] = override;
    }
  }
  for (size_t i = 0;
       i < contacts->face_count && status == QN_OK && !contacts->room.failed; i++)
    status = furnish_face (model, contacts, i, own[i], &bars, judged, diag);
  if (status == QN_OK && !contacts->room.failed)
    status = qn_bar_search_finish (&bars, model, contacts, diag);
  for (size_t i = 0; i < QN_N_ELEMENTS (judged); i++)
    if (judged[i].block_a != QN_NONE)
      qn_contacts_report (contacts, judged[i]);
  if (status == QN_OK)
    judge_arrangements (model, contacts);
  return status;
}
