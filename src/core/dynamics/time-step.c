#include "core/dynamics/time-step.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <string.h>

/* Part of the residual that a factorisation which serves on may leave. */
#define WORTH_KEEPING 0.1

/* Bounds of r in pair-motion.h. */
#define SLENDEREST 0.03
#define WIDEST     3

/* The scheme with a spectral radius, 0 to 1. */
static QnTimeScheme
scheme_of (double rho)
{
  double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
  double both = 1 - alpha_m + alpha_f;

  return (QnTimeScheme){ .alpha_m = alpha_m,
                         .alpha_f = alpha_f,
                         .beta = 0.25 * both * both,
                         .gamma = both - 0.5 };
}

/* Numbers from the forces of one pair to those of the next. */
enum { PAIR_STRIDE = sizeof (QnPairForces) / sizeof (double) };

static void measure (QnStepEquation *equation);
static QnSolveStatus solve_for_step (QnStepEquation *equation);
static void move_in_time (QnStepEquation *equation, double part);

/* --- Setting up -------------------------------------------------------------------------- */

static void
instant_init (QnInstant *instant, const QnAssembly *as, QnPool *pool)
{
  size_t n = (size_t) as->unknown_count, pairs = as->pair_count;

  instant->v = qn_pool_alloc (pool, n, sizeof (double));
  instant->a = qn_pool_alloc (pool, n, sizeof (double));
  instant->dead = qn_pool_alloc (pool, n, sizeof (double));
  instant->residual = qn_pool_alloc (pool, n, sizeof (double));
  instant->elongations = qn_pool_alloc (pool, 2 * pairs, sizeof (double));
  instant->rates = qn_pool_alloc (pool, 2 * pairs, sizeof (double));
  qn_equilibrium_state_init (&instant->at, as, pool);
}

static bool
allocate (QnTimeStep *step)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  size_t n = (size_t) as->unknown_count, entries = (size_t) as->ap[n],
         pairs = as->pair_count;
  QnPool *pool = &step->pool;

  instant_init (&step->start, as, pool);
  instant_init (&step->end, as, pool);
  step->mass = qn_pool_alloc (pool, entries, sizeof (double));
  step->beam_damping = qn_pool_alloc (pool, entries, sizeof (double));
  step->inertia[0] = qn_pool_alloc (pool, n, sizeof (double));
  step->inertia[1] = qn_pool_alloc (pool, n, sizeof (double));
  step->increment = qn_pool_alloc (pool, n, sizeof (double));
  step->branches = qn_pool_alloc (pool, QN_BRANCH * pairs, sizeof (double));
  step->factored = qn_pool_alloc (pool, QN_BRANCH * pairs, sizeof (double));
  step->elasticity = qn_pool_alloc (pool, pairs, sizeof *step->elasticity);
  step->damping = qn_pool_alloc (pool, pairs, sizeof *step->damping);
  step->forces = qn_pool_alloc (pool, pairs, sizeof *step->forces);
  return !pool->failed;
}

/* The stiffness of beams that damping goes with. */
static void
renew_beam_damping (QnTimeStep *step)
{
  QnAssembly *as = &step->equation.eq->assembly;

  if (as->beams.count == 0 || step->settings->joint_damping == 0)
    return;
  memset (step->beam_damping, 0,
          (size_t) as->ap[as->unknown_count] * sizeof *step->beam_damping);
  qn_beam_assembly_add_material_tangent (as, step->beam_damping);
  for (int32_t j = 0; j < as->unknown_count; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++)
      if (as->settles[j] || as->settles[as->ai[k]])
        step->beam_damping[k] = 0;
}

/* What is stored at the last evaluation: N and M times half of the deformation that is not
 * plastic. */
static double
beam_energy (const QnBeamAssembly *beams)
{
  double sum = 0;

  for (size_t b = 0; b < beams->count; b++) {
    const QnBeamResponse *r = &beams->responses[b];
    const double *deformation = beams->beams[b].kinematics.deformation;
    sum += 0.5 * r->force[0]
           * (deformation[0] - beams->beams[b].properties.rest - r->memory.stretch);
    for (int end = 0; end < 2; end++)
      sum += 0.5 * r->force[1 + end] * (deformation[1 + end] - r->memory.plastic[end]);
  }
  return sum;
}

