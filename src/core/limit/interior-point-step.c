#include "core/limit/interior-point-internal.h"

#include <math.h>
#include <string.h>

/* Share of the way to the boundary that a step takes. Going nearer, up to 0.995, saves an
 * iteration at the end and costs more of them before: measured on walls of 500 to 5,000
 * blocks, as was the exponent of the centring. */
#define STEP_SHARE 0.9

/* The mean product aimed at is that of the iterate times (1 - the predictor's length) to the
 * power of this. */
#define CENTRING_EXPONENT 4.0

/* Gondzio's correctors aim at a step longer by this much, with products s z between these
 * multiples of the target; one that gains less than this is the last. */
#define CORRECTOR_ADVANCE 0.3
#define CORRECTOR_LOW     0.1
#define CORRECTOR_HIGH    10.0
#define CORRECTOR_GAIN    0.01

/* Factorises and solves for the border column, which does not depend on the direction's
 * right-hand side. */
static QnStatus
prepare (QnInteriorPoint *ip, bool *ok, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnStatus status;

  for (int32_t i = 0; i < p->bound_count; i++)
    work->w[i] = ip->z[i] / ip->s[i];
  status = qn_ip_kkt_factorize (&work->kkt, work->w, ok, diag);
  if (status || !*ok)
    return status;

  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++) {
      double q = p->cells[c].linear[k], qy = p->cells[c].quadratic[k] * ip->y[2 * c + k];
      work->gy[2 * c + k] = 2.0 * qy / ip->tau + q;
      work->right.y[2 * c + k] = -q;
    }
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = work->w[i] * p->bounds[i].limit;
  qn_ip_add_bounds_transposed (p, work->products, 1.0, work->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    work->right.v[r] = -p->constant[r];
  work->right.lambda = p->load_gain;
  return qn_ip_kkt_solve (&work->kkt, &work->right, &work->tau_column, diag);
}

/* dtau from the gap row,
 *
 *   gy'dy - gain dlambda - d'dv + h'dz - (kappa/tau + y'Qy/tau^2) dtau
 *     = share r_tau - product_tau/tau
 *
 * where dy = `base` + tau_column dtau and so on; base->z holds what does not depend on dtau and
 * dy in dz, so that dz = base->z + w (G dy - h dtau). */
static double
solve_tau (const QnInteriorPoint *ip, double share, const QnIpVector *base)
{
  const QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  const QnIpKktVector *column = &work->tau_column;
  int32_t cells = 2 * p->cell_count, rows = p->row_count;
  double pivot = qn_ip_dot (work->gy, column->y, cells) - p->load_gain * column->lambda
                 - qn_ip_dot (p->constant, column->v, rows) - ip->kappa / ip->tau
                 - work->curvature / (ip->tau * ip->tau);
  double right = share * work->r_tau - work->product_tau / ip->tau
                 - qn_ip_dot (work->gy, base->y, cells) + p->load_gain * base->lambda
                 + qn_ip_dot (p->constant, base->v, rows);

  for (int32_t i = 0; i < p->bound_count; i++) {
    double h = p->bounds[i].limit;
    pivot += h * work->w[i] * (column->g[i] - h);
    right -= h * (base->z[i] + work->w[i] * base->s[i]);
  }
  return right / pivot;
}

/* Newton direction for `share` of the residuals and the products in work->products:
 *
 *   H dy + B'dv = share ry - G'(products/s - w share rz) + (G'(w h) - q) dtau
 *   B dy + f dlambda = share rv - d dtau
 *   f'dv        = share r_lambda + gain dtau
 *   ds = share rz - G dy + h dtau,   dz = (products - z ds) / s
 */
