#include "core/limit/collapse.h"

#include "core/base/memory.h"
#include "core/limit/interior-point-apply.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What steers the method. Measured on the six walls and 48 seeded walls of 20 to 600 blocks
 * (docs/experiments/limit-analysis.md). */
static const struct {
  double to_boundary; /* part of the way to where some s or z vanishes */
  double exponent;    /* of what the predictor leaves of mu, for the mu aimed at */
  double least_aim;   /* of mu, in one step */
  int32_t correctors; /* of centrality, for steps shorter than `full_step` */
  double full_step, spread,
    gain;            /* products are brought within `spread` of mu, a corrector gains */
  double short_step; /* a step shorter than this lowers the coupling, */
  double long_step;  /* a longer one than this raises it, */
  double less, more; /* by so much; */
} tuning = {
  .to_boundary = 0.9,
  .exponent = 5,
  .least_aim = 1e-6,
  .correctors = 4,
  .full_step = 0.9,
  .spread = 5,
  .gain = 0.01,
  .short_step = 0.1,
  .long_step = 0.3,
  .less = 0.1,
  .more = 0.05,
};

/* Residuals at a collapse: of forces, relative to the largest; of rates, to the largest velocity. */
#define FORCE_RESIDUAL 1e-8
#define RATE_RESIDUAL  1e-5

/* Proximal term of the linear systems (interior-point-kkt.h). */
#define REGULARIZATION 1e-12

/* An error of the linear systems above this is no direction. */
#define WORST_ERROR 1e-3

QnStatus
qn_collapse_init (QnCollapse *c, const QnIpProblem *p, QnDiag *diag)
{
  size_t cells = (size_t) p->cell_count, rows = (size_t) p->row_count,
         bounds = (size_t) p->bound_count;

  *c = (QnCollapse){ .problem = p };
  c->w = qn_alloc (bounds, sizeof (double));
  c->rz = qn_alloc (bounds, sizeof (double));
  c->products = qn_alloc (bounds, sizeof (double));
  c->ry = qn_alloc (2 * cells, sizeof (double));
  c->right.y = qn_alloc (2 * cells, sizeof (double));
  c->rv = qn_alloc (rows, sizeof (double));
  c->right.v = qn_alloc (rows, sizeof (double));
  bool ok = c->w && c->rz && c->products && c->ry && c->right.y && c->rv && c->right.v
            && qn_ip_vector_init (&c->at, p) && qn_ip_vector_init (&c->step, p)
            && qn_ip_vector_init (&c->trial, p);
  QnStatus status = ok ? qn_ip_kkt_init (&c->kkt, p, diag) : qn_diag_no_memory (diag);
  c->kkt.regularization = REGULARIZATION;
  if (status)
    qn_collapse_clear (c);
  return status;
}

void
qn_collapse_clear (QnCollapse *c)
{
  double *arrays[] = { c->w, c->rz, c->products, c->ry, c->right.y, c->rv, c->right.v };

  for (size_t i = 0; i < QN_N_ELEMENTS (arrays); i++)
    free (arrays[i]);
  qn_ip_vector_clear (&c->at);
  qn_ip_vector_clear (&c->step);
  qn_ip_vector_clear (&c->trial);
  qn_ip_kkt_clear (&c->kkt);
  *c = (QnCollapse){ 0 };
}

void
qn_collapse_start (QnCollapse *c, const double *y, double lambda, double strength,
                   double coupling)
{
  const QnIpProblem *p = c->problem;
  size_t size = 2 * (size_t) p->cell_count * sizeof (double);

  memset (c->at.v, 0, (size_t) p->row_count * sizeof (double));
  if (y != NULL)
    memcpy (c->at.y, y, size);
  else
    memset (c->at.y, 0, size);
  c->at.lambda = lambda;
  c->least_coupling = coupling;
  qn_ip_apply_bounds (p, c->at.y, c->rz);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = fmax (p->bounds[i].limit - c->rz[i], 0);
    c->at.s[i] = 0.5 * (left + hypot (left, 2 * strength));
    c->at.z[i] = strength / c->at.s[i];
  }
}

