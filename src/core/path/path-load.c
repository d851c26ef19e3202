/* Load control.
 *
 * From the equilibrium under dead load the multiplier grows by increments. Newton tries each
 * one, then the central path takes it as a whole. Where that leads nowhere, collapse is
 * approached by growing motion (path-collapse.c). Where that is lost too, increments go on, and
 * what Newton does not solve is left to relaxation along central paths, which lets the
 * structure move until it rests (the path jumped) or goes on for good: that encloses the
 * collapse multiplier between the last equilibrium and the lowest multiplier without one. The
 * last increment is decided by viscous relaxation where nothing else has.
 *
 * The first limit point is looked for as long as none was found. An increment that was not
 * easy is accepted only if the displacements at its end follow from the tangents at both ends;
 * otherwise it is shortened. What remains of a jump that nothing shortens is a limit point.
 */
#include "core/path/path.h"

#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/path/path-tangents.h"

#include <stdlib.h>
#include <string.h>

/* An increment that Newton solves within so many iterations is easy: nothing happened on the
 * way that deserves a closer look, and the next one may be longer. */
#define EASY   5
#define GROWTH 2.0

/* What an increment is shortened to that deserves a closer look. One that Newton's method was not enough
 * for was dear, and is mostly longer by far than what its tangents explain. */
#define SHORTER      0.5
#define MUCH_SHORTER 0.25

/* Largest increment, as a multiple of the first and as a part of the multiplier reached. */
#define LARGEST_INCREMENT 4.0
#define LARGEST_PART      0.1

/* Part of the displacements reached by which an increment may differ from what the tangents
 * at its ends explain, in multiplier tolerances. */
#define JUMP 10.0

/* Part of the displacements by which even an easy increment may: more has let joints slide along
 * another path than that of the load. */
#define COARSE 0.1

/* The first limit point is located within so many resolutions of the multiplier. */
#define LIMIT_RESOLUTION 10.0

typedef struct {
  QnPath *path;
  double first;     /* first increment */
  double increment; /* to try next */
  double end;       /* largest multiplier asked for */
  double upper;     /* lowest multiplier found to have no equilibrium, or infinity */
  bool certified;   /* relaxation at `upper` ended in a mechanism, not in doubt */
  bool confirmed;   /* viscous relaxation has been tried there */
  bool settled;     /* how the structure moves on above the collapse multiplier */
  double doubted;   /* the multiplier that was tried again because it was not certified */
  double guess;     /* where the motion at `upper` says that collapse is, or NaN */
  double explored;  /* highest multiplier that was solved at all, then looked at closer */
  bool relaxed;     /* Newton's method was not enough in the last attempt */
  bool viscous;     /* nor was the central path */
  bool may_jump; /* friction without associativity, or joints of other laws, allow it */
  bool stuck;    /* Newton's method failed where the path goes on smoothly */
  bool jumped;   /* the next accepted equilibrium lies beyond a jump */
  bool finished;
  double *start;          /* unknowns where the live load begins to act */
  double *mechanism;      /* velocity of the motion at `upper`, where certified */
  QnCentralPath *central; /* NULL where it does not apply */
  double approached_from; /* the last equilibrium where the approach was lost, or NaN */
  QnPathTangents tangents;
} LoadControl;

/* --- Choosing multipliers --------------------------------------------------------------- */

static double
resolution (const LoadControl *control, double multiplier)
{
  return control->path->settings->multiplier_tolerance
         * fmax (multiplier, QN_TOLERANCE_MULTIPLIER_FLOOR * control->first);
}

static bool
looks_for_limit_point (const LoadControl *control)
{
  return !control->path->result->has_first_limit_multiplier;
}

/* Whether the path may jump below collapse, and has not yet. */
static bool
watches_for_jumps (const LoadControl *control)
{
  return control->may_jump && looks_for_limit_point (control);
}

/* Next multiplier to try: by increments until there is an upper bound, then just below or
 * just above where the mechanism says that collapse is, or half way. */
static double
choose_target (const LoadControl *control)
{
  double lower = control->path->equilibrium.committed.multiplier;
  double upper = control->upper;

  if (!isfinite (upper))
    return fmin (lower + control->increment, control->end);

  double margin = 0.5 * resolution (control, upper);
  double target = 0.5 * (lower + upper);
  if (control->guess - margin > lower && control->guess - margin < upper)
    target = control->guess - margin;
  else if (control->guess + margin > lower && control->guess + margin < upper)
    target = control->guess + margin;
  return fmin (target, lower + control->increment);
}

