#include "core/limit/limit.h"

#include "core/base/memory.h"
#include "core/base/tolerance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How the engine is used; loads are of the order of 1. */
static const struct {
  double small;    /* multipliers below this are refined */
  double near;     /* forces are sought beside the optimum where the gap is below this */
  double residual; /* out-of-balance of forces that count, */
  double gap;      /* and gap that proves an optimum where the engine was not satisfied */
  double fall;     /* accuracy of the quadratic program of a fall */
} limit_tuning = {
  .small = 1e-2,
  .near = 1e-4,
  .residual = 1e-7,
  .gap = 1e-6,
  .fall = 1e-9,
};

typedef struct LimitRun {
  QnLimitProblem *limit;
  QnLimitSolution *solution;
  /* Nearest to the last iterate, and within the strength at the largest multiplier yet, or -INFINITY. */
  QnCollapseForces last, inside;
  double *rates;       /* cell_count x 2 */
  double lower, upper; /* bounds, scaled */
  bool stands; /* forces within the strength carry the dead load, or it is not asked */
  bool dead_only;
} LimitRun;

void
qn_limit_solution_clear (QnLimitSolution *solution)
{
  free (solution->forces);
  free (solution->velocities);
  *solution = (QnLimitSolution){ 0 };
}

/* The iterate's forces, moved into equilibrium. */
static void
take_forces (LimitRun *run, bool fixed, double lambda)
{
  run->last.lambda = lambda;
  qn_collapse_project (&run->limit->engine, fixed, &run->last);
}

/* Whether the iterate, moved into equilibrium, is within the strength: at multiplier 0 as long as
 * it is not known to be carried, then at one as large as possible. */
static void
look_inside (LimitRun *run)
{
  const QnCollapse *engine = &run->limit->engine;
  QnCollapseForces *last = &run->last, swap;
  bool near = engine->ip.power <= limit_tuning.near * run->limit->ip.load_gain;

  if (run->stands && !near)
    return;
  take_forces (run, !near, near ? engine->ip.at.lambda : 0);
  if (!(last->slack >= 0 && last->residual <= limit_tuning.residual))
    return;
  run->stands |= !near || run->dead_only;
  if (last->lambda < run->inside.lambda)
    return;
  swap = run->inside;
  run->inside = *last;
  *last = swap;
}

static bool
is_enough (void *data)
{
  LimitRun *run = data;

  look_inside (run);
  return run->dead_only && run->stands;
}

static QnOutcome
follow_program (LimitRun *run, double least)
{
  QnCollapse *engine = &run->limit->engine;

  engine->least_multiplier = least;
  return qn_collapse_follow (engine, QN_LIMIT_TOLERANCE, QN_COLLAPSE_BUDGET, is_enough,
                             run);
}

/* The program of the dead load alone; its forces are not needed once some are inside the strength. */
static QnOutcome
follow_dead_load (LimitRun *run)
{
  QnIpProblem *p = &run->limit->ip;
  const QnIpProblem whole = *p;

  p->load = NULL;
  p->load_gain = 0;
  run->dead_only = true;
  qn_collapse_start_elastic (&run->limit->engine);
  QnOutcome state = follow_program (run, 1);
  *p = whole;
  return state;
}

/* How the structure falls, and whether it does where *falls is not known: accelerations from rest under the
 * dead load. Of all forces within the strength, the joints exert those that leave the least imbalance in the
 * metric of the inverse masses (Gauss's principle of least constraint, flow being associative), and what is left
 * accelerates. The engine's certificate proves that there is no equilibrium, but moves blocks that could stand as
 * well; here they stay at rest exactly. At the optimum it is a certificate too: the dead load does positive power
 * along it, and no joint resists with more than that. */
