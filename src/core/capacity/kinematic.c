#include "core/capacity/kinematic.h"

#include "core/base/memory.h"
#include "core/model/support.h"

#include <math.h>
#include <stdlib.h>

/* Bodies that move otherwise than about their hinges, by more than this part of the fastest, make no chain. */
#define DEVIATION 0.1

/* How far the fastest body moves in a step, of the size of the chain, and most steps. */
#define STEP  2e-3
#define STEPS 4000

/* Hinges that part by more than this part of the size: the chain has come to a stop. */
#define PARTED 1e-6

/* Of the fastest: elongation of a tie that is none. */
#define NO_MOTION 1e-6

/* Displacements and velocities: ux, uy, and the rotation times the size of the chain. */
typedef struct Body {
  QnVec2 centre; /* as drawn */
  double u[QN_DOF_COUNT], v[QN_DOF_COUNT];
  double start[QN_DOF_COUNT]; /* u at the start of a step */
} Body;

/* One condition: two points, or a point and the ground, keep together along an axis. */
typedef struct Row {
  QnId bodies[2]; /* QN_NONE: at rest */
  QnVec2 arms[2]; /* from their centres, as drawn */
  QnDof axis;     /* UX, UY; RZ: the first body does not turn */
  double gap, factors[2][QN_DOF_COUNT];
} Row;

typedef struct Force {
  QnId body;
  QnVec2 arm, force;
  double moment;
  bool live; /* its force is a seismic weight, N, along x */
} Force;

typedef struct Chain {
  const QnModel *model;
  const QnMechanism *mechanism;
  QnPool pool; /* of all below */
  Body *bodies;
  Row *rows;
  Force *forces;
  size_t body_count, row_count, force_count;
  double size;      /* half the diagonal around all that moves, m */
  double direction; /* of the live load: 1 = one weight */
  double *x, *p, *z, *right, *q;
} Chain;

static double
angle_of (const Chain *c, const Body *body)
{
  return body->u[QN_DOF_RZ] / c->size;
}

static QnVec2
turned (const Chain *c, QnId body, QnVec2 arm)
{
  double angle = angle_of (c, &c->bodies[body]);

  return qn_vec2_rotate (arm, cos (angle), sin (angle));
}

/* Of a point of a body; zero where it is at rest. */
static QnVec2
displacement (const Chain *c, QnId body, QnVec2 arm)
{
  if (body == QN_NONE)
    return qn_vec2 (0, 0);
  const double *u = c->bodies[body].u;
  return qn_vec2_add (qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]),
                      qn_vec2_sub (turned (c, body, arm), arm));
}

static QnVec2
velocity (const Chain *c, QnId body, QnVec2 arm)
{
  if (body == QN_NONE)
    return qn_vec2 (0, 0);
  const double *v = c->bodies[body].v;
  return qn_vec2_add_scaled (qn_vec2 (v[QN_DOF_UX], v[QN_DOF_UY]), v[QN_DOF_RZ] / c->size,
                             qn_vec2_perp (turned (c, body, arm)));
}

static QnId
body_of (const Chain *c, QnId block)
{
  return block != QN_NONE ? c->mechanism->body_of_block[block] : QN_NONE;
}

static QnVec2
arm_of (const Chain *c, QnId body, QnVec2 point)
{
  return body != QN_NONE ? qn_vec2_sub (point, c->bodies[body].centre) : qn_vec2 (0, 0);
}

/* ---- conditions ---- */

static void
add_row (Chain *c, QnId a, QnId b, QnVec2 point, QnDof axis)
{
  c->rows[c->row_count++] = (Row){ .bodies = { a, b },
                                   .arms = { arm_of (c, a, point), arm_of (c, b, point) },
                                   .axis = axis };
}

