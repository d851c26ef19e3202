/* One trace of the path of equilibria, for every procedure.
 *
 * A step prescribes how far one measure advances: the multiplier, a displacement, the work of the
 * live load, or the length of the path. Load control prescribes the multiplier as long as Newton's
 * method gets through easily. From then on it prescribes the work of the live load, as a jack does
 * that advances slowly: where the path turns down, a structure under a load that keeps growing
 * would leave it there, and would meet it again where it climbs above that multiplier. Load control
 * reports these equilibria alone, the jumps between them as events, and the multiplier that the path
 * does not climb above again as the collapse multiplier. So a jump ends on the path itself, not
 * wherever an iteration happens to find an equilibrium, and sizes of steps hardly matter.
 */
#include "core/path/path-trace.h"
#include "core/base/box.h"
#include "core/base/tolerance.h"
#include "core/check/second-order-work.h"
#include "core/check/unlimited.h"

#include <string.h>

/* --- Sizes of steps ---------------------------------------------------------------------- */

/* How far the direction of motion has turned in the step just solved: the largest difference between it
 * and that of the step before, both as parts of the largest motion. */
static double
turn_of_motion (const QnPathTrace *trace)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  const double *last = trace->measure.last_u, *from = eq->committed.u;
  double before = qn_assembly_largest (as, from, last);
  double now = qn_assembly_largest (as, eq->u, from);
  double *turn = eq->trial;

  if (before == 0 || now == 0)
    return INFINITY;
  for (int32_t i = 0; i < as->unknown_count; i++)
    turn[i] = (eq->u[i] - from[i]) / now - (from[i] - last[i]) / before;
  return qn_assembly_largest (as, turn, NULL);
}

static double
growth (const QnPathTrace *trace)
{
  if (!trace->load_control)
    return QN_PATH_GROWTH; /* the states between are part of the answer */
  if (!trace->may_jump)
    return 1 / QN_PATH_CUT;
  bool steady = qn_path_trace_is_linear (trace) && trace->central != NULL
                && trace->measure.procedure == QN_PROCEDURE_WORK
                && turn_of_motion (trace) < QN_PATH_TURN;
  return steady ? QN_PATH_GROWTH_STEADY : QN_PATH_GROWTH;
}

/* Largest next step: displacement control keeps to multiples of the requested increment; steps of other
 * measures grow with the motion, in nonlinear geometry up to QN_PATH_LARGEST_MOTION, since longer steps
 * may lead to other branches of sliding joints. */
static double
largest_next_step (const QnPathTrace *trace)
{
  bool is_displacement = trace->measure.procedure == QN_PROCEDURE_DISPLACEMENT;
  double first = fabs (trace->measure.first),
         most = is_displacement ? QN_PATH_LARGEST_STEP * first : INFINITY,
         far = QN_PATH_LARGEST_MOTION * trace->path->equilibrium.assembly.length;

  if (qn_path_trace_is_linear (trace) || trace->pace == 0
      || (is_displacement && trace->central == NULL))
    return most;
  return fmin (most, fmax (far / trace->pace, is_displacement ? first : 0));
}

/* Whether steps that pass the highest multiplier are cut until they meet it. In linear geometry without softening
 * load control holds the load above it, and other procedures meet it to the length of their steps. */
static bool
ends_at_peak (const QnPathTrace *trace)
{
  return trace->may_soften || !qn_path_trace_is_linear (trace);
}

/* Whether a step passes the maximum of the multiplier and may miss it by more than the tolerance. A concave
 * path lies below its tangents at both ends of the step: the next try ends where they intersect, or
 * earlier if the first tangent is unknown. */
