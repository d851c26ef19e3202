#include "core/limit/collapse.h"

#include "core/base/numbers.h"

#include <math.h>
#include <string.h>

/* What steers the method; numbers without a unit are parts. Measured on the six walls and 48 seeded
 * walls of 20 to 600 blocks (docs/experiments/limit-analysis.md). */
static const struct {
  double elastic; /* of the largest elastic force, the strength that is left at a start */
  double to_boundary; /* of the way to where some s or z vanishes, at least */
  double exponent;    /* of what the predictor leaves of mu, for the mu aimed at */
  double least_aim;   /* of mu, in one step */
  int32_t correctors; /* of centrality, for steps shorter than `full_step` */
  double full_step;
  double spread;     /* of products about mu: correctors bring them within */
  double gain;       /* of length, by a corrector that is worth another */
  double short_step; /* a step shorter than this lowers the coupling, */
  double long_step;  /* a longer one than this raises it, */
  double less, more; /* by so much */
  double balance;    /* out-of-balance at a collapse, of the largest force */
  double proof;      /* what a certificate leaves, of what it proves */
  int32_t
    idle; /* iterations without a better one, after which rounding has ended the progress
                        of associative flow */
  double restored; /* out-of-balance of projected forces, in units of force, */
  int32_t
    rounds; /* by so many solves at most: each removes the rounding of the one before */
  double flow; /* proximal term of a flow of its own, in units of force over rate */
  /* Proximal term of the linear systems (interior-point-kkt.h): least, most, and the factor by which it
   * grows where the error of a solution is above the worst that is a direction. */
  double least_proximal, most_proximal, more_proximal, worst_solution;
} tuning = {
  .elastic = 0.3,
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
  .balance = 1e-8,
  .proof = 1e-8,
  .idle = 15,
  .restored = 1e-13,
  .rounds = 3,
  .flow = 1e-8,
  .least_proximal = 1e-10,
  .most_proximal = 1e-5,
  .more_proximal = 30,
  .worst_solution = 1e-3,
};

QnStatus
qn_collapse_init (QnCollapse *c, const QnIpProblem *p, QnDiag *diag)
{
  size_t cells = (size_t) p->cell_count, rows = (size_t) p->row_count,
         bounds = (size_t) p->bound_count;
  QnPool *pool = &c->pool;

  *c = (QnCollapse){ .problem = p };
  c->w = qn_pool_alloc (pool, bounds, sizeof (double));
  c->rz = qn_pool_alloc (pool, bounds, sizeof (double));
  c->products = qn_pool_alloc (pool, bounds, sizeof (double));
  c->ry = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  c->right.y = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  c->rv = qn_pool_alloc (pool, rows, sizeof (double));
  c->right.v = qn_pool_alloc (pool, rows, sizeof (double));
  qn_ip_vector_init (&c->at, p, pool);
  qn_ip_vector_init (&c->step, p, pool);
  qn_ip_vector_init (&c->trial, p, pool);
  if (qn_ip_kkt_init (&c->kkt, p) && !pool->failed)
    return QN_OK;
  qn_collapse_clear (c);
  return qn_diag_no_memory (diag);
}

void
qn_collapse_clear (QnCollapse *c)
{
  qn_ip_kkt_clear (&c->kkt);
  qn_pool_clear (&c->pool);
  *c = (QnCollapse){ 0 };
}

void
qn_collapse_centre (QnCollapse *c, double strength)
{
  const QnIpProblem *p = c->problem;

  qn_ip_apply_bounds (p, c->at.y, c->rz);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = fmax (p->bounds[i].limit - c->rz[i], 0);
    c->at.s[i] = 0.5 * (left + hypot (left, 2 * strength));
    c->at.z[i] = strength / c->at.s[i];
  }
}

void
qn_collapse_start (QnCollapse *c, const double *y, double lambda, double strength,
                   double coupling)
{
  const QnIpProblem *p = c->problem;
  size_t size = 2 * (size_t) p->cell_count * sizeof (double);

  c->least_coupling = coupling;
  c->excess = 0;
  c->least_multiplier = QN_COLLAPSE_LEAST;
  memset (c->at.v, 0, (size_t) p->row_count * sizeof (double));
  if (y != NULL)
    memcpy (c->at.y, y, size);
  else
    memset (c->at.y, 0, size);
  c->at.lambda = lambda;
  qn_collapse_centre (c, strength);
}

