#include "core/dynamics/time-step.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <stdlib.h>
#include <string.h>

/* Newton iterations of a step; a handful is usual, one more for each change of state. */
#define BUDGET 30

/* From this iteration on a step that makes the residual grow is shortened: before, joints cross
 * from state to state, which costs balance before it gains. */
#define PATIENCE 6

/* Halvings of such a step. */
#define HALVINGS 3

/* A factorisation serves as long as it takes away nine tenths of the residual, or more. */
#define WORTH_KEEPING 0.1

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

/* --- Setting up -------------------------------------------------------------------------- */

static bool
instant_init (QnInstant *instant, const QnAssembly *as)
{
  size_t n = (size_t) as->unknown_count, pairs = as->pair_count;

  instant->u = qn_alloc (n, sizeof (double));
  instant->v = qn_alloc (n, sizeof (double));
  instant->a = qn_alloc (n, sizeof (double));
  instant->dead = qn_alloc (n, sizeof (double));
  instant->residual = qn_alloc (n, sizeof (double));
  instant->elongations = qn_alloc (2 * pairs, sizeof (double));
  instant->rates = qn_alloc (2 * pairs, sizeof (double));
  instant->responses = qn_alloc (pairs, sizeof *instant->responses);
  return qn_beam_state_init (&instant->beams, &as->beams) && instant->u && instant->v
         && instant->a && instant->dead && instant->residual && instant->elongations
         && instant->rates && instant->responses;
}

static void
instant_clear (QnInstant *instant)
{
  free (instant->u);
  free (instant->v);
  free (instant->a);
  free (instant->dead);
  free (instant->residual);
  free (instant->elongations);
  free (instant->rates);
  free (instant->responses);
  qn_beam_state_clear (&instant->beams);
}

static bool
allocate (QnTimeStep *step)
{
  const QnAssembly *as = step->assembly;
  size_t n = (size_t) as->unknown_count, entries = (size_t) as->ap[n],
         pairs = as->pair_count;
  const struct {
    double **vector;
    size_t count;
  } vectors[] = {
    { &step->mass, entries },
    { &step->beam_damping, entries },
    { &step->inertia[0], n },
    { &step->inertia[1], n },
    { &step->residual, n },
    { &step->step, n },
    { &step->increment, n },
    { &step->mean_motion, n },
    { &step->product, n },
    { &step->tangents, 4 * pairs },
    { &step->sums, 2 * pairs },
    { &step->branches, QN_BRANCH * pairs },
    { &step->factored, QN_BRANCH * pairs },
  };
  bool ok = instant_init (&step->start, as) && instant_init (&step->end, as);

  for (size_t i = 0; i < QN_N_ELEMENTS (vectors); i++) {
    *vectors[i].vector = qn_alloc (vectors[i].count, sizeof (double));
    ok &= *vectors[i].vector != NULL;
  }
  step->elasticity = qn_alloc (pairs, sizeof *step->elasticity);
  step->forces = qn_alloc (pairs, sizeof *step->forces);
  return ok && step->elasticity != NULL && step->forces != NULL;
}

/* The stiffness of beams that damping goes with. */
static void
renew_beam_damping (QnTimeStep *step)
{
  QnAssembly *as = step->assembly;

  if (as->beams.count == 0 || step->settings->joint_damping == 0)
    return;
  memset (step->beam_damping, 0,
          (size_t) as->ap[as->unknown_count] * sizeof *step->beam_damping);
  qn_beam_assembly_add_material_tangent (&as->beams, step->beam_damping);
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
    sum += 0.5 * r->force[0] * deformation[0];
    for (int end = 0; end < 2; end++)
      sum += 0.5 * r->force[1 + end] * (deformation[1 + end] - r->memory.plastic[end]);
  }
  return sum;
}

/* Copies what the assembly found at instant->u. */
static void
take_evaluation (const QnTimeStep *step, QnInstant *instant)
{
  QnAssembly *as = step->assembly;
  size_t bytes = (size_t) as->unknown_count * sizeof (double);

  memcpy (instant->dead, as->dead, bytes);
  memcpy (instant->elongations, as->elongations,
          2 * as->pair_count * sizeof *as->elongations);
  memcpy (instant->responses, as->responses, as->pair_count * sizeof *as->responses);
  qn_assembly_elongation_rates (as, instant->v, instant->rates);
  qn_assembly_residual (as, 0, instant->residual);
  qn_beam_state_save (&instant->beams, &as->beams);
  instant->beam_energy = beam_energy (&as->beams);
}

