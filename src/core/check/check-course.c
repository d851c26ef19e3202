/* The course of an analysis: steps in order, events, and an outcome that is that of the last step. */
#include "core/check/check-parts.h"
#include "core/check/unlimited.h"

#include <math.h>

/* Multipliers that stand in a result twice are written alike. */
#define SAME 1e-9

static bool
same_multiplier (double a, double b)
{
  return qn_check_agrees (a, b, SAME * (1 + fabs (b)));
}

static void
check_numbers (QnCheck *check)
{
  const QnResult *r = check->result;
  size_t bodies = qn_result_body_count (r) * QN_DOF_COUNT;
  bool finite =
    !(r->has_collapse_multiplier && !isfinite (r->collapse_multiplier))
    && !(r->has_first_limit_multiplier && !isfinite (r->first_limit_multiplier));

  for (size_t i = 0; i < r->step_count; i++)
    finite = finite && isfinite (r->steps[i].multiplier) && isfinite (r->steps[i].time)
             && isfinite (r->steps[i].residual);
  const QnStatistics *spent = &r->statistics;
  finite = finite && spent->seconds >= 0 && spent->factor_seconds >= 0
           && spent->assembly_seconds >= 0 && spent->law_seconds >= 0;
  for (size_t i = 0; i < r->step_count * bodies; i++)
    finite = finite && isfinite (r->displacements[i]);
  for (size_t p = 0; r->step_count > 0 && p < r->pair_count; p++)
    finite =
      finite && isfinite (r->pairs[p].normal_force) && isfinite (r->pairs[p].shear_force);
  for (size_t i = 0; r->mechanism != NULL && i < bodies; i++)
    finite = finite && isfinite (r->mechanism[i]);
  for (size_t i = 0; i < r->history.row_count * r->history.width; i++)
    finite = finite && isfinite (r->history.rows[i]);
  if (!finite)
    qn_check_tell_model (check, QN_CLAIM_NUMBERS, QN_NONE, NAN, NAN);
}

/* The dead load first, stages one after the other, times growing; in time no multiplier. */
static void
check_order (QnCheck *check)
{
  const QnResult *r = check->result;
  bool in_time = r->history.width > 0;
  int32_t stages = (int32_t) check->model->stage_count;

  for (size_t i = 0; i < r->step_count; i++) {
    const QnStep *step = &r->steps[i];
    bool follows = i == 0 || in_time || stages == 0
                   || (step->stage >= r->steps[i - 1].stage && step->stage >= 1);
    bool in_order = step->stage <= stages && follows;
    if (i == 0 || in_time)
      in_order = in_order && step->multiplier == 0;
    if (in_time && i > 1)
      in_order = in_order && step->time > r->steps[i - 1].time;
    if (!in_order)
      qn_check_tell_model (check, QN_CLAIM_STEPS, (QnId) i,
                           in_time ? step->time : step->multiplier, NAN);
    if (!(step->residual >= 0
          && step->residual <= fmax (check->tolerance, QN_CHECK_FORCES)))
      qn_check_tell_model (check, QN_CLAIM_STEPS, (QnId) i, step->residual,
                           check->tolerance);
  }
}

static QnProcedure
procedure_of (const QnCheck *check, const QnStep *step)
{
  return step->stage > 0 && (size_t) step->stage <= check->model->stage_count
           ? check->model->stages[step->stage - 1].procedure
           : check->model->analysis.procedure;
}

static bool
is_same_state (const QnResult *r, size_t a, size_t b)
{
  size_t count = qn_result_body_count (r) * QN_DOF_COUNT;
  const double *u = qn_result_step_displacements (r, a),
               *v = qn_result_step_displacements (r, b);
  bool same = r->steps[a].multiplier == r->steps[b].multiplier;

  for (size_t i = 0; same && i < count; i++)
    same = u[i] == v[i];
  return same;
}

/* No step of a path repeats the one before, and where the load is prescribed it grows all the time; only
 * the last step may lie below, where the structure moves on. Limit analysis has two: before and at
 * collapse. */