static bool
passes_peak (QnPathTrace *trace, double step)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  double before = eq->committed.multiplier, after = eq->multiplier;
  double tolerance = trace->path->settings->multiplier_tolerance * fabs (after);
  double size = fabs (step), ahead = copysign (1, step);
  double first = ahead * trace->slope, last = ahead * eq->slope;

  if (!ends_at_peak (trace) || trace->events.below || trace->jumped
      || size <= QN_PATH_SMALLEST_STEP * trace->largest || first < 0 || !(last < 0))
    return false;
  double turn = first > 0 ? (after - before - last * size) / (first - last) : 0;
  if (first > 0 && first * turn - fmax (0, after - before) <= tolerance)
    return false;
  trace->step = ahead * fmin (fmax (turn, QN_PATH_CUT * size), size / 2);
  return true;
}

static void
choose_next_step (QnPathTrace *trace, double step, bool easy)
{
  if (!trace->jumped)
    trace->pace = qn_equilibrium_motion (&trace->path->equilibrium) / fabs (step);
  trace->largest = fmax (trace->largest, fabs (step));
  trace->step = fmax (fabs (easy ? growth (trace) * step : step),
                      QN_PATH_RESTART_STEP * trace->largest);
  trace->step =
    copysign (fmin (trace->step, largest_next_step (trace)), trace->measure.first);
  qn_path_step_aim (trace, step);
  trace->slope = trace->path->equilibrium.slope;
}

/* --- One step ---------------------------------------------------------------------------- */

static void
exchange_highest (QnPathTrace *trace)
{
  QnEquilibriumState before = trace->before;

  trace->before = trace->highest;
  trace->highest = before;
}

/* Accepts the current state. Load control records the equilibria that it meets, which lie above all
 * multipliers before. */
bool
qn_path_trace_accept (QnPathTrace *trace)
{
  QnPath *path = trace->path;
  QnEquilibrium *eq = &path->equilibrium;
  double multiplier = eq->multiplier;
  bool snap = false;

  qn_path_measure_keep_last (&trace->measure);
  trace->last_multiplier = eq->committed.multiplier;
  bool climbs = qn_path_events_climbs (&trace->events);
  if (!qn_path_events_observe (&trace->events, trace->jumped, &snap))
    return false;
  if (trace->load_control && !climbs) {
    qn_equilibrium_commit (eq);
    return true;
  }
  snap = trace->load_control ? snap : trace->jumped;
  if (!qn_path_accept (path, multiplier, snap ? QN_EVENT_SNAP : QN_EVENT_NONE))
    return false;
  if (trace->load_control) {
    exchange_highest (trace);
    qn_equilibrium_save (eq, &trace->highest);
    if (!trace->doubt)
      qn_equilibrium_save (eq, &trace->sure);
    trace->lower.multiplier = INFINITY;
  }
  return true;
}

/* One increment of the multiplier. Where Newton's method does not get through easily, the first is cut until
 * it is short enough, or the work of the live load is prescribed from here on. */
static bool
advance_by_load (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double from = eq->committed.multiplier;
  double target = fmin (from + trace->step, trace->end);
  bool easy;
  QnSolveStatus status = qn_path_step_solve_load (trace, target, &easy);

  if (status == QN_SOLVE_NO_MEMORY || status == QN_SOLVE_CANCELLED)
    return qn_path_end_give_up (trace, status);
  /* A load that a stage takes back, and that works against its change: joints soften on, where no structure
   * stays. Where its work is prescribed they close. */
  bool softens = status == QN_SOLVE_CONVERGED && trace->may_soften
                 && qn_equilibrium_live_work (eq, eq->committed.u) < 0;
  if (!easy || softens) {
    qn_equilibrium_restore (eq);
    if (!softens && from <= 0
        && trace->step > QN_PATH_RESTART_STEP * trace->measure.first) {
      trace->step *= QN_PATH_CUT;
      return true;
    }
    if (!qn_path_measure_take_work (&trace->measure, trace->step))
      return false;
    double work = qn_path_last_advance (trace); /* that of the last increment first */
    trace->step = trace->largest = work != 0 ? fabs (work) : trace->measure.first;
    trace->pace = 0;
    trace->slope = trace->measure.slope;
    return true;
  }
  choose_next_step (trace, target - from, true);
  if (!qn_path_trace_accept (trace))
    return false;
  qn_path_end_check (trace);
  return true;
}

