#include "core/limit/collapse.h"

#include "core/base/numbers.h"

#include <math.h>
#include <string.h>

/* What steers the method; numbers without a unit are parts. Measured on the six walls and 48 seeded
 * walls of 20 to 600 blocks (docs/experiments/limit-analysis.md). */
static const struct {
  double elastic; /* of the largest elastic force, the strength that is left at a start */
  double to_boundary; /* of the way to where some s or z vanishes, at least */
  QnIpTuning steps;
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
  double closer; /* the part of the gap to which a turn of two programs has to bring it */
  double flow;   /* proximal term of a flow of its own, in units of force over rate */
  /* Proximal term of the linear systems (interior-point-kkt.h): least, most, and the factor by which it
   * grows where the error of a solution is above the worst that is a direction. */
  double least_proximal, most_proximal, more_proximal, worst_solution;
} collapse_tuning = {
  .elastic = 0.3,
  .to_boundary = 0.9,
  .steps = { .exponent = 5,
             .least_aim = 1e-6,
             .correctors = 4,
             .full_step = 0.9,
             .spread = 5,
             .gain = 0.01 },
  .short_step = 0.1,
  .long_step = 0.3,
  .less = 0.1,
  .more = 0.05,
  .balance = 1e-8,
  .proof = 1e-8,
  .idle = 15,
  .restored = 1e-13,
  .rounds = 3,
  .closer = 0.8,
  .flow = 1e-8,
  .least_proximal = 1e-10,
  .most_proximal = 1e-5,
  .more_proximal = 30,
  .worst_solution = 1e-3,
};

/* The linear system of a step. */
static void
solve_iteration (QnIpStep *ip, double share, QnIpVector *out)
{
  QnCollapse *c = (QnCollapse *) ip;
  const QnIpVector right = { .y = ip->right,
                             .v = c->right_v,
                             .lambda = share * c->r_lambda };

  for (int32_t r = 0; r < c->ip.problem->row_count; r++)
    c->right_v[r] = share * c->rv[r];
  qn_ip_kkt_solve (&c->kkt, &right, out);
}

QnStatus
qn_collapse_init (QnCollapse *c, const QnIpProblem *p, QnDiag *diag)
{
  size_t rows = (size_t) p->row_count;
  QnPool *pool = &c->pool;

  *c = (QnCollapse){ .ip = { .together = true, .solve = solve_iteration } };
  qn_ip_step_init (&c->ip, p, &collapse_tuning.steps, pool);
  c->given = qn_pool_alloc (pool, 2 * (size_t) p->cell_count, sizeof (double));
  c->bounds = qn_pool_alloc (pool, (size_t) p->bound_count, sizeof *c->bounds);
  qn_ip_vector_init (&c->kept, p, pool);
  c->rv = qn_pool_alloc (pool, rows, sizeof (double));
  c->right_v = qn_pool_alloc (pool, rows, sizeof (double));
  if (qn_ip_kkt_init (&c->kkt, &c->ip, &c->effort) && !pool->failed)
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
  const QnIpProblem *p = c->ip.problem;

  qn_ip_apply_bounds (p, c->ip.at.y, c->ip.rz);
  for (int32_t i = 0; i < p->bound_count; i++) {
    double left = fmax (p->bounds[i].limit - c->ip.rz[i], 0);
    c->ip.at.s[i] = 0.5 * (left + hypot (left, 2 * strength));
    c->ip.at.z[i] = strength / c->ip.at.s[i];
  }
}

void
qn_collapse_start (QnCollapse *c, const double *y, double lambda, double strength,
                   double coupling)
{
  const QnIpProblem *p = c->ip.problem;
  size_t size = 2 * (size_t) p->cell_count * sizeof (double);

  c->least_coupling = coupling;
  c->least_multiplier = QN_COLLAPSE_LEAST;
  memset (c->ip.at.v, 0, (size_t) p->row_count * sizeof (double));
  if (y != NULL)
    memcpy (c->ip.at.y, y, size);
  else
    memset (c->ip.at.y, 0, size);
  c->ip.at.lambda = lambda;
  qn_collapse_centre (c, strength);
}