static void
check_advance (QnCheck *check)
{
  const QnResult *r = check->result;
  double grows = 0;

  if (r->limit.given && r->step_count != 2)
    qn_check_tell_model (check, QN_CLAIM_STEPS, QN_NONE, NAN, NAN);
  if (r->limit.given || r->history.width > 0)
    return;
  for (size_t i = 1; i < r->step_count; i++) {
    bool begins = r->steps[i].stage != r->steps[i - 1].stage;
    bool ends = i + 1 == r->step_count && r->outcome == QN_OUTCOME_COLLAPSE;
    double more = r->steps[i].multiplier - r->steps[i - 1].multiplier;
    bool in_order = begins || !is_same_state (r, i - 1, i);
    if (!begins && !ends && procedure_of (check, &r->steps[i]) == QN_PROCEDURE_LOAD)
      in_order = in_order && (grows == 0 ? more != 0 : grows * more > 0);
    grows = begins ? 0 : more;
    if (!in_order)
      qn_check_tell_model (check, QN_CLAIM_STEPS, (QnId) i, r->steps[i].multiplier, NAN);
  }
}

/* Collapse is the last step of all, and only where that is the outcome; only paths jump. */
static void
check_events (QnCheck *check)
{
  const QnResult *r = check->result;
  bool is_path = !r->limit.given && r->history.width == 0;

  for (size_t i = 0; i < r->step_count; i++) {
    bool is_last = i + 1 == r->step_count;
    bool collapses = r->steps[i].event == QN_EVENT_COLLAPSE;
    bool should = is_last && r->outcome == QN_OUTCOME_COLLAPSE;
    /* Motion that is driven may go on beyond its collapse multiplier. */
    if (collapses != should)
      qn_check_tell_model (check, QN_CLAIM_EVENTS, (QnId) i, NAN, NAN);
    bool ends = is_last && r->outcome == QN_OUTCOME_SNAP;
    bool may_jump = ends || (i > 0 && is_path && r->stability == QN_STABILITY_UNKNOWN);
    if (r->steps[i].event == QN_EVENT_SNAP ? !may_jump : ends)
      qn_check_tell_model (check, QN_CLAIM_EVENTS, (QnId) i, NAN, NAN);
  }
}

/* Without any equilibrium there is nothing that is told of one, and in time no multiplier. */
static void
check_nothing (QnCheck *check)
{
  const QnResult *r = check->result;
  bool tells = r->has_collapse_multiplier || r->has_first_limit_multiplier
               || r->event_count > 0 || r->solution_count > 0 || r->limit.given
               || r->stability != QN_STABILITY_UNKNOWN || r->vibration.mode > 0;

  if ((r->step_count == 0 || r->history.width > 0) && tells)
    qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
}

double
qn_check_sense (const QnCheck *check, size_t step, double from)
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

/* Of the steps of the last stage: the highest multiplier, counted in the sense in which it grows. */
static double
find_peak (const QnCheck *check, double *sense)
{
  const QnResult *r = check->result;
  int32_t stage = r->steps[r->step_count - 1].stage;
  double first = NAN, peak = NAN;

  *sense = 1;
  for (size_t i = 0; i < r->step_count; i++) {
    double at = r->steps[i].multiplier;
    if (r->steps[i].stage != stage)
      continue;
    if (isnan (first)) {
      double before[QN_MAX_LOAD_SETS] = { 0 };
      uint32_t sets = stage > 0 ? check->model->stages[stage - 1].sets : 1;
      if (stage > 0 && i > 0)
        qn_result_load_factors (check->model, r, i - 1, before);
      int set = 0;
      while (set < QN_MAX_LOAD_SETS - 1 && (sets >> set & 1) == 0)
        set++;
      first = before[set];
      *sense = qn_check_sense (check, i, first);
      peak = stage > 0 && *sense * first > *sense * at ? first : at;
    }
    if (*sense * at > *sense * peak)
      peak = at;
  }
  return peak;
}

/* In linear geometry a structure that moves on for good collapses at its last multiplier, unless that has
 * fallen to nothing; in large displacements, and where joints lose strength, at the highest. Where its
 * mechanism is not known, either may be told. */
static void
check_collapse (QnCheck *check)
{
  const QnResult *r = check->result;
  double sense, peak;

  if (r->outcome == QN_OUTCOME_COLLAPSE && !r->has_collapse_multiplier
      && r->history.width == 0)
    qn_check_tell_model (check, QN_CLAIM_COLLAPSE, QN_NONE, NAN, NAN);
  if (!r->has_collapse_multiplier || r->step_count == 0)
    return;
  peak = find_peak (check, &sense);
  double last = r->steps[r->step_count - 1].multiplier;
  bool is_last = r->outcome == QN_OUTCOME_COLLAPSE && sense * last > 0
                 && check->model->analysis.geometry == QN_GEOMETRY_LINEAR
                 && !qn_assembly_may_soften (&check->assembly);
  double told = is_last ? last : peak;
  /* A path that gains less than equilibrium may lack does not climb. */
  double gain = sense * (peak - r->collapse_multiplier);
  bool is_peak =
    gain >= 0 && gain <= check->model->analysis.residual_tolerance * fabs (peak);
  if (!same_multiplier (r->collapse_multiplier, told) && !(is_peak && !is_last)
      && !(r->mechanism_uncertain && same_multiplier (r->collapse_multiplier, peak)))
    qn_check_tell_model (check, QN_CLAIM_COLLAPSE, QN_NONE, r->collapse_multiplier, told);
}

