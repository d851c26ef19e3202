/* Check of the order of steps, of collapse and outcome. */
#include "core/check/check-parts.h"
#include "core/check/unlimited.h"

#include <math.h>

/* Multipliers and displacements that stand in a result twice are written alike. */
#define SAME 1e-9

static bool
same (double a, double b)
{
  return qn_check_agrees (a, b, SAME * (1 + fabs (b)));
}

static void
tell (QnCheck *check, QnClaim claim)
{
  qn_check_tell_model (check, claim, QN_NONE, NAN, NAN);
}

static bool
all_finite (const double *numbers, size_t count)
{
  size_t i = 0;

  while (numbers != NULL && i < count && isfinite (numbers[i]))
    i++;
  return numbers == NULL || i == count;
}

/* The dead load first, stages one after the other, times growing; in time no multiplier. Where the load is
 * prescribed it goes one way all the time; only the last step may lie below, where the structure moves on.
 * Limit analysis has two steps: before and at collapse. */
static void
check_order (QnCheck *check)
{
  const QnResult *r = check->result;
  bool in_time = r->history.width > 0;
  int32_t stages = (int32_t) check->model->stage_count;

  if (r->limit.given && r->step_count != 2)
    tell (check, QN_CLAIM_STEPS);
  for (size_t i = 0; i < r->step_count; i++) {
    const QnStep *step = &r->steps[i];
    bool follows = i == 0 || in_time || stages == 0
                   || (step->stage >= r->steps[i - 1].stage && step->stage >= 1);
    bool in_order = step->stage <= stages && follows;
    if (i == 0 || in_time)
      in_order = in_order && step->multiplier == 0;
    if (in_time && i > 1)
      in_order = in_order && step->time > r->steps[i - 1].time;
    bool ends = i + 1 == r->step_count && r->outcome == QN_OUTCOME_COLLAPSE;
    QnCheckStage stage = qn_check_stage (check, step->stage);
    if (i > stage.base && !ends && !in_time && stage.procedure == QN_PROCEDURE_LOAD) {
      bool begins = i == stage.base + 1;
      double more = step->multiplier - (begins ? stage.origin : step[-1].multiplier);
      in_order = in_order && (stage.sense * more > 0 || (begins && more == 0));
    }
    if (!in_order)
      qn_check_tell_model (check, QN_CLAIM_STEPS, (QnId) i,
                           in_time ? step->time : step->multiplier, NAN);
    if (!(step->residual >= 0
          && step->residual <= fmax (check->tolerance, QN_CHECK_FORCES)))
      qn_check_tell_model (check, QN_CLAIM_STEPS, (QnId) i, step->residual,
                           check->tolerance);
    /* Motion that is driven may go on beyond its collapse multiplier. */
    if ((step->event == QN_EVENT_COLLAPSE) != ends)
      qn_check_tell_model (check, QN_CLAIM_OUTCOME, (QnId) i, NAN, NAN);
  }
}

/* --- Stages ------------------------------------------------------------------------------- */

/* In which sense (1, -1) the multiplier of the stage that begins with this step grows: towards its target, or,
 * where a motion is prescribed, that in which the driven loads do work on the way there (path-stages.c).
 * `from`: the multiplier before. */
static double
find_sense (const QnCheck *check, size_t step, double from)
{
  const QnResult *r = check->result;

  if (r->steps[step].stage < 1)
    return r->steps[step].multiplier < from ? -1 : 1;
  const QnStage *stage = &check->model->stages[r->steps[step].stage - 1];
  double factors[QN_MAX_LOAD_SETS] = { 0 }, work = 0;

  if (stage->has_target)
    return stage->target < from ? -1 : 1;
  if (stage->procedure == QN_PROCEDURE_LOAD || step == 0)
    return 1;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    factors[set] = stage->sets >> set & 1;
  qn_model_set_forces (check->model, factors, check->rows);
  const double *u = qn_result_step_displacements (r, step),
               *u0 = qn_result_step_displacements (r, step - 1);
  for (size_t i = 0; i < qn_model_body_count (check->model) * QN_DOF_COUNT; i++)
    work += check->rows[i] * (u[i] - u0[i]);
  return work < 0 ? -1 : 1;
}

