/* One step of the trace.
 *
 * Every step climbs the same ladder. Newton's method; then the central path, which takes the step as a
 * whole, where there are joints for it; then a shorter step. What is left is a jump with the measure held:
 * the structure moves until it rests, by viscous relaxation. That comes last because under damping joints
 * slide that would not otherwise: it rests below the path, and Newton's method fails from there again.
 */
#include "core/base/numbers.h"
#include "core/path/path-trace.h"

#include <string.h>

/* Whether a bond that was whole is broken in the state just solved: what happens first in a long step may
 * spare others, or not let them bear what they would bear together. */
static bool
breaks_bond (const QnEquilibrium *eq)
{
  const QnAssembly *as = &eq->assembly;

  for (size_t p = 0; p < as->pair_count; p++)
    if (qn_pair_damage (&as->springs[p], &as->responses[p].memory) >= 1
        && qn_pair_damage (&as->springs[p], &eq->committed.memory[p]) <= 0)
      return true;
  return false;
}

/* An equilibrium that the structure would leave at once is none. */
static QnSolveStatus
refuse_unstable (QnPathTrace *trace, QnSolveStatus status)
{
  bool unstable = trace->path->equilibrium.orientation * trace->orientation < 0;

  if (status != QN_SOLVE_CONVERGED || !unstable)
    return status;
  trace->refused = true;
  return QN_SOLVE_FAILED;
}

double
qn_path_last_advance (const QnPathTrace *trace)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnPathMeasure *measure = &trace->measure;
  double advanced = 0;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    advanced += measure->direction[i] * (eq->committed.u[i] - measure->last_u[i]);
  return advanced;
}

/* By Newton's method, or else along the central path. Stability counts where the branch that is
 * lost leads elsewhere: in linear geometry what the central path finds goes on to the same plateau,
 * and what relaxation would find instead may not. */
static QnSolveStatus
solve_statically (QnPathTrace *trace, const QnTarget *target)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnSolveStatus status;

  trace->means = QN_FOUND_BY_NEWTON;
  if (qn_path_predictor_go (&trace->predictor, eq, target->advance)) {
    status =
      refuse_unstable (trace, qn_equilibrium_newton (eq, target, 0, QN_NEWTON_EASY));
    if (status != QN_SOLVE_FAILED)
      return status;
    qn_equilibrium_restore (eq);
  }
  status =
    refuse_unstable (trace, qn_equilibrium_newton (eq, target, 0, QN_NEWTON_BUDGET));
  if (status != QN_SOLVE_FAILED || trace->central == NULL)
    return status;
  qn_equilibrium_restore (eq);
  trace->means = QN_FOUND_BY_CENTRAL_PATH;
  eq->orientation =
    trace->orientation; /* should Newton's method find nothing left to do */
  status = qn_central_path_solve (trace->central, target, 0);
  return qn_path_trace_is_linear (trace) ? status : refuse_unstable (trace, status);
}

/* Whether a step moved JUMP times farther than the pace of the steps before it predicts. */
static bool
is_jump (const QnPathTrace *trace, double step)
{
  return trace->pace > 0
         && qn_equilibrium_motion (&trace->path->equilibrium)
              > QN_PATH_JUMP * trace->pace * fabs (step);
}

/* In nonlinear geometry: how far the state just solved is from where the last step, of the measure by `last`,
 * leads on to, and how far may be; where that step tells nothing (0), the motion. Joints that change their
 * state bend the path, and a shorter step departs less. Another branch stays as far away, and often is nearer
 * than one step moves. */
static double
departure (const QnPathTrace *trace, double step, double last, double *most)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const double *now = eq->committed.u, *before = trace->measure.last_u;
  double *away = eq->trial;

  *most = trace->pace * fabs (step);
  if (last == 0) {
    *most *= QN_PATH_JUMP;
    return qn_equilibrium_motion (eq);
  }
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    away[i] = eq->u[i] - now[i] - step / last * (now[i] - before[i]);
  return qn_assembly_largest (&eq->assembly, away, NULL);
}

/* Linear geometry: tries the step, cut up to QN_PATH_MOST_CUTS times, then relaxes the structure, which may
 * jump. Softening joints may be beyond a bifurcation, where shorter steps are unstable, too. */