/* Shortens the increment to `part` of what was tried and takes up the last equilibrium again. */
static void
look_closer (LoadControl *control, double target, double part)
{
  QnEquilibrium *eq = &control->path->equilibrium;

  control->explored = fmax (control->explored, target);
  control->increment = part * (target - eq->committed.multiplier);
  qn_equilibrium_restore (eq);
}

/* The last equilibrium is where the path ends. */
static void
end_cancelled (LoadControl *control)
{
  qn_equilibrium_restore (&control->path->equilibrium);
  control->path->result->outcome = QN_OUTCOME_CANCELLED;
  control->finished = true;
}

static void
grow_increment (LoadControl *control, double increment, double reached)
{
  double largest = fmax (LARGEST_INCREMENT * control->first, LARGEST_PART * reached);

  if (!control->path->settings->shortcuts.growing_increments)
    largest = control->first;
  control->increment = fmin (GROWTH * fmax (control->increment, increment), largest);
}

/* --- The first limit point -------------------------------------------------------------- */

static void
set_first_limit (QnResult *result, double multiplier)
{
  result->has_first_limit_multiplier = true;
  result->first_limit_multiplier = multiplier;
}

/* The path jumps at the last accepted equilibrium. */
static void
note_limit_point (LoadControl *control)
{
  QnResult *result = control->path->result;

  set_first_limit (result, control->path->equilibrium.committed.multiplier);
  control->jumped = true;
  if (control->path->settings->snap == QN_SNAP_THROUGH_STOP) {
    result->outcome = QN_OUTCOME_SNAP;
    result->steps[result->step_count - 1].event = QN_EVENT_SNAP;
    control->finished = true;
    qn_equilibrium_restore (&control->path->equilibrium);
  }
}

/* Checks the increment that ends in the current state. Returns whether the state is to be
 * accepted: not if it is looked at closer, nor if the path stops at a limit point. */
static bool
passes_limit_check (LoadControl *control, double target, bool easy)
{
  const QnPathTangents *tangents = &control->tangents;
  double increment = target - control->path->equilibrium.committed.multiplier;
  double part = easy ? COARSE : JUMP * control->path->settings->multiplier_tolerance;

  if (!tangents->start_known
      || (tangents->end_known ? qn_path_tangents_unexplained (tangents, increment) <= part
                              : easy))
    return true;
  if (increment > LIMIT_RESOLUTION * resolution (control, target)) {
    look_closer (control, target, control->relaxed ? MUCH_SHORTER : SHORTER);
    return false;
  }
  if (control->relaxed)
    note_limit_point (control);
  return !control->finished;
}

/* --- One increment ---------------------------------------------------------------------- */

/* Whether failure of Newton's method is enough to look closer: where a limit point is still to
 * be located, and something else than relaxation, which is expensive, has or will have an answer
 * further up. */
static bool
newton_decides (const LoadControl *control, double target)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  double increment = target - eq->committed.multiplier;
  bool seen = target <= control->explored || isfinite (control->upper);

  return watches_for_jumps (control) && control->tangents.start_known && !control->stuck
         && (seen || control->central != NULL)
         && increment > LIMIT_RESOLUTION * resolution (control, target);
}

/* Whether the central path alone is to try: relaxation decides about the last increment. */
static bool
central_decides (const LoadControl *control, double target)
{
  double increment = target - control->path->equilibrium.committed.multiplier;

  return control->central != NULL && increment > resolution (control, target);
}

/* Tries to find an equilibrium at `target`. *cut: it is to be looked at closer. */
static QnSolveStatus
attempt (LoadControl *control, double target, bool *cut)
{
  const QnTarget goal = qn_target_multiplier (target);
  QnEquilibrium *eq = &control->path->equilibrium;
  double increment = target - eq->committed.multiplier;
  QnSolveStatus status = qn_equilibrium_newton (eq, &goal, 0, QN_NEWTON_BUDGET);

  control->relaxed = status == QN_SOLVE_FAILED;
  control->viscous = false;
  *cut = control->relaxed && newton_decides (control, target);
  if (!control->relaxed || *cut)
    return status;
  if (control->central != NULL && isnan (control->approached_from))
    status = qn_central_path_solve (control->central, &goal, QN_CENTRAL_BUDGET);
  else if (control->central != NULL)
    status = qn_central_path_relax (control->central, &goal, INFINITY, QN_CENTRAL_BUDGET);
  if (status != QN_SOLVE_FAILED || central_decides (control, target))
    return status;

  control->viscous = true;
  qn_equilibrium_restore (eq);
  bool hint = increment > 3 * resolution (control, target);
  return qn_equilibrium_relax (eq, &goal, hint ? QN_RELAX_BUDGET_HINT : QN_RELAX_BUDGET);
}

