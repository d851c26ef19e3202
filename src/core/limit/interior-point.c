#include "core/limit/interior-point.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void
qn_ip_vector_init (QnIpVector *vector, const QnIpProblem *p, QnPool *pool)
{
  vector->y = qn_pool_alloc (pool, 2 * (size_t) p->cell_count, sizeof (double));
  vector->v = qn_pool_alloc (pool, (size_t) p->row_count, sizeof (double));
  vector->s = qn_pool_alloc (pool, (size_t) p->bound_count, sizeof (double));
  vector->z = qn_pool_alloc (pool, (size_t) p->bound_count, sizeof (double));
}

void
qn_ip_vector_add (QnIpVector *to, double part, const QnIpVector *step,
                  const QnIpProblem *p)
{
  qn_ip_add_multiple (to->y, part, step->y, 2 * p->cell_count);
  qn_ip_add_multiple (to->v, part, step->v, p->row_count);
  qn_ip_add_multiple (to->s, part, step->s, p->bound_count);
  qn_ip_add_multiple (to->z, part, step->z, p->bound_count);
  to->lambda += part * step->lambda;
}

void
qn_ip_add_rates (const QnIpProblem *problem, const double *v, double scale, double *out)
{
  for (int32_t g = 0; g < problem->group_count; g++) {
    const QnIpGroup *group = &problem->groups[g];
    double local[QN_IP_GROUP_ROWS];

    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      local[i] = group->rows[i] >= 0 ? v[group->rows[i]] : 0.0;
    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const QnIpCell *cell = &problem->cells[c];
      double normal = 0.0, shear = 0.0;
      for (int i = 0; i < QN_IP_GROUP_ROWS; i++) {
        normal += cell->map[i][0] * local[i];
        shear += cell->map[i][1] * local[i];
      }
      out[2 * c] += scale * normal;
      if (!cell->no_shear)
        out[2 * c + 1] += scale * shear;
    }
  }
}

void
qn_ip_apply_bounds (const QnIpProblem *p, const double *y, double *out)
{
  for (int32_t c = 0; c < p->cell_count; c++) {
    const QnIpCell *cell = &p->cells[c];
    for (int32_t i = cell->first_bound; i < cell->first_bound + cell->bound_count; i++)
      out[i] = p->bounds[i].normal * y[2 * c] + p->bounds[i].shear * y[2 * c + 1];
  }
}

void
qn_ip_add_flows (const QnIpProblem *p, const double *z, double scale, double *out)
{
  for (int32_t c = 0; c < p->cell_count; c++) {
    const QnIpCell *cell = &p->cells[c];
    for (int32_t i = cell->first_bound; i < cell->first_bound + cell->bound_count; i++) {
      out[2 * c] += scale * p->bounds[i].opening * z[i];
      if (!cell->no_shear)
        out[2 * c + 1] += scale * p->bounds[i].shear * z[i];
    }
  }
}

void
qn_ip_add_multiple (double *values, double factor, const double *step, int32_t count)
{
  for (int32_t i = 0; i < count; i++)
    values[i] += factor * step[i];
}

double
qn_ip_quadratic_term (const QnIpProblem *p, const double *y)
{
  double sum = 0.0;
  for (int32_t c = 0; c < p->cell_count; c++)
    sum += p->cells[c].quadratic[0] * y[2 * c] * y[2 * c]
           + p->cells[c].quadratic[1] * y[2 * c + 1] * y[2 * c + 1];
  return sum;
}

double
qn_ip_limit_term (const QnIpProblem *p, const double *z)
{
  double sum = 0.0;
  for (int32_t i = 0; i < p->bound_count; i++)
    sum += p->bounds[i].limit * z[i];
  return sum;
}

double
qn_ip_largest (const double *values, int32_t count)
{
  double most = 0.0;
  for (int32_t i = 0; i < count; i++) {
    double size = fabs (values[i]);
    if (size > most || isnan (size)) /* nothing is greater than a NaN: it stays */
      most = size;
  }
  return most;
}

void
qn_ip_add_forces (const QnIpProblem *p, const double *y, double scale, double *out)
{
  for (int32_t g = 0; g < p->group_count; g++) {
    const QnIpGroup *group = &p->groups[g];
    double sum[QN_IP_GROUP_ROWS] = { 0 };

    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const QnIpCell *cell = &p->cells[c];
      for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
        sum[i] += cell->map[i][0] * y[2 * c] + cell->map[i][1] * y[2 * c + 1];
    }
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      if (group->rows[i] >= 0)
        out[group->rows[i]] += scale * sum[i];
  }
}

void
qn_ip_balance (const QnIpProblem *p, const double *y, double lambda, double *out)
{
  for (int32_t r = 0; r < p->row_count; r++)
    out[r] = p->constant[r] + (p->load ? lambda * p->load[r] : 0.0);
  qn_ip_add_forces (p, y, 1, out);
}
