#include "core/limit/interior-point-internal.h"

#include <math.h>
#include <string.h>

/* A certificate holds where its equations hold to this, relative to what it proves. */
#define CERTIFICATE_TOLERANCE 1e-8

void
qn_ip_residuals (QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double load_power = 0.0, primal, dual;

  work->curvature = qn_ip_quadratic_term (p, ip->y);
  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      work->ry[2 * c + k] =
        -p->cells[c].quadratic[k] * ip->y[2 * c + k] - p->cells[c].linear[k] * ip->tau;
  qn_ip_add_rates (p, ip->v, -1.0, work->ry);
  qn_ip_add_bounds_transposed (p, ip->z, -1.0, work->ry);
  for (int32_t c = 0; c < p->cell_count; c++)
    if (p->cells[c].no_shear)
      work->ry[2 * c + 1] = 0.0;

  qn_interior_point_balance (p, ip->y, ip->lambda, ip->tau, work->rv);
  for (int32_t r = 0; r < p->row_count; r++)
    work->rv[r] = -work->rv[r];

  qn_ip_apply_bounds (p, ip->y, work->rz);
  for (int32_t i = 0; i < p->bound_count; i++)
    work->rz[i] = p->bounds[i].limit * ip->tau - ip->s[i] - work->rz[i];

  if (p->load)
    load_power = qn_ip_dot (p->load, ip->v, p->row_count);
  work->r_lambda = p->load ? p->load_gain * ip->tau - load_power : 0.0;
  primal =
    work->curvature / ip->tau + qn_ip_linear_term (p, ip->y) - p->load_gain * ip->lambda;
  dual = qn_ip_dot (p->constant, ip->v, p->row_count) - qn_ip_limit_term (p, ip->z);
  work->r_tau = dual - primal - ip->kappa;
}

/* Size of the largest strength multiplier or linear term: what the dual residual of a problem
 * is compared with. */
static double
dual_scale (const QnInteriorPoint *ip)
{
  const QnIpProblem *p = ip->work->problem;
  double scale = p->load && p->load_gain != 0.0 ? 0.0 : 1.0;

  for (int32_t c = 0; c < p->cell_count; c++)
    scale =
      fmax (scale, fmax (fabs (p->cells[c].linear[0]), fabs (p->cells[c].linear[1])));
  return fmax (scale, qn_ip_largest (ip->v, p->row_count) / ip->tau);
}

void
qn_ip_measure (QnInteriorPoint *ip)
{
  const QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double primal_scale = 1.0 + qn_ip_largest (p->constant, p->row_count);
  double primal, dual, balance, slacks, rates;

  if (p->load)
    primal_scale = fmax (primal_scale, 1.0 + qn_ip_largest (p->load, p->row_count));
  balance = qn_ip_largest (work->rv, p->row_count);
  slacks = qn_ip_largest (work->rz, p->bound_count);
  rates = qn_ip_largest (work->ry, 2 * p->cell_count);
  primal = 0.5 * work->curvature / ip->tau + qn_ip_linear_term (p, ip->y)
           - p->load_gain * ip->lambda;
  dual = -0.5 * work->curvature / ip->tau + qn_ip_dot (p->constant, ip->v, p->row_count)
         - qn_ip_limit_term (p, ip->z);
  ip->measures = (QnIpMeasures){
    .primal_residual = fmax (balance, slacks) / (ip->tau * primal_scale),
    .dual_residual =
      fmax (rates, fabs (work->r_lambda)) / (ip->tau * (dual_scale (ip) + 1e-300)),
    .gap = fabs (primal - dual) / (ip->tau + fmin (fabs (primal), fabs (dual))),
  };
}

/* No forces keep equilibrium under any multiplier: the dead load does more power along v than
 * the joints can dissipate, and the live load none. */
bool
qn_ip_proves_infeasible (const QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double proof =
    qn_ip_dot (p->constant, ip->v, p->row_count) - qn_ip_limit_term (p, ip->z);
  double *rates = work->right.y;

  if (proof <= 0.0)
    return false;
  if (p->load
      && fabs (qn_ip_dot (p->load, ip->v, p->row_count)) > CERTIFICATE_TOLERANCE * proof)
    return false;
  memset (rates, 0, 2 * (size_t) p->cell_count * sizeof (double));
  qn_ip_add_rates (p, ip->v, 1.0, rates);
  qn_ip_add_bounds_transposed (p, ip->z, 1.0, rates);
  return qn_ip_largest (rates, 2 * p->cell_count) <= CERTIFICATE_TOLERANCE * proof;
}

/* Forces that balance the live load alone, within the joints' recession cones. */
bool
qn_ip_proves_unbounded (const QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double proof = p->load_gain * ip->lambda - qn_ip_linear_term (p, ip->y);
  double *balance = work->right.v, worst = 0.0;

  if (proof <= 0.0)
    return false;
  qn_interior_point_balance (p, ip->y, ip->lambda, 0.0, balance);
  for (int32_t i = 0; i < p->bound_count; i++) /* Gy = -s + (h tau - rz), s >= 0 */
    worst = fmax (worst, p->bounds[i].limit * ip->tau - work->rz[i]);
  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      worst = fmax (worst, fabs (p->cells[c].quadratic[k] * ip->y[2 * c + k]));
  return fmax (worst, qn_ip_largest (balance, p->row_count))
         <= CERTIFICATE_TOLERANCE * proof;
}
