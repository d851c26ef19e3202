/* Balance of every free body at a step, and strengths, from the model and the forces that are stated: nothing
 * here is of the solver. */
#include "core/check/check-parts.h"
#include "core/result/result-contact.h"

#include <math.h>

static bool
has_bond (const QnLaw *law)
{
  return qn_law_may_bond (law->kind) && (law->cohesion > 0 || law->tension > 0);
}

/* By how much a force exceeds what a law can carry, N, its bond whole or broken; 0 or less where it does
 * not. Strengths per area are times the tributary area. */
static double
law_excess (const QnLaw *law, double area, const QnPairResult *pair, bool broken)
{
  double factor = law->basis == QN_BASIS_CONTACT ? 1 : area;
  double normal = pair->normal_force, shear = pair->shear_force;

  switch (law->kind) {
  case QN_LAW_NO_TENSION:
    return normal;
  case QN_LAW_COULOMB:
  case QN_LAW_MOHR_COULOMB: {
    double friction =
      broken && law->residual_friction > 0 ? law->residual_friction : law->friction;
    double cohesion = broken ? 0 : factor * law->cohesion;
    double tension = broken ? 0 : factor * law->tension;
    double slip =
      fabs (shear) + friction * normal - cohesion; /* |t| + mu n <= c, n <= ft */
    double most = fmax (slip, normal - fmax (tension, QN_BOND_ROUNDING * cohesion));
    return law->kind == QN_LAW_COULOMB ? most
                                       : fmax (most, -normal - factor * law->compression);
  }
  case QN_LAW_ELASTIC_PLASTIC:
    return fabs (normal) - factor * law->yield;
  case QN_LAW_STEEL:
    return fabs (normal) - factor * law->strength;
  case QN_LAW_CONCRETE:
    return fmax (normal - factor * law->tension, -normal - factor * law->strength);
  case QN_LAW_BILINEAR:
  case QN_LAW_CURVE:
  case QN_LAW_ELASTIC:
  case QN_LAW_KIND_COUNT:
    break;
  }
  return 0;
}

double
qn_check_excess (const QnCheck *check, size_t p)
{
  const QnPairResult *stated = &check->stated[p];
  const QnModel *model = check->model;
  const QnContactPair *pair = &check->contacts->pairs[p];
  const QnContactFace *face = &check->contacts->faces[pair->face];
  double area = pair->tributary * face->thickness;

  if (pair->bar != QN_NONE)
    return law_excess (&model->laws[model->bars[pair->bar].law], area, stated, false);
  const QnLaw *a = &model->laws[face->law_a], *b = &model->laws[face->law_b];
  bool broken = stated->damage >= 1;
  double excess = qn_worse (law_excess (a, area, stated, broken && has_bond (a)),
                            law_excess (b, area, stated, broken && has_bond (b)));

  /* Damage is that of the pair: of two bonds one may be whole. */
  if (broken && face->law_a != face->law_b && has_bond (a) && has_bond (b))
    excess = fmin (
      qn_worse (law_excess (a, area, stated, true), law_excess (b, area, stated, false)),
      qn_worse (law_excess (a, area, stated, false), law_excess (b, area, stated, true)));
  return excess;
}

/* Sums at a step. */
typedef struct Sum {
  const QnModel *model;
  const double *moved; /* rows of displacements; NULL: of the undeformed structure */
  double *balance;     /* a row for every body; moments about where it has moved to */
} Sum;

/* Where a body's centroid, or a node, has moved to. */
static QnVec2
place_of (const Sum *sum, size_t body)
{
  const QnModel *model = sum->model;
  QnVec2 at = body < model->block_count ? model->blocks[body].centroid
                                        : model->nodes[body - model->block_count].at;

  if (sum->moved == NULL)
    return at;
  const double *u = sum->moved + body * QN_DOF_COUNT;
  return qn_vec2_add (at, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]));
}

static void
add (const Sum *sum, size_t body, QnVec2 force, double moment, QnVec2 point)
{
  double *row = sum->balance + body * QN_DOF_COUNT;

  row[QN_DOF_UX] += force.x;
  row[QN_DOF_UY] += force.y;
  row[QN_DOF_RZ] +=
    moment + qn_vec2_cross (qn_vec2_sub (point, place_of (sum, body)), force); /* r x F */
}

