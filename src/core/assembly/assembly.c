#include "core/assembly/assembly-parts.h"

#include "core/base/memory.h"

#include <string.h>

/* --- Setting up ------------------------------------------------------------------------- */

static void
allocate (QnAssembly *as)
{
  QnPool *pool = &as->pool;
  size_t pairs = as->pair_count, n = (size_t) as->unknown_count;

  as->kinematics = qn_pool_alloc (pool, pairs, sizeof *as->kinematics);
  as->gradients = qn_pool_alloc (pool, pairs, sizeof *as->gradients);
  as->elongations = qn_pool_alloc (pool, 2 * (pairs + 7), sizeof *as->elongations);
  as->springs = qn_pool_alloc (pool, pairs, sizeof *as->springs);
  as->committed = qn_pool_alloc (pool, pairs, sizeof *as->committed);
  as->responses = qn_pool_alloc (pool, pairs, sizeof *as->responses);
  as->inactive = qn_pool_alloc (pool, pairs, sizeof *as->inactive);
  as->breaks = qn_pool_alloc (pool, pairs, sizeof *as->breaks);
  as->dead = qn_pool_alloc (pool, n, sizeof (double));
  as->live = qn_pool_alloc (pool, n, sizeof (double));
  as->dead_at_rest = qn_pool_alloc (pool, n, sizeof (double));
  as->live_at_rest = qn_pool_alloc (pool, n, sizeof (double));
  as->damping = qn_pool_alloc (pool, n, sizeof (double));
  as->diagonal = qn_pool_alloc (pool, n, sizeof *as->diagonal);
  as->scatter = qn_pool_alloc (pool, as->contacts->face_count * 36, sizeof *as->scatter);
  as->first_pairs =
    qn_pool_alloc (pool, as->contacts->face_count + 1, sizeof *as->first_pairs);
  as->forces = qn_pool_alloc (pool, qn_model_body_count (as->model) * QN_DOF_COUNT,
                              sizeof *as->forces);
  as->settles = qn_pool_alloc (pool, n, sizeof *as->settles);
  as->loose = qn_pool_alloc (pool, qn_model_body_count (as->model), sizeof *as->loose);
  as->face_unknowns = qn_pool_alloc (pool, as->contacts->face_count * QN_FACE_UNKNOWNS,
                                     sizeof *as->face_unknowns);
  for (size_t p = 0; !pool->failed && p < pairs; p++)
    as->breaks[p] = NAN;
}

/* Marks the supports that settle in any of the loads. */
static void
mark_settling (const QnLoad *loads, size_t count, int32_t *unknown)
{
  for (size_t i = 0; i < count; i++)
    if (loads[i].kind == QN_LOAD_SETTLEMENT)
      unknown[QN_DOF_COUNT * loads[i].block + (int) loads[i].dof] = 1;
}

static void
number_unknowns (QnAssembly *as)
{
  const QnModel *model = as->model;

  const size_t count = qn_model_body_count (model) * QN_DOF_COUNT;

  as->unknown = qn_pool_alloc (&as->pool, count, sizeof *as->unknown);
  if (as->unknown == NULL)
    return;
  mark_settling (model->dead_loads, model->dead_load_count, as->unknown);
  mark_settling (model->live_loads, model->live_load_count, as->unknown);
  as->settling_count = 0;
  for (size_t i = 0; i < model->block_count * QN_DOF_COUNT; i++)
    as->settling_count += as->unknown[i] != 0;
  as->settling = qn_pool_alloc (&as->pool, as->settling_count, sizeof *as->settling);
  if (as->settling == NULL)
    return;

  QnSettling *next = as->settling;
  as->unknown_count = 0;
  for (size_t i = 0; i < count; i++) {
    bool settles = as->unknown[i] != 0;
    bool fixed =
      qn_model_body_is_fixed (model, i / QN_DOF_COUNT, (QnDof) (i % QN_DOF_COUNT));
    if (settles)
      *next++ = (QnSettling){ as->unknown_count, (QnId) (i / QN_DOF_COUNT), 0 };
    as->unknown[i] = fixed && !settles ? QN_NONE : as->unknown_count++;
  }
}

