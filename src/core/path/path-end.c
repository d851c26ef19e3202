/* Where the trace ends. */
#include "core/base/tolerance.h"
#include "core/path/path-trace.h"

/* Whether the path may end on a plateau: in linear geometry motion knows no end. */
static bool
may_end_on_plateau (const QnPathTrace *trace)
{
  return qn_path_trace_is_linear (trace)
         && trace->measure.procedure != QN_PROCEDURE_DISPLACEMENT;
}

/* Whether the structure has run away under a multiplier that hardly follows. If that goes like collapse -
 * constant / motion, it has still to gain a part of itself: near collapse less and less, all of it while the
 * structure is elastic. */
static bool
is_gone (const QnPathTrace *trace, double motion)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  double tolerance = trace->path->settings->multiplier_tolerance;
  double before =
    qn_assembly_elastic_displacements (&eq->assembly, trace->measure.last_u, NULL);
  double gain = eq->multiplier / trace->last_multiplier - 1;
  double left = fabs (gain * before / (motion - before));

  return motion > eq->runaway && left <= QN_PATH_NEARLY_SETTLED
         && (trace->may_jump || motion > QN_FARTHEST
             || left <= QN_PATH_SETTLED * tolerance);
}

double
qn_path_end_gain (const QnPathTrace *trace)
{
  const QnResult *result = trace->path->result;
  size_t last = result->step_count - 1, first = last, half = last;

  while (first > 0 && result->steps[first - 1].stage == result->steps[last].stage)
    first--;
  if (first > 0)
    first--; /* where the stage began */
  double motion = qn_result_motion (result, first, last), before = motion;
  while (half > first && before > motion / 2)
    before = qn_result_motion (result, first, --half);
  double multiplier = result->steps[last].multiplier;
  double gain = multiplier - result->steps[half].multiplier;
  return half > first ? gain / (fabs (multiplier) * log2 (motion / before)) : INFINITY;
}

/* Whether the multiplier was constant, or under load control did not rise, while the motion grew
 * QN_PATH_PLATEAU_GROWTH times; or the motion exceeds eq->runaway. */
static bool
is_plateau (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnAssembly *as = &eq->assembly;
  const double *last_u = trace->measure.last_u;
  double tolerance =
    trace->may_jump ? QN_PATH_PLATEAU : trace->path->settings->multiplier_tolerance;
  double motion = qn_assembly_elastic_displacements (as, eq->u, NULL);
  bool climbs_no_more = trace->load_control && !trace->may_soften;
  double level = climbs_no_more ? trace->events.highest : eq->multiplier;

  if (!may_end_on_plateau (trace))
    return false;
  if (is_gone (trace, motion))
    return true;
  if (fabs (level - trace->plateau_multiplier) > tolerance * fabs (level)) {
    trace->plateau_multiplier = level;
    trace->plateau_motion = motion;
    return false;
  }
  if (motion <= QN_PATH_PLATEAU_GROWTH * trace->plateau_motion)
    return false;
  /* The motion of the last step may continue up to eq->runaway if no open joint will close. */
  double step = qn_assembly_elastic_displacements (as, eq->u, last_u);
  qn_assembly_update_kinematics (as, last_u);
  qn_equilibrium_note_gaps (eq);
  qn_assembly_update_kinematics (as, eq->u);
  return !qn_equilibrium_will_close (eq, 1, fmax (0, eq->runaway - motion) / step);
}

void
qn_path_end_finish (QnPathTrace *trace, QnOutcome outcome, QnStop stop)
{
  trace->path->result->outcome = outcome;
  trace->stop = stop;
}

void
qn_path_end_check (QnPathTrace *trace)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnPathEvents *events = &trace->events;
  /* In linear geometry load control goes on below zero: what moves then is the mechanism. */
  bool linear = qn_path_trace_is_linear (trace);
  bool falls = trace->measure.unknown == QN_NONE && events->below
               && !(trace->load_control && linear);
  /* In large displacements far since the highest multiplier: below it, or, where blocks slide, on a plateau. */
  double moved = events->displacement - events->highest_displacement;
  bool has_collapsed =
    trace->load_control && !linear && moved > QN_PATH_COLLAPSED * eq->assembly.length;

  if (events->below && trace->path->settings->snap == QN_SNAP_THROUGH_STOP
      && (!trace->load_control || qn_path_events_has_snapped (events)))
    qn_path_end_finish (trace, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
  else if (eq->multiplier >= (1 - QN_TOLERANCE_TARGET) * trace->end)
    qn_path_end_finish (trace, QN_OUTCOME_TARGET_REACHED, QN_STOP_MULTIPLIER);
  else if (qn_path_measure_is_at_end (&trace->measure))
    qn_path_end_finish (trace, QN_OUTCOME_TARGET_REACHED, QN_STOP_DISPLACEMENT);
  else if (falls && eq->multiplier <= QN_TOLERANCE_TARGET * events->highest)
    qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_ZERO);
  else if (!events->below && events->displacement > trace->extent)
    qn_path_end_finish (trace, QN_OUTCOME_UNBOUNDED, QN_STOP_MULTIPLIER);
  else if (has_collapsed)
    qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_FALL);
  else if (is_plateau (trace))
    qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_PLATEAU);
}

bool
qn_path_end_give_up (QnPathTrace *trace, QnSolveStatus status)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double motion =
    qn_assembly_elastic_displacements (&eq->assembly, eq->committed.u, NULL);

  qn_equilibrium_restore (eq);
  switch (status) {
  case QN_SOLVE_CONVERGED:
    qn_path_end_finish (trace, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
    break;
  case QN_SOLVE_MECHANISM:
    qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_FALL);
    break;
  case QN_SOLVE_CANCELLED:
    qn_path_end_finish (trace, QN_OUTCOME_CANCELLED, QN_STOP_CANCELLED);
    break;
  case QN_SOLVE_FAILED:
  case QN_SOLVE_NO_MEMORY:
    if (may_end_on_plateau (trace)
        && (motion > eq->runaway || trace->moved_on
            || qn_path_end_gain (trace) <= QN_PATH_SETTLES)) {
      qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_PLATEAU);
      trace->path->result->mechanism_uncertain = motion <= eq->runaway;
    } else
      qn_path_end_finish (trace, QN_OUTCOME_NOT_CONVERGED, QN_STOP_STEP_TOO_SMALL);
    break;
  }
  return status != QN_SOLVE_NO_MEMORY;
}