/* Copies what the assembly found at eq->u. */
static void
take_evaluation (const QnTimeStep *step, QnInstant *instant)
{
  const QnAssembly *as = &step->equation.eq->assembly;

  qn_equilibrium_save (step->equation.eq, &instant->at);
  memcpy (instant->dead, as->dead, (size_t) as->unknown_count * sizeof (double));
  memcpy (instant->elongations, as->elongations,
          2 * as->pair_count * sizeof *as->elongations);
  qn_assembly_elongation_rates (as, instant->v, instant->rates);
  qn_assembly_residual (as, 0, instant->residual);
  instant->beam_energy = beam_energy (&as->beams);
}

/* The dashpot of a pair: see pair-motion.h. */
static double
damping_of (const QnTimeStep *step, size_t pair)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  const double *g = as->gradients[pair].factors[0];
  const double factors[QN_FACE_UNKNOWNS] = { g[1], g[2], g[0], g[1], g[2], g[3] };
  const int32_t *unknown =
    as->face_unknowns + QN_FACE_UNKNOWNS * (size_t) as->contacts->pairs[pair].face;
  double moves = 0, turns = 0;

  if (step->settings->of != QN_DAMPING_IMPACT)
    return step->settings->joint_damping;
  for (int i = 0; i < QN_FACE_UNKNOWNS; i++) {
    double mass = unknown[i] != QN_NONE ? step->mass[as->diagonal[unknown[i]]] : 0;
    if (mass > 0)
      *(i % QN_DOF_COUNT == QN_DOF_RZ ? &turns : &moves) +=
        factors[i] * factors[i] / mass;
  }
  double r = moves > 0 ? fmin (fmax (turns / moves, SLENDEREST), WIDEST) : WIDEST;
  double mobility = moves + turns;
  return mobility > 0 ? sqrt (2 * r / (mobility * step->elasticity[pair].k[0])) : 0;
}

/* Arrays that depend on the assembly and not on the state. */
static QnStatus
prepare (QnTimeStep *step, QnDiag *diag)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  QnStatus status = allocate (step) ? QN_OK : qn_diag_no_memory (diag);

  if (status == QN_OK)
    status = qn_assembly_mass (as, step->mass, diag);
  if (status != QN_OK)
    return status;
  qn_assembly_add_inertia (as, qn_vec2 (1, 0), step->inertia[0]);
  qn_assembly_add_inertia (as, qn_vec2 (0, 1), step->inertia[1]);
  for (size_t p = 0; p < as->pair_count; p++) {
    step->elasticity[p] = qn_pair_elasticity (&as->springs[p]);
    step->damping[p] = damping_of (step, p);
  }
  return QN_OK;
}

/* The end of a step becomes the start of the next one. A joint whose bond is broken is dry from then on. */
static void
commit (QnTimeStep *step)
{
  const QnAssembly *as = &step->equation.eq->assembly;

  qn_assembly_commit (&step->equation.eq->assembly);
  for (size_t p = 0; p < as->pair_count; p++)
    if (qn_pair_damage (&as->springs[p], &as->committed[p]) >= 1) {
      const QnPairSprings broken = qn_pair_springs_broken (&as->springs[p]);
      step->elasticity[p] = qn_pair_elasticity (&broken);
    }
}

/* The state at the start, as the workspace has it. */
static void
begin_step (QnTimeStep *step)
{
  QnEquilibrium *eq = step->equation.eq;

  qn_assembly_evaluate (&eq->assembly, eq->u);
  commit (step);
  take_evaluation (step, &step->start);
  renew_beam_damping (step);
}