/* Solves the step, *step on entry, and ends it at the end of the path where it passes that.
 * *again: it is to be tried once more, shorter. */
static QnSolveStatus
solve_to_end (QnPathTrace *trace, double *step, bool *easy, bool *again)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  int32_t before = eq->statistics.iterations;
  double share;
  QnSolveStatus status = qn_path_step_solve (trace, step);

  *easy = (!trace->may_jump
           && qn_path_trace_is_linear (trace)) /* one path, however long the steps */
          || qn_path_step_was_easy (trace, eq->statistics.iterations - before);
  *again = false;
  if (status != QN_SOLVE_CONVERGED)
    return status;
  status = qn_path_step_land (trace, &share);
  if (status != QN_SOLVE_FAILED)
    return status;
  *again = fabs (*step) > QN_PATH_SMALLEST_STEP * trace->largest;
  if (*again) {
    trace->step = *step * fmin (share, 1 - QN_PATH_CUT);
    qn_equilibrium_restore (eq);
  }
  return QN_SOLVE_CONVERGED;
}

/* Tells of a branch that has ended with the step just accepted. However short the next step is,
 * the motion in it tells nothing of jumps: it grows as the root of the step. False when memory
 * runs out. */
static bool
leave_branch (QnPathTrace *trace)
{
  if (!trace->ends_branch)
    return true;
  trace->ends_branch = false;
  trace->pace = 0;
  if (trace->path->settings->snap == QN_SNAP_THROUGH_STOP)
    qn_path_end_finish (trace, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
  return qn_path_events_buckle (&trace->events, trace->buckling);
}

/* Whether a step that ended in a fall is too long to determine the multiplier of the fall: it exceeds the
 * smallest step, or its change of the multiplier the tolerance. */
static bool
falls_too_far (const QnPathTrace *trace, double step)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  double part = fabs (step) / trace->largest;
  double exact = trace->path->settings->multiplier_tolerance
                 * fmax (fabs (eq->committed.multiplier), trace->unit);

  return part > QN_PATH_SMALLEST_STEP
         || (fabs (trace->slope * step) > exact
             && part > QN_PATH_SMALLEST_STEP * QN_PATH_SMALLEST_STEP);
}

/* No further step converges: tries to find the collapse directly. */
static bool
give_up (QnPathTrace *trace, QnSolveStatus solve)
{
  if (solve == QN_SOLVE_FAILED && !qn_path_end_direct (trace, true))
    return false;
  return trace->stop != QN_STOP_UNKNOWN || qn_path_end_give_up (trace, solve);
}

