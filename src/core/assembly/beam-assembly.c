/* Beam elements and ties within the assembled structure. */
#include "core/assembly/assembly-parts.h"

#include <math.h>
#include <string.h>

/* --- Setting up ------------------------------------------------------------------------- */

QnBeamProperties
qn_beam_properties (const QnModel *model, QnId index)
{
  const QnBeamElement *element = &model->elements[index];
  const QnBeam *beam = &model->beams[element->beam];
  const QnSection *section = &model->sections[beam->section];
  const double plastic = qn_section_plastic_moment (section);
  QnBeamProperties p = { .chord = qn_vec2_sub (model->nodes[element->nodes[1]].at,
                                               model->nodes[element->nodes[0]].at) };

  p.length = qn_vec2_length (p.chord);
  p.axial = section->young * section->area / p.length;
  p.bending = section->young * section->inertia / p.length;
  if (beam->kind == QN_BEAM_TIMOSHENKO)
    p.phi = 12 * p.bending
            / (section->shear_factor * qn_section_shear_modulus (section) * section->area
               * p.length);
  for (int end = 0; end < 2; end++) {
    p.moments[end] = element->yields[end] ? plastic : INFINITY;
    if (element->hinge[end])
      p.moments[end] = 0;
  }
  if (model->gravity > 0) {
    double density = section->unit_weight / model->gravity;
    p.mass = density * section->area;
    /* Euler and Bernoulli neglect the inertia of turning together with the shear. */
    p.rotary = beam->kind == QN_BEAM_TIMOSHENKO ? density * section->inertia : 0;
  }
  return p;
}

static QnBeamProperties
tie_properties (const QnTie *tie)
{
  QnBeamProperties p = { .tie = tie,
                         .chord = qn_vec2_sub (tie->ends[1].at, tie->ends[0].at),
                         .length = qn_tie_length (tie),
                         .axial = qn_tie_stiffness (tie) };

  p.rest = tie->slack - tie->prestress / p.axial;
  return p;
}

static void
place (QnAssembly *as, size_t index)
{
  const QnModel *model = as->model;
  const size_t elements = model->element_count;
  const QnTie *tie = index < elements ? NULL : qn_model_tie (model, index - elements);
  QnAssembledBeam *beam = &as->beams.beams[index];

  beam->properties =
    tie != NULL ? tie_properties (tie) : qn_beam_properties (model, (QnId) index);
  for (int end = 0; end < 2; end++) {
    QnVec2 at;
    QnId block;
    if (tie != NULL) {
      block = tie->ends[end].block;
      at = tie->ends[end].at;
      beam->bodies[end] = block != QN_NONE ? (size_t) block : QN_GROUND;
    } else {
      QnId node = model->elements[index].nodes[end];
      block = model->nodes[node].block;
      at = model->nodes[node].at;
      beam->bodies[end] = qn_model_node_body (model, node);
    }
    if (block != QN_NONE)
      beam->arms[end] = qn_vec2_sub (at, model->blocks[block].centroid);
    beam->turned[end] = beam->arms[end];
    for (int i = 0; i < QN_DOF_COUNT; i++)
      beam->unknowns[3 * end + i] =
        beam->bodies[end] == QN_GROUND
          ? QN_NONE
          : as->unknown[QN_DOF_COUNT * beam->bodies[end] + (size_t) i];
  }
  qn_beam_kinematics_init (&beam->kinematics, &beam->properties);
}

double
qn_beam_assembly_stiffness (const QnAssembly *as)
{
  const QnModel *model = as->model;
  QnVec2 low = { INFINITY, INFINITY }, high = { -INFINITY, -INFINITY };
  double sum = 0;

  if (as->beams.count == 0)
    return 1;
  for (size_t i = 0; i < model->node_count; i++) {
    QnVec2 at = model->nodes[i].at;
    low = qn_vec2 (fmin (low.x, at.x), fmin (low.y, at.y));
    high = qn_vec2 (fmax (high.x, at.x), fmax (high.y, at.y));
  }
  double extent = qn_vec2_length (qn_vec2_sub (high, low));
  for (size_t i = 0; i < as->beams.count; i++) {
    const QnBeamProperties *p = &as->beams.beams[i].properties;
    sum +=
      log (p->tie != NULL ? p->axial
                          : 12 * p->bending * p->length / (extent * extent * extent));
  }
  return exp (sum / (double) as->beams.count);
}