void
qn_collapse_start_elastic (QnCollapse *c)
{
  const QnIpProblem *p = c->ip.problem;
  QnCollapseForces forces = { .y = c->ip.step.y };

  qn_collapse_start (c, NULL, 0, 1, 1);
  for (int32_t i = 0; i < p->bound_count; i++) {
    c->ip.w[i] = 1;
    c->ip.rz[i] = 0;
  }
  c->ip.inverse.regularization = collapse_tuning.least_proximal;
  if (!qn_ip_kkt_factorize (&c->kkt))
    return;
  qn_collapse_project (c, true, &forces);
  qn_collapse_centre (
    c, fmax (1, collapse_tuning.elastic * qn_ip_largest (forces.y, 2 * p->cell_count)));
}

/* out (row_count) = B y + lambda f + d */
static void
find_balance (const QnIpProblem *p, const double *y, double lambda, double *out)
{
  for (int32_t r = 0; r < p->row_count; r++)
    out[r] = p->constant[r] + (p->load ? lambda * p->load[r] : 0.0);
  qn_ip_add_forces (p, y, 1, out);
}

/* y'Qy */
static double
stored_work (const QnIpProblem *p, const double *y)
{
  double sum = 0.0;
  for (int32_t c = 0; c < p->cell_count; c++)
    sum += p->cells[c].quadratic[0] * y[2 * c] * y[2 * c]
           + p->cells[c].quadratic[1] * y[2 * c + 1] * y[2 * c + 1];
  return sum;
}

bool
qn_collapse_proves_infeasible (const QnCollapse *c, const QnIpProblem *p)
{
  double power = qn_dot (p->constant, c->ip.at.v, (size_t) p->row_count);
  double dissipated = 0, worst = 0;

  for (int32_t i = 0; i < p->bound_count; i++)
    dissipated += p->bounds[i].limit * c->ip.at.z[i];
  if (c->ip.problem->load != NULL)
    worst = fabs (p->load_gain - c->r_lambda);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    worst = qn_worse (
      worst, fabs (c->ip.ry[i] + p->cells[i / 2].quadratic[i % 2] * c->ip.at.y[i]));
  return worst <= collapse_tuning.proof * (power - dissipated);
}

/* Whether y and lambda prove that the multiplier has no bound: forces that balance the live load alone,
 * whatever the strength. */
static bool
proves_unbounded (const QnCollapse *c)
{
  const QnIpProblem *p = c->ip.problem;
  double proof = c->ip.at.lambda, worst = 0;

  if (p->load == NULL)
    return false;
  for (int32_t r = 0; r < p->row_count; r++)
    worst = qn_worse (worst, fabs (c->rv[r] + p->constant[r]));
  for (int32_t i = 0; i < p->bound_count; i++) /* Gy = -s + (h - rz), s >= 0 */
    worst = qn_worse (worst, p->bounds[i].limit - c->ip.rz[i]);
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    worst = qn_worse (worst, fabs (p->cells[i / 2].quadratic[i % 2] * c->ip.at.y[i]));
  return worst <= collapse_tuning.proof * proof;
}

/* How many times as much as a collapse may have the iterate has of what vanishes there: products compared
 * with the work of the live load, out-of-balance forces, excess of the strength, and rates that are not
 * those of flows and compliance. */
static double
find_misfit (const QnCollapse *c, double tolerance)
{
  const QnIpProblem *p = c->ip.problem;
  double work = p->load != NULL
                  ? p->load_gain * fmax (fabs (c->ip.at.lambda), c->least_multiplier)
                  : 1 + stored_work (p, c->ip.at.y);
  double forces =
    collapse_tuning.balance * fmax (1, qn_ip_largest (c->ip.at.y, 2 * p->cell_count));
  double speed =
    fmax (p->load != NULL ? 1e-300 : 1, qn_ip_largest (c->ip.at.v, p->row_count));
  double misfit =
    qn_worse (c->ip.power / work, qn_ip_largest (c->ip.ry, 2 * p->cell_count) / speed);

  if (p->load != NULL)
    misfit = qn_worse (misfit, fabs (c->r_lambda) / p->load_gain);
  misfit = qn_worse (misfit / tolerance, qn_ip_largest (c->rv, p->row_count) / forces);
  return qn_worse (misfit, qn_ip_largest (c->ip.rz, p->bound_count) / forces);
}

