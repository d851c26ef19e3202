/* Semismooth Newton iteration with a backtracking line search on the out-of-balance forces. */
#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/base/tolerance.h"
#include "core/equilibrium/equilibrium.h"

#include <string.h>

/* Tuning. A structure has run away when a tenth of a millimetre of elastic deformation of the whole under its
 * dead load, which grows with the square of the number of courses, has become three centimetres; and not before
 * QN_RUNAWAY. */
#define RUNAWAY_OF_WHOLE    300
#define SHORTEST_STEP       (1.0 / 1024) /* part of the direction that the line search tries */
#define SUFFICIENT_DECREASE 1e-4         /* of what a linear system would give */
#define FINER               1e-3 /* of the tolerance: no more is worth another iteration */
#define TRACE               1e-9 /* viscosity in the tangent where another target is sought */

/* One solution in progress. */
typedef struct {
  QnStepEquation equation; /* norm: of residual and target together, N */
  const QnTarget *target;
  double viscosity;
  double stiffness; /* force that the target's equation is worth per unit, N or N/m */
  double multiplier, multiplier_step; /* where eq->step begins, and of it */
} Newton;

double
qn_equilibrium_target_lack (const QnEquilibrium *eq, const QnTarget *target)
{
  double lack = target->advance;

  if (target->direction == NULL)
    return 0;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    lack -= target->direction[i] * (eq->u[i] - eq->committed.u[i]);
  return lack;
}

/* The same, but nothing where it is no more than rounding. */
static double
target_gap (const Newton *newton)
{
  const QnEquilibrium *eq = newton->equation.eq;
  const QnTarget *target = newton->target;
  double gap = qn_equilibrium_target_lack (eq, target), size = 0;

  if (target->direction == NULL)
    return 0;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    size += fabs (target->direction[i] * eq->u[i]);
  double met = QN_TOLERANCE_TARGET * fabs (target->advance) + QN_TOLERANCE_MEASURE * size;
  return fabs (gap) > met ? gap : 0;
}

/* residual = R(u, multiplier) - viscosity C (u - anchor), from the forces of the last
 * evaluation; sets norm and relative. */
static void
measure (QnStepEquation *equation)
{
  Newton *newton = (Newton *) equation;
  QnEquilibrium *eq = newton->equation.eq;
  QnAssembly *as = &eq->assembly;
  double start = qn_clock_seconds ();
  double scale = qn_assembly_residual (as, eq->multiplier, eq->residual);
  double gap = newton->stiffness * target_gap (newton);
  double sum = gap * gap, largest = qn_assembly_largest (as, eq->residual, NULL);

  eq->out_of_balance = scale > 0 ? largest / scale : 0;
  for (int32_t i = 0; i < as->unknown_count; i++) {
    eq->residual[i] -= newton->viscosity * as->damping[i] * (eq->u[i] - eq->anchor.u[i]);
    sum += eq->residual[i] * eq->residual[i];
  }
  if (newton->viscosity > 0)
    largest = qn_assembly_largest (as, eq->residual, NULL);
  newton->equation.relative = scale > 0 ? largest / scale : 0;
  if (gap != 0)
    newton->equation.relative = INFINITY; /* the target is met exactly or not at all */
  newton->equation.norm = sqrt (sum);
  eq->statistics.assembly_seconds += qn_clock_seconds () - start;
}

/* Whether a pair is on the branch of its law that was factorised last. */
static bool
is_same (const QnEquilibrium *eq, size_t p)
{
  const QnPairResponse *was = &eq->factored_pairs[p], *is = &eq->assembly.responses[p];

  return was->state == is->state && was->varies == is->varies
         && (is->varies || memcmp (was->tangent, is->tangent, sizeof is->tangent) == 0);
}

/* Whether the tangent is factorised already: it depends on the branches of the pairs and the viscosity only, as
 * long as geometry is linear. */
