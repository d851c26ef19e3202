#include "core/base/memory.h"
#include "core/result/result.h"

#include <math.h>
#include <stdlib.h>

/* Multiplier of the sets of a stage at a step, wherever it was left. */
static double
multiplier_of (const QnModel *model, const QnResult *result, uint32_t sets, size_t step)
{
  double factors[QN_MAX_LOAD_SETS];
  int set = 0;

  qn_result_load_factors (model, result, step, factors);
  while (set < QN_MAX_LOAD_SETS - 1 && (sets >> set & 1) == 0)
    set++;
  return factors[set];
}

bool
qn_result_stage_figures (const QnModel *model, const QnResult *result, int32_t stage,
                         QnStageFigures *figures)
{
  const uint32_t sets = model->stages[stage - 1].sets;
  size_t bodies = qn_model_body_count (model), first = 0, end;
  double unit[QN_MAX_LOAD_SETS] = { 0 };

  while (first < result->step_count && result->steps[first].stage != stage)
    first++;
  if (first == 0 || first == result->step_count)
    return false;
  double *forces = qn_alloc (bodies * QN_DOF_COUNT, sizeof *forces);
  if (forces == NULL)
    return false;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    unit[set] = sets >> set & 1;
  qn_model_set_forces (model, unit, forces);
  double before = multiplier_of (model, result, sets, first - 1);
  *figures = (QnStageFigures){ .lowest = before, .highest = before };
  for (end = first; end < result->step_count && result->steps[end].stage == stage;
       end++) {
    const double *u = qn_result_step_displacements (result, end);
    const double *v = qn_result_step_displacements (result, end - 1);
    double now = result->steps[end].multiplier, work = 0;
    for (size_t i = 0; i < bodies * QN_DOF_COUNT; i++)
      work += forces[i] * (u[i] - v[i]);
    figures->work += 0.5 * (before + now) * work;
    figures->lowest = fmin (figures->lowest, now);
    figures->highest = fmax (figures->highest, now);
    before = now;
  }
  figures->last = end - 1;
  figures->multiplier = before;
  free (forces);
  return true;
}