/* Factorises for the iterate; false where the system has no solution. */
static bool
factorize_collapse (QnCollapse *c)
{
  qn_ip_step_weights (&c->ip);
  return qn_ip_kkt_factorize (&c->kkt);
}

/* d lambda / d log (1 / compliance) at a collapse: the tangent of its equations. */
static void
find_growth (QnCollapse *c)
{
  const QnIpProblem *p = c->ip.problem;
  const QnIpVector right = { .y = c->ip.right, .v = c->right_v };

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    c->ip.right[i] = p->cells[i / 2].quadratic[i % 2] * c->ip.at.y[i];
  memset (c->right_v, 0, (size_t) p->row_count * sizeof (double));
  c->ip.step.lambda = INFINITY;
  bool exact = c->ip.inverse.coupling == 1;
  c->ip.inverse.coupling = 1;
  if (exact || factorize_collapse (c))
    qn_ip_kkt_solve (&c->kkt, &right, &c->ip.step);
  c->growth = c->ip.step.lambda;
}

/* What the iterate is. */
static QnOutcome
judge_iterate (const QnCollapse *c, double misfit)
{
  if (misfit <= 1)
    return QN_OUTCOME_COLLAPSE;
  if (!c->own_flow && qn_collapse_proves_infeasible (c, c->ip.problem))
    return QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  return !c->own_flow && proves_unbounded (c) ? QN_OUTCOME_UNBOUNDED
                                              : QN_OUTCOME_NOT_CONVERGED;
}

/* Takes a step, or regularises more. Returns how much of the step may be gone; *ok is false where there
 * is none. */
static double
step_on (QnCollapse *c, bool *ok)
{
  double part, length = qn_ip_step_find (&c->ip, &part);

  if (c->kkt.error < collapse_tuning.worst_solution) {
    double reach = c->own_flow ? 0 : 1 - part;
    qn_ip_vector_add (&c->ip.at,
                      fmin (1, fmax (collapse_tuning.to_boundary, reach) * length),
                      &c->ip.step, c->ip.problem);
  } else {
    *ok = c->ip.inverse.regularization < collapse_tuning.most_proximal;
    c->ip.inverse.regularization *= collapse_tuning.more_proximal;
    length = collapse_tuning.short_step;
  }
  return length;
}

/* Counts an iteration, and reports it; false when it is to be cancelled. */
static bool
count_iteration (QnCollapse *c)
{
  const QnProgress report = {
    .iterations = ++c->effort.iterations,
    .factorizations = c->effort.factorizations,
    .rigid = true,
  };

  c->cancelled = c->progress != NULL && !c->progress (&report, c->user_data);
  return !c->cancelled;
}

