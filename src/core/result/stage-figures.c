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

/* Forces of load sets at a multiplier of 1, a row for every body. False when memory runs out. */
static bool
unit_forces (const QnModel *model, uint32_t sets, double **forces)
{
  double unit[QN_MAX_LOAD_SETS] = { 0 };

  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    unit[set] = sets >> set & 1;
  if (*forces == NULL)
    *forces = qn_alloc (qn_model_body_count (model) * QN_DOF_COUNT, sizeof **forces);
  if (*forces != NULL)
    qn_model_set_forces (model, unit, *forces);
  return *forces != NULL;
}

/* Work of forces that grow from one multiplier to another while the structure goes to a step from that before. */
static double
work_of_step (const QnResult *result, const double *forces, double from, double to,
              size_t step)
{
  const double *u = qn_result_step_displacements (result, step);
  const double *v = qn_result_step_displacements (result, step - 1);
  double work = 0;

  for (size_t i = 0; i < qn_result_body_count (result) * QN_DOF_COUNT; i++)
    work += forces[i] * (u[i] - v[i]);
  return 0.5 * (from + to) * work;
}

bool
qn_result_sum_work (const QnModel *model, const QnResult *result, double *sums)
{
  double *forces = NULL, before = 0;
  bool done = true;

  for (size_t step = 0; done && step < result->step_count; step++) {
    const QnStep *s = &result->steps[step];
    uint32_t sets = s->stage > 0 ? model->stages[s->stage - 1].sets : 1;
    sums[step] = 0;
    if (step == 0)
      continue;
    if (step == 1 || s->stage != result->steps[step - 1].stage) {
      done = unit_forces (model, sets, &forces);
      before = multiplier_of (model, result, sets, step - 1);
    }
    if (done)
      sums[step] =
        sums[step - 1] + work_of_step (result, forces, before, s->multiplier, step);
    before = s->multiplier;
  }
  free (forces);
  return done;
}

bool
qn_result_stage_figures (const QnModel *model, const QnResult *result, int32_t first,
                         int32_t last, QnStageFigures *figures)
{
  const uint32_t sets = model->stages[first - 1].sets;
  double *forces = NULL;
  size_t step = 0;

  while (step < result->step_count && result->steps[step].stage < first)
    step++;
  if (step == 0 || step == result->step_count || result->steps[step].stage > last
      || !unit_forces (model, sets, &forces))
    return false;
  double before = multiplier_of (model, result, sets, step - 1);
  *figures = (QnStageFigures){ .lowest = before, .highest = before };
  for (; step < result->step_count && result->steps[step].stage <= last; step++) {
    double now = result->steps[step].multiplier;
    figures->work += work_of_step (result, forces, before, now, step);
    figures->lowest = fmin (figures->lowest, now);
    figures->highest = fmax (figures->highest, now);
    figures->last = step;
    before = now;
  }
  figures->multiplier = before;
  free (forces);
  return true;
}

int32_t
qn_result_cycle_start (const QnModel *model, const QnResult *result, int32_t stage)
{
  const int32_t leg = model->stages[stage - 1].leg;
  bool done = stage < result->stage || result->outcome == QN_OUTCOME_TARGET_REACHED;

  return done && leg > 0 && leg % QN_CYCLE_LEGS == 0 ? stage - QN_CYCLE_LEGS + 1 : 0;
}