void
qn_collapse_start_elastic (QnCollapse *c)
{
  const QnIpProblem *p = c->problem;
  double lambda = 0, residual, slack, *y = c->step.y;

  qn_collapse_start (c, NULL, 0, 1, 1);
  for (int32_t i = 0; i < p->bound_count; i++) {
    c->w[i] = 1;
    c->rz[i] = 0;
  }
  c->kkt.regularization = tuning.least_proximal;
  if (!qn_ip_kkt_factorize (&c->kkt, c->w))
    return;
  qn_collapse_project (c, true, &lambda, y, &residual, &slack);
  qn_collapse_centre (c, fmax (1, tuning.elastic * qn_ip_largest (y, 2 * p->cell_count)));
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
  qn_ip_balance (p, c->at.y, c->at.lambda, c->rv);
  for (int32_t r = 0; r < p->row_count; r++)
    c->rv[r] = -c->rv[r];
  qn_ip_apply_bounds (p, c->at.y, c->rz);
  for (int32_t i = 0; i < p->bound_count; i++)
    c->rz[i] = p->bounds[i].limit - c->at.s[i] - c->rz[i];
  c->power = qn_dot (c->at.s, c->at.z, (size_t) p->bound_count);
  c->r_lambda =
    p->load != NULL ? p->load_gain - qn_dot (p->load, c->at.v, (size_t) p->row_count) : 0;
}

/* Without dilatancy the flows of both directions in which an open joint may slip cancel: they may grow
 * together without end. A proximal term holds them: of a step it leaves itself times the change of a
 * flow in the strength of its row, G y + s - term z = h, and that vanishes as steps do. The end of a path
 * is found without: of 12 ends of seeded walls one had a state then that its forces do not have. */
static double
flow_term (const QnCollapse *c)
{
  return c->own_flow && c->holds_flows ? tuning.flow : 0;
}

static double
yielding (const QnCollapse *c, int32_t i)
{
  return c->at.s[i] + flow_term (c) * c->at.z[i];
}