static QnStatus
solve_direction (QnInteriorPoint *ip, double share, QnIpVector *out, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpKktVector solution = { out->y, out->s, out->v, 0.0 };
  QnStatus status;

  for (int32_t i = 0; i < p->bound_count; i++)
    out->z[i] = work->products[i] / ip->s[i] - work->w[i] * share * work->rz[i];
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    work->right.y[i] = share * work->ry[i];
  qn_ip_add_bounds_transposed (p, out->z, -1.0, work->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    work->right.v[r] = share * work->rv[r];
  work->right.lambda = share * work->r_lambda;
  status = qn_ip_kkt_solve (&work->kkt, &work->right, &solution, diag);
  if (status)
    return status;

  out->lambda = solution.lambda;
  out->tau = solve_tau (ip, share, out);
  out->lambda += out->tau * work->tau_column.lambda;
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    out->y[i] += out->tau * work->tau_column.y[i];
  for (int32_t r = 0; r < p->row_count; r++)
    out->v[r] += out->tau * work->tau_column.v[r];
  for (int32_t i = 0; i < p->bound_count; i++) {
    double change = out->s[i] + out->tau * work->tau_column.g[i]; /* G dy */
    out->s[i] = share * work->rz[i] - change + p->bounds[i].limit * out->tau;
    out->z[i] = (work->products[i] - ip->z[i] * out->s[i]) / ip->s[i];
  }
  out->kappa = (work->product_tau - ip->kappa * out->tau) / ip->tau;
  return QN_OK;
}

/* Longest step, at most 1, that keeps s, z, tau and kappa non-negative. */
static double
longest_step (const QnInteriorPoint *ip, const QnIpVector *step)
{
  double length = 1.0;

  if (step->tau < 0.0)
    length = fmin (length, -ip->tau / step->tau);
  if (step->kappa < 0.0)
    length = fmin (length, -ip->kappa / step->kappa);
  for (int32_t i = 0; i < ip->work->problem->bound_count; i++) {
    if (step->s[i] < 0.0)
      length = fmin (length, -ip->s[i] / step->s[i]);
    if (step->z[i] < 0.0)
      length = fmin (length, -ip->z[i] / step->z[i]);
  }
  return length;
}

/* What has to be added to a product that would leave [low, high] of the target. */
static double
centre (double product, double target)
{
  double low = CORRECTOR_LOW * target, high = CORRECTOR_HIGH * target;

  if (product < low)
    return low - product;
  return product > high ? fmax (high - product, -high) : 0.0;
}

/* Gondzio's centrality corrector: one more solve that draws outlying products back and so
 * allows a longer step. Returns whether the longer step was found; work->step is the better
 * of the two then. */
static QnStatus
correct_centrality (QnInteriorPoint *ip, double target, double share, double *length,
                    bool *gained, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpVector *step = &work->step, *trial = &work->trial, swap;
  double aim = fmin (1.0, *length + CORRECTOR_ADVANCE), reached;
  QnStatus status;

  /* work->products still holds the right-hand side of `step`. */
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] +=
      centre ((ip->s[i] + aim * step->s[i]) * (ip->z[i] + aim * step->z[i]), target);
  work->product_tau +=
    centre ((ip->tau + aim * step->tau) * (ip->kappa + aim * step->kappa), target);
  status = solve_direction (ip, share, trial, diag);
  if (status)
    return status;
  reached = longest_step (ip, trial);
  *gained = reached > *length;
  if (!*gained)
    return QN_OK;
  swap = *step;
  *step = *trial;
  *trial = swap;
  *gained = reached >= *length + CORRECTOR_GAIN;
  *length = reached;
  return QN_OK;
}

QnStatus
qn_ip_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpVector *step = &work->step;
  double mean = (qn_ip_dot (ip->s, ip->z, p->bound_count) + ip->tau * ip->kappa)
                / (p->bound_count + 1.0);
  double centring, target, share;
  QnStatus status = prepare (ip, ok, diag);

  if (status || !*ok)
    return status;
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = -ip->s[i] * ip->z[i];
  work->product_tau = -ip->tau * ip->kappa;
  status = solve_direction (ip, 1.0, step, diag);
  if (status)
    return status;

  *length = longest_step (ip, step);
  centring = pow (1.0 - *length, CENTRING_EXPONENT);
  target = centring * mean;
  share = 1.0 - centring;
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = target - ip->s[i] * ip->z[i] - step->s[i] * step->z[i];
  work->product_tau = target - ip->tau * ip->kappa - step->tau * step->kappa;
  status = solve_direction (ip, share, step, diag);
  if (status)
    return status;
  *length = longest_step (ip, step);
  for (int32_t k = 0; k < work->settings.correctors && *length < 0.95; k++) {
    bool gained;
    status = correct_centrality (ip, target, share, length, &gained, diag);
    if (status)
      return status;
    if (!gained)
      break;
  }
  *length = fmin (1.0, STEP_SHARE * *length);
  return QN_OK;
}
