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
#include <string.h>

/* By how much r differs from the rate nearest to it that two rows of a strength give together, a sum of both with
 * factors >= 0; what a joint dissipates at that rate. */
static double
flow (const QnStrengthRow *s, const QnStrengthRow *t, const double r[2],
      double *dissipated)
{
  double cross = s->normal * t->shear - s->shear * t->normal, l, m = 0;

  if (fabs (cross) < 1e-12) /* both are one */
    l = (s->normal * r[0] + s->shear * r[1])
        / (s->normal * s->normal + s->shear * s->shear);
  else {
    l = (r[0] * t->shear - r[1] * t->normal) / cross;
    m = fmax ((s->normal * r[1] - s->shear * r[0]) / cross, 0);
  }
  l = fmax (l, 0);
  *dissipated = l * s->limit + m * t->limit;
  return hypot (r[0] - l * s->normal - m * t->normal, r[1] - l * s->shear - m * t->shear);
}

/* Largest f . r of a joint: the least that two rows of its strength give with r (duality of linear programs). *away:
 * how far r turns away from all that they give; within `little` it counts as given. */
static double
dissipation (const QnPairSprings *springs, const double rate[2], double little,
             double *away)
{
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS + 1];
  int count = qn_pair_rigid_strength (springs, rows);
  const double r[2] = { rate[0], fabs (rate[1]) };
  double least = 0;

  rows[count++] = (QnStrengthRow){ .shear = -1 }; /* no shear force against the slip */
  *away = hypot (r[0], r[1]);
  for (int i = 0; i < count; i++)
    for (int j = 0; j <= i; j++) {
      double dissipated, off = flow (&rows[i], &rows[j], r, &dissipated);
      if (fmax (off, *away) <= little ? dissipated < least : off < *away) {
        least = dissipated;
        *away = off;
      }
    }
  return least;
}

/* The kinematic multiplier of the mechanism; NAN where it is none of associative flow. */
static double
kinematic_multiplier (QnCheck *check)
{
  QnAssembly *as = &check->assembly;
  const double none[QN_MAX_LOAD_SETS] = { 0 }, live[QN_MAX_LOAD_SETS] = { 1 };
  double *rates = check->rates, dissipated = 0;

  qn_assembly_set_loads (as, none, live);
  qn_assembly_collect (as, check->result->mechanism, check->velocity);
  qn_assembly_elongation_rates (as, check->velocity, rates);
  double largest = qn_largest (check->velocity, (size_t) as->unknown_count);
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairResult *pair = &check->result->pairs[p];
    double away;
    dissipated +=
      dissipation (&as->springs[p], rates + 2 * p, QN_CHECK_TOLERANCE * largest, &away);
    if (away > QN_CHECK_TOLERANCE * largest)
      return NAN;
    dissipated += away * hypot (pair->normal_force, pair->shear_force);
  }
  /* Largest dissipation of ties. */
  double ties = 0;
  for (size_t i = 0; i < qn_model_tie_count (check->model); i++) {
    double rate = qn_beam_assembly_tie_rate (as, i, check->velocity);
    double strength = qn_tie_strength (qn_model_tie (check->model, i));
    double force = as->beams.responses[check->model->element_count + i].force[0];
    /* What nothing limits does not give: what rounding leaves counts as in joints. */
    ties += fmax (rate, 0) * (isfinite (strength) ? strength : force);
  }
  dissipated += ties;
  size_t n = (size_t) as->unknown_count;
  double unit = qn_dot (as->live, check->velocity, n);
  return unit > 0 ? (dissipated - qn_dot (as->dead, check->velocity, n)) / unit : NAN;
}

static bool
agree (double stated, double found)
{
  return qn_check_agrees (stated, found, QN_CHECK_FORCES * (1 + fabs (found)));
}

/* The solution that a path has met is its collapse, with the displacement of a step of that multiplier. */
static bool
is_met (const QnCheck *check, const QnSolution *solution)
{
  const QnResult *result = check->result;

  for (size_t i = 0; i < result->step_count; i++) {
    double moved = qn_result_motion (result, 0, i);
    if (agree (result->steps[i].multiplier, solution->multiplier)
        && qn_check_agrees (solution->displacement, moved, QN_CHECK_FORCES * moved))
      return agree (solution->multiplier, result->collapse_multiplier);
  }
  return false;
}

