/* How the parts of the program grow with the structure: walls in running bond and façades with
 * openings, from 200 to 50,000 blocks.
 *
 *   bench-scaling [--clp N] [--path N] [--procedure P] [--seconds N] [BLOCKS…]
 *
 * For each: contact detection, beside one factorisation of the elastic stiffness matrix; limit
 * analysis by Quoin and, up to --clp blocks, by Clp (the best of its simplex methods and its
 * barrier); up to --path blocks, the path to collapse (multiplier tolerance 1e-3) by the procedure
 * load, work or arc-length. Whatever takes longer than --seconds is stopped; a path then counts
 * with what it has reached. */
#include "bench/bench.h"
#include "core/analysis.h"
#include "core/equilibrium.h"
#include "core/generate.h"
#include "core/limit.h"

#include <locale.h>
#include <math.h>

#ifdef HAVE_CLP
#include "bench/clp-limit.h"
#endif

static int largest_clp = 800, largest_path = 800;
static double most_seconds = 300;
static QnProcedure procedure = QN_PROCEDURE_LOAD;

static BenchChart chart = { .name = "scaling",
                            .title = "Processor time against the number of blocks",
                            .x_label = "Blocks",
                            .x_unit = "",
                            .y_label = "Time (s)" };

/* A structure and what was measured on it; times in s, NAN where nothing was. */
typedef struct Case {
  const char *kind;
  QnModel model;
  QnContacts contacts;
  double detect, factorize;
  double limit, limit_multiplier, limit_memory;
  int limit_factorizations;
  double path, path_multiplier, path_memory;
  int path_factorizations;
  const char *path_outcome;
  double clp;
  const char *clp_method;
} Case;

