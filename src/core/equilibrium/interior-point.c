#include "core/equilibrium/interior-point.h"

#include "core/base/numbers.h"

#include <math.h>
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
qn_ip_vector_copy (QnIpVector *to, const QnIpVector *from, const QnIpProblem *p)
{
  memcpy (to->y, from->y, 2 * (size_t) p->cell_count * sizeof (double));
  memcpy (to->v, from->v, (size_t) p->row_count * sizeof (double));
  memcpy (to->s, from->s, (size_t) p->bound_count * sizeof (double));
  memcpy (to->z, from->z, (size_t) p->bound_count * sizeof (double));
  to->lambda = from->lambda;
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
    double normal = out[2 * c], shear = out[2 * c + 1];
    for (int32_t i = cell->first_bound; i < cell->first_bound + cell->bound_count; i++) {
      normal += scale * p->bounds[i].opening * z[i];
      shear += scale * p->bounds[i].shear * z[i];
    }
    out[2 * c] = normal;
    if (!cell->no_shear)
      out[2 * c + 1] = shear;
  }
}

void
qn_ip_add_multiple (double *values, double factor, const double *step, int32_t count)
{
  for (int32_t i = 0; i < count; i++)
    values[i] += factor * step[i];
}

double
qn_ip_largest (const double *values, int32_t count)
{
  double most = 0.0;
  for (int32_t i = 0; i < count; i++)
    most = qn_worse (most, fabs (values[i]));
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
qn_ip_step_init (QnIpStep *ip, const QnIpProblem *p, const QnIpTuning *tuning,
                 QnPool *pool)
{
  size_t cells = (size_t) p->cell_count, bounds = (size_t) p->bound_count;

  ip->problem = p;
  ip->tuning = tuning;
  qn_ip_vector_init (&ip->at, p, pool);
  qn_ip_vector_init (&ip->step, p, pool);
  qn_ip_vector_init (&ip->trial, p, pool);
  ip->ry = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  ip->right = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  ip->rz = qn_pool_alloc (pool, bounds, sizeof (double));
  ip->products = qn_pool_alloc (pool, bounds, sizeof (double));
  ip->w = qn_pool_alloc (pool, bounds, sizeof (double));
  ip->inverse = (QnIpInverse){ .cells = qn_pool_alloc (pool, 4 * cells, sizeof (double)),
                               .axes = qn_pool_alloc (pool, 2 * cells, sizeof (double)),
                               .turns = qn_pool_alloc (pool, bounds, sizeof (double)),
                               .normals = qn_pool_alloc (pool, bounds, sizeof (double)),
                               .coupling = 1 };
}

void
qn_ip_step_measure (QnIpStep *ip)
{
  const QnIpProblem *p = ip->problem;

  qn_ip_apply_bounds (p, ip->at.y, ip->rz);
  for (int32_t i = 0; i < p->bound_count; i++)
    ip->rz[i] = p->bounds[i].limit - ip->at.s[i] - ip->rz[i];
  ip->power = qn_dot (ip->at.s, ip->at.z, (size_t) p->bound_count);
}

void
qn_ip_step_weights (QnIpStep *ip)
{
  for (int32_t i = 0; i < ip->problem->bound_count; i++)
    ip->w[i] = ip->at.z[i] / (ip->at.s[i] + ip->proximal * ip->at.z[i]);
}

/* The direction that takes `share` off the residuals and has ip->products as s dz + z ds. */
static void
solve_for_share (QnIpStep *ip, double share, QnIpVector *out)
{
  const QnIpProblem *p = ip->problem;
  const double *s = ip->at.s, *z = ip->at.z, proximal = ip->proximal;

  for (int32_t i = 0; i < p->bound_count; i++)
    out->z[i] = (ip->products[i] - z[i] * share * ip->rz[i]) / (s[i] + proximal * z[i]);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    ip->right[i] = share * ip->ry[i];
  qn_ip_add_flows (p, out->z, -1, ip->right);
  ip->solve (ip, share, out);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = share * ip->rz[i] - out->s[i];
    out->z[i] = (ip->products[i] - z[i] * left) / (s[i] + proximal * z[i]);
    out->s[i] = left + proximal * out->z[i];
  }
}

/* How often the step can be made until some s or z vanishes. */
static double
way_to_boundary (const QnIpStep *ip, const QnIpVector *step)
{
  double most = 1e-300;

  for (int32_t i = 0; i < ip->problem->bound_count; i++) {
    if (-step->s[i] > most * ip->at.s[i])
      most = -step->s[i] / ip->at.s[i];
    if (-step->z[i] > most * ip->at.z[i])
      most = -step->z[i] / ip->at.z[i];
  }
  return 1 / most;
}

