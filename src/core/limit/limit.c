#include "core/limit/limit.h"

#include "core/base/memory.h"
#include "core/limit/limit-bounds.h"
#include "core/limit/limit-fall.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The lower bound is to reach the optimum to this part of the multiplier, or this part of the
 * loads. Where it does not, so many rounds are made of moving forces inside the strength, and
 * then forces are sought at a multiplier that is less than the optimum by the least of these
 * parts that has some. */
#define WANTED_GAP   1e-6
#define LEAST_GAP    1e-9
#define MOST_ROUNDS  8
#define LEAST_MARGIN 1e-5
#define MOST_MARGIN  1e-2

/* A multiplier that is small beside the loads is found to WANTED_GAP of itself, as far as rounding lets. */
#define FINEST 1e-12

/* Without an optimum to full accuracy, an iterate this good is still an answer. */
#define ACCEPTED_GAP      1e-6
#define ACCEPTED_RESIDUAL 1e-7

typedef struct LimitRun {
  QnLimitProblem *limit;
  QnInteriorPoint *ip;
  const QnLimitStart *start;
  QnProgressFunc progress;
  void *user_data;
  QnLimitSolution *solution;
  double *y;       /* cell_count x 2 */
  double residual; /* largest out-of-balance of y, scaled */
  double *rates;   /* cell_count x 2 */
  double *anchor;  /* cell_count x 2: forces within the strength at multiplier 0 */
  bool anchored;   /* … where they are known */
  double *inner;   /* cell_count x 2: the same just below the optimum */
  double *drawn;   /* cell_count x 2 */
  bool cancelled;
} LimitRun;

void
qn_limit_solution_clear (QnLimitSolution *solution)
{
  free (solution->forces);
  free (solution->velocities);
  *solution = (QnLimitSolution){ 0 };
}

/* Counts an iteration and reports it; false when the analysis is to be cancelled. */
static bool
go_on_limit (void *data)
{
  LimitRun *run = data;

  run->solution->effort.iterations++;
  if (run->progress != NULL) {
    QnProgress report = {
      .iterations = run->solution->effort.iterations,
      .factorizations = run->solution->effort.factorizations + run->ip->factorizations,
      .rigid = true,
    };
    run->cancelled = !run->progress (&report, run->user_data);
  }
  return !run->cancelled;
}

static QnStatus
iterate_once (LimitRun *run, QnDiag *diag)
{
  QnStatus status = qn_interior_point_iterate (run->ip, diag);

  if (!status)
    go_on_limit (run);
  return status;
}

static QnStatus
begin (LimitRun *run, const QnIpVector *start, QnDiag *diag)
{
  if (start == NULL)
    return qn_interior_point_start (run->ip, diag);
  qn_interior_point_start_from (run->ip, start);
  return QN_OK;
}

static void
count_effort (LimitRun *run)
{
  run->solution->effort.factorizations += run->ip->factorizations;
  run->solution->effort.factor_seconds += run->ip->factor_seconds;
}

/* Forces strictly within the strength that carry `constant` alone, or the certificate that there
 * are none. An iterate that can be moved into the interior is an early answer; only where there is
 * no interior does the program run to its end. */
static QnStatus
carry (LimitRun *run, const double *constant, const QnIpVector *start, double *forces,
       bool *found, QnDiag *diag)
{
  QnIpProblem *p = &run->limit->ip;
  QnInteriorPoint *ip = run->ip;
  const QnIpProblem whole = *p;
  double lambda = 0.0, residual = INFINITY, slack = 0.0;
  QnStatus status;

  *found = false;
  p->constant = constant;
  p->load = NULL;
  p->load_gain = 0.0;
  status = begin (run, start, diag);
  while (!status && ip->state == QN_IP_RUNNING && !*found && !run->cancelled) {
    status = iterate_once (run, diag);
    if (!status)
      status =
        qn_interior_point_project (ip, true, &lambda, forces, &residual, &slack, diag);
    *found = !status && slack > 0.0 && residual < ACCEPTED_RESIDUAL;
  }
  *p = whole;
  count_effort (run);
  return status;
}

static bool
is_answer (const QnInteriorPoint *ip)
{
  return ip->state == QN_IP_OPTIMAL
         || (ip->state == QN_IP_STALLED && ip->measures.gap < ACCEPTED_GAP
             && ip->measures.primal_residual < ACCEPTED_RESIDUAL
             && ip->measures.dual_residual < ACCEPTED_RESIDUAL);
}

/* The engine's certificate proves that there is no equilibrium, but moves blocks that could
 * stand as well; the fall moves those alone that cannot. */
static QnStatus
take_certificate (LimitRun *run, QnDiag *diag)
{
  double *v = run->ip->at.v;
  bool found;
  QnStatus status = qn_limit_fall (run->limit, go_on_limit, run, v, &found, diag);

  run->solution->outcome =
    run->cancelled ? QN_OUTCOME_CANCELLED : QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  qn_limit_problem_velocities (run->limit, v, run->solution->velocities);
  return status;
}