/* No equilibrium found at `target`, which bounds the collapse multiplier from above. The power
 * that a steady motion leaves unbalanced says how much of the load is too much:
 *
 *   guess = target - R . v / F_live . v */
static void
bound_from_above (LoadControl *control, double target, bool certified)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  double unbalanced = 0, live = 0;

  qn_assembly_residual (as, target, eq->residual);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    unbalanced += eq->residual[i] * eq->velocity[i];
    live += as->live[i] * eq->velocity[i];
  }
  control->upper = target;
  control->certified = certified;
  control->confirmed = control->viscous;
  control->settled = control->viscous && certified;
  control->guess =
    control->viscous && live > 0 && control->path->settings->shortcuts.mechanism_estimate
      ? target - unbalanced / live
      : NAN;
  if (certified)
    memcpy (control->mechanism, eq->velocity,
            (size_t) as->unknown_count * sizeof *control->mechanism);
  qn_equilibrium_restore (eq);
}

/* Takes the equilibrium at `target` as the next step, unless a closer look is due. */
static QnStatus
consider (LoadControl *control, double target, int32_t iterations, QnDiag *diag)
{
  QnPath *path = control->path;
  double increment = target - path->equilibrium.committed.multiplier;
  bool easy = !control->relaxed && iterations <= EASY;

  if (watches_for_jumps (control)) {
    if (!qn_path_tangents_take_end (&control->tangents))
      return qn_diag_no_memory (diag);
    if (!passes_limit_check (control, target, easy))
      return QN_OK;
  }
  if (!qn_path_accept (path, target, control->jumped ? QN_EVENT_SNAP : QN_EVENT_NONE))
    return qn_diag_no_memory (diag);

  control->jumped = false;
  control->stuck = control->relaxed && watches_for_jumps (control);
  if (watches_for_jumps (control))
    qn_path_tangents_accept (&control->tangents);
  if (easy || control->stuck || !watches_for_jumps (control))
    grow_increment (control, increment, target);
  if (target >= control->end) {
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    control->finished = true;
  }
  return QN_OK;
}

/* --- Collapse --------------------------------------------------------------------------- */

/* The mechanism often says where collapse is far more exactly than the bracket: one Newton
 * attempt just below that multiplier, by a part of it that rounding cannot blur, gains the
 * digits for next to nothing. */
static QnStatus
polish (LoadControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnEquilibrium *eq = &path->equilibrium;
  const QnTarget target =
    qn_target_multiplier (control->guess * (1 - QN_TOLERANCE_POLISH));

  if (!(target.multiplier > eq->committed.multiplier
        && target.multiplier < control->upper))
    return QN_OK;
  switch (qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET)) {
  case QN_SOLVE_CONVERGED:
    return qn_path_accept (path, target.multiplier, QN_EVENT_NONE)
             ? QN_OK
             : qn_diag_no_memory (diag);
  case QN_SOLVE_NO_MEMORY:
    return qn_diag_no_memory (diag);
  case QN_SOLVE_CANCELLED: /* the collapse is known all the same */
  case QN_SOLVE_FAILED:
  case QN_SOLVE_MECHANISM:
    break;
  }
  qn_equilibrium_restore (eq);
  return QN_OK;
}

/* The last step is collapse, with this velocity. */
static QnStatus
report_collapse (LoadControl *control, const double *velocity, QnDiag *diag)
{
  QnPath *path = control->path;
  QnResult *result = path->result;

  control->finished = true;
  result->outcome = QN_OUTCOME_COLLAPSE;
  result->has_collapse_multiplier = true;
  result->collapse_multiplier = path->equilibrium.committed.multiplier;
  result->steps[result->step_count - 1].event = QN_EVENT_COLLAPSE;
  result->mechanism_uncertain = !control->settled;
  if (looks_for_limit_point (control)) {
    set_first_limit (result, result->collapse_multiplier);
  }
  return qn_path_record_mechanism (path, velocity, diag);
}