static QnSolveStatus
solve_linear (QnPathTrace *trace, double *step)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnSolveStatus status;
  QnTarget target;

  for (int cut = 0;; cut++) {
    target = (QnTarget){ .direction = trace->measure.direction, .advance = *step };
    trace->refused = false;
    status = solve_statically (trace, &target);
    trace->jumped =
      trace->may_soften && status == QN_SOLVE_CONVERGED && is_jump (trace, *step);
    if (status != QN_SOLVE_FAILED && (!trace->jumped || cut == QN_PATH_MOST_CUTS))
      return status;
    qn_equilibrium_restore (eq);
    if (cut == QN_PATH_MOST_CUTS || (trace->refused && trace->may_soften))
      break;
    *step *= QN_PATH_CUT;
  }
  trace->means = QN_FOUND_BY_RELAXATION;
  status =
    qn_equilibrium_relax (eq, trace->central, &target, INFINITY, NULL, QN_RELAX_BUDGET);
  trace->jumped = status == QN_SOLVE_CONVERGED && is_jump (trace, *step);
  return status;
}

/* Where a structure cannot stay at the equilibrium that was found, although the measure is held: straight
 * columns beyond buckling, stacks that rock at two joints. It leaves in the motion of the lowest
 * eigenvalue, by a characteristic length, and Newton's method finds where it comes to. FAILED where that is
 * no better. */
static QnSolveStatus
leave_unstable (QnPathTrace *trace, const QnTarget *target)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  QnSolveStatus status = qn_path_judge_stability (trace->path, target->direction, true);

  if (status != QN_SOLVE_MECHANISM)
    return status;
  memcpy (trace->buckling, eq->motion, (size_t) as->unknown_count * sizeof (double));
  qn_equilibrium_restore (eq);
  for (int32_t i = 0; i < as->unknown_count; i++)
    eq->u[i] += as->length * trace->buckling[i];
  if (!qn_assembly_evaluate (&eq->assembly, eq->u))
    return QN_SOLVE_FAILED;
  status = qn_equilibrium_newton (eq, target, 0, QN_NEWTON_BUDGET);
  trace->means = QN_FOUND_BY_NEWTON;
  if (status == QN_SOLVE_CONVERGED)
    status = qn_path_judge_stability (trace->path, target->direction, true);
  return status == QN_SOLVE_MECHANISM ? QN_SOLVE_FAILED : status;
}

/* The equilibrium where the measure has advanced by `step`, and whether the structure can stay there under
 * its loads: MECHANISM where it cannot. */
static QnSolveStatus
probe (QnPathTrace *trace, double step)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  const QnTarget target = { .direction = trace->measure.direction, .advance = step };

  qn_equilibrium_restore (eq);
  QnSolveStatus status = qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
  return status == QN_SOLVE_CONVERGED ? qn_path_judge_stability (trace->path, NULL, true)
                                      : status;
}

/* Whether the load does no work in the motion that leaves an unstable equilibrium: then the branch goes on
 * beyond, as it does not at a limit point. */
static bool
is_across (const QnPathTrace *trace)
{
  const QnAssembly *as = &trace->path->equilibrium.assembly;
  const double *live = as->live, *motion = trace->buckling;
  size_t n = (size_t) as->unknown_count;

  return fabs (qn_dot (live, motion, n))
         <= QN_PATH_NONE * sqrt (qn_dot (live, live, n) * qn_dot (motion, motion, n));
}

/* Whether the structure can stay at the equilibrium just solved under its loads; or MECHANISM, with
 * trace->refused where the branch may end before. */
static QnSolveStatus
look_across (QnPathTrace *trace)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  QnSolveStatus status = qn_path_judge_stability (trace->path, NULL, true);

  if (status != QN_SOLVE_MECHANISM)
    return status;
  memcpy (trace->buckling, eq->motion,
          (size_t) eq->assembly.unknown_count * sizeof (double));
  trace->refused = is_across (trace);
  trace->looks -= !trace->refused;
  return status;
}

/* Where the branch of a path that climbs loses its stability within a step, *step on entry: CONVERGED with
 * the last stable equilibrium, to a tenth of the multiplier tolerance, and *step that leads to it; FAILED,
 * and nothing has changed, where it does not. */