static QnStatus
find_fall (LimitRun *run, bool *falls, QnDiag *diag)
{
  QnLimitProblem *limit = run->limit;
  QnCollapse *whole = &limit->engine, engine = { 0 };
  QnIpProblem fall = limit->ip;
  size_t blocks = limit->block_count, group_count = (size_t) fall.group_count,
         cell_count = (size_t) fall.cell_count;
  /* Copies with room for two more cells per block: the imbalance, as an unlimited force and moment on the
   * block with a quadratic price. */
  QnPool pool = { 0 };
  QnIpGroup *groups = qn_pool_alloc (&pool, group_count + blocks, sizeof *groups);
  QnIpCell *cells = qn_pool_alloc (&pool, cell_count + 2 * blocks, sizeof *cells);

  if (pool.failed) {
    qn_pool_clear (&pool);
    return qn_diag_no_memory (diag);
  }
  memcpy (groups, fall.groups, group_count * sizeof *groups);
  memcpy (cells, fall.cells, cell_count * sizeof *cells);
  for (size_t b = 0; b < blocks; b++) {
    const double *mass = limit->mass + b * QN_DOF_COUNT;
    QnIpGroup *group = &groups[group_count + b];
    QnIpCell *pair = &cells[cell_count + 2 * b];
    *group = (QnIpGroup){ .first_cell = (int32_t) (cell_count + 2 * b), .cell_count = 2 };
    for (size_t i = 0; i < QN_IP_GROUP_ROWS; i++)
      group->rows[i] = i < QN_DOF_COUNT ? limit->rows[b * QN_DOF_COUNT + i] : -1;
    pair[0] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_UX], 1.0 / mass[QN_DOF_UY] },
                          .first_bound = fall.bound_count };
    pair[0].map[QN_DOF_UX][0] = 1.0;
    pair[0].map[QN_DOF_UY][1] = 1.0;
    pair[1] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_RZ], 0.0 },
                          .first_bound = fall.bound_count,
                          .no_shear = true };
    pair[1].map[QN_DOF_RZ][0] = 1.0;
  }
  fall.groups = groups;
  fall.cells = cells;
  fall.group_count += (int32_t) blocks;
  fall.cell_count += 2 * (int32_t) blocks;
  fall.load = NULL;
  fall.load_gain = 0.0;
  QnStatus status = qn_collapse_init (&engine, &fall, diag);
  if (!status) {
    double *v = whole->ip.at.v;
    engine.progress = whole->progress;
    engine.user_data = whole->user_data;
    engine.effort = whole->effort;
    qn_collapse_start_elastic (&engine);
    if (qn_collapse_follow (&engine, limit_tuning.fall, QN_COLLAPSE_BUDGET, NULL, NULL)
        == QN_OUTCOME_COLLAPSE) {
      memcpy (v, engine.ip.at.v, (size_t) limit->ip.row_count * sizeof *v);
      *falls |= qn_collapse_proves_infeasible (&engine, &limit->ip);
    }
    if (*falls)
      qn_limit_problem_velocities (limit, v, run->solution->velocities);
    whole->effort.iterations = engine.effort.iterations;
    whole->cancelled = engine.cancelled;
  }
  qn_collapse_clear (&engine);
  qn_pool_clear (&pool);
  return status;
}

/* Least dissipation sum h z over z >= 0 with G'z = rate, at a vertex of that little program,
 * that is with two rows at most. Where the rate cannot be had, the nearest vertex counts and
 * *missing is how far it is. */
static double
least_dissipation (const QnIpProblem *p, const QnIpCell *cell, const double *rate,
                   double *missing_rate)
{
  const QnIpBound *b = p->bounds + cell->first_bound;
  double least_missing = hypot (rate[0], cell->no_shear ? 0.0 : rate[1]);
  double best = least_missing > 0.0 ? INFINITY : 0.0;

  for (int32_t i = 0; i < cell->bound_count; i++) {
    double along = b[i].normal * rate[0] + (cell->no_shear ? 0.0 : b[i].shear * rate[1]);
    double square = b[i].normal * b[i].normal + b[i].shear * b[i].shear;
    double z = fmax (0.0, along / square);
    double missing =
      hypot (rate[0] - z * b[i].normal, cell->no_shear ? 0.0 : rate[1] - z * b[i].shear);
    if (missing < least_missing || (missing == least_missing && z * b[i].limit < best)) {
      least_missing = missing;
      best = z * b[i].limit;
    }
    for (int32_t j = 0; j < i && !cell->no_shear; j++) {
      double cross = b[i].normal * b[j].shear - b[i].shear * b[j].normal;
      double zi, zj;
      if (cross == 0.0)
        continue;
      zi = (rate[0] * b[j].shear - rate[1] * b[j].normal) / cross;
      zj = (b[i].normal * rate[1] - b[i].shear * rate[0]) / cross;
      if (zi < 0.0 || zj < 0.0)
        continue;
      if (least_missing > 0.0 || zi * b[i].limit + zj * b[j].limit < best)
        best = zi * b[i].limit + zj * b[j].limit;
      least_missing = 0.0;
    }
  }
  *missing_rate = least_missing;
  return isfinite (best) ? best : 0.0;
}

