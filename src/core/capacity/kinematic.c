#include "core/capacity/capacity.h"

#include "core/base/memory.h"

#include <math.h>

/* Bodies that move otherwise than about their hinges, by more than this part of the
 * fastest, make no chain. */
#define DEVIATION 0.1

/* How far the fastest body moves in a step, of the size of the chain, and most steps. */
#define STEP  2e-3
#define STEPS 4000

/* Hinges that part by more than this part of the size: the chain has come to a stop. */
#define PARTED 1e-6

/* Of the fastest: elongation of a tie that is none. */
#define NO_MOTION 1e-6

/* Part of the largest acceleration that ties must take with them to end SLV, C8.7.1.2.1.6. */
#define LOST 0.5

/* One condition: two points, or a point and the ground, keep together along an axis. */
typedef struct Row {
  QnId bodies[2]; /* QN_NONE: at rest */
  QnVec2 arms[2]; /* from their centres, as drawn */
  QnDof axis;     /* UX, UY; RZ: the first body does not turn */
  double gap, factors[2][QN_DOF_COUNT];
} Row;

/* On a point of a body: dead loads, N, N m, and the seismic weight, N. */
typedef struct Force {
  QnId body;
  QnVec2 arm, dead;
  double moment, seismic;
} Force;

typedef struct Chain {
  const QnModel *model;
  const QnMechanism *mechanism;
  QnPool pool;     /* of all below */
  QnVec2 *centres; /* of the bodies, as drawn */
  double *u, *v;   /* n: displacements, velocities: ux, uy, rotation times size */
  Row *rows;
  Force *forces;
  size_t n, row_count, force_count;
  double size;      /* half the diagonal around all that moves, m */
  double direction; /* of the live load: 1 = one weight */
  bool *broken;     /* ties of the project */
  double *x, *p, *z, *right, *q;
} Chain;

static QnVec2
turned (const Chain *c, QnId body, QnVec2 arm)
{
  double angle = c->u[QN_DOF_COUNT * body + QN_DOF_RZ] / c->size;

  return qn_vec2_rotate (arm, cos (angle), sin (angle));
}

/* Of a point of a body; zero where it is at rest. */
static QnVec2
displacement (const Chain *c, QnId body, QnVec2 arm)
{
  if (body == QN_NONE)
    return qn_vec2 (0, 0);
  const double *u = c->u + QN_DOF_COUNT * body;
  return qn_vec2_add (qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]),
                      qn_vec2_sub (turned (c, body, arm), arm));
}

static QnVec2
velocity (const Chain *c, QnId body, QnVec2 arm)
{
  if (body == QN_NONE)
    return qn_vec2 (0, 0);
  const double *v = c->v + QN_DOF_COUNT * body;
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
  return body != QN_NONE ? qn_vec2_sub (point, c->centres[body]) : qn_vec2 (0, 0);
}

/* ---- conditions ---- */

static void
add_row (Chain *c, QnId a, QnId b, QnVec2 point, QnDof axis)
{
  c->rows[c->row_count++] = (Row){ .bodies = { a, b },
                                   .arms = { arm_of (c, a, point), arm_of (c, b, point) },
                                   .axis = axis };
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
      const double moves[QN_DOF_COUNT] = {
        moved.x, moved.y, c->u[QN_DOF_COUNT * row->bodies[side] + QN_DOF_RZ]
      };
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

  for (size_t i = 0; i < c->n; i++)
    p[i] = 0;
  for (size_t i = 0; i < c->row_count; i++) {
    const Row *row = &c->rows[i];
    for (int side = 0; side < 2 && row->bodies[side] != QN_NONE; side++)
      for (int d = 0; d < QN_DOF_COUNT; d++)
        p[QN_DOF_COUNT * row->bodies[side] + d] += row->factors[side][d] * q[i];
  }
  for (size_t i = 0; i < c->n; i++)
    sum += p[i] * p[i];
  return sum;
}

/* The least x for which J x is nearest to c->right, which is left as what remains: conjugate gradients
 * on the normal equations, for there may be more conditions than motions. */
