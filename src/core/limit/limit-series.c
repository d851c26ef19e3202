#include "core/limit/limit-series.h"

#include <stdlib.h>
#include <string.h>

/* The iterate that analyses start from is the last whose gap is greater than this. Measured on 1,000
 * cases of a wall whose friction varies by 10 % (docs/method/studies.md). */
#define START_GAP 1e-2

/* Iterates until the gap is small, and keeps the last one before. */
static QnStatus
find_start (QnLimitSeries *series, QnIpVector *start, QnDiag *diag)
{
  QnInteriorPoint *ip = &series->ip;
  QnStatus status = qn_interior_point_start (ip, diag);

  ip->measures.gap = 1;
  do {
    status = status ? status : qn_interior_point_keep (ip, start, diag);
    status = status ? status : qn_interior_point_iterate (ip, diag);
  } while (!status && ip->state == QN_IP_RUNNING && ip->measures.gap > START_GAP);
  series->ready = ip->state == QN_IP_RUNNING || ip->state == QN_IP_OPTIMAL;
  return status;
}

QnStatus
qn_limit_series_init (QnLimitSeries *series, const QnModel *model,
                      const QnContacts *contacts, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();

  *series = (QnLimitSeries){ 0 };
  QnStatus status = qn_limit_problem_init (&series->limit, model, contacts, false, diag);
  if (status)
    return status;
  settings.tolerance = QN_LIMIT_TOLERANCE;
  settings.hasten = true;
  status = qn_interior_point_init (&series->ip, &series->limit.ip, &settings, diag);
  QnIpProblem whole = series->limit.ip;

  series->limit.ip.load = NULL;
  series->limit.ip.load_gain = 0;
  if (!status)
    status = find_start (series, &series->start.dead, diag);
  series->limit.ip = whole;
  if (!status && series->ready)
    status = find_start (series, &series->start.whole, diag);
  if (status)
    qn_limit_series_clear (series);
  return status;
}

void
qn_limit_series_clear (QnLimitSeries *series)
{
  qn_ip_vector_clear (&series->start.dead);
  qn_ip_vector_clear (&series->start.whole);
  qn_interior_point_clear (&series->ip);
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

  if (!series->ready)
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
  return qn_limit_solve (&series->limit, &series->ip, true, &series->start, progress,
                         user_data, solution, diag);
}
