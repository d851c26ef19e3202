/* Displacement, work and arc-length control: following the path beyond its peak.
 *
 * Instead of the multiplier, a step prescribes how far a linear measure of the motion
 * advances: one displacement, the work of the live load, or the length along the tangent of
 * the path (Riks 1979, Crisfield 1981, linearised). The multiplier follows, up or down.
 *
 * A step that Newton does not solve is halved; the smallest one is relaxed with the measure
 * held, which carries the structure across snaps at constant measure.
 */
#include "core/path.h"

#include "core/memory.h"
#include "core/tolerance.h"

#include <stdlib.h>
#include <string.h>

/* A step that converges within so many iterations lets the next one grow. */
#define EASY   6
#define GROWTH 1.5

/* Largest step of displacement control, as a multiple of the first; the others have no
 * natural end and grow with the motion. */
#define LARGEST_STEP 4.0

/* How often a step is halved before relaxation takes over. */
#define MOST_HALVINGS 8

/* A multiplier that holds still while the motion grows so many times is a plateau: collapse,
 * in linear geometry. */
#define PLATEAU_GROWTH 100.0

/* Most steps of a path that nothing else ends. */
#define MOST_STEPS 100000

typedef struct {
  QnPath *path;
  QnProcedure procedure;
  double *direction;  /* of the measure */
  double first, step; /* of the measure */
  double end;         /* of the controlled displacement, scaled; NaN without one */
  double start; /* where its way there is counted from: 0, or where a stage begins */
  double peak;  /* largest multiplier so far */
  bool passed_peak;
  double plateau_multiplier, plateau_motion; /* where the present plateau began */
  double
    *last_u; /* before the last step: gives the sense along the path, and the mechanism */
  bool finished;
} PathControl;

/* --- The measure ------------------------------------------------------------------------ */

static int32_t
controlled_unknown (const QnPath *path)
{
  size_t body = qn_model_controlled_body (path->model, path->settings->control_block,
                                          path->settings->control_node);

  if (body == SIZE_MAX)
    return QN_NONE;
  return path->equilibrium.assembly
    .unknown[QN_DOF_COUNT * body + (size_t) path->settings->control_dof];
}

static double
norm (const double *v, int32_t n)
{
  double sum = 0;

  for (int32_t i = 0; i < n; i++)
    sum += v[i] * v[i];
  return sqrt (sum);
}

static double
dot (const double *a, const double *b, int32_t n)
{
  double sum = 0;

  for (int32_t i = 0; i < n; i++)
    sum += a[i] * b[i];
  return sum;
}

/* direction = K \ F_live, of unit length, in the sense in which the path last moved. A singular
 * tangent leaves the direction as it was. */
static QnSolveStatus
update_arc_direction (PathControl *control, double *rate_length)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  int32_t n = eq->assembly.unknown_count;
  double *rate = eq->trial, along = 0;

  memcpy (rate, eq->assembly.live, (size_t) n * sizeof *rate);
  QnSolveStatus status = qn_equilibrium_apply_tangent_inverse (eq, rate);
  if (status != QN_SOLVE_CONVERGED)
    return status;
  *rate_length = norm (rate, n);
  for (int32_t i = 0; i < n; i++)
    along += rate[i] * (eq->u[i] - control->last_u[i]);
  /* At the start, what moved so far is due to the dead load and says nothing. */
  double sense = along < 0 && eq->multiplier != 0 ? -1 : 1;
  for (int32_t i = 0; i < n; i++)
    control->direction[i] = sense * rate[i] / *rate_length;
  return QN_SOLVE_CONVERGED;
}

/* Chooses the direction of the measure and the first step. */
static QnStatus
choose_measure (PathControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnEquilibrium *eq = &path->equilibrium;
  const QnAnalysisSettings *settings = path->settings;
  int32_t n = eq->assembly.unknown_count, unknown = controlled_unknown (path);
  double rate_length = 0;

  if (unknown != QN_NONE)
    control->end = settings->control_target
                   * (settings->control_dof == QN_DOF_RZ ? eq->assembly.length : 1);
  if (unknown != QN_NONE && path->stage > 0)
    control->start = eq->committed.u[unknown];
  if (control->procedure == QN_PROCEDURE_DISPLACEMENT) {
    control->direction[unknown] = 1;
    control->first = (control->end - control->start) / settings->increments;
    return QN_OK;
  }

  QnSolveStatus status = update_arc_direction (control, &rate_length);
  if (status == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  control->first = rate_length / settings->increments;
  if (control->procedure == QN_PROCEDURE_WORK) {
    double along = dot (control->direction, eq->assembly.live_at_rest, n);
    memcpy (control->direction, eq->assembly.live_at_rest, (size_t) n * sizeof (double));
    control->first *= fabs (along);
  }
  return QN_OK;
}

/* What is left of the way to the controlled displacement, as a share of this step; 1 or more
 * if the step does not reach it. */
static double
share_to_end (const PathControl *control, double step)
{
  const QnEquilibrium *eq = &control->path->equilibrium;

  if (control->procedure != QN_PROCEDURE_DISPLACEMENT)
    return INFINITY;
  return (control->end - eq->committed.u[controlled_unknown (control->path)]) / step;
}

/* --- One step --------------------------------------------------------------------------- */

/* Tries the step, halved until Newton solves it, and at the smallest size relaxed. On return
 * *step is the size that was tried last. */
static QnSolveStatus
attempt (PathControl *control, double *step)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  QnTarget target = { .direction = control->direction };
  QnSolveStatus status = QN_SOLVE_FAILED;

  for (int halving = 0; halving <= MOST_HALVINGS; halving++, *step /= 2) {
    target.advance = *step;
    status = qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
    if (status != QN_SOLVE_FAILED)
      return status;
    qn_equilibrium_restore (eq);
  }
  *step *= 2;
  return qn_equilibrium_relax (eq, &target, QN_RELAX_BUDGET);
}