static void
add_initial_motion (QnTimeStep *step)
{
  const QnAssembly *as = step->assembly;

  for (size_t i = 0; i < as->model->initial_count; i++) {
    const QnInitialMotion *motion = &as->model->initial[i];
    for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
      int32_t unknown = as->unknown[QN_DOF_COUNT * motion->block + dof];
      double scale = dof == QN_DOF_RZ ? as->length : 1;
      if (unknown == QN_NONE || as->settles[unknown])
        continue;
      step->start.u[unknown] += scale * motion->displacement[dof];
      step->start.v[unknown] += scale * motion->velocity[dof];
    }
  }
}

/* What depends on the assembly and not on the state. */
static QnStatus
prepare (QnTimeStep *step, QnDiag *diag)
{
  const QnAssembly *as = step->assembly;
  QnStatus status = allocate (step) ? QN_OK : qn_diag_no_memory (diag);

  if (status == QN_OK)
    status = qn_assembly_mass (as, step->mass, diag);
  if (status != QN_OK)
    return status;
  qn_assembly_add_inertia (as, qn_vec2 (1, 0), step->inertia[0]);
  qn_assembly_add_inertia (as, qn_vec2 (0, 1), step->inertia[1]);
  for (size_t p = 0; p < as->pair_count; p++)
    step->elasticity[p] = qn_pair_elasticity (&as->springs[p]);
  return QN_OK;
}

/* The end of a step becomes the start of the next one. A joint whose bond is broken is dry from then on. */
static void
commit (QnTimeStep *step)
{
  const QnAssembly *as = step->assembly;

  qn_assembly_commit (step->assembly);
  for (size_t p = 0; p < as->pair_count; p++)
    if (qn_pair_damage (&as->springs[p], &as->committed[p]) >= 1) {
      const QnPairSprings broken = qn_pair_springs_broken (&as->springs[p]);
      step->elasticity[p] = qn_pair_elasticity (&broken);
    }
}

QnStatus
qn_time_step_setup (QnTimeStep *step, QnAssembly *as, QnLinsys *linsys, const double *u0,
                    QnDiag *diag)
{
  const QnModel *model = as->model;

  *step = (QnTimeStep){ .assembly = as,
                        .linsys = linsys,
                        .scheme = scheme_of (model->analysis.dynamic.rho),
                        .settings = &model->analysis.dynamic,
                        .tolerance = model->analysis.residual_tolerance };
  QnStatus status = prepare (step, diag);
  if (status != QN_OK) {
    qn_time_step_clear (step);
    return status;
  }

  memcpy (step->start.u, u0, (size_t) as->unknown_count * sizeof *u0);
  add_initial_motion (step);
  qn_assembly_evaluate (as, step->start.u);
  commit (step);
  take_evaluation (step, &step->start);
  renew_beam_damping (step);
  return QN_OK;
}

void
qn_time_step_renew (QnTimeStep *step)
{
  qn_assembly_evaluate (step->assembly, step->start.u);
  commit (step);
  take_evaluation (step, &step->start);
  renew_beam_damping (step);
  step->factored_length = 0;
}

QnStatus
qn_time_step_move (QnTimeStep *step, QnAssembly *as, QnLinsys *linsys, QnDiag *diag)
{
  size_t bytes = (size_t) as->unknown_count * sizeof (double);
  QnTimeStep next = { .assembly = as,
                      .linsys = linsys,
                      .scheme = step->scheme,
                      .settings = step->settings,
                      .tolerance = step->tolerance,
                      .relative = step->relative,
                      .statistics = step->statistics,
                      .progress = step->progress,
                      .report = step->report,
                      .report_data = step->report_data };
  QnStatus status = prepare (&next, diag);

  if (status != QN_OK) {
    qn_time_step_clear (&next);
    return status;
  }
  memcpy (next.start.u, step->start.u, bytes);
  memcpy (next.start.v, step->start.v, bytes);
  memcpy (next.start.a, step->start.a, bytes);
  qn_beam_state_set (&step->start.beams, &as->beams);
  qn_time_step_clear (step);
  *step = next;
  qn_time_step_renew (step);
  return QN_OK;
}

