#include "core/model.h"

/* Adds a force acting at a point of the block and a free moment; at the centroid the force has
 * no arm. */
static void
add_force (const QnBlock *block, const QnLoad *load, double *out)
{
  QnVec2 arm = load->has_at ? qn_vec2_sub (load->at, block->centroid) : qn_vec2 (0, 0);
  out[QN_DOF_UX] += load->vector.x;
  out[QN_DOF_UY] += load->vector.y;
  out[QN_DOF_RZ] += load->moment + qn_vec2_cross (arm, load->vector); /* M + r x F */
}

static void
sum_loads (const QnModel *model, const QnLoad *loads, size_t load_count, double *forces)
{
  for (size_t i = 0; i < model->block_count * QN_DOF_COUNT; i++)
    forces[i] = 0;

  for (size_t i = 0; i < load_count; i++) {
    const QnLoad *load = &loads[i];
    switch (load->kind) {
    case QN_LOAD_WEIGHT:
      for (size_t b = 0; b < model->block_count; b++) {
        double *out = forces + b * QN_DOF_COUNT;
        out[QN_DOF_UX] += model->blocks[b].weight * load->vector.x;
        out[QN_DOF_UY] += model->blocks[b].weight * load->vector.y;
      }
      break;
    case QN_LOAD_FORCE:
      add_force (&model->blocks[load->block], load,
                 forces + (size_t) load->block * QN_DOF_COUNT);
      break;
    }
  }
}

void
qn_model_dead_forces (const QnModel *model, double *forces)
{
  sum_loads (model, model->dead_loads, model->dead_load_count, forces);
}

void
qn_model_live_forces (const QnModel *model, double *forces)
{
  sum_loads (model, model->live_loads, model->live_load_count, forces);
}
