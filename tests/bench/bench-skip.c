/* What is gained by leaving out what is not needed.
 *
 *   bench-skip [--path N] [--ascent N] [--seconds N] [BLOCKS…]
 *
 * skip.csv:      each shortcut of the analysis turned off, and all of them, beside the path with all
 *                on, in one process, on the six walls and on walls and façades of BLOCKS blocks:
 *                factorisations, what they amount to in whole ones, time
 * iteration.csv: on walls of any size, one factorisation, one solution, and one iteration along
 *                the central path beside them
 * pairs.csv:     more pairs to a joint than the two that suffice, on the six walls
 * precision.csv: how far solutions of the elastic stiffness, and of one near collapse, would be off
 *                if it were rounded to single precision
 */
#include "bench/bench.h"
#include "bench/scaling-case.h"
#include "core/path/analysis.h"
#include "core/path/path.h"
#include "support/models.h"

#include <locale.h>
#include <math.h>
#include <string.h>

/* Part of the limit multiplier up to which the path of larger walls is followed: what comes
 * beyond varies by chance more than by shortcuts. */
#define ASCENT 0.8

static int largest_path = 800, largest_ascent = 1800;
static double most_seconds = 60;

typedef struct {
  const char *name;
  unsigned no_shortcuts;
} Variant;

static const Variant variants[] = {
  { "all shortcuts", 0 },
  { "same_tangent off", QN_SHORTCUT_SAME_TANGENT },
  { "partial_elimination off", QN_SHORTCUT_PARTIAL_ELIMINATION },
  { "both off", QN_SHORTCUT_SAME_TANGENT | QN_SHORTCUT_PARTIAL_ELIMINATION },
  { "early_failure off", QN_SHORTCUT_EARLY_FAILURE },
  { "none", ~0u },
};

typedef struct {
  double seconds;
  QnResult result;
} Run;

/* Once, or where that is soon done several times, of which the fastest counts. */
static void
run (QnModel *model, const QnContacts *contacts, Run *run)
{
  double begin = bench_cpu_seconds ();
  run->seconds = G_MAXDOUBLE;
  for (int round = 0; round == 0 || (round < 5 && bench_cpu_seconds () < begin + 0.5);
       round++) {
    double start = bench_cpu_seconds (), end = start + most_seconds;
    if (round > 0)
      qn_result_clear (&run->result);
    g_assert_cmpint (
      qn_analysis_run (model, contacts, bench_within_time, &end, &run->result, NULL), ==,
      QN_OK);
    run->seconds = MIN (run->seconds, bench_cpu_seconds () - start);
  }
}

static double
multiplier (const QnResult *result)
{
  return result->step_count > 0 ? result->steps[result->step_count - 1].multiplier : NAN;
}

/* --- Shortcuts -------------------------------------------------------------------------- */

static void
compare_shortcuts (FILE *csv, const char *name, QnModel *model,
                   const QnContacts *contacts)
{
  Run with = { 0 };
  for (size_t i = 0; i < G_N_ELEMENTS (variants); i++) {
    Run found;
    model->analysis.no_shortcuts = variants[i].no_shortcuts;
    run (model, contacts, &found);
    if (i == 0)
      with = found;
    const QnStatistics *effort = &found.result.statistics;
    bench_csv_row (csv, "%s,%s,%s,%.6f,%d,%d,%.1f,%.4f,%.1f,%.2f", name, variants[i].name,
                   qn_outcome_names[found.result.outcome], multiplier (&found.result),
                   effort->iterations, effort->factorizations, effort->factorization_work,
                   found.seconds, found.seconds / bench_kernel_seconds (),
                   found.seconds / with.seconds);
    if (i > 0)
      qn_result_clear (&found.result);
  }
  qn_result_clear (&with.result);
  model->analysis.no_shortcuts = 0;
}

static FILE *
open_shortcuts (void)
{
  return bench_csv_open ("skip", "structure,shortcuts,outcome,multiplier,iterations,"
                                 "factorisations,whole factorisations,s,kernels,"
                                 "times all shortcuts");
}

static void
prepare_wall (QnModel *model, QnContacts *contacts, int number)
{
  test_model_init_wall (model, number, 0);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, NULL), ==, QN_OK);
}

static void
compare_on_six_walls (FILE *csv)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_autofree char *name = g_strdup_printf ("wall %d", number);
    prepare_wall (&model, &contacts, number);
    compare_shortcuts (csv, name, &model, &contacts);
  }
}

/* --- One iteration ---------------------------------------------------------------------- */