/* About `blocks` blocks, as wide as high; a façade has an opening for every 60 of them. */
static void
build (Case *c, int blocks, gboolean facade)
{
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = (int32_t) lround (sqrt (blocks * recipe.unit.y / recipe.unit.x));
  recipe.courses = (int32_t) lround ((double) blocks / (recipe.length + 0.5));
  recipe.openings = facade ? blocks / 60 : 0;
  recipe.seed = 7;
  *c = (Case){ .kind = facade ? "façade" : "wall",
               .path = NAN,
               .path_multiplier = NAN,
               .path_memory = NAN,
               .path_outcome = "",
               .clp = NAN,
               .clp_method = "" };
  qn_model_init (&c->model);
  g_assert_cmpint (qn_generate_wall (&c->model, &recipe, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
}

static void
time_detection (Case *c)
{
  c->detect = G_MAXDOUBLE;
  for (int round = 0; round < 3; round++) {
    if (round > 0)
      qn_contacts_clear (&c->contacts);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
    c->detect = MIN (c->detect, bench_cpu_seconds () - start);
  }
}

/* One factorisation of the stiffness matrix of the undeformed structure, after the symbolic
 * analysis. */
static void
time_factorization (Case *c)
{
  QnEquilibrium eq;
  g_assert_cmpint (qn_equilibrium_setup (&eq, &c->model, &c->contacts, NULL, NULL, NULL),
                   ==, QN_OK);
  c->factorize = G_MAXDOUBLE;
  qn_assembly_evaluate (&eq.assembly, eq.u);
  for (int round = 0; round < 2; round++) {
    qn_assembly_tangent (&eq.assembly, 0, 0);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_linsys_factor (eq.linsys, eq.assembly.ax), ==, QN_FACTOR_OK);
    c->factorize = MIN (c->factorize, bench_cpu_seconds () - start);
  }
  qn_equilibrium_clear (&eq);
}

static void
time_limit (Case *c)
{
  QnLimitSolution solution;
  double start = bench_cpu_seconds (), end = start + most_seconds;
  bench_reset_peak ();
  g_assert_cmpint (qn_limit_associative (&c->model, &c->contacts, bench_within_time, &end,
                                         &solution, NULL),
                   ==, QN_OK);
  c->limit = bench_cpu_seconds () - start;
  c->limit_memory = bench_peak_megabytes ();
  c->limit_factorizations = solution.effort.factorizations;
  c->limit_multiplier =
    solution.outcome == QN_OUTCOME_COLLAPSE ? solution.lower_bound : NAN;
  qn_limit_solution_clear (&solution);
}

static void
time_path (Case *c)
{
  QnResult result;
  double start = bench_cpu_seconds (), end = start + most_seconds;
  c->model.analysis.procedure = procedure;
  c->model.analysis.increments = 10;
  c->model.analysis.multiplier_tolerance = 1e-3;
  bench_reset_peak ();
  g_assert_cmpint (
    qn_analysis_run (&c->model, &c->contacts, bench_within_time, &end, &result, NULL), ==,
    QN_OK);
  c->path = bench_cpu_seconds () - start;
  c->path_memory = bench_peak_megabytes ();
  c->path_factorizations = result.statistics.factorizations;
  c->path_outcome = qn_outcome_name (result.outcome);
  c->path_multiplier = result.has_collapse_multiplier ? result.collapse_multiplier
                       : result.step_count > 0
                         ? result.steps[result.step_count - 1].multiplier
                         : 0;
  qn_result_clear (&result);
}

#ifdef HAVE_CLP
/* The best of Clp's methods; what does not end in time counts with the time given. */
static void
time_clp (Case *c)
{
  static const ClpMethod order[] = { CLP_PRIMAL, CLP_BARRIER, CLP_DUAL };
  QnLimitProblem limit;
  g_assert_cmpint (qn_limit_problem_init (&limit, &c->model, &c->contacts, false, NULL),
                   ==, QN_OK);
  for (size_t i = 0; i < G_N_ELEMENTS (order); i++) {
    double spent;
    /* Nobody waits for a method that is slower than the best one already. */
    double budget = fmin (most_seconds, c->clp > 0 ? 1.2 * c->clp + 1 : most_seconds);
    double found = clp_limit_solve (&limit, order[i], budget, &spent);
    if (isnan (found))
      continue;
    g_assert_cmpfloat_with_epsilon (found, c->limit_multiplier, 1e-6);
    if (!(spent >= c->clp)) {
      c->clp = spent;
      c->clp_method = clp_method_name (order[i]);
    }
  }
  qn_limit_problem_clear (&limit);
}
#endif

static void
add_to_chart (const Case *c, const char *what, double seconds)
{
  g_autofree char *label = g_strdup_printf ("%s, %s", what, c->kind);
  if (isfinite (seconds))
    bench_chart_add (&chart, label, (double) c->model.block_count, seconds);
}

static void
report (FILE *csv, const Case *c)
{
  double kernel = bench_kernel_seconds ();
  bench_csv_row (csv,
                 "%s,%zu,%zu,%.4f,%.4f,%.2f,%.3f,%.1f,%d,%.8f,%.0f,%.3f,%.1f,%d,%.5f,%s,"
                 "%.0f,%.3f,%s,%.1f,%.1f",
                 c->kind, c->model.block_count - 1, c->contacts.face_count, c->detect,
                 c->factorize, c->detect / c->factorize, c->limit, c->limit / kernel,
                 c->limit_factorizations, c->limit_multiplier, c->limit_memory, c->path,
                 c->path / kernel, c->path_factorizations, c->path_multiplier,
                 c->path_outcome, c->path_memory, c->clp, c->clp_method,
                 c->clp / c->limit, c->clp / c->path);
  add_to_chart (c, "contact detection", c->detect);
  add_to_chart (c, "factorisation", c->factorize);
  add_to_chart (c, "limit analysis", c->limit);
  add_to_chart (c, "path", c->path);
  add_to_chart (c, "Clp", c->clp);
}

static void
run (FILE *csv, int blocks, gboolean facade)
{
  Case c;
  build (&c, blocks, facade);
  time_detection (&c);
  time_factorization (&c);
  time_limit (&c);
  if (blocks <= largest_path)
    time_path (&c);
#ifdef HAVE_CLP
  if (blocks <= largest_clp)
    time_clp (&c);
#endif
  report (csv, &c);
  qn_contacts_clear (&c.contacts);
  qn_model_clear (&c.model);
}

static void
report_exponents (void)
{
  FILE *csv = bench_csv_open ("scaling-exponents", "part,from 800 to 10000 blocks");
  for (size_t i = 0; i < chart.series_count; i++) {
    const char *label = chart.series[i].label;
    bench_csv_row (csv, "\"%s\",%.2f", label,
                   bench_chart_exponent (&chart, label, 800, 10000));
  }
  fclose (csv);
}

int
main (int argc, char **argv)
{
  g_autofree char *procedure_name = NULL;
  const GOptionEntry entries[] = {
    { "clp", 0, 0, G_OPTION_ARG_INT, &largest_clp, "Run Clp up to this size", "N" },
    { "path", 0, 0, G_OPTION_ARG_INT, &largest_path, "Follow the path up to this size",
      "N" },
    { "procedure", 0, 0, G_OPTION_ARG_STRING, &procedure_name, "How the path is led",
      "P" },
    { "seconds", 0, 0, G_OPTION_ARG_DOUBLE, &most_seconds, "Time for each part", "N" },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    fprintf (stderr, "bench-scaling: %s\n", error->message);
    return 2;
  }
  if (g_strcmp0 (procedure_name, "work") == 0)
    procedure = QN_PROCEDURE_WORK;
  else if (g_strcmp0 (procedure_name, "arc-length") == 0)
    procedure = QN_PROCEDURE_ARC_LENGTH;
  FILE *csv = bench_csv_open (
    "scaling",
    "kind,blocks,faces,detection s,factorisation s,detection/factorisation,limit "
    "s,limit/kernel,limit factorisations,limit multiplier,limit peak MB,path s,"
    "path/kernel,path factorisations,path multiplier,path outcome,path peak MB,Clp "
    "s,Clp method,Clp/limit,Clp/path");
  for (int i = 1; i < argc; i++)
    for (int facade = 0; facade < 2; facade++)
      run (csv, (int) g_ascii_strtoll (argv[i], NULL, 10), facade);
  fclose (csv);
  report_exponents ();
  bench_chart_write (&chart);
  return 0;
}
