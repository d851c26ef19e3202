#include "core/result/mechanism.h"

#include <math.h>

/* A way of moving prevails where so much of all moving blocks belong to bodies that move so. */
#define PREVAILING 0.7

/* A body with this share of all moving blocks is a pier. */
#define PIER_SHARE 0.18

/* Joints lie on one line where they deviate by less than this part of the characteristic block
 * length, and their normals by less than this sine. */
#define SAME_LEVEL     0.2
#define SAME_DIRECTION 0.1

/* A folding chain needs this many hinges: three make a statically determined arch. */
#define CHAIN_HINGES 4

const char *const qn_mechanism_kind_names[QN_MECHANISM_KIND_COUNT] = {
  [QN_MECHANISM_KIND_NONE] = "none",
  [QN_MECHANISM_KIND_OVERTURNING] = "overturning",
  [QN_MECHANISM_KIND_ROCKING] = "rocking",
  [QN_MECHANISM_KIND_SLIDING] = "sliding",
  [QN_MECHANISM_KIND_STEPPED] = "stepped",
  [QN_MECHANISM_KIND_ARCH] = "arch",
  [QN_MECHANISM_KIND_FALLING] = "falling",
  [QN_MECHANISM_KIND_MIXED] = "mixed",
};

static bool
is_hinge (const QnJointMotion *joint)
{
  return joint->kind == QN_JOINT_HINGE_START || joint->kind == QN_JOINT_HINGE_END;
}

static bool
same_line (const QnContactFace *a, const QnContactFace *b, double length)
{
  QnVec2 between = qn_vec2_sub (b->start, a->start);

  return fabs (qn_vec2_cross (a->normal, b->normal)) < SAME_DIRECTION
         && fabs (qn_vec2_dot (between, a->normal)) < SAME_LEVEL * length;
}

/* Whether a body leaves what is beneath it along a staircase: beds of its foot that move lie on more
 * than one line, and a head joint of it opens between them. Courses that slide over each other have
 * beds on many lines, but no head joint that opens. */
static bool
leaves_steps (const QnMechanism *m, const QnModel *model, const QnContacts *contacts,
              QnId body)
{
  const QnContactFace *first = NULL;
  bool treads = false, risers = false;

  for (size_t f = 0; f < m->joint_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    const QnJointMotion *joint = &m->joints[f];
    QnId a = m->body_of_block[face->a], b = m->body_of_block[face->b];
    if (joint->kind == QN_JOINT_CLOSED || (a != body && b != body) || a == b)
      continue;
    if (fabs (face->normal.y) < fabs (face->normal.x)) /* a head joint */
      risers |= joint->kind != QN_JOINT_SLIDING;
    else if ((face->normal.y > 0.0 ? b : a) == body) { /* which stands on the other one */
      treads |= first && !same_line (first, face, model->characteristic_length);
      first = first ? first : face;
    }
  }
  return treads && risers;
}

static bool
is_stepped (const QnMechanism *m, const QnModel *model, const QnContacts *contacts)
{
  for (size_t i = 0; i < m->body_count; i++)
    if (leaves_steps (m, model, contacts, (QnId) i))
      return true;
  return false;
}

/* Bodies that turn against each other in alternating senses, one hinge more than bodies or so: a
 * chain that folds. */
static bool
is_folding (const QnMechanism *m, const QnContacts *contacts)
{
  int32_t hinges = m->counts[QN_JOINT_HINGE_START] + m->counts[QN_JOINT_HINGE_END];
  int32_t opposite = 0, alike = 0;

  if (hinges < CHAIN_HINGES || m->body_count < 2)
    return false;
  for (size_t f = 0; f < m->joint_count; f++) {
    QnId a = m->body_of_block[contacts->faces[f].a];
    QnId b = m->body_of_block[contacts->faces[f].b];
    if (!is_hinge (&m->joints[f]) || a == QN_NONE || b == QN_NONE)
      continue;
    if (m->bodies[a].rotation * m->bodies[b].rotation < 0.0)
      opposite++;
    else
      alike++;
  }
  return opposite > alike && hinges <= (int32_t) m->body_count + 2;
}

/* Large bodies that turn in the sense of the largest: piers, where there are several. */
static int32_t
count_piers (const QnMechanism *m)
{
  int32_t moving = 0, piers = 0;

  for (size_t i = 0; i < m->body_count; i++)
    moving += m->bodies[i].block_count;
  for (size_t i = 0; i < m->body_count; i++) {
    const QnMechanismBody *body = &m->bodies[i];
    if (body->turns && body->rotation * m->bodies[0].rotation > 0.0
        && body->block_count >= PIER_SHARE * moving)
      piers++;
  }
  return piers;
}

static QnMechanismKind
classify_turning (const QnMechanism *m, const QnModel *model, const QnContacts *contacts)
{
  if (is_folding (m, contacts))
    return QN_MECHANISM_KIND_ARCH;
  if (count_piers (m) > 1)
    return QN_MECHANISM_KIND_ROCKING;
  if (is_stepped (m, model, contacts))
    return QN_MECHANISM_KIND_STEPPED;
  return m->body_count == 1 ? QN_MECHANISM_KIND_OVERTURNING : QN_MECHANISM_KIND_MIXED;
}

QnMechanismKind
qn_mechanism_classify (const QnMechanism *m, const QnModel *model,
                       const QnContacts *contacts)
{
  int32_t hinges = m->counts[QN_JOINT_HINGE_START] + m->counts[QN_JOINT_HINGE_END];
  int32_t turning_blocks = 0, moving_blocks = 0;

  if (m->body_count == 0)
    return QN_MECHANISM_KIND_NONE;
  if (hinges == 0 && m->sliding_count == 0)
    return QN_MECHANISM_KIND_FALLING;
  for (size_t i = 0; i < m->body_count; i++) {
    moving_blocks += m->bodies[i].block_count;
    if (m->bodies[i].turns)
      turning_blocks += m->bodies[i].block_count;
  }
  double turning = (double) turning_blocks / moving_blocks;
  if (turning >= PREVAILING && hinges > 0)
    return classify_turning (m, model, contacts);
  if (turning <= 1.0 - PREVAILING && m->sliding_count > 0)
    return is_stepped (m, model, contacts) ? QN_MECHANISM_KIND_STEPPED
                                           : QN_MECHANISM_KIND_SLIDING;
  return QN_MECHANISM_KIND_MIXED;
}