static double
motion (const QnEquilibrium *eq)
{
  return norm (eq->u, eq->assembly.unknown_count);
}

/* Whether the multiplier has held still while the motion grew PLATEAU_GROWTH times. */
static bool
is_plateau (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double tolerance = control->path->settings->multiplier_tolerance;

  if (eq->assembly.nonlinear)
    return false;
  if (fabs (eq->multiplier - control->plateau_multiplier)
      > tolerance * fabs (eq->multiplier)) {
    control->plateau_multiplier = eq->multiplier;
    control->plateau_motion = motion (eq);
    return false;
  }
  return motion (eq) > PLATEAU_GROWTH * control->plateau_motion;
}

/* Notes the first peak of the multiplier. */
static void
watch_peak (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  QnResult *result = control->path->result;
  double tolerance = control->path->settings->multiplier_tolerance;

  control->peak = fmax (control->peak, eq->multiplier);
  control->passed_peak = eq->multiplier < (1 - tolerance) * control->peak;
  if (control->passed_peak && !result->has_first_limit_multiplier) {
    result->has_first_limit_multiplier = true;
    result->first_limit_multiplier = control->peak;
    if (control->path->settings->snap == QN_SNAP_STOP) {
      result->outcome = QN_OUTCOME_SNAP;
      control->finished = true;
    }
  }
}

/* Whether the path has arrived where it was meant to go, or has nowhere to go. */
static void
check_end (PathControl *control)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  const QnAnalysisSettings *settings = control->path->settings;
  QnResult *result = control->path->result;
  int32_t unknown = controlled_unknown (control->path);

  bool arrived = eq->multiplier >= settings->max_multiplier;
  if (unknown != QN_NONE)
    arrived |= (eq->u[unknown] - control->start) / (control->end - control->start)
               >= 1 - QN_TOLERANCE_TARGET;
  bool collapsed = unknown == QN_NONE && control->passed_peak && eq->multiplier <= 0;
  collapsed |= control->procedure != QN_PROCEDURE_DISPLACEMENT && is_plateau (control);

  if (arrived)
    result->outcome = QN_OUTCOME_TARGET_REACHED;
  else if (collapsed)
    result->outcome = QN_OUTCOME_COLLAPSE;
  control->finished |= arrived || collapsed;
}

static QnStatus
advance (PathControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnEquilibrium *eq = &path->equilibrium;
  int32_t before = eq->statistics.iterations;
  double step = control->step, rate_length, share = share_to_end (control, step);

  if (share < 1 + QN_TOLERANCE_TARGET)
    step *= share;
  QnSolveStatus status = attempt (control, &step);
  if (status == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  if (status != QN_SOLVE_CONVERGED) {
    qn_equilibrium_restore (eq);
    path->result->outcome =
      status == QN_SOLVE_CANCELLED ? QN_OUTCOME_CANCELLED : QN_OUTCOME_NOT_CONVERGED;
    control->finished = true;
    return QN_OK;
  }

  memcpy (control->last_u, eq->committed.u,
          (size_t) eq->assembly.unknown_count * sizeof *control->last_u);
  if (!qn_path_accept (path, eq->multiplier, QN_EVENT_NONE))
    return qn_diag_no_memory (diag);
  watch_peak (control);
  check_end (control);

  bool easy = eq->statistics.iterations - before <= EASY;
  control->step = easy ? GROWTH * step : step;
  if (control->procedure == QN_PROCEDURE_DISPLACEMENT
      && fabs (control->step) > LARGEST_STEP * fabs (control->first))
    control->step = LARGEST_STEP * control->first;
  if (control->procedure == QN_PROCEDURE_ARC_LENGTH
      && update_arc_direction (control, &rate_length) == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  return QN_OK;
}

/* --- The whole path --------------------------------------------------------------------- */

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
  if (!result->has_first_limit_multiplier) {
    result->has_first_limit_multiplier = true;
    result->first_limit_multiplier = control->peak;
  }
  if (result->outcome == QN_OUTCOME_COLLAPSE)
    result->steps[result->step_count - 1].event = QN_EVENT_COLLAPSE;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    eq->velocity[i] = eq->u[i] - control->last_u[i];
  return qn_path_record_mechanism (path, eq->velocity, diag);
}

static QnStatus
run (PathControl *control, QnDiag *diag)
{
  QnStatus status = choose_measure (control, diag);

  control->step = control->first;
  if (control->first == 0) {
    control->path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    return status;
  }
  for (int step = 0; status == QN_OK && !control->finished && step < MOST_STEPS; step++)
    status = advance (control, diag);
  return status == QN_OK ? conclude (control, diag) : status;
}

QnStatus
qn_path_motion_control (QnPath *path, QnDiag *diag)
{
  size_t n = (size_t) path->equilibrium.assembly.unknown_count;
  PathControl control = { .path = path,
                          .procedure = path->settings->procedure,
                          .end = NAN,
                          .direction = qn_alloc (n, sizeof (double)),
                          .last_u = qn_alloc (n, sizeof (double)) };

  QnStatus status =
    control.direction && control.last_u ? run (&control, diag) : qn_diag_no_memory (diag);
  free (control.direction);
  free (control.last_u);
  return status;
}
