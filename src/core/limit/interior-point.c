#include "core/limit/interior-point.h"

#include "core/base/memory.h"
#include "core/limit/interior-point-internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Iterations without a better iterate after which the engine gives up. */
#define STALL_ITERATIONS 12

/* … and after which it does so where the best is this good already: what is left is rounding. */
#define GOOD_MEASURE    1e-6
#define GOOD_ITERATIONS 2

/* Regularisation of the linear systems, and the relative residual above which a direction is
 * computed again with more of it. */
#define LEAST_REGULARIZATION 1e-10
#define MOST_REGULARIZATION  1e-5
#define REGULARIZATION_STEP  30.0
#define WORST_SOLUTION       1e-4

/* Solves spent on restoring equilibrium: the second removes the rounding of the first. */
#define PROJECTION_ROUNDS 2

QnIpSettings
qn_interior_point_defaults (void)
{
  return (QnIpSettings){ .tolerance = 1e-9, .max_iterations = 200, .correctors = 6 };
}

static bool
vector_init (QnIpVector *vector, const QnIpProblem *p)
{
  vector->y = qn_alloc (2 * (size_t) p->cell_count, sizeof (double));
  vector->v = qn_alloc ((size_t) p->row_count, sizeof (double));
  vector->s = qn_alloc ((size_t) p->bound_count, sizeof (double));
  vector->z = qn_alloc ((size_t) p->bound_count, sizeof (double));
  return vector->y && vector->v && vector->s && vector->z;
}

static void
vector_clear (QnIpVector *vector)
{
  free (vector->y);
  free (vector->v);
  free (vector->s);
  free (vector->z);
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
  ip->y = qn_alloc (2 * cells, sizeof (double));
  ip->v = qn_alloc (rows, sizeof (double));
  ip->s = qn_alloc (bounds, sizeof (double));
  ip->z = qn_alloc (bounds, sizeof (double));
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
      || !work->tau_column.v || !work->right.v || !vector_init (&work->step, problem)
      || !vector_init (&work->trial, problem) || !vector_init (&work->best, problem)
      || !ip->y || !ip->v || !ip->s || !ip->z)
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
    vector_clear (&work->step);
    vector_clear (&work->trial);
    vector_clear (&work->best);
    qn_ip_kkt_clear (&work->kkt);
    free (work);
  }
  free (ip->y);
  free (ip->v);
  free (ip->s);
  free (ip->z);
  *ip = (QnInteriorPoint){ 0 };
}

/* Copies the iterate to `best`, or back. */
static void
keep_iterate (const QnInteriorPoint *ip, QnIpVector *to)
{
  const QnIpProblem *p = ip->work->problem;

  vector_copy (
    to, &(QnIpVector){ ip->y, ip->v, ip->s, ip->z, ip->lambda, ip->tau, ip->kappa }, p);
}

static void
restore_iterate (QnInteriorPoint *ip, const QnIpVector *from)
{
  QnIpVector to = { ip->y, ip->v, ip->s, ip->z, 0.0, 0.0, 0.0 };

  vector_copy (&to, from, ip->work->problem);
  ip->lambda = to.lambda;
  ip->tau = to.tau;
  ip->kappa = to.kappa;
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

/* Right-hand sides of the two least-squares problems of the starting point. */
static void
set_primal_start (QnInteriorPointWork *work)
{
  const QnIpProblem *p = work->problem;

  memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  for (int32_t i = 0; i < p->bound_count; i++)
    work->products[i] = p->bounds[i].limit;
  qn_ip_add_bounds_transposed (p, work->products, 1.0, work->right.y);
  for (int32_t r = 0; r < p->row_count; r++)
    work->right.v[r] = -p->constant[r];
  work->right.lambda = 0.0;
}

static void
set_dual_start (QnInteriorPointWork *work)
{
  const QnIpProblem *p = work->problem;

  for (int32_t c = 0; c < p->cell_count; c++)
    for (int k = 0; k < 2; k++)
      work->right.y[2 * c + k] = -p->cells[c].linear[k];
  memset (work->right.v, 0, (size_t) p->row_count * sizeof (double));
  work->right.lambda = p->load_gain;
}

static void
begin (QnInteriorPoint *ip)
{
  ip->state = QN_IP_RUNNING;
  ip->iterations = 0;
  ip->work->kkt.regularization = LEAST_REGULARIZATION;
  ip->work->kkt.schur.factorizations = 0;
  ip->work->kkt.schur.seconds = 0.0;
  ip->work->since_best = 0;
  ip->work->best_merit = INFINITY;
}

static void
count_effort (QnInteriorPoint *ip)
{
  ip->factorizations = ip->work->kkt.schur.factorizations;
  ip->factor_seconds = ip->work->kkt.schur.seconds;
}

/* The smallest slacks in equilibrium with the constant loads, and the smallest multipliers
 * compatible with the objective; both shifted to the interior. */
QnStatus
qn_interior_point_start (QnInteriorPoint *ip, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpKktVector primal = { ip->y, ip->s, ip->v, 0.0 };
  QnIpKktVector dual = { work->step.y, ip->z, ip->v, 0.0 };
  QnStatus status;
  bool ok;

  begin (ip);
  for (int32_t i = 0; i < p->bound_count; i++)
    work->w[i] = 1.0;
  status = qn_ip_kkt_factorize (&work->kkt, work->w, &ok, diag);
  count_effort (ip);
  if (!status && !ok)
    ip->state = QN_IP_STALLED;
  set_primal_start (work);
  if (!status)
    status = qn_ip_kkt_solve (&work->kkt, &work->right, &primal, diag);
  set_dual_start (work);
  if (!status)
    status = qn_ip_kkt_solve (&work->kkt, &work->right, &dual, diag);
  if (status)
    return status;

  for (int32_t i = 0; i < p->bound_count; i++)
    ip->s[i] = p->bounds[i].limit - ip->s[i];
  shift_positive (ip->s, p->bound_count);
  shift_positive (ip->z, p->bound_count);
  ip->lambda = primal.lambda;
  ip->tau = 1.0;
  ip->kappa =
    p->bound_count > 0 ? qn_ip_dot (ip->s, ip->z, p->bound_count) / p->bound_count : 1.0;
  qn_ip_residuals (ip);
  return QN_OK;
}

static void
take_step (QnInteriorPoint *ip, double length)
{
  const QnIpProblem *p = ip->work->problem;
  const QnIpVector *step = &ip->work->step;

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    ip->y[i] += length * step->y[i];
  for (int32_t r = 0; r < p->row_count; r++)
    ip->v[r] += length * step->v[r];
  for (int32_t i = 0; i < p->bound_count; i++) {
    ip->s[i] += length * step->s[i];
    ip->z[i] += length * step->z[i];
  }
  ip->lambda += length * step->lambda;
  ip->tau += length * step->tau;
  ip->kappa += length * step->kappa;
}

/* Decides whether the iterate is an answer, and keeps the best one for the case that rounding
 * ends the progress. */
static void
judge (QnInteriorPoint *ip)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpMeasures *m = &ip->measures;
  double merit = fmax (m->primal_residual, fmax (m->dual_residual, m->gap));

  if (merit <= work->settings.tolerance) {
    ip->state = QN_IP_OPTIMAL;
    return;
  }
  if (ip->tau < ip->kappa || merit > 1e3) {
    if (qn_ip_proves_infeasible (ip))
      ip->state = QN_IP_INFEASIBLE;
    else if (qn_ip_proves_unbounded (ip))
      ip->state = QN_IP_UNBOUNDED;
    if (ip->state != QN_IP_RUNNING)
      return;
  }
  if (merit < work->best_merit) {
    work->best_merit = merit;
    work->since_best = 0;
    keep_iterate (ip, &work->best);
  } else if (++work->since_best
             >= (work->best_merit < GOOD_MEASURE ? GOOD_ITERATIONS : STALL_ITERATIONS)) {
    ip->state = QN_IP_STALLED;
  }
}

