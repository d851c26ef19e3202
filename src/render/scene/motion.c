#include "render/scene/motion.h"

#include "render/drawing/camera.h"
#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>

/* Fraction of the structure's diagonal that the fastest point moves in a drawing, and the most that a block
 * turns, rad; farther, where a small block would not be seen to move else. */
#define AUTO_SHARE    (1.0 / 12.0)
#define AUTO_ROTATION 0.25
#define LEAST_SHARE   (1.0 / 40.0)
#define MOST_ROTATION 0.6

/* Share of the largest joint motion below which a joint counts as closed. */
#define JOINT_SHARE 0.02

/* Share of the largest displacement below which a joint's motion is not seen: a twelfth of the
 * diagonal is drawn of that displacement, of the joint a four-hundredth. */
#define SEEN_SHARE 0.03

/* A point that moves with a body about its centroid *c, which moves too. */
static QnVec2
displace (QnVec2 *c, QnVec2 p, const double *u, double scale, bool linear)
{
  QnVec2 arm = qn_vec2_sub (p, *c);
  double angle = scale * u[QN_DOF_RZ];
  QnVec2 turned = linear ? qn_vec2_add_scaled (arm, angle, qn_vec2_perp (arm))
                         : qn_vec2_rotate (arm, cos (angle), sin (angle));
  QnVec2 way = qn_vec2 (scale * u[QN_DOF_UX], scale * u[QN_DOF_UY]);
  QnVec2 moved = qn_vec2_add (qn_vec2_add (*c, turned), way);
  *c = qn_vec2_add (*c, way);
  return moved;
}

QnVec2
qn_motion_place (const QnMotion *motion, QnId block, QnVec2 p, double scale)
{
  const size_t row = (size_t) block * QN_DOF_COUNT;
  if (motion->displacements == NULL && motion->base == NULL)
    return p;
  QnVec2 c = motion->model->blocks[block].centroid;
  if (motion->base != NULL)
    p = displace (&c, p, motion->base + row, 1, false);
  if (motion->displacements != NULL)
    p = displace (&c, p, motion->displacements + row, scale, motion->linear);
  return p;
}

static QnMotion
moves_of (const QnMotion *motion)
{
  QnMotion own = *motion;
  own.base = NULL;
  return own;
}

double
qn_motion_of_block (const QnMotion *motion, QnId block)
{
  const QnVec2 *v = qn_model_block_vertices (motion->model, block);
  const QnMotion own = moves_of (motion);
  double largest = 0;
  for (QnId i = 0; i < motion->model->blocks[block].vertex_count; i++) {
    QnVec2 moved = qn_motion_place (&own, block, v[i], 1);
    largest = fmax (largest, qn_vec2_length (qn_vec2_sub (moved, v[i])));
  }
  return largest;
}

double
qn_motion_largest (const QnMotion *motion)
{
  double largest = 0;
  for (size_t b = 0; b < motion->model->block_count; b++)
    largest = fmax (largest, qn_motion_of_block (motion, (QnId) b));
  for (size_t n = 0; motion->displacements != NULL && n < motion->model->node_count;
       n++) {
    const double *u =
      motion->displacements + QN_DOF_COUNT * (motion->model->block_count + n);
    largest = fmax (largest, hypot (u[QN_DOF_UX], u[QN_DOF_UY]));
  }
  return largest;
}

double
qn_motion_auto_scale (const QnMotion *motion)
{
  const QnModel *model = motion->model;
  QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  double turn = 0;
  for (size_t i = 0; i < model->node_count; i++)
    qn_box_add_point (&box, model->nodes[i].at);
  for (size_t b = 0; motion->displacements != NULL && b < model->block_count; b++)
    turn = fmax (turn, fabs (motion->displacements[b * QN_DOF_COUNT + QN_DOF_RZ]));

  double largest = qn_motion_largest (motion);
  double scale = AUTO_SHARE * qn_box_diagonal (box) / largest;
  double seen = LEAST_SHARE / AUTO_SHARE * scale;
  if (turn > 0)
    scale = fmin (scale, fmax (AUTO_ROTATION / turn, fmin (seen, MOST_ROTATION / turn)));
  if (!(largest > 0) || !isfinite (scale) || scale <= 0)
    return 1;

  double power = pow (10, floor (log10 (scale)) - 1);
  return floor (scale / power) * power;
}

/* The step of a result (of at least one) whose blocks and nodes have moved farthest: a factor that
 * fits it fits all steps, so that they can be compared. */
static size_t
farthest_step (const QnModel *model, const QnResult *result)
{
  size_t rows = qn_result_body_count (result), farthest = 0;
  double largest = -1;
  for (size_t s = 0; s < result->step_count; s++) {
    const double *u = qn_result_step_displacements (result, s);
    double moved = 0;
    for (size_t r = 0; r < rows; r++, u += QN_DOF_COUNT)
      moved = fmax (moved, hypot (u[QN_DOF_UX], u[QN_DOF_UY])
                             + model->characteristic_length * fabs (u[QN_DOF_RZ]));
    /* The last of those alike: the end of a run is what is looked at first. */
    if (moved >= largest) {
      largest = moved;
      farthest = s;
    }
  }
  return farthest;
}