void
qn_time_step_clear (QnTimeStep *step)
{
  instant_clear (&step->start);
  instant_clear (&step->end);
  free (step->mass);
  free (step->beam_damping);
  free (step->inertia[0]);
  free (step->inertia[1]);
  free (step->elasticity);
  free (step->residual);
  free (step->step);
  free (step->increment);
  free (step->mean_motion);
  free (step->product);
  free (step->forces);
  free (step->tangents);
  free (step->sums);
  free (step->branches);
  free (step->factored);
  *step = (QnTimeStep){ 0 };
}

static QnStepStatus
judge_factor (QnFactorStatus status)
{
  switch (status) {
  case QN_FACTOR_OK:
    return QN_STEP_CONVERGED;
  case QN_FACTOR_SINGULAR:
    return QN_STEP_FAILED;
  case QN_FACTOR_NO_MEMORY:
    break;
  }
  return QN_STEP_NO_MEMORY;
}

/* a = M \ (F - P - a0 M v - M i g), without the dashpots of joints and beams, which the first step
 * takes up. */
QnStepStatus
qn_time_step_start (QnTimeStep *step, QnVec2 ground)
{
  QnAssembly *as = step->assembly;
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
  QnFactorStatus status =
    qn_linsys_factor_and_solve (step->linsys, as->ax, QN_LINSYS_ONCE, start->a);
  for (int32_t i = 0; status == QN_FACTOR_OK && i < as->unknown_count; i++)
    start->a[i] -= step->settings->mass_damping * start->v[i];
  return judge_factor (status);
}

/* --- Newton's iteration ------------------------------------------------------------------ */

/* u1, v1 and a1 from the increment. */
static void
move (QnTimeStep *step, double h)
{
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start;
  QnInstant *end = &step->end;

  for (int32_t i = 0; i < step->assembly->unknown_count; i++) {
    end->u[i] = start->u[i] + step->increment[i];
    end->a[i] = (step->increment[i] - h * start->v[i]) / (s->beta * h * h)
                - (0.5 / s->beta - 1) * start->a[i];
    end->v[i] = start->v[i] + h * ((1 - s->gamma) * start->a[i] + s->gamma * end->a[i]);
  }
}

static QnPairInstant
pair_at (const QnInstant *instant, const QnPairResponse *responses, size_t p)
{
  return (
    QnPairInstant){ .q = { instant->elongations[2 * p], instant->elongations[2 * p + 1] },
                    .rate = { instant->rates[2 * p], instant->rates[2 * p + 1] },
                    .response = &responses[p] };
}

static void
evaluate_pairs (QnTimeStep *step, double h)
{
  const QnAssembly *as = step->assembly;
  const QnTimeScheme *s = &step->scheme;
  const QnPairStep pair_step = { .alpha_f = s->alpha_f,
                                 .rate_gain = s->gamma / (s->beta * h),
                                 .length = h,
                                 .damping = step->settings->joint_damping,
                                 .of = step->settings->of };

  memcpy (step->end.elongations, as->elongations,
          2 * as->pair_count * sizeof *as->elongations);
  if (pair_step.damping > 0)
    qn_assembly_elongation_rates (as, step->end.v, step->end.rates);
  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairInstant start = pair_at (&step->start, step->start.responses, p);
    QnPairInstant end = pair_at (&step->end, as->responses, p);
    QnPairForces *forces = &step->forces[p];
    if (as->inactive[p]) {
      *forces = (QnPairForces){ 0 };
      memset (step->sums + 2 * p, 0, 2 * sizeof *step->sums);
      memset (step->tangents + 4 * p, 0, sizeof forces->tangent);
      memset (step->branches + QN_BRANCH * p, 0, QN_BRANCH * sizeof *step->branches);
      continue;
    }
    *forces = qn_pair_motion (&step->elasticity[p], &pair_step, &start, &end);
    for (int i = 0; i < 2; i++)
      step->sums[2 * p + i] =
        end.response->force[i]
        + (forces->correction[i] + forces->dashpot[i]) / (1 - s->alpha_f);
    memcpy (step->tangents + 4 * p, forces->tangent, sizeof forces->tangent);
    double *branch = step->branches + QN_BRANCH * p;
    memcpy (branch, end.response->tangent, sizeof end.response->tangent);
    branch[QN_BRANCH - 1] = qn_pair_branch (&step->elasticity[p], &start, &end);
  }
}