QnCheckStage
qn_check_stage (const QnCheck *check, int32_t number)
{
  const QnResult *r = check->result;
  const QnModel *model = check->model;
  QnCheckStage stage = { .last = r->step_count - 1,
                         .sense = 1,
                         .sets = 1,
                         .procedure = model->analysis.procedure };

  if (number > 0 && (size_t) number <= model->stage_count) {
    int set = 0;
    while (number < r->stage && stage.last > 0 && r->steps[stage.last].stage != number)
      stage.last--;
    stage.number = number;
    stage.sets = model->stages[number - 1].sets;
    stage.procedure = model->stages[number - 1].procedure;
    stage.base = stage.last;
    while (stage.base > 0 && r->steps[stage.base].stage == number)
      stage.base--;
    qn_result_load_factors (model, r, stage.base, stage.before);
    while (set < QN_MAX_LOAD_SETS - 1 && (stage.sets >> set & 1) == 0)
      set++;
    stage.origin = stage.before[set];
  }
  if (stage.last > stage.base)
    stage.sense = find_sense (check, stage.base + 1, stage.origin);
  return stage;
}

/* Whether this is the highest multiplier of the last stage, which is written to *peak. A path that gains less
 * than equilibrium may lack does not climb. */
static bool
is_highest (const QnCheck *check, double multiplier, double *peak)
{
  const QnResult *r = check->result;
  QnCheckStage stage = qn_check_stage (check, r->steps[r->step_count - 1].stage);
  double sense = stage.number > 0 ? stage.sense : 1;

  *peak = stage.origin;
  for (size_t i = stage.base + 1; i <= stage.last; i++)
    if (sense * r->steps[i].multiplier > sense * *peak)
      *peak = r->steps[i].multiplier;
  double gain = sense * (*peak - multiplier);
  return same (multiplier, *peak)
         || (gain >= 0
             && gain <= check->model->analysis.residual_tolerance * fabs (*peak));
}

/* --- Outcome ------------------------------------------------------------------------------ */

/* Where a prescribed displacement, or the largest multiplier, was to be reached. */
static bool
reached_target (const QnCheck *check)
{
  const QnResult *r = check->result;
  const QnModel *model = check->model;
  const QnStep *last = &r->steps[r->step_count - 1];
  const QnAnalysisSettings *settings = &model->analysis;

  if (r->vibration.dead_load) /* it was to be brought there and no further */
    return r->step_count == 1;
  if (model->stage_count > 0)
    return last->stage == (int32_t) model->stage_count || last->stage == 0;
  if (settings->procedure != QN_PROCEDURE_LOAD || settings->max_multiplier == 0
      || model->live_load_count == 0)
    return true;
  double end = settings->max_multiplier;
  if (!isfinite (end)) /* settlements alone go as far as they are told */
    end = qn_model_sets_have_force (model, 1) ? INFINITY : 1;
  return last->multiplier >= fmin (end, 1e9) * (1 - SAME);
}

/* Limit analysis tells no step (check-bounds.c). A path goes on to the largest multiplier there is, unless no
 * load brings the structure down. */
static QnStatus
is_unbounded (const QnCheck *check, bool *is_true, QnDiag *diag)
{
  const QnResult *r = check->result;
  const QnStep *last = r->step_count > 0 ? &r->steps[r->step_count - 1] : NULL;

  *is_true =
    r->mechanism == NULL && !r->has_collapse_multiplier
    && (last == NULL) == (check->model->analysis.procedure == QN_PROCEDURE_LIMIT);
  if (!*is_true || last == NULL || last->multiplier >= 1e9 * (1 - SAME))
    return QN_OK;
  *is_true = false;
  if (check->model->analysis.geometry == QN_GEOMETRY_LINEAR)
    return QN_OK;
  return qn_check_unlimited (check->model, check->contacts, is_true, diag);
}

