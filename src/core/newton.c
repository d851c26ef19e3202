/* Semismooth Newton iteration with a backtracking line search on the out-of-balance forces. */
#include "core/clock.h"
#include "core/equilibrium.h"

#include <string.h>

/* Shortest fraction of the Newton direction that the line search tries. */
#define SHORTEST_STEP (1.0 / 1024)

/* Decrease of the residual asked for, as a fraction of what a linear system would give. */
#define SUFFICIENT_DECREASE 1e-4

/* residual = R(u) - viscosity C (u - anchor); returns its 2-norm, or infinity where a pair
 * could not be evaluated. *relative gets the largest entry relative to the loads. */
static double
measure (QnEquilibrium *eq, const double *u, double multiplier, double viscosity,
         double *relative)
{
  QnAssembly *as = &eq->assembly;
  double start = qn_clock_seconds ();
  double scale = qn_assembly_residual (as, multiplier, eq->residual);
  double sum = 0, largest = 0, largest_static = 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    largest_static = fmax (largest_static, fabs (eq->residual[i]));
    eq->residual[i] -= viscosity * as->damping[i] * (u[i] - eq->anchor.u[i]);
    largest = fmax (largest, fabs (eq->residual[i]));
    sum += eq->residual[i] * eq->residual[i];
  }
  eq->out_of_balance = scale > 0 ? largest_static / scale : 0;
  *relative = scale > 0 ? largest / scale : 0;
  eq->statistics.assembly_seconds += qn_clock_seconds () - start;
  return sqrt (sum);
}

static double
evaluate (QnEquilibrium *eq, const double *u, double multiplier, double viscosity,
          double *relative)
{
  double start = qn_clock_seconds ();
  bool evaluated = qn_assembly_evaluate (&eq->assembly, u);

  eq->statistics.law_seconds += qn_clock_seconds () - start;
  if (!evaluated)
    return INFINITY;
  return measure (eq, u, multiplier, viscosity, relative);
}

/* Factorises the tangent unless it is the one that is factorised already: the tangent depends
 * on the phases of the pairs and the viscosity only. */
static QnFactorStatus
factorize (QnEquilibrium *eq, double viscosity)
{
  QnAssembly *as = &eq->assembly;
  bool same = eq->factored && eq->factored_viscosity == viscosity;

  for (size_t p = 0; p < as->pair_count; p++) {
    same = same && eq->factored_phases[p] == as->responses[p].phase;
    eq->factored_phases[p] = as->responses[p].phase;
  }
  if (same)
    return QN_FACTOR_OK;

  double start = qn_clock_seconds ();
  qn_assembly_tangent (as, viscosity);
  double assembled = qn_clock_seconds ();
  QnFactorStatus status = qn_linsys_factor (eq->linsys, as->ax);
  eq->statistics.assembly_seconds += assembled - start;
  eq->statistics.factor_seconds += qn_clock_seconds () - assembled;
  eq->statistics.factorizations++;
  eq->factored = status == QN_FACTOR_OK;
  eq->factored_viscosity = viscosity;
  return status;
}

static bool
go_on (QnEquilibrium *eq)
{
  eq->statistics.iterations++;
  eq->progress.iterations = eq->statistics.iterations;
  eq->progress.factorizations = eq->statistics.factorizations;
  if (eq->report != NULL && !eq->cancelled)
    eq->cancelled = !eq->report (&eq->progress, eq->report_data);
  return !eq->cancelled;
}

/* Moves along the Newton direction by the largest power of 1/2 that decreases the residual.
 * Returns the new norm, or a negative number where none does. */
static double
line_search (QnEquilibrium *eq, double multiplier, double viscosity, double norm,
             double *relative)
{
  int32_t n = eq->assembly.unknown_count;

  for (double alpha = 1; alpha >= SHORTEST_STEP; alpha /= 2) {
    for (int32_t i = 0; i < n; i++)
      eq->trial[i] = eq->u[i] + alpha * eq->step[i];
    double tried = evaluate (eq, eq->trial, multiplier, viscosity, relative);
    if (tried <= (1 - SUFFICIENT_DECREASE * alpha) * norm) {
      memcpy (eq->u, eq->trial, (size_t) n * sizeof *eq->u);
      return tried;
    }
  }
  return -1;
}

QnSolveStatus
qn_equilibrium_newton (QnEquilibrium *eq, double multiplier, double viscosity, int budget)
{
  int32_t n = eq->assembly.unknown_count;
  double relative;
  double norm = measure (eq, eq->u, multiplier, viscosity, &relative);

  for (int iteration = 0;; iteration++) {
    if (relative <= eq->tolerance)
      return QN_SOLVE_CONVERGED;
    if (iteration == budget || !isfinite (norm))
      return QN_SOLVE_FAILED;
    if (!go_on (eq))
      return QN_SOLVE_CANCELLED;

    switch (factorize (eq, viscosity)) {
    case QN_FACTOR_OK:
      break;
    case QN_FACTOR_SINGULAR:
      return QN_SOLVE_FAILED;
    case QN_FACTOR_NO_MEMORY:
      return QN_SOLVE_NO_MEMORY;
    }
    memcpy (eq->step, eq->residual, (size_t) n * sizeof *eq->step);
    double start = qn_clock_seconds ();
    qn_linsys_solve (eq->linsys, eq->step); /* step = K \ residual */
    eq->statistics.factor_seconds += qn_clock_seconds () - start;

    /* The first step is free: it takes pairs across the corner they rest in, which costs
     * balance before it gains. */
    norm = line_search (eq, multiplier, viscosity, iteration == 0 ? INFINITY : norm,
                        &relative);
    if (norm < 0)
      return QN_SOLVE_FAILED;
  }
}

QnSolveStatus
qn_equilibrium_apply_tangent_inverse (QnEquilibrium *eq, double *b)
{
  switch (factorize (eq, 0)) {
  case QN_FACTOR_OK:
    qn_linsys_solve (eq->linsys, b);
    return QN_SOLVE_CONVERGED;
  case QN_FACTOR_SINGULAR:
    return QN_SOLVE_FAILED;
  case QN_FACTOR_NO_MEMORY:
    break;
  }
  return QN_SOLVE_NO_MEMORY;
}
