#include "core/result/curve-motion.h"

#include <math.h>

static bool
is_fixed (const QnModel *model, size_t body)
{
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    if (!qn_model_body_is_fixed (model, body, (QnDof) dof))
      return false;
  return true;
}

/* Of the bodies from `first` to `end`, at the step where it is furthest from where it began. */
static void
find_furthest (const QnModel *model, const QnResult *result, size_t first, size_t end,
               QnCurveMotion *motion)
{
  const double *start = qn_result_step_displacements (result, 0);
  double furthest = -1;

  for (size_t body = first; body < end; body++) {
    if (is_fixed (model, body))
      continue;
    const double *u0 = start + body * QN_DOF_COUNT;
    for (size_t step = 0; step < result->step_count; step++) {
      const double *u = qn_result_step_displacements (result, step) + body * QN_DOF_COUNT;
      double x = fabs (u[QN_DOF_UX] - u0[QN_DOF_UX]);
      double y = fabs (u[QN_DOF_UY] - u0[QN_DOF_UY]);
      if (!(hypot (x, y) > furthest))
        continue;
      furthest = hypot (x, y);
      motion->body = (QnId) body;
      motion->dof = x >= y ? QN_DOF_UX : QN_DOF_UY;
    }
  }
}

const QnLoad *
qn_result_settlement (const QnModel *model, const QnResult *result)
{
  const QnLoad *largest = NULL;
  bool staged = result->stage > 0 && (size_t) result->stage <= model->stage_count;
  uint32_t sets = staged ? model->stages[result->stage - 1].sets : 1;

  if (result->history.width > 0 || result->limit.given || result->support_count == 0
      || result->reactions == NULL || qn_model_sets_have_force (model, sets))
    return NULL;
  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    if (load->kind == QN_LOAD_SETTLEMENT && (sets >> load->set & 1) != 0
        && (largest == NULL || fabs (load->value) > fabs (largest->value)))
      largest = load;
  }
  return largest;
}

double
qn_result_settlement_reaction (const QnModel *model, const QnResult *result,
                               const QnLoad *settlement, size_t step)
{
  double sum = 0;

  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    if (load->kind != QN_LOAD_SETTLEMENT || load->dof != settlement->dof
        || load->set != settlement->set)
      continue;
    for (size_t k = 0; k < result->support_count; k++)
      if (result->supports[k] == load->block)
        sum += result->reactions[(step * result->support_count + k) * QN_DOF_COUNT
                                 + (size_t) load->dof];
  }
  return sum;
}

QnCurveMotion
qn_result_curve_motion (const QnModel *model, const QnResult *result)
{
  const QnControl *control = &model->analysis.control;
  const QnLoad *settlement = qn_result_settlement (model, result);

  if (settlement != NULL && result->step_count > 0)
    return (QnCurveMotion){ settlement->block, settlement->dof, true };
  size_t body = qn_model_controlled_body (model, control);

  /* With stages what the last one has prescribed that prescribes anything. */
  for (int32_t i = result->stage;
       body == SIZE_MAX && i > 0 && (size_t) i <= model->stage_count; i--) {
    control = &model->stages[i - 1].control;
    body = qn_model_controlled_body (model, control);
  }
  QnCurveMotion motion = { QN_NONE, control->dof, body == SIZE_MAX };
  if (result->history.width > 0) {
    qn_model_followed (model, &body, &motion.dof);
    motion.since_dead = true;
  }
  if (body != SIZE_MAX)
    motion.body = (QnId) body;
  else if (result->step_count > 0) {
    find_furthest (model, result, 0, result->block_count, &motion);
    if (motion.body == QN_NONE)
      find_furthest (model, result, result->block_count, qn_result_body_count (result),
                     &motion);
  }
  return motion;
}

double
qn_curve_motion_at (const QnResult *result, QnCurveMotion motion, size_t step)
{
  size_t place = (size_t) motion.body * QN_DOF_COUNT + (size_t) motion.dof;
  double u = qn_result_step_displacements (result, step)[place];
  return motion.since_dead ? u - qn_result_step_displacements (result, 0)[place] : u;
}