/* One step of another measure than the multiplier. */
static bool
advance (QnPathTrace *trace)
{
  QnPath *path = trace->path;
  QnEquilibrium *eq = &path->equilibrium;
  double step = trace->step, share = qn_path_measure_share_to_end (&trace->measure, step);
  bool easy, again, linear = qn_path_trace_is_linear (trace);
  bool stops = path->settings->snap == QN_SNAP_THROUGH_STOP && !trace->load_control;

  if (share < 1 + QN_TOLERANCE_TARGET)
    step *= share;
  QnSolveStatus status = solve_to_end (trace, &step, &easy, &again);
  if (again)
    return true;
  if (status == QN_SOLVE_MECHANISM && falls_too_far (trace, step)) {
    trace->step = QN_PATH_CUT * step;
    qn_equilibrium_restore (eq);
    return true;
  }
  if (status != QN_SOLVE_CONVERGED || (trace->jumped && stops))
    return give_up (trace, status);

  /* The first state may take work from the driven loads on the way to the control target, or, where work or length
   * are prescribed, lead away from that: which way a structure that has yielded goes back is not told by its
   * tangent. */
  if (trace->reverses != NULL) {
    double start = eq->committed.u[trace->measure.unknown];
    double way = (trace->measure.end - start) * (eq->u[trace->measure.unknown] - start);
    *trace->reverses = way * qn_equilibrium_live_work (eq, eq->committed.u) < 0;
    if (*trace->reverses) {
      qn_equilibrium_restore (eq);
      trace->stop = QN_STOP_DISPLACEMENT;
      return true;
    }
    trace->reverses = NULL;
  }
  if (ends_at_peak (trace) && !trace->events.below
      && !qn_equilibrium_update_slope (eq, trace->measure.direction))
    return false;
  if (passes_peak (trace, step)) {
    qn_equilibrium_restore (eq);
    return true;
  }
  if (!qn_path_hold (trace))
    return false;
  if (trace->stop != QN_STOP_UNKNOWN)
    return true;
  bool smooth = trace->means != QN_FOUND_BY_RELAXATION && !trace->jumped
                && (trace->means == QN_FOUND_BY_NEWTON || linear);
  if (trace->orientation == 0)
    trace->orientation = eq->orientation;
  choose_next_step (trace, step, easy);
  if (!linear && !trace->load_control)
    qn_path_predictor_note (&trace->predictor, eq, step,
                            trace->means != QN_FOUND_BY_RELAXATION && !trace->jumped);
  if (!qn_path_trace_accept (trace) || !leave_branch (trace))
    return false;
  if (trace->stop == QN_STOP_UNKNOWN)
    qn_path_end_check (trace);
  if (smooth)
    qn_path_measure_follow (&trace->measure);
  return true;
}

/* --- The whole path --------------------------------------------------------------------- */

/* How the structure moves on at its highest multiplier: as in the last step, where geometry is linear and
 * motion settles as it grows. In large displacements other joints slide and open as it falls, and the
 * first state below is nearest; where there is none, what relaxation has seen fall. */
static void
find_velocity (const QnPathTrace *trace, double *velocity)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  bool first =
    trace->load_control && trace->events.below && !qn_path_trace_is_linear (trace);
  const double *from = first ? trace->highest.u : trace->measure.last_u;
  const double *to = first ? trace->lower.u : eq->committed.u;

  if (trace->stop == QN_STOP_FALL
      && (!trace->events.below || qn_path_trace_is_linear (trace)))
    return;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    velocity[i] = to[i] - from[i];
}

/* Whether the structure moves on from its highest multiplier along this motion. */
static bool
is_proved (QnPathTrace *trace, const double *velocity)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double highest = trace->highest.multiplier;

  qn_equilibrium_set_state (eq, &trace->highest);
  bool moves = qn_moves_on (&eq->assembly, trace->highest.u, highest, highest, velocity,
                            eq->trial, eq->residual);
  qn_equilibrium_set_state (eq, &trace->highest);
  return moves;
}

/* In large displacements other joints slide and open as a structure falls: where the motion known is not
 * proved to begin at the highest multiplier, that to where it has fallen less and less far. `velocity` is
 * eq->motion. */
static void
settle_velocity (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  double *velocity = eq->motion, *known = trace->buckling;
  size_t size = (size_t) eq->assembly.unknown_count * sizeof *velocity;
  bool proved = is_proved (trace, velocity);

  memcpy (known, velocity, size);
  for (int i = trace->fall.first; !proved && i < QN_FALL_STATES; i++) {
    for (int32_t k = 0; k < eq->assembly.unknown_count; k++)
      velocity[k] = trace->fall.u[i][k] - trace->highest.u[k];
    proved = is_proved (trace, velocity);
  }
  if (!proved)
    memcpy (velocity, known, size);
  qn_equilibrium_restore (eq);
}

