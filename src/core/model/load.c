#include "core/model/model.h"

QnLoad *
qn_model_load (const QnModel *model, size_t source)
{
  return source < model->dead_load_count
           ? &model->dead_loads[source]
           : &model->live_loads[source - model->dead_load_count];
}

double
qn_model_load_factor (const QnModel *model, const QnLoad *load)
{
  return load->load_case > 0 ? model->load_cases[load->load_case - 1].factor : 1;
}

size_t
qn_model_acting_source (const QnModel *model, size_t index)
{
  size_t given = qn_model_load_count (model);

  return index < given ? index : model->edge_forces[index - given].source;
}

QnLoad
qn_model_acting_load (const QnModel *model, size_t index)
{
  size_t given = qn_model_load_count (model);
  size_t source = qn_model_acting_source (model, index);
  QnLoad load = *qn_model_load (model, source);
  double factor = qn_model_load_factor (model, &load);

  if (source < model->dead_load_count)
    load.set = QN_NONE;
  if (index >= given) {
    const QnEdgeForce *force = &model->edge_forces[index - given];
    load.kind = QN_LOAD_FORCE;
    load.block = force->block;
    load.vector = force->force;
    load.has_at = true;
    load.at = force->at;
  }
  load.vector = qn_vec2_scale (factor, load.vector);
  load.moment *= factor;
  load.value *= factor;
  return load;
}

QnVec2
qn_model_load_arm (const QnModel *model, const QnLoad *load)
{
  const QnNode *node = load->kind == QN_LOAD_NODE ? &model->nodes[load->node] : NULL;

  if (node != NULL && node->block != QN_NONE)
    return qn_vec2_sub (node->at, model->blocks[node->block].centroid);
  if (load->kind == QN_LOAD_FORCE && load->has_at)
    return qn_vec2_sub (load->at, model->blocks[load->block].centroid);
  return qn_vec2 (0, 0);
}

size_t
qn_model_load_body (const QnModel *model, const QnLoad *load)
{
  return load->kind == QN_LOAD_NODE ? qn_model_node_body (model, load->node)
                                    : (size_t) load->block;
}

/* Factor of a load by its set, 0 for dead loads; without `factors` 1 for dead loads, 0 for others. */
static double
part_of (const QnLoad *load, const double *factors)
{
  if (factors == NULL)
    return load->set == QN_NONE ? 1 : 0;
  return load->set == QN_NONE ? 0 : factors[load->set];
}

void
qn_model_set_forces (const QnModel *model, const double *factors, double *forces)
{
  for (size_t i = 0; i < qn_model_body_count (model) * QN_DOF_COUNT; i++)
    forces[i] = 0;
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    double part = part_of (&load, factors);
    if (part == 0)
      continue;
    for (size_t b = 0; b < model->block_count && load.kind == QN_LOAD_WEIGHT; b++) {
      double *out = forces + b * QN_DOF_COUNT;
      out[QN_DOF_UX] += part * (model->blocks[b].weight * load.vector.x);
      out[QN_DOF_UY] += part * (model->blocks[b].weight * load.vector.y);
    }
    /* Those of loads on edges come behind the loads. */
    if (load.kind == QN_LOAD_FORCE || load.kind == QN_LOAD_NODE) {
      /* Adds a force acting at a point of the body and a free moment; at the centroid the
       * force has no arm. */
      double *out = forces + QN_DOF_COUNT * qn_model_load_body (model, &load);
      QnVec2 arm = qn_model_load_arm (model, &load);
      double moment = load.moment + qn_vec2_cross (arm, load.vector); /* M + r x F */
      out[QN_DOF_UX] += part * load.vector.x;
      out[QN_DOF_UY] += part * load.vector.y;
      out[QN_DOF_RZ] += part * moment;
    }
  }
}

void
qn_model_live_forces (const QnModel *model, double *forces)
{
  const double factors[QN_MAX_LOAD_SETS] = { 1 };

  qn_model_set_forces (model, factors, forces);
}

bool
qn_model_has_bonds (const QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++)
    if (qn_law_has_bond (&model->laws[i]))
      return true;
  return false;
}

bool
qn_model_is_non_associative (const QnModel *model)
{
  bool any = false;

  for (size_t i = 0; i < model->law_count; i++)
    any |= qn_law_may_bond (model->laws[i].kind)
           && model->laws[i].dilatancy < model->laws[i].friction;
  return any;
}

bool
qn_model_sets_have_force (const QnModel *model, uint32_t sets)
{
  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    if (load->kind != QN_LOAD_SETTLEMENT && (sets >> load->set & 1) != 0)
      return true;
  }
  return false;
}

void
qn_model_element_loads (const QnModel *model, const double *factors, QnVec2 *out)
{
  for (size_t e = 0; e < model->element_count; e++)
    out[e] = qn_vec2 (0, 0);
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    double factor = part_of (&load, factors);
    if (factor == 0 || (load.kind != QN_LOAD_WEIGHT && load.kind != QN_LOAD_LINE))
      continue;
    for (size_t e = 0; e < model->element_count; e++) {
      const QnBeam *beam = &model->beams[model->elements[e].beam];
      if (load.kind == QN_LOAD_WEIGHT)
        out[e] = qn_vec2_add_scaled (
          out[e], factor * qn_section_weight (&model->sections[beam->section]),
          load.vector);
      else if (load.beam == model->elements[e].beam)
        out[e] = qn_vec2_add_scaled (out[e], factor, load.vector);
    }
  }
}

/* First of the edge forces that come from this load or a later one. */
static size_t
first_edge_force (const QnModel *model, size_t source)
{
  size_t low = 0, high = model->edge_force_count;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (model->edge_forces[middle].source < source)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

const QnEdgeForce *
qn_model_edge_forces_of (const QnModel *model, size_t source, size_t *count)
{
  size_t first = first_edge_force (model, source);

  *count = first_edge_force (model, source + 1) - first;
  return *count > 0 ? model->edge_forces + first : NULL;
}

/* Of a load of weight, or along beams: by what its vector is multiplied. */
static double
loaded_amount (const QnModel *model, const QnLoad *load)
{
  double sum = 0;

  for (size_t b = 0; b < model->block_count && load->kind == QN_LOAD_WEIGHT; b++)
    sum += model->blocks[b].weight;
  for (size_t b = 0; b < model->beam_count; b++) {
    const QnBeam *beam = &model->beams[b];
    if (load->kind == QN_LOAD_WEIGHT)
      sum += qn_section_weight (&model->sections[beam->section])
             * qn_model_beam_length (model, (QnId) b);
    else if (load->kind == QN_LOAD_LINE && load->beam == (QnId) b)
      sum += qn_model_beam_length (model, (QnId) b);
  }
  return sum;
}

QnVec2
qn_model_load_resultant (const QnModel *model, size_t source)
{
  const QnLoad *load = qn_model_load (model, source);
  QnVec2 sum = { 0, 0 };
  size_t count;
  const QnEdgeForce *forces = qn_model_edge_forces_of (model, source, &count);

  if (load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE)
    sum = load->vector;
  else if (load->kind == QN_LOAD_WEIGHT || load->kind == QN_LOAD_LINE)
    sum = qn_vec2_scale (loaded_amount (model, load), load->vector);
  for (size_t i = 0; i < count; i++)
    sum = qn_vec2_add (sum, forces[i].force);
  return qn_vec2_scale (qn_model_load_factor (model, load), sum);
}
