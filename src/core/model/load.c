#include "core/model/model.h"

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

/* Adds a force acting at a point of the body and a free moment; at the centroid the force has
 * no arm. */
static void
add_force (const QnModel *model, const QnLoad *load, double factor, double *forces)
{
  double *out = forces + QN_DOF_COUNT * qn_model_load_body (model, load);
  QnVec2 arm = qn_model_load_arm (model, load);
  double moment = load->moment + qn_vec2_cross (arm, load->vector); /* M + r x F */
  out[QN_DOF_UX] += factor * load->vector.x;
  out[QN_DOF_UY] += factor * load->vector.y;
  out[QN_DOF_RZ] += factor * moment;
}

/* forces += factor x load */
static void
add_load (const QnModel *model, const QnLoad *load, double factor, double *forces)
{
  switch (load->kind) {
  case QN_LOAD_WEIGHT:
    for (size_t b = 0; b < model->block_count; b++) {
      double *out = forces + b * QN_DOF_COUNT;
      out[QN_DOF_UX] += factor * (model->blocks[b].weight * load->vector.x);
      out[QN_DOF_UY] += factor * (model->blocks[b].weight * load->vector.y);
    }
    break;
  case QN_LOAD_FORCE:
  case QN_LOAD_NODE:
    add_force (model, load, factor, forces);
    break;
  case QN_LOAD_SETTLEMENT:
  case QN_LOAD_LINE:
  case QN_LOAD_KIND_COUNT:
    break;
  }
}

static void
set_zero (const QnModel *model, double *forces)
{
  for (size_t i = 0; i < qn_model_body_count (model) * QN_DOF_COUNT; i++)
    forces[i] = 0;
}

void
qn_model_dead_forces (const QnModel *model, double *forces)
{
  set_zero (model, forces);
  for (size_t i = 0; i < model->dead_load_count; i++)
    add_load (model, &model->dead_loads[i], 1, forces);
}

void
qn_model_set_forces (const QnModel *model, const double *factors, double *forces)
{
  set_zero (model, forces);
  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    if (factors[load->set] != 0)
      add_load (model, load, factors[load->set], forces);
  }
}

void
qn_model_live_forces (const QnModel *model, double *forces)
{
  const double factors[QN_MAX_LOAD_SETS] = { 1 };

  qn_model_set_forces (model, factors, forces);
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
  const QnLoad *loads = factors != NULL ? model->live_loads : model->dead_loads;
  size_t count = factors != NULL ? model->live_load_count : model->dead_load_count;

  for (size_t e = 0; e < model->element_count; e++)
    out[e] = qn_vec2 (0, 0);
  for (size_t i = 0; i < count; i++) {
    const QnLoad *load = &loads[i];
    double factor = factors != NULL ? factors[load->set] : 1;
    if (factor == 0 || (load->kind != QN_LOAD_WEIGHT && load->kind != QN_LOAD_LINE))
      continue;
    for (size_t e = 0; e < model->element_count; e++) {
      const QnBeam *beam = &model->beams[model->elements[e].beam];
      if (load->kind == QN_LOAD_WEIGHT)
        out[e] = qn_vec2_add_scaled (
          out[e], factor * qn_section_weight (&model->sections[beam->section]),
          load->vector);
      else if (load->beam == model->elements[e].beam)
        out[e] = qn_vec2_add_scaled (out[e], factor, load->vector);
    }
  }
}