static void
find_residuals (QnCollapse *c)
{
  const QnIpProblem *p = c->problem;

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->ry[i] = p->cells[i / 2].no_shear && i % 2 == 1
                 ? 0
                 : -p->cells[i / 2].quadratic[i % 2] * c->at.y[i];
  qn_ip_add_rates (p, c->at.v, -1, c->ry);
  qn_ip_add_flows (p, c->at.z, -1, c->ry);
  qn_interior_point_balance (p, c->at.y, c->at.lambda, 1, c->rv);
  for (int32_t r = 0; r < p->row_count; r++)
    c->rv[r] = -c->rv[r];
  qn_ip_apply_bounds (p, c->at.y, c->rz);
  for (int32_t i = 0; i < p->bound_count; i++)
    c->rz[i] = p->bounds[i].limit - c->at.s[i] - c->rz[i];
  c->r_lambda = p->load_gain - qn_ip_dot (p->load, c->at.v, p->row_count);
}

/* The direction that takes `share` off the residuals and has c->products as s dz + z ds. */
static QnStatus
solve_for_share (QnCollapse *c, double share, QnIpVector *out, QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  QnIpKktVector solution = { out->y, out->s, out->v, 0 };

  for (int32_t i = 0; i < p->bound_count; i++)
    out->z[i] = c->products[i] / c->at.s[i] - c->w[i] * share * c->rz[i];
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->right.y[i] = share * c->ry[i];
  qn_ip_add_flows (p, out->z, -1, c->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    c->right.v[r] = share * c->rv[r];
  c->right.lambda = share * c->r_lambda;
  QnStatus status = qn_ip_kkt_solve (&c->kkt, &c->right, &solution, diag);
  if (status)
    return status;
  out->lambda = solution.lambda;
  for (int32_t i = 0; i < p->bound_count; i++) {
    out->s[i] = share * c->rz[i] - out->s[i];
    out->z[i] = (c->products[i] - c->at.z[i] * out->s[i]) / c->at.s[i];
  }
  return QN_OK;
}

/* at += part * step, or the same of another vector. */
static void
add (const QnIpProblem *p, QnIpVector *to, double part, const QnIpVector *step)
{
  qn_ip_add_multiple (to->y, part, step->y, 2 * p->cell_count);
  qn_ip_add_multiple (to->v, part, step->v, p->row_count);
  qn_ip_add_multiple (to->s, part, step->s, p->bound_count);
  qn_ip_add_multiple (to->z, part, step->z, p->bound_count);
  to->lambda += part * step->lambda;
}

/* How often the step can be made until some s or z vanishes. */
static double
way_to_boundary (const QnCollapse *c, const QnIpVector *step)
{
  double most = 1e-300;

  for (int32_t i = 0; i < c->problem->bound_count; i++)
    most = fmax (most, fmax (-step->s[i] / c->at.s[i], -step->z[i] / c->at.z[i]));
  return 1 / most;
}

/* Whether the iterate is a collapse: rates are those of flows and compliance, forces balance and are
 * strictly within the strength. `power`: z's, the sum of all products. */
static bool
is_collapse (const QnCollapse *c, double power, double tolerance)
{
  const QnIpProblem *p = c->problem;
  double forces = fmax (1, qn_ip_largest (c->at.y, 2 * p->cell_count));
  double speed = qn_ip_largest (c->at.v, p->row_count);

  return power <= tolerance * p->load_gain * fmax (fabs (c->at.lambda), tolerance)
         && fabs (c->r_lambda) <= RATE_RESIDUAL * p->load_gain
         && qn_ip_largest (c->rv, p->row_count) <= FORCE_RESIDUAL * forces
         && qn_ip_largest (c->rz, p->bound_count) <= FORCE_RESIDUAL * forces
         && qn_ip_largest (c->ry, 2 * p->cell_count) <= RATE_RESIDUAL * speed;
}

/* What has to be added to a product that would leave the neighbourhood of the target. */
static double
centre_collapse (double product, double target)
{
  double low = target / tuning.spread, high = target * tuning.spread;

  if (product < low)
    return low - product;
  return product > high ? fmax (high - product, -high) : 0;
}

static void
exchange (QnIpVector *a, QnIpVector *b)
{
  QnIpVector swap = *a;

  *a = *b;
  *b = swap;
}

/* The step that lowers mu, as far as the predictor says; *length: how much of it may be gone. */
static QnStatus
find_step (QnCollapse *c, double power, double *length, QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  QnIpVector *step = &c->step;
  double left = 0;

  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = -c->at.s[i] * c->at.z[i];
  QnStatus status = solve_for_share (c, 1, step, diag);
  if (status)
    return status;
  double whole = fmin (1, way_to_boundary (c, step));
  for (int32_t i = 0; i < p->bound_count; i++)
    left += (c->at.s[i] + whole * step->s[i]) * (c->at.z[i] + whole * step->z[i]);
  double part = fmax (tuning.least_aim, pow (left / power, tuning.exponent));
  double target = part * power / p->bound_count;
  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = target - c->at.s[i] * c->at.z[i] - step->s[i] * step->z[i];
  status = solve_for_share (c, 1 - part, step, diag);
  *length = way_to_boundary (c, step);
  for (int32_t k = 0; !status && k < tuning.correctors && *length < tuning.full_step;
       k++) {
    double aim = fmin (1, 1.3 * *length + 0.1);
    for (int32_t i = 0; i < p->bound_count; i++)
      c->products[i] += centre_collapse (
        (c->at.s[i] + aim * step->s[i]) * (c->at.z[i] + aim * step->z[i]), target);
    status = solve_for_share (c, 1 - part, &c->trial, diag);
    double reached = way_to_boundary (c, &c->trial);
    if (reached < *length + tuning.gain)
      break;
    exchange (step, &c->trial);
    *length = reached;
  }
  return status;
}

/* Factorises for the iterate. *ok is false where the system has no solution. */
static QnStatus
factorize_collapse (QnCollapse *c, bool *ok, QnDiag *diag)
{
  for (int32_t i = 0; i < c->problem->bound_count; i++)
    c->w[i] = c->at.z[i] / c->at.s[i];
  return qn_ip_kkt_factorize (&c->kkt, c->w, ok, diag);
}

/* Whether the matrix has as many negative eigenvalues as one of associative flow, or by an even number
 * more. */
static bool
is_stable (const QnIpKkt *kkt)
{
  return (qn_block_lu_sign (kkt->schur.lu) > 0) == (kkt->border_power > 0);
}

/* d lambda / d log (1 / compliance) at a collapse: the tangent of its equations. */
static QnStatus
find_growth (QnCollapse *c, QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  QnIpKktVector solution = { c->step.y, c->step.s, c->step.v, 0 };
  QnStatus status = QN_OK;
  bool ok = true;

  if (c->kkt.coupling < 1) {
    c->kkt.coupling = 1;
    status = factorize_collapse (c, &ok, diag);
  }
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->right.y[i] = p->cells[i / 2].quadratic[i % 2] * c->at.y[i];
  memset (c->right.v, 0, (size_t) p->row_count * sizeof (double));
  c->right.lambda = 0;
  if (!status && ok)
    status = qn_ip_kkt_solve (&c->kkt, &c->right, &solution, diag);
  c->growth = ok ? solution.lambda : INFINITY;
  return status;
}

QnStatus
qn_collapse_follow (QnCollapse *c, double tolerance, int32_t budget,
                    bool (*go_on) (void *), void *data, QnCollapseState *state,
                    QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  double *coupling = &c->kkt.coupling;
  QnStatus status = QN_OK;
  bool ok = true;

  *coupling = 1;
  *state = QN_COLLAPSE_LOST;
  for (int32_t iteration = 0; !status && ok; iteration++) {
    find_residuals (c);
    double power = qn_ip_dot (c->at.s, c->at.z, p->bound_count), length = 0;
    double least = c->least_coupling;
    if (iteration > 0 && is_collapse (c, power, tolerance)) {
      *state = QN_COLLAPSE_FOUND;
      return find_growth (c, diag);
    }
    if (iteration == budget || !isfinite (power))
      return QN_OK;
    if (!go_on (data)) {
      *state = QN_COLLAPSE_CANCELLED;
      return QN_OK;
    }
    status = factorize_collapse (c, &ok, diag);
    if (status || !ok)
      return status;
    if (is_stable (&c->kkt)) {
      status = find_step (c, power, &length, diag);
      if (status || !(c->kkt.error < WORST_ERROR))
        return status;
      add (p, &c->at, fmin (1, tuning.to_boundary * length), &c->step);
    } else if (*coupling <= least) {
      least = 0;
    }
    if (length < tuning.short_step)
      *coupling = fmax (least, *coupling - tuning.less);
    else if (length > tuning.long_step)
      *coupling = fmin (1, *coupling + tuning.more);
  }
  return status;
}