static bool
lies_between (double stated, double low, double high)
{
  return stated >= low - SAME * (1 + fabs (low))
         && stated <= high + SAME * (1 + fabs (high));
}

/* At a jump, where load is what drives; otherwise among the steps. */
static void
check_first_limit (QnCheck *check)
{
  const QnResult *r = check->result;
  double low = INFINITY, high = -INFINITY, stated = r->first_limit_multiplier;
  bool jumps = false, at_jump = false;

  if (!r->has_first_limit_multiplier || r->step_count == 0
      || check->model->stage_count > 0)
    return;
  for (size_t i = 0; i < r->step_count; i++) {
    double at = r->steps[i].multiplier;
    low = fmin (low, at);
    high = fmax (high, at);
    if (i == 0 || r->steps[i].event != QN_EVENT_SNAP)
      continue;
    jumps = true;
    at_jump = at_jump || lies_between (stated, r->steps[i - 1].multiplier, at);
  }
  bool by_load = check->model->analysis.procedure == QN_PROCEDURE_LOAD;
  /* The next stable state was not reached where the analysis stops there. */
  bool stops = r->outcome == QN_OUTCOME_SNAP;
  if (!lies_between (stated, low, stops ? INFINITY : high)
      || (jumps && by_load && !stops && !at_jump))
    qn_check_tell_model (check, QN_CLAIM_FIRST_LIMIT, QN_NONE, stated, high);
}

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
  return last->multiplier >= end * (1 - SAME) || last->multiplier >= 1e9 * (1 - SAME);
}

/* Limit analysis tells no step (check-fall.c). A path goes on to the largest multiplier there is, unless no
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
  bool in_time = r->history.width > 0, is_true = true;
  QnStatus status = QN_OK;
  const QnStep *last = r->step_count > 0 ? &r->steps[r->step_count - 1] : NULL;

  switch (r->outcome) {
  case QN_OUTCOME_COLLAPSE:
    is_true = last != NULL && r->mechanism != NULL;
    break;
  case QN_OUTCOME_TARGET_REACHED:
    if (in_time)
      is_true = last != NULL
                && qn_check_agrees (last->time, qn_model_duration (check->model),
                                    1e-6 * qn_model_duration (check->model));
    else
      is_true =
        last != NULL && reached_target (check) && r->stability != QN_STABILITY_LOST;
    break;
  case QN_OUTCOME_SNAP:
    is_true =
      last != NULL && r->has_first_limit_multiplier && r->stability != QN_STABILITY_KEPT;
    break;
  case QN_OUTCOME_DEAD_LOAD_UNSTABLE:
    is_true = r->step_count == 0 && r->unstable_count > 0 && !r->has_collapse_multiplier;
    break;
  case QN_OUTCOME_REST:
    is_true = in_time && last != NULL;
    break;
  case QN_OUTCOME_UNBOUNDED:
    status = is_unbounded (check, &is_true, diag);
    break;
  case QN_OUTCOME_CANCELLED:
  case QN_OUTCOME_NOT_CONVERGED:
    break;
  case QN_OUTCOME_COUNT:
    is_true = false;
    break;
  }
  if (!is_true)
    qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
  return status;
}

/* Results of earlier versions do not tell it. */
static void
check_linearity (QnCheck *check)
{
  QnResult found = *check->result; /* whose arrays stay the result's */

  qn_result_judge_linearity (check->model, &found);
  if (check->result->linearity != QN_LINEARITY_UNKNOWN
      && (check->result->linearity != found.linearity
          || !same_multiplier (check->result->beyond_linear_multiplier,
                               found.beyond_linear_multiplier)))
    qn_check_tell_model (check, QN_CLAIM_LINEARITY, QN_NONE,
                         check->result->beyond_linear_multiplier,
                         found.beyond_linear_multiplier);
}

QnStatus
qn_check_course (QnCheck *check, QnDiag *diag)
{
  check_numbers (check);
  check_order (check);
  check_advance (check);
  check_events (check);
  QnStatus status = check_outcome (check, diag);
  check_nothing (check);
  check_collapse (check);
  check_first_limit (check);
  check_linearity (check);
  return status;
}