void
qn_beam_assembly_setup (QnAssembly *as)
{
  const QnModel *model = as->model;
  size_t count = model->element_count + qn_model_tie_count (model);
  QnPool *pool = &as->pool;
  QnBeamAssembly *beams = &as->beams;

  beams->count = count;
  beams->beams = qn_pool_alloc (pool, count, sizeof *beams->beams);
  beams->committed = qn_pool_alloc (pool, count, sizeof *beams->committed);
  beams->responses = qn_pool_alloc (pool, count, sizeof *beams->responses);
  beams->loads[0] = qn_pool_alloc (pool, count, sizeof *beams->loads[0]);
  beams->loads[1] = qn_pool_alloc (pool, count, sizeof *beams->loads[1]);
  beams->scratch = qn_pool_alloc (pool, count, sizeof *beams->scratch);
  beams->assembled_phases = qn_pool_alloc (pool, count, sizeof *beams->assembled_phases);
  beams->shares = qn_pool_alloc (pool, model->node_count, sizeof *beams->shares);
  if (pool->failed)
    return;
  for (size_t i = 0; i < count; i++)
    place (as, i);
  for (size_t i = 0; i < model->element_count; i++) {
    const QnBeamElement *element = &model->elements[i];
    const QnSection *section = &model->sections[model->beams[element->beam].section];
    double length = as->beams.beams[i].properties.length;
    for (int end = 0; end < 2; end++) {
      QnBeamShare *share = &as->beams.shares[element->nodes[end]];
      share->weight += 0.5 * length * qn_section_weight (section);
      share->volume += 0.5 * length * section->area;
      share->longest = fmax (share->longest, length);
    }
  }
}

void
qn_beam_assembly_add_pattern (const QnAssembly *as, QnSparsePattern *pattern)
{
  for (size_t i = 0; i < as->beams.count; i++)
    qn_sparse_pattern_add_clique (pattern, as->beams.beams[i].unknowns, 6);
}

void
qn_beam_assembly_find_places (QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    QnAssembledBeam *beam = &as->beams.beams[b];
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++)
        beam->scatter[6 * i + j] =
          qn_sparse_find (as->ap, as->ai, beam->unknowns[i], beam->unknowns[j]);
  }
}

/* --- Bodies and nodes -------------------------------------------------------------------- */

/* dv / dx = T: displacements of the nodes from those of the bodies,
 *   v = u + perp (r) rz,  rz = x / L */
static void
transform (const QnAssembledBeam *beam, double length, double t[6][6])
{
  memset (t, 0, 36 * sizeof (double));
  for (int end = 0; end < 2; end++) {
    const int k = 3 * end;
    t[k][k] = t[k + 1][k + 1] = 1;
    t[k][k + 2] = -beam->turned[end].y / length;
    t[k + 1][k + 2] = beam->turned[end].x / length;
    t[k + 2][k + 2] = 1 / length;
  }
}

/* out = T' k T */
static void
transform_matrix (const QnAssembledBeam *beam, double length, double k[6][6],
                  double out[6][6])
{
  double t[6][6], kt[6][6];

  transform (beam, length, t);

  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) {
      kt[i][j] = 0;
      for (int m = 0; m < 6; m++)
        kt[i][j] += k[i][m] * t[m][j];
    }
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) {
      out[i][j] = 0;
      for (int m = 0; m < 6; m++)
        out[i][j] += t[m][i] * kt[m][j];
    }
}