static bool
is_factored (const QnEquilibrium *eq, double viscosity)
{
  const QnAssembly *as = &eq->assembly;
  bool same = eq->factored && eq->factored_viscosity == viscosity && !as->nonlinear
              && !qn_beam_assembly_has_changed (as);

  for (size_t p = 0; p < as->pair_count && same; p++)
    same = !as->responses[p].varies && is_same (eq, p);
  return same;
}

QnSolveStatus
qn_equilibrium_factor (QnEquilibrium *eq, double *b)
{
  double start = qn_clock_seconds ();
  QnSolveStatus status = qn_linsys_factor_and_solve (eq->linsys, eq->assembly.ax, b);
  double work = qn_linsys_work (eq->linsys);

  eq->statistics.factor_seconds += qn_clock_seconds () - start;
  eq->statistics.factorizations += work > 0;
  eq->statistics.factorization_work += work;
  return status;
}

void
qn_equilibrium_solve (QnEquilibrium *eq, double *b)
{
  double start = qn_clock_seconds ();

  qn_linsys_solve (eq->linsys, b);
  eq->statistics.factor_seconds += qn_clock_seconds () - start;
}

/* b = K \ b. Factorises the tangent unless it is the one that is factorised already. */
static QnSolveStatus
apply_inverse (QnEquilibrium *eq, double viscosity, double *b)
{
  QnAssembly *as = &eq->assembly;

  if (is_factored (eq, viscosity)) {
    qn_equilibrium_solve (eq, b);
    return QN_SOLVE_CONVERGED;
  }
  for (size_t p = 0; p < as->pair_count; p++)
    eq->factored_pairs[p] = as->responses[p];
  double start = qn_clock_seconds ();
  qn_assembly_tangent (as, eq->multiplier, viscosity);
  eq->statistics.assembly_seconds += qn_clock_seconds () - start;
  QnSolveStatus status = qn_equilibrium_factor (eq, b);
  eq->factored = status == QN_SOLVE_CONVERGED;
  eq->factored_viscosity = viscosity;
  return status;
}

bool
qn_equilibrium_go_on (QnEquilibrium *eq)
{
  eq->statistics.iterations++;
  eq->progress.iterations = eq->statistics.iterations;
  eq->progress.factorizations = eq->statistics.factorizations;
  if (eq->report != NULL && !eq->cancelled)
    eq->cancelled = !eq->report (&eq->progress, eq->report_data);
  return !eq->cancelled;
}

double
qn_equilibrium_complete_step (QnEquilibrium *eq, const QnTarget *target, double lack,
                              double *along_live)
{
  int32_t n = eq->assembly.unknown_count;
  double along_step = qn_dot (target->direction, eq->step, (size_t) n);

  *along_live = qn_dot (target->direction, eq->live_step, (size_t) n);
  double multiplier_step = *along_live != 0 ? (lack - along_step) / *along_live : 0;
  for (int32_t i = 0; i < n; i++)
    eq->step[i] += multiplier_step * eq->live_step[i];
  return multiplier_step;
}

/* A full mechanism has a singular tangent, yet a target holds it: a trace of damping lets the bordered
 * system be solved in two halves. A tangent that is factorised without it is not singular. */
static double
viscosity_of_tangent (const Newton *newton)
{
  bool held = newton->target->direction != NULL;

  return held && !is_factored (newton->equation.eq, newton->viscosity)
           ? fmax (newton->viscosity, TRACE)
           : newton->viscosity;
}

/* The Newton direction: eq->step and multiplier_step. */
static QnSolveStatus
solve_direction (QnStepEquation *equation)
{
  Newton *newton = (Newton *) equation;
  QnEquilibrium *eq = newton->equation.eq;
  const QnTarget *target = newton->target;
  int32_t n = eq->assembly.unknown_count;
  size_t bytes = (size_t) n * sizeof (double);
  double viscosity = viscosity_of_tangent (newton);

  memcpy (eq->step, eq->residual, bytes);
  QnSolveStatus status = apply_inverse (eq, viscosity, eq->step);
  newton->multiplier_step = 0;
  if (status == QN_SOLVE_CONVERGED && target->direction != NULL) {
    double along_live;
    double load = qn_assembly_largest (&eq->assembly, eq->assembly.live, NULL);
    memcpy (eq->live_step, eq->assembly.live, bytes);
    qn_equilibrium_solve (eq, eq->live_step);
    double gap = target_gap (newton);
    newton->multiplier_step = qn_equilibrium_complete_step (eq, target, gap, &along_live);
    eq->slope = along_live != 0 ? 1 / along_live : 0;
    newton->stiffness = along_live != 0 ? load / fabs (along_live) : 0;
    eq->orientation =
      along_live < 0 ? -qn_linsys_sign (eq->linsys) : qn_linsys_sign (eq->linsys);
  }
  return status;
}