QnOutcome
qn_collapse_follow (QnCollapse *c, double tolerance, int32_t budget,
                    bool (*is_enough) (void *), void *data)
{
  const QnIpProblem *p = c->ip.problem;
  double *coupling = &c->ip.inverse.coupling, least = c->least_coupling, best = INFINITY;
  int32_t idle = 0;
  bool ok = true;

  c->gap = 0;
  c->own_flow = false;
  for (int32_t i = 0; i < p->bound_count; i++)
    c->own_flow |= p->bounds[i].normal != p->bounds[i].opening;
  /* Without dilatancy the flows of both directions in which an open joint may slip cancel: they may grow
   * together without end. A proximal term holds them: of a step it leaves itself times the change of a
   * flow in the strength of its row, and that vanishes as steps do. The end of a path is found without: of 12
   * ends of seeded walls one had a state then that its forces do not have. */
  c->ip.proximal = c->own_flow && c->holds_flows ? collapse_tuning.flow : 0;
  c->ip.inverse.regularization = collapse_tuning.least_proximal;
  *coupling = 1;
  for (int32_t iteration = 0; ok; iteration++) {
    for (int32_t i = 0; i < 2 * p->cell_count; i++)
      c->ip.ry[i] = p->cells[i / 2].no_shear && i % 2 == 1
                      ? 0
                      : c->given[i] - p->cells[i / 2].quadratic[i % 2] * c->ip.at.y[i];
    qn_ip_add_rates (p, c->ip.at.v, -1, c->ip.ry);
    qn_ip_add_flows (p, c->ip.at.z, -1, c->ip.ry);
    find_balance (p, c->ip.at.y, c->ip.at.lambda, c->rv);
    for (int32_t r = 0; r < p->row_count; r++)
      c->rv[r] = -c->rv[r];
    qn_ip_step_measure (&c->ip);
    c->r_lambda = p->load != NULL
                    ? p->load_gain - qn_dot (p->load, c->ip.at.v, (size_t) p->row_count)
                    : 0;
    double misfit = find_misfit (c, tolerance), length = 0;
    QnOutcome state =
      iteration > 0 ? judge_iterate (c, misfit) : QN_OUTCOME_NOT_CONVERGED;
    if (state == QN_OUTCOME_COLLAPSE && c->own_flow)
      find_growth (c);
    idle = misfit < best ? 0 : idle + 1;
    best = fmin (best, misfit);
    if (state != QN_OUTCOME_NOT_CONVERGED || iteration == budget || isnan (misfit)
        || (!c->own_flow && idle == collapse_tuning.idle))
      return state;
    bool enough = is_enough != NULL && is_enough (data);
    if (!count_iteration (c) || enough)
      return QN_OUTCOME_CANCELLED;
    ok = factorize_collapse (c);
    /* As many negative eigenvalues as one of associative flow has, or by an even number more. */
    if (ok
        && (!c->own_flow
            || (qn_block_lu_sign (c->kkt.lu) > 0) == (c->kkt.border_power > 0)))
      length = step_on (c, &ok);
    else if (*coupling <= least)
      least = c->holds_flows ? least - collapse_tuning.less : 0;
    if (length < collapse_tuning.short_step)
      *coupling = fmax (least, *coupling - collapse_tuning.less);
    else if (length > collapse_tuning.long_step)
      *coupling = fmin (1, *coupling + collapse_tuning.more);
  }
  return QN_OUTCOME_NOT_CONVERGED;
}

/* One of two programs: `fixed_flow`, or fixed normal forces. */
static QnOutcome
take_turn (QnCollapse *c, const QnIpProblem *whole, bool fixed_flow, double tolerance,
           int32_t end)
{
  for (int32_t i = 0; i < whole->cell_count; i++)
    for (int32_t k = 0, j = whole->cells[i].first_bound; k < whole->cells[i].bound_count;
         k++, j++) {
      QnIpBound *bound = &c->bounds[j];
      *bound = whole->bounds[j];
      double dilates = bound->normal - bound->opening;
      if (fixed_flow) {
        c->given[2 * i] += dilates * c->kept.z[j];
        bound->opening = bound->normal;
      } else if (dilates != 0) {
        bound->limit = fmax (0, bound->limit - dilates * c->ip.at.y[2 * i]);
        bound->normal = bound->opening;
      }
    }
  qn_collapse_centre (c, 1); /* at 0.1 steps are short: 63 iterations instead of 29 */
  QnOutcome state =
    qn_collapse_follow (c, tolerance, end - c->effort.factorizations, NULL, NULL);
  memset (c->given, 0, 2 * (size_t) whole->cell_count * sizeof (double));
  return state;
}

