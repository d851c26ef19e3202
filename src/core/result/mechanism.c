#include "core/result/mechanism.h"

#include "core/base/memory.h"
#include "core/base/union-find.h"

#include <math.h>
#include <stdlib.h>

/* Of the fastest point's speed: a joint that moves less is closed, a block at rest. */
#define MOTION_SHARE 0.01

/* Rotation counts where it moves the ends of a joint, or the far corner of a body, apart by more
 * than this part of their motion. */
#define ROTATION_SHARE 0.05

const char *const qn_joint_kind_names[QN_JOINT_KIND_COUNT] = {
  [QN_JOINT_CLOSED] = "closed",       [QN_JOINT_HINGE_START] = "hinge-start",
  [QN_JOINT_HINGE_END] = "hinge-end", [QN_JOINT_SLIDING] = "sliding",
  [QN_JOINT_OPENING] = "opening",
};

/* A field of velocities, and where the blocks are as it begins: NULL where they were built. */
typedef struct Field {
  const QnModel *model;
  const double *base, *velocities;
  bool associative; /* joints dilate by their friction, whatever their laws say */
} Field;

static double
turned_by (const Field *field, QnId block)
{
  return field->base != NULL ? field->base[(size_t) block * QN_DOF_COUNT + QN_DOF_RZ] : 0;
}

static QnVec2
turn (QnVec2 v, double angle)
{
  return angle != 0 ? qn_vec2_rotate (v, cos (angle), sin (angle)) : v;
}

static QnVec2
centroid_of (const Field *field, QnId block)
{
  const double *u = field->base + (size_t) block * QN_DOF_COUNT;
  QnVec2 centroid = field->model->blocks[block].centroid;

  return field->base != NULL
           ? qn_vec2_add (centroid, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]))
           : centroid;
}

/* Velocity of the point of a block that was built at p. */
static QnVec2
velocity_at (const Field *field, QnId block, QnVec2 p)
{
  const double *v = field->velocities + (size_t) block * QN_DOF_COUNT;
  QnVec2 arm = turn (qn_vec2_sub (p, field->model->blocks[block].centroid),
                     turned_by (field, block));

  return qn_vec2 (v[QN_DOF_UX] - v[QN_DOF_RZ] * arm.y,
                  v[QN_DOF_UY] + v[QN_DOF_RZ] * arm.x);
}

static double
fastest_vertex (const Field *field, QnId block)
{
  const QnVec2 *vertices = qn_model_block_vertices (field->model, block);
  double fastest = 0.0;

  for (QnId i = 0; i < field->model->blocks[block].vertex_count; i++)
    fastest = fmax (fastest, qn_vec2_length (velocity_at (field, block, vertices[i])));
  return fastest;
}

void
qn_joint_corners (const QnContacts *contacts, QnId face, QnVec2 *start, QnVec2 *end)
{
  const QnContactFace *f = &contacts->faces[face];
  const QnContactPair *pairs = &contacts->pairs[f->first_pair];

  *start = f->pair_count > 1 ? pairs[0].point : f->start;
  *end = f->pair_count > 1 ? pairs[f->pair_count - 1].point : f->end;
}