static void
tell_interval (QnCheck *check, double stated, double found)
{
  qn_check_tell_model (check, QN_CLAIM_INTERVAL, QN_NONE, stated, found);
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
  int32_t own = 0;

  for (int32_t i = 0; i < result->solution_count; i++) {
    const QnSolution *solution = &result->solutions[i];
    bool rigid = solution->found_by == QN_PROCEDURE_LIMIT; /* has no displacements */
    greatest = fmax (greatest, solution->multiplier);
    if (limit->given == rigid) {
      least = fmin (least, solution->multiplier);
      own++;
    }
    if (rigid ? !isnan (solution->displacement)
                  || !(limit->given
                       || (solution->multiplier < result->collapse_multiplier
                           && solution->multiplier >= 0))
              : !is_met (check, solution))
      tell_interval (check, solution->multiplier, NAN);
  }
  /* Only collapses of limit analysis are several. */
  if (result->solution_count > 0 && own != 1 && !fixed_points)
    tell_interval (check, result->solutions[0].multiplier, NAN);
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
      && !(greatest <= result->associative_bound
                         + QN_CHECK_FORCES * (1 + fabs (result->associative_bound))))
    tell_interval (check, greatest, result->associative_bound);
}

/* Of no mechanism in the result: the linear program is solved again. It has this bound, or without any
 * equilibrium this outcome, but that joints with less dilatancy may stand less. */
static QnStatus
check_associative (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  QnLimitSolution solution;
  QnStatus status =
    qn_limit_associative (check->model, check->contacts, NULL, NULL, &solution, NULL);
  bool solved = status == QN_OK;

  if (status == QN_ERROR_NO_MEMORY)
    return qn_diag_no_memory (diag);
  if (r->step_count == 0) {
    bool may_fall = r->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE
                    && check->model->analysis.flow == QN_FLOW_NON_ASSOCIATIVE;
    if (solved && solution.outcome != r->outcome && !may_fall)
      qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
  } else if (!solved || solution.outcome != QN_OUTCOME_COLLAPSE
             || !agree (r->associative_bound, solution.upper_bound))
    qn_check_tell_model (check, QN_CLAIM_UPPER_BOUND, QN_NONE, r->associative_bound,
                         solved ? solution.upper_bound : NAN);
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

static double
speed_of (const QnCheck *check, size_t block)
{
  const double *v = check->result->mechanism + QN_DOF_COUNT * block;

  return hypot (hypot (v[QN_DOF_UX], v[QN_DOF_UY]),
                v[QN_DOF_RZ] * check->model->characteristic_length);
}

/* Without any equilibrium: the blocks that fall move in the mechanism, the fastest among them, and the dead
 * load does work on it; where relaxation has seen blocks fall at some time, whichever way they move at last. */
static void
check_fall (QnCheck *check)
{
  const QnResult *r = check->result;
  QnAssembly *as = &check->assembly;
  const double none[QN_MAX_LOAD_SETS] = { 0 };
  double fastest = 0, named = 0, slowest = INFINITY;

  if (r->mechanism == NULL)
    return;
  for (size_t b = 0; b < r->block_count; b++)
    fastest = fmax (fastest, speed_of (check, b));
  for (size_t i = 0; i < r->unstable_count; i++) {
    double speed = speed_of (check, (size_t) r->unstable_blocks[i]);
    named = fmax (named, speed);
    slowest = fmin (slowest, speed);
  }
  /* A path takes the larger of shift and turn for the speed. */
  if (!(named >= 0.5 * fastest
        && slowest > QN_UNSTABLE_RIGID * fastest * (1 - QN_CHECK_FORCES)))
    qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
  qn_assembly_set_loads (as, none, none);
  memset (check->u, 0, (size_t) as->unknown_count * sizeof *check->u);
  qn_assembly_collect (as, r->mechanism, check->velocity);
  qn_assembly_update_kinematics (as, check->u);
  double power = qn_dot (as->dead, check->velocity, (size_t) as->unknown_count);
  qn_check_bodies (check);
  if (check->model->analysis.procedure == QN_PROCEDURE_LIMIT && !(power > 0))
    qn_check_tell_model (check, QN_CLAIM_WORK, QN_NONE, power, 0);
}

QnStatus
qn_check_bounds (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  bool none = r->step_count == 0, falls = r->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  bool proved_by_mechanism = r->limit.given && r->limit.flow == QN_FLOW_ASSOCIATIVE;
  bool again = none ? (falls || r->outcome == QN_OUTCOME_UNBOUNDED)
                        && check->model->analysis.procedure == QN_PROCEDURE_LIMIT
                    : r->has_associative_bound && !proved_by_mechanism;

  if (none && falls)
    check_fall (check);
  if (!none && r->limit.given)
    check_limit (check);
  if (!none && r->history.width == 0)
    check_solutions (check);
  return again && check->depth == QN_CHECK_RECOMPUTED ? check_associative (check, diag)
                                                      : QN_OK;
}