static QnSolveStatus
find_end_of_branch (QnPathTrace *trace, double *step)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  double tolerance = 0.1 * trace->path->settings->multiplier_tolerance;
  double from = eq->committed.multiplier, to = from;
  double low = 0, high = *step, middle = high;
  QnSolveStatus status = probe (trace, middle);

  for (int k = 0; status == QN_SOLVE_CONVERGED || status == QN_SOLVE_MECHANISM; k++) {
    if (status == QN_SOLVE_MECHANISM) {
      high = middle;
      to = eq->multiplier;
      qn_equilibrium_save (eq, &eq->anchor);
      memcpy (trace->buckling, eq->motion,
              (size_t) eq->assembly.unknown_count * sizeof (double));
      if (!is_across (trace))
        break;
    } else if (k > 0) {
      low = middle;
      from = eq->multiplier;
    } else
      break; /* stable after all */
    if (k == QN_PATH_BISECTIONS || to - from <= tolerance * fabs (to)) {
      status = probe (trace, low);
      double moved = qn_assembly_largest (as, eq->u, trace->events.rest);
      if (status != QN_SOLVE_CONVERGED /* or on another branch */
          || qn_assembly_largest (as, eq->u, eq->anchor.u) > QN_PATH_NONE * moved)
        break;
      *step = low;
      return status;
    }
    middle = 0.5 * (low + high);
    status = probe (trace, middle);
  }
  qn_equilibrium_restore (eq);
  return status == QN_SOLVE_CANCELLED || status == QN_SOLVE_NO_MEMORY ? status
                                                                      : QN_SOLVE_FAILED;
}

/* The same for a step that has met an unstable equilibrium: it ends there. FAILED where it goes on. */
static QnSolveStatus
end_branch (QnPathTrace *trace, double *step)
{
  double part = *step;
  QnSolveStatus status = find_end_of_branch (trace, &part);

  trace->looks--;
  if (status != QN_SOLVE_CONVERGED)
    return status;
  trace->looks = 0;
  if (part == 0) /* with the last step */
    return qn_path_events_buckle (&trace->events, trace->buckling) ? QN_SOLVE_FAILED
                                                                   : QN_SOLVE_NO_MEMORY;
  *step = part;
  trace->means = QN_FOUND_BY_NEWTON;
  trace->jumped = false;
  trace->ends_branch = true;
  return status;
}

/* In nonlinear geometry, where branches lie close to each other: cut until it is solved without a jump
 * or is the smallest one. Static solutions come first, and are cheap, unless relaxation was needed
 * just before: then their first failure is enough. Relaxation moves the structure no farther than a
 * block, or a radian, beyond which the contacts that were detected mean nothing. Under load control the
 * load is held first where no static solution is found (path-trace.c). */
static QnSolveStatus
solve_nonlinear (QnPathTrace *trace, double *step)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double least_for_newton = trace->means == QN_FOUND_BY_RELAXATION && !trace->load_control
                              ? INFINITY
                              : pow (QN_PATH_CUT, QN_PATH_MOST_CUTS) * trace->largest;
  bool is_smooth = !trace->jumped && trace->means != QN_FOUND_BY_RELAXATION;
  double last = is_smooth ? qn_path_last_advance (trace) : 0;
  double far = eq->assembly.length;
  bool relaxes = false;
  bool looks = trace->looks > 0 && !trace->events.below;

  for (;;) {
    const QnTarget target = { .direction = trace->measure.direction, .advance = *step };
    bool smallest = fabs (*step) <= QN_PATH_SMALLEST_STEP * trace->largest;
    trace->refused = false;
    QnSolveStatus status =
      relaxes ? qn_equilibrium_relax (eq, NULL, &target, far, NULL,
                                      smallest ? QN_RELAX_BUDGET_HELD : QN_TRIED)
              : solve_statically (trace, &target);
    if (relaxes)
      trace->means = QN_FOUND_BY_RELAXATION;
    bool judged = looks && status == QN_SOLVE_CONVERGED;
    if (judged)
      status = look_across (trace);
    if (looks && trace->refused) {
      looks = false;
      status = end_branch (trace, step);
      if (status != QN_SOLVE_FAILED)
        return status;
      continue;
    }
    if (status == (judged ? QN_SOLVE_MECHANISM : QN_SOLVE_CONVERGED))
      status = leave_unstable (trace, &target);
    bool solved = status == QN_SOLVE_CONVERGED;
    double most = 0, away = solved ? departure (trace, *step, last, &most) : 0;
    trace->jumped = most > 0 && away > most;
    if (status == QN_SOLVE_CANCELLED || status == QN_SOLVE_NO_MEMORY
        || (solved && !trace->jumped) || (smallest && (solved || relaxes)))
      return status;
    qn_equilibrium_restore (eq);
    if (relaxes || fabs (*step) * QN_PATH_CUT >= least_for_newton)
      *step *= QN_PATH_CUT;
    else if (trace->load_control && !trace->events.below)
      return QN_SOLVE_FAILED;
    else
      relaxes = true;
  }
}

