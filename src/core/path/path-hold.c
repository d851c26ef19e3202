/* Does a structure whose load grows slowly come to where a step of the path leads?
 *
 * In linear geometry a step prescribes work, not the load, and takes many joints at once. Without
 * associativity it may lead across a stretch in which a structure under its load moves on for good, to
 * equilibria that it never comes to. Two kinds of steps are doubtful:
 *
 *   a jump        from a peak of the path down and up again, of a snap's size
 *   a late stop   on the straight way there joints resist less than the load for long, and only where
 *                 gaps close at its end as much: whoever moves another way misses them
 *
 * Then the load is held at the multiplier of the new state, once it is higher by a part that counts,
 * and the structure is let go from the last equilibrium before, with damped motion. Where it rests
 * the path goes on. Where it falls, multipliers between are held until the highest at which it
 * rests is known: its collapse.
 */
#include "core/path/path-trace.h"

#include <string.h>

/* Multiplier at which the live load does the work that the joints resist at this part of the last step. */
static double
resistance (QnPathTrace *trace, double part)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnAssembly *as = &eq->assembly;
  const double *from = eq->committed.u;
  double resisted = 0, work = qn_equilibrium_live_work (eq, from);

  qn_equilibrium_save (eq, &trace->ahead);
  for (int32_t i = 0; i < as->unknown_count; i++)
    eq->trial[i] = from[i] + part * (eq->u[i] - from[i]);
  if (!qn_assembly_evaluate (as, eq->trial))
    work = 0;
  qn_assembly_residual (as, 0, eq->residual);
  for (int32_t i = 0; i < as->unknown_count; i++)
    resisted -= eq->residual[i] * (eq->u[i] - from[i]);
  qn_equilibrium_set_state (eq, &trace->ahead);
  return work > 0 ? resisted / work : INFINITY;
}

/* Relaxes the structure from trace->sure under a held load. */
static QnSolveStatus
let_go (QnPathTrace *trace, double multiplier)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  const QnTarget target = qn_target_multiplier (multiplier);
  int32_t before = eq->statistics.factorizations;

  qn_equilibrium_set_state (eq, &trace->sure);
  QnSolveStatus status =
    qn_equilibrium_relax (eq, trace->central, &target, INFINITY, NULL, QN_RELAX_BUDGET);
  trace->aside += eq->statistics.factorizations - before;
  if (status == QN_SOLVE_MECHANISM)
    memcpy (trace->buckling, eq->motion,
            (size_t) eq->assembly.unknown_count * sizeof (double));
  return status;
}

/* The structure falls under the load `high`: finds the highest load at which it rests by bisection. */
static bool
find_fall (QnPathTrace *trace, double high)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnSolveStatus status = QN_SOLVE_MECHANISM;

  qn_equilibrium_set_state (eq, &trace->highest);
  qn_equilibrium_save (eq, &eq->committed);
  while (high - trace->highest.multiplier > QN_PATH_NEARLY_SETTLED * high
         && (status == QN_SOLVE_MECHANISM || status == QN_SOLVE_CONVERGED)) {
    double middle = 0.5 * (trace->highest.multiplier + high);
    status = let_go (trace, middle);
    if (status == QN_SOLVE_MECHANISM)
      high = middle;
    trace->means = QN_FOUND_BY_RELAXATION;
    trace->jumped = false;
    if (status == QN_SOLVE_NO_MEMORY
        || (status == QN_SOLVE_CONVERGED && !qn_path_trace_accept (trace)))
      return false;
  }
  trace->events.below = false;
  trace->lower.multiplier = INFINITY;
  trace->fall.first = QN_FALL_STATES; /* no states of these falls are kept */
  qn_path_end_give_up (trace, status == QN_SOLVE_CANCELLED ? status : QN_SOLVE_MECHANISM);
  if (trace->stop == QN_STOP_FALL)
    trace->path->result->stop = QN_STOP_FALL;
  memcpy (eq->motion, trace->buckling,
          (size_t) eq->assembly.unknown_count * sizeof (double));
  return true;
}

bool
qn_path_hold (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double multiplier = eq->multiplier, from = trace->events.highest;
  double gain = multiplier - from;

  if (!trace->load_control || !qn_path_trace_is_linear (trace) || !trace->may_jump
      || trace->may_soften || trace->events.highest <= trace->events.least
      || !qn_path_events_climbs (&trace->events))
    return true;
  if (trace->events.below)
    trace->doubt = trace->doubt || qn_path_events_has_snapped (&trace->events);
  else if (!trace->doubt && gain > QN_PATH_IN_DOUBT * multiplier)
    trace->doubt =
      resistance (trace, QN_PATH_LATE) < from + QN_PATH_RESISTS * QN_PATH_LATE * gain;
  if (!trace->doubt
      || multiplier - trace->sure.multiplier <= QN_PATH_IN_DOUBT * multiplier)
    return true;
  qn_equilibrium_save (eq, &trace->ahead);
  trace->doubt = false;
  QnSolveStatus status = let_go (trace, multiplier);
  if (status == QN_SOLVE_NO_MEMORY || status == QN_SOLVE_CANCELLED)
    return qn_path_end_give_up (trace, status);
  if (status == QN_SOLVE_MECHANISM)
    return find_fall (trace, multiplier);
  qn_equilibrium_set_state (eq, &trace->ahead);
  return true;
}