static void
add_rows (Chain *c, const QnContacts *contacts)
{
  for (size_t f = 0; f < c->mechanism->joint_count; f++) {
    QnJointKind kind = c->mechanism->joints[f].kind;
    QnId a = body_of (c, contacts->faces[f].a), b = body_of (c, contacts->faces[f].b);
    QnVec2 ends[2];
    qn_joint_corners (contacts, (QnId) f, &ends[0], &ends[1]);
    if ((kind != QN_JOINT_HINGE_START && kind != QN_JOINT_HINGE_END) || a == b)
      continue;
    for (int axis = QN_DOF_UX; axis <= QN_DOF_UY; axis++)
      add_row (c, a != QN_NONE ? a : b, a != QN_NONE ? b : a,
               ends[kind == QN_JOINT_HINGE_END], (QnDof) axis);
  }
  for (size_t b = 0; b < c->model->block_count; b++) {
    const QnBlock *block = &c->model->blocks[b];
    for (int axis = 0; axis < QN_DOF_COUNT && body_of (c, (QnId) b) != QN_NONE; axis++)
      if (block->support[axis])
        add_row (c, body_of (c, (QnId) b), QN_NONE, block->centroid, (QnDof) axis);
  }
}

/* How far the points of every condition are apart, and what moves them. */
static void
place_rows (Chain *c)
{
  for (size_t i = 0; i < c->row_count; i++) {
    Row *row = &c->rows[i];
    row->gap = 0;
    for (int side = 0; side < 2 && row->bodies[side] != QN_NONE; side++) {
      double sign = side == 0 ? 1 : -1, *factors = row->factors[side];
      QnVec2 moved = displacement (c, row->bodies[side], row->arms[side]);
      QnVec2 arm = turned (c, row->bodies[side], row->arms[side]);
      const double turns[QN_DOF_COUNT] = { -arm.y / c->size, arm.x / c->size, 1 };
      const double moves[QN_DOF_COUNT] = { moved.x, moved.y,
                                           c->bodies[row->bodies[side]].u[QN_DOF_RZ] };
      factors[QN_DOF_UX] = row->axis == QN_DOF_UX ? sign : 0;
      factors[QN_DOF_UY] = row->axis == QN_DOF_UY ? sign : 0;
      factors[QN_DOF_RZ] = sign * turns[row->axis];
      row->gap += sign * moves[row->axis];
    }
  }
}

/* q = J p */
static void
apply (const Chain *c, const double *p, double *q)
{
  for (size_t i = 0; i < c->row_count; i++) {
    const Row *row = &c->rows[i];
    q[i] = 0;
    for (int side = 0; side < 2 && row->bodies[side] != QN_NONE; side++)
      for (int d = 0; d < QN_DOF_COUNT; d++)
        q[i] += row->factors[side][d] * p[QN_DOF_COUNT * row->bodies[side] + d];
  }
}

/* p = J' q; returns p'p. */
static double
apply_transposed (const Chain *c, const double *q, double *p)
{
  double sum = 0;

  for (size_t i = 0; i < QN_DOF_COUNT * c->body_count; i++)
    p[i] = 0;
  for (size_t i = 0; i < c->row_count; i++) {
    const Row *row = &c->rows[i];
    for (int side = 0; side < 2 && row->bodies[side] != QN_NONE; side++)
      for (int d = 0; d < QN_DOF_COUNT; d++)
        p[QN_DOF_COUNT * row->bodies[side] + d] += row->factors[side][d] * q[i];
  }
  for (size_t i = 0; i < QN_DOF_COUNT * c->body_count; i++)
    sum += p[i] * p[i];
  return sum;
}

/* The least x for which J x is nearest to c->right, which is left as what remains: conjugate gradients
 * on the normal equations, for there may be more conditions than motions. */
static void
solve (Chain *c)
{
  size_t n = QN_DOF_COUNT * c->body_count;
  double square = apply_transposed (c, c->right, c->p), first = square;

  for (size_t i = 0; i < n; i++)
    c->x[i] = 0;
  for (size_t k = 0; k < 4 * n && square > 1e-30 * first && square > 0; k++) {
    double length = 0;
    apply (c, c->p, c->q);
    for (size_t i = 0; i < c->row_count; i++)
      length += c->q[i] * c->q[i];
    if (!(length > 0))
      return;
    for (size_t i = 0; i < n; i++)
      c->x[i] += square / length * c->p[i];
    for (size_t i = 0; i < c->row_count; i++)
      c->right[i] -= square / length * c->q[i];
    double next = apply_transposed (c, c->right, c->z);
    for (size_t i = 0; i < n; i++)
      c->p[i] = c->z[i] + next / square * c->p[i];
    square = next;
  }
}