/* residual = (F - M a - C v - P - M i g)_(1-a) / (1 - af) at end.u. Returns its largest entry
 * over the largest force; INFINITY where it cannot be had. */
static double
measure (QnTimeStep *step, double h, QnVec2 ground)
{
  QnAssembly *as = step->assembly;
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start, *end = &step->end;
  double weight = 1 - s->alpha_f, largest = 0, *r = step->residual;
  double begun = qn_clock_seconds ();

  move (step, h);
  if (!qn_assembly_evaluate (as, end->u))
    return INFINITY;
  evaluate_pairs (step, h);
  double evaluated = qn_clock_seconds ();
  step->statistics.law_seconds += evaluated - begun;
  double scale = qn_assembly_residual_of (as, 0, step->sums, 2, r);
  bool damps_beams = as->beams.count > 0 && step->settings->joint_damping > 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    double v = weight * end->v[i] + s->alpha_f * start->v[i];
    step->mean_motion[i] = (1 - s->alpha_m) * end->a[i] + s->alpha_m * start->a[i]
                           + step->settings->mass_damping * v;
  }
  qn_assembly_multiply (as, step->mass, step->mean_motion, step->product);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    double drag = step->inertia[0][i] * ground.x + step->inertia[1][i] * ground.y;
    scale = fmax (scale, fmax (fabs (step->product[i]), fabs (drag)));
    r[i] += (s->alpha_f * start->residual[i] - step->product[i] - drag) / weight;
  }
  if (damps_beams) {
    for (int32_t i = 0; i < as->unknown_count; i++)
      step->mean_motion[i] = weight * end->v[i] + s->alpha_f * start->v[i];
    qn_assembly_multiply (as, step->beam_damping, step->mean_motion, step->product);
    for (int32_t i = 0; i < as->unknown_count; i++)
      r[i] -= step->settings->joint_damping * step->product[i] / weight;
  }
  for (int32_t i = 0; i < as->unknown_count; i++)
    largest = as->settles[i] ? largest : qn_worse (largest, fabs (r[i]));
  step->statistics.assembly_seconds += qn_clock_seconds () - evaluated;
  return scale > 0 ? largest / scale : largest;
}

/* Whether the factorisation at hand is of this tangent, but for what elongations and motion have
 * changed since. */
static bool
is_factored (const QnTimeStep *step, double h)
{
  const QnAssembly *as = step->assembly;

  return step->factored_length == h && !step->stale
         && !qn_beam_assembly_has_changed (&as->beams)
         && memcmp (step->factored, step->branches,
                    QN_BRANCH * as->pair_count * sizeof *step->branches)
              == 0;
}

/* Whether what is factorised is for joints none of which slides, opens or closes. */
static bool
is_still (const QnTimeStep *step)
{
  size_t p = 0;

  while (p < step->assembly->pair_count
         && qn_pair_branch_is_still ((int) step->factored[QN_BRANCH * p + QN_BRANCH - 1]))
    p++;
  return p == step->assembly->pair_count;
}

/* step = K \ residual, K = (M (1-am)/(beta h^2) + C (1-af) gamma/(beta h))/(1-af) + dP/du */
static QnFactorStatus
solve_direction (QnTimeStep *step, double h)
{
  QnAssembly *as = step->assembly;
  const QnTimeScheme *s = &step->scheme;
  double gain = s->gamma / (s->beta * h);
  double begun = qn_clock_seconds ();

  memcpy (step->step, step->residual, (size_t) as->unknown_count * sizeof *step->step);
  if (is_factored (step, h)) {
    qn_linsys_solve (step->linsys, step->step);
    step->statistics.factor_seconds += qn_clock_seconds () - begun;
    return QN_FACTOR_OK;
  }
  double mass = (1 - s->alpha_m) / (s->beta * h * h * (1 - s->alpha_f))
                + step->settings->mass_damping * gain;
  qn_assembly_tangent_of (as, 0, 0, step->tangents, 4);
  for (int32_t k = 0; k < as->ap[as->unknown_count]; k++)
    as->ax[k] +=
      mass * step->mass[k] + step->settings->joint_damping * gain * step->beam_damping[k];
  double assembled = qn_clock_seconds ();
  QnFactorStatus status =
    qn_linsys_factor_and_solve (step->linsys, as->ax, QN_LINSYS_REPEATED, step->step);
  memcpy (step->factored, step->branches,
          QN_BRANCH * as->pair_count * sizeof *step->factored);
  step->factored_length = status == QN_FACTOR_OK ? h : 0;
  step->statistics.factorizations += qn_linsys_work (step->linsys) > 0;
  step->statistics.factorization_work += qn_linsys_work (step->linsys);
  step->statistics.assembly_seconds += assembled - begun;
  step->statistics.factor_seconds += qn_clock_seconds () - assembled;
  return status;
}

