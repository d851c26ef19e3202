/* Displacement, work and arc-length control: following the path beyond its peak.
 *
 * Instead of the multiplier, a step prescribes how far a measure of the motion advances; the
 * multiplier follows, up or down. What Newton does not solve is taken as a whole along the
 * central path, where there are joints for it. What is left is relaxed with the measure held, which
 * carries the structure to the equilibrium that a testing machine would find at this
 * displacement: near by, where the path has a corner that Newton does not get round, or far
 * away, where it turns back and the structure jumps. Relaxation comes last because under
 * damping joints slide that would not otherwise: it rests below the path, and Newton fails from
 * there again. Steps that jump are cut until the jump is located, and the equilibrium beyond it
 * bears the event SNAP.
 */
#include "core/base/tolerance.h"
#include "core/path/path-measure.h"

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

/* Motion beyond eq->runaway is collapse if so many tolerances of the multiplier are left to gain;
 * if nothing can jump it goes on, so many times as far, until a part of one is, as long as rounding
 * leaves a digit. */
#define NEARLY_SETTLED 10.0
#define FURTHER        100.0
#define SETTLED        0.1

/* Most steps of a path that nothing else ends. */
#define MOST_STEPS 100000

typedef struct {
  QnPath *path;
  QnPathMeasure measure;
  double end;     /* largest multiplier */
  double step;    /* to try next */
  double largest; /* step so far */
  double pace;    /* motion per unit of the measure in the last smooth step; 0: unknown */
  int orientation;        /* of the path where it began; 0: unknown */
  QnCentralPath *central; /* NULL where it does not apply */
  bool may_jump;          /* some joint is not associative, or not known to be */
  bool whole;   /* the last attempt took the step as a whole, along the central path */
  bool relaxed; /* or was one of relaxation */
  bool jumped;  /* and moved on by a jump */
  double peak;  /* largest multiplier so far */
  bool has_highest;
  QnEquilibriumState highest; /* with the multiplier `peak`, where the path ends there */
  double last_multiplier;     /* before the last accepted step */
  bool passed_peak;
  bool gone; /* the structure has run away under a multiplier that hardly follows */
  double plateau_multiplier, plateau_motion; /* where the present plateau began */
  bool finished;
} PathControl;

/* --- One step --------------------------------------------------------------------------- */

/* An equilibrium that the structure would leave at once is none. */
static QnSolveStatus
refuse_unstable (const PathControl *control, QnSolveStatus status)
{
  bool unstable = control->path->equilibrium.orientation * control->orientation < 0;

  return status == QN_SOLVE_CONVERGED && unstable ? QN_SOLVE_FAILED : status;
}

/* By Newton, or else along the central path. Stability counts where the branch that is lost
 * leads elsewhere: in linear geometry what the central path finds goes on to the same plateau,
 * and what relaxation would find instead may not. */
static QnSolveStatus
solve_statically (PathControl *control, const QnTarget *target)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  QnSolveStatus status = qn_equilibrium_newton (eq, target, 0, QN_NEWTON_BUDGET);

  status = refuse_unstable (control, status);
  control->whole = status == QN_SOLVE_FAILED && control->central != NULL;
  if (!control->whole)
    return status;
  eq->orientation = control->orientation; /* should Newton find nothing left to do */
  status = qn_central_path_solve (control->central, target, QN_CENTRAL_BUDGET);
  return eq->assembly.nonlinear ? refuse_unstable (control, status) : status;
}

/* Whether the step that was solved went along the path, and not round corners of it that an arc
 * had better not follow. */
static bool
is_smooth (const PathControl *control)
{
  bool linear = !control->path->equilibrium.assembly.nonlinear;

  return !control->relaxed && !control->jumped && (!control->whole || linear);
}

/* Whether the step that was solved lets the next one grow. A whole step does not tell how many
 * joints changed state; in nonlinear geometry the branch depends on them. */
static bool
was_easy (const PathControl *control, int32_t iterations)
{
  bool linear = !control->path->equilibrium.assembly.nonlinear;

  return control->relaxed || (control->whole && linear) || iterations <= EASY;
}

