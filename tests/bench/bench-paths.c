/* The load path of large walls: seeded ones of six families (support/walls.h), each beside the
 * limit analysis of the same wall.
 *
 *   bench-paths [--seeds FIRST-LAST] [--least N] [--most N] [--increments N] [--tolerance T]
 *               [--time-limit S] [--associative] [--save FOLDER [--only-save]]
 *
 * For each wall: the bound of limit analysis (associative), the multiplier of the path by load
 * control and its first limit point, how it ended, and what both cost in factorisations and
 * processor time. A path that takes longer than the time limit is stopped and counts as
 * cancelled, with the highest multiplier that it has reached. With --associative, dilatancy is
 * friction, and the path should end at the bound. The program fails where a path does not end, or
 * ends above the bound, which nothing may exceed. --save writes every wall as a project file. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "io/project/project.h"
#include "support/auto-clear.h"
#include "support/walls.h"

#include <locale.h>
#include <math.h>

typedef struct Options {
  int first_seed, last_seed, least, most, increments;
  double tolerance, time_limit;
  gboolean associative, only_save;
  char *save;
} Options;

static Chart chart = { .name = "paths",
                       .title = "Seeded walls: processor time of the load path to "
                                "collapse",
                       .x_label = "Blocks",
                       .x_unit = "",
                       .y_label = "Time (s)" };

static Chart ratios = { .name = "paths-ratio",
                        .title = "Seeded walls: the load path in times of the limit "
                                 "analysis of the same wall",
                        .x_label = "Blocks",
                        .x_unit = "",
                        .y_label = "Path / limit analysis" };

/* What all walls together come to. */
typedef struct Totals {
  int walls, ended, above, factorizations;
  double path, limit, ratio_logarithms;
} Totals;

typedef struct Bound {
  QnOutcome outcome;
  double seconds, multiplier;
  int factorizations;
} Bound;

static Bound
run_limit (const QnModel *model, const QnContacts *contacts, double time_limit)
{
  g_auto (QnLimitSolution) solution;
  double start = bench_cpu_seconds (), end = start + time_limit;
  g_assert_cmpint (
    qn_limit_associative (model, contacts, bench_within_time, &end, &solution, NULL), ==,
    QN_OK);
  Bound bound = { .outcome = solution.outcome,
                  .seconds = bench_cpu_seconds () - start,
                  .factorizations = solution.effort.factorizations };
  bound.multiplier = solution.outcome == QN_OUTCOME_COLLAPSE ? solution.upper_bound : NAN;
  return bound;
}

static double
highest_multiplier (const QnResult *result)
{
  double highest = result->has_collapse_multiplier ? result->collapse_multiplier : 0;
  for (size_t i = 0; i < result->step_count; i++)
    highest = fmax (highest, result->steps[i].multiplier);
  return highest;
}

static void
report (FILE *csv, guint32 seed, const QnModel *model, size_t faces, const Bound *bound,
        const QnResult *result, double seconds, Totals *totals)
{
  double tolerance = model->analysis.multiplier_tolerance;
  const char *family = test_wall_family (seed);
  g_autofree char *first_limit =
    result->has_first_limit_multiplier
      ? g_strdup_printf ("%.5f", result->first_limit_multiplier)
      : g_strdup ("");
  double ratio = seconds / bound->seconds, highest = highest_multiplier (result);

  bench_csv_row (
    csv, "%u,%s,%zu,%zu,%.2f,%s,%.6f,%d,%.3f,%.2f,%.6f,%.4f,%s,%s,%zu,%d,%.3f,%.1f,%.2f",
    seed, family, model->block_count, faces, model->laws[0].friction,
    qn_outcome_names[bound->outcome], bound->multiplier, bound->factorizations,
    bound->seconds, bound->seconds / bench_kernel_seconds (), highest,
    highest / bound->multiplier, first_limit, qn_outcome_names[result->outcome],
    result->step_count, result->statistics.factorizations, seconds,
    seconds / bench_kernel_seconds (), ratio);
  chart_add (&chart, family, (double) model->block_count, seconds);
  chart_add (&ratios, family, (double) model->block_count, ratio);
  totals->walls++;
  totals->ended += result->outcome == QN_OUTCOME_COLLAPSE;
  totals->above += highest > (1 + tolerance) * bound->multiplier;
  totals->factorizations += result->statistics.factorizations;
  totals->path += seconds;
  totals->limit += bound->seconds;
  totals->ratio_logarithms += log (ratio);
}