/* Closes the hinges that a step has parted. False where they cannot be. */
static bool
close_hinges (Chain *c)
{
  double largest = 0;

  for (int k = 0; k < 4; k++) {
    place_rows (c);
    largest = 0;
    for (size_t i = 0; i < c->row_count; i++) {
      c->right[i] = c->rows[i].gap;
      largest = fmax (largest, fabs (c->rows[i].gap));
    }
    if (largest <= 1e-12 * c->size)
      break;
    solve (c);
    for (size_t b = 0; b < c->body_count; b++)
      for (int d = 0; d < QN_DOF_COUNT; d++)
        c->bodies[b].u[d] -= c->x[QN_DOF_COUNT * b + (size_t) d];
  }
  return largest <= PARTED * c->size;
}

/* Takes off the velocities what parts the hinges, and scales them: the fastest body has 1. Returns how
 * much was taken off, as a part of the fastest. */
static double
project (Chain *c)
{
  double taken = 0, fastest = 0;

  for (size_t b = 0; b < c->body_count; b++)
    for (int d = 0; d < QN_DOF_COUNT; d++)
      c->z[QN_DOF_COUNT * b + (size_t) d] = c->bodies[b].v[d];
  apply (c, c->z, c->right);
  solve (c);
  for (size_t b = 0; b < c->body_count; b++) {
    double *v = c->bodies[b].v;
    const double *x = c->x + QN_DOF_COUNT * b;
    for (int d = 0; d < QN_DOF_COUNT; d++) {
      v[d] -= x[d];
      taken = fmax (taken, fabs (x[d]));
    }
    fastest = fmax (fastest, hypot (hypot (v[0], v[1]), v[2]));
  }
  for (size_t b = 0; b < c->body_count && fastest > 0; b++)
    for (int d = 0; d < QN_DOF_COUNT; d++)
      c->bodies[b].v[d] /= fastest;
  return fastest > 0 ? taken / fastest : INFINITY;
}

/* ---- loads ---- */

static void
add_force (Chain *c, QnId block, QnVec2 arm, QnVec2 force, double moment, bool live)
{
  QnId body = body_of (c, block);
  QnVec2 point = qn_vec2_add (c->model->blocks[block].centroid, arm);

  if (body != QN_NONE)
    c->forces[c->force_count++] =
      (Force){ body, arm_of (c, body, point), force, moment, live };
}

/* Dead loads on what moves, and seismic weights. False where live loads are not horizontal, or against the
 * direction of the weights. */
static bool
add_forces (Chain *c)
{
  const QnModel *model = c->model;
  size_t count = qn_model_acting_count (model);
  QnVec2 dead = { 0, 0 };

  for (size_t i = 0; i < count; i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (load.kind == QN_LOAD_WEIGHT && load.set == QN_NONE)
      dead = qn_vec2_add (dead, load.vector);
    if (load.kind == QN_LOAD_WEIGHT && load.set == 0)
      c->direction += load.vector.x;
  }
  if (c->direction == 0)
    return false;
  for (size_t b = 0; b < model->block_count; b++) {
    double weight = model->blocks[b].weight;
    add_force (c, (QnId) b, qn_vec2 (0, 0), qn_vec2_scale (weight, dead), 0, false);
    add_force (c, (QnId) b, qn_vec2 (0, 0), qn_vec2 (weight, 0), 0, true);
  }
  for (size_t i = 0; i < count; i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    bool force = load.kind == QN_LOAD_FORCE || load.kind == QN_LOAD_NODE;
    QnVec2 vector = load.vector;
    if (load.set == 0) {
      bool resolved = qn_load_is_on_edges (load.kind);
      if (!resolved && load.kind != QN_LOAD_WEIGHT && !force)
        return false;
      if ((force || load.kind == QN_LOAD_WEIGHT)
          && (vector.y != 0 || load.moment != 0 || vector.x * c->direction < 0))
        return false;
      vector = qn_vec2 (vector.x / c->direction, 0);
    }
    if (force && (load.set == QN_NONE || load.set == 0))
      add_force (c, (QnId) qn_model_load_body (model, &load),
                 qn_model_load_arm (model, &load), vector, load.moment, load.set == 0);
  }
  return true;
}