/* A force between two bodies. */
static void
add_both (const Sum *sum, QnId a, QnId b, QnVec2 force, QnVec2 point)
{
  add (sum, (size_t) a, force, 0, point);
  add (sum, (size_t) b, qn_vec2_scale (-1, force), 0, point);
}

/* Loads of sets count with the factor of their set, the dead ones with 1. Arms of forces that act away from
 * the centroid have turned with their blocks. */
static void
add_loads (const Sum *sum, const double *factors, double *live)
{
  const QnModel *model = sum->model;
  size_t size = qn_model_body_count (model) * QN_DOF_COUNT;

  qn_model_set_forces (model, NULL, sum->balance);
  qn_model_set_forces (model, factors, live);
  for (size_t i = 0; i < size; i++)
    sum->balance[i] += live[i];
  for (size_t i = 0; sum->moved != NULL && i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (load.kind != QN_LOAD_FORCE && load.kind != QN_LOAD_NODE)
      continue;
    size_t rz = qn_model_load_body (model, &load) * QN_DOF_COUNT + QN_DOF_RZ;
    QnVec2 arm = qn_model_load_arm (model, &load);
    QnVec2 turned = qn_vec2_rotate (arm, cos (sum->moved[rz]), sin (sum->moved[rz]));
    sum->balance[rz] += (load.set == QN_NONE ? 1 : factors[load.set])
                        * qn_vec2_cross (qn_vec2_sub (turned, arm), load.vector);
  }
}

/* Those that were found on the way come behind the drawn ones. */
static void
add_pairs (const QnCheck *check, const Sum *sum)
{
  for (size_t p = 0; p < check->assembly.pair_count; p++) {
    const QnPairResult *f = &check->stated[p];
    QnVec2 point, normal;
    if (p >= check->contacts->pair_count) {
      size_t found = p - check->contacts->pair_count;
      const QnFoundContact *c = &check->result->found[found].contact;
      const QnFoundForce force = { .normal = f->normal_force, .shear = f->shear_force };
      add_both (sum, c->block, c->other,
                qn_found_force (sum->model, c, &force, sum->moved),
                qn_block_place (sum->model, c->other, sum->moved,
                                qn_found_corner (sum->model, c)));
      continue;
    }
    const QnContactFace *face = &check->contacts->faces[check->contacts->pairs[p].face];
    qn_result_contact_place (sum->model, check->contacts, p, sum->moved, &point, &normal);
    add_both (sum, face->a, face->b,
              qn_vec2_add_scaled (qn_vec2_scale (f->normal_force, normal), f->shear_force,
                                  qn_vec2_perp (normal)),
              point);
  }
}

/* Adds what the two ends of an element exert on their nodes: N pulls the nodes together, V pushes the
 * first one down, along -y, and the second one up. Returns by how much they are not in balance with the
 * element's load, N. */
static double
add_element (const Sum *sum, size_t e, const QnBeamForces *f, const double *factors)
{
  const QnModel *model = sum->model;
  const QnBeamElement *element = &model->elements[e];
  QnVec2 ends[2], nodes[2];

  for (int end = 0; end < 2; end++) {
    nodes[end] = model->nodes[element->nodes[end]].at;
    ends[end] = place_of (sum, model->block_count + (size_t) element->nodes[end]);
  }
  QnVec2 chord = qn_vec2_sub (ends[1], ends[0]);
  double length = qn_vec2_length (chord);
  QnVec2 x = qn_vec2_scale (1 / length, chord), y = qn_vec2_perp (x);
  QnVec2 on_node[2] = {
    qn_vec2_add_scaled (qn_vec2_scale (f->normal[0], x), -f->shear[0], y),
    qn_vec2_add_scaled (qn_vec2_scale (-f->normal[1], x), f->shear[1], y)
  };
  for (int end = 0; end < 2; end++)
    add (sum, qn_model_node_body (model, element->nodes[end]), on_node[end],
         end == 0 ? f->moment[0] : -f->moment[1], ends[end]);
  /* Load on an element, N/m: all sets with their factors, and the dead loads. */
  const QnId beam = model->elements[e].beam;
  const QnSection *section = &model->sections[model->beams[beam].section];
  QnVec2 load_sum = { 0, 0 };
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    double factor = load.set == QN_NONE ? 1 : factors[load.set];
    if (load.kind == QN_LOAD_WEIGHT)
      load_sum = qn_vec2_add_scaled (
        load_sum, factor * section->unit_weight * section->area, load.vector);
    else if (load.kind == QN_LOAD_LINE && load.beam == beam)
      load_sum = qn_vec2_add_scaled (load_sum, factor, load.vector);
  }
  /* Its resultant, in the middle, against both ends. */
  QnVec2 resultant =
    qn_vec2_scale (qn_vec2_length (qn_vec2_sub (nodes[1], nodes[0])), load_sum);
  QnVec2 rest = qn_vec2_sub (resultant, qn_vec2_add (on_node[0], on_node[1]));
  double turning = qn_vec2_cross (qn_vec2_scale (0.5, chord), resultant) - f->moment[0]
                   + f->moment[1] - qn_vec2_cross (chord, on_node[1]);
  return fmax (qn_vec2_length (rest), fabs (turning) / length);
}

