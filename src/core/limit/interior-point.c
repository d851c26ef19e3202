#include "core/limit/interior-point.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/limit/interior-point-apply.h"
#include "core/limit/interior-point-kkt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Iterations without a better iterate after which the method stops. */
#define STALL_ITERATIONS 12

/* Regularisation of the linear systems, and the relative residual above which a direction is
 * computed again with more of it. */
#define LEAST_REGULARIZATION 1e-10
#define MOST_REGULARIZATION  1e-5
#define REGULARIZATION_STEP  30.0
#define WORST_SOLUTION       1e-4

/* Solves spent on restoring equilibrium: the second removes the rounding of the first. */
#define PROJECTION_ROUNDS 2

struct QnInteriorPointWork {
  const QnIpProblem *problem; /* borrowed */
  QnIpSettings settings;
  double tolerance; /* that of the settings, or a finer one */
  QnIpKkt kkt;
  double *w;                /* z / s */
  double *ry, *rv, *rz;     /* residuals of the iterate, minus the left-hand sides */
  double r_lambda, r_tau;   /* the two scalar ones */
  double *gy;               /* gradient of the objective in y, cell_count x 2 */
  double curvature;         /* y'Qy */
  QnIpKktVector tau_column; /* solution for the border column of tau */
  QnIpKktRight right;       /* right-hand side being built */
  double *products;         /* right-hand side of s dz + z ds */
  double product_tau;       /* … and of tau dkappa + kappa dtau */
  QnIpVector step, trial, best;
  double best_merit;
  int32_t since_best;
};

/* A certificate holds where its equations hold to this, relative to what it proves. */
#define CERTIFICATE_TOLERANCE 1e-8

/* What is missing for equilibrium: out = -(B y + lambda f + tau d) */
static void
missing_balance (const QnIpProblem *p, const double *y, double lambda, double tau,
                 double *out)
{
  qn_interior_point_balance (p, y, lambda, tau, out);
  for (int32_t r = 0; r < p->row_count; r++)
    out[r] = -out[r];
}

/* Residuals of the iterate. */
static void
residuals (QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double load_power = 0.0, primal, dual;

  work->curvature = qn_ip_quadratic_term (p, ip->at.y);
  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      work->ry[2 * c + k] = -p->cells[c].quadratic[k] * ip->at.y[2 * c + k];
  qn_ip_add_rates (p, ip->at.v, -1.0, work->ry);
  qn_ip_add_bounds_transposed (p, ip->at.z, -1.0, work->ry);
  for (int32_t c = 0; c < p->cell_count; c++)
    if (p->cells[c].no_shear)
      work->ry[2 * c + 1] = 0.0;

  missing_balance (p, ip->at.y, ip->at.lambda, ip->at.tau, work->rv);

  qn_ip_apply_bounds (p, ip->at.y, work->rz);
  for (int32_t i = 0; i < p->bound_count; i++)
    work->rz[i] = p->bounds[i].limit * ip->at.tau - ip->at.s[i] - work->rz[i];

  if (p->load)
    load_power = qn_ip_dot (p->load, ip->at.v, p->row_count);
  work->r_lambda = p->load ? p->load_gain * ip->at.tau - load_power : 0.0;
  primal = work->curvature / ip->at.tau - p->load_gain * ip->at.lambda;
  dual = qn_ip_dot (p->constant, ip->at.v, p->row_count) - qn_ip_limit_term (p, ip->at.z);
  work->r_tau = dual - primal - ip->at.kappa;
}

/* Size of the largest velocity: what the dual residual of a problem is compared with. */
static double
dual_scale (const QnInteriorPoint *ip)
{
  const QnIpProblem *p = ip->work->problem;
  double least = p->load && p->load_gain != 0.0 ? 0.0 : 1.0;

  return fmax (least, qn_ip_largest (ip->at.v, p->row_count) / ip->at.tau);
}