/* The work of dead loads and of seismic weights with the velocities as they are. */
static void
find_works (const Chain *c, double *dead, double *seismic)
{
  *dead = *seismic = 0;
  for (size_t i = 0; i < c->force_count; i++) {
    const Force *f = &c->forces[i];
    QnVec2 v = velocity (c, f->body, f->arm);
    double rotation = c->bodies[f->body].v[QN_DOF_RZ] / c->size;
    *(f->live ? seismic : dead) += qn_vec2_dot (f->force, v) + f->moment * rotation;
  }
}

/* That of ties at their strength. */
static QnStatus
stretch_ties (const Chain *c, double *work, QnDiag *diag)
{
  *work = 0;
  for (size_t i = 0; i < c->model->tie_count; i++) {
    const QnTie *tie = &c->model->ties[i];
    QnVec2 ends[2];
    for (int e = 0; e < 2; e++) {
      QnId body = body_of (c, tie->ends[e].block);
      ends[e] = velocity (c, body, arm_of (c, body, tie->ends[e].at));
    }
    QnVec2 along = qn_vec2_sub (tie->ends[1].at, tie->ends[0].at);
    double rate =
      qn_vec2_dot (qn_vec2_sub (ends[1], ends[0]), along) / qn_tie_length (tie);
    if (!(rate > NO_MOTION))
      continue;
    if (!isfinite (qn_tie_strength (tie)))
      return qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_MECHANISM_TIE, QN_ENTITY_TIE,
                          (QnId) i, QN_NONE);
    *work += qn_tie_strength (tie) * rate;
  }
  return QN_OK;
}

/* ---- the chain ---- */

/* The bodies where they were built, with their velocities in this place. */
static void
add_bodies (Chain *c, const double *base)
{
  QnBox all = QN_BOX_EMPTY;
  double *areas = c->x; /* free until the first solution */

  for (size_t i = 0; i < c->body_count; i++)
    qn_box_add_box (&all, c->mechanism->bodies[i].box);
  c->size = 0.5 * qn_box_diagonal (all);
  for (size_t b = 0; b < c->model->block_count; b++) {
    const QnBlock *block = &c->model->blocks[b];
    QnId body = body_of (c, (QnId) b);
    if (body == QN_NONE)
      continue;
    areas[body] += block->area;
    c->bodies[body].centre =
      qn_vec2_add_scaled (c->bodies[body].centre, block->area, block->centroid);
    if (base != NULL) /* how far it has turned, in the place of its rotation */
      c->bodies[body].u[QN_DOF_RZ] += block->area * base[QN_DOF_COUNT * b + QN_DOF_RZ];
  }
  for (size_t i = 0; i < c->body_count; i++) {
    Body *body = &c->bodies[i];
    const QnMechanismBody *found = &c->mechanism->bodies[i];
    double angle = -body->u[QN_DOF_RZ] / areas[i];
    QnVec2 v = qn_vec2_rotate (found->velocity, cos (angle), sin (angle));
    body->centre = qn_vec2_scale (1 / areas[i], body->centre);
    body->u[QN_DOF_RZ] = 0;
    body->v[QN_DOF_UX] = v.x;
    body->v[QN_DOF_UY] = v.y;
    body->v[QN_DOF_RZ] = found->rotation * c->size;
  }
}

/* False where memory runs out. */
static bool
chain_init (Chain *c, const QnModel *model, const QnContacts *contacts,
            const QnMechanism *mechanism, const double *base)
{
  size_t n = QN_DOF_COUNT * mechanism->body_count;
  size_t rows = 2 * mechanism->joint_count + QN_DOF_COUNT * model->block_count;
  size_t forces = 2 * model->block_count + qn_model_acting_count (model);

  *c = (Chain){ .model = model,
                .mechanism = mechanism,
                .body_count = mechanism->body_count };
  c->bodies = qn_pool_alloc (&c->pool, c->body_count, sizeof *c->bodies);
  c->rows = qn_pool_alloc (&c->pool, rows, sizeof *c->rows);
  c->forces = qn_pool_alloc (&c->pool, forces, sizeof *c->forces);
  c->x = qn_pool_alloc (&c->pool, n, sizeof *c->x);
  c->p = qn_pool_alloc (&c->pool, n, sizeof *c->p);
  c->z = qn_pool_alloc (&c->pool, n, sizeof *c->z);
  c->right = qn_pool_alloc (&c->pool, rows, sizeof *c->right);
  c->q = qn_pool_alloc (&c->pool, rows, sizeof *c->q);
  if (c->pool.failed)
    return false;
  add_bodies (c, base);
  add_rows (c, contacts);
  place_rows (c);
  return true;
}