/* Forces on the nodes that the element exerts on itself: P = G' s */
static void
node_forces (const QnAssembledBeam *beam, const QnBeamResponse *response, double p[6])
{
  for (int j = 0; j < 6; j++) {
    p[j] = 0;
    for (int i = 0; i < 3; i++)
      p[j] += beam->kinematics.gradient[i][j] * response->force[i];
  }
}

void
qn_beam_assembly_update_kinematics (QnAssembly *as, const double *u)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    QnAssembledBeam *beam = &as->beams.beams[b];
    double v[6];

    for (int i = 0; i < 6; i++)
      v[i] = beam->unknowns[i] == QN_NONE ? 0 : u[beam->unknowns[i]];
    for (int end = 0; end < 2; end++) {
      double *at = v + 3 * end;
      at[2] /= as->length;
      QnVec2 moved = as->nonlinear
                       ? qn_vec2_turn_away (beam->arms[end], at[2])
                       : qn_vec2_scale (at[2], qn_vec2_perp (beam->arms[end]));
      if (as->nonlinear)
        beam->turned[end] = qn_vec2_add (beam->arms[end], moved);
      at[0] += moved.x;
      at[1] += moved.y;
    }
    qn_beam_kinematics_update (&beam->kinematics, &beam->properties, v, as->nonlinear);
  }
}

/* --- Loads ------------------------------------------------------------------------------- */

static bool
can_yield (const QnBeamProperties *p)
{
  return (p->moments[0] > 0 && isfinite (p->moments[0]))
         || (p->moments[1] > 0 && isfinite (p->moments[1]));
}

/* Moments that hold a distributed load q (N/m, in the axes of the model) at the ends. */
static void
held_moments (const QnAssembly *as, size_t element, QnVec2 q, double moments[2])
{
  const QnAssembledBeam *beam = &as->beams.beams[element];

  moments[0] = moments[1] = 0;
  if (!as->nonlinear && !can_yield (&beam->properties))
    qn_beam_fixed_end_moments (
      &beam->properties, qn_vec2_dot (q, qn_vec2_perp (beam->kinematics.axis)), moments);
}

void
qn_beam_assembly_set_loads (QnAssembly *as, const double *held, const double *driven)
{
  qn_model_element_loads (as->model, driven, as->beams.loads[1]);
  qn_model_element_loads (as->model, held, as->beams.loads[0]);
  qn_model_element_loads (as->model, NULL, as->beams.scratch);
  for (size_t b = 0; b < as->beams.count; b++)
    as->beams.loads[0][b] = qn_vec2_add (as->beams.loads[0][b], as->beams.scratch[b]);
}

/* Forces and moments of a load q on an element at its two nodes. */
static void
node_loads (const QnAssembly *as, size_t element, QnVec2 q, QnVec2 forces[2],
            double moments[2])
{
  const QnAssembledBeam *beam = &as->beams.beams[element];
  QnVec2 half = qn_vec2_scale (0.5 * beam->properties.length, q);
  double held[2];

  held_moments (as, element, q, held);
  /* The chord turns the difference of the moments into a couple of end forces. */
  QnVec2 couple = qn_vec2_scale ((held[0] + held[1]) / beam->properties.length,
                                 qn_vec2_perp (beam->kinematics.axis));
  forces[0] = qn_vec2_sub (half, couple);
  forces[1] = qn_vec2_add (half, couple);
  moments[0] = -held[0];
  moments[1] = -held[1];
}

void
qn_beam_assembly_add_loads (const QnAssembly *as, const QnVec2 *q, double *loads)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    QnVec2 forces[2];
    double moments[2];

    node_loads (as, b, q[b], forces, moments);
    for (int end = 0; end < 2; end++) {
      const int32_t *unknown = beam->unknowns + 3 * end;
      double moment = moments[end] + qn_vec2_cross (beam->arms[end], forces[end]);
      if (unknown[0] != QN_NONE)
        loads[unknown[0]] += forces[end].x;
      if (unknown[1] != QN_NONE)
        loads[unknown[1]] += forces[end].y;
      if (unknown[2] != QN_NONE)
        loads[unknown[2]] += moment / as->length;
    }
  }
}

