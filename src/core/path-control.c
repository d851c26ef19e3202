/* Displacement, work and arc-length control: following the path beyond its peak.
 *
 * Instead of the multiplier, a step prescribes how far a measure of the motion advances; the
 * multiplier follows, up or down. What Newton does not solve is relaxed with the measure
 * held, which carries the structure to the equilibrium that a testing machine would find at
 * this displacement: near by, where the path has a corner that Newton walks round in circles,
 * or far away, where it turns back and the structure jumps. Steps that jump are cut until the
 * jump is located, and the equilibrium beyond it bears the event SNAP.
 */
#include "core/path-measure.h"
#include "core/tolerance.h"

/* A step that converges within so many iterations lets the next one grow. */
#define EASY   6
#define GROWTH 1.5

/* Largest step of displacement control, as a multiple of the first; largest motion in a step
 * of another measure, as a part of the characteristic length (or of a radian). */
#define LARGEST_STEP   4.0
#define LARGEST_MOTION 0.05

/* To what part a step is cut that fails or jumps; down to which part of the largest one so
 * far; and with which part of it the path goes on afterwards. */
#define CUT           0.25
#define SMALLEST_STEP (1.0 / 1024)
#define RESTART_STEP  (1.0 / 64)

/* Smallest step, as a part of the largest, that Newton is worth: relaxation takes a longer one
 * for the same effort. */
#define NEWTON_STEP (1.0 / 16)

/* A step that cannot be ended right at the end of the path is shortened at least to this part. */
#define MOST_OF_STEP 0.9

/* Motion so many times as far as the step before would have it may be a jump; it is one if
 * half of it is left in a step cut to a quarter. */
#define JUMP       3.0
#define JUMP_STAYS 0.5

/* A multiplier that holds still while the motion grows so many times is a plateau: collapse,
 * in linear geometry. */
#define PLATEAU_GROWTH 100.0

/* Most steps of a path that nothing else ends. */
#define MOST_STEPS 100000

typedef struct {
  QnPath *path;
  QnPathMeasure measure;
  double step;    /* to try next */
  double largest; /* step so far */
  double pace;    /* motion per unit of the measure in the last smooth step; 0: unknown */
  int orientation; /* of the path where it began; 0: unknown */
  bool relaxed;    /* the last attempt was one of relaxation */
  bool jumped;     /* and moved on by a jump */
  double peak;     /* largest multiplier so far */
  bool passed_peak;
  double plateau_multiplier, plateau_motion; /* where the present plateau began */
  bool finished;
} PathControl;

/* --- One step --------------------------------------------------------------------------- */

/* Tries the step by Newton or by relaxation. Newton knows no stability: an equilibrium that
 * the structure would leave is no solution. */
static QnSolveStatus
solve (PathControl *control, double step, bool smallest)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  const QnTarget target = { .direction = control->measure.direction, .advance = step };

  if (!control->relaxed) {
    QnSolveStatus status = qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
    bool unstable = eq->orientation * control->orientation < 0;
    return status == QN_SOLVE_CONVERGED && unstable ? QN_SOLVE_FAILED : status;
  }
  return qn_equilibrium_relax (eq, &target,
                               smallest ? QN_RELAX_BUDGET_HELD : QN_RELAX_BUDGET_HINT);
}

/* Tries the step, cut until it is solved without a jump or is the smallest one. Newton comes
 * first, and is cheap, unless relaxation was needed just before: then its first failure is
 * enough. On return *step is the size that was tried last. */
static QnSolveStatus
attempt (PathControl *control, double *step)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  double least_for_newton = NEWTON_STEP * control->largest;
  double before = 0; /* motion in the step before it was cut; 0: unknown */

  if (control->relaxed)
    least_for_newton = INFINITY;
  control->relaxed = false;
  for (;;) {
    bool smallest = fabs (*step) <= SMALLEST_STEP * control->largest;
    QnSolveStatus status = solve (control, *step, smallest);
    double moved = qn_path_measure_motion (eq);
    bool far = control->pace > 0 && moved > JUMP * control->pace * fabs (*step);
    bool solved = status == QN_SOLVE_CONVERGED;

    control->jumped = solved && far && moved > JUMP_STAYS * before;
    if (status == QN_SOLVE_CANCELLED || status == QN_SOLVE_NO_MEMORY
        || (solved && !control->jumped) || (smallest && (solved || control->relaxed)))
      return status;
    before = solved ? moved : 0;
    qn_equilibrium_restore (eq);
    if (control->relaxed || fabs (*step) * CUT >= least_for_newton)
      *step *= CUT;
    else
      control->relaxed = true;
  }
}

/* What part of the step leads to the end of the path: to the controlled displacement, or,
 * without one, to multiplier zero beyond the peak. More than 1 where it does not pass it. */