static QnSolveStatus
solve (PathControl *control, double step, bool smallest)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  const QnTarget target = { .direction = control->measure.direction, .advance = step };

  if (!control->relaxed)
    return solve_statically (control, &target);
  return qn_equilibrium_relax (eq, &target,
                               smallest ? QN_RELAX_BUDGET_HELD : QN_RELAX_BUDGET_HINT);
}

/* Tries the step, cut until it is solved without a jump or is the smallest one. Static solutions
 * come first, and are cheap, unless relaxation was needed just before: then their first failure
 * is enough. On return *step is the size that was tried last. */
static QnSolveStatus
attempt (PathControl *control, double *step)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  double least_for_newton = NEWTON_STEP * control->largest;
  double before = 0; /* motion in the step before it was cut; 0: unknown */

  if (control->relaxed)
    least_for_newton = INFINITY;
  control->relaxed = control->whole = false;
  for (;;) {
    bool smallest = fabs (*step) <= SMALLEST_STEP * control->largest;
    QnSolveStatus status = solve (control, *step, smallest);
    double moved = qn_equilibrium_motion (eq);
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

/* What part of the step leads to the end of the path, which is *end then: the largest multiplier,
 * or multiplier zero beyond the peak where there is no controlled displacement; or that
 * displacement where another measure is prescribed. Infinite where the step passes none. */
static double
share_to_end (const PathControl *control, QnTarget *end)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  const QnPathMeasure *measure = &control->measure;
  double before = eq->committed.multiplier, share = INFINITY;

  *end = qn_target_multiplier (eq->multiplier > 0 ? control->end : 0);
  if (eq->multiplier > control->end
      || (measure->unknown == QN_NONE && control->passed_peak && eq->multiplier < 0))
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

/* A step that passes the end of the path is solved once more, to end right there; FAILED
 * where that takes a shorter step, *share of this one. */
static QnSolveStatus
land (PathControl *control, double *share)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  QnTarget end;

  *share = share_to_end (control, &end);
  if (!(*share < 1))
    return QN_SOLVE_CONVERGED;
  qn_equilibrium_save (eq, &eq->anchor);
  QnSolveStatus status = qn_equilibrium_newton (eq, &end, 0, QN_NEWTON_BUDGET);
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
    control->pace = qn_equilibrium_motion (&control->path->equilibrium) / fabs (step);
  control->largest = fmax (control->largest, fabs (step));
  control->step =
    fmax (fabs (easy ? GROWTH * step : step), RESTART_STEP * control->largest);
  control->step = copysign (fmin (control->step, largest_next_step (control)), first);
}

/* --- Where the path ends ---------------------------------------------------------------- */

/* Whether the path may end on a plateau: in linear geometry motion knows no end. */
static bool
may_end_on_plateau (const PathControl *control)
{
  return !control->path->equilibrium.assembly.nonlinear
         && control->measure.procedure != QN_PROCEDURE_DISPLACEMENT;
}

/* What the multiplier has still to gain if it goes like collapse - constant / motion, as a part
 * of itself: near collapse less and less, all of it while the structure is elastic. */
static double
left_to_gain (const PathControl *control, double motion)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double before =
    qn_assembly_elastic_displacements (&eq->assembly, control->measure.last_u, NULL);
  double gain = eq->multiplier / control->last_multiplier - 1;

  return fabs (gain * before / (motion - before));
}

/* Whether the multiplier has held still while the motion grew PLATEAU_GROWTH times, or the
 * structure has run away. */