static void
run_path (FILE *csv, guint32 seed, QnModel *model, const Options *options, Totals *totals)
{
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;

  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, &contacts, NULL), ==, QN_OK);
  Bound bound = run_limit (model, &contacts, options->time_limit);
  double start = bench_cpu_seconds (), end = start + options->time_limit;
  g_assert_cmpint (
    qn_analysis_run (model, &contacts, bench_within_time, &end, &result, NULL), ==,
    QN_OK);
  double seconds = bench_cpu_seconds () - start;
  report (csv, seed, model, contacts.face_count, &bound, &result, seconds, totals);
}

static void
save (const QnModel *model, guint32 seed, const char *folder)
{
  const QnProject project = { .model = *model };
  g_autoptr (GError) error = NULL;
  g_autofree char *name = g_strdup_printf ("seed-%u.quoin", seed);
  g_autofree char *path = g_build_filename (folder, name, NULL);
  if (g_mkdir_with_parents (folder, 0777) != 0
      || !qn_project_save (&project, path, &error))
    g_error ("%s: %s", path, error != NULL ? error->message : "no folder");
}

static void
run (FILE *csv, guint32 seed, const Options *options, Totals *totals)
{
  g_auto (QnModel) model;
  test_wall_draw_sized (&model, seed, options->least, options->most);
  model.analysis.increments = options->increments;
  model.analysis.multiplier_tolerance = options->tolerance;
  if (options->associative)
    model.laws[0].dilatancy = model.laws[0].friction;
  if (options->save != NULL)
    save (&model, seed, options->save);
  if (!options->only_save)
    run_path (csv, seed, &model, options, totals);
}

static gboolean
parse (int *argc, char ***argv, Options *options, GError **error)
{
  g_autofree char *seeds = NULL;
  const GOptionEntry entries[] = {
    { "seeds", 0, 0, G_OPTION_ARG_STRING, &seeds, "Which walls (1-20)", "FIRST-LAST" },
    { "least", 0, 0, G_OPTION_ARG_INT, &options->least, "Fewest blocks (800)", "N" },
    { "most", 0, 0, G_OPTION_ARG_INT, &options->most, "Most blocks (5000)", "N" },
    { "increments", 0, 0, G_OPTION_ARG_INT, &options->increments, "Per unit (10)", "N" },
    { "tolerance", 0, 0, G_OPTION_ARG_DOUBLE, &options->tolerance,
      "Of the multiplier (1e-3)", "T" },
    { "time-limit", 0, 0, G_OPTION_ARG_DOUBLE, &options->time_limit,
      "Processor time of a path, s (120)", "S" },
    { "associative", 0, 0, G_OPTION_ARG_NONE, &options->associative,
      "Dilatancy = friction", NULL },
    { "save", 0, 0, G_OPTION_ARG_FILENAME, &options->save, "Write the walls there",
      "FOLDER" },
    { "only-save", 0, 0, G_OPTION_ARG_NONE, &options->only_save, "and do nothing else",
      NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, argc, argv, error))
    return FALSE;
  if ((seeds != NULL
       && !test_wall_parse_seeds (seeds, &options->first_seed, &options->last_seed))
      || options->least < 10 || options->most < options->least || options->increments < 1
      || !(options->tolerance > 0)) {
    g_set_error (error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                 "seeds from 1, sizes from 10, increments and tolerance positive");
    return FALSE;
  }
  return TRUE;
}

int
main (int argc, char **argv)
{
  Options options = { .first_seed = 1,
                      .last_seed = 20,
                      .least = 800,
                      .most = 5000,
                      .increments = 10,
                      .tolerance = 1e-3,
                      .time_limit = 120 };
  Totals totals = { 0 };
  g_autoptr (GError) error = NULL;

  setlocale (LC_ALL, "C.UTF-8");
  if (!parse (&argc, &argv, &options, &error)) {
    fprintf (stderr, "bench-paths: %s\n", error->message);
    return 2;
  }
  FILE *csv = bench_csv_open (
    "paths",
    "seed,family,blocks,faces,friction,limit outcome,limit multiplier,limit "
    "factorisations,"
    "limit s,limit/kernel,path multiplier,path/bound,path first limit,path outcome,steps,"
    "path factorisations,path s,path/kernel,path/limit");
  for (int seed = options.first_seed; seed <= options.last_seed; seed++)
    run (csv, (guint32) seed, &options, &totals);
  fclose (csv);
  if (totals.walls > 0) {
    printf ("%d of %d paths end in collapse, %d above the bound; %d factorisations, %.1f "
            "s (%.0f kernels), "
            "limit analysis %.1f s; a path takes %.1f times the limit analysis "
            "(geometric mean)\n",
            totals.ended, totals.walls, totals.above, totals.factorizations, totals.path,
            totals.path / bench_kernel_seconds (), totals.limit,
            exp (totals.ratio_logarithms / totals.walls));
    chart_write (&chart);
    chart_write (&ratios);
  }
  g_free (options.save);
  return totals.ended == totals.walls && totals.above == 0 ? 0 : 1;
}
