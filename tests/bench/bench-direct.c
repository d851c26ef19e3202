/* Collapse without associativity, found directly, of seeded walls (seeded-walls.h): answers, and what
 * they cost.
 *
 *     bench-direct [FIRST-LAST [LEAST MOST]]      seeds (1-48), fewest and most blocks (20 600) */
#include "bench/bench.h"
#include "bench/seeded-walls.h"
#include "core/limit/limit.h"
#include "support/auto-clear.h"

#include <math.h>

int
main (int argc, char **argv)
{
  int first = 1, last = 48, least = 20, most = 600, found = 0, walls = 0, work = 0;

  if (argc > 1 && !seeded_wall_parse_range (argv[1], &first, &last))
    return 2;
  if (argc > 3) {
    least = atoi (argv[2]);
    most = atoi (argv[3]);
  }
  for (int seed = first; seed <= last; seed++) {
    g_auto (QnProject) project;
    g_auto (QnContacts) contacts;
    QnLimitInterval interval;
    seeded_wall_init (&project, (guint32) seed, least, most);
    g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
    double start = bench_cpu_seconds ();
    g_assert_cmpint (
      qn_limit_non_associative (&project.model, &contacts, NULL, NULL, &interval, NULL),
      ==, QN_OK);
    walls++;
    found += interval.solution.outcome == QN_OUTCOME_COLLAPSE;
    work += interval.solution.effort.factorizations;
    printf ("%4d %-8s %5zu %-20s %.6f bound %.6f count %d factorisations %4d %.2f s\n",
            seed, seeded_wall_family ((guint32) seed), project.model.block_count,
            qn_outcome_names[interval.solution.outcome], interval.solution.lower_bound,
            interval.associative, interval.count, interval.solution.effort.factorizations,
            bench_cpu_seconds () - start);
    fflush (stdout);
    qn_limit_interval_clear (&interval);
  }
  printf ("%d of %d found, %.1f factorisations in the mean\n", found, walls,
          (double) work / walls);
  return 0;
}