static double
share_to_end (const PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  const QnPathMeasure *measure = &control->measure;
  double before = eq->committed.multiplier;

  if (measure->procedure == QN_PROCEDURE_DISPLACEMENT)
    return INFINITY;
  if (measure->unknown != QN_NONE) {
    double start = eq->committed.u[measure->unknown];
    return qn_path_measure_is_at_end (measure)
             ? (measure->end - start) / (eq->u[measure->unknown] - start)
             : INFINITY;
  }
  return control->passed_peak && eq->multiplier < 0 ? before / (before - eq->multiplier)
                                                    : INFINITY;
}

/* A step that passes the end of the path is solved once more, to end right there; FAILED
 * where that takes a shorter step. */
static QnSolveStatus
land (PathControl *control)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  const QnPathMeasure *measure = &control->measure;
  QnTarget target = qn_target_multiplier (0);

  if (!(share_to_end (control) < 1))
    return QN_SOLVE_CONVERGED;
  if (measure->unknown != QN_NONE)
    target = (QnTarget){ .direction = measure->unit,
                         .advance = measure->end - eq->committed.u[measure->unknown] };
  qn_equilibrium_save (eq, &eq->anchor);
  QnSolveStatus status = qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
  if (status == QN_SOLVE_FAILED)
    qn_equilibrium_load (eq, &eq->anchor);
  return status;
}

/* Largest step that may come next: displacement control keeps to the increments that were
 * asked for; the other measures have no natural end and grow with the motion, in nonlinear
 * geometry until blocks move or turn by a part of themselves. */
static double
largest_next_step (const PathControl *control)
{
  const QnAssembly *as = &control->path->equilibrium.assembly;

  if (control->measure.procedure == QN_PROCEDURE_DISPLACEMENT)
    return LARGEST_STEP * fabs (control->measure.first);
  if (as->nonlinear && control->pace > 0)
    return LARGEST_MOTION * as->length / control->pace;
  return INFINITY;
}

static void
choose_next_step (PathControl *control, double step, bool easy)
{
  double first = control->measure.first;

  if (!control->jumped)
    control->pace = qn_path_measure_motion (&control->path->equilibrium) / fabs (step);
  control->largest = fmax (control->largest, fabs (step));
  control->step =
    fmax (fabs (easy ? GROWTH * step : step), RESTART_STEP * control->largest);
  control->step = copysign (fmin (control->step, largest_next_step (control)), first);
}

/* --- Where the path ends ---------------------------------------------------------------- */

/* Whether the multiplier has held still while the motion grew PLATEAU_GROWTH times, or the
 * structure has run away. */
static bool
is_plateau (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double tolerance = control->path->settings->multiplier_tolerance, motion = 0;

  if (eq->assembly.nonlinear || control->measure.procedure == QN_PROCEDURE_DISPLACEMENT)
    return false;
  if (qn_assembly_elastic_displacements (&eq->assembly, eq->u, NULL) > QN_RUNAWAY)
    return true;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    motion = fmax (motion, fabs (eq->u[i]));
  if (fabs (eq->multiplier - control->plateau_multiplier)
      > tolerance * fabs (eq->multiplier)) {
    control->plateau_multiplier = eq->multiplier;
    control->plateau_motion = motion;
    return false;
  }
  return motion > PLATEAU_GROWTH * control->plateau_motion;
}

static void
finish (PathControl *control, QnOutcome outcome, QnStop stop)
{
  control->path->result->outcome = outcome;
  control->path->result->stop = stop;
  control->finished = true;
}

static void
note_limit_point (PathControl *control, double multiplier)
{
  QnResult *result = control->path->result;

  if (result->has_first_limit_multiplier)
    return;
  result->has_first_limit_multiplier = true;
  result->first_limit_multiplier = multiplier;
}