static double
least_time (QnLinsys *linsys, const double *ax, double *b, gboolean factorise)
{
  double least = G_MAXDOUBLE;
  for (int round = 0; round < 5; round++) {
    double start = bench_cpu_seconds ();
    int count = 0;
    while (count < 3 || bench_cpu_seconds () - start < 0.02) {
      if (factorise)
        g_assert_cmpint (qn_linsys_factor (linsys, ax), ==, QN_FACTOR_OK);
      else
        qn_linsys_solve (linsys, b);
      count++;
    }
    least = MIN (least, (bench_cpu_seconds () - start) / count);
  }
  return least;
}

/* The increment to half the multiplier of collapse: it has a solution, and joints change state. */
static void
time_iteration (FILE *csv, const ScalingCase *c, double collapse)
{
  QnEquilibrium eq;
  const QnTarget dead = qn_target_multiplier (0),
                 half = qn_target_multiplier (0.5 * collapse);
  g_assert_cmpint (qn_equilibrium_setup (&eq, &c->model, &c->contacts, NULL, NULL, NULL),
                   ==, QN_OK);
  qn_linsys_always_factor_whole (eq.linsys, true);
  qn_assembly_tangent (&eq.assembly, 0, 0);
  memcpy (eq.step, eq.assembly.live,
          sizeof (double) * (size_t) eq.assembly.unknown_count);
  double factor = least_time (eq.linsys, eq.assembly.ax, NULL, TRUE);
  double solve = least_time (eq.linsys, NULL, eq.step, FALSE);

  QnCentralPath *central = qn_central_path_new (&eq);
  if (qn_equilibrium_newton (&eq, &dead, 0, QN_NEWTON_BUDGET) != QN_SOLVE_CONVERGED)
    g_assert_cmpint (qn_central_path_solve (central, &dead, QN_CENTRAL_BUDGET), ==,
                     QN_SOLVE_CONVERGED);
  qn_equilibrium_commit (&eq);
  double least = G_MAXDOUBLE;
  int factorizations = 0;
  for (int round = 0; round < 3; round++) {
    int before = eq.statistics.factorizations;
    double start = bench_cpu_seconds ();
    QnSolveStatus status = qn_central_path_solve (central, &half, QN_CENTRAL_BUDGET);
    least = MIN (least, bench_cpu_seconds () - start);
    factorizations = eq.statistics.factorizations - before;
    if (status != QN_SOLVE_CONVERGED)
      break;
  }
  double iteration = least / factorizations;
  bench_csv_row (csv, "%s,%zu,%.3f,%.3f,%d,%.3f,%.2f", c->kind, c->blocks, 1e3 * factor,
                 1e3 * solve, factorizations, 1e3 * iteration, iteration / factor);
  qn_central_path_free (central);
  qn_equilibrium_clear (&eq);
}

static void
run_on_walls (FILE *skip, int count, char **sizes)
{
  FILE *csv = bench_csv_open ("iteration", "kind,blocks,factorisation ms,solution ms,"
                                           "factorisations of an increment,"
                                           "iteration ms,iteration/factorisation");
  const ScalingLimits limits = { .path = most_seconds, .limit = most_seconds };
  for (int i = 0; i < count; i++)
    for (int facade = 0; facade < 2; facade++) {
      ScalingCase c;
      int blocks = (int) g_ascii_strtoll (sizes[i], NULL, 10);
      scaling_case_init (&c, blocks, facade);
      scaling_case_detect (&c);
      scaling_case_limit (&c, &limits);
      if (c.limit.done)
        time_iteration (csv, &c, c.limit.multiplier);
      g_autofree char *name = g_strdup_printf (
        "%s %zu%s", c.kind, c.blocks, blocks > largest_path ? " on its way up" : "");
      c.model.analysis.increments = 10;
      c.model.analysis.multiplier_tolerance = 1e-3;
      if (blocks > largest_path && c.limit.done)
        c.model.analysis.max_multiplier = ASCENT * c.limit.multiplier;
      if (blocks <= largest_path || (c.limit.done && blocks <= largest_ascent))
        compare_shortcuts (skip, name, &c.model, &c.contacts);
      scaling_case_clear (&c);
    }
  fclose (csv);
}

/* --- Pairs ------------------------------------------------------------------------------ */

static void
compare_pairs (void)
{
  FILE *csv = bench_csv_open ("pairs", "wall,placement,pairs of a joint,multiplier,"
                                       "off by %,factorisations,s");
  static const int counts[] = { 2, 3, 5, 10, 20 };
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    double reference = NAN;
    for (int i = -1; i < (int) G_N_ELEMENTS (counts); i++) {
      g_auto (QnModel) model;
      g_auto (QnContacts) contacts;
      Run found;
      test_model_init_wall (&model, number, 0.65);
      if (i >= 0)
        model.contact.pairs =
          (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = counts[i] };
      g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
      g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
      run (&model, &contacts, &found);
      if (i < 0)
        reference = multiplier (&found.result);
      bench_csv_row (csv, "%d,%s,%d,%.6f,%.3f,%d,%.4f", number,
                     i < 0 ? "ends" : "uniform", i < 0 ? 2 : counts[i],
                     multiplier (&found.result),
                     100 * (multiplier (&found.result) / reference - 1),
                     found.result.statistics.factorizations, found.seconds);
      qn_result_clear (&found.result);
    }
  }
  fclose (csv);
}