static void
solve (Chain *c)
{
  double square = apply_transposed (c, c->right, c->p), first = square;

  for (size_t i = 0; i < c->n; i++)
    c->x[i] = 0;
  for (size_t k = 0; k < 4 * c->n && square > 1e-30 * first && square > 0; k++) {
    double length = 0;
    apply (c, c->p, c->q);
    for (size_t i = 0; i < c->row_count; i++)
      length += c->q[i] * c->q[i];
    if (!(length > 0))
      return;
    for (size_t i = 0; i < c->n; i++)
      c->x[i] += square / length * c->p[i];
    for (size_t i = 0; i < c->row_count; i++)
      c->right[i] -= square / length * c->q[i];
    double next = apply_transposed (c, c->right, c->z);
    for (size_t i = 0; i < c->n; i++)
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
    for (size_t i = 0; i < c->n; i++)
      c->u[i] -= c->x[i];
  }
  return largest <= PARTED * c->size;
}

/* Takes off the velocities what parts the hinges, and scales them: the fastest body has 1. Returns how
 * much was taken off, as a part of the fastest. */
static double
project (Chain *c)
{
  double taken = 0, fastest = 0;

  apply (c, c->v, c->right);
  solve (c);
  for (size_t i = 0; i < c->n; i++) {
    c->v[i] -= c->x[i];
    taken = fmax (taken, fabs (c->x[i]));
    fastest = fmax (fastest, fabs (c->v[i]));
  }
  for (size_t i = 0; i < c->n && fastest > 0; i++)
    c->v[i] /= fastest;
  return fastest > 0 ? taken / fastest : INFINITY;
}

/* ---- loads ---- */

static void
add_force (Chain *c, QnId block, QnVec2 at, Force force)
{
  force.body = body_of (c, block);
  force.arm = arm_of (c, force.body, at);
  if (force.body != QN_NONE)
    c->forces[c->force_count++] = force;
}

/* Dead loads on what moves, and seismic weights. False where live loads are not horizontal, or against the
 * direction of the weights. */
static bool
add_forces (Chain *c)
{
  const QnModel *model = c->model;
  QnVec2 dead = { 0, 0 };

  c->direction = qn_capacity_direction (model);
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    bool live = load.set == 0, weight = load.kind == QN_LOAD_WEIGHT;
    bool force = load.kind == QN_LOAD_FORCE || load.kind == QN_LOAD_NODE;
    if (weight && load.set == QN_NONE)
      dead = qn_vec2_add (dead, load.vector);
    if ((!live && load.set != QN_NONE) || qn_load_is_on_edges (load.kind))
      continue;
    if (live
        && ((!weight && !force) || load.vector.y != 0 || load.moment != 0
            || !(load.vector.x * c->direction >= 0) || c->direction == 0))
      return false;
    if (force)
      add_force (c, (QnId) qn_model_load_body (model, &load),
                 qn_vec2_add (model->blocks[qn_model_load_body (model, &load)].centroid,
                              qn_model_load_arm (model, &load)),
                 live ? (Force){ .seismic = load.vector.x / c->direction }
                      : (Force){ .dead = load.vector, .moment = load.moment });
  }
  for (size_t b = 0; b < model->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    add_force (
      c, (QnId) b, block->centroid,
      (Force){ .dead = qn_vec2_scale (block->weight, dead), .seismic = block->weight });
  }
  return c->direction != 0;
}

/* The work of dead loads and of seismic weights with the velocities as they are. */
static void
find_works (const Chain *c, double *dead, double *seismic)
{
  *dead = *seismic = 0;
  for (size_t i = 0; i < c->force_count; i++) {
    const Force *f = &c->forces[i];
    QnVec2 v = velocity (c, f->body, f->arm);
    *dead += qn_vec2_dot (f->dead, v)
             + f->moment * c->v[QN_DOF_COUNT * f->body + QN_DOF_RZ] / c->size;
    *seismic += f->seismic * v.x;
  }
}

