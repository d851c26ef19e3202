#include "stress/checks.h"

#include "support/pair-sums.h"

#include <math.h>

/* What a pair carries: |t| <= cohesion - friction n and n <= cap, N. Two laws may differ in
 * stiffness, and in strength if one of them is weaker throughout. */
typedef struct Strength {
  double friction, cohesion, cap, dilatancy;
} Strength;

static Strength
pair_strength (const QnModel *model, const QnContacts *contacts, size_t pair)
{
  Strength weaker = { INFINITY, INFINITY, INFINITY, 0 };

  for (int side = 0; side < 2; side++) {
    const QnLaw *law = &model->laws[qn_contacts_pair_law (model, contacts, pair, side)];
    double apex = law->friction > 0 ? law->cohesion / law->friction : INFINITY;
    g_assert_true (law->kind == QN_LAW_COULOMB && law->basis == QN_BASIS_CONTACT);
    weaker.friction = fmin (weaker.friction, law->friction);
    weaker.cohesion = fmin (weaker.cohesion, law->cohesion);
    weaker.cap = fmin (weaker.cap, fmin (law->tension, apex));
    weaker.dilatancy = fmax (weaker.dilatancy, law->dilatancy);
  }
  return weaker;
}

/* The arm that a moment on a block counts with: its size, or half its length where it is thin. */
static double
arm_of (const QnBlock *block)
{
  return fmax (sqrt (block->area), sqrt (3 * block->polar_moment / block->area));
}

/* Largest sum of forces, or of moments over their arm, that is left on a free block, over the
 * largest force that acts on one. */
static double
out_of_balance (const QnModel *model, const QnContacts *contacts, const double *forces,
                double dead_factor, double multiplier)
{
  size_t count = model->block_count * QN_DOF_COUNT;
  g_autofree double *sum = g_new0 (double, count);
  g_autofree double *live = g_new0 (double, count);
  double largest = 0, worst = 0;

  qn_model_set_forces (model, NULL, sum);
  qn_model_live_forces (model, live);
  for (size_t i = 0; i < count; i++) {
    bool counts = i % QN_DOF_COUNT != QN_DOF_RZ
                  && !model->blocks[i / QN_DOF_COUNT].support[i % QN_DOF_COUNT];
    sum[i] *= dead_factor;
    if (counts)
      largest = fmax (largest, fmax (fabs (sum[i]), fabs (multiplier * live[i])));
    sum[i] += multiplier * live[i];
  }
  double pairs = test_add_pair_forces (model, contacts, forces, sum);
  if (largest == 0)
    largest = pairs;
  for (size_t i = 0; i < count; i++) {
    const QnBlock *block = &model->blocks[i / QN_DOF_COUNT];
    double arm = i % QN_DOF_COUNT == QN_DOF_RZ ? arm_of (block) : 1;
    if (!block->support[i % QN_DOF_COUNT])
      worst = fmax (worst, fabs (sum[i]) / arm);
  }
  return largest > 0 ? worst / largest : 0;
}

/* Largest excess over the strength of a pair, over the largest force. A bond of cohesion alone
 * bears as much tension as the law calls rounding. */
static double
excess (const QnModel *model, const QnContacts *contacts, const double *forces)
{
  double worst = 0, largest = 0;

  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength s = pair_strength (model, contacts, p);
    double n = forces[2 * p], t = forces[2 * p + 1];
    largest = fmax (largest, hypot (n, t));
    double apart = n - fmax (s.cap, QN_BOND_ROUNDING * s.cohesion);
    worst = fmax (worst, fmax (fabs (t) + s.friction * n - s.cohesion, apart));
  }
  return largest > 0 ? worst / largest : 0;
}

/* What of a pair's rate its flow rule does not know: all of it inside the strength, what does
 * not slip forwards with the law's opening at the friction line, what does not open at the cap.
 * `slack` is the force that counts as none. */
static double
pair_misfit (const Strength *s, const double *force, QnVec2 rate, double slack)
{
  double n = force[0], t = force[1], side = t < 0 ? -1 : 1;
  bool slips = fabs (t) + s->friction * n >= s->cohesion - slack;
  bool opens = n >= s->cap - slack;
  double forward = side * rate.y, least = s->dilatancy * fabs (rate.y);

  if (opens
      && fabs (t) <= 2 * slack) /* nothing holds it: any shear, but no penetration */
    return fmax (0, least - rate.x);
  if (opens && slips) /* between the directions of the line and of the cap */
    return fmax (fmax (0, -forward), fmax (0, s->dilatancy * forward - rate.x));
  if (opens)
    return hypot (fmin (rate.x, 0), rate.y);
  if (slips && forward >= 0)
    return fabs (rate.x - s->dilatancy * forward);
  return qn_vec2_length (rate);
}