void
qn_beam_assembly_turn_loads (QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++)
    for (int end = 0; end < 2; end++) {
      const QnAssembledBeam *beam = &as->beams.beams[b];
      QnVec2 moved = qn_vec2_sub (beam->turned[end], beam->arms[end]);
      int32_t unknown = beam->unknowns[3 * end + 2];
      for (int live = 0; live < 2 && unknown != QN_NONE; live++) {
        QnVec2 half =
          qn_vec2_scale (0.5 * beam->properties.length, as->beams.loads[live][b]);
        (live ? as->live : as->dead)[unknown] += qn_vec2_cross (moved, half) / as->length;
      }
    }
}

/* A force at the arm r of a block that turns loses -d(r x F)/drz = r . F of its moment. */
void
qn_beam_assembly_add_load_stiffness (QnAssembly *as, double multiplier)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    QnVec2 q =
      qn_vec2_add_scaled (as->beams.loads[0][b], multiplier, as->beams.loads[1][b]);
    QnVec2 half = qn_vec2_scale (0.5 * beam->properties.length, q);
    for (int end = 0; end < 2; end++) {
      int32_t place = beam->scatter[7 * (3 * end + 2)];
      if (place != QN_NONE)
        as->ax[place] +=
          qn_vec2_dot (beam->turned[end], half) / (as->length * as->length);
    }
  }
}

void
qn_beam_assembly_add_body_forces (const QnAssembly *as, double multiplier, double *forces)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    QnVec2 q = qn_vec2_add_scaled (as->beams.loads[0][b], multiplier,
                                   as->beams.loads[1][b]),
           loads[2];
    double p[6], moments[2];

    node_forces (beam, &as->beams.responses[b], p);
    node_loads (as, b, q, loads, moments);
    for (int end = 0; end < 2; end++) {
      if (beam->bodies[end] == QN_GROUND)
        continue;
      double *out = forces + QN_DOF_COUNT * beam->bodies[end];
      QnVec2 force = qn_vec2_sub (qn_vec2 (p[3 * end], p[3 * end + 1]), loads[end]);
      out[QN_DOF_UX] += force.x;
      out[QN_DOF_UY] += force.y;
      out[QN_DOF_RZ] +=
        p[3 * end + 2] - moments[end] + qn_vec2_cross (beam->turned[end], force);
    }
  }
}

/* --- Evaluating ------------------------------------------------------------------------- */

void
qn_beam_assembly_evaluate (QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnBeamProperties *p = &as->beams.beams[b].properties;
    (p->tie != NULL ? qn_tie_evaluate : qn_beam_evaluate) (
      p, &as->beams.committed[b], as->beams.beams[b].kinematics.deformation,
      &as->beams.responses[b]);
  }
}

void
qn_beam_assembly_subtract_forces (const QnAssembly *as, double *residual)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    double p[6];

    node_forces (beam, &as->beams.responses[b], p);
    for (int end = 0; end < 2; end++) {
      const int k = 3 * end;
      QnVec2 force = qn_vec2 (p[k], p[k + 1]);
      p[k + 2] = (p[k + 2] + qn_vec2_cross (beam->turned[end], force)) / as->length;
    }
    for (int i = 0; i < 6; i++)
      if (beam->unknowns[i] != QN_NONE)
        residual[beam->unknowns[i]] -= p[i];
  }
}

/* k = G' D G */
static void
material_tangent (const QnAssembly *as, size_t index, double k[6][6])
{
  const QnAssembledBeam *beam = &as->beams.beams[index];
  const double (*g)[6] = beam->kinematics.gradient;
  const QnBeamResponse *response = &as->beams.responses[index];

  for (int j = 0; j < 6; j++) {
    double dg[3];
    for (int i = 0; i < 3; i++) {
      dg[i] = 0;
      for (int m = 0; m < 3; m++)
        dg[i] += response->tangent[i][m] * g[m][j];
    }
    for (int i = 0; i < 6; i++)
      k[i][j] = g[0][i] * dg[0] + g[1][i] * dg[1] + g[2][i] * dg[2];
  }
}