/* Notes the first peak of the multiplier. */
static void
watch_peak (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double tolerance = control->path->settings->multiplier_tolerance;

  control->peak = fmax (control->peak, eq->multiplier);
  control->passed_peak = eq->multiplier < (1 - tolerance) * control->peak;
  if (!control->passed_peak)
    return;
  note_limit_point (control, control->peak);
  if (control->path->settings->snap == QN_SNAP_STOP)
    finish (control, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
}

/* Whether the path has arrived where it was meant to go, or has nowhere to go. */
static void
check_end (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;

  if (eq->multiplier >= control->path->settings->max_multiplier)
    finish (control, QN_OUTCOME_TARGET_REACHED, QN_STOP_MULTIPLIER);
  else if (qn_path_measure_is_at_end (&control->measure))
    finish (control, QN_OUTCOME_TARGET_REACHED, QN_STOP_DISPLACEMENT);
  else if (control->measure.unknown == QN_NONE && control->passed_peak
           && eq->multiplier <= 0)
    finish (control, QN_OUTCOME_COLLAPSE, QN_STOP_ZERO);
  else if (is_plateau (control))
    finish (control, QN_OUTCOME_COLLAPSE, QN_STOP_PLATEAU);
}

/* The step was not solved, or jumps where the path is to stop at limit points. */
static void
give_up (PathControl *control, QnSolveStatus status)
{
  QnResult *result = control->path->result;
  QnEquilibrium *eq = &control->path->equilibrium;

  qn_equilibrium_restore (eq);
  switch (status) {
  case QN_SOLVE_CONVERGED:
    note_limit_point (control, eq->multiplier);
    result->steps[result->step_count - 1].event = QN_EVENT_SNAP;
    finish (control, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
    break;
  case QN_SOLVE_MECHANISM:
    finish (control, QN_OUTCOME_COLLAPSE, QN_STOP_FALL);
    break;
  case QN_SOLVE_CANCELLED:
    finish (control, QN_OUTCOME_CANCELLED, QN_STOP_CANCELLED);
    break;
  case QN_SOLVE_FAILED:
  case QN_SOLVE_NO_MEMORY:
    finish (control, QN_OUTCOME_NOT_CONVERGED, QN_STOP_STEP_TOO_SMALL);
    break;
  }
}

/* --- The whole path --------------------------------------------------------------------- */

static QnStatus
advance (PathControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnEquilibrium *eq = &path->equilibrium;
  int32_t before = eq->statistics.iterations;
  double step = control->step,
         share = qn_path_measure_share_to_end (&control->measure, step);

  if (share < 1 + QN_TOLERANCE_TARGET)
    step *= share;
  QnSolveStatus status = attempt (control, &step);
  bool easy = control->relaxed || eq->statistics.iterations - before <= EASY;
  if (status == QN_SOLVE_CONVERGED) {
    status = land (control);
    if (status == QN_SOLVE_FAILED && fabs (step) > SMALLEST_STEP * control->largest) {
      control->step = step * fmin (share_to_end (control), MOST_OF_STEP);
      qn_equilibrium_restore (eq);
      return QN_OK;
    }
    if (status == QN_SOLVE_FAILED)
      status = QN_SOLVE_CONVERGED;
  }
  if (status == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  if (status != QN_SOLVE_CONVERGED
      || (control->jumped && path->settings->snap == QN_SNAP_STOP)) {
    give_up (control, status);
    return QN_OK;
  }

  if (control->orientation == 0)
    control->orientation = eq->orientation;
  choose_next_step (control, step, easy);
  qn_path_measure_keep_last (&control->measure);
  if (!qn_path_accept (path, eq->multiplier,
                       control->jumped ? QN_EVENT_SNAP : QN_EVENT_NONE))
    return qn_diag_no_memory (diag);
  watch_peak (control);
  check_end (control);
  if (!control->relaxed && !control->jumped)
    qn_path_measure_follow (&control->measure);
  return QN_OK;
}

/* What the path as a whole says of the structure. */
static QnStatus
conclude (PathControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnEquilibrium *eq = &path->equilibrium;
  QnResult *result = path->result;

  if (result->outcome == QN_OUTCOME_CANCELLED
      || result->outcome == QN_OUTCOME_NOT_CONVERGED)
    return QN_OK;
  if (result->outcome != QN_OUTCOME_COLLAPSE && !control->passed_peak)
    return QN_OK;

  result->has_collapse_multiplier = true;
  result->collapse_multiplier = control->peak;
  note_limit_point (control, control->peak);
  if (result->outcome == QN_OUTCOME_COLLAPSE)
    result->steps[result->step_count - 1].event = QN_EVENT_COLLAPSE;
  if (result->stop != QN_STOP_FALL)
    for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
      eq->velocity[i] = eq->u[i] - control->measure.last_u[i];
  return qn_path_record_mechanism (path, eq->velocity, diag);
}

static QnStatus
run (PathControl *control, QnDiag *diag)
{
  QnStatus status = QN_OK;

  control->step = control->measure.first;
  control->largest = fabs (control->step);
  if (control->step == 0) {
    finish (control, QN_OUTCOME_TARGET_REACHED, QN_STOP_DISPLACEMENT);
    return QN_OK;
  }
  for (int step = 0; status == QN_OK && !control->finished && step < MOST_STEPS; step++)
    status = advance (control, diag);
  if (status == QN_OK && !control->finished)
    finish (control, QN_OUTCOME_NOT_CONVERGED, QN_STOP_STEPS);
  return status == QN_OK ? conclude (control, diag) : status;
}

QnStatus
qn_path_motion_control (QnPath *path, QnDiag *diag)
{
  PathControl control = { .path = path };
  QnStatus status = qn_path_measure_setup (&control.measure, path, diag);

  if (status != QN_OK)
    return status;
  status = run (&control, diag);
  qn_path_measure_clear (&control.measure);
  return status;
}