/* Velocity of the fastest block, at its centroid or half its length away. */
static double
fastest_block (const QnModel *model, const double *velocities)
{
  double fastest = 0;

  for (size_t i = 0; i < model->block_count; i++) {
    const double *v = velocities + i * QN_DOF_COUNT;
    fastest = fmax (fastest, hypot (v[QN_DOF_UX], v[QN_DOF_UY]));
    fastest = fmax (fastest, fabs (v[QN_DOF_RZ]) * arm_of (&model->blocks[i]));
  }
  return fastest;
}

/* Power of dead load and multiplied live load on velocities, over what it would be if every load
 * went along with its block. */
static double
relative_power (const QnModel *model, double multiplier, const double *velocities)
{
  size_t count = model->block_count * QN_DOF_COUNT;
  g_autofree double *dead = g_new0 (double, count);
  g_autofree double *live = g_new0 (double, count);
  double power = 0, size = 0;

  qn_model_set_forces (model, NULL, dead);
  qn_model_live_forces (model, live);
  for (size_t i = 0; i < count; i += QN_DOF_COUNT) {
    double speed = hypot (velocities[i], velocities[i + 1]);
    size += speed * hypot (dead[i], dead[i + 1])
            + speed * fabs (multiplier) * hypot (live[i], live[i + 1]);
    for (size_t k = i; k < i + QN_DOF_COUNT; k++)
      power += (dead[k] + multiplier * live[k]) * velocities[k];
  }
  return size > 0 ? power / size : 0;
}

/* Forces of the pairs at collapse, and displacements: a pair without force that has parted may close again;
 * NULL where there was no equilibrium at all. */
static void
check_mechanism (const QnModel *model, const QnContacts *contacts, const double *forces,
                 const double *displacements, double multiplier, const double *velocities,
                 StressCheck *check)
{
  double largest = 0, fastest = fastest_block (model, velocities), worst = 0, deepest = 0;

  for (size_t i = 0; i < 2 * contacts->pair_count && forces != NULL; i++)
    largest = fmax (largest, fabs (forces[i]));
  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength strength = pair_strength (model, contacts, p);
    QnVec2 rate = test_pair_rate (model, contacts, p, velocities);
    bool parted = forces != NULL
                  && hypot (forces[2 * p], forces[2 * p + 1]) <= 1e-5 * largest
                  && test_pair_rate (model, contacts, p, displacements).x > 0;
    if (!parted)
      deepest = fmax (deepest, -rate.x);
    if (forces != NULL)
      worst = fmax (worst, pair_misfit (&strength, forces + 2 * p, rate, 1e-5 * largest));
  }
  check->moves = true;
  check->misfit = forces != NULL ? worst / fastest : NAN;
  check->penetration = fastest > 0 ? deepest / fastest : INFINITY;
  check->power = relative_power (model, multiplier, velocities);
}

static void
forces_at (const QnResult *result, size_t step, double *forces)
{
  for (size_t p = 0; p < result->pair_count; p++) {
    QnPairResult pair = qn_result_pair_at (result, step, p);
    forces[2 * p] = pair.normal_force;
    forces[2 * p + 1] = pair.shear_force;
  }
}