/* Along the live load. */
static double
along (const Chain *c, QnVec2 motion)
{
  return copysign (motion.x, motion.x * c->direction);
}

static QnVec2
arm_of_block (const Chain *c, QnId block)
{
  return arm_of (c, body_of (c, block), c->model->blocks[block].centroid);
}

/* Control block, M*, e* and the ratio of displacements, of the velocities as built. False where the chain
 * or the control block does not move with the load. */
static bool
find_masses (const Chain *c, QnCapacity *capacity, QnId control)
{
  QnMassSums sums = { 0 };
  double farthest = 0;

  capacity->block = control;
  for (size_t b = 0; b < c->model->block_count; b++) {
    const QnBlock *block = &c->model->blocks[b];
    QnId body = body_of (c, (QnId) b);
    double motion = along (c, velocity (c, body, arm_of_block (c, (QnId) b)));
    if (body == QN_NONE && !qn_support_is_full (block->support))
      capacity->left_out += block->weight / c->model->gravity;
    capacity->participating += body != QN_NONE;
    if (control != QN_NONE ? (QnId) b == control : motion > farthest * (1 + 1e-9)) {
      farthest = motion;
      capacity->block = (QnId) b;
    }
  }
  for (size_t i = 0; i < c->force_count; i++) {
    const Force *f = &c->forces[i];
    if (f->live)
      qn_mass_sums_add (&sums, f->force.x, along (c, velocity (c, f->body, f->arm)));
  }
  return qn_capacity_set_masses (capacity, sums, farthest, c->model->gravity);
}

/* The multiplier without ties, from point to point as the chain moves on, until it is 0 or the chain stops. */
static QnStatus
follow (Chain *c, QnCapacity *capacity, QnDiag *diag)
{
  const QnId body = body_of (c, capacity->block);
  const QnVec2 arm = arm_of_block (c, capacity->block);
  const double scale = fabs (c->direction) * c->model->gravity / capacity->share;
  size_t room = 0;

  while (capacity->count < STEPS && !capacity->reaches_zero) {
    double dead, seismic;
    find_works (c, &dead, &seismic);
    QnCapacityPoint point = { .multiplier = -dead / (c->direction * seismic),
                              .control = along (c, displacement (c, body, arm)) };
    const QnCapacityPoint *before =
      capacity->count > 0 ? &capacity->points[capacity->count - 1] : NULL;
    if (before != NULL
        && !(point.control > before->control && c->direction * seismic > 0))
      break;
    if (before != NULL && point.multiplier <= 0) {
      double part = before->multiplier / (before->multiplier - point.multiplier);
      point.control = before->control + part * (point.control - before->control);
      point.multiplier = 0;
      capacity->reaches_zero = true;
    }
    point.displacement = point.control * capacity->ratio;
    point.acceleration = point.multiplier * scale;
    if (!QN_ARRAY_PUSH (capacity->points, capacity->count, room, point))
      return qn_diag_no_memory (diag);
    if (point.multiplier > capacity->points[capacity->peak].multiplier)
      capacity->peak = capacity->count - 1;
    /* half a step to find the velocities of the whole one */
    bool closed = true;
    for (int half = 1; half <= 2 && closed; half++) {
      for (size_t b = 0; b < c->body_count; b++)
        for (int d = 0; d < QN_DOF_COUNT; d++) {
          Body *at = &c->bodies[b];
          at->start[d] = half == 1 ? at->u[d] : at->start[d];
          at->u[d] = at->start[d] + 0.5 * half * STEP * c->size * at->v[d];
        }
      closed = close_hinges (c);
      project (c);
    }
    if (!closed)
      break;
  }
  capacity->end = capacity->points[capacity->count - 1].displacement;
  return QN_OK;
}

static QnStatus
refuse (QnProblem problem, QnDiag *diag)
{
  return qn_diag_set (diag, QN_ERROR_INVALID, problem, QN_ENTITY_MODEL, QN_NONE, QN_NONE);
}

