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
  int32_t correctors; /* of centrality, for steps shorter than `long_step` */
  double long_step, spread,
    gain;            /* products are brought within `spread` of mu, a corrector gains */
  double short_step; /* a step shorter than this: the curve is traced */
  double leave;      /* and no longer once the tangent reaches this part of mu */
  double pace, most_pace; /* length along the tangent, in lengths to the boundary */
  double near, nearest;   /* products within this of mu: the pace is halved, or doubled */
  double centred;         /* products beyond this: no step along the tangent */
} tuning = {
  .to_boundary = 0.9,
  .exponent = 3,
  .least_aim = 1e-6,
  .correctors = 4,
  .long_step = 0.9,
  .spread = 5,
  .gain = 0.01,
  .short_step = 0.05,
  .leave = 0.5,
  .pace = 0.5,
  .most_pace = 4,
  .near = 4,
  .nearest = 1.5,
  .centred = 10,
};

/* Residuals at a collapse: of forces, relative to the largest; of rates, to the largest velocity. */
#define FORCE_RESIDUAL 1e-8
#define RATE_RESIDUAL  1e-5

/* Proximal term of the linear systems (interior-point-kkt.h). */
#define REGULARIZATION 1e-12

/* An error of the linear systems above this is no direction. */
#define WORST_SOLUTION 1e-3

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
            && qn_ip_vector_init (&c->at, p) && qn_ip_vector_init (&c->tangent, p)
            && qn_ip_vector_init (&c->step, p) && qn_ip_vector_init (&c->trial, p);
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
  qn_ip_vector_clear (&c->tangent);
  qn_ip_vector_clear (&c->step);
  qn_ip_vector_clear (&c->trial);
  qn_ip_kkt_clear (&c->kkt);
  *c = (QnCollapse){ 0 };
}