static bool
is_plateau (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double tolerance = control->path->settings->multiplier_tolerance;
  double motion = qn_assembly_elastic_displacements (&eq->assembly, eq->u, NULL);
  double left = left_to_gain (control, motion);

  if (!may_end_on_plateau (control))
    return false;
  control->gone = motion > eq->runaway && left <= NEARLY_SETTLED * tolerance;
  if (control->gone
      && (control->may_jump || motion > fmin (FURTHER * eq->runaway, QN_FARTHEST)
          || left <= SETTLED * tolerance))
    return true;
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

  if (control->path->ends_at_peak && eq->multiplier >= control->peak) {
    qn_equilibrium_save (eq, &control->highest);
    control->has_highest = true;
  }
  control->peak = fmax (control->peak, eq->multiplier);
  control->passed_peak = eq->multiplier < (1 - tolerance) * control->peak;
  if (!control->passed_peak)
    return;
  note_limit_point (control, control->peak);
  if (control->path->settings->snap == QN_SNAP_THROUGH_STOP)
    finish (control, QN_OUTCOME_SNAP, QN_STOP_LIMIT_POINT);
}

/* Whether the path has arrived where it was meant to go, or has nowhere to go. */
static void
check_end (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;

  if (eq->multiplier >= control->end)
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
    if (control->gone)
      finish (control, QN_OUTCOME_COLLAPSE, QN_STOP_PLATEAU);
    else
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
  bool easy = was_easy (control, eq->statistics.iterations - before);
  if (status == QN_SOLVE_CONVERGED) {
    status = land (control, &share);
    if (status == QN_SOLVE_FAILED && fabs (step) > SMALLEST_STEP * control->largest) {
      control->step = step * fmin (share, MOST_OF_STEP);
      qn_equilibrium_restore (eq);
      return QN_OK;
    }
    if (status == QN_SOLVE_FAILED)
      status = QN_SOLVE_CONVERGED;
  }
  if (status == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  if (status != QN_SOLVE_CONVERGED
      || (control->jumped && path->settings->snap == QN_SNAP_THROUGH_STOP)) {
    give_up (control, status);
    return QN_OK;
  }

  if (control->orientation == 0)
    control->orientation = eq->orientation;
  choose_next_step (control, step, easy);
  qn_path_measure_keep_last (&control->measure);
  control->last_multiplier = eq->committed.multiplier;
  if (path->ends_at_peak && eq->multiplier <= control->peak)
    qn_equilibrium_commit (eq);
  else if (!qn_path_accept (path, eq->multiplier,
                            control->jumped ? QN_EVENT_SNAP : QN_EVENT_NONE))
    return qn_diag_no_memory (diag);
  watch_peak (control);
  check_end (control);
  if (is_smooth (control))
    qn_path_measure_follow (&control->measure);
  return QN_OK;
}

/* Comes back to the highest multiplier. */
static void
go_back_to_peak (PathControl *control)
{
  QnEquilibrium *eq = &control->path->equilibrium;

  if (!control->has_highest)
    return;
  qn_equilibrium_load (eq, &control->highest);
  qn_equilibrium_save (eq, &eq->committed);
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
  if (result->stop != QN_STOP_FALL)
    for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
      eq->velocity[i] = eq->u[i] - control->measure.last_u[i];
  if (path->ends_at_peak)
    go_back_to_peak (control);
  if (result->outcome == QN_OUTCOME_COLLAPSE)
    result->steps[result->step_count - 1].event = QN_EVENT_COLLAPSE;
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
  PathControl control = { .path = path,
                          .end = fmin (path->settings->max_multiplier, QN_UNBOUNDED) };
  bool central = qn_central_path_has_joints (&path->equilibrium.assembly);
  QnStatus status = qn_path_measure_setup (&control.measure, path, diag);

  if (status != QN_OK)
    return status;
  if (central)
    control.central = qn_central_path_new (&path->equilibrium);
  control.may_jump =
    control.central == NULL || qn_central_path_turns_back (control.central);
  bool ready =
    (control.central != NULL || !central)
    && (!path->ends_at_peak
        || qn_equilibrium_state_init (&control.highest, &path->equilibrium.assembly));
  status = ready ? run (&control, diag) : qn_diag_no_memory (diag);
  if (path->ends_at_peak)
    qn_equilibrium_state_clear (&control.highest);
  qn_central_path_free (control.central);
  qn_path_measure_clear (&control.measure);
  return status;
}
