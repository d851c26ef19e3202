#include "io/result/result-check-beams.h"

#include <math.h>

/* Where a body's centroid, or a node, has moved to. */
static QnVec2
place_of (const QnModel *model, size_t body, const double *deformation)
{
  QnVec2 at = body < model->block_count ? model->blocks[body].centroid
                                        : model->nodes[body - model->block_count].at;
  if (deformation == NULL)
    return at;
  const double *u = deformation + body * QN_DOF_COUNT;
  return qn_vec2_add (at, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]));
}

/* Load on an element, N/m: all sets with their factors, and the dead loads. */
static QnVec2
element_load (const QnModel *model, QnId element, const double *factors)
{
  const QnId beam = model->elements[element].beam;
  const QnSection *section = &model->sections[model->beams[beam].section];
  QnVec2 sum = { 0, 0 };

  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    double factor = load.set == QN_NONE ? 1 : factors[load.set];
    if (load.kind == QN_LOAD_WEIGHT)
      sum = qn_vec2_add_scaled (sum, factor * section->unit_weight * section->area,
                                load.vector);
    else if (load.kind == QN_LOAD_LINE && load.beam == beam)
      sum = qn_vec2_add_scaled (sum, factor, load.vector);
  }
  return sum;
}

void
qn_result_check_add_beams (const QnResultFile *file, const QnModel *model,
                           const double *deformation, const double *factors,
                           double *balance, QnResultCheck *check)
{
  const QnResult *result = &file->result;
  const QnBeamForces *all =
    result->step_count > 0 ? qn_result_step_beam_forces (result, result->step_count - 1)
                           : NULL;

  for (size_t e = 0; all != NULL && e < model->element_count; e++) {
    const QnBeamElement *element = &model->elements[e];
    QnVec2 ends[2], on_node[2];
    double moment[2];
    for (int end = 0; end < 2; end++)
      ends[end] =
        place_of (model, model->block_count + (size_t) element->nodes[end], deformation);
    QnVec2 chord = qn_vec2_sub (ends[1], ends[0]);
    double length = qn_vec2_length (chord);
    /* What the two ends of an element exert on their nodes: forces, and moments. N pulls the
     * nodes together, V pushes the first one down, along -y, and the second one up. */
    const QnBeamForces *forces = &all[e];
    QnVec2 x = qn_vec2_scale (1 / length, chord);
    QnVec2 y = qn_vec2_perp (x);
    on_node[0] =
      qn_vec2_add_scaled (qn_vec2_scale (forces->normal[0], x), -forces->shear[0], y);
    on_node[1] =
      qn_vec2_add_scaled (qn_vec2_scale (-forces->normal[1], x), forces->shear[1], y);
    moment[0] = forces->moment[0];
    moment[1] = -forces->moment[1];

    for (int end = 0; end < 2; end++) {
      size_t body = qn_model_node_body (model, element->nodes[end]);
      double *sum = balance + body * QN_DOF_COUNT;
      QnVec2 arm = qn_vec2_sub (ends[end], place_of (model, body, deformation));
      sum[QN_DOF_UX] += on_node[end].x;
      sum[QN_DOF_UY] += on_node[end].y;
      sum[QN_DOF_RZ] += moment[end] + qn_vec2_cross (arm, on_node[end]);
    }

    /* The element itself: the resultant of its load, in its middle, against both ends. */
    QnVec2 at_rest = qn_vec2_sub (model->nodes[element->nodes[1]].at,
                                  model->nodes[element->nodes[0]].at);
    QnVec2 load =
      qn_vec2_scale (qn_vec2_length (at_rest), element_load (model, (QnId) e, factors));
    QnVec2 rest = qn_vec2_sub (load, qn_vec2_add (on_node[0], on_node[1]));
    double turning = qn_vec2_cross (qn_vec2_scale (0.5, chord), load) - moment[0]
                     - moment[1] - qn_vec2_cross (chord, on_node[1]);
    double out = fmax (qn_vec2_length (rest), fabs (turning) / length);
    if (out > check->element_out_of_balance) {
      check->element_out_of_balance = out;
      check->unbalanced_element = (QnId) e;
    }
    check->beam_scale = fmax (
      check->beam_scale, fmax (qn_vec2_length (on_node[0]), qn_vec2_length (on_node[1])));
  }
}

void
qn_result_check_add_ties (const QnResultFile *file, const QnModel *model,
                          const double *deformation, double *balance,
                          QnResultCheck *check)
{
  const QnResult *result = &file->result;
  const QnTieResult *ties = qn_result_step_ties (result, result->step_count - 1);

  for (size_t i = 0; ties != NULL && i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    double force = ties[i].force, steel = tie->area * tie->yield;
    QnVec2 at[2];
    for (int end = 0; end < 2; end++) {
      at[end] = tie->ends[end].at;
      if (tie->ends[end].block != QN_NONE && deformation != NULL)
        at[end] = qn_block_place (model, tie->ends[end].block, deformation, at[end]);
    }
    QnVec2 along = qn_vec2_sub (at[1], at[0]);
    QnVec2 pull = qn_vec2_scale (force / qn_vec2_length (along), along);
    for (int end = 0; end < 2; end++) {
      QnId block = tie->ends[end].block;
      if (block == QN_NONE)
        continue;
      double *sum = balance + (size_t) block * QN_DOF_COUNT;
      QnVec2 on_block = qn_vec2_scale (end == 0 ? 1 : -1, pull);
      QnVec2 arm = qn_vec2_sub (at[end], place_of (model, (size_t) block, deformation));
      sum[QN_DOF_UX] += on_block.x;
      sum[QN_DOF_UY] += on_block.y;
      sum[QN_DOF_RZ] += qn_vec2_cross (arm, on_block);
    }
    check->beam_scale = fmax (check->beam_scale, force);
    check->tie_excess = fmax (check->tie_excess, -force);
    if (tie->yield > 0)
      check->tie_excess = fmax (check->tie_excess, force - steel);
    check->tie_excess = fmax (check->tie_excess, force - qn_tie_anchor (tie));
  }
}
