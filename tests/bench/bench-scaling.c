/* How the parts of the program grow with the structure: walls in running bond and façades with
 * openings, from 200 to 50,000 blocks.
 *
 *   bench-scaling [--peers N] [--path N] [--procedure P] [--seconds N] [--limit-seconds N]
 *                 [--check] [BLOCKS…]
 *
 * For each: contact detection, beside one factorisation of the elastic stiffness matrix; one
 * elastic solution from nothing; limit analysis by Quoin and, up to --peers blocks, by Clp and by HiGHS (the
 * best of their simplex methods and interior points); up to --path blocks, the path to collapse (multiplier
 * tolerance 1e-3) by the procedure load, work or arc-length. A path or a method of theirs that takes
 * longer than --seconds is stopped; a path then counts with what it has reached, and not for
 * the growth. What is demanded is in scaling-bars.csv; with --check the program fails where a
 * demand on a size that was run is not met. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "bench/scaling-case.h"

#include <locale.h>
#include <math.h>

static int largest_peers = 1800, largest_path = 10000;
static int largest_run; /* of the paths */
static gboolean check;
static ScalingLimits limits = { .path = 300, .limit = 3600, .peers = 300 };

static Chart chart = { .name = "scaling",
                       .title = "Processor time against the number of blocks",
                       .x_label = "Blocks",
                       .x_unit = "",
                       .y_label = "Time (s)" };
static Chart memory = { .name = "scaling-memory",
                        .title = "Most memory against the number of blocks",
                        .x_label = "Blocks",
                        .x_unit = "",
                        .y_label = "Memory (MB)" };

static const char headings[] =
  "kind,blocks,faces,detection s,detection/kernel,factorisation s,"
  "detection/factorisation,elastic s,elastic/kernel,elastic peak MB,limit outcome,"
  "limit s,limit/kernel,limit factorisations,limit multiplier,limit peak MB,path "
  "outcome,path s,path/kernel,path factorisations,path multiplier,path first limit,path "
  "peak MB,Clp s,Clp method,Clp/limit,Clp/path,"
  "HiGHS s,HiGHS method";

static void
add_to_chart (Chart *to, const ScalingCase *c, const char *what, double value)
{
  g_autofree char *label = g_strdup_printf ("%s, %s", what, c->kind);
  if (isfinite (value))
    chart_add (to, label, (double) c->blocks, value);
}

static void
report (FILE *csv, const ScalingCase *c)
{
  const ScalingPart *limit = &c->limit, *path = &c->path;
  bench_csv_row (csv,
                 "%s,%zu,%zu,%.4f,%.3f,%.4f,%.2f,%.4f,%.2f,%.0f,%s,%.3f,%.1f,%d,%.8f,"
                 "%.0f,%s,%.3f,%.1f,%d,%.5f,%.5f,%.0f,%.3f,%s,%.1f,%.1f,%.3f,%s",
                 c->kind, c->blocks, c->faces, c->detection.seconds, c->detection.kernels,
                 c->factorization, c->detection.seconds / c->factorization,
                 c->elastic.seconds, c->elastic.kernels, c->elastic.megabytes,
                 limit->outcome, limit->seconds, limit->kernels, limit->factorizations,
                 limit->multiplier, limit->megabytes, path->outcome, path->seconds,
                 path->kernels, path->factorizations, path->multiplier, c->first_limit,
                 path->megabytes, c->clp.seconds, c->clp.outcome,
                 c->clp.seconds / limit->seconds, c->clp.seconds / path->seconds,
                 c->highs.seconds, c->highs.outcome);
  add_to_chart (&chart, c, "contact detection", c->detection.seconds);
  add_to_chart (&chart, c, "factorisation", c->factorization);
  add_to_chart (&chart, c, "elastic solution", c->elastic.seconds);
  add_to_chart (&chart, c, "Clp", c->clp.seconds);
  add_to_chart (&chart, c, "HiGHS", c->highs.seconds);
  add_to_chart (&memory, c, "elastic solution", c->elastic.megabytes);
  if (limit->done) {
    add_to_chart (&chart, c, "limit analysis", limit->seconds);
    add_to_chart (&memory, c, "limit analysis", limit->megabytes);
  }
  if (path->done) {
    add_to_chart (&chart, c, "path", path->seconds);
    add_to_chart (&memory, c, "path", path->megabytes);
  }
}