static void
move (QnStepEquation *equation, double part)
{
  Newton *newton = (Newton *) equation;
  QnEquilibrium *eq = newton->equation.eq;
  int32_t n = eq->assembly.unknown_count;

  if (part == 1) {
    memcpy (eq->trial, eq->u, (size_t) n * sizeof *eq->u);
    newton->multiplier = eq->multiplier;
  }
  eq->multiplier = newton->multiplier + part * newton->multiplier_step;
  for (int32_t i = 0; i < n; i++)
    eq->u[i] = eq->trial[i] + part * eq->step[i];
  double start = qn_clock_seconds ();
  bool evaluated = qn_assembly_evaluate (&eq->assembly, eq->u);
  eq->statistics.law_seconds += qn_clock_seconds () - start;
  if (evaluated)
    measure (equation);
  else
    equation->norm = INFINITY;
}

/* Moves by the largest power of 1/2 that decreases the residual enough below `norm`; false where none does. */
static bool
line_search (QnStepEquation *equation, double norm)
{
  for (double part = 1; part >= SHORTEST_STEP; part /= 2) {
    equation->move (equation, part);
    if (equation->norm <= (1 - SUFFICIENT_DECREASE * part) * norm)
      return true;
  }
  return false;
}

/* One more iteration of a solution that has converged, where it costs no factorisation: on a plateau the
 * multiplier then has all its digits, not only those of the tolerance. */
static void
refine (QnStepEquation *equation)
{
  Newton *newton = (Newton *) equation;
  QnEquilibrium *eq = newton->equation.eq;

  if (newton->target->direction == NULL
      || newton->equation.relative <= FINER * eq->tolerance
      || !is_factored (eq, viscosity_of_tangent (newton)))
    return;
  if (solve_direction (equation) == QN_SOLVE_CONVERGED
      && !line_search (equation, equation->norm))
    move (equation, 0);
}

/* With bonds as they are. The first step is free: it takes pairs across the corner they rest in, which costs
 * balance before it gains. */
static QnSolveStatus
iterate (QnStepEquation *equation, int budget)
{
  QnEquilibrium *eq = equation->eq;

  for (int iteration = 0;; iteration++) {
    if (equation->relative <= eq->tolerance)
      return QN_SOLVE_CONVERGED;
    if (iteration >= budget || !isfinite (equation->norm))
      return QN_SOLVE_FAILED;
    if (!qn_equilibrium_go_on (eq))
      return QN_SOLVE_CANCELLED;
    QnSolveStatus status = equation->solve (equation);
    if (status != QN_SOLVE_CONVERGED)
      return status;
    if (!line_search (equation, iteration == 0 ? INFINITY : equation->norm))
      return QN_SOLVE_FAILED;
  }
}

QnSolveStatus
qn_equilibrium_iterate (QnStepEquation *equation, int budget)
{
  QnAssembly *as = &equation->eq->assembly;
  QnSolveStatus status;

  for (;;) {
    status = iterate (equation, budget);
    if (status == QN_SOLVE_CONVERGED && equation->refine != NULL)
      equation->refine (equation);
    if (status != QN_SOLVE_CONVERGED || !qn_assembly_break_bonds (as))
      break;
    equation->measure (equation);
  }
  qn_assembly_let_bonds (as, status == QN_SOLVE_CONVERGED);
  return status;
}