/* That of ties at their strength. */
static QnStatus
stretch_ties (const Chain *c, double *work, QnDiag *diag)
{
  *work = 0;
  for (size_t i = 0; i < qn_model_tie_count (c->model); i++) {
    const QnTie *tie = qn_model_tie (c->model, i);
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
      return qn_refuse (diag, QN_PROBLEM_MECHANISM_TIE, QN_ENTITY_TIE, (QnId) i);
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
  double *areas = c->x, *turns = c->p; /* free until the first solution */

  for (size_t i = 0; i < c->mechanism->body_count; i++)
    qn_box_add_box (&all, c->mechanism->bodies[i].box);
  c->size = 0.5 * qn_box_diagonal (all);
  for (size_t b = 0; b < c->model->block_count; b++) {
    const QnBlock *block = &c->model->blocks[b];
    QnId body = body_of (c, (QnId) b);
    if (body == QN_NONE)
      continue;
    areas[body] += block->area;
    c->centres[body] =
      qn_vec2_add_scaled (c->centres[body], block->area, block->centroid);
    turns[body] += base != NULL ? block->area * base[QN_DOF_COUNT * b + QN_DOF_RZ] : 0;
  }
  for (size_t i = 0; i < c->mechanism->body_count; i++) {
    const QnMechanismBody *found = &c->mechanism->bodies[i];
    double angle = -turns[i] / areas[i], *v = c->v + QN_DOF_COUNT * i;
    QnVec2 velocity = qn_vec2_rotate (found->velocity, cos (angle), sin (angle));
    c->centres[i] = qn_vec2_scale (1 / areas[i], c->centres[i]);
    v[QN_DOF_UX] = velocity.x;
    v[QN_DOF_UY] = velocity.y;
    v[QN_DOF_RZ] = found->rotation * c->size;
  }
}

/* False where memory runs out. */
static bool
chain_init (Chain *c, const QnModel *model, const QnContacts *contacts,
            const QnMechanism *mechanism, const double *base)
{
  size_t rows = 2 * mechanism->joint_count + QN_DOF_COUNT * model->block_count;
  size_t forces = model->block_count + qn_model_acting_count (model);

  *c = (Chain){ .model = model,
                .mechanism = mechanism,
                .n = QN_DOF_COUNT * mechanism->body_count };
  double **const vectors[] = { &c->u, &c->v, &c->x, &c->p, &c->z };
  for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++)
    *vectors[i] = qn_pool_alloc (&c->pool, c->n, sizeof **vectors[i]);
  c->centres = qn_pool_alloc (&c->pool, mechanism->body_count, sizeof *c->centres);
  c->rows = qn_pool_alloc (&c->pool, rows, sizeof *c->rows);
  c->forces = qn_pool_alloc (&c->pool, forces, sizeof *c->forces);
  c->right = qn_pool_alloc (&c->pool, rows, sizeof *c->right);
  c->q = qn_pool_alloc (&c->pool, rows, sizeof *c->q);
  c->broken = qn_pool_alloc (&c->pool, model->tie_count, sizeof *c->broken);
  if (c->pool.failed)
    return false;
  add_bodies (c, base);
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

/* The work of ties as the chain has moved, and whether one of them breaks here. */
static bool
pull_ties (Chain *c, double strain, double *work)
{
  bool breaks = false;

  *work = 0;
  for (size_t i = 0; i < c->model->tie_count && strain > 0; i++) {
    const QnTie *tie = &c->model->ties[i];
    double length = qn_tie_length (tie), stiffness = qn_tie_stiffness (tie);
    QnVec2 moved[2], ends[2];
    for (int e = 0; e < 2; e++) {
      QnId body = body_of (c, tie->ends[e].block);
      QnVec2 arm = arm_of (c, body, tie->ends[e].at);
      moved[e] = qn_vec2_add (tie->ends[e].at, displacement (c, body, arm));
      ends[e] = velocity (c, body, arm);
    }
    QnVec2 line = qn_vec2_sub (moved[1], moved[0]);
    double elongation = qn_vec2_length (line) - length;
    breaks = breaks || (!c->broken[i] && elongation > strain * length);
    c->broken[i] = c->broken[i] || elongation > strain * length;
    if (c->broken[i])
      continue;
    double force = tie->prestress + stiffness * (elongation - tie->slack);
    *work += fmin (fmax (force, 0), qn_tie_strength (tie))
             * qn_vec2_dot (qn_vec2_sub (ends[1], ends[0]), line) / qn_vec2_length (line);
  }
  return breaks;
}

/* The multiplier as the chain moves on, until it is 0 or the chain stops. */
static QnStatus
follow (Chain *c, QnCapacity *capacity, double tie_strain, QnDiag *diag)
{
  const QnId body = body_of (c, capacity->block);
  const QnVec2 arm = arm_of_block (c, capacity->block);
  const double scale = capacity->unit / capacity->share;
  double lost = 0;
  size_t room = 0;

  while (capacity->count < STEPS && !capacity->reaches_zero) {
    double dead, seismic, ties;
    bool breaks = pull_ties (c, tie_strain, &ties);
    find_works (c, &dead, &seismic);
    double control = along (c, displacement (c, body, arm));
    if (capacity->count > 0
        && !(control > capacity->points[capacity->count - 1].control
             && c->direction * seismic > 0))
      break;
    QnCapacityPoint point = qn_capacity_next_point (
      capacity, (ties - dead) / (c->direction * seismic), control, scale);
    if (breaks && capacity->count > 0 && capacity->broken == 0) {
      const QnCapacityPoint *before = &capacity->points[capacity->count - 1];
      lost += before->multiplier - point.multiplier;
      if (lost > LOST * capacity->points[capacity->peak].multiplier)
        capacity->broken = before->displacement;
    }
    if (!QN_ARRAY_PUSH (capacity->points, capacity->count, room, point))
      return qn_diag_no_memory (diag);
    if (point.multiplier > capacity->points[capacity->peak].multiplier)
      capacity->peak = capacity->count - 1;
    /* A chain with one freedom is right wherever its hinges close again. */
    for (size_t i = 0; i < c->n; i++)
      c->u[i] += STEP * c->size * c->v[i];
    if (!close_hinges (c))
      break;
    project (c);
  }
  capacity->end = capacity->points[capacity->count - 1].displacement;
  return QN_OK;
}

static QnStatus
refuse (QnProblem problem, QnDiag *diag)
{
  return qn_refuse (diag, problem, QN_ENTITY_MODEL, QN_NONE);
}

/* Whether every joint that moves turns: one that slides far is no hinge. */
static QnStatus
check_joints (const QnMechanism *m, const QnContacts *contacts, QnDiag *diag)
{
  for (size_t f = 0; f < m->joint_count; f++)
    if (m->joints[f].kind == QN_JOINT_SLIDING
        && fabs (m->joints[f].slip) > DEVIATION * m->largest)
      return qn_refuse (diag, QN_PROBLEM_MECHANISM_SLIDES, QN_ENTITY_BLOCK,
                        contacts->faces[f].b);
  return QN_OK;
}

static QnStatus
analyse (Chain *c, QnCapacity *capacity, const QnContacts *contacts, QnId control,
         double tie_strain, QnDiag *diag)
{
  double dead, seismic;
  QnStatus status = check_joints (c->mechanism, contacts, diag);

  if (status != QN_OK)
    return status;
  if (!add_forces (c))
    return refuse (QN_PROBLEM_CAPACITY_LOADS, diag);
  if (project (c) > DEVIATION)
    return refuse (QN_PROBLEM_MECHANISM_SLIDES, diag);
  /* Control block, M*, e* and the ratio of displacements, of the velocities as built. */
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
    qn_mass_sums_add (&sums, f->seismic, along (c, velocity (c, f->body, f->arm)));
  }
  if (!qn_capacity_set_masses (capacity, sums, farthest, c->model->gravity))
    return qn_refuse (diag, QN_PROBLEM_CAPACITY_MOTION, QN_ENTITY_BLOCK, capacity->block);
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
  capacity->unit = fabs (c->direction) * c->model->gravity;
  capacity->activation = (capacity->works[QN_WORK_DEAD] + capacity->works[QN_WORK_TIES])
                         / capacity->works[QN_WORK_LIVE];
  return follow (c, capacity, tie_strain, diag);
}

QnStatus
qn_capacity_init_kinematic (QnCapacity *capacity, const QnModel *model,
                            const QnContacts *contacts, const QnResult *result,
                            QnId control, double tie_strain, QnDiag *diag)
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
    status = analyse (&chain, capacity, contacts, control, tie_strain, diag);
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
                          double confidence, double period)
{
  const QnFloor *f = &spectrum->floor;
  QnLinearCheck check = { .demand = qn_spectrum_acceleration (spectrum, period),
                          .en_demand = NAN,
                          .en_ratio = NAN };

  check.capacity = c->activation * c->unit / (c->share * confidence);
  check.sld = check.capacity / check.demand;
  check.slv = QN_NTC_BEHAVIOUR_FACTOR * check.sld;
  if (f->height > 0) {
    QnSpectrum ground = *spectrum;
    ground.floor = (QnFloor){ 0 };
    double apart = 1 - period / f->period;
    double factor = 3 * (1 + f->height / f->building) / (1 + apart * apart) - 0.5;
    check.en_demand = fmax (factor, 1) * qn_spectrum_acceleration (&ground, 0);
    check.en_ratio = c->activation * c->unit / (confidence * check.en_demand);
  }
  return check;
}