void
qn_assembly_place_pair (QnAssembly *as, size_t p)
{
  const QnContactPair *pair = &as->contacts->pairs[p];
  const QnContactFace *face = &as->contacts->faces[pair->face];
  QnVec2 from = pair->found ? pair->foot : pair->point;

  qn_pair_kinematics_init (&as->kinematics[p], face->normal,
                           qn_vec2_sub (from, as->model->blocks[face->a].centroid),
                           qn_vec2_sub (pair->point, as->model->blocks[face->b].centroid),
                           as->length);
  if (pair->found)
    qn_pair_kinematics_set_corner (&as->kinematics[p], qn_vec2_sub (pair->point, from));
  as->gradients[p] = qn_pair_kinematics_gradient (&as->kinematics[p]);
}

/* Pattern of K: every block couples with itself and with the blocks it touches. */
static void
build_pattern (QnAssembly *as)
{
  const QnContacts *contacts = as->contacts;
  size_t bodies = qn_model_body_count (as->model);
  QnSparsePattern pattern;

  qn_sparse_pattern_init (&pattern, as->unknown_count,
                          bodies * 9 + (contacts->face_count + as->beams.count) * 36,
                          &as->pool);
  for (size_t b = 0; b < bodies; b++)
    qn_sparse_pattern_add_clique (&pattern, as->unknown + QN_DOF_COUNT * b, QN_DOF_COUNT);
  for (size_t f = 0; f < contacts->face_count; f++)
    qn_sparse_pattern_add_clique (&pattern, as->face_unknowns + QN_FACE_UNKNOWNS * f,
                                  QN_FACE_UNKNOWNS);
  qn_beam_assembly_add_pattern (as, &pattern);
  qn_sparse_pattern_compress (&pattern, &as->ap, &as->ai);
  if (!as->pool.failed)
    as->ax =
      qn_pool_alloc (&as->pool, (size_t) as->ap[as->unknown_count], sizeof (double));
  if (as->pool.failed)
    return;
  for (size_t f = 0; f < contacts->face_count; f++) {
    /* Where a face's 6 x 6 goes in ax. */
    const int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * f;
    int32_t *scatter = as->scatter + 36 * f;
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++)
      for (int j = 0; j < QN_FACE_UNKNOWNS; j++)
        scatter[6 * i + j] = qn_sparse_find (as->ap, as->ai, unknowns[i], unknowns[j]);
  }
  qn_beam_assembly_find_places (as);
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->diagonal[i] = qn_sparse_find (as->ap, as->ai, i, i);
  for (size_t s = 0; s < as->settling_count; s++)
    as->settles[as->settling[s].unknown] = true;
}

/* What a body resists acceleration with: its weight, or its area, and the square of the radius of
 * gyration, m2. */
typedef struct {
  double mass, gyration;
} Inertia;

static Inertia
body_inertia (const QnAssembly *as, size_t body, bool weightless)
{
  const QnModel *model = as->model;
  Inertia inertia;

  if (body >= model->block_count) {
    const QnNode *node = &model->nodes[body - model->block_count];
    const QnBeamShare *share = &as->beams.shares[body - model->block_count];
    bool rides = node->block != QN_NONE; /* its load acts on the block */
    inertia.mass = rides ? 0 : weightless ? share->volume : share->weight;
    inertia.gyration = share->longest * share->longest / 12;
  } else {
    const QnBlock *block = &model->blocks[body];
    inertia.mass = weightless ? block->area : block->weight;
    inertia.gyration = block->polar_moment / block->area;
  }
  return inertia;
}

/* Mean normal stiffness of a pair; without pairs what a beam as large as the whole offers against
 * sway, however finely it is cut. */
static double
mean_stiffness (const QnAssembly *as)
{
  double sum = 0;

  if (as->pair_count == 0)
    return qn_beam_assembly_stiffness (as);
  for (size_t p = 0; p < as->pair_count; p++) {
    double k[2];
    qn_pair_elastic_stiffness (&as->springs[p], k);
    sum += log (k[0]);
  }
  return exp (sum / (double) as->pair_count);
}

/* Stiffness of the softest spring, normal or tangential, or tie, over the mean stiffness; at most 1. */
static double
softness (const QnAssembly *as)
{
  double softest = as->stiffness;

  for (size_t p = 0; p < as->pair_count; p++) {
    double k[2];
    qn_pair_elastic_stiffness (&as->springs[p], k);
    softest = fmin (softest, fmin (k[0], k[1]));
  }
  for (size_t b = as->model->element_count; b < as->beams.count; b++)
    softest = fmin (softest, as->beams.beams[b].properties.axial);
  return softest / as->stiffness;
}

/* Diagonal of C: the mean stiffness, distributed like mass (like area where nothing has weight),
 * with the radius of gyration for rotations. */