/* Whether the optimum proves that the dead load is not carried: the largest multiplier is negative, and on
 * its mechanism the dead load does more than the joints dissipate. So it is decided a millionth from the verge,
 * where an infeasible program differs from a feasible one by no more than rounding. */
static bool
falls (LimitRun *run)
{
  const QnInteriorPoint *ip = run->ip;

  return qn_limit_upper_bound (run->limit, ip->at.v, ip->at.y, ip->at.tau, run->rates,
                               &run->solution->check)
         < -QN_LIMIT_TOLERANCE;
}

/* Draws the forces run->y, which carry the scaled multiplier lambda, to forces within the
 * strength; keeps them as run->drawn where more is carried than *lower. */
static void
draw (LimitRun *run, const double *anchor, double anchor_lambda, double lambda,
      double *lower)
{
  size_t size = 2 * (size_t) run->limit->ip.cell_count * sizeof *run->y;
  QnLimitCheck check = run->solution->check;
  check.static_residual = run->residual;
  double *drawn = run->rates; /* at rest since the upper bound was found */

  memcpy (drawn, run->y, size);
  double carried =
    qn_limit_draw_inside (run->limit, anchor, anchor_lambda, lambda, drawn, &check);
  if (carried <= *lower)
    return;
  *lower = carried;
  run->solution->check = check;
  run->rates = run->drawn;
  run->drawn = drawn;
}

/* The forces of the optimum within the strength, as run->drawn. They keep it to the tolerance of
 * the program only. Where drawing them to the forces under dead load costs too much, they are
 * moved inside and into equilibrium by turns; where that is not enough, forces just below the
 * optimum are sought to draw them to. */
static QnStatus
prove_lower (LimitRun *run, double *lower, QnDiag *diag)
{
  const double *anchor = run->anchored ? run->anchor : NULL;
  double lambda = run->ip->at.lambda / run->ip->at.tau, slack;
  double wanted = lambda - WANTED_GAP * fabs (lambda) - LEAST_GAP;
  bool found = false;
  QnStatus status = qn_interior_point_project (run->ip, false, &lambda, run->y,
                                               &run->residual, &slack, diag);

  *lower = -INFINITY;
  if (!status)
    draw (run, anchor, 0.0, lambda, lower);
  for (int round = 0; !status && *lower < wanted && round < MOST_ROUNDS; round++) {
    qn_limit_move_inside (run->limit, run->y);
    status = qn_interior_point_restore (run->ip, false, &lambda, run->y, &run->residual,
                                        &slack, diag);
    if (!status)
      draw (run, anchor, 0.0, lambda, lower);
  }
  if (status || *lower >= wanted)
    return status;
  const QnIpProblem *p = &run->limit->ip;
  double *constant = qn_alloc ((size_t) p->row_count, sizeof *constant);
  if (!constant)
    return qn_diag_no_memory (diag);
  for (double margin = LEAST_MARGIN;
       !status && !found && *lower < wanted && margin <= MOST_MARGIN; margin *= 10.0) {
    double inner = lambda - margin * fabs (lambda);
    for (int32_t r = 0; r < p->row_count; r++)
      constant[r] = p->constant[r] + inner * p->load[r];
    status = carry (run, constant, NULL, run->inner, &found, diag);
    if (!status && found)
      draw (run, run->inner, inner, lambda, lower);
  }
  free (constant);
  return status;
}

/* The two bounds with what proves them. */
static QnStatus
take_optimum (LimitRun *run, QnDiag *diag)
{
  QnLimitSolution *solution = run->solution;
  const QnLimitProblem *limit = run->limit;
  double upper = qn_limit_upper_bound (limit, run->ip->at.v, run->ip->at.y,
                                       run->ip->at.tau, run->rates, &solution->check);
  double lower;
  QnStatus status;

  qn_limit_problem_velocities (limit, run->ip->at.v, solution->velocities);
  status = prove_lower (run, &lower, diag);
  if (status)
    return status;
  solution->check.gap = (upper - lower) / (1.0 + fabs (upper));
  solution->lower_bound = qn_limit_problem_multiplier (limit, lower);
  solution->upper_bound = qn_limit_problem_multiplier (limit, upper);
  solution->outcome = QN_OUTCOME_COLLAPSE;
  qn_limit_problem_forces (limit, run->drawn, 1.0, solution->forces);
  return QN_OK;
}

/* The whole program, from a start or from nothing. */
static QnStatus
find_optimum (LimitRun *run, const QnIpVector *start, QnDiag *diag)
{
  QnInteriorPoint *ip = run->ip;
  bool refined = false;
  QnStatus status = begin (run, start, diag);

  while (!status && ip->state == QN_IP_RUNNING && !run->cancelled) {
    status = iterate_once (run, diag);
    if (status || ip->state != QN_IP_OPTIMAL || refined)
      continue;
    double fine = WANTED_GAP * fabs (ip->at.lambda / ip->at.tau);
    refined = fine < QN_LIMIT_TOLERANCE;
    if (refined)
      qn_interior_point_refine (ip, fmax (fine, FINEST));
  }
  count_effort (run);
  return status;
}

