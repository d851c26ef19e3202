#include "render/scene/reading.h"

#include <glib.h>

/* Share of the normal forces that is left of them in their resultant: below, it is bending with
 * rounding, and its centre is anywhere. */
#define BENDING_SHARE 1e-3

/* Part of an elongation that is no crack, but rounding. */
#define ROUNDING 1e-6

/* Part of the widest crack that is rounding of displacements. */
#define EXACT 1e-12

#define KERN_SHARE (1.0 / 6.0)
#define EDGE_SHARE (0.5 - 1.0 / 50.0)
#define BEYOND     (0.5 + 1.0 / 50.0)

QnPressurePlace
qn_pressure_place (double eccentricity, double length, double normal, double total)
{
  if (!(-normal > BENDING_SHARE * total))
    return QN_PLACE_NOWHERE;
  double share = fabs (eccentricity) / length;
  return share <= KERN_SHARE   ? QN_PLACE_KERN
         : share <= EDGE_SHARE ? QN_PLACE_INSIDE
         : share <= BEYOND     ? QN_PLACE_EDGE
                               : QN_PLACE_OUTSIDE;
}

QnJointReading
qn_joint_reading (const QnContacts *contacts, QnId index, const QnPairResult *pairs)
{
  const QnContactFace *face = &contacts->faces[index];
  QnJointReading reading = { 0 };
  double total = 0, first = 0; /* N; N m about the start */
  for (QnId k = face->first_pair; k < face->first_pair + face->pair_count; k++) {
    const QnContactPair *pair = &contacts->pairs[k];
    double area = pair->tributary * face->thickness;
    reading.normal += pairs[k].normal_force;
    reading.shear += pairs[k].shear_force;
    reading.states[pairs[k].state]++;
    total += fabs (pairs[k].normal_force);
    first += pairs[k].normal_force * pair->abscissa;
    if (area > 0)
      reading.pressure = fmin (reading.pressure, pairs[k].normal_force / area);
  }
  reading.moment = -(first - 0.5 * face->length * reading.normal);
  double s = 0.5 * face->length;
  if (fabs (reading.normal) > BENDING_SHARE * total)
    s = fmin (fmax (first / reading.normal, 0), face->length);
  double eccentricity =
    reading.normal < 0 ? first / reading.normal - 0.5 * face->length : 0;
  reading.place = qn_pressure_place (eccentricity, face->length, reading.normal, total);
  if (reading.place != QN_PLACE_NOWHERE)
    reading.eccentricity = eccentricity;
  reading.at =
    qn_vec2_lerp (face->start, face->end, face->length > 0 ? s / face->length : 0);
  return reading;
}

/* ---- cracks ---- */

static bool
may_crack (const QnLaw *law)
{
  return law->kind != QN_LAW_BILINEAR && law->kind != QN_LAW_ELASTIC_PLASTIC
         && law->kind != QN_LAW_STEEL;
}

/* What has opened at a pair that is `whole` longer than it was built; less than nothing where it is shorter. */
static double
opened_at (const QnModel *model, const QnContacts *contacts, QnId pair,
           const QnPairResult *pairs, double whole)
{
  double force = pairs != NULL ? pairs[pair].normal_force : 0, k[2];
  if (whole <= 0 || force <= 0)
    return whole;
  const QnPairSprings springs = qn_contacts_pair_springs (model, contacts, (size_t) pair);
  qn_pair_elastic_stiffness (&springs, k);
  double opened = whole - force / k[0];
  return opened > ROUNDING * (whole + force / k[0]) ? opened : 0;
}

/* The next place along a joint, which it has opened by `width` there. */
static void
add_place (QnCrack *crack, const QnContactFace *face, double from[2], double at,
           double width)
{
  double low = fmin (from[1], width), high = fmax (from[1], width);
  if (high > 0) /* a triangle where one end is closed */
    crack->mean += (at - from[0]) / face->length
                   * (low >= 0 ? 0.5 * (low + high) : 0.5 * high * high / (high - low));
  if (width > crack->width) {
    crack->width = width;
    crack->face = face;
    crack->at = qn_vec2_lerp (face->start, face->end, at / face->length);
  }
  from[0] = at;
  from[1] = width;
}