/* ip->measures from the residuals. */
static void
take_measures (QnInteriorPoint *ip)
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
  primal = 0.5 * work->curvature / ip->at.tau - p->load_gain * ip->at.lambda;
  dual = -0.5 * work->curvature / ip->at.tau
         + qn_ip_dot (p->constant, ip->at.v, p->row_count)
         - qn_ip_limit_term (p, ip->at.z);
  ip->measures = (QnIpMeasures){
    .primal_residual = fmax (balance, slacks) / (ip->at.tau * primal_scale),
    .dual_residual =
      fmax (rates, fabs (work->r_lambda)) / (ip->at.tau * (dual_scale (ip) + 1e-300)),
    .gap = fabs (primal - dual) / (ip->at.tau + fmin (fabs (primal), fabs (dual))),
  };
}

/* Whether v and z prove that no forces keep equilibrium under any multiplier: the dead load does more
 * power along v than the joints can dissipate, and the live load none. */
static bool
proves_infeasible (const QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double proof =
    qn_ip_dot (p->constant, ip->at.v, p->row_count) - qn_ip_limit_term (p, ip->at.z);
  double *rates = work->right.y;

  if (proof <= 0.0)
    return false;
  if (p->load
      && !(fabs (qn_ip_dot (p->load, ip->at.v, p->row_count))
           <= CERTIFICATE_TOLERANCE * proof))
    return false;
  memset (rates, 0, 2 * (size_t) p->cell_count * sizeof (double));
  qn_ip_add_rates (p, ip->at.v, 1.0, rates);
  qn_ip_add_bounds_transposed (p, ip->at.z, 1.0, rates);
  return qn_ip_largest (rates, 2 * p->cell_count) <= CERTIFICATE_TOLERANCE * proof;
}

/* Whether y and lambda prove that the multiplier has no bound: forces that balance the live load
 * alone, within the joints' recession cones. */
static bool
proves_unbounded (const QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  double proof = p->load_gain * ip->at.lambda;
  double *balance = work->right.v, worst = 0.0;

  if (proof <= 0.0)
    return false;
  qn_interior_point_balance (p, ip->at.y, ip->at.lambda, 0.0, balance);
  for (int32_t i = 0; i < p->bound_count; i++) /* Gy = -s + (h tau - rz), s >= 0 */
    worst = qn_worse (worst, p->bounds[i].limit * ip->at.tau - work->rz[i]);
  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      worst = qn_worse (worst, fabs (p->cells[c].quadratic[k] * ip->at.y[2 * c + k]));
  return fmax (worst, qn_ip_largest (balance, p->row_count))
         <= CERTIFICATE_TOLERANCE * proof;
}

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
prepare_start (QnInteriorPoint *ip, bool *ok, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnStatus status;

  for (int32_t i = 0; i < p->bound_count; i++)
    work->w[i] = ip->at.z[i] / ip->at.s[i];
  status = qn_ip_kkt_factorize (&work->kkt, work->w, ok, diag);
  if (status || !*ok)
    return status;

  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      work->gy[2 * c + k] =
        2.0 * p->cells[c].quadratic[k] * ip->at.y[2 * c + k] / ip->at.tau;
  memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
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
                 - qn_ip_dot (p->constant, column->v, rows) - ip->at.kappa / ip->at.tau
                 - work->curvature / (ip->at.tau * ip->at.tau);
  double right = share * work->r_tau - work->product_tau / ip->at.tau
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
solve_newton (QnInteriorPoint *ip, double share, QnIpVector *out, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpKktVector solution = { out->y, out->s, out->v, 0.0 };
  QnStatus status;

  for (int32_t i = 0; i < p->bound_count; i++)
    out->z[i] = work->products[i] / ip->at.s[i] - work->w[i] * share * work->rz[i];
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
  qn_ip_add_multiple (out->y, out->tau, work->tau_column.y, 2 * p->cell_count);
  qn_ip_add_multiple (out->v, out->tau, work->tau_column.v, p->row_count);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double change = out->s[i] + out->tau * work->tau_column.g[i]; /* G dy */
    out->s[i] = share * work->rz[i] - change + p->bounds[i].limit * out->tau;
    out->z[i] = (work->products[i] - ip->at.z[i] * out->s[i]) / ip->at.s[i];
  }
  out->kappa = (work->product_tau - ip->at.kappa * out->tau) / ip->at.tau;
  return QN_OK;
}