/* Whether every joint that moves turns: one that slides far is no hinge. */
static QnStatus
check_joints (const QnMechanism *m, const QnContacts *contacts, QnDiag *diag)
{
  for (size_t f = 0; f < m->joint_count; f++)
    if (m->joints[f].kind == QN_JOINT_SLIDING
        && fabs (m->joints[f].slip) > DEVIATION * m->largest)
      return qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_MECHANISM_SLIDES,
                          QN_ENTITY_BLOCK, contacts->faces[f].b, contacts->faces[f].a);
  return QN_OK;
}

static QnStatus
analyse (Chain *c, QnCapacity *capacity, const QnContacts *contacts, QnId control,
         QnDiag *diag)
{
  double dead, seismic;
  QnStatus status = check_joints (c->mechanism, contacts, diag);

  if (status != QN_OK)
    return status;
  if (!add_forces (c))
    return refuse (QN_PROBLEM_CAPACITY_LOADS, diag);
  if (project (c) > DEVIATION)
    return refuse (QN_PROBLEM_MECHANISM_SLIDES, diag);
  if (!find_masses (c, capacity, control))
    return qn_diag_set (diag, QN_ERROR_INVALID, QN_PROBLEM_CAPACITY_MOTION,
                        QN_ENTITY_BLOCK, capacity->block, QN_NONE);
  status = stretch_ties (c, &capacity->works[QN_WORK_TIES], diag);
  if (status != QN_OK)
    return status;
  find_works (c, &dead, &seismic);
  double unit = along (
    c, velocity (c, body_of (c, capacity->block), arm_of_block (c, capacity->block)));
  capacity->works[QN_WORK_TIES] /= unit;
  capacity->works[QN_WORK_DEAD] = -dead / unit;
  capacity->works[QN_WORK_LIVE] = c->direction * seismic / unit;
  if (!(capacity->works[QN_WORK_DEAD] > 0))
    return refuse (QN_PROBLEM_MECHANISM_WEIGHT, diag);
  capacity->activation = (capacity->works[QN_WORK_DEAD] + capacity->works[QN_WORK_TIES])
                         / capacity->works[QN_WORK_LIVE];
  return follow (c, capacity, diag);
}

QnStatus
qn_capacity_init_kinematic (QnCapacity *capacity, const QnModel *model,
                            const QnContacts *contacts, const QnResult *result,
                            QnId control, QnDiag *diag)
{
  QnMechanism mechanism;
  Chain chain = { 0 };

  *capacity = (QnCapacity){ .kinematic = true, .found = NAN };
  QnStatus status = qn_capacity_check_model (model, diag);
  if (status != QN_OK)
    return status;
  if (result->mechanism == NULL || result->vibration.mode > 0
      || result->stability == QN_STABILITY_LOST || result->history.width > 0)
    return refuse (QN_PROBLEM_MECHANISM_MISSING, diag);
  status = qn_mechanism_of_result (&mechanism, model, contacts, result, diag);
  if (status != QN_OK)
    return status;
  if (mechanism.body_count == 0)
    status = refuse (QN_PROBLEM_MECHANISM_MISSING, diag);
  else if (!chain_init (&chain, model, contacts, &mechanism,
                        qn_mechanism_base (model, result)))
    status = qn_diag_no_memory (diag);
  else
    status = analyse (&chain, capacity, contacts, control, diag);
  if (status != QN_OK)
    qn_capacity_clear (capacity);
  else if (result->has_collapse_multiplier)
    capacity->found = result->collapse_multiplier;
  qn_pool_clear (&chain.pool);
  qn_mechanism_clear (&mechanism);
  return status;
}

QnLinearCheck
qn_capacity_check_linear (const QnCapacity *c, const QnSpectrum *spectrum,
                          double confidence)
{
  const QnCapacityPoint *first = &c->points[0];
  QnLinearCheck check = { .demand = qn_spectrum_acceleration (spectrum, 0) };

  check.capacity = first->acceleration * (c->activation / first->multiplier) / confidence;
  check.sld = check.capacity / check.demand;
  check.slv = QN_NTC_BEHAVIOUR_FACTOR * check.sld;
  return check;
}