QnMotion
qn_step_motion (const QnModel *model, const QnResult *result, size_t step)
{
  return (QnMotion){ .model = model,
                     .displacements = step < result->step_count
                                        ? qn_result_step_displacements (result, step)
                                        : NULL,
                     .linear = model->analysis.geometry == QN_GEOMETRY_LINEAR,
                     .scale = 1 };
}

double
qn_motion_result_scale (const QnModel *model, const QnResult *result)
{
  if (result->step_count == 0)
    return 1;
  size_t step = farthest_step (model, result);
  bool linear = model->analysis.geometry == QN_GEOMETRY_LINEAR;
  const QnMotion motion = qn_step_motion (model, result, step);
  double scale = qn_motion_auto_scale (&motion);
  return linear && result->history.width == 0 ? scale : fmax (scale, 1);
}

char *
qn_motion_dup_scale (double scale)
{
  g_autofree char *number = qn_label_number ("%g", scale);
  return scale == 1 ? g_strdup (_ ("displacements in true scale"))
                    : g_strdup_printf (_ ("displacements × %s"), number);
}

QnJointMotion
qn_motion_joint (const QnMotion *motion, const QnContactFace *face)
{
  QnVec2 normal = face->normal, tangent = face->tangent;
  if (!motion->linear && motion->displacements != NULL) {
    double angle = motion->displacements[(size_t) face->a * QN_DOF_COUNT + QN_DOF_RZ];
    normal = qn_vec2_rotate (normal, cos (angle), sin (angle));
    tangent = qn_vec2_perp (normal);
  }
  QnVec2 ends[2] = { face->start, face->end };
  QnVec2 jump[2];
  const QnMotion own = moves_of (motion);
  for (int i = 0; i < 2; i++)
    jump[i] = qn_vec2_sub (qn_motion_place (&own, face->b, ends[i], 1),
                           qn_motion_place (&own, face->a, ends[i], 1));
  return (QnJointMotion){
    .opening_start = qn_vec2_dot (jump[0], normal),
    .opening_end = qn_vec2_dot (jump[1], normal),
    .slip = 0.5 * (qn_vec2_dot (jump[0], tangent) + qn_vec2_dot (jump[1], tangent)),
  };
}

static void
set_joint (QnJointMotion *joint, bool open_start, bool open_end, bool slides)
{
  joint->kind = open_start && open_end ? QN_JOINT_OPENING
                : open_start           ? QN_JOINT_HINGE_END
                : open_end             ? QN_JOINT_HINGE_START
                                       : QN_JOINT_CLOSED;
  joint->slides = slides;
}

/* By what the analysis found at the pairs of the face, where the motion is more than
 * `least`: near collapse most joints slip or open a little, which no picture shows. */
static void
set_joint_from_pairs (QnJointMotion *joint, const QnContactFace *face,
                      const QnPairResult *pairs, double least)
{
  if (face->pair_count < 1)
    return;
  const QnPairResult *first = pairs + face->first_pair;
  const QnPairResult *last = first + face->pair_count - 1;
  bool slips = false;
  for (int32_t i = 0; i < face->pair_count; i++)
    slips |= first[i].state == QN_PAIR_SLIP;
  set_joint (joint, first->state == QN_PAIR_OPEN && joint->opening_start > least,
             last->state == QN_PAIR_OPEN && joint->opening_end > least,
             slips && fabs (joint->slip) > least);
}

QnJointMotion *
qn_motion_joints (const QnMotion *motion, const QnContacts *contacts,
                  const QnPairResult *pairs)
{
  QnJointMotion *joints = g_new0 (QnJointMotion, MAX (contacts->face_count, 1));
  double largest = 0;
  for (size_t f = 0; f < contacts->face_count; f++) {
    QnJointMotion *joint = &joints[f];
    *joint = qn_motion_joint (motion, &contacts->faces[f]);
    largest = fmax (largest, fmax (joint->opening_start, joint->opening_end));
    largest = fmax (largest, fabs (joint->slip));
  }
  double least = JOINT_SHARE * largest;
  double seen = fmax (least, SEEN_SHARE * qn_motion_largest (motion));
  for (size_t f = 0; f < contacts->face_count; f++) {
    QnJointMotion *joint = &joints[f];
    if (pairs != NULL)
      set_joint_from_pairs (joint, &contacts->faces[f], pairs, seen);
    else
      set_joint (joint, joint->opening_start > least, joint->opening_end > least,
                 fabs (joint->slip) > least);
  }
  return joints;
}

const char *
qn_mechanism_kind_text (QnMechanismKind kind)
{
  static const char *const texts[QN_MECHANISM_KIND_COUNT] = {
    [QN_MECHANISM_KIND_OVERTURNING] = N_ ("overturning"),
    [QN_MECHANISM_KIND_ROCKING] = N_ ("rocking"),
    [QN_MECHANISM_KIND_SLIDING] = N_ ("sliding"),
    [QN_MECHANISM_KIND_STEPPED] = N_ ("stepped crack"),
    [QN_MECHANISM_KIND_ARCH] = N_ ("hinged arch"),
    [QN_MECHANISM_KIND_FALLING] = N_ ("falling blocks"),
    [QN_MECHANISM_KIND_SWAYING] = N_ ("swaying"),
    [QN_MECHANISM_KIND_MIXED] = N_ ("rocking and sliding"),
    [QN_MECHANISM_KIND_NONE] = N_ ("beams fail"), /* no block moves */
  };
  return _ (texts[kind]);
}