QnStatus
qn_time_step_setup (QnTimeStep *step, QnEquilibrium *eq, QnDiag *diag)
{
  const QnDynamicSettings *settings = &eq->assembly.model->analysis.dynamic;

  *step = (QnTimeStep){ .equation = { .eq = eq,
                                      .measure = measure,
                                      .solve = solve_for_step,
                                      .move = move_in_time },
                        .scheme = scheme_of (settings->rho),
                        .settings = settings };
  eq->factored = false;
  QnStatus status = prepare (step, diag);
  if (status == QN_OK) {
    const QnAssembly *as = &eq->assembly;
    for (size_t i = 0; i < as->model->initial_count; i++) {
      const QnInitialMotion *motion = &as->model->initial[i];
      for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
        int32_t unknown = as->unknown[QN_DOF_COUNT * motion->block + dof];
        double scale = dof == QN_DOF_RZ ? as->length : 1;
        if (unknown == QN_NONE || as->settles[unknown])
          continue;
        eq->u[unknown] += scale * motion->displacement[dof];
        step->start.v[unknown] += scale * motion->velocity[dof];
      }
    }
    begin_step (step);
  } else
    qn_time_step_clear (step);
  return status;
}

QnStatus
qn_time_step_renew (QnTimeStep *step, QnDiag *diag)
{
  size_t bytes = (size_t) step->equation.eq->assembly.unknown_count * sizeof (double);
  QnTimeStep next = { .equation = step->equation,
                      .scheme = step->scheme,
                      .settings = step->settings };
  QnStatus status = prepare (&next, diag);

  if (status != QN_OK) {
    qn_time_step_clear (&next);
    return status;
  }
  memcpy (next.start.v, step->start.v, bytes);
  memcpy (next.start.a, step->start.a, bytes);
  qn_time_step_clear (step);
  *step = next;
  begin_step (step);
  return QN_OK;
}

void
qn_time_step_clear (QnTimeStep *step)
{
  qn_pool_clear (&step->pool);
  *step = (QnTimeStep){ 0 };
}

/* a = M \ (F - P - a0 M v - M i g), without the dashpots of joints and beams, which the first step
 * takes up. */
QnSolveStatus
qn_time_step_start (QnTimeStep *step, QnVec2 ground)
{
  QnAssembly *as = &step->equation.eq->assembly;
  QnInstant *start = &step->start;

  memcpy (as->ax, step->mass, (size_t) as->ap[as->unknown_count] * sizeof *as->ax);
  step->factored_length = 0;
  for (int32_t i = 0; i < as->unknown_count; i++) {
    start->a[i] = start->residual[i] - step->inertia[0][i] * ground.x
                  - step->inertia[1][i] * ground.y;
    if (as->settles[i]) {
      as->ax[as->diagonal[i]] = 1;
      start->a[i] = 0;
    }
  }
  QnSolveStatus status =
    qn_linsys_factor_and_solve (step->equation.eq->linsys, as->ax, start->a);
  for (int32_t i = 0; status == QN_SOLVE_CONVERGED && i < as->unknown_count; i++)
    start->a[i] -= step->settings->mass_damping * start->v[i];
  return status;
}

/* --- Newton's iteration ------------------------------------------------------------------ */

/* u1, v1 and a1 from the increment. */
static void
move (QnTimeStep *step)
{
  QnEquilibrium *eq = step->equation.eq;
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start;
  QnInstant *end = &step->end;
  double h = step->h;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++) {
    eq->u[i] = start->at.u[i] + step->increment[i];
    end->a[i] = (step->increment[i] - h * start->v[i]) / (s->beta * h * h)
                - (0.5 / s->beta - 1) * start->a[i];
    end->v[i] = start->v[i] + h * ((1 - s->gamma) * start->a[i] + s->gamma * end->a[i]);
  }
}