static bool
is_broken (const QnPairSprings *springs, const QnPairMemory *memory, bool in_a)
{
  return in_a ? qn_spring_damage (&springs->a, &memory->a) >= 1
              : !springs->equal && qn_spring_damage (&springs->b, &memory->b) >= 1;
}

/* Whether the laws by themselves, from the state before, break what is broken, and of two springs the same. */
static bool
breaks_by_law (const QnAssembly *as)
{
  for (size_t p = 0; as->has_bonds && p < as->pair_count; p++) {
    const QnPairSprings *springs = &as->springs[p];
    const QnPairMemory *after = &as->responses[p].memory;
    QnPairMemory before = as->committed[p];
    QnPairResponse response;
    if (isnan (as->breaks[p]))
      continue;
    before.a.extreme = before.a.extreme == 1 ? as->breaks[p] : before.a.extreme;
    before.b.extreme = before.b.extreme == 1 ? as->breaks[p] : before.b.extreme;
    if (!qn_pair_evaluate (springs, &before, as->elongations + 2 * p, &response))
      return false;
    for (int in_a = 0; in_a < 2; in_a++)
      if (is_broken (springs, &response.memory, in_a) != is_broken (springs, after, in_a))
        return false;
  }
  return true;
}

QnSolveStatus
qn_equilibrium_newton (QnEquilibrium *eq, const QnTarget *target, double viscosity,
                       int budget)
{
  Newton newton = { .equation = { .eq = eq,
                                  .measure = measure,
                                  .solve = solve_direction,
                                  .move = move,
                                  .refine = refine },
                    .target = target,
                    .viscosity = viscosity,
                    .stiffness = 1 };

  if (target->direction == NULL)
    eq->multiplier = target->multiplier;
  if (budget != QN_MEASURE_ONLY)
    qn_assembly_hold_bonds (&eq->assembly);
  measure (&newton.equation);
  if (budget == QN_MEASURE_ONLY)
    return newton.equation.relative <= eq->tolerance ? QN_SOLVE_CONVERGED
                                                     : QN_SOLVE_FAILED;
  QnSolveStatus status = qn_equilibrium_iterate (&newton.equation, budget);
  if (status == QN_SOLVE_CONVERGED && !breaks_by_law (&eq->assembly))
    eq->keeps_forces = true;
  return status;
}

bool
qn_equilibrium_set_runaway (QnEquilibrium *eq)
{
  const QnAssembly *as = &eq->assembly;

  memcpy (eq->step, as->dead, (size_t) as->unknown_count * sizeof *eq->step);
  for (size_t s = 0; s < as->settling_count; s++)
    eq->step[as->settling[s].unknown] = 0; /* what follows a settlement does not deform */
  QnSolveStatus status = apply_inverse (eq, 0, eq->step);
  double whole = status == QN_SOLVE_CONVERGED
                   ? qn_assembly_elastic_displacements (as, eq->step, NULL)
                   : 0;
  eq->runaway = fmin (fmax (QN_RUNAWAY, RUNAWAY_OF_WHOLE * whole), QN_FARTHEST);
  return status != QN_SOLVE_NO_MEMORY;
}

bool
qn_equilibrium_update_slope (QnEquilibrium *eq, const double *direction)
{
  const QnAssembly *as = &eq->assembly;
  bool same = true;
  double along_live = 0;

  for (size_t p = 0; p < as->pair_count && same; p++)
    same = is_same (eq, p);
  if (same)
    return true;
  QnSolveStatus status = qn_equilibrium_rate (eq, eq->live_step);
  if (status == QN_SOLVE_CONVERGED)
    along_live = qn_dot (direction, eq->live_step, (size_t) as->unknown_count);
  eq->slope = along_live != 0 ? 1 / along_live : 0;
  return status != QN_SOLVE_NO_MEMORY;
}

QnSolveStatus
qn_equilibrium_rate (QnEquilibrium *eq, double *rate)
{
  memcpy (rate, eq->assembly.live, (size_t) eq->assembly.unknown_count * sizeof *rate);
  return apply_inverse (eq, 0, rate);
}