/* The direction that takes `share` off the residuals and has c->products as s dz + z ds. */
static void
solve_for_share (QnCollapse *c, double share, QnIpVector *out)
{
  const QnIpProblem *p = c->problem;
  QnIpKktVector solution = { out->y, out->s, out->v, 0 };

  for (int32_t i = 0; i < p->bound_count; i++)
    out->z[i] = (c->products[i] - c->at.z[i] * share * c->rz[i]) / yielding (c, i);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->right.y[i] = share * c->ry[i];
  qn_ip_add_flows (p, out->z, -1, c->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    c->right.v[r] = share * c->rv[r];
  c->right.lambda = share * c->r_lambda;
  qn_ip_kkt_solve (&c->kkt, &c->right, &solution);
  out->lambda = solution.lambda;
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = share * c->rz[i] - out->s[i];
    out->z[i] = (c->products[i] - c->at.z[i] * left) / yielding (c, i);
    out->s[i] = left + flow_term (c) * out->z[i];
  }
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

bool
qn_collapse_proves_infeasible (const QnCollapse *c, const QnIpProblem *p)
{
  double power = qn_dot (p->constant, c->at.v, (size_t) p->row_count);
  double proof = power - qn_ip_limit_term (p, c->at.z), worst = 0;

  if (c->problem->load != NULL)
    worst = fabs (p->load_gain - c->r_lambda);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    worst =
      qn_worse (worst, fabs (c->ry[i] + p->cells[i / 2].quadratic[i % 2] * c->at.y[i]));
  return worst <= tuning.proof * proof;
}

/* Whether y and lambda prove that the multiplier has no bound: forces that balance the live load alone,
 * whatever the strength. */
static bool
proves_unbounded (const QnCollapse *c)
{
  const QnIpProblem *p = c->problem;
  double proof = c->at.lambda, worst = 0;

  if (p->load == NULL)
    return false;
  for (int32_t r = 0; r < p->row_count; r++)
    worst = qn_worse (worst, fabs (c->rv[r] + p->constant[r]));
  for (int32_t i = 0; i < p->bound_count; i++) /* Gy = -s + (h - rz), s >= 0 */
    worst = qn_worse (worst, p->bounds[i].limit - c->rz[i]);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    worst = qn_worse (worst, fabs (p->cells[i / 2].quadratic[i % 2] * c->at.y[i]));
  return worst <= tuning.proof * proof;
}

/* How many times as much as a collapse may have the iterate has of what vanishes there: products compared
 * with the work of the live load, out-of-balance forces, excess of the strength, and rates that are not
 * those of flows and compliance. */
static double
find_misfit (const QnCollapse *c, double tolerance)
{
  const QnIpProblem *p = c->problem;
  double work = p->load != NULL
                  ? p->load_gain * fmax (fabs (c->at.lambda), c->least_multiplier)
                  : 1 + qn_ip_quadratic_term (p, c->at.y);
  double forces = tuning.balance * fmax (1, qn_ip_largest (c->at.y, 2 * p->cell_count));
  double speed =
    fmax (p->load != NULL ? 1e-300 : 1, qn_ip_largest (c->at.v, p->row_count));
  double misfit =
    qn_worse (c->power / work, qn_ip_largest (c->ry, 2 * p->cell_count) / speed);

  if (p->load != NULL)
    misfit = qn_worse (misfit, fabs (c->r_lambda) / p->load_gain);
  misfit = qn_worse (misfit / tolerance, qn_ip_largest (c->rv, p->row_count) / forces);
  return qn_worse (misfit, qn_ip_largest (c->rz, p->bound_count) / forces);
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

/* What s'z is lowered to at least: products that vanish ahead of what is left out of the strengths hold
 * every later step back. */
static double
least_power (const QnCollapse *c)
{
  double excess = 0;

  for (int32_t i = 0; c->own_flow && i < c->problem->bound_count; i++)
    excess += fabs (c->rz[i]) * c->at.z[i];
  return fmin (c->power, c->excess * excess);
}

/* The step that lowers mu, as far as the predictor says. Returns how much of it may be gone until some
 * s or z vanishes; *part: what it leaves of residuals and mu. */
static double
find_step (QnCollapse *c, double *part)
{
  const QnIpProblem *p = c->problem;
  QnIpVector *step = &c->step;
  double left = 0;

  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = -c->at.s[i] * c->at.z[i];
  solve_for_share (c, 1, step);
  double whole = fmin (1, way_to_boundary (c, step));
  for (int32_t i = 0; i < p->bound_count; i++)
    left += (c->at.s[i] + whole * step->s[i]) * (c->at.z[i] + whole * step->z[i]);
  *part =
    fmax (tuning.least_aim, c->power > 0 ? pow (left / c->power, tuning.exponent) : 0);
  double target = fmax (*part * c->power, least_power (c)) / p->bound_count;
  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = target - c->at.s[i] * c->at.z[i] - step->s[i] * step->z[i];
  solve_for_share (c, 1 - *part, step);
  double length = way_to_boundary (c, step);
  for (int32_t k = 0; k < tuning.correctors && length < tuning.full_step; k++) {
    double aim = fmin (1, 1.3 * length + 0.1);
    for (int32_t i = 0; i < p->bound_count; i++)
      c->products[i] += centre_collapse (
        (c->at.s[i] + aim * step->s[i]) * (c->at.z[i] + aim * step->z[i]), target);
    solve_for_share (c, 1 - *part, &c->trial);
    double reached = way_to_boundary (c, &c->trial);
    if (reached < length + tuning.gain)
      break;
    exchange (step, &c->trial);
    length = reached;
  }
  return length;
}

/* Factorises for the iterate; false where the system has no solution. */
static bool
factorize_collapse (QnCollapse *c)
{
  for (int32_t i = 0; i < c->problem->bound_count; i++)
    c->w[i] = c->at.z[i] / yielding (c, i);
  return qn_ip_kkt_factorize (&c->kkt, c->w);
}

/* Whether the matrix has as many negative eigenvalues as one of associative flow, or by an even number
 * more. */
static bool
is_stable (const QnCollapse *c)
{
  return !c->own_flow
         || (qn_block_lu_sign (c->kkt.schur.lu) > 0) == (c->kkt.border_power > 0);
}

/* d lambda / d log (1 / compliance) at a collapse: the tangent of its equations. */
static void
find_growth (QnCollapse *c)
{
  const QnIpProblem *p = c->problem;
  QnIpKktVector solution = { c->step.y, c->step.s, c->step.v, INFINITY };

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->right.y[i] = p->cells[i / 2].quadratic[i % 2] * c->at.y[i];
  memset (c->right.v, 0, (size_t) p->row_count * sizeof (double));
  c->right.lambda = 0;
  bool exact = c->kkt.coupling == 1;
  c->kkt.coupling = 1;
  if (exact || factorize_collapse (c))
    qn_ip_kkt_solve (&c->kkt, &c->right, &solution);
  c->growth = solution.lambda;
}

/* What the iterate is. */
static QnCollapseState
judge_iterate (const QnCollapse *c, double misfit)
{
  if (misfit <= 1)
    return QN_COLLAPSE_FOUND;
  if (!c->own_flow && qn_collapse_proves_infeasible (c, c->problem))
    return QN_COLLAPSE_INFEASIBLE;
  return !c->own_flow && proves_unbounded (c) ? QN_COLLAPSE_UNBOUNDED : QN_COLLAPSE_LOST;
}

/* Takes a step, or regularises more. Returns how much of the step may be gone; *ok is false where there
 * is none. */
static double
step_on (QnCollapse *c, bool *ok)
{
  double part, length = find_step (c, &part);

  if (c->kkt.error < tuning.worst_solution) {
    double reach = c->own_flow ? 0 : 1 - part;
    qn_ip_vector_add (&c->at, fmin (1, fmax (tuning.to_boundary, reach) * length),
                      &c->step, c->problem);
  } else {
    *ok = c->kkt.regularization < tuning.most_proximal;
    c->kkt.regularization *= tuning.more_proximal;
    length = tuning.short_step;
  }
  return length;
}

QnCollapseState
qn_collapse_follow (QnCollapse *c, double tolerance, int32_t budget,
                    bool (*go_on) (void *), void *data)
{
  const QnIpProblem *p = c->problem;
  double *coupling = &c->kkt.coupling, least = c->least_coupling, best = INFINITY;
  int32_t idle = 0;
  bool ok = true;

  c->own_flow = false;
  for (int32_t i = 0; i < p->bound_count; i++)
    c->own_flow |= p->bounds[i].normal != p->bounds[i].opening;
  c->kkt.regularization = tuning.least_proximal;
  *coupling = 1;
  for (int32_t iteration = 0; ok; iteration++) {
    find_residuals (c);
    double misfit = find_misfit (c, tolerance), length = 0;
    QnCollapseState state = iteration > 0 ? judge_iterate (c, misfit) : QN_COLLAPSE_LOST;
    if (state == QN_COLLAPSE_FOUND)
      find_growth (c);
    idle = misfit < best ? 0 : idle + 1;
    best = fmin (best, misfit);
    if (state != QN_COLLAPSE_LOST || iteration == budget || isnan (misfit)
        || (!c->own_flow && idle == tuning.idle))
      return state;
    if (!go_on (data))
      return QN_COLLAPSE_CANCELLED;
    ok = factorize_collapse (c);
    if (ok && is_stable (c))
      length = step_on (c, &ok);
    else if (*coupling <= least)
      least = c->holds_flows ? least - tuning.less : 0;
    if (length < tuning.short_step)
      *coupling = fmax (least, *coupling - tuning.less);
    else if (length > tuning.long_step)
      *coupling = fmin (1, *coupling + tuning.more);
  }
  return QN_COLLAPSE_LOST;
}

void
qn_collapse_project (QnCollapse *c, bool fixed, double *lambda, double *y,
                     double *residual, double *slack)
{
  const QnIpProblem *p = c->problem;

  memcpy (y, c->at.y, 2 * (size_t) p->cell_count * sizeof *y);
  *residual = INFINITY;
  *slack = -INFINITY;
  if (!isfinite (c->kkt.error))
    return;
  memset (c->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  for (int32_t i = 0; i < p->bound_count; i++)
    c->products[i] = c->w[i] * c->rz[i];
  qn_ip_add_flows (p, c->products, 1, c->right.y);
  c->right.lambda = 0;
  c->kkt.bordered = p->load != NULL && !fixed;
  for (int round = 0;; round++) {
    QnIpKktVector step = { c->trial.y, c->trial.s, c->trial.v, 0 };
    qn_ip_balance (p, y, *lambda, c->right.v);
    *residual = qn_ip_largest (c->right.v, p->row_count);
    if (round > 0 && (*residual <= tuning.restored || round == tuning.rounds))
      break;
    for (int32_t r = 0; r < p->row_count; r++)
      c->right.v[r] = -c->right.v[r];
    qn_ip_kkt_solve (&c->kkt, &c->right, &step);
    qn_ip_add_multiple (y, 1, step.y, 2 * p->cell_count);
    *lambda += step.lambda;
    memset (c->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  }
  c->kkt.bordered = p->load != NULL;
  qn_ip_apply_bounds (p, y, c->trial.s);
  *slack = INFINITY;
  for (int32_t i = 0; i < p->bound_count; i++)
    *slack = fmin (*slack, p->bounds[i].limit - c->trial.s[i]);
}