double
qn_ip_step_find (QnIpStep *ip, double *part)
{
  const QnIpTuning *tuning = ip->tuning;
  const QnIpVector *at = &ip->at;
  QnIpVector *step = &ip->step;
  int32_t bounds = ip->problem->bound_count;
  double left = 0;

  for (int32_t i = 0; i < bounds; i++)
    ip->products[i] = -at->s[i] * at->z[i];
  solve_for_share (ip, 1, step);
  double whole = fmin (1, way_to_boundary (ip, step));
  for (int32_t i = 0; i < bounds; i++)
    left += (at->s[i] + whole * step->s[i]) * (at->z[i] + whole * step->z[i]);
  *part = fmax (tuning->least_aim,
                ip->power > 0 ? pow (left / ip->power, tuning->exponent) : 0);
  double share = ip->together ? 1 - *part : 1;
  double target = *part * ip->power / bounds;
  double low = target / tuning->spread, high = target * tuning->spread;
  for (int32_t i = 0; i < bounds; i++)
    ip->products[i] = target - at->s[i] * at->z[i] - step->s[i] * step->z[i];
  solve_for_share (ip, share, step);
  double length = way_to_boundary (ip, step);
  for (int32_t k = 0; k < tuning->correctors && length < tuning->full_step; k++) {
    double aim = fmin (1, 1.3 * length + 0.1);
    for (int32_t i = 0; i < bounds; i++) { /* back into the neighbourhood of the target */
      double product = (at->s[i] + aim * step->s[i]) * (at->z[i] + aim * step->z[i]);
      ip->products[i] += fmax (low - product, 0) + fmax (fmin (high - product, 0), -high);
    }
    solve_for_share (ip, share, &ip->trial);
    double reached = way_to_boundary (ip, &ip->trial);
    if (reached < length + tuning->gain)
      break;
    QnIpVector found = ip->trial;
    ip->trial = *step;
    *step = found;
    length = reached;
  }
  return length;
}

/* Every term a sum without cancellation however different the weights: the determinant by Cauchy and Binet,
 * det = sum_{i<j} w_i w_j (f_i x f_j) (g_i x g_j), the adjugate by turning rows and flows by a right
 * angle, adj H = sum_j w_j g_j^ f_j^'. Q and the regularisation count as rows along the axes. */
void
qn_ip_step_invert (QnIpStep *ip, int32_t c)
{
  const QnIpInverse *inverse = &ip->inverse;
  const QnIpCell *cell = &ip->problem->cells[c];
  const QnIpBound *bounds = ip->problem->bounds + cell->first_bound;
  const double *w = ip->w + cell->first_bound;
  double axis_n = cell->quadratic[0] + inverse->regularization;
  double axis_t = cell->quadratic[1] + inverse->regularization;
  double nn = axis_n, nt = 0.0, tn = 0.0, tt = axis_t, determinant = axis_n * axis_t;
  double *found = inverse->cells + 4 * (size_t) c, *axes = inverse->axes + 2 * (size_t) c;
  double *turns = inverse->turns + cell->first_bound;
  double *normals = inverse->normals + cell->first_bound;

  for (int32_t i = 0; i < cell->bound_count; i++) {
    const QnIpBound *b = &bounds[i];
    double normal = b->opening + inverse->coupling * (b->normal - b->opening);
    normals[i] = normal;
    nn += w[i] * b->opening * normal;
    nt += w[i] * b->opening * b->shear;
    tn += w[i] * b->shear * normal;
    tt += w[i] * b->shear * b->shear;
    determinant += w[i] * (b->opening * normal * axis_t + b->shear * b->shear * axis_n);
    for (int32_t j = 0; j < i; j++)
      determinant += w[i] * w[j] * (normal * bounds[j].shear - b->shear * normals[j])
                     * (b->opening * bounds[j].shear - b->shear * bounds[j].opening);
  }
  found[0] = cell->no_shear ? 1.0 / nn : tt / determinant;
  found[1] = cell->no_shear ? 0.0 : -nt / determinant;
  found[2] = cell->no_shear ? 0.0 : -tn / determinant;
  found[3] = cell->no_shear ? 0.0 : nn / determinant;
  axes[0] = cell->no_shear ? 1.0 / nn : axis_t / determinant;
  axes[1] = cell->no_shear ? 0.0 : axis_n / determinant;
  for (int32_t i = 0; i < cell->bound_count; i++)
    turns[i] = cell->no_shear ? 0.0 : w[i] / determinant;
}

void
qn_ip_step_answer (const QnIpStep *ip, int32_t c, double normal, double shear,
                   QnIpVector *out)
{
  const QnIpInverse *inverse = &ip->inverse;
  const QnIpCell *cell = &ip->problem->cells[c];
  const QnIpBound *bounds = ip->problem->bounds + cell->first_bound;
  const double *turns = inverse->turns + cell->first_bound;
  const double *normals = inverse->normals + cell->first_bound;
  double *g = out->s + cell->first_bound;
  double axis_n = inverse->axes[2 * c] * normal;
  double axis_t = inverse->axes[2 * c + 1] * shear, yn = axis_n, yt = axis_t;

  for (int32_t i = 0; i < cell->bound_count; i++) {
    double row = normals[i], along = bounds[i].shear;
    double turn = turns[i] * (bounds[i].opening * shear - along * normal);
    yn -= turn * along;
    yt += turn * row;
    g[i] += row * axis_n + along * axis_t;
    for (int32_t j = 0; j < cell->bound_count; j++) /* nothing for j = i */
      g[j] += turn * (row * bounds[j].shear - along * normals[j]);
  }
  out->y[2 * c] += yn;
  out->y[2 * c + 1] += yt;
}