/* The demands on one size; what was not asked for is none. */
static gboolean
check_size (FILE *bars, const ScalingCase *c, int wanted)
{
  static const struct {
    int blocks;
    double times;
  } against_clp[] = { { 200, 1 }, { 800, 3 }, { 1800, 10 } };
  g_autofree char *what = g_strdup_printf ("%s of %d", c->kind, wanted);
  gboolean met = TRUE;

  for (size_t i = 0; i < G_N_ELEMENTS (against_clp); i++)
    if (wanted == against_clp[i].blocks && wanted <= largest_path && c->clp.seconds > 0)
      met &= bench_bar (bars, "Clp / path", what,
                        c->path.done ? c->clp.seconds / c->path.seconds : NAN,
                        BENCH_AT_LEAST, against_clp[i].times);
  if (wanted == 10000)
    met &= bench_bar (bars, "memory (MB)", what,
                      fmax (fmax (c->elastic.megabytes, c->limit.megabytes),
                            isnan (c->path.megabytes) ? 0 : c->path.megabytes),
                      BENCH_AT_MOST, 1024);
  if (wanted == 50000)
    met &=
      bench_bar (bars, "limit analysis ends", what, c->limit.done, BENCH_AT_LEAST, 1);
  if (wanted >= 10000 && wanted <= largest_path)
    met &= bench_bar (bars, "path ends", what, c->path.done, BENCH_AT_LEAST, 1);
  return met;
}

static gboolean
run (FILE *csv, FILE *bars, int blocks, gboolean facade)
{
  ScalingCase c;
  scaling_case_init (&c, blocks, facade);
  scaling_case_detect (&c);
  scaling_case_elastic (&c);
  scaling_case_limit (&c, &limits);
  if (blocks <= largest_path) {
    scaling_case_path (&c, &limits);
    largest_run = MAX (largest_run, blocks);
  }
  if (blocks <= largest_peers)
    scaling_case_peers (&c, &limits);
  report (csv, &c);
  gboolean met = check_size (bars, &c, blocks);
  scaling_case_clear (&c);
  return met;
}

/* Growth exponents of every part, and the demand on the path. */
static gboolean
report_exponents (FILE *bars)
{
  static const char *const paths[] = { "path, wall", "path, façade" };
  double least = 800, most = 10000;
  FILE *csv = bench_csv_open ("scaling-exponents", "part,from,to,exponent");
  for (size_t i = 0; i < chart.series_count; i++) {
    const char *label = chart.series[i].label;
    double ends[][2] = { { 800, 10000 }, { 800, 50000 } };
    for (size_t k = 0; k < G_N_ELEMENTS (ends); k++) {
      double exponent = chart_exponent (&chart, label, &ends[k][0], &ends[k][1]);
      if (isfinite (exponent) && (k == 0 || ends[1][1] > 1.5 * ends[0][1]))
        bench_csv_row (csv, "\"%s\",%.0f,%.0f,%.2f", label, ends[k][0], ends[k][1],
                       exponent);
    }
  }
  fclose (csv);

  gboolean met = TRUE;
  for (size_t i = 0; i < G_N_ELEMENTS (paths) && largest_run >= 10000; i++) {
    double from = least, to = most;
    double exponent = chart_exponent (&chart, paths[i], &from, &to);
    gboolean whole = fabs (log (from / least)) < 0.2 && fabs (log (to / most)) < 0.2;
    met &=
      bench_bar (bars, "path: exponent from 800 to 10000", i == 0 ? "wall" : "façade",
                 whole ? exponent : NAN, BENCH_AT_MOST, 1.7);
  }
  return met;
}

static gboolean
parse (int *argc, char ***argv, GError **error)
{
  g_autofree char *procedure = NULL;
  const GOptionEntry entries[] = {
    { "peers", 0, 0, G_OPTION_ARG_INT, &largest_peers,
      "Run Clp and HiGHS up to this size (1800)", "N" },
    { "path", 0, 0, G_OPTION_ARG_INT, &largest_path,
      "Follow the path up to this size (10000)", "N" },
    { "procedure", 0, 0, G_OPTION_ARG_STRING, &procedure, "How the path is led", "P" },
    { "seconds", 0, 0, G_OPTION_ARG_DOUBLE, &limits.path,
      "Time for a path or a method of a peer (300)", "N" },
    { "limit-seconds", 0, 0, G_OPTION_ARG_DOUBLE, &limits.limit,
      "Time for limit analysis (3600)", "N" },
    { "check", 0, 0, G_OPTION_ARG_NONE, &check, "Fail where a demand is not met", NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, argc, argv, error))
    return FALSE;
  limits.peers = limits.path;
  limits.procedure = g_strcmp0 (procedure, "work") == 0         ? QN_PROCEDURE_WORK
                     : g_strcmp0 (procedure, "arc-length") == 0 ? QN_PROCEDURE_ARC_LENGTH
                                                                : QN_PROCEDURE_LOAD;
  return TRUE;
}

int
main (int argc, char **argv)
{
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "C.UTF-8");
  if (!parse (&argc, &argv, &error)) {
    fprintf (stderr, "bench-scaling: %s\n", error->message);
    return 2;
  }
  gboolean met = TRUE;
  FILE *csv = bench_csv_open ("scaling", headings);
  FILE *bars = bench_bars_open ("scaling");
  for (int i = 1; i < argc; i++)
    for (int facade = 0; facade < 2; facade++)
      met &= run (csv, bars, (int) g_ascii_strtoll (argv[i], NULL, 10), facade);
  fclose (csv);
  met &= report_exponents (bars);
  fclose (bars);
  chart_write (&chart);
  chart_write (&memory);
  return met || !check ? 0 : 1;
}