StressCheck
stress_check_result (const QnModel *model, const QnContacts *contacts,
                     const QnResult *result)
{
  /* The solver measures forces by their lengths, here they are measured by their components. */
  double asked = G_SQRT2 * model->analysis.residual_tolerance;
  StressCheck check = { .balanced = fmax (STRESS_BALANCE_TOLERANCE, asked),
                        .misfit = NAN };
  g_autofree double *forces = g_new (double, 2 * contacts->pair_count + 1);

  for (size_t step = 0; step < result->step_count; step++) {
    if (!qn_result_has_forces (result, step))
      continue;
    forces_at (result, step, forces);
    double out =
      out_of_balance (model, contacts, forces, 1, result->steps[step].multiplier);
    check.out_of_balance = fmax (check.out_of_balance, out);
    check.excess = fmax (check.excess, excess (model, contacts, forces));
  }
  check.uncertain = result->mechanism_uncertain;
  check.by_work = result->mechanism_by_work;
  if (result->mechanism != NULL && result->outcome == QN_OUTCOME_COLLAPSE)
    check_mechanism (model, contacts, forces,
                     qn_result_step_displacements (result, result->step_count - 1),
                     result->collapse_multiplier, result->mechanism, &check);
  if (result->mechanism != NULL && result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    check_mechanism (model, contacts, NULL, NULL, 0, result->mechanism, &check);
  return check;
}

guint
stress_check_faults (const StressCheck *check)
{
  guint faults = 0;

  if (!(check->out_of_balance <= check->balanced))
    faults |= STRESS_BALANCE;
  if (!(check->excess <= STRESS_STRENGTH_TOLERANCE))
    faults |= STRESS_STRENGTH;
  if (check->moves && !check->uncertain
      && !((check->by_work || check->penetration <= STRESS_MOTION_TOLERANCE)
           && check->power >= -STRESS_MOTION_TOLERANCE))
    faults |= STRESS_MECHANISM;
  return faults;
}

bool
stress_path_is_consistent (const QnResult *result)
{
  double last = -INFINITY, highest = -INFINITY;
  bool falls = result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  bool collapses = result->outcome == QN_OUTCOME_COLLAPSE;

  for (size_t i = 0; i < result->step_count; i++) {
    last = result->steps[i].multiplier;
    if (!(last >= highest))
      return false;
    highest = fmax (highest, last);
  }
  if (collapses
      && (!result->has_collapse_multiplier || result->collapse_multiplier != last
          || (result->has_first_limit_multiplier
              && result->first_limit_multiplier > highest)))
    return false;
  bool knows = result->outcome != QN_OUTCOME_NOT_CONVERGED
               && result->outcome != QN_OUTCOME_CANCELLED;
  return (!knows || isfinite (last) == !falls)
         && (result->mechanism != NULL) == (falls || collapses)
         && (result->unstable_count > 0) == falls;
}

/* No power of dead and live loads on any admissible velocity can be resisted: the velocities
 * alone prove it. */
static bool
falls_freely (const QnModel *model, const QnContacts *contacts, const double *velocities)
{
  size_t count = model->block_count * QN_DOF_COUNT;
  g_autofree double *dead = g_new0 (double, count);
  double power = 0, fastest = 0, worst = 0, dissipation = 0;

  qn_model_set_forces (model, NULL, dead);
  for (size_t i = 0; i < count; i++)
    power += dead[i] * velocities[i];
  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength s = pair_strength (model, contacts, p);
    QnVec2 rate = test_pair_rate (model, contacts, p, velocities);
    double slip = fabs (rate.y);
    fastest = fmax (fastest, qn_vec2_length (rate));
    worst = fmax (worst, s.friction * slip - rate.x);
    dissipation += isinf (s.cap)
                     ? s.cohesion * slip
                     : s.cap * rate.x + (s.cohesion - s.friction * s.cap) * slip;
  }
  return worst <= 1e-6 * fastest && power > dissipation;
}

/* Growing forces that balance the live load alone within strengths without cohesion. */
static bool
grows_freely (const QnModel *model, const QnContacts *contacts, const double *growth)
{
  double worst = 0, largest = 0;

  for (size_t p = 0; p < contacts->pair_count; p++) {
    Strength s = pair_strength (model, contacts, p);
    double n = growth[2 * p], t = growth[2 * p + 1];
    double cap = isinf (s.cap) ? INFINITY : 0;
    largest = fmax (largest, hypot (n, t));
    worst = fmax (worst, fmax (fabs (t) + s.friction * n, n - cap));
  }
  return worst <= 1e-6 * largest
         && out_of_balance (model, contacts, growth, 0, 1) <= 1e-6;
}

/* Bounds that meet, the lower one carried, the upper one moved. */
static bool
is_bounded (const QnModel *model, const QnContacts *contacts,
            const QnLimitSolution *solution)
{
  double size = 1 + fabs (solution->upper_bound);
  double out =
    out_of_balance (model, contacts, solution->forces, 1, solution->lower_bound);

  return out <= STRESS_BALANCE_TOLERANCE
         && excess (model, contacts, solution->forces) <= STRESS_STRENGTH_TOLERANCE
         && solution->check.kinematic_violation <= 1e-6
         && fabs (solution->upper_bound - solution->lower_bound) <= 1e-6 * size;
}

bool
stress_limit_is_proved (const QnModel *model, const QnContacts *contacts,
                        const QnLimitSolution *solution)
{
  switch (solution->outcome) {
  case QN_OUTCOME_COLLAPSE:
    return is_bounded (model, contacts, solution);
  case QN_OUTCOME_DEAD_LOAD_UNSTABLE:
    return falls_freely (model, contacts, solution->velocities);
  case QN_OUTCOME_UNBOUNDED:
    return grows_freely (model, contacts, solution->forces);
  case QN_OUTCOME_TARGET_REACHED:
  case QN_OUTCOME_SNAP:
  case QN_OUTCOME_CANCELLED:
  case QN_OUTCOME_NOT_CONVERGED:
  case QN_OUTCOME_REST:
  case QN_OUTCOME_COUNT:
    break;
  }
  return false;
}
