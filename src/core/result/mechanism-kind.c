#include "core/result/mechanism.h"

#include <math.h>

/* A way of moving prevails where so much of all moving blocks belong to bodies that move so. */
#define PREVAILING 0.7

/* A body with this share of all moving blocks is a pier. */
#define PIER_SHARE 0.18

/* Joints meet where their ends are nearer than this part of the characteristic block length. */
#define MEETING 0.2

/* A joint is inclined where its normal deviates from the level and the vertical by more than this
 * sine. */
#define INCLINED 0.1

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
  [QN_MECHANISM_KIND_SWAYING] = "swaying",
  [QN_MECHANISM_KIND_MIXED] = "mixed",
};

static bool
is_hinge (const QnJointMotion *joint)
{
  return joint->kind == QN_JOINT_HINGE_START || joint->kind == QN_JOINT_HINGE_END;
}

/* A bed that a body leaves: what it stands on stays behind, or moves otherwise. */
static bool
is_tread (const QnMechanism *m, const QnContacts *contacts, size_t f, QnId body)
{
  const QnContactFace *face = &contacts->faces[f];
  QnId a = m->body_of_block[face->a], b = m->body_of_block[face->b];

  return m->joints[f].kind != QN_JOINT_CLOSED && a != b
         && fabs (face->normal.y) >= fabs (face->normal.x)
         && (face->normal.y > 0.0 ? b : a) == body;
}

/* Whether such a bed ends at the head joint `riser`, at its foot or beneath it, or at its head or
 * above; and to which side it extends from there: -1, 1, or 0 where it does not. */
static int
tread_side (const QnContactFace *tread, const QnContactFace *riser, bool above,
            double near)
{
  bool up = riser->end.y > riser->start.y;
  QnVec2 end = up == above ? riser->end : riser->start;
  double low = fmin (tread->start.x, tread->end.x);
  double high = fmax (tread->start.x, tread->end.x);
  double y = 0.5 * (tread->start.y + tread->end.y);

  if (above ? y < end.y - near : y > end.y + near)
    return 0;
  return fabs (low - end.x) < near ? 1 : fabs (high - end.x) < near ? -1 : 0;
}

/* Whether a body leaves what is beneath it along a step: two of its beds lie to either side of a head
 * joint that opens, one at its foot and one at its head. */
static bool
leaves_step (const QnMechanism *m, const QnContacts *contacts, const QnContactFace *riser,
             QnId body, double near)
{
  bool treads[2][2] = { { false } }; /* beneath and above, to the left and to the right */

  for (size_t f = 0; f < m->joint_count; f++)
    for (int above = 0; above < 2 && is_tread (m, contacts, f, body); above++) {
      int side = tread_side (&contacts->faces[f], riser, above, near);
      if (side != 0)
        treads[above][side > 0] = true;
    }
  return (treads[0][0] && treads[1][1]) || (treads[0][1] && treads[1][0]);
}

/* Whether a body leaves a staircase. Courses that slide over each other have no head joint that opens,
 * a part that stands on two levels has none between them. */
static bool
is_stepped (const QnMechanism *m, const QnModel *model, const QnContacts *contacts)
{
  double near = MEETING * model->characteristic_length;

  for (size_t f = 0; f < m->joint_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    QnId a = m->body_of_block[face->a], b = m->body_of_block[face->b];
    bool opens =
      m->joints[f].kind != QN_JOINT_CLOSED && m->joints[f].kind != QN_JOINT_SLIDING;
    if (opens && fabs (face->normal.y) < fabs (face->normal.x) && a != b
        && ((a != QN_NONE && leaves_step (m, contacts, face, a, near))
            || (b != QN_NONE && leaves_step (m, contacts, face, b, near))))
      return true;
  }
  return false;
}

/* Bodies that turn against each other in alternating senses, one hinge more than bodies or so: a
 * chain that folds. Rings upon each other have more hinges, for they slide over each other as they
 * fold: they are told from walls by joints that mostly lie neither level nor upright, and by large
 * parts that turn either way. */
static bool
is_folding (const QnMechanism *m, const QnContacts *contacts, int32_t moving)
{
  int32_t hinges = m->counts[QN_JOINT_HINGE_START] + m->counts[QN_JOINT_HINGE_END];
  int32_t opposite = 0, alike = 0, inclined = 0, turning[2] = { 0, 0 };

  if (hinges < CHAIN_HINGES || m->body_count < 2)
    return false;
  for (size_t f = 0; f < m->joint_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    QnId a = m->body_of_block[face->a], b = m->body_of_block[face->b];
    if (!is_hinge (&m->joints[f]))
      continue;
    inclined += fmin (fabs (face->normal.x), fabs (face->normal.y)) > INCLINED;
    if (a == QN_NONE || b == QN_NONE)
      continue;
    if (m->bodies[a].turns && m->bodies[b].turns
        && m->bodies[a].rotation * m->bodies[b].rotation < 0.0)
      opposite++;
    else
      alike++;
  }
  for (size_t i = 0; i < m->body_count; i++)
    if (m->bodies[i].turns)
      turning[m->bodies[i].rotation > 0.0] += m->bodies[i].block_count;
  return (opposite > alike && hinges <= (int32_t) m->body_count + 2)
         || (2 * inclined > hinges && turning[0] >= PIER_SHARE * moving
             && turning[1] >= PIER_SHARE * moving);
}

