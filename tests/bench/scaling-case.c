#include "bench/scaling-case.h"

#include "bench/bench.h"
#include "bench/limit-program.h"
#include "core/equilibrium/equilibrium.h"
#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "support/auto-clear.h"
#include "support/walls.h"

#include <math.h>
#include <string.h>

static const ScalingPart not_run = {
  .outcome = "", .seconds = NAN, .kernels = NAN, .megabytes = NAN, .multiplier = NAN
};

void
scaling_case_init (ScalingCase *c, int blocks, gboolean facade)
{
  int length = (int) lround (sqrt (blocks * TEST_UNIT.y / TEST_UNIT.x));
  int courses = (int) lround ((double) blocks / (length + 0.5));
  *c = (ScalingCase){ .kind = facade ? "façade" : "wall",
                      .first_limit = NAN,
                      .detection = not_run,
                      .elastic = not_run,
                      .limit = not_run,
                      .path = not_run,
                      .clp = not_run,
                      .highs = not_run };
  test_bond_init (&c->model, TEST_UNIT, length, courses, facade ? blocks / 60 : 0, 7);
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  c->blocks = c->model.block_count - 1;
}

void
scaling_case_clear (ScalingCase *c)
{
  qn_contacts_clear (&c->contacts);
  qn_model_clear (&c->model);
}

/* Ends a measurement that began at `start` (processor time). */
static void
finish (ScalingPart *part, double start)
{
  part->seconds = bench_cpu_seconds () - start;
  part->megabytes = bench_peak_megabytes ();
  part->kernels = part->seconds / bench_kernel_seconds ();
}

void
scaling_case_detect (ScalingCase *c)
{
  double best = G_MAXDOUBLE;
  for (int round = 0; round < 3; round++) {
    if (round > 0)
      qn_contacts_clear (&c->contacts);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
    best = fmin (best, bench_cpu_seconds () - start);
  }
  c->faces = c->contacts.face_count;
  c->detection.done = TRUE;
  c->detection.seconds = best;
  c->detection.kernels = best / bench_kernel_seconds ();
}

void
scaling_case_elastic (ScalingCase *c)
{
  QnEquilibrium eq;
  bench_reset_peak ();
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_equilibrium_setup (&eq, &c->model, &c->contacts, NULL, NULL, NULL),
                   ==, QN_OK);
  QnAssembly *assembly = &eq.assembly;
  qn_assembly_evaluate (assembly, eq.u);
  qn_assembly_tangent (assembly, 0, 0);
  double factoring = bench_cpu_seconds ();
  g_assert_cmpint (qn_linsys_factor (eq.linsys, assembly->ax), ==, QN_SOLVE_CONVERGED);
  c->factorization = bench_cpu_seconds () - factoring;
  memcpy (eq.u, assembly->dead, (size_t) assembly->unknown_count * sizeof *eq.u);
  qn_linsys_solve (eq.linsys, eq.u);
  finish (&c->elastic, start);
  c->elastic.done = TRUE;

  /* Best of two, since the ratio to detection is held to a bound; of other values, for what has
   * not changed would not be eliminated again. */
  for (int32_t e = 0; e < assembly->ap[assembly->unknown_count]; e++)
    assembly->ax[e] *= 2;
  factoring = bench_cpu_seconds ();
  g_assert_cmpint (qn_linsys_factor (eq.linsys, assembly->ax), ==, QN_SOLVE_CONVERGED);
  c->factorization = fmin (c->factorization, bench_cpu_seconds () - factoring);
  qn_equilibrium_clear (&eq);
}

void
scaling_case_limit (ScalingCase *c, const ScalingLimits *limits)
{
  g_auto (QnLimitSolution) solution;
  bench_reset_peak ();
  double start = bench_cpu_seconds (), end = start + limits->limit;
  g_assert_cmpint (qn_limit_associative (&c->model, &c->contacts, bench_within_time, &end,
                                         &solution, NULL),
                   ==, QN_OK);
  finish (&c->limit, start);
  c->limit.outcome = qn_outcome_names[solution.outcome];
  c->limit.factorizations = solution.effort.factorizations;
  c->limit.done = solution.outcome == QN_OUTCOME_COLLAPSE;
  c->limit.multiplier = c->limit.done ? solution.lower_bound : NAN;
}

void
scaling_case_path (ScalingCase *c, const ScalingLimits *limits)
{
  g_auto (QnResult) result;
  c->model.analysis.procedure = limits->procedure;
  c->model.analysis.increments = 10;
  c->model.analysis.multiplier_tolerance = 1e-3;
  bench_reset_peak ();
  double start = bench_cpu_seconds (), end = start + limits->path;
  g_assert_cmpint (
    qn_analysis_run (&c->model, &c->contacts, bench_within_time, &end, &result, NULL), ==,
    QN_OK);
  finish (&c->path, start);
  c->path.outcome = qn_outcome_names[result.outcome];
  c->path.factorizations = result.statistics.factorizations;
  c->path.done = result.outcome == QN_OUTCOME_COLLAPSE;
  c->path.multiplier = result.has_collapse_multiplier ? result.collapse_multiplier
                       : result.step_count > 0
                         ? result.steps[result.step_count - 1].multiplier
                         : 0;
  if (result.has_first_limit_multiplier)
    c->first_limit = result.first_limit_multiplier;
}

void
scaling_case_peers (ScalingCase *c, const ScalingLimits *limits)
{
  QnLimitProblem limit;
  g_assert_cmpint (qn_limit_problem_init (&limit, &c->model, &c->contacts, false, NULL),
                   ==, QN_OK);
  for (const LimitPeer *peer = limit_peers; peer->solver != NULL; peer++) {
    ScalingPart *part = strcmp (peer->solver, "Clp") == 0 ? &c->clp : &c->highs;
    double spent;
    /* Nobody waits for a method that is slower than the best one already. */
    double budget =
      part->done ? fmin (limits->peers, 1.2 * part->seconds + 1) : limits->peers;
    double found = limit_peer_solve (peer, &limit, budget, &spent);
    if (isnan (found))
      continue;
    g_assert_cmpfloat_with_epsilon (found, c->limit.multiplier, 1e-6);
    if (!part->done || spent < part->seconds) {
      part->seconds = spent;
      part->outcome = peer->method;
    }
    part->done = TRUE;
  }
  qn_limit_problem_clear (&limit);
}
