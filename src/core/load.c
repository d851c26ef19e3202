#include "core/model.h"

/* Adds a force acting at a point of the block and a free moment; at the centroid the force has
 * no arm. */
static void
add_force (const QnBlock *block, const QnLoad *load, double factor, double *out)
{
  QnVec2 arm = load->has_at ? qn_vec2_sub (load->at, block->centroid) : qn_vec2 (0, 0);
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
    add_force (&model->blocks[load->block], load, factor,
               forces + (size_t) load->block * QN_DOF_COUNT);
    break;
  case QN_LOAD_SETTLEMENT:
  case QN_LOAD_KIND_COUNT:
    break;
  }
}

static void
set_zero (const QnModel *model, double *forces)
{
  for (size_t i = 0; i < model->block_count * QN_DOF_COUNT; i++)
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