QnCrack
qn_joint_crack (const QnContacts *contacts, QnId id, const QnPairResult *pairs,
                const QnMotion *motion)
{
  const QnModel *model = motion->model;
  const QnContactFace *face = &contacts->faces[id];
  const QnJointMotion joint = qn_motion_joint (motion, face);
  const double start = joint.opening_start, end = joint.opening_end;
  QnCrack crack = { 0 };
  double from[2] = { 0, 0 };
  QnId last = QN_NONE;

  if (!(fmax (start, end) > 0)
      || !(may_crack (&model->laws[face->law_a])
           || may_crack (&model->laws[face->law_b])))
    return crack;
  for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
    double at = contacts->pairs[p].abscissa;
    if (contacts->pairs[p].bar != QN_NONE)
      continue;
    if (last == QN_NONE) {
      from[1] = opened_at (model, contacts, p, pairs, start);
      add_place (&crack, face, from, 0, from[1]);
    }
    add_place (
      &crack, face, from, at,
      opened_at (model, contacts, p, pairs, start + at / face->length * (end - start)));
    last = p;
  }
  if (last != QN_NONE)
    add_place (&crack, face, from, face->length,
               opened_at (model, contacts, last, pairs, end));
  return crack;
}

static int
compare_cracks (gconstpointer a, gconstpointer b)
{
  const QnCrack *one = a, *other = b;
  if (one->width != other->width)
    return one->width > other->width ? -1 : 1;
  return one->face < other->face ? -1 : 1;
}

GArray *
qn_result_cracks (const QnModel *model, const QnContacts *contacts,
                  const QnResult *result, size_t step)
{
  const QnMotion motion = qn_step_motion (model, result, step);
  g_autofree QnPairResult *pairs = qn_step_pairs (contacts, result, step);
  GArray *cracks = g_array_new (FALSE, FALSE, sizeof (QnCrack));
  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnCrack crack = qn_joint_crack (contacts, (QnId) f, pairs, &motion);
    if (crack.face != NULL)
      g_array_append_val (cracks, crack);
  }
  g_array_sort (cracks, compare_cracks);
  const double least =
    cracks->len > 0 ? EXACT * g_array_index (cracks, QnCrack, 0).width : 0;
  while (cracks->len > 0
         && g_array_index (cracks, QnCrack, cracks->len - 1).width <= least)
    g_array_set_size (cracks, cracks->len - 1);
  return cracks;
}

/* Relative to 1, and to the length of both faces. */
#define SAME_LINE 1e-6

bool
qn_faces_in_line (const QnContactFace *a, const QnContactFace *b)
{
  const double off = qn_vec2_dot (a->normal, qn_vec2_sub (b->start, a->start));
  return fabs (qn_vec2_cross (a->tangent, b->tangent)) <= SAME_LINE
         && fabs (off) <= SAME_LINE * (a->length + b->length);
}

GArray *
qn_cracks_by_line (const QnContacts *contacts, const GArray *cracks, guint *lines)
{
  GArray *found = g_array_new (FALSE, FALSE, sizeof (QnCrack));
  for (guint i = 0; i < cracks->len; i++) {
    QnCrack crack = g_array_index (cracks, QnCrack, i);
    const double area = crack.mean * crack.face->length;
    guint line = 0;
    while (line < found->len
           && !qn_faces_in_line (g_array_index (found, QnCrack, line).face, crack.face))
      line++;
    if (lines != NULL)
      lines[i] = line;
    crack.mean = 0;
    if (line == found->len)
      g_array_append_val (found, crack);
    g_array_index (found, QnCrack, line).mean += area;
  }
  for (guint line = 0; line < found->len; line++) {
    QnCrack *crack = &g_array_index (found, QnCrack, line);
    double length = 0;
    for (size_t f = 0; f < contacts->face_count; f++)
      if (qn_faces_in_line (crack->face, &contacts->faces[f]))
        length += contacts->faces[f].length;
    crack->mean /= length;
  }
  return found;
}

/* ---- blocks ---- */

/* The mean stress of a block follows from the forces on its boundary,
 * sigma = (1/V) sum f (x) r (Love 1927, Weber 1966); its sums stand in `stress` until they are
 * divided by the volume. */
static void
add_stress (QnBlockReading *reading, QnVec2 r, QnVec2 f)
{
  reading->stress[0] += f.x * r.x;
  reading->stress[1] += f.y * r.y;
  reading->stress[2] += 0.5 * (f.x * r.y + f.y * r.x);
}

static void
add_force (QnBlockReading *reading, const QnBlock *block, QnVec2 at, QnVec2 f)
{
  QnVec2 r = qn_vec2_sub (at, block->centroid);
  reading->force = qn_vec2_add (reading->force, f);
  reading->moment += qn_vec2_cross (r, f);
  add_stress (reading, r, f);
}