/* Longest step, at most 1, that keeps s, z, tau and kappa non-negative. */
static double
longest_step (const QnInteriorPoint *ip, const QnIpVector *step)
{
  double length = 1.0;

  if (step->tau < 0.0)
    length = fmin (length, -ip->at.tau / step->tau);
  if (step->kappa < 0.0)
    length = fmin (length, -ip->at.kappa / step->kappa);
  for (int32_t i = 0; i < ip->work->problem->bound_count; i++) {
    if (step->s[i] < 0.0)
      length = fmin (length, -ip->at.s[i] / step->s[i]);
    if (step->z[i] < 0.0)
      length = fmin (length, -ip->at.z[i] / step->z[i]);
  }
  return length;
}

/* What has to be added to a product that would leave [low, high] of the target. */
static double
centre_gap (double product, double target)
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
    work->products[i] += centre_gap (
      (ip->at.s[i] + aim * step->s[i]) * (ip->at.z[i] + aim * step->z[i]), target);
  work->product_tau += centre_gap (
    (ip->at.tau + aim * step->tau) * (ip->at.kappa + aim * step->kappa), target);
  status = solve_newton (ip, share, trial, diag);
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

/* Predictor, corrector and centrality correctors from the present iterate: the direction is
 * left in work->step, the step length in *length. *ok is false where the linear system could
 * not be factorised. */
static QnStatus
newton_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpVector *step = &work->step;
  double mean =
    (qn_ip_dot (ip->at.s, ip->at.z, p->bound_count) + ip->at.tau * ip->at.kappa)
    / (p->bound_count + 1.0);
  double centring, target, share;
  QnStatus status = prepare_start (ip, ok, diag);

  if (status || !*ok)
    return status;
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = -ip->at.s[i] * ip->at.z[i];
  work->product_tau = -ip->at.tau * ip->at.kappa;
  status = solve_newton (ip, 1.0, step, diag);
  if (status)
    return status;

  *length = longest_step (ip, step);
  centring = pow (1.0 - *length, CENTRING_EXPONENT);
  target = centring * mean;
  share = 1.0 - centring;
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = target - ip->at.s[i] * ip->at.z[i] - step->s[i] * step->z[i];
  work->product_tau = target - ip->at.tau * ip->at.kappa - step->tau * step->kappa;
  status = solve_newton (ip, share, step, diag);
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
  /* Where the predictor alone almost solves the problem, the step may go nearer to the boundary: by as
   * much as the mean product is to fall. */
  double reach = work->settings.hasten ? fmax (STEP_SHARE, share) : STEP_SHARE;
  *length = fmin (1.0, reach * *length);
  return QN_OK;
}

QnIpSettings
qn_interior_point_defaults (void)
{
  return (QnIpSettings){ .tolerance = 1e-9, .max_iterations = 200, .correctors = 6 };
}

bool
qn_ip_vector_init (QnIpVector *vector, const QnIpProblem *p)
{
  vector->y = qn_alloc (2 * (size_t) p->cell_count, sizeof (double));
  vector->v = qn_alloc ((size_t) p->row_count, sizeof (double));
  vector->s = qn_alloc ((size_t) p->bound_count, sizeof (double));
  vector->z = qn_alloc ((size_t) p->bound_count, sizeof (double));
  return vector->y && vector->v && vector->s && vector->z;
}

void
qn_ip_vector_clear (QnIpVector *vector)
{
  free (vector->y);
  free (vector->v);
  free (vector->s);
  free (vector->z);
  *vector = (QnIpVector){ 0 };
}