static QnStatus
conclude (LoadControl *control, QnDiag *diag)
{
  QnPath *path = control->path;
  QnResult *result = path->result;

  control->finished = true;
  if (!control->certified) {
    result->outcome = QN_OUTCOME_NOT_CONVERGED;
    return QN_OK;
  }
  QnStatus status = polish (control, diag);
  return status == QN_OK ? report_collapse (control, control->mechanism, diag) : status;
}

/* The approach has passed `target`, where the increment that begins at `lower` had no
 * solution: there the path jumps. */
static void
note_jump_in_approach (LoadControl *control, double lower, double target)
{
  QnResult *result = control->path->result;
  size_t step = result->step_count - 1;

  while (result->steps[step - 1].multiplier > target)
    step--;
  set_first_limit (result, fmax (lower, result->steps[step - 1].multiplier));
  result->steps[step].event = QN_EVENT_SNAP;
}

static void
take_approach (LoadControl *control, double lower, double target, bool stops)
{
  double reached = control->path->equilibrium.committed.multiplier;

  if (stops)
    note_limit_point (control);
  else if (watches_for_jumps (control) && reached > target)
    note_jump_in_approach (control, lower, target);
  if (reached >= control->upper)
    control->upper = INFINITY;
}

/* Goes for collapse, `target` having no equilibrium that is found directly. Where that leads
 * nowhere either, a smaller increment may. */
static QnStatus
approach_collapse (LoadControl *control, double target, QnDiag *diag)
{
  QnPath *path = control->path;
  const QnEquilibrium *eq = &path->equilibrium;
  double lower = eq->committed.multiplier;
  bool stops =
    watches_for_jumps (control) && path->settings->snap == QN_SNAP_THROUGH_STOP;
  QnApproach outcome;
  QnStatus status =
    qn_path_approach_collapse (path, control->central, control->start,
                               stops ? target : control->end, &outcome, diag);

  if (status != QN_OK)
    return status;
  take_approach (control, lower, target, stops && outcome == QN_APPROACH_BEYOND);
  switch (outcome) {
  case QN_APPROACH_SETTLED:
    control->settled = true;
    return report_collapse (control, eq->velocity, diag);
  case QN_APPROACH_CANCELLED:
    end_cancelled (control);
    break;
  case QN_APPROACH_BEYOND:
  case QN_APPROACH_LOST:
    control->approached_from = eq->committed.multiplier;
    if (eq->committed.multiplier == lower)
      look_closer (control, target, SHORTER);
    else
      control->increment = resolution (control, eq->committed.multiplier);
    break;
  }
  return QN_OK;
}

/* Viscous relaxation at `upper` from the last equilibrium, which is close to it. */
static QnStatus
relax_at_upper (LoadControl *control, QnDiag *diag)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  const QnTarget goal = qn_target_multiplier (control->upper);
  QnSolveStatus status = qn_equilibrium_relax (eq, &goal, QN_RELAX_BUDGET_CONFIRM);

  control->relaxed = control->viscous = control->confirmed = true;
  switch (status) {
  case QN_SOLVE_MECHANISM:
    bound_from_above (control, control->upper, true);
    break;
  case QN_SOLVE_CONVERGED:
    control->upper = INFINITY;
    control->increment = resolution (control, goal.multiplier);
    return consider (control, goal.multiplier, 0, diag);
  case QN_SOLVE_FAILED:
    qn_equilibrium_restore (eq);
    break;
  case QN_SOLVE_CANCELLED:
    end_cancelled (control);
    break;
  case QN_SOLVE_NO_MEMORY:
    return qn_diag_no_memory (diag);
  }
  return QN_OK;
}

/* The bracket has closed. Where relaxation along central paths closed it, viscous relaxation
 * from here says how the structure moves, if it does. An upper end that was found from far
 * away and without certainty is tried once more from the equilibrium that is now close to it. */
static QnStatus
close_bracket (LoadControl *control, QnDiag *diag)
{
  if (control->certified && !control->confirmed)
    return relax_at_upper (control, diag);
  if (control->certified || control->doubted == control->upper)
    return conclude (control, diag);

  control->doubted = control->upper;
  control->increment = control->upper - control->path->equilibrium.committed.multiplier;
  control->upper = INFINITY;
  control->guess = NAN;
  return QN_OK;
}