static QnJointMotion
joint_motion (const Field *field, const QnContacts *contacts, QnId id, double least)
{
  const QnContactFace *face = &contacts->faces[id];
  QnVec2 normal = turn (face->normal, turned_by (field, face->a));
  QnVec2 tangent = turn (face->tangent, turned_by (field, face->a));
  QnJointMotion joint;
  QnVec2 corners[2], jumps[2];
  double low, high, dilated;

  qn_joint_corners (contacts, id, &corners[0], &corners[1]);
  for (int i = 0; i < 2; i++)
    jumps[i] = qn_vec2_sub (velocity_at (field, face->b, corners[i]),
                            velocity_at (field, face->a, corners[i]));
  joint.opening_start = qn_vec2_dot (jumps[0], normal);
  joint.opening_end = qn_vec2_dot (jumps[1], normal);
  joint.slip = 0.5 * (qn_vec2_dot (jumps[0], tangent) + qn_vec2_dot (jumps[1], tangent));
  /* In a gap that is open already the sides turn past each other: what slips is where they touch. */
  if (field->base != NULL)
    joint.slip = qn_vec2_dot (jumps[joint.opening_end < joint.opening_start], tangent);
  joint.slides = fabs (joint.slip) > least;
  low = fmin (joint.opening_start, joint.opening_end);
  high = fmax (joint.opening_start, joint.opening_end);
  /* By how much of its slip a joint opens and stays in touch: by the larger of its two sides. */
  const QnLaw *a = &field->model->laws[face->law_a],
              *b = &field->model->laws[face->law_b];
  dilated = ((field->associative ? fmax (a->friction, b->friction)
                                 : fmax (a->dilatancy, b->dilatancy))
             + QN_JOINT_PARTING)
            * fabs (joint.slip);
  if (low > dilated + least) {
    joint.kind = QN_JOINT_OPENING;
    joint.slides = false;
  } else if (high - low > least && high - low > ROTATION_SHARE * fabs (joint.slip))
    joint.kind =
      joint.opening_start < joint.opening_end ? QN_JOINT_HINGE_START : QN_JOINT_HINGE_END;
  else
    joint.kind = joint.slides ? QN_JOINT_SLIDING : QN_JOINT_CLOSED;
  return joint;
}

/* A body during grouping: its root block and size, for sorting. */
typedef struct Group {
  QnId root;
  int32_t blocks;
} Group;

static int
compare_groups (const void *a, const void *b)
{
  const Group *x = a, *y = b;

  if (x->blocks != y->blocks)
    return y->blocks - x->blocks;
  return (x->root > y->root) - (x->root < y->root);
}

/* Bodies are the blocks that move and are joined by closed joints; the largest comes first. What a body
 * has is the mean over its blocks, weighted by area. */
static QnStatus
find_bodies (QnMechanism *m, const Field *field, const QnContacts *contacts, QnDiag *diag)
{
  const QnModel *model = field->model;
  QnPool room = { 0 };
  bool *moving = qn_pool_alloc (&room, m->block_count, sizeof *moving);
  QnId *parents = qn_pool_alloc (&room, m->block_count, sizeof *parents);
  QnId *numbers = qn_pool_alloc (&room, m->block_count, sizeof *numbers);
  double *areas = qn_pool_alloc (&room, m->block_count, sizeof *areas);
  Group *groups = qn_pool_alloc (&room, m->block_count, sizeof *groups);
  size_t count = 0;

  m->bodies = qn_alloc (m->block_count, sizeof *m->bodies);
  if (room.failed || m->bodies == NULL) {
    qn_pool_clear (&room);
    return qn_diag_no_memory (diag);
  }
  qn_sets_init (parents, m->block_count);
  for (size_t f = 0; f < m->joint_count; f++)
    if (m->joints[f].kind == QN_JOINT_CLOSED)
      qn_sets_join (parents, contacts->faces[f].a, contacts->faces[f].b);
  for (size_t b = 0; b < m->block_count; b++)
    numbers[b] = QN_NONE;
  for (size_t b = 0; b < m->block_count; b++) {
    QnId root = qn_sets_root (parents, (QnId) b);
    moving[b] = fastest_vertex (field, (QnId) b) > MOTION_SHARE * m->largest;
    if (!moving[b])
      continue;
    if (numbers[root] == QN_NONE) {
      numbers[root] = (QnId) count;
      groups[count++] = (Group){ .root = root };
    }
    groups[numbers[root]].blocks++;
  }
  qsort (groups, count, sizeof *groups, compare_groups);
  for (size_t g = 0; g < count; g++) {
    numbers[groups[g].root] = (QnId) g;
    m->bodies[g].box = QN_BOX_EMPTY;
  }
  m->body_count = count;
  for (size_t b = 0; b < m->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    const double *v = field->velocities + b * QN_DOF_COUNT;
    QnId id = moving[b] ? numbers[qn_sets_root (parents, (QnId) b)] : QN_NONE;
    m->body_of_block[b] = id;
    if (id == QN_NONE)
      continue;
    QnMechanismBody *body = &m->bodies[id];
    areas[id] += block->area;
    body->block_count++;
    body->centroid =
      qn_vec2_add_scaled (body->centroid, block->area, centroid_of (field, (QnId) b));
    body->rotation += block->area * v[QN_DOF_RZ];
    body->velocity = qn_vec2_add_scaled (body->velocity, block->area,
                                         qn_vec2 (v[QN_DOF_UX], v[QN_DOF_UY]));
    body->largest = fmax (body->largest, fastest_vertex (field, (QnId) b) / m->largest);
    qn_box_add_box (&body->box, qn_model_block_box (model, (QnId) b));
  }
  for (size_t i = 0; i < count; i++) {
    QnMechanismBody *body = &m->bodies[i];
    double radius = 0.5 * qn_box_diagonal (body->box);
    body->centroid = qn_vec2_scale (1.0 / areas[i], body->centroid);
    body->velocity = qn_vec2_scale (1.0 / areas[i], body->velocity);
    body->rotation /= areas[i];
    body->turns =
      fabs (body->rotation) * radius > ROTATION_SHARE * qn_vec2_length (body->velocity);
    /* 0 = velocity + rotation x (centre - centroid) */
    body->centre = body->turns ? qn_vec2_add_scaled (body->centroid, 1.0 / body->rotation,
                                                     qn_vec2_perp (body->velocity))
                               : body->centroid;
  }
  qn_pool_clear (&room);
  return QN_OK;
}