static void
vector_copy (QnIpVector *to, const QnIpVector *from, const QnIpProblem *p)
{
  memcpy (to->y, from->y, 2 * (size_t) p->cell_count * sizeof (double));
  memcpy (to->v, from->v, (size_t) p->row_count * sizeof (double));
  memcpy (to->s, from->s, (size_t) p->bound_count * sizeof (double));
  memcpy (to->z, from->z, (size_t) p->bound_count * sizeof (double));
  to->lambda = from->lambda;
  to->tau = from->tau;
  to->kappa = from->kappa;
}

QnStatus
qn_interior_point_init (QnInteriorPoint *ip, const QnIpProblem *problem,
                        const QnIpSettings *settings, QnDiag *diag)
{
  size_t cells = (size_t) problem->cell_count, rows = (size_t) problem->row_count;
  size_t bounds = (size_t) problem->bound_count;
  QnInteriorPointWork *work;
  QnStatus status;

  *ip = (QnInteriorPoint){ .state = QN_IP_RUNNING };
  work = ip->work = qn_alloc (1, sizeof *work);
  if (!work)
    return qn_diag_no_memory (diag);
  work->problem = problem;
  work->settings = *settings;
  work->w = qn_alloc (bounds, sizeof (double));
  work->rz = qn_alloc (bounds, sizeof (double));
  work->products = qn_alloc (bounds, sizeof (double));
  work->ry = qn_alloc (2 * cells, sizeof (double));
  work->gy = qn_alloc (2 * cells, sizeof (double));
  work->tau_column.y = qn_alloc (2 * cells, sizeof (double));
  work->tau_column.g = qn_alloc (bounds, sizeof (double));
  work->right.y = qn_alloc (2 * cells, sizeof (double));
  work->rv = qn_alloc (rows, sizeof (double));
  work->tau_column.v = qn_alloc (rows, sizeof (double));
  work->right.v = qn_alloc (rows, sizeof (double));
  if (!work->w || !work->rz || !work->products || !work->ry || !work->gy
      || !work->tau_column.y || !work->tau_column.g || !work->right.y || !work->rv
      || !work->tau_column.v || !work->right.v
      || !qn_ip_vector_init (&work->step, problem)
      || !qn_ip_vector_init (&work->trial, problem)
      || !qn_ip_vector_init (&work->best, problem)
      || !qn_ip_vector_init (&ip->at, problem))
    status = qn_diag_no_memory (diag);
  else
    status = qn_ip_kkt_init (&work->kkt, problem, diag);
  if (status)
    qn_interior_point_clear (ip);
  return status;
}

void
qn_interior_point_clear (QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;

  if (work) {
    double *arrays[] = { work->w,
                         work->rz,
                         work->products,
                         work->ry,
                         work->gy,
                         work->rv,
                         work->tau_column.y,
                         work->tau_column.g,
                         work->tau_column.v,
                         work->right.y,
                         work->right.v };
    for (size_t i = 0; i < QN_N_ELEMENTS (arrays); i++)
      free (arrays[i]);
    qn_ip_vector_clear (&work->step);
    qn_ip_vector_clear (&work->trial);
    qn_ip_vector_clear (&work->best);
    qn_ip_kkt_clear (&work->kkt);
    free (work);
  }
  qn_ip_vector_clear (&ip->at);
  *ip = (QnInteriorPoint){ 0 };
}

QnStatus
qn_interior_point_keep (const QnInteriorPoint *ip, QnIpVector *copy, QnDiag *diag)
{
  if (copy->y == NULL && !qn_ip_vector_init (copy, ip->work->problem))
    return qn_diag_no_memory (diag);
  vector_copy (copy, &ip->at, ip->work->problem);
  return QN_OK;
}

/* Moves the entries to positive values of comparable size, as Mehrotra's starting point does. */
static void
shift_positive (double *values, int32_t count)
{
  double lowest = 0.0, sum = 0.0;

  for (int32_t i = 0; i < count; i++)
    lowest = fmin (lowest, values[i]);
  for (int32_t i = 0; i < count; i++) {
    values[i] -= 1.5 * lowest;
    sum += values[i];
  }
  sum = count > 0 && sum > 0.0 ? 0.5 * sum / count : 1.0;
  for (int32_t i = 0; i < count; i++)
    values[i] += sum;
}