/* What the path as a whole says of the structure. */
static bool
conclude (QnPathTrace *trace)
{
  QnPath *path = trace->path;
  QnEquilibrium *eq = &path->equilibrium;
  QnResult *result = path->result;
  double *velocity = eq->motion;

  find_velocity (trace, velocity);
  /* A stage that has only taken its loads back, against which they have worked, has no highest multiplier of
   * its own. */
  bool only_back = path->stage > 0 && result->outcome == QN_OUTCOME_TARGET_REACHED
                   && trace->events.highest <= trace->events.least
                   && qn_equilibrium_live_work (eq, trace->events.rest) <= 0;
  bool collapses = result->outcome == QN_OUTCOME_COLLAPSE
                   || (result->outcome != QN_OUTCOME_NOT_CONVERGED
                       && result->outcome != QN_OUTCOME_CANCELLED && trace->events.below
                       && !only_back && !trace->load_control);
  if (collapses && !qn_path_events_collapse (&trace->events))
    return false;
  if (result->outcome == QN_OUTCOME_SNAP)
    qn_result_set_first_limit (result,
                               path->origin + path->scale * trace->events.highest);
  if (!trace->load_control)
    result->stop = trace->stop;
  else {
    qn_equilibrium_set_state (eq, &trace->highest);
    qn_equilibrium_save (eq, &eq->committed);
  }
  if (result->outcome == QN_OUTCOME_SNAP)
    result->steps[result->step_count - 1].event = QN_EVENT_SNAP;
  if (result->outcome == QN_OUTCOME_COLLAPSE)
    result->steps[result->step_count - 1].event = QN_EVENT_COLLAPSE;
  if (!collapses)
    return true;
  result->has_collapse_multiplier = true;
  result->collapse_multiplier = trace->events.highest;
  qn_path_add_solution (path, trace->measure.procedure,
                        path->origin + path->scale * trace->events.highest);
  if (trace->load_control && trace->stop == QN_STOP_FALL)
    settle_velocity (trace);
  if (trace->load_control)
    qn_path_events_take_mechanism (&trace->events, velocity);
  return qn_path_record_mechanism (path, velocity, NULL) == QN_OK;
}

/* Load control, after the path has turned down or no step converges; in linear geometry, where it has ended on a
 * plateau below its peak. Relaxes the structure under a load slightly above the highest multiplier; in linear
 * geometry from the equilibrium before, since a long step may lead beyond a higher peak. If it comes to rest, load
 * control goes on from there; if it falls, that is collapse; if neither is certain, the path is followed to its
 * end. */
static bool
hold_load (QnPathTrace *trace)
{
  QnPath *path = trace->path;
  QnEquilibrium *eq = &path->equilibrium;
  double more = trace->above * path->settings->multiplier_tolerance
                * fmax (trace->events.highest, trace->unit);
  bool linear = qn_path_trace_is_linear (trace);
  double far = QN_PATH_COLLAPSED * eq->assembly.length;
  const QnTarget target =
    qn_target_multiplier (fmin (trace->events.highest + more, trace->end));

  qn_equilibrium_save (eq, &trace->lower);
  qn_equilibrium_set_state (eq, linear ? &trace->before : &trace->highest);
  qn_equilibrium_record (eq);
  QnSolveStatus status = qn_equilibrium_relax (
    eq, trace->central, &target, far, &trace->fall, linear ? QN_TRIED : QN_RELAX_BUDGET);

  if (status == QN_SOLVE_CONVERGED)
    status = qn_path_stay (path, far);
  if (status == QN_SOLVE_CONVERGED && !qn_path_events_climbs (&trace->events))
    status = QN_SOLVE_FAILED;
  if (status == QN_SOLVE_FAILED) {
    qn_equilibrium_set_state (eq, &trace->highest);
    qn_equilibrium_record (eq);
    qn_equilibrium_set_state (eq, &trace->lower);
    qn_equilibrium_commit (eq);
    return true;
  }
  if (status != QN_SOLVE_CONVERGED
      || (path->settings->snap == QN_SNAP_THROUGH_STOP
          && qn_path_events_has_snapped (&trace->events)))
    return qn_path_end_give_up (trace, status);
  trace->moved_on = linear;
  trace->stop = QN_STOP_UNKNOWN;
  trace->means = QN_FOUND_BY_RELAXATION;
  trace->jumped = true;
  trace->above = fmin (2 * trace->above, QN_PATH_MOST_ABOVE);
  if (linear && trace->before.multiplier < trace->highest.multiplier) {
    /* A structure that is loaded slowly does not come to the highest state. */
    qn_result_keep_steps (path->result, path->result->step_count - 1);
    exchange_highest (trace);
  }
  if (!qn_path_trace_accept (trace))
    return false;
  qn_path_measure_keep_last (&trace->measure);
  trace->measure.procedure = QN_PROCEDURE_LOAD;
  trace->step = trace->largest = more;
  trace->pace = 0;
  qn_path_end_check (trace);
  return true;
}