const double *
qn_mechanism_base (const QnModel *model, const QnResult *result)
{
  return model->analysis.geometry != QN_GEOMETRY_LINEAR && model->beam_count == 0
             && result->step_count > 0 && !result->limit.given
             && result->vibration.mode == 0 && result->stability != QN_STABILITY_LOST
             && result->history.width == 0
           ? qn_result_step_displacements (result, result->step_count - 1)
           : NULL;
}

QnStatus
qn_mechanism_of_result (QnMechanism *m, const QnModel *model, const QnContacts *contacts,
                        const QnResult *result, QnDiag *diag)
{
  const Field field = { model, qn_mechanism_base (model, result), result->mechanism,
                        result->limit.given
                          && result->limit.flow == QN_FLOW_ASSOCIATIVE };

  *m = (QnMechanism){ .joint_count = contacts->face_count,
                      .block_count = model->block_count };
  m->joints = qn_alloc (m->joint_count, sizeof *m->joints);
  m->body_of_block = qn_alloc (m->block_count, sizeof *m->body_of_block);
  if (!m->joints || !m->body_of_block) {
    qn_mechanism_clear (m);
    return qn_diag_no_memory (diag);
  }
  for (size_t b = 0; b < model->block_count; b++)
    m->largest = fmax (m->largest, fastest_vertex (&field, (QnId) b));
  for (size_t f = 0; f < m->joint_count; f++) {
    m->joints[f] = joint_motion (&field, contacts, (QnId) f, MOTION_SHARE * m->largest);
    m->counts[m->joints[f].kind]++;
    m->sliding_count += m->joints[f].slides;
  }
  QnStatus status = find_bodies (m, &field, contacts, diag);
  if (status != QN_OK)
    qn_mechanism_clear (m);
  else
    m->kind = qn_mechanism_classify (m, model, contacts);
  return status;
}

void
qn_mechanism_clear (QnMechanism *mechanism)
{
  free (mechanism->joints);
  free (mechanism->body_of_block);
  free (mechanism->bodies);
  *mechanism = (QnMechanism){ 0 };
}