static void
evaluate_pairs (QnTimeStep *step)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  const QnTimeScheme *s = &step->scheme;
  QnPairStep pair_step = { .alpha_f = s->alpha_f,
                           .rate_gain = s->gamma / (s->beta * step->h),
                           .length = step->h,
                           .of = step->settings->of };

  memcpy (step->end.elongations, as->elongations,
          2 * as->pair_count * sizeof *as->elongations);
  if (step->settings->joint_damping > 0 || pair_step.of == QN_DAMPING_IMPACT)
    qn_assembly_elongation_rates (as, step->end.v, step->end.rates);
  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairInstant start = qn_instant_pair (&step->start, step->start.at.responses, p);
    QnPairInstant end = qn_instant_pair (&step->end, as->responses, p);
    if (as->inactive[p]) {
      step->forces[p] = (QnPairForces){ 0 };
      memset (step->branches + QN_BRANCH * p, 0, QN_BRANCH * sizeof *step->branches);
      continue;
    }
    QnPairResponse held;
    pair_step.damping = isnan (as->breaks[p]) ? step->damping[p] : 0;
    pair_step.held = pair_step.damping > 0 && pair_step.of != QN_DAMPING_INITIAL
                         && qn_pair_holds_damage (&as->springs[p], &as->committed[p],
                                                  &start, &end, &held)
                       ? &held
                       : NULL;
    step->forces[p] = qn_pair_motion (&step->elasticity[p], &pair_step, &start, &end);
    double *branch = step->branches + QN_BRANCH * p;
    memcpy (branch, end.response->tangent, sizeof end.response->tangent);
    branch[QN_BRANCH - 1] = qn_pair_branch (&step->elasticity[p], &start, &end);
  }
}

/* residual = (F - M a - C v - P - M i g)_(1-a) / (1 - af) at the increment; relative: its largest entry
 * over the largest force, INFINITY where it cannot be had. */
static void
measure (QnStepEquation *equation)
{
  QnTimeStep *step = (QnTimeStep *) equation;
  QnEquilibrium *eq = equation->eq;
  QnAssembly *as = &eq->assembly;
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start, *end = &step->end;
  double weight = 1 - s->alpha_f, largest = 0;
  double *r = eq->residual, *mean_motion = eq->live_step, *product = eq->trial;
  double begun = qn_clock_seconds ();

  equation->norm = equation->relative = INFINITY;
  move (step);
  if (!qn_assembly_evaluate (as, eq->u))
    return;
  evaluate_pairs (step);
  double evaluated = qn_clock_seconds ();
  eq->statistics.law_seconds += evaluated - begun;
  double scale = qn_assembly_residual_of (as, 0, step->forces[0].total, PAIR_STRIDE, r);
  bool damps_beams = as->beams.count > 0 && step->settings->joint_damping > 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    double v = weight * end->v[i] + s->alpha_f * start->v[i];
    mean_motion[i] = (1 - s->alpha_m) * end->a[i] + s->alpha_m * start->a[i]
                     + step->settings->mass_damping * v;
  }
  qn_assembly_multiply (as, step->mass, mean_motion, product);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    double drag =
      step->inertia[0][i] * step->ground.x + step->inertia[1][i] * step->ground.y;
    scale = fmax (scale, fmax (fabs (product[i]), fabs (drag)));
    r[i] += (s->alpha_f * start->residual[i] - product[i] - drag) / weight;
  }
  if (damps_beams) {
    for (int32_t i = 0; i < as->unknown_count; i++)
      mean_motion[i] = weight * end->v[i] + s->alpha_f * start->v[i];
    qn_assembly_multiply (as, step->beam_damping, mean_motion, product);
    for (int32_t i = 0; i < as->unknown_count; i++)
      r[i] -= step->settings->joint_damping * product[i] / weight;
  }
  for (int32_t i = 0; i < as->unknown_count; i++)
    largest = as->settles[i] ? largest : qn_worse (largest, fabs (r[i]));
  eq->statistics.assembly_seconds += qn_clock_seconds () - evaluated;
  equation->norm = equation->relative = scale > 0 ? largest / scale : largest;
}

/* Whether the factorisation at hand is of this tangent, but for what elongations and motion have
 * changed since. */
static bool
is_factored (const QnTimeStep *step)
{
  const QnAssembly *as = &step->equation.eq->assembly;

  return step->factored_length == step->h && !step->stale
         && !qn_beam_assembly_has_changed (as)
         && memcmp (step->factored, step->branches,
                    QN_BRANCH * as->pair_count * sizeof *step->branches)
              == 0;
}

/* Whether no joint slides, opens or closes in the factorised tangent. */
static bool
is_still (const QnTimeStep *step)
{
  bool still = true;

  for (size_t p = 0; still && p < step->equation.eq->assembly.pair_count; p++)
    still = qn_pair_branch_is_still ((int) step->factored[QN_BRANCH * (p + 1) - 1]);
  return still;
}

