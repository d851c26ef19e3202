/* The bounds of limit analysis.
 *
 *   lower   the multiplier of the forces in the result, whose balance and strength are those of the
 *           last step
 *   upper   of the mechanism: what the joints dissipate at most on its rates, less the power of the
 *           dead load, where the live load has unit power
 *
 * A joint dissipates at most the largest f . r that any force within its strength has on the rate r: at
 * a corner of the strength, or without limit where r turns away from what it can carry.
 */
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/limit/limit.h"

#include <math.h>

/* Bounds agree to this, relative to 1 + multiplier. */
#define AGREE 1e-5

/* A rate turns away from what a joint carries where it does so by more than this part of the largest
 * velocity: rounding of a linear program. */
#define AWAY 1e-6

enum { MOST_SIDES = 4 * QN_STRENGTH_ROWS };

/* A side of a strength: a . f <= b. */
typedef struct {
  double a[2], b;
} Side;

static int
list_sides (const QnPairSprings *springs, Side sides[MOST_SIDES])
{
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  int count = qn_pair_rigid_strength (springs, rows), sides_count = 0;

  for (int i = 0; i < count; i++) {
    sides[sides_count++] = (Side){ { rows[i].normal, rows[i].shear }, rows[i].limit };
    if (rows[i].shear > 0)
      sides[sides_count++] = (Side){ { rows[i].normal, -rows[i].shear }, rows[i].limit };
  }
  return sides_count;
}

static bool
carries (const Side *sides, int count, const double f[2], double little)
{
  for (int i = 0; i < count; i++)
    if (sides[i].a[0] * f[0] + sides[i].a[1] * f[1] > sides[i].b + little)
      return false;
  return true;
}

/* Largest f . r of a joint; *away: how far r turns away from all that it can carry. */
static double
dissipation (const QnPairSprings *springs, const double r[2], double little, double *away)
{
  Side sides[MOST_SIDES];
  int count = list_sides (springs, sides);
  double most = -INFINITY;

  *away = 0;
  for (int i = 0; i < count; i++) {
    /* Along the side for ever: a direction in which nothing limits the force. */
    for (int sign = -1; sign <= 1; sign += 2) {
      double d[2] = { sign * sides[i].a[1], -sign * sides[i].a[0] };
      bool unlimited = true;
      for (int j = 0; j < count && unlimited; j++)
        unlimited = sides[j].a[0] * d[0] + sides[j].a[1] * d[1] <= 1e-12;
      if (unlimited)
        *away = fmax (*away, (d[0] * r[0] + d[1] * r[1]) / hypot (d[0], d[1]));
    }
    for (int j = 0; j < i; j++) {
      double cross = sides[i].a[0] * sides[j].a[1] - sides[i].a[1] * sides[j].a[0];
      if (fabs (cross) < 1e-12)
        continue;
      double f[2] = { (sides[i].b * sides[j].a[1] - sides[j].b * sides[i].a[1]) / cross,
                      (sides[i].a[0] * sides[j].b - sides[j].a[0] * sides[i].b) / cross };
      if (carries (sides, count, f, little))
        most = fmax (most, f[0] * r[0] + f[1] * r[1]);
    }
  }
  return isfinite (most) ? most : 0;
}

static double
power_of (const QnAssembly *as, const double *loads, const double *v)
{
  double power = 0;

  for (int32_t i = 0; i < as->unknown_count; i++)
    power += loads[i] * v[i];
  return power;
}

/* The kinematic multiplier of the mechanism; NAN where it is none of associative flow. */
static double
kinematic_multiplier (QnCheck *check)
{
  QnAssembly *as = &check->assembly;
  const double none[QN_MAX_LOAD_SETS] = { 0 }, live[QN_MAX_LOAD_SETS] = { 1 };
  double *rates = check->forces, dissipated = 0;

  qn_assembly_set_loads (as, none, live);
  qn_check_gather (as, check->result->mechanism, check->velocity);
  qn_assembly_elongation_rates (as, check->velocity, rates);
  double largest = qn_largest (check->velocity, (size_t) as->unknown_count);
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairResult *pair = &check->result->pairs[p];
    double away;
    dissipated += dissipation (&as->springs[p], rates + 2 * p,
                               QN_CHECK_STATE * 1e-6 * check->scale, &away);
    if (away > AWAY * largest)
      return NAN;
    dissipated += away * hypot (pair->normal_force, pair->shear_force);
  }
  dissipated += qn_check_tie_dissipation (check);
  double unit = power_of (as, as->live, check->velocity);
  return unit > 0 ? (dissipated - power_of (as, as->dead, check->velocity)) / unit : NAN;
}

static bool
agree (double stated, double found)
{
  return qn_check_agrees (stated, found, AGREE * (1 + fabs (found)));
}

/* The collapse of a path; NULL where none is told. */
static const QnPathEvent *
find_collapse (const QnResult *result)
{
  size_t last = result->event_count;

  return last > 0 && result->events[last - 1].kind == QN_EVENT_KIND_COLLAPSE
           ? &result->events[last - 1]
           : NULL;
}

/* Whether a path with this procedure may tell a solution as found by another: load control prescribes the
 * work of the live load where the path bends, and alone goes beyond the highest multiplier then. */