/* One step of the path, by what leads on from where it has come. The load is held once at each highest
 * multiplier, but not by a path that has spent its effort. */
static bool
go_on (QnPathTrace *trace)
{
  bool linear = qn_path_trace_is_linear (trace);
  bool holds =
    trace->load_control
    && (linear ? trace->may_jump && !trace->may_soften && !qn_path_end_is_spent (trace)
               : !trace->events.below);
  bool ok = trace->measure.procedure == QN_PROCEDURE_LOAD ? advance_by_load (trace)
                                                          : advance (trace);
  bool goes_on = trace->stop == QN_STOP_UNKNOWN;
  bool turns = (goes_on && trace->events.below) || trace->stop == QN_STOP_ZERO
               || trace->stop == QN_STOP_FALL || trace->stop == QN_STOP_STEP_TOO_SMALL;

  return ok && holds
             && (linear ? trace->stop == QN_STOP_PLATEAU && trace->events.below : turns)
           ? hold_load (trace)
           : ok;
}

/* A workspace for central paths of the pairs that carry now. False when memory runs out. */
static bool
renew_central_path (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;

  qn_central_path_free (trace->central);
  trace->may_jump = qn_assembly_may_jump (&eq->assembly);
  trace->may_soften = qn_assembly_may_soften (&eq->assembly);
  return qn_central_path_new (eq, trace->load_control, &trace->central);
}

/* The committed state is the highest one of load control. */
static bool
renew_highest (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;

  qn_pool_clear (&trace->states);
  qn_equilibrium_state_init (&trace->highest, &eq->assembly, &trace->states);
  qn_equilibrium_state_init (&trace->before, &eq->assembly, &trace->states);
  qn_equilibrium_state_init (&trace->lower, &eq->assembly, &trace->states);
  qn_equilibrium_state_init (&trace->sure, &eq->assembly, &trace->states);
  qn_equilibrium_state_init (&trace->ahead, &eq->assembly, &trace->states);
  if (trace->states.failed)
    return false;
  qn_equilibrium_save (eq, &trace->sure);
  qn_equilibrium_save (eq, &trace->highest);
  qn_equilibrium_save (eq, &trace->before);
  trace->lower.multiplier = INFINITY;
  return true;
}

/* Contacts follow the blocks before the first step and after each. Load control, which comes back
 * to its highest multiplier, stays with the contacts that it had there while it looks whether the
 * path climbs again. */
static bool
follow_contacts (QnPathTrace *trace)
{
  bool changed;

  if (!trace->path->follows || (trace->load_control && trace->events.below))
    return true;
  if (qn_path_follow_contacts (trace->path, &changed) != QN_OK)
    return false;
  if (!changed)
    return true;
  trace->predictor.count = 0;
  return renew_central_path (trace) && (!trace->load_control || renew_highest (trace));
}