static QnStatus
check_outcome (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  bool in_time = r->history.width > 0, any = r->step_count > 0, is_true = any;
  double duration = qn_model_duration (check->model);
  QnStatus status = QN_OK;

  switch (r->outcome) {
  case QN_OUTCOME_COLLAPSE:
    is_true = any && r->mechanism != NULL;
    break;
  case QN_OUTCOME_TARGET_REACHED:
    is_true = any
              && (in_time ? qn_check_agrees (r->steps[r->step_count - 1].time, duration,
                                             1e-6 * duration)
                          : reached_target (check) && r->stability != QN_STABILITY_LOST);
    break;
  case QN_OUTCOME_SNAP:
    is_true = any && r->has_first_limit_multiplier && r->stability != QN_STABILITY_KEPT;
    break;
  case QN_OUTCOME_DEAD_LOAD_UNSTABLE:
    is_true = !any && r->unstable_count > 0;
    break;
  case QN_OUTCOME_REST:
    is_true = any && in_time;
    break;
  case QN_OUTCOME_UNBOUNDED:
    status = is_unbounded (check, &is_true, diag);
    break;
  case QN_OUTCOME_CANCELLED:
  case QN_OUTCOME_NOT_CONVERGED:
    is_true = true;
    break;
  case QN_OUTCOME_COUNT:
    is_true = false;
    break;
  }
  if (r->limit.given)
    is_true = is_true && !r->has_first_limit_multiplier;
  /* Without any equilibrium there is nothing that is told of one, and in time no multiplier. */
  if (!any || in_time)
    is_true = is_true
              && !(r->has_collapse_multiplier || r->has_first_limit_multiplier
                   || r->event_count > 0 || r->solution_count > 0 || r->limit.given
                   || r->stability != QN_STABILITY_UNKNOWN || r->vibration.mode > 0);
  if (!is_true)
    tell (check, QN_CLAIM_OUTCOME);
  return status;
}

QnStatus
qn_check_course (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  size_t bodies = qn_result_body_count (r) * QN_DOF_COUNT;
  bool finite =
    !(r->has_collapse_multiplier && !isfinite (r->collapse_multiplier))
    && !(r->has_first_limit_multiplier && !isfinite (r->first_limit_multiplier))
    && all_finite (r->displacements, r->step_count * bodies)
    && all_finite (r->mechanism, bodies)
    && all_finite (r->history.rows, r->history.row_count * r->history.width);
  for (size_t i = 0; i < r->step_count; i++)
    finite = finite && isfinite (r->steps[i].multiplier) && isfinite (r->steps[i].time);
  for (size_t p = 0; r->step_count > 0 && p < r->pair_count; p++)
    finite =
      finite && isfinite (r->pairs[p].normal_force) && isfinite (r->pairs[p].shear_force);
  if (!finite)
    tell (check, QN_CLAIM_NUMBERS);
  check_order (check);
  QnStatus status = check_outcome (check, diag);
  /* Collapse is at the highest multiplier. */
  double peak;
  if (r->outcome == QN_OUTCOME_COLLAPSE && !r->has_collapse_multiplier
      && r->history.width == 0)
    tell (check, QN_CLAIM_COLLAPSE);
  if (r->has_collapse_multiplier && r->step_count > 0
      && !is_highest (check, r->collapse_multiplier, &peak))
    qn_check_tell_model (check, QN_CLAIM_COLLAPSE, QN_NONE, r->collapse_multiplier, peak);
  /* The first snap of the last stage is the first limit point; where the analysis stops
   * there, its highest multiplier. */
  bool stops = r->outcome == QN_OUTCOME_SNAP;
  double first = NAN;
  if (r->stability == QN_STABILITY_UNKNOWN && r->outcome != QN_OUTCOME_NOT_CONVERGED
      && (stops ? r->step_count != 0 : !r->events_unknown)) {
    for (size_t i = r->event_count; i-- > 0;)
      if (r->events[i].stage == r->stage && r->events[i].kind == QN_EVENT_KIND_SNAP)
        first = r->events[i].multiplier;
    if (stops ? !is_highest (check, r->first_limit_multiplier, &first)
              : r->has_first_limit_multiplier != !isnan (first)
                  || (!isnan (first) && !same (r->first_limit_multiplier, first)))
      qn_check_tell_model (
        check, QN_CLAIM_FIRST_LIMIT, QN_NONE,
        r->has_first_limit_multiplier ? r->first_limit_multiplier : NAN, first);
  }
  /* Results of earlier versions do not tell it. */
  QnResult found = *r; /* whose arrays stay the result's */
  qn_result_judge_linearity (check->model, &found);
  if (r->linearity != QN_LINEARITY_UNKNOWN
      && (r->linearity != found.linearity
          || !same (r->beyond_linear_multiplier, found.beyond_linear_multiplier)))
    qn_check_tell_model (check, QN_CLAIM_LINEARITY, QN_NONE, r->beyond_linear_multiplier,
                         found.beyond_linear_multiplier);
  return status;
}