/* The scaled multiplier at which the mechanism v (row_count; rescaled in place to unit power of the
 * live load) balances its power. The dissipation is that of v. The power of the iterate's forces y
 * on rates that no flow rule allows is added, so that rounding of v does not bring the bound
 * below the multiplier of these forces. rates: cell_count x 2, out. */
static double
upper_bound (const QnLimitProblem *limit, double *v, const double *y, double *rates,
             QnLimitCheck *check)
{
  const QnIpProblem *p = &limit->ip;
  double power = 0.0, largest = 0.0, bound = 0.0, violation = 0.0;

  for (int32_t r = 0; r < p->row_count; r++)
    power += p->load[r] * v[r];
  for (int32_t r = 0; r < p->row_count; r++) {
    v[r] /= power;
    largest = fmax (largest, fabs (v[r]));
    bound -= p->constant[r] * v[r];
  }
  memset (rates, 0, 2 * (size_t) p->cell_count * sizeof *rates);
  qn_ip_add_rates (p, v, -1, rates);
  for (int32_t c = 0; c < p->cell_count; c++) {
    double missing;
    bound += least_dissipation (p, &p->cells[c], rates + 2 * c, &missing);
    bound += missing * hypot (y[2 * c], y[2 * c + 1]);
    violation = fmax (violation, missing);
  }
  check->kinematic_violation = violation / largest;
  return bound;
}

/* What the last iterate proves, if that is more than one before did. Forces may exceed the strength by
 * rounding where few are inside. */
static void
take_optimum (LimitRun *run)
{
  QnCollapse *engine = &run->limit->engine;
  QnLimitSolution *solution = run->solution;
  QnLimitCheck check;
  const QnCollapseForces *proof = &run->inside;
  double upper =
    upper_bound (run->limit, engine->ip.at.v, engine->ip.at.y, run->rates, &check);

  look_inside (run);
  take_forces (run, false, engine->ip.at.lambda);
  double gain = run->last.lambda - run->inside.lambda;
  if (isinf (gain)
      || (run->last.slack >= -QN_TOLERANCE_STRENGTH
          && gain > QN_LIMIT_TOLERANCE * fabs (run->last.lambda)))
    proof = &run->last;
  if (!(fabs (upper - proof->lambda) < run->upper - run->lower))
    return;
  run->upper = upper;
  run->lower = proof->lambda;
  check.static_violation = fmax (0, -proof->slack);
  check.static_residual = proof->residual;
  check.gap = (upper - run->lower) / (1.0 + fabs (upper));
  solution->check = check;
  qn_limit_problem_velocities (run->limit, engine->ip.at.v, solution->velocities);
  qn_limit_problem_forces (run->limit, proof->y, 1, solution->forces);
}

/* As much of the live load as there is, then the dead load alone if it was not carried on the way. Where
 * the largest multiplier is negative it is not: so that is decided a millionth beside the verge, where an
 * infeasible program differs from a feasible one by no more than rounding. */