void
qn_collapse_start (QnCollapse *c, const double *y, double lambda, double strength)
{
  const QnIpProblem *p = c->problem;
  size_t size = 2 * (size_t) p->cell_count * sizeof (double);

  memset (c->at.v, 0, (size_t) p->row_count * sizeof (double));
  if (y != NULL)
    memcpy (c->at.y, y, size);
  else
    memset (c->at.y, 0, size);
  c->at.lambda = lambda;
  c->remaining = 1;
  c->first_product = strength;
  qn_ip_apply_bounds (p, c->at.y, c->rz);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = fmax (p->bounds[i].limit - c->rz[i], 0);
    c->at.s[i] = 0.5 * (left + hypot (left, 2 * strength));
    c->at.z[i] = c->first_product / c->at.s[i];
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
solve_direction (QnCollapse *c, double share, QnIpVector *out, QnDiag *diag)
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

/* How often the step, in this sense, can be made until some s or z vanishes. */
static double
way_to_boundary (const QnCollapse *c, const QnIpVector *step, double sense)
{
  double most = 1e-300;

  for (int32_t i = 0; i < c->problem->bound_count; i++)
    most = fmax (
      most, fmax (-sense * step->s[i] / c->at.s[i], -sense * step->z[i] / c->at.z[i]));
  return 1 / most;
}

/* a . b of the relative changes of s and z. */
static double
product (const QnCollapse *c, const QnIpVector *a, const QnIpVector *b)
{
  double sum = 0;

  for (int32_t i = 0; i < c->problem->bound_count; i++)
    sum += a->s[i] * b->s[i] / (c->at.s[i] * c->at.s[i])
           + a->z[i] * b->z[i] / (c->at.z[i] * c->at.z[i]);
  return sum;
}

/* Products and residuals of the iterate. */
typedef struct {
  double mu;        /* what all products s z are to be */
  double sum;       /* of s z */
  double low, high; /* least and greatest, over mu */
} Products;

static Products
find_products (const QnCollapse *c)
{
  Products found = { .mu = c->remaining * c->first_product, .low = INFINITY };

  for (int32_t i = 0; i < c->problem->bound_count; i++) {
    double product = c->at.s[i] * c->at.z[i];
    found.sum += product;
    found.low = fmin (found.low, product / found.mu);
    found.high = fmax (found.high, product / found.mu);
  }
  return found;
}

/* Whether the iterate is a collapse: rates are those of flows and compliance, forces balance and are
 * strictly within the strength. */
static bool
is_collapse (const QnCollapse *c, const Products *products, double tolerance)
{
  const QnIpProblem *p = c->problem;
  double forces = fmax (1, qn_ip_largest (c->at.y, 2 * p->cell_count));
  double speed = qn_ip_largest (c->at.v, p->row_count);

  return products->sum <= tolerance * p->load_gain * fmax (fabs (c->at.lambda), tolerance)
         && fabs (c->r_lambda) <= RATE_RESIDUAL * p->load_gain
         && qn_ip_largest (c->rv, p->row_count) <= FORCE_RESIDUAL * forces
         && qn_ip_largest (c->rz, p->bound_count) <= FORCE_RESIDUAL * forces
         && qn_ip_largest (c->ry, 2 * p->cell_count) <= RATE_RESIDUAL * speed;
}

/* What has to be added to a product that would leave the neighbourhood of the target. */
static double
centre (double product, double target)
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

/* The step that lowers mu, as far as the predictor says; *share: the part of the residuals that it
 * takes off, *length: how much of it may be gone. */
static QnStatus
find_descent (QnCollapse *c, const Products *now, double *share, double *length,
              QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  QnIpVector *step = &c->step;
  double left = 0, aim = 1;

  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = -c->at.s[i] * c->at.z[i];
  QnStatus status = solve_direction (c, 1, step, diag);
  if (status)
    return status;
  *length = fmin (1, way_to_boundary (c, step, 1));
  for (int32_t i = 0; i < p->bound_count; i++)
    left += (c->at.s[i] + *length * step->s[i]) * (c->at.z[i] + *length * step->z[i]);
  double part = fmax (tuning.least_aim, pow (left / now->sum, tuning.exponent));
  double target = part * now->mu;
  *share = 1 - part;
  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = target - c->at.s[i] * c->at.z[i] - step->s[i] * step->z[i];
  status = solve_direction (c, *share, step, diag);
  *length = fmin (1, way_to_boundary (c, step, 1));
  for (int32_t k = 0; !status && k < tuning.correctors && *length < tuning.long_step;
       k++) {
    aim = fmin (1, 1.3 * *length + 0.1);
    for (int32_t i = 0; i < p->bound_count; i++)
      c->products[i] += centre (
        (c->at.s[i] + aim * step->s[i]) * (c->at.z[i] + aim * step->z[i]), target);
    status = solve_direction (c, *share, &c->trial, diag);
    double reached = fmin (1, way_to_boundary (c, &c->trial, 1));
    if (reached < *length + tuning.gain)
      break;
    exchange (step, &c->trial);
    *length = reached;
  }
  return status;
}

/* The step along the curve: `part` of the tangent, and at right angles to it back to the curve. */
static QnStatus
find_trace (QnCollapse *c, const Products *now, double part, double *share,
            double *length, QnDiag *diag)
{
  const QnIpVector *tangent = &c->tangent;

  for (int32_t i = 0; i < c->problem->bound_count; i++)
    c->products[i] =
      now->mu - c->at.s[i] * c->at.z[i] - part * part * tangent->s[i] * tangent->z[i];
  QnStatus status = solve_direction (c, 0, &c->step, diag);
  *share = part - product (c, tangent, &c->step) / product (c, tangent, tangent);
  add (c->problem, &c->step, *share, tangent);
  *length = fmin (1, way_to_boundary (c, &c->step, 1));
  return status;
}

/* d lambda / d log (1 / compliance) at a collapse: the tangent of its equations, by one more solution of
 * the last linear system. */
static QnStatus
find_growth (QnCollapse *c, QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  QnIpKktVector solution = { c->step.y, c->step.s, c->step.v, 0 };

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->right.y[i] = p->cells[i / 2].quadratic[i % 2] * c->at.y[i];
  memset (c->right.v, 0, (size_t) p->row_count * sizeof (double));
  c->right.lambda = 0;
  QnStatus status = qn_ip_kkt_solve (&c->kkt, &c->right, &solution, diag);
  c->growth = solution.lambda;
  return status;
}

QnStatus
qn_collapse_follow (QnCollapse *c, double tolerance, int32_t budget,
                    bool (*go_on) (void *), void *data, QnCollapseState *state,
                    QnDiag *diag)
{
  const QnIpProblem *p = c->problem;
  double pace = tuning.pace, share = 0, length = 1;
  bool traces = false;
  QnStatus status = QN_OK;

  *state = QN_COLLAPSE_LOST;
  for (int32_t iteration = 0; !status; iteration++) {
    find_residuals (c);
    const Products now = find_products (c);
    if (iteration > 0 && is_collapse (c, &now, tolerance)) {
      *state = QN_COLLAPSE_FOUND;
      return find_growth (c, diag);
    }
    if (iteration == budget || !isfinite (now.sum))
      return QN_OK;
    if (!go_on (data)) {
      *state = QN_COLLAPSE_CANCELLED;
      return QN_OK;
    }

    bool ok;
    for (int32_t i = 0; i < p->bound_count; i++) {
      c->w[i] = c->at.z[i] / c->at.s[i];
      c->products[i] = -now.mu;
    }
    status = qn_ip_kkt_factorize (&c->kkt, c->w, &ok, diag);
    if (status || !ok)
      return status;
    status = solve_direction (c, 1, &c->tangent, diag);
    if (status)
      return status;
    double sense =
      qn_block_lu_sign (c->kkt.schur.lu) * (c->kkt.border_power > 0 ? 1 : -1);
    double reach = way_to_boundary (c, &c->tangent, sense);
    bool traced = traces;
    traces = sense < 0 || (traced ? reach < tuning.leave : length < tuning.short_step);
    if (traces && !traced)
      pace = tuning.pace;
    if (traces) {
      double apart = fmax (now.high, 1 / now.low), part = 0;
      if (apart < tuning.nearest)
        pace = fmin (tuning.most_pace, 2 * pace);
      else if (apart > tuning.near)
        pace = fmax (0.2, 0.5 * pace);
      if (apart < tuning.centred)
        part = sense > 0 ? fmin (0.9, pace * reach) : -fmin (3, pace * reach);
      status = find_trace (c, &now, part, &share, &length, diag);
    } else {
      status = find_descent (c, &now, &share, &length, diag);
    }
    if (status || !(c->kkt.error < WORST_SOLUTION))
      return status;
    double taken = fmin (1, tuning.to_boundary * length);
    c->remaining *= 1 - taken * share;
    add (p, &c->at, taken, &c->step);
  }
  return status;
}