/* Large bodies that turn in the sense of the largest that turns: piers, where there are several. */
static int32_t
count_piers (const QnMechanism *m, int32_t moving)
{
  double sense = 0.0;
  int32_t piers = 0;

  for (size_t i = 0; i < m->body_count; i++) {
    const QnMechanismBody *body = &m->bodies[i];
    if (!body->turns || body->block_count < PIER_SHARE * moving)
      continue;
    sense = piers == 0 ? body->rotation : sense;
    piers += body->rotation * sense > 0.0;
  }
  return piers;
}

/* Whether a joint slides more than it opens: rocking bodies slip a little at their hinges. */
static bool
slides_foremost (const QnMechanism *m)
{
  for (size_t f = 0; f < m->joint_count; f++) {
    const QnJointMotion *joint = &m->joints[f];
    if (joint->slides
        && fabs (joint->slip) > fmax (joint->opening_start, joint->opening_end))
      return true;
  }
  return false;
}

static QnMechanismKind
classify_turning (const QnMechanism *m, const QnModel *model, const QnContacts *contacts,
                  int32_t moving)
{
  if (is_folding (m, contacts, moving))
    return QN_MECHANISM_KIND_ARCH;
  if (count_piers (m, moving) > 1)
    return QN_MECHANISM_KIND_ROCKING;
  if (is_stepped (m, model, contacts))
    return QN_MECHANISM_KIND_STEPPED;
  if (m->body_count == 1)
    return QN_MECHANISM_KIND_OVERTURNING;
  return slides_foremost (m) ? QN_MECHANISM_KIND_MIXED : QN_MECHANISM_KIND_ROCKING;
}

static bool
goes_aside (const QnMechanismBody *body)
{
  return fabs (body->velocity.y) < 2.0 * fabs (body->velocity.x);
}

/* Whether blocks go aside though no joint hinges, slides or opens. */
static bool
sways (const QnMechanism *m)
{
  for (size_t i = 0; i < m->body_count; i++)
    if (goes_aside (&m->bodies[i]))
      return m->counts[QN_JOINT_OPENING] == 0;
  return false;
}

/* Whether blocks are lifted or fall: they go up or down, and every joint parts that does not stay
 * closed. The sides of a joint that opens, but not as its law or associative friction dilates it,
 * press each other no more, however far they slip. */
static bool
loses_contact (const QnMechanism *m, const QnModel *model, const QnContacts *contacts)
{
  for (size_t i = 0; i < m->body_count; i++)
    if (goes_aside (&m->bodies[i]))
      return false;
  for (size_t f = 0; f < m->joint_count; f++) {
    const QnJointMotion *joint = &m->joints[f];
    const QnContactFace *face = &contacts->faces[f];
    double slip = fabs (joint->slip);
    double opening = fmin (joint->opening_start, joint->opening_end);
    double friction =
      fmax (model->laws[face->law_a].friction, model->laws[face->law_b].friction);
    if (joint->kind == QN_JOINT_SLIDING
        && (opening < (fmax (model->laws[face->law_a].dilatancy,
                             model->laws[face->law_b].dilatancy)
                       + QN_JOINT_PARTING)
                        * slip
            || fabs (opening - friction * slip) < QN_JOINT_PARTING * slip))
      return false;
  }
  return true;
}

QnMechanismKind
qn_mechanism_classify (const QnMechanism *m, const QnModel *model,
                       const QnContacts *contacts)
{
  int32_t hinges = m->counts[QN_JOINT_HINGE_START] + m->counts[QN_JOINT_HINGE_END];
  int32_t turning_blocks = 0, moving = 0;

  if (m->body_count == 0)
    return QN_MECHANISM_KIND_NONE;
  if (hinges == 0 && m->sliding_count == 0)
    return sways (m) ? QN_MECHANISM_KIND_SWAYING : QN_MECHANISM_KIND_FALLING;
  for (size_t i = 0; i < m->body_count; i++) {
    moving += m->bodies[i].block_count;
    if (m->bodies[i].turns)
      turning_blocks += m->bodies[i].block_count;
  }
  double turning = (double) turning_blocks / moving;
  if (hinges == 0 && turning_blocks == 0 && loses_contact (m, model, contacts))
    return QN_MECHANISM_KIND_FALLING;
  if (hinges > 0 && (turning >= PREVAILING || !slides_foremost (m)))
    return classify_turning (m, model, contacts, moving);
  /* Friction on beds alone resists what goes straight on: of beds on one level or on several, however
   * many head joints part behind it, the multiplier is the same. */
  if (turning <= 1.0 - PREVAILING && m->sliding_count > 0)
    return QN_MECHANISM_KIND_SLIDING;
  return QN_MECHANISM_KIND_MIXED;
}
