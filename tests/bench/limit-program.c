#include "bench/limit-program.h"

#include "bench/bench.h"

#include <glib.h>
#include <math.h>

const LimitPeer limit_peers[] = {
#ifdef HAVE_CLP
  { "Clp", "barrier", clp_solve, 0 },
  { "Clp", "dual simplex", clp_solve, 1 },
  { "Clp", "primal simplex", clp_solve, 2 },
#endif
#ifdef HAVE_HIGHS
  { "HiGHS", "interior point", highs_solve, 0 },
  { "HiGHS", "simplex", highs_solve, 1 },
#endif
  { NULL, NULL, NULL, 0 },
};

/* Columns: for every cell n = -(a + b) / (2 mu), t = (a - b) / 2 with a, b >= 0, which is what
 * mu n +- t <= 0 says; then lambda. */
typedef struct Columns {
  GArray *rows, *values, *starts;
  GArray *lower, *upper, *cost;
} Columns;

static void
add_entry (Columns *columns, int row, double value)
{
  if (row < 0 || value == 0)
    return;
  g_array_append_val (columns->rows, row);
  g_array_append_val (columns->values, value);
}

static void
end_column (Columns *columns, double lower, double cost)
{
  int end = (int) columns->rows->len;
  g_array_append_val (columns->starts, end);
  double upper = INFINITY;
  g_array_append_val (columns->lower, lower);
  g_array_append_val (columns->upper, upper);
  g_array_append_val (columns->cost, cost);
}

static void
add_cell (Columns *columns, const QnIpProblem *ip, const QnIpGroup *group, int32_t c)
{
  const QnIpCell *cell = &ip->cells[c];
  const QnIpBound *bound = &ip->bounds[cell->first_bound];

  g_assert_cmpint (cell->bound_count, ==, 2);
  double friction = bound->normal / fabs (bound->shear);
  for (int sign = -1; sign <= 1; sign += 2) {
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      add_entry (columns, group->rows[i],
                 -cell->map[i][0] / (2 * friction) + sign * cell->map[i][1] / 2);
    end_column (columns, 0, 0);
  }
}

static Columns
build (const QnIpProblem *ip)
{
  int zero = 0;
  Columns columns = { g_array_new (FALSE, FALSE, sizeof (int)),
                      g_array_new (FALSE, FALSE, sizeof (double)),
                      g_array_new (FALSE, FALSE, sizeof (int)),
                      g_array_new (FALSE, FALSE, sizeof (double)),
                      g_array_new (FALSE, FALSE, sizeof (double)),
                      g_array_new (FALSE, FALSE, sizeof (double)) };
  g_array_append_val (columns.starts, zero);
  for (int32_t g = 0; g < ip->group_count; g++)
    for (int32_t c = 0; c < ip->groups[g].cell_count; c++)
      add_cell (&columns, ip, &ip->groups[g], ip->groups[g].first_cell + c);
  for (int32_t r = 0; r < ip->row_count; r++)
    add_entry (&columns, r, ip->load[r]);
  end_column (&columns, -INFINITY, 1);
  return columns;
}

static void
columns_free (Columns *columns)
{
  g_array_unref (columns->rows);
  g_array_unref (columns->values);
  g_array_unref (columns->starts);
  g_array_unref (columns->lower);
  g_array_unref (columns->upper);
  g_array_unref (columns->cost);
}

double
limit_peer_solve (const LimitPeer *peer, const QnLimitProblem *limit, double seconds,
                  double *spent)
{
  const QnIpProblem *ip = &limit->ip;
  Columns columns = build (ip);
  g_autofree double *right = g_new (double, ip->row_count);
  for (int32_t r = 0; r < ip->row_count; r++)
    right[r] = -ip->constant[r];
  LimitProgram program = { .row_count = ip->row_count,
                           .column_count = (int) columns.cost->len,
                           .starts = (int *) columns.starts->data,
                           .rows = (int *) columns.rows->data,
                           .values = (double *) columns.values->data,
                           .lower = (double *) columns.lower->data,
                           .upper = (double *) columns.upper->data,
                           .cost = (double *) columns.cost->data,
                           .right = right };
  double start = bench_cpu_seconds ();
  double found = peer->solve (&program, peer->number, seconds);
  *spent = bench_cpu_seconds () - start;
  columns_free (&columns);
  return isnan (found) ? found : qn_limit_problem_multiplier (limit, found);
}