/* The forces of a face on the block on one of its sides. */
static void
add_face_reading (QnBlockReading *reading, const QnModel *model,
                  const QnContacts *contacts, const QnContactFace *face,
                  const QnPairResult *pairs, QnId block)
{
  double sign = block == face->a ? 1 : -1;
  for (QnId k = face->first_pair; k < face->first_pair + face->pair_count; k++) {
    QnVec2 f = qn_vec2_add (qn_vec2_scale (sign * pairs[k].normal_force, face->normal),
                            qn_vec2_scale (sign * pairs[k].shear_force, face->tangent));
    add_force (reading, &model->blocks[block], contacts->pairs[k].point, f);
  }
}

QnBlockReading *
qn_block_readings (const QnModel *model, const QnContacts *contacts,
                   const QnPairResult *pairs, const QnTouch *touches, size_t touch_count,
                   const double *factors)
{
  QnBlockReading *readings = g_new0 (QnBlockReading, MAX (model->block_count, 1));
  if (factors != NULL) {
    /* The forces of loads, each on the reading of its block. */
    for (size_t i = 0; i < qn_model_acting_count (model); i++) {
      const QnLoad load = qn_model_acting_load (model, i);
      if (load.kind != QN_LOAD_FORCE)
        continue;
      double factor = load.set == QN_NONE ? 1 : factors[load.set];
      add_stress (&readings[load.block], qn_model_load_arm (model, &load),
                  qn_vec2_scale (factor, load.vector));
    }
  }
  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    add_face_reading (&readings[face->a], model, contacts, face, pairs, face->a);
    add_face_reading (&readings[face->b], model, contacts, face, pairs, face->b);
  }
  for (size_t i = 0; i < touch_count; i++)
    for (int side = 0; side < 2; side++) {
      const QnId block = touches[i].block[side];
      add_force (&readings[block], &model->blocks[block], touches[i].at[side],
                 touches[i].on[side]);
    }
  for (size_t i = 0; i < model->block_count; i++) {
    double volume = model->blocks[i].area * model->blocks[i].thickness;
    for (int k = 0; k < 3; k++)
      readings[i].stress[k] /= volume;
    double middle = 0.5 * (readings[i].stress[0] + readings[i].stress[1]);
    double radius = hypot (0.5 * (readings[i].stress[0] - readings[i].stress[1]),
                           readings[i].stress[2]);
    readings[i].principal[0] = middle - radius;
    readings[i].principal[1] = middle + radius;
  }
  return readings;
}

/* ---- a step ---- */

QnPairResult *
qn_step_pairs (const QnContacts *contacts, const QnResult *result, size_t step)
{
  if (result->pair_count != contacts->pair_count || result->pairs == NULL
      || !qn_result_has_forces (result, step))
    return NULL;
  QnPairResult *pairs = g_new (QnPairResult, MAX (result->pair_count, 1));
  for (size_t p = 0; p < result->pair_count; p++)
    pairs[p] = qn_result_pair_at (result, step, p);
  return pairs;
}

static QnTouch
read_touch (const QnModel *model, const QnResult *result, const QnFoundForce *force,
            const double *displacements)
{
  const QnFoundContact *contact = &result->found[force->found].contact;
  const double *u = displacements + (size_t) contact->block * QN_DOF_COUNT;
  const double *v = displacements + (size_t) contact->other * QN_DOF_COUNT;
  QnVec2 corner = qn_found_corner (model, contact);
  double turn = u[QN_DOF_RZ], turned = v[QN_DOF_RZ];
  QnVec2 place = qn_block_place (model, contact->other, displacements, corner);
  QnVec2 on = qn_found_force (model, contact, force, NULL);
  return (QnTouch){
    .found = force->found,
    .block = { contact->block, contact->other },
    .at = { qn_block_unplace (model, contact->block, displacements, place), corner },
    .on = { on, qn_vec2_scale (
                  -1, qn_vec2_rotate (on, cos (turn - turned), sin (turn - turned))) },
    .normal = qn_found_normal (model, contact),
    .force = force->normal,
    .shear = force->shear,
  };
}

QnTouch *
qn_step_touches (const QnModel *model, const QnResult *result, size_t step, size_t *count)
{
  const QnFoundForce *forces = qn_step_found (result, step, count);
  QnTouch *touches = g_new (QnTouch, *count + 1);
  for (size_t i = 0; i < *count; i++)
    touches[i] =
      read_touch (model, result, &forces[i], qn_result_step_displacements (result, step));
  return touches;
}

bool *
qn_step_left (const QnContacts *contacts, const QnResult *result, size_t step)
{
  bool *left = NULL;
  for (size_t i = 0; i < result->left_count; i++) {
    if (result->left[i].time > result->steps[step].time
        || (size_t) result->left[i].face >= contacts->face_count)
      continue;
    if (left == NULL)
      left = g_new0 (bool, contacts->face_count);
    left[result->left[i].face] = true;
  }
  return left;
}