static void
prepare_damping (QnAssembly *as)
{
  const QnModel *model = as->model;
  size_t bodies = qn_model_body_count (model);
  double total = 0;
  bool weightless = true;

  as->stiffness = mean_stiffness (as);
  as->softness = softness (as);
  for (size_t b = 0; b < model->block_count && weightless; b++)
    weightless = model->blocks[b].weight <= 0;
  for (size_t i = 0; i < model->section_count && weightless; i++)
    weightless = model->sections[i].unit_weight <= 0;
  for (size_t b = 0; b < bodies; b++)
    total += body_inertia (as, b, weightless).mass;

  double mean = total / (double) bodies;
  for (size_t b = 0; b < bodies; b++) {
    Inertia inertia = body_inertia (as, b, weightless);
    double mass = weightless ? inertia.mass : fmax (inertia.mass, 1e-3 * mean);
    double c = as->stiffness * mass / mean;
    double gyration = inertia.gyration / (as->length * as->length);
    for (int i = 0; i < QN_DOF_COUNT; i++) {
      int32_t unknown = as->unknown[QN_DOF_COUNT * b + (size_t) i];
      if (unknown != QN_NONE && !as->settles[unknown])
        as->damping[unknown] = i == QN_DOF_RZ ? c * gyration : c;
    }
  }
}

QnStatus
qn_assembly_setup (QnAssembly *as, const QnModel *model, const QnContacts *contacts,
                   QnDiag *diag)
{
  *as = (QnAssembly){ .model = model,
                      .contacts = contacts,
                      .length = model->characteristic_length,
                      .nonlinear = model->analysis.geometry == QN_GEOMETRY_NONLINEAR,
                      .pair_count = contacts->pair_count };

  number_unknowns (as);
  allocate (as);
  qn_beam_assembly_setup (as);
  for (size_t p = 0; p < as->pair_count && !as->pool.failed; p++) {
    qn_assembly_place_pair (as, p);
    as->springs[p] = qn_contacts_pair_springs (as->model, as->contacts, p);
    as->has_bonds |=
      qn_spring_has_bond (&as->springs[p].a) || qn_spring_has_bond (&as->springs[p].b);
  }
  /* What the inner loops need of faces. */
  if (!as->pool.failed)
    as->first_pairs[as->contacts->face_count] = (int32_t) as->pair_count;
  for (size_t f = 0; f < as->contacts->face_count && !as->pool.failed; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * f;
    as->first_pairs[f] = face->first_pair;
    for (int i = 0; i < QN_DOF_COUNT; i++) {
      unknowns[i] = as->unknown[QN_DOF_COUNT * face->a + i];
      unknowns[QN_DOF_COUNT + i] = as->unknown[QN_DOF_COUNT * face->b + i];
    }
  }
  if (!as->pool.failed)
    build_pattern (as);
  if (!as->pool.failed) {
    prepare_damping (as);
    qn_assembly_gather_loads (as);
  }
  if (!as->pool.failed)
    return QN_OK;
  qn_assembly_clear (as);
  return qn_diag_no_memory (diag);
}

void
qn_assembly_clear (QnAssembly *as)
{
  qn_pool_clear (&as->pool);
  *as = (QnAssembly){ 0 };
}

/* --- Evaluating ------------------------------------------------------------------------- */

void
qn_assembly_update_kinematics (QnAssembly *as, const double *u)
{
  qn_assembly_move_faces (as, u);
  qn_beam_assembly_update_kinematics (as, u);
  if (as->nonlinear)
    qn_assembly_turn_loads (as, u);
  for (size_t s = 0; s < as->settling_count; s++)
    as->settling[s].u = u[as->settling[s].unknown];
}

bool
qn_assembly_evaluate (QnAssembly *as, const double *u)
{
  bool ok = true;

  qn_assembly_update_kinematics (as, u);
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->inactive[p])
      as->responses[p] =
        (QnPairResponse){ .memory = as->committed[p], .state = QN_PAIR_OPEN };
    else
      ok &= qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                              &as->responses[p]);
  qn_beam_assembly_evaluate (as);
  return ok;
}

double
qn_assembly_residual (const QnAssembly *as, double multiplier, double *residual)
{
  return qn_assembly_residual_of (as, multiplier, as->responses[0].force,
                                  sizeof *as->responses / sizeof (double), residual);
}