static void
begin_iterations (QnInteriorPoint *ip)
{
  ip->state = QN_IP_RUNNING;
  ip->iterations = 0;
  ip->work->kkt.regularization = LEAST_REGULARIZATION;
  ip->work->kkt.schur.factorizations = 0;
  ip->work->kkt.schur.seconds = 0.0;
  ip->work->since_best = 0;
  ip->work->best_merit = INFINITY;
  ip->work->tolerance = ip->work->settings.tolerance;
}

static void
count_effort (QnInteriorPoint *ip)
{
  ip->factorizations = ip->work->kkt.schur.factorizations;
  ip->factor_seconds = ip->work->kkt.schur.seconds;
}

/* Two least-squares problems: the smallest slacks in equilibrium with the constant loads, and the
 * smallest multipliers compatible with the objective; both shifted to the interior. */
QnStatus
qn_interior_point_start (QnInteriorPoint *ip, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpKktVector primal = { ip->at.y, ip->at.s, ip->at.v, 0.0 };
  QnIpKktVector dual = { work->step.y, ip->at.z, ip->at.v, 0.0 };
  QnStatus status;
  bool ok;

  begin_iterations (ip);
  for (int32_t i = 0; i < p->bound_count; i++)
    work->w[i] = 1.0;
  status = qn_ip_kkt_factorize (&work->kkt, work->w, &ok, diag);
  count_effort (ip);
  if (!status && !ok)
    ip->state = QN_IP_STALLED;

  memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = p->bounds[i].limit;
  qn_ip_add_bounds_transposed (p, work->products, 1.0, work->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    work->right.v[r] = -p->constant[r];
  work->right.lambda = 0.0;
  if (!status)
    status = qn_ip_kkt_solve (&work->kkt, &work->right, &primal, diag);

  memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  memset (work->right.v, 0, (size_t) p->row_count * sizeof (double));
  work->right.lambda = p->load_gain;
  if (!status)
    status = qn_ip_kkt_solve (&work->kkt, &work->right, &dual, diag);
  if (status)
    return status;

  for (int32_t i = 0; i < p->bound_count; i++)
    ip->at.s[i] = p->bounds[i].limit - ip->at.s[i];
  shift_positive (ip->at.s, p->bound_count);
  shift_positive (ip->at.z, p->bound_count);
  ip->at.lambda = primal.lambda;
  ip->at.tau = 1.0;
  ip->at.kappa = p->bound_count > 0
                   ? qn_ip_dot (ip->at.s, ip->at.z, p->bound_count) / p->bound_count
                   : 1.0;
  residuals (ip);
  return QN_OK;
}

void
qn_interior_point_start_from (QnInteriorPoint *ip, const QnIpVector *iterate)
{
  begin_iterations (ip);
  count_effort (ip);
  vector_copy (&ip->at, iterate, ip->work->problem);
  residuals (ip);
}

/* Decides whether the iterate is an answer, and keeps the best one for the case that rounding
 * ends the progress. */
static void
judge (QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpMeasures *m = &ip->measures;
  double merit = fmax (m->primal_residual, fmax (m->dual_residual, m->gap));

  if (merit <= work->tolerance) {
    ip->state = QN_IP_OPTIMAL;
    return;
  }
  if (ip->at.tau < ip->at.kappa || merit > 1e3) {
    if (proves_infeasible (ip))
      ip->state = QN_IP_INFEASIBLE;
    else if (proves_unbounded (ip))
      ip->state = QN_IP_UNBOUNDED;
    if (ip->state != QN_IP_RUNNING)
      return;
  }
  if (merit < work->best_merit) {
    work->best_merit = merit;
    work->since_best = 0;
    vector_copy (&work->best, &ip->at, work->problem);
  } else if (++work->since_best >= STALL_ITERATIONS) {
    ip->state = QN_IP_STALLED;
  }
}

void
qn_interior_point_refine (QnInteriorPoint *ip, double tolerance)
{
  ip->state = QN_IP_RUNNING;
  ip->work->tolerance = tolerance;
  judge (ip);
}

/* A direction that solves its equations. Where rounding prevents that, the regularisation grows,
 * and with it the residual that a step leaves. */
static QnStatus
find_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag)
{
  QnIpKkt *kkt = &ip->work->kkt;

  for (;;) {
    QnStatus status = newton_direction (ip, length, ok, diag);
    if (status)
      return status;
    *ok = *ok && isfinite (*length) && kkt->error < WORST_SOLUTION;
    if (*ok || kkt->regularization >= MOST_REGULARIZATION)
      return QN_OK;
    kkt->regularization *= REGULARIZATION_STEP;
  }
}