static QnStatus
solve (LimitRun *run, QnDiag *diag)
{
  QnLimitSolution *solution = run->solution;
  QnLimitCheck *check = &solution->check;
  QnLimitProblem *limit = run->limit;
  QnCollapse *engine = &limit->engine;
  QnOutcome state, dead = QN_OUTCOME_COLLAPSE;
  QnStatus status = QN_OK;

  qn_collapse_start_elastic (engine);
  state = follow_program (run, 1);
  bool falls = state == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  if (state == QN_OUTCOME_UNBOUNDED) {
    qn_limit_problem_forces (limit, engine->ip.at.y,
                             qn_limit_problem_multiplier (limit, engine->ip.at.lambda),
                             solution->forces);
  } else if (state == QN_OUTCOME_COLLAPSE || state == QN_OUTCOME_NOT_CONVERGED) {
    take_optimum (run);
    if (state == QN_OUTCOME_COLLAPSE
        && fabs (engine->ip.at.lambda) < limit_tuning.small) {
      follow_program (run, QN_COLLAPSE_LEAST);
      take_optimum (run);
    }
    falls =
      !run->stands && state == QN_OUTCOME_COLLAPSE && run->upper < -QN_LIMIT_TOLERANCE;
  }
  if (!run->stands && !falls && !engine->cancelled)
    dead = follow_dead_load (run);
  falls |= dead == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  if (falls || dead == QN_OUTCOME_NOT_CONVERGED)
    status = find_fall (run, &falls, diag);
  if (engine->cancelled || falls || status) {
    solution->outcome =
      engine->cancelled ? QN_OUTCOME_CANCELLED : QN_OUTCOME_DEAD_LOAD_UNSTABLE;
    return status;
  }
  if (state == QN_OUTCOME_UNBOUNDED) {
    solution->outcome = QN_OUTCOME_UNBOUNDED;
    solution->lower_bound = solution->upper_bound = INFINITY;
    return QN_OK;
  }
  solution->lower_bound = qn_limit_problem_multiplier (limit, run->lower);
  solution->upper_bound = qn_limit_problem_multiplier (limit, run->upper);
  bool proved =
    fabs (check->gap) <= limit_tuning.gap
    && fmax (check->static_residual, check->static_violation) <= limit_tuning.residual
    && check->kinematic_violation <= limit_tuning.residual;
  solution->outcome = state == QN_OUTCOME_COLLAPSE || proved ? QN_OUTCOME_COLLAPSE
                                                             : QN_OUTCOME_NOT_CONVERGED;
  return QN_OK;
}

QnStatus
qn_limit_solve (QnLimitProblem *limit, bool from_dead_load, QnLimitSolution *solution,
                QnDiag *diag)
{
  size_t count = 2 * (size_t) limit->ip.cell_count;
  QnPool pool = { 0 };
  LimitRun run = { .limit = limit,
                   .solution = solution,
                   .last.y = qn_pool_alloc (&pool, count, sizeof (double)),
                   .inside = { .lambda = -INFINITY },
                   .rates = qn_pool_alloc (&pool, count, sizeof (double)),
                   .lower = -INFINITY,
                   .upper = INFINITY,
                   .stands = !from_dead_load };

  run.inside.y = qn_pool_alloc (&pool, count, sizeof (double));
  *solution = (QnLimitSolution){
    .forces = qn_alloc (2 * limit->pair_count, sizeof (double)),
    .velocities = qn_alloc (limit->block_count * QN_DOF_COUNT, sizeof (double)),
  };
  QnStatus status = pool.failed || !solution->forces || !solution->velocities
                      ? qn_diag_no_memory (diag)
                      : solve (&run, diag);
  solution->effort = limit->engine.effort;
  qn_pool_clear (&pool);
  if (status)
    qn_limit_solution_clear (solution);
  return status;
}

QnStatus
qn_limit_associative (const QnModel *model, const QnContacts *contacts,
                      QnProgressFunc progress, void *user_data, QnLimitSolution *solution,
                      QnDiag *diag)
{
  QnLimitProblem limit;
  QnStatus status = qn_limit_problem_init (&limit, model, contacts, false, diag);

  *solution = (QnLimitSolution){ 0 };
  if (status)
    return status;
  limit.engine.progress = progress;
  limit.engine.user_data = user_data;
  status = qn_limit_solve (&limit, true, solution, diag);
  if (!status && solution->outcome == QN_OUTCOME_COLLAPSE) {
    solution->associative = solution->upper_bound;
    solution->multipliers[solution->count++] = solution->lower_bound;
  }
  qn_limit_problem_clear (&limit);
  return status;
}