double
qn_assembly_residual_of (const QnAssembly *as, double multiplier, const double *forces,
                         size_t stride, double *residual)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    residual[i] = as->settles[i] ? 0 : as->dead[i] + multiplier * as->live[i];
  double scale = fmax (as->force_scale, qn_assembly_largest (as, residual, NULL));
  qn_assembly_subtract_face_forces (as, forces, stride, residual);
  qn_beam_assembly_subtract_forces (as, residual);
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    residual[i] =
      as->dead[i] + multiplier * as->live[i] - as->stiffness * as->settling[s].u;
  }
  return scale;
}

double
qn_assembly_gap (const QnAssembly *as, size_t pair)
{
  const QnPairMemory *memory = &as->committed[pair];
  double gap = as->elongations[2 * pair] - memory->a.opening;

  return as->springs[pair].equal ? gap : gap - memory->b.opening;
}

void
qn_assembly_commit (QnAssembly *as)
{
  for (size_t p = 0; p < as->pair_count; p++)
    as->committed[p] = as->responses[p].memory;
  qn_beam_assembly_commit (as);
  as->commits++;
}

/* --- Bonds ------------------------------------------------------------------------------- */

/* Bonds with at least this part of the largest excess over the strength break at once. */
#define BREAK_TOGETHER 0.5

static void
evaluate_again (QnAssembly *as, size_t p)
{
  qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                    &as->responses[p]);
}

void
qn_assembly_hold_bonds (QnAssembly *as)
{
  for (size_t p = 0; as->has_bonds && p < as->pair_count; p++) {
    bool broke = qn_pair_damage (&as->springs[p], &as->responses[p].memory)
                 > qn_pair_damage (&as->springs[p], &as->committed[p]);
    qn_bond_hold (&as->springs[p].a, &as->committed[p].a);
    qn_bond_hold (&as->springs[p].b, &as->committed[p].b);
    as->breaks[p] = NAN;
    if (broke)
      evaluate_again (as, p);
  }
}

static double
strain_of (const QnSpring *spring, const QnSpringMemory *before, const double force[2])
{
  return qn_spring_bond_strain (spring, force) / (1 - qn_spring_damage (spring, before));
}

/* Whether a bond that is held is to break; by how much it is strained. */
static bool
is_to_break (const QnAssembly *as, size_t p, double *strain)
{
  const QnPairResponse *r = &as->responses[p];
  const QnPairMemory *before = &as->committed[p];
  double a = NAN, b = NAN;

  if (r->memory.a.extreme == QN_BOND_BREAKS)
    a = strain_of (&as->springs[p].a, &before->a, r->force);
  if (!as->springs[p].equal && r->memory.b.extreme == QN_BOND_BREAKS)
    b = strain_of (&as->springs[p].b, &before->b, r->force);
  *strain = fmax (a, b);
  return !isnan (*strain);
}

bool
qn_assembly_break_bonds (QnAssembly *as)
{
  double most = -INFINITY,
         strain; /* below 1 where friction relieves what is left of a bond */
  bool any = false;

  for (size_t p = 0; as->has_bonds && p < as->pair_count; p++)
    if (!as->inactive[p] && is_to_break (as, p, &strain)) {
      any = true;
      most = fmax (most, strain);
    }
  for (size_t p = 0; any && p < as->pair_count; p++)
    if (!as->inactive[p] && is_to_break (as, p, &strain)
        && strain - 1 >= fmin (BREAK_TOGETHER * (most - 1), most - 1)) {
      bool in_a = as->responses[p].memory.a.extreme == QN_BOND_BREAKS;
      QnSpringMemory *memory = in_a ? &as->committed[p].a : &as->committed[p].b;
      as->breaks[p] = qn_bond_held (memory->extreme);
      memory->extreme = 1;
      evaluate_again (as, p);
    }
  return any;
}

void
qn_assembly_let_bonds (QnAssembly *as, bool found)
{
  for (size_t p = 0; as->has_bonds && p < as->pair_count; p++)
    for (int side = 0; side < 2; side++) {
      QnSpringMemory *memory = side == 0 ? &as->committed[p].a : &as->committed[p].b;
      bool bond = qn_spring_has_bond (side == 0 ? &as->springs[p].a : &as->springs[p].b);
      if (bond && memory->extreme < 0)
        memory->extreme = qn_bond_held (memory->extreme);
      else if (bond && !found && !isnan (as->breaks[p]) && memory->extreme == 1)
        memory->extreme = as->breaks[p];
    }
}