/* Ends without an answer: the best iterate seen is what is left. */
static void
give_up (QnInteriorPoint *ip)
{
  if (isfinite (ip->work->best_merit)) {
    vector_copy (&ip->at, &ip->work->best, ip->work->problem);
    residuals (ip);
    take_measures (ip);
  }
  ip->state = QN_IP_STALLED;
}

QnStatus
qn_interior_point_iterate (QnInteriorPoint *ip, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  double length = 0;
  bool ok;
  QnStatus status;

  if (ip->state != QN_IP_RUNNING)
    return QN_OK;
  status = find_direction (ip, &length, &ok, diag);
  count_effort (ip);
  if (status)
    return status;
  if (!ok) {
    give_up (ip);
    return QN_OK;
  }
  const QnIpProblem *p = work->problem;
  const QnIpVector *step = &work->step;
  qn_ip_add_multiple (ip->at.y, length, step->y, 2 * p->cell_count);
  qn_ip_add_multiple (ip->at.v, length, step->v, p->row_count);
  qn_ip_add_multiple (ip->at.s, length, step->s, p->bound_count);
  qn_ip_add_multiple (ip->at.z, length, step->z, p->bound_count);
  ip->at.lambda += length * step->lambda;
  ip->at.tau += length * step->tau;
  ip->at.kappa += length * step->kappa;
  ip->iterations++;
  residuals (ip);
  take_measures (ip);
  judge (ip);
  if (ip->state == QN_IP_RUNNING
      && (ip->iterations >= work->settings.max_iterations || length < 1e-10))
    ip->state = QN_IP_STALLED;
  if (ip->state == QN_IP_STALLED)
    give_up (ip);
  return QN_OK;
}

QnStatus
qn_interior_point_restore (QnInteriorPoint *ip, bool fixed, double *lambda, double *y,
                           double *residual, double *slack, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnStatus status = QN_OK;

  work->kkt.bordered = p->load && !fixed;
  for (int round = 0; round < PROJECTION_ROUNDS && !status; round++) {
    QnIpKktVector step = { work->trial.y, work->trial.s, work->trial.v, 0.0 };
    missing_balance (p, y, *lambda, 1.0, work->right.v);
    memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
    work->right.lambda = 0.0;
    status = qn_ip_kkt_solve (&work->kkt, &work->right, &step, diag);
    if (!status)
      qn_ip_add_multiple (y, 1.0, step.y, 2 * p->cell_count);
    *lambda += step.lambda;
  }
  work->kkt.bordered = p->load != NULL;
  if (status)
    return status;
  qn_interior_point_balance (p, y, *lambda, 1.0, work->right.v);
  *residual = qn_ip_largest (work->right.v, p->row_count);
  qn_ip_apply_bounds (p, y, work->trial.s);
  *slack = INFINITY;
  for (int32_t i = 0; i < p->bound_count; i++)
    *slack = fmin (*slack, p->bounds[i].limit - work->trial.s[i]);
  return QN_OK;
}

QnStatus
qn_interior_point_project (QnInteriorPoint *ip, bool fixed, double *lambda, double *y,
                           double *residual, double *slack, QnDiag *diag)
{
  for (int32_t i = 0; i < 2 * ip->work->problem->cell_count; i++)
    y[i] = ip->at.y[i] / ip->at.tau;
  return qn_interior_point_restore (ip, fixed, lambda, y, residual, slack, diag);
}