/* k = T' (G' D G + geometric) T - r . F of arms that turn */
static void
element_tangent (const QnAssembly *as, size_t index, double out[6][6])
{
  const QnAssembledBeam *beam = &as->beams.beams[index];
  const QnBeamResponse *response = &as->beams.responses[index];
  double k[6][6], p[6];

  material_tangent (as, index, k);
  if (as->nonlinear)
    qn_beam_kinematics_add_stiffness (&beam->kinematics, response->force, k);
  transform_matrix (beam, as->length, k, out);
  if (!as->nonlinear)
    return;
  node_forces (beam, response, p);
  for (int end = 0; end < 2; end++)
    out[3 * end + 2][3 * end + 2] -=
      qn_vec2_dot (beam->turned[end], qn_vec2 (p[3 * end], p[3 * end + 1]))
      / (as->length * as->length);
}

static void
add_matrix (const QnAssembledBeam *beam, double k[6][6], double *ax)
{
  for (int i = 0; i < 36; i++)
    if (beam->scatter[i] != QN_NONE)
      ax[beam->scatter[i]] += k[i / 6][i % 6];
}

void
qn_beam_assembly_add_tangent (QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    double k[6][6];
    element_tangent (as, b, k);
    add_matrix (&as->beams.beams[b], k, as->ax);
    as->beams.assembled_phases[b] = as->beams.responses[b].phase;
  }
}

void
qn_beam_assembly_add_material_tangent (const QnAssembly *as, double *ax)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    double k[6][6], out[6][6];

    material_tangent (as, b, k);
    transform_matrix (&as->beams.beams[b], as->length, k, out);
    add_matrix (&as->beams.beams[b], out, ax);
  }
}

/* Along the chord as it lies, with the mass of the undeformed length. */
static void
moved_mass (const QnAssembledBeam *beam, double m[6][6])
{
  QnBeamProperties now = beam->properties;

  now.chord = qn_vec2_scale (now.length, beam->kinematics.axis);
  qn_beam_mass (&now, m);
}

void
qn_beam_assembly_add_mass (const QnAssembly *as, double *ax)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    double m[6][6], out[6][6];

    moved_mass (&as->beams.beams[b], m);
    transform_matrix (&as->beams.beams[b], as->length, m, out);
    add_matrix (&as->beams.beams[b], out, ax);
  }
}

void
qn_beam_assembly_add_inertia (const QnAssembly *as, QnVec2 acceleration, double *forces)
{
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    double m[6][6];

    moved_mass (beam, m);
    for (int end = 0; end < 2; end++) {
      double p[3];
      for (int i = 0; i < 3; i++)
        p[i] = (m[3 * end + i][0] + m[3 * end + i][3]) * acceleration.x
               + (m[3 * end + i][1] + m[3 * end + i][4]) * acceleration.y;
      p[2] =
        (p[2] + qn_vec2_cross (beam->turned[end], qn_vec2 (p[0], p[1]))) / as->length;
      for (int i = 0; i < 3; i++)
        if (beam->unknowns[3 * end + i] != QN_NONE)
          forces[beam->unknowns[3 * end + i]] += p[i];
    }
  }
}

bool
qn_beam_assembly_has_changed (const QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++)
    if (as->beams.assembled_phases[b] != as->beams.responses[b].phase)
      return true;
  return false;
}

void
qn_beam_assembly_commit (QnAssembly *as)
{
  for (size_t b = 0; b < as->beams.count; b++)
    as->beams.committed[b] = as->beams.responses[b].memory;
}

