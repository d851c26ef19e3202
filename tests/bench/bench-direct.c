/* Collapse without associativity, found directly, of seeded walls (support/walls.h): answers, and what
 * they cost, beside the load path of the same wall.
 *
 *     bench-direct [FIRST-LAST [LEAST MOST [path]]]    seeds (1-48), fewest and most blocks (20 600)
 *     bench-direct wall|facade BLOCKS...               those of scaling-case.h, beside the associative program */
#include "bench/bench.h"
#include "bench/scaling-case.h"
#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "support/auto-clear.h"
#include "support/walls.h"

#include <math.h>

/* The rest of the line: the path of the project as it is, by load control. */
static void
tell_path (const QnModel *model, const QnContacts *contacts, int *work, double *seconds)
{
  g_auto (QnResult) result;
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_analysis_run (model, contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  double took = bench_cpu_seconds () - start;
  *work += result.statistics.factorizations;
  *seconds += took;
  printf (" path %-20s %.6f factorisations %5d %.2f s", qn_outcome_names[result.outcome],
          result.collapse_multiplier, result.statistics.factorizations, took);
}

/* Walls and façades of about so many blocks. */
static int
tell_large (gboolean facade, char **sizes)
{
  for (; *sizes != NULL; sizes++) {
    ScalingCase c;
    QnLimitSolution interval;
    const ScalingLimits limits = { .limit = INFINITY };
    scaling_case_init (&c, atoi (*sizes), facade);
    scaling_case_detect (&c);
    scaling_case_limit (&c, &limits);
    c.model.analysis.multiplier_tolerance = 1e-4;
    bench_reset_peak ();
    double start = bench_cpu_seconds ();
    g_assert_cmpint (qn_limit_non_associative (&c.model, &c.contacts, INFINITY, NULL,
                                               NULL, &interval, NULL),
                     ==, QN_OK);
    printf (
      "%s %zu %s %.6f factorisations %d %.2f s %.0f MB associative %.6f %d %.2f s\n",
      c.kind, c.blocks, qn_outcome_names[interval.outcome], interval.lower_bound,
      interval.effort.factorizations, bench_cpu_seconds () - start,
      bench_peak_megabytes (), c.limit.multiplier, c.limit.factorizations,
      c.limit.seconds);
    fflush (stdout);
    qn_limit_solution_clear (&interval);
    scaling_case_clear (&c);
  }
  return 0;
}

int
main (int argc, char **argv)
{
  int first = 1, last = 48, least = 20, most = 600, found = 0, walls = 0, work = 0;
  int path_work = 0;
  double seconds = 0, path_seconds = 0;

  if (argc > 1 && (g_str_equal (argv[1], "wall") || g_str_equal (argv[1], "facade")))
    return tell_large (argv[1][0] == 'f', argv + 2);
  if (argc > 1 && !test_wall_parse_seeds (argv[1], &first, &last))
    return 2;
  if (argc > 3) {
    least = atoi (argv[2]);
    most = atoi (argv[3]);
  }
  for (int seed = first; seed <= last; seed++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    QnLimitSolution interval;
    test_wall_draw_sized (&model, (guint32) seed, least, most);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (
      qn_limit_non_associative (&model, &contacts, INFINITY, NULL, NULL, &interval, NULL),
      ==, QN_OK);
    walls++;
    found += interval.outcome == QN_OUTCOME_COLLAPSE;
    work += interval.effort.factorizations;
    double took = bench_cpu_seconds () - start;
    seconds += took;
    printf ("%4d %-8s %5zu %-20s %.6f bound %.6f count %d factorisations %4d %.2f s",
            seed, test_wall_family ((guint32) seed), model.block_count,
            qn_outcome_names[interval.outcome], interval.lower_bound,
            interval.associative, interval.count, interval.effort.factorizations, took);
    if (argc > 4)
      tell_path (&model, &contacts, &path_work, &path_seconds);
    printf ("\n");
    fflush (stdout);
    qn_limit_solution_clear (&interval);
  }
  printf ("%d of %d found, %.1f factorisations and %.3f s in the mean\n", found, walls,
          (double) work / walls, seconds / walls);
  if (argc > 4)
    printf ("path: %.1f factorisations and %.3f s in the mean\n",
            (double) path_work / walls, path_seconds / walls);
  return 0;
}