void
qn_path_step_aim (QnPathTrace *trace, double step)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  double share = INFINITY;

  for (size_t p = 0; p < as->pair_count && trace->may_soften; p++) {
    double before = qn_pair_bond_strain (&as->springs[p], &eq->committed.responses[p]);
    double now = qn_pair_bond_strain (&as->springs[p], &as->responses[p]);
    if (now > before && now < 1)
      share = fmin (share, (1 - now) / (now - before));
  }
  double way = share * fabs (step), little = QN_PATH_SMALLEST_STEP * trace->largest;
  way += way > 2 * little ? -little : little;
  if (!isfinite (way))
    return;
  double most = fabs (trace->step);
  if (qn_path_trace_is_linear (trace)) /* the path is straight until then */
    most = fmax (most, trace->largest);
  trace->step = copysign (fmin (most, way), trace->step);
}

/* Cuts a step in which a bond breaks until it ends at the break within the smallest step. */
QnSolveStatus
qn_path_step_solve (QnPathTrace *trace, double *step)
{
  for (;;) {
    QnSolveStatus status = qn_path_trace_is_linear (trace)
                             ? solve_linear (trace, step)
                             : solve_nonlinear (trace, step);
    if (status != QN_SOLVE_CONVERGED || !trace->may_soften
        || fabs (*step) <= 3 * QN_PATH_SMALLEST_STEP * trace->largest
        || !breaks_bond (&trace->path->equilibrium))
      return status;
    qn_equilibrium_restore (&trace->path->equilibrium);
    *step *= 0.5;
  }
}

QnSolveStatus
qn_path_step_solve_load (QnPathTrace *trace, double target, bool *easy)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  const QnTarget goal = qn_target_multiplier (target);
  double increment = target - eq->committed.multiplier;
  QnSolveStatus status = qn_equilibrium_newton (eq, &goal, 0, QN_NEWTON_EASY);

  trace->means = QN_FOUND_BY_NEWTON;
  trace->jumped = false;
  if (status == QN_SOLVE_CONVERGED)
    status = qn_path_judge_stability (trace->path, NULL, false);
  *easy = status == QN_SOLVE_CONVERGED && !is_jump (trace, increment)
          && !(trace->may_soften && breaks_bond (eq));
  return status;
}

bool
qn_path_step_was_easy (const QnPathTrace *trace, int32_t iterations)
{
  /* A step along the central path does not tell how many joints changed state; in nonlinear geometry
   * the branch depends on them, which matters where what lies between is to be seen. */
  bool may_grow = qn_path_trace_is_linear (trace) || trace->load_control;

  return trace->means == QN_FOUND_BY_RELAXATION || iterations <= QN_NEWTON_EASY
         || (trace->means == QN_FOUND_BY_CENTRAL_PATH && may_grow);
}

/* What part of the step leads to the end of the path, which is *end then: the largest multiplier,
 * or multiplier zero beyond the peak where there is no controlled displacement; or that
 * displacement where another measure is prescribed. Infinite where the step passes none. */
static double
share_to_end (const QnPathTrace *trace, QnTarget *end)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnPathMeasure *measure = &trace->measure;
  double before = eq->committed.multiplier, share = INFINITY;
  bool falls = measure->unknown == QN_NONE && trace->events.below && !trace->load_control;

  *end = qn_target_multiplier (eq->multiplier > 0 ? trace->end : 0);
  if (eq->multiplier > trace->end || (falls && eq->multiplier < 0))
    share = (end->multiplier - before) / (eq->multiplier - before);
  if (measure->procedure != QN_PROCEDURE_DISPLACEMENT
      && qn_path_measure_is_at_end (measure)) {
    double start = eq->committed.u[measure->unknown];
    double way = (measure->end - start) / (eq->u[measure->unknown] - start);
    if (way < share)
      *end = (QnTarget){ .direction = measure->unit, .advance = measure->end - start };
    share = fmin (way, share);
  }
  return share;
}

QnSolveStatus
qn_path_step_land (QnPathTrace *trace, double *share)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnTarget end;

  *share = share_to_end (trace, &end);
  if (!(*share < 1))
    return QN_SOLVE_CONVERGED;
  qn_equilibrium_save (eq, &eq->anchor);
  QnSolveStatus status = qn_equilibrium_newton (eq, &end, 0, QN_NEWTON_BUDGET);
  if (status == QN_SOLVE_FAILED)
    qn_equilibrium_set_state (eq, &eq->anchor);
  return status;
}