/* The dead load first, from where an earlier solution leads and else from nothing; then as much of the
 * live load as there is. */
static QnStatus
solve (LimitRun *run, bool from_dead_load, QnDiag *diag)
{
  const QnLimitStart *start = run->start;
  QnInteriorPoint *ip = run->ip;
  QnLimitSolution *solution = run->solution;
  const QnLimitProblem *limit = run->limit;
  QnStatus status = QN_OK;

  solution->outcome = QN_OUTCOME_NOT_CONVERGED;
  if (from_dead_load) {
    const double *dead = limit->ip.constant;
    if (start != NULL)
      status = carry (run, dead, &start->dead, run->anchor, &run->anchored, diag);
    if (!status && !run->cancelled
        && (start == NULL || (!run->anchored && ip->state == QN_IP_STALLED)))
      status = carry (run, dead, NULL, run->anchor, &run->anchored, diag);
    if (!status && !run->cancelled && ip->state == QN_IP_INFEASIBLE)
      return take_certificate (run, diag);
  }

  if (!status && !run->cancelled) {
    const QnIpVector *starts[] = { start != NULL ? &start->whole : NULL, NULL };
    for (int i = start == NULL; i < 2 && !status; i++) {
      status = find_optimum (run, starts[i], diag);
      if (ip->state != QN_IP_STALLED || is_answer (ip) || run->cancelled)
        break;
    }
  }

  if (status)
    return status;
  if (run->cancelled)
    solution->outcome = QN_OUTCOME_CANCELLED;
  else if (ip->state == QN_IP_INFEASIBLE)
    status = take_certificate (run, diag);
  else if (ip->state == QN_IP_UNBOUNDED) {
    solution->outcome = QN_OUTCOME_UNBOUNDED;
    solution->lower_bound = solution->upper_bound = INFINITY;
    qn_limit_problem_forces (limit, ip->at.y,
                             qn_limit_problem_multiplier (limit, ip->at.lambda),
                             solution->forces);
  } else if (is_answer (ip))
    status = from_dead_load && !run->anchored && falls (run)
               ? take_certificate (run, diag)
               : take_optimum (run, diag);
  return status;
}

QnStatus
qn_limit_solve (QnLimitProblem *limit, QnInteriorPoint *ip, bool from_dead_load,
                const QnLimitStart *start, QnProgressFunc progress, void *user_data,
                QnLimitSolution *solution, QnDiag *diag)
{
  size_t cells = (size_t) limit->ip.cell_count;
  LimitRun run = { .limit = limit,
                   .ip = ip,
                   .start = start,
                   .progress = progress,
                   .user_data = user_data,
                   .solution = solution,
                   .y = qn_alloc (2 * cells, sizeof (double)),
                   .rates = qn_alloc (2 * cells, sizeof (double)),
                   .anchor = qn_alloc (2 * cells, sizeof (double)),
                   .inner = qn_alloc (2 * cells, sizeof (double)),
                   .drawn = qn_alloc (2 * cells, sizeof (double)) };
  QnStatus status;

  *solution = (QnLimitSolution){
    .forces = qn_alloc (2 * limit->pair_count, sizeof (double)),
    .velocities = qn_alloc (limit->block_count * QN_DOF_COUNT, sizeof (double)),
  };
  if (!run.y || !run.rates || !run.anchor || !run.inner || !run.drawn || !solution->forces
      || !solution->velocities)
    status = qn_diag_no_memory (diag);
  else
    status = solve (&run, from_dead_load, diag);
  free (run.y);
  free (run.rates);
  free (run.anchor);
  free (run.inner);
  free (run.drawn);
  if (status)
    qn_limit_solution_clear (solution);
  return status;
}

QnStatus
qn_limit_associative_in_haste (const QnModel *model, const QnContacts *contacts,
                               bool hasten, QnProgressFunc progress, void *user_data,
                               QnLimitSolution *solution, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();
  QnLimitProblem limit;
  QnInteriorPoint ip;
  QnStatus status = qn_limit_problem_init (&limit, model, contacts, false, diag);

  *solution = (QnLimitSolution){ 0 };
  if (status)
    return status;
  settings.tolerance = QN_LIMIT_TOLERANCE;
  settings.hasten = hasten;
  status = qn_interior_point_init (&ip, &limit.ip, &settings, diag);
  if (!status)
    status =
      qn_limit_solve (&limit, &ip, true, NULL, progress, user_data, solution, diag);
  qn_interior_point_clear (&ip);
  qn_limit_problem_clear (&limit);
  return status;
}

QnStatus
qn_limit_associative (const QnModel *model, const QnContacts *contacts,
                      QnProgressFunc progress, void *user_data, QnLimitSolution *solution,
                      QnDiag *diag)
{
  return qn_limit_associative_in_haste (model, contacts, false, progress, user_data,
                                        solution, diag);
}