/* step = K \ residual, K = (M (1-am)/(beta h^2) + C (1-af) gamma/(beta h))/(1-af) + dP/du */
static QnSolveStatus
solve_for_step (QnStepEquation *equation)
{
  QnTimeStep *step = (QnTimeStep *) equation;
  QnEquilibrium *eq = equation->eq;
  QnAssembly *as = &eq->assembly;
  const QnTimeScheme *s = &step->scheme;
  double h = step->h, gain = s->gamma / (s->beta * h);
  double begun = qn_clock_seconds ();

  memcpy (eq->step, eq->residual, (size_t) as->unknown_count * sizeof *eq->step);
  step->kept = is_factored (step);
  if (step->kept) {
    qn_equilibrium_solve (eq, eq->step);
    return QN_SOLVE_CONVERGED;
  }
  double mass = (1 - s->alpha_m) / (s->beta * h * h * (1 - s->alpha_f))
                + step->settings->mass_damping * gain;
  qn_assembly_tangent_of (as, 0, 0, step->forces[0].tangent[0], PAIR_STRIDE);
  for (int32_t k = 0; k < as->ap[as->unknown_count]; k++)
    as->ax[k] +=
      mass * step->mass[k] + step->settings->joint_damping * gain * step->beam_damping[k];
  eq->statistics.assembly_seconds += qn_clock_seconds () - begun;
  QnSolveStatus status = qn_equilibrium_factor (eq, eq->step);
  memcpy (step->factored, step->branches,
          QN_BRANCH * as->pair_count * sizeof *step->factored);
  step->factored_length = status == QN_SOLVE_CONVERGED ? h : 0;
  return status;
}

static void
move_in_time (QnStepEquation *equation, double part)
{
  QnTimeStep *step = (QnTimeStep *) equation;

  if (part == 1)
    step->before = equation->relative;
  for (int32_t i = 0; i < equation->eq->assembly.unknown_count; i++)
    step->increment[i] += (part == 1 ? 1 : -part) * equation->eq->step[i];
  measure (equation);
  step->stale = step->kept && equation->relative > WORTH_KEEPING * step->before;
}

/* Where the step begins to iterate: so far on with the speed at its start, which sliding and open joints
 * keep. */
static void
predict (QnTimeStep *step, double part)
{
  for (int32_t i = 0; i < step->equation.eq->assembly.unknown_count; i++)
    step->increment[i] = part * step->h * step->start.v[i];
  measure (&step->equation);
}

QnSolveStatus
qn_time_step_try (QnTimeStep *step, double h, QnVec2 ground)
{
  step->h = h;
  step->ground = ground;
  step->stale = false;
  qn_assembly_hold_bonds (&step->equation.eq->assembly);
  predict (step, 1);
  /* Joints that vibrate faster than the steps would leave their branch for a moment and come back:
   * where they stand still nothing is factorised for that. */
  if (step->factored_length == h && is_still (step) && !is_factored (step)) {
    predict (step, 0);
    if (!is_factored (step))
      predict (step, 1);
  }
  QnSolveStatus status = qn_equilibrium_iterate (&step->equation, QN_NEWTON_BUDGET);
  if (status == QN_SOLVE_CONVERGED)
    take_evaluation (step, &step->end);
  return status;
}

double
qn_time_step_error (const QnTimeStep *step, double h, QnVec2 change)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  double largest = 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    double mass = step->mass[as->diagonal[i]];
    double force = step->end.residual[i] - step->start.residual[i]
                   - step->inertia[0][i] * change.x - step->inertia[1][i] * change.y;
    if (mass > 0)
      largest = qn_worse (largest, fabs (force) / mass);
  }
  return fabs (step->scheme.beta - 1.0 / 6) * h * h * largest;
}

void
qn_time_step_accept (QnTimeStep *step)
{
  QnInstant before = step->start;

  commit (step);
  step->start = step->end;
  step->end = before;
  qn_equilibrium_save (step->equation.eq, &step->start.at);
  if (step->settings->of == QN_DAMPING_CURRENT || step->equation.eq->assembly.nonlinear)
    renew_beam_damping (step);
}