/* --- Single precision ------------------------------------------------------------------- */

/* Largest difference between the displacements under the live load of the tangent as it is and
 * rounded, relative to the largest displacement. */
static double
error_of_rounding (QnEquilibrium *eq)
{
  const QnAssembly *as = &eq->assembly;
  size_t n = (size_t) as->unknown_count, entries = (size_t) as->ap[n];
  double error = 0, size = 0;

  memcpy (eq->step, as->live, n * sizeof (double));
  memcpy (eq->trial, as->live, n * sizeof (double));
  g_assert_cmpint (qn_linsys_factor (eq->linsys, as->ax), ==, QN_FACTOR_OK);
  qn_linsys_solve (eq->linsys, eq->step);
  for (size_t k = 0; k < entries; k++)
    as->ax[k] = (double) (float) as->ax[k];
  if (qn_linsys_factor (eq->linsys, as->ax) != QN_FACTOR_OK)
    return INFINITY;
  qn_linsys_solve (eq->linsys, eq->trial);
  for (size_t i = 0; i < n; i++) {
    size = fmax (size, fabs (eq->step[i]));
    error = fmax (error, fabs (eq->step[i] - eq->trial[i]));
  }
  return error / size;
}

/* The tangent of the central path towards a multiplier, so many factorisations before its end. */
static void
assemble_central_tangent (QnEquilibrium *eq, double multiplier, int before_end)
{
  const QnTarget target = qn_target_multiplier (multiplier);
  QnCentralPath *central = qn_central_path_new (eq);
  int before = eq->statistics.factorizations;
  qn_central_path_solve (central, &target, QN_CENTRAL_BUDGET);
  int count = eq->statistics.factorizations - before;
  qn_central_path_solve (central, &target, MAX (1, count - before_end));
  qn_central_path_free (central);
}

static void
report_precision (FILE *csv, int number, const char *tangent, double at,
                  QnEquilibrium *eq)
{
  bench_csv_row (csv, "%d,%s,%.4f,%.1e", number, tangent, at, error_of_rounding (eq));
}

/* Newton's way up in hundredths of the multiplier of collapse, to the last tangent that has a
 * solution. */
static void
compare_precision (void)
{
  FILE *csv = bench_csv_open ("precision", "wall,tangent,multiplier,error in single");
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    QnModel model;
    QnContacts contacts;
    QnEquilibrium eq;
    prepare_wall (&model, &contacts, number);
    g_assert_cmpint (qn_equilibrium_setup (&eq, &model, &contacts, NULL, NULL, NULL), ==,
                     QN_OK);
    double last = 0;
    for (int part = 0; part < 100; part++) {
      const QnTarget target =
        qn_target_multiplier (0.01 * part * test_walls[number - 1].non_associative);
      if (qn_equilibrium_newton (&eq, &target, 0, 20) != QN_SOLVE_CONVERGED)
        break;
      qn_equilibrium_commit (&eq);
      last = target.multiplier;
      if (part != 0)
        continue;
      qn_assembly_tangent (&eq.assembly, last, 0);
      report_precision (csv, number, "elastic", last, &eq);
      qn_equilibrium_restore (&eq);
    }
    qn_equilibrium_restore (&eq);
    qn_assembly_tangent (&eq.assembly, last, 0);
    report_precision (csv, number, "last of Newton's method", last, &eq);
    qn_equilibrium_restore (&eq);
    assemble_central_tangent (&eq, last, 6);
    report_precision (csv, number, "central path", last, &eq);
    qn_equilibrium_clear (&eq);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
  fclose (csv);
}

int
main (int argc, char **argv)
{
  const GOptionEntry entries[] = {
    { "path", 0, 0, G_OPTION_ARG_INT, &largest_path, "Follow the path up to this size",
      "N" },
    { "ascent", 0, 0, G_OPTION_ARG_INT, &largest_ascent,
      "Follow most of it up to this size", "N" },
    { "seconds", 0, 0, G_OPTION_ARG_DOUBLE, &most_seconds, "Time for each path", "N" },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    fprintf (stderr, "bench-skip: %s\n", error->message);
    return 2;
  }
  FILE *skip = open_shortcuts ();
  compare_precision ();
  compare_pairs ();
  compare_on_six_walls (skip);
  run_on_walls (skip, argc - 1, argv + 1);
  fclose (skip);
  return 0;
}
