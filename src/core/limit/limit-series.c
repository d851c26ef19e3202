#include "core/limit/limit-series.h"

#include <string.h>

QnStatus
qn_limit_series_init (QnLimitSeries *series, const QnModel *model,
                      const QnContacts *contacts, QnDiag *diag)
{
  *series = (QnLimitSeries){ 0 };
  QnStatus status = qn_limit_problem_init (&series->limit, model, contacts, false, diag);
  if (!status)
    status = qn_collapse_init (&series->engine, &series->limit.ip, diag);
  if (status)
    qn_limit_series_clear (series);
  return status;
}

void
qn_limit_series_clear (QnLimitSeries *series)
{
  qn_collapse_clear (&series->engine);
  qn_limit_problem_clear (&series->limit);
  *series = (QnLimitSeries){ 0 };
}

static bool
has_same_structure (const QnLimitProblem *a, const QnLimitProblem *b)
{
  const QnIpProblem *p = &a->ip, *q = &b->ip;

  if (p->row_count != q->row_count || p->group_count != q->group_count
      || p->cell_count != q->cell_count || p->bound_count != q->bound_count
      || a->pair_count != b->pair_count || a->block_count != b->block_count)
    return false;
  for (int32_t g = 0; g < p->group_count; g++)
    if (memcmp (&p->groups[g], &q->groups[g], sizeof *p->groups) != 0)
      return false;
  for (int32_t c = 0; c < p->cell_count; c++)
    if (p->cells[c].first_bound != q->cells[c].first_bound
        || p->cells[c].bound_count != q->cells[c].bound_count
        || p->cells[c].no_shear != q->cells[c].no_shear)
      return false;
  return true;
}

QnStatus
qn_limit_series_solve (QnLimitSeries *series, const QnModel *model,
                       const QnContacts *contacts, QnProgressFunc progress,
                       void *user_data, QnLimitSolution *solution, QnDiag *diag)
{
  QnLimitProblem next;
  QnStatus status;

  if (series->limit.ip.row_count == 0)
    return qn_limit_associative (model, contacts, progress, user_data, solution, diag);
  *solution = (QnLimitSolution){ 0 };
  status = qn_limit_problem_init (&next, model, contacts, false, diag);
  if (status)
    return status;
  if (!has_same_structure (&series->limit, &next)) {
    qn_limit_problem_clear (&next);
    return qn_limit_associative (model, contacts, progress, user_data, solution, diag);
  }
  qn_limit_problem_clear (&series->limit);
  series->limit = next; /* the engine's views are of series->limit */
  return qn_limit_solve (&series->limit, &series->engine, true, progress, user_data,
                         solution, diag);
}
