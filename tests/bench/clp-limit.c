#include "bench/clp-limit.h"

#include "bench/bench.h"

#include <coin/Clp_C_Interface.h>
#include <float.h>
#include <glib.h>
#include <math.h>

const char *
clp_method_name (ClpMethod method)
{
  static const char *const names[CLP_METHOD_COUNT] = { "dual simplex", "primal simplex",
                                                       "barrier" };
  return names[method];
}

/* Columns: for every cell n = -(a + b) / (2 mu), t = (a - b) / 2 with a, b >= 0, which is what
 * mu n +- t <= 0 says; then lambda. */
typedef struct Columns {
  GArray *rows, *values, *starts;
  GArray *lower, *cost;
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
  CoinBigIndex end = (CoinBigIndex) columns->rows->len;
  g_array_append_val (columns->starts, end);
  g_array_append_val (columns->lower, lower);
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
  CoinBigIndex zero = 0;
  Columns columns = { g_array_new (FALSE, FALSE, sizeof (int)),
                      g_array_new (FALSE, FALSE, sizeof (double)),
                      g_array_new (FALSE, FALSE, sizeof (CoinBigIndex)),
                      g_array_new (FALSE, FALSE, sizeof (double)),
                      g_array_new (FALSE, FALSE, sizeof (double)) };
  g_array_append_val (columns.starts, zero);
  for (int32_t g = 0; g < ip->group_count; g++)
    for (int32_t c = 0; c < ip->groups[g].cell_count; c++)
      add_cell (&columns, ip, &ip->groups[g], ip->groups[g].first_cell + c);
  for (int32_t r = 0; r < ip->row_count; r++)
    add_entry (&columns, r, ip->load[r]);
  end_column (&columns, -DBL_MAX, 1);
  return columns;
}

static void
columns_free (Columns *columns)
{
  g_array_unref (columns->rows);
  g_array_unref (columns->values);
  g_array_unref (columns->starts);
  g_array_unref (columns->lower);
  g_array_unref (columns->cost);
}

double
clp_limit_solve (const QnLimitProblem *limit, ClpMethod method, double seconds,
                 double *spent)
{
  const QnIpProblem *ip = &limit->ip;
  Columns columns = build (ip);
  g_autofree double *right = g_new (double, ip->row_count);
  Clp_Simplex *model = Clp_newModel ();
  double multiplier = NAN;

  for (int32_t r = 0; r < ip->row_count; r++)
    right[r] = -ip->constant[r];
  Clp_setLogLevel (model, 0);
  Clp_loadProblem (model, (int) columns.cost->len, ip->row_count,
                   (CoinBigIndex *) columns.starts->data, (int *) columns.rows->data,
                   (double *) columns.values->data, (double *) columns.lower->data, NULL,
                   (double *) columns.cost->data, right, right);
  Clp_setObjSense (model, -1);
  /* The default 1e-7 stops short of the optimum where forces are large. */
  Clp_setDualTolerance (model, 1e-9);
  Clp_setPrimalTolerance (model, 1e-9);
  Clp_setMaximumSeconds (model, seconds);
  double start = bench_cpu_seconds ();
  if (method == CLP_DUAL)
    Clp_initialDualSolve (model);
  else if (method == CLP_PRIMAL)
    Clp_initialPrimalSolve (model);
  else
    Clp_initialBarrierNoCrossSolve (model);
  *spent = bench_cpu_seconds () - start;
  if (Clp_status (model) == 0)
    multiplier = qn_limit_problem_multiplier (limit, Clp_objectiveValue (model));
  Clp_deleteModel (model);
  columns_free (&columns);
  return multiplier;
}