/* A direction that solves its equations; where rounding does not let it, the regularisation
 * grows and with it the distance that a step leaves to the next. */
static QnStatus
find_direction (QnInteriorPoint *ip, double *length, bool *ok, QnDiag *diag)
{
  QnIpKkt *kkt = &ip->work->kkt;

  for (;;) {
    QnStatus status = qn_ip_direction (ip, length, ok, diag);
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
    restore_iterate (ip, &ip->work->best);
    qn_ip_residuals (ip);
    qn_ip_measure (ip);
  }
  ip->state = QN_IP_STALLED;
}

QnStatus
qn_interior_point_iterate (QnInteriorPoint *ip, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  double length;
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
  take_step (ip, length);
  ip->iterations++;
  qn_ip_residuals (ip);
  qn_ip_measure (ip);
  judge (ip);
  if (ip->state == QN_IP_RUNNING
      && (ip->iterations >= work->settings.max_iterations || length < 1e-10))
    ip->state = QN_IP_STALLED;
  if (ip->state == QN_IP_STALLED)
    give_up (ip);
  return QN_OK;
}

QnStatus
qn_interior_point_solve (QnInteriorPoint *ip, QnDiag *diag)
{
  QnStatus status = qn_interior_point_start (ip, diag);

  while (!status && ip->state == QN_IP_RUNNING)
    status = qn_interior_point_iterate (ip, diag);
  return status;
}

/* Adds to y (and to *lambda where that is bordered) what is missing for equilibrium. */
static QnStatus
restore_balance (QnInteriorPoint *ip, double *lambda, double *y, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnIpKktVector step = { work->trial.y, work->trial.s, work->trial.v, 0.0 };
  QnStatus status;

  qn_interior_point_balance (p, y, *lambda, 1.0, work->right.v);
  for (int32_t r = 0; r < p->row_count; r++)
    work->right.v[r] = -work->right.v[r];
  memset (work->right.y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  work->right.lambda = 0.0;
  status = qn_ip_kkt_solve (&work->kkt, &work->right, &step, diag);
  for (int32_t i = 0; i < 2 * p->cell_count && !status; i++)
    y[i] += step.y[i];
  *lambda += step.lambda;
  return status;
}

QnStatus
qn_interior_point_restore (QnInteriorPoint *ip, bool fixed, double *lambda, double *y,
                           double *residual, double *slack, QnDiag *diag)
{
  QnInteriorPointWork *work = ip->work;
  const QnIpProblem *p = work->problem;
  QnStatus status = QN_OK;

  work->kkt.bordered = p->load && !fixed;
  for (int round = 0; round < PROJECTION_ROUNDS && !status; round++)
    status = restore_balance (ip, lambda, y, diag);
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
    y[i] = ip->y[i] / ip->tau;
  return qn_interior_point_restore (ip, fixed, lambda, y, residual, slack, diag);
}