QnOutcome
qn_collapse_alternate (QnCollapse *c, double tolerance, int32_t budget)
{
  const QnIpProblem *whole = c->ip.problem;
  QnIpProblem program = *whole;
  int32_t end = c->effort.factorizations + budget;
  double gap = INFINITY, before, enough;
  QnOutcome state;

  program.bounds = c->bounds;
  c->ip.problem = &program;
  do {
    state = take_turn (c, whole, false, 0.1 * tolerance, end);
    qn_ip_vector_copy (&c->kept, &c->ip.at, whole);
    if (state == QN_OUTCOME_COLLAPSE)
      state = take_turn (c, whole, true, 0.1 * tolerance, end);
    double least = fmax (fabs (c->ip.at.lambda), c->least_multiplier);
    before = gap;
    /* z'(h - Gy) + 1/2 |Qy - q|^2 of the forces y of the iterate, and of flow z and
     * elastic rates q that are kept. */
    double duality = 0;
    for (int32_t i = 0; i < 2 * whole->cell_count; i++) {
      double off = c->ip.at.y[i] - c->kept.y[i];
      duality += 0.5 * whole->cells[i / 2].quadratic[i % 2] * off * off;
    }
    qn_ip_apply_bounds (whole, c->ip.at.y, c->ip.rz);
    for (int32_t i = 0; i < whole->bound_count; i++)
      duality += (whole->bounds[i].limit - c->ip.rz[i]) * c->kept.z[i];
    gap = duality / (whole->load_gain * least);
    c->growth = 0.5 * stored_work (whole, c->ip.at.y) / whole->load_gain;
    c->gap = gap * least;
    enough = fmax (tolerance, sqrt (tolerance * c->growth / least));
  } while (state == QN_OUTCOME_COLLAPSE && !(gap <= enough)
           && gap < collapse_tuning.closer * before);
  c->ip.problem = whole;
  memcpy (c->ip.at.v, c->kept.v, (size_t) whole->row_count * sizeof (double));
  memcpy (c->ip.at.z, c->kept.z, (size_t) whole->bound_count * sizeof (double));
  return state == QN_OUTCOME_COLLAPSE && !(gap <= enough) ? QN_OUTCOME_NOT_CONVERGED
                                                          : state;
}

void
qn_collapse_project (QnCollapse *c, bool fixed, QnCollapseForces *forces)
{
  const QnIpProblem *p = c->ip.problem;
  const QnIpVector right = { .y = c->ip.right, .v = c->right_v };
  QnIpVector *step = &c->ip.trial;
  double *y = forces->y;

  memcpy (y, c->ip.at.y, 2 * (size_t) p->cell_count * sizeof *y);
  forces->residual = INFINITY;
  forces->slack = -INFINITY;
  if (!isfinite (c->kkt.error))
    return;
  memset (c->ip.right, 0, 2 * (size_t) p->cell_count * sizeof (double));
  for (int32_t i = 0; i < p->bound_count; i++)
    c->ip.products[i] = c->ip.w[i] * c->ip.rz[i];
  qn_ip_add_flows (p, c->ip.products, 1, c->ip.right);
  c->kkt.bordered = p->load != NULL && !fixed;
  for (int round = 0;; round++) {
    find_balance (p, y, forces->lambda, c->right_v);
    forces->residual = qn_ip_largest (c->right_v, p->row_count);
    if (round > 0
        && (forces->residual <= collapse_tuning.restored
            || round == collapse_tuning.rounds))
      break;
    for (int32_t r = 0; r < p->row_count; r++)
      c->right_v[r] = -c->right_v[r];
    qn_ip_kkt_solve (&c->kkt, &right, step);
    qn_ip_add_multiple (y, 1, step->y, 2 * p->cell_count);
    forces->lambda += step->lambda;
    memset (c->ip.right, 0, 2 * (size_t) p->cell_count * sizeof (double));
  }
  c->kkt.bordered = p->load != NULL;
  qn_ip_apply_bounds (p, y, step->s);
  forces->slack = INFINITY;
  for (int32_t i = 0; i < p->bound_count; i++)
    forces->slack = fmin (forces->slack, p->bounds[i].limit - step->s[i]);
}