static bool
go_on (QnTimeStep *step)
{
  step->progress.iterations = ++step->statistics.iterations;
  step->progress.factorizations = step->statistics.factorizations;
  return step->report == NULL || step->report (&step->progress, step->report_data);
}

/* Takes the direction, or a part of it where the residual grows although joints should have found
 * their states. Returns the residual. */
static double
advance (QnTimeStep *step, double h, QnVec2 ground, int iteration, double before)
{
  int32_t n = step->assembly->unknown_count;
  double part = 1;

  for (int32_t i = 0; i < n; i++)
    step->increment[i] += step->step[i];
  double after = measure (step, h, ground);
  for (int i = 0; i < HALVINGS && iteration >= PATIENCE && !(after < before); i++) {
    part /= 2;
    for (int32_t k = 0; k < n; k++)
      step->increment[k] -= part * step->step[k];
    after = measure (step, h, ground);
  }
  return after;
}

/* The residual where the step begins to iterate: so far on with the speed at its start, which sliding
 * and open joints keep. */
static double
predict (QnTimeStep *step, double h, double part, QnVec2 ground)
{
  for (int32_t i = 0; i < step->assembly->unknown_count; i++)
    step->increment[i] = part * h * step->start.v[i];
  return measure (step, h, ground);
}

/* With bonds as they are, from where the increment is. */
static QnStepStatus
iterate (QnTimeStep *step, double h, QnVec2 ground)
{
  for (int iteration = 0; !(step->relative <= step->tolerance); iteration++) {
    if (iteration == BUDGET || !isfinite (step->relative))
      return QN_STEP_FAILED;
    if (!go_on (step))
      return QN_STEP_CANCELLED;
    int32_t factorizations = step->statistics.factorizations;
    QnStepStatus status = judge_factor (solve_direction (step, h));
    if (status != QN_STEP_CONVERGED)
      return status;
    bool kept = factorizations == step->statistics.factorizations;
    double after = advance (step, h, ground, iteration, step->relative);
    step->stale = kept && after > WORTH_KEEPING * step->relative;
    step->relative = after;
  }
  return QN_STEP_CONVERGED;
}

QnStepStatus
qn_time_step_try (QnTimeStep *step, double h, QnVec2 ground)
{
  QnStepStatus status;

  step->stale = false;
  qn_assembly_hold_bonds (step->assembly);
  step->relative = predict (step, h, 1, ground);
  /* Joints that vibrate faster than the steps would leave their branch for a moment and come back:
   * where they stand still nothing is factorised for that. */
  if (step->factored_length == h && is_still (step) && !is_factored (step, h)) {
    step->relative = predict (step, h, 0, ground);
    if (!is_factored (step, h))
      step->relative = predict (step, h, 1, ground);
  }
  while ((status = iterate (step, h, ground)) == QN_STEP_CONVERGED
         && qn_assembly_break_bonds (step->assembly))
    step->relative = measure (step, h, ground);
  qn_assembly_let_bonds (step->assembly, status == QN_STEP_CONVERGED);
  if (status == QN_STEP_CONVERGED)
    take_evaluation (step, &step->end);
  return status;
}

double
qn_time_step_error (const QnTimeStep *step, double h, QnVec2 change)
{
  const QnAssembly *as = step->assembly;
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
  qn_beam_state_save (&step->start.beams, &step->assembly->beams);
  if (step->settings->of == QN_DAMPING_CURRENT || step->assembly->nonlinear)
    renew_beam_damping (step);
}

void
qn_time_step_restore (QnTimeStep *step)
{
  QnAssembly *as = step->assembly;

  memcpy (as->responses, step->start.responses, as->pair_count * sizeof *as->responses);
  qn_beam_state_set (&step->start.beams, &as->beams);
  qn_assembly_update_kinematics (as, step->start.u);
}