/* Whether the approach may find what it did not find before. */
static bool
may_approach (const LoadControl *control)
{
  double lower = control->path->equilibrium.committed.multiplier;

  return control->central != NULL
         && !(lower <= control->approached_from
                         + LIMIT_RESOLUTION * resolution (control, lower));
}

/* Neither Newton's method nor the central path found an equilibrium at `target`. */
static QnStatus
draw_conclusion (LoadControl *control, double target, QnSolveStatus status, QnDiag *diag)
{
  bool decided = control->viscous || status == QN_SOLVE_MECHANISM;

  if (decided)
    bound_from_above (control, target, status == QN_SOLVE_MECHANISM);
  if (may_approach (control))
    return approach_collapse (control, target, diag);
  if (!decided)
    look_closer (control, target, SHORTER);
  return QN_OK;
}

static QnStatus
advance (LoadControl *control, QnDiag *diag)
{
  QnEquilibrium *eq = &control->path->equilibrium;
  double target = choose_target (control);
  int32_t before = eq->statistics.iterations;
  bool cut = false;
  QnSolveStatus status = attempt (control, target, &cut);

  switch (status) {
  case QN_SOLVE_CONVERGED:
    return consider (control, target, eq->statistics.iterations - before, diag);
  case QN_SOLVE_MECHANISM:
  case QN_SOLVE_FAILED:
    if (!cut)
      return draw_conclusion (control, target, status, diag);
    look_closer (control, target, SHORTER);
    return QN_OK;
  case QN_SOLVE_CANCELLED:
    end_cancelled (control);
    return QN_OK;
  case QN_SOLVE_NO_MEMORY:
    break;
  }
  return qn_diag_no_memory (diag);
}

/* --- The whole path --------------------------------------------------------------------- */

static QnStatus
run (LoadControl *control, QnDiag *diag)
{
  const QnEquilibrium *eq = &control->path->equilibrium;
  QnStatus status = QN_OK;

  memcpy (control->start, eq->u,
          (size_t) eq->assembly.unknown_count * sizeof *control->start);
  if (!qn_path_tangents_take_start (&control->tangents))
    return qn_diag_no_memory (diag);
  while (status == QN_OK && !control->finished) {
    double bracket = control->upper - eq->committed.multiplier;
    if (isfinite (bracket) && bracket <= resolution (control, control->upper))
      status = close_bracket (control, diag);
    else
      status = advance (control, diag);
  }
  return status;
}

static bool
has_live_load (const QnAssembly *as)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    if (as->live[i] != 0)
      return true;
  return false;
}

/* Coulomb friction with dilatancy = friction has one multiplier for one motion, and collapse is
 * the only limit point. */
static bool
may_jump (const QnAssembly *as)
{
  if (as->nonlinear || as->beams.count > 0)
    return true;
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairSprings *springs = &as->springs[p];
    if (!qn_pair_springs_are_plastic (springs)
        || springs->a.dilatancy != springs->a.friction)
      return true;
  }
  return false;
}

QnStatus
qn_path_load_control (QnPath *path, QnDiag *diag)
{
  const QnAssembly *as = &path->equilibrium.assembly;
  size_t n = (size_t) as->unknown_count;
  double first = 1.0 / path->settings->increments;
  LoadControl control = { .path = path,
                          .first = first,
                          .increment = first,
                          .end = fmin (path->settings->max_multiplier, QN_UNBOUNDED),
                          .upper = INFINITY,
                          .guess = NAN,
                          .may_jump = may_jump (as),
                          .approached_from = NAN };

  /* Without live load the path is the single equilibrium under dead load. */
  if (!has_live_load (as)) {
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    return QN_OK;
  }
  control.start = qn_alloc (n, sizeof *control.start);
  control.mechanism = qn_alloc (n, sizeof *control.mechanism);
  bool tangents = qn_path_tangents_init (&control.tangents, &path->equilibrium);

  bool central = qn_central_path_applies (as);
  if (central)
    control.central = qn_central_path_new (&path->equilibrium);

  QnStatus status =
    control.start && control.mechanism && tangents && (control.central || !central)
      ? run (&control, diag)
      : qn_diag_no_memory (diag);
  qn_central_path_free (control.central);
  free (control.start);
  free (control.mechanism);
  qn_path_tangents_clear (&control.tangents);
  return status;
}