void
qn_beam_assembly_ties (const QnAssembly *as, QnTieResult *ties)
{
  const size_t elements = as->model->element_count;

  for (size_t b = elements; b < as->beams.count; b++) {
    double force = as->beams.responses[b].force[0];
    ties[b - elements] =
      (QnTieResult){ .force = force,
                     .elongation = as->beams.beams[b].kinematics.deformation[0],
                     .state =
                       qn_tie_state (as->beams.beams[b].properties.tie, force, 0) };
  }
}

double
qn_beam_assembly_tie_gap (const QnAssembly *as, size_t tie)
{
  size_t b = as->model->element_count + tie;

  return as->beams.beams[b].properties.rest + as->beams.responses[b].memory.stretch
         - as->beams.beams[b].kinematics.deformation[0];
}

double
qn_beam_assembly_tie_rate (const QnAssembly *as, size_t tie, const double *v)
{
  const QnAssembledBeam *beam = &as->beams.beams[as->model->element_count + tie];
  double rate = 0;

  for (int end = 0; end < 2; end++) {
    const int32_t *unknowns = beam->unknowns + 3 * end;
    double at[3];
    for (int i = 0; i < QN_DOF_COUNT; i++)
      at[i] = unknowns[i] != QN_NONE ? v[unknowns[i]] : 0;
    QnVec2 moves = qn_vec2_add_scaled (qn_vec2 (at[0], at[1]), at[2] / as->length,
                                       qn_vec2_perp (beam->turned[end]));
    rate += (end == 0 ? -1 : 1) * qn_vec2_dot (beam->kinematics.axis, moves);
  }
  return rate;
}

void
qn_beam_assembly_tension (QnAssembly *as)
{
  for (size_t b = as->model->element_count; b < as->beams.count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    QnBeamResponse *response = &as->beams.responses[b];
    if (beam->properties.tie->prestress == 0)
      continue;
    const double force = response->force[0];
    QnBeamMemory memory = { .stretch = beam->kinematics.deformation[0]
                                       - beam->properties.rest
                                       - force / beam->properties.axial,
                            .tensioned = true };
    qn_tie_evaluate (&beam->properties, &memory, beam->kinematics.deformation, response);
    response->force[0] = force; /* without rounding */
  }
}

void
qn_beam_assembly_forces (const QnAssembly *as, double multiplier, QnBeamForces *forces)
{
  for (size_t b = 0; b < as->model->element_count; b++) {
    const QnAssembledBeam *beam = &as->beams.beams[b];
    const double *force = as->beams.responses[b].force;
    QnVec2 q =
      qn_vec2_add_scaled (as->beams.loads[0][b], multiplier, as->beams.loads[1][b]);
    QnVec2 x = beam->kinematics.axis, y = qn_vec2_perp (x);
    double half = 0.5 * beam->properties.length, held[2];

    held_moments (as, b, q, held);
    double first = force[1] + held[0], second = force[2] + held[1];
    double shear = (first + second) / beam->kinematics.length;
    double along = half * qn_vec2_dot (q, x), across = half * qn_vec2_dot (q, y);
    forces[b] = (QnBeamForces){ .normal = { force[0] + along, force[0] - along },
                                .shear = { shear - across, shear + across },
                                .moment = { -first, second } };
  }
}

/* --- States ----------------------------------------------------------------------------- */

void
qn_beam_state_init (QnBeamState *state, const QnAssembly *as, QnPool *pool)
{
  state->memory = qn_pool_alloc (pool, as->beams.count, sizeof *state->memory);
  state->responses = qn_pool_alloc (pool, as->beams.count, sizeof *state->responses);
}

void
qn_beam_state_save (QnBeamState *state, const QnAssembly *as)
{
  memcpy (state->memory, as->beams.committed, as->beams.count * sizeof *state->memory);
  memcpy (state->responses, as->beams.responses,
          as->beams.count * sizeof *state->responses);
}

void
qn_beam_state_set (const QnBeamState *state, QnAssembly *as)
{
  memcpy (as->beams.committed, state->memory, as->beams.count * sizeof *state->memory);
  memcpy (as->beams.responses, state->responses,
          as->beams.count * sizeof *state->responses);
}