static void
add_tie (const Sum *sum, const QnTie *tie, double force)
{
  QnVec2 at[2];

  for (int end = 0; end < 2; end++) {
    at[end] = tie->ends[end].at;
    if (tie->ends[end].block != QN_NONE && sum->moved != NULL)
      at[end] = qn_block_place (sum->model, tie->ends[end].block, sum->moved, at[end]);
  }
  QnVec2 along = qn_vec2_sub (at[1], at[0]);
  for (int end = 0; end < 2; end++)
    if (tie->ends[end].block != QN_NONE)
      add (sum, (size_t) tie->ends[end].block,
           qn_vec2_scale ((end == 0 ? force : -force) / qn_vec2_length (along), along), 0,
           at[end]);
}

/* NaN counts as the largest. */
static bool
is_worse (double out, double worst)
{
  return !(out <= worst) && !isnan (worst);
}

void
qn_check_balance (QnCheck *check, size_t step)
{
  const QnModel *model = check->model;
  const QnResult *result = check->result;
  const QnAssembly *as = &check->assembly;
  const QnBeamForces *beams = qn_result_step_beam_forces (result, step);
  bool is_deformed = as->nonlinear && !result->limit.given;
  const Sum sum = { .model = model,
                    .moved =
                      is_deformed ? qn_result_step_displacements (result, step) : NULL,
                    .balance = check->rows };
  QnLastForces *last = &check->faults->last;
  double factors[QN_MAX_LOAD_SETS], worst = 0;

  last->multiplier = result->steps[step].multiplier;
  last->scale = check->scale;
  last->entity = QN_ENTITY_BLOCK;
  last->index = QN_NONE;
  qn_result_load_factors (model, result, step, factors);
  add_loads (&sum, factors, check->live);
  add_pairs (check, &sum);
  for (size_t e = 0; e < model->element_count; e++) {
    double out =
      add_element (&sum, e, beams != NULL ? &beams[e] : &check->beam_forces[e], factors);
    if (is_worse (out, worst)) {
      worst = out;
      last->entity = QN_ENTITY_BEAM;
      last->index = (QnId) e;
    }
  }
  for (size_t i = 0; i < qn_model_tie_count (model); i++)
    add_tie (&sum, qn_model_tie (model, i),
             as->beams.responses[model->element_count + i].force[0]);
  for (size_t i = 0; i < qn_model_body_count (model) * QN_DOF_COUNT; i++) {
    size_t body = i / QN_DOF_COUNT;
    QnDof dof = (QnDof) (i % QN_DOF_COUNT);
    double out = fabs (check->rows[i]) / (dof == QN_DOF_RZ ? as->length : 1);
    if (qn_model_body_is_fixed (model, body, dof) || !is_worse (out, worst))
      continue;
    bool node = body >= model->block_count;
    worst = out;
    last->entity = node ? QN_ENTITY_NODE : QN_ENTITY_BLOCK;
    last->index = (QnId) (node ? body - model->block_count : body);
  }
  last->out_of_balance = check->scale > 0 ? worst / check->scale : 0;
  /* Where blocks have moved far apart, forces between them, which files round, have arms as long as that. */
  double arm = is_deformed ? check->largest / as->length : 0;
  if (!(worst <= (check->tolerance + QN_CHECK_DIGITS * arm) * check->scale))
    qn_check_tell (check, QN_CLAIM_BALANCE, (QnId) step, last->entity,
                   last->entity == QN_ENTITY_BEAM ? model->elements[last->index].beam
                                                  : last->index,
                   worst, 0);
}