static bool
finds_by (const QnCheck *check, QnProcedure found_by)
{
  const QnModel *model = check->model;
  int32_t stage = check->result->stage;
  bool staged = stage > 0 && (size_t) stage <= model->stage_count;
  QnProcedure procedure =
    staged ? model->stages[stage - 1].procedure : model->analysis.procedure;

  const QnPathEvent *collapse = find_collapse (check->result);
  bool beyond = collapse != NULL
                && !agree (collapse->displacement_after, collapse->displacement_before);

  if (procedure == QN_PROCEDURE_LOAD && beyond)
    return found_by == QN_PROCEDURE_WORK;
  return found_by == procedure
         || (procedure == QN_PROCEDURE_LOAD && found_by == QN_PROCEDURE_WORK);
}

/* The solution that a path has met is its collapse, with the displacement of a step of that multiplier. */
static bool
is_met (const QnCheck *check, const QnSolution *solution)
{
  const QnResult *result = check->result;

  if (!finds_by (check, solution->found_by)
      || !agree (solution->multiplier, result->collapse_multiplier))
    return false;
  for (size_t i = 0; i < result->step_count; i++) {
    double moved = qn_result_motion (result, 0, i);
    if (agree (result->steps[i].multiplier, solution->multiplier)
        && qn_check_agrees (solution->displacement, moved, AGREE * moved))
      return true;
  }
  return false;
}

static void
tell_interval (QnCheck *check, double stated, double found)
{
  qn_check_tell_model (check, QN_CLAIM_INTERVAL, QN_NONE, stated, found);
}

/* Rigid blocks have no displacements. */
static bool
suits_limit (const QnSolution *solution)
{
  return solution->found_by == QN_PROCEDURE_LIMIT && isnan (solution->displacement);
}

/* Least and greatest solution are those that the result tells, and nothing exceeds the associative
 * bound. */
static void
check_solutions (QnCheck *check)
{
  const QnResult *result = check->result;
  const QnLimitFigures *limit = &result->limit;
  bool fixed_points = limit->given && limit->flow == QN_FLOW_NON_ASSOCIATIVE;
  double least = INFINITY, greatest = -INFINITY;

  for (int32_t i = 0; i < result->solution_count; i++) {
    const QnSolution *solution = &result->solutions[i];
    least = fmin (least, solution->multiplier);
    greatest = fmax (greatest, solution->multiplier);
    if (limit->given ? !suits_limit (solution) : !is_met (check, solution))
      tell_interval (check, solution->multiplier, NAN);
  }
  /* Only collapses of limit analysis are several. */
  if (result->solution_count > 1 && !fixed_points)
    tell_interval (check, result->solutions[1].multiplier, NAN);
  if (result->solution_count == 0) {
    greatest = least = result->collapse_multiplier;
    if (!result->has_collapse_multiplier)
      return;
  }
  if (!agree (result->collapse_multiplier, least))
    tell_interval (check, result->collapse_multiplier, least);
  if (fixed_points && !agree (limit->lower_bound, least))
    tell_interval (check, limit->lower_bound, least);
  if (fixed_points && !agree (limit->upper_bound, greatest))
    tell_interval (check, limit->upper_bound, greatest);
  if (result->has_associative_bound
      && !(greatest
           <= result->associative_bound + AGREE * (1 + fabs (result->associative_bound))))
    tell_interval (check, greatest, result->associative_bound);
}

/* Of no mechanism in the result: the linear program is solved again. */
static QnStatus
check_associative (QnCheck *check, double stated, QnDiag *diag)
{
  QnLimitSolution solution;
  QnStatus status =
    qn_limit_associative (check->model, check->contacts, NULL, NULL, &solution, NULL);

  if (status == QN_ERROR_NO_MEMORY)
    return qn_diag_no_memory (diag);
  if (status != QN_OK) /* of joints like these there is no bound */
    solution.upper_bound = NAN;
  if (status != QN_OK || solution.outcome != QN_OUTCOME_COLLAPSE
      || !agree (stated, solution.upper_bound))
    qn_check_tell_model (check, QN_CLAIM_UPPER_BOUND, QN_NONE, stated,
                         solution.upper_bound);
  qn_limit_solution_clear (&solution);
  return QN_OK;
}

/* Of limit analysis: the forces in the result carry the lower bound, and with associative flow its
 * mechanism proves the upper one. */
static void
check_limit (QnCheck *check)
{
  const QnResult *result = check->result;
  const QnLimitFigures *limit = &result->limit;
  double carried = result->steps[result->step_count - 1].multiplier;

  if (!agree (limit->lower_bound, carried)
      || !agree (limit->lower_bound, result->collapse_multiplier))
    qn_check_tell_model (check, QN_CLAIM_LOWER_BOUND, QN_NONE, limit->lower_bound,
                         carried);
  if (limit->flow == QN_FLOW_NON_ASSOCIATIVE)
    return;
  double found = result->mechanism != NULL ? kinematic_multiplier (check) : NAN;
  if (!agree (limit->upper_bound, found))
    qn_check_tell_model (check, QN_CLAIM_UPPER_BOUND, QN_NONE, limit->upper_bound, found);
  if (result->has_associative_bound
      && !agree (result->associative_bound, limit->upper_bound))
    tell_interval (check, result->associative_bound, limit->upper_bound);
}

QnStatus
qn_check_bounds (QnCheck *check, QnDiag *diag)
{
  const QnResult *result = check->result;
  bool proved_by_mechanism =
    result->limit.given && result->limit.flow == QN_FLOW_ASSOCIATIVE;

  if (result->step_count == 0)
    return QN_OK;
  if (result->limit.given)
    check_limit (check);
  if (result->history.width == 0)
    check_solutions (check);
  return result->has_associative_bound && !proved_by_mechanism
             && check->depth == QN_CHECK_RECOMPUTED
           ? check_associative (check, result->associative_bound, diag)
           : QN_OK;
}