static void
expand_unknowns (const QnAssembly *as, const double *u, double *rows)
{
  for (size_t i = 0; i < qn_model_body_count (as->model) * QN_DOF_COUNT; i++) {
    double value = as->unknown[i] == QN_NONE ? 0 : u[as->unknown[i]];
    rows[i] = i % QN_DOF_COUNT == QN_DOF_RZ ? value / as->length : value;
  }
}

void
qn_assembly_collect (const QnAssembly *as, const double *rows, double *u)
{
  for (size_t i = 0; i < qn_model_body_count (as->model) * QN_DOF_COUNT; i++)
    if (as->unknown[i] != QN_NONE)
      u[as->unknown[i]] = i % QN_DOF_COUNT == QN_DOF_RZ ? rows[i] * as->length : rows[i];
}

void
qn_assembly_expand (const QnAssembly *as, const double *u, double *displacements)
{
  expand_unknowns (as, u, displacements);
  qn_model_move_riding_nodes (as->model, as->nonlinear, displacements);
}

void
qn_assembly_expand_rates (const QnAssembly *as, const double *u, const double *rates,
                          double *velocities)
{
  const QnModel *model = as->model;

  expand_unknowns (as, rates, velocities);
  for (size_t i = 0; i < model->node_count; i++) {
    const QnNode *node = &model->nodes[i];
    if (node->block == QN_NONE)
      continue;
    const int32_t turning = as->unknown[QN_DOF_COUNT * node->block + QN_DOF_RZ];
    double rz = as->nonlinear && turning != QN_NONE ? u[turning] / as->length : 0;
    QnVec2 arm = qn_vec2_sub (node->at, model->blocks[node->block].centroid);
    qn_body_velocity_at (velocities + QN_DOF_COUNT * node->block,
                         qn_vec2_rotate (arm, cos (rz), sin (rz)),
                         velocities + QN_DOF_COUNT * (model->block_count + i));
  }
}

bool
qn_assembly_may_jump (const QnAssembly *as)
{
  bool plastic = false;

  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairSprings *springs = &as->springs[p];
    if (springs->a.dilatancy < springs->a.friction
        || springs->b.dilatancy < springs->b.friction || qn_spring_has_bond (&springs->a))
      return true;
    plastic |= qn_pair_is_plastic (springs, &as->committed[p]);
  }
  return !plastic;
}

bool
qn_assembly_may_soften (const QnAssembly *as)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (qn_spring_softening (&as->springs[p].a) > 0
        || qn_spring_softening (&as->springs[p].b) > 0)
      return true;
  return false;
}

/* C = A + qa in the frame of the pair,  A = centroid + u_a + arm */
static QnVec2
hinge_position (const QnAssembly *as, size_t pair, const double *u)
{
  const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[pair].face];
  const QnPairKinematics *k = &as->kinematics[pair];
  const double *qa = as->responses[pair].memory.qa;
  double v[QN_FACE_UNKNOWNS];

  qn_assembly_gather (as, (size_t) as->contacts->pairs[pair].face, u, v);
  QnVec2 arm = k->turned_a;
  if (as->model->analysis.geometry == QN_GEOMETRY_LINEAR)
    arm = qn_vec2_add_scaled (k->arm_a, v[2] / as->length, qn_vec2_perp (k->arm_a));
  QnVec2 a = qn_vec2_add (as->model->blocks[face->a].centroid, arm);
  a = qn_vec2_add (a, qn_vec2 (v[0], v[1]));
  return qn_vec2_add_scaled (qn_vec2_add_scaled (a, qa[0], k->frame), qa[1],
                             qn_vec2_perp (k->frame));
}

void
qn_assembly_pair_results (const QnAssembly *as, const double *u, QnPairResult *results)
{
  double largest = 0;

  for (size_t p = 0; p < as->pair_count; p++)
    largest =
      fmax (largest, hypot (as->responses[p].force[0], as->responses[p].force[1]));
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairResponse *response = &as->responses[p];
    results[p] = (QnPairResult){
      .state = response->state,
      .normal_force = response->force[0],
      .shear_force = response->force[1],
      .damage = qn_pair_damage (&as->springs[p], &response->memory),
      .has_springs = true,
      .hinge = hinge_position (as, p, u),
    };
    if (qn_pair_is_plastic (&as->springs[p], &response->memory))
      results[p].state =
        qn_pair_state_of_force (&as->springs[p], &response->memory, results[p].state,
                                response->force, QN_NO_FORCE * largest);
    memcpy (results[p].elongation_a, response->memory.qa, sizeof response->memory.qa);
    memcpy (results[p].elongation_b, response->memory.qb, sizeof response->memory.qb);
  }
}