static bool
run (QnPathTrace *trace)
{
  const QnResult *result = trace->path->result;
  bool ok = true;
  size_t known = 0;

  trace->step = trace->measure.first;
  trace->slope = trace->measure.slope;
  trace->largest = fabs (trace->step);
  if (trace->step == 0)
    qn_path_end_finish (trace, QN_OUTCOME_TARGET_REACHED, QN_STOP_DISPLACEMENT);
  for (int step = 0; ok && trace->stop == QN_STOP_UNKNOWN && step < QN_PATH_MOST_STEPS;
       step++) {
    ok = result->step_count == known || follow_contacts (trace);
    known = result->step_count;
    ok = ok && go_on (trace);
    if (ok && trace->stop == QN_STOP_UNKNOWN)
      ok = qn_path_end_direct (trace, false);
    if (ok && trace->stop == QN_STOP_UNKNOWN && qn_path_end_is_spent (trace))
      ok = give_up (trace, QN_SOLVE_FAILED);
  }
  if (ok && trace->stop == QN_STOP_UNKNOWN)
    qn_path_end_finish (trace, QN_OUTCOME_NOT_CONVERGED, QN_STOP_STEPS);
  bool reverses = trace->reverses != NULL && *trace->reverses;
  return ok && (reverses || conclude (trace));
}

/* In linear geometry the multiplier of such a structure grows until it counts as unbounded. */
static QnStatus
see_limits (QnPathTrace *trace, QnDiag *diag)
{
  const QnModel *model = trace->path->model;
  QnBox box = QN_BOX_EMPTY;

  if (qn_path_trace_is_linear (trace) || !trace->load_control
      || trace->end < QN_UNBOUNDED)
    return QN_OK;
  for (size_t b = 0; b < model->block_count; b++)
    qn_box_add_point (&box, model->blocks[b].centroid);
  bool unlimited;
  QnStatus status = qn_check_unlimited (model, trace->path->equilibrium.assembly.contacts,
                                        &unlimited, diag);
  if (unlimited)
    trace->extent = qn_box_diagonal (box);
  return status;
}

QnStatus
qn_path_trace (QnPath *path, bool *reverses, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  double dead = qn_assembly_largest (as, as->dead, NULL);
  double live = qn_assembly_largest (as, as->live, NULL);
  QnPathTrace trace = { .path = path,
                        .above = 1,
                        .extent = INFINITY,
                        .looks = QN_PATH_MOST_LOOKS,
                        .reverses = reverses,
                        .unit = live > 0 ? dead / live : 0,
                        .load_control = path->settings->procedure == QN_PROCEDURE_LOAD,
                        .end = fmin (path->settings->max_multiplier, QN_UNBOUNDED) };
  QnPool *pool = &path->trace_pool;

  if (trace.load_control && live == 0) { /* the single equilibrium that it begins with */
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    return !isfinite (path->settings->max_multiplier)
               || qn_path_accept (path, trace.end, QN_EVENT_NONE)
             ? QN_OK
             : qn_diag_no_memory (diag);
  }
  QnStatus status = see_limits (&trace, diag);
  if (status != QN_OK)
    return status;
  bool ready =
    qn_path_measure_setup (&trace.measure, path) && renew_central_path (&trace);
  trace.buckling =
    qn_pool_alloc (pool, (size_t) as->unknown_count, sizeof *trace.buckling);
  qn_path_predictor_init (&trace.predictor, as, pool);
  qn_fall_init (&trace.fall, as, pool);
  ready = ready && qn_path_events_init (&trace.events, path, trace.unit)
          && (!trace.load_control || renew_highest (&trace));
  if (ready && trace.load_control && trace.central != NULL && dead > 0)
    trace.measure.first = QN_PATH_START * trace.unit;
  status = ready && run (&trace) ? QN_OK : qn_diag_no_memory (diag);
  qn_central_path_free (trace.central);
  qn_limit_solution_clear (&trace.direct);
  qn_pool_clear (&trace.states);
  qn_pool_clear (pool);
  return status;
}
