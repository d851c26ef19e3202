#include "core/equilibrium/central-path.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/equilibrium/central-pairs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tuning. Residuals at which Newton's method may finish, of strain and complementarity relative to the
 * elongations. Flows that belong to the last trace of a strength, z = product / s, lose their digits to rounding,
 * and strain with them; displacements and forces do not. */
#define EXACT         1e-9 /* balance, strength, complementarity */
#define STRAIN        1e-3
#define TIGHTER       1e-2 /* complementarity, where Newton's method does not finish, */
#define MOST_FINISHES 3    /* so often */
#define NEARLY        1e-7 /* complementarity that may stand if only rounding turns back */
#define MOST_TURNS    4 /* central paths of a step, as dilation turns on the last one */

#define HOLDING_VISCOSITY 1e-12 /* holds what touches nothing */
#define TO_BOUNDARY       0.995 /* of the way to the boundary */
#define PATIENCE          10    /* iterations in which complementarity has to halve */

/* A step of motion begins at this part of how far the structure goes at the velocity it has: at all of it
 * twice as many steps turn back on a wall of 820 blocks, at a hundredth as many again. */
#define PART_OF_MOTION 0.1

static const QnIpTuning ip_tuning = { .exponent = 3,
                                      .least_aim = 1e-6,
                                      .correctors = 2,
                                      .full_step = 0.9,
                                      .spread = 10,
                                      .gain = 0.01 };

struct QnCentralPath {
  QnCentralPairs pairs;
  QnEquilibrium *eq;
  bool may_jump;   /* and then the path may turn back */
  bool together;   /* residuals go down with complementarity where a measure advances */
  QnIpVector near; /* the best iterate that may stand if no better one comes */
  double *kept;    /* from where Newton's method sets out */
  double *lack;    /* out of balance at the iterate, where a part of it is to stay */

  /* Of the solution in progress. */
  double viscosity; /* 0: static */
  const QnTarget *target;
  double target_gap;      /* what the target lacks */
  double gap;             /* mean of s z */
  double elongation;      /* the largest, at least 1 */
  double complementarity; /* asked for */
  double near_gap;        /* complementarity of `near`, INFINITY without */
};

/* Everything at eq->u: residuals, tangents, the pairs of other laws. */
static bool
prepare_path (QnCentralPath *path)
{
  QnAssembly *as = &path->eq->assembly;

  qn_assembly_update_kinematics (as, path->eq->u);
  qn_beam_assembly_evaluate (as);
  if (!qn_central_pairs_prepare (&path->pairs))
    return false;
  path->elongation = fmax (1, path->pairs.elongation);
  path->gap = path->pairs.ip.power / path->pairs.problem.bound_count;
  return true;
}

/* residual = what the forces of the pairs, and damping, leave unbalanced. Returns what it is measured by. */
static double
balance (const QnCentralPath *path, double *residual)
{
  const QnEquilibrium *eq = path->eq;
  const QnAssembly *as = &eq->assembly;
  double scale =
    qn_assembly_residual_of (as, eq->multiplier, path->pairs.forces, 2, residual);

  for (int32_t i = 0; path->viscosity > 0 && i < as->unknown_count; i++)
    residual[i] -= path->viscosity * as->damping[i] * (eq->u[i] - eq->anchor.u[i]);
  return scale;
}

/* Factorises the tangent, and finds displacements per multiplier. The geometric stiffness is that of the forces
 * on the central path. */
static QnSolveStatus
factorize_path (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;
  QnAssembly *as = &eq->assembly;
  QnCentralPairs *pairs = &path->pairs;
  double start = qn_clock_seconds (), stiffness = pairs->force / pairs->length;

  for (size_t p = 0; as->nonlinear && p < as->pair_count; p++)
    for (size_t k = 0; k < 2; k++)
      as->responses[p].force[k] = pairs->force * pairs->ip.at.y[2 * p + k];
  for (size_t i = 0; i < 4 * as->pair_count; i++)
    pairs->tangents[i] = stiffness * pairs->ip.inverse.cells[i];
  qn_assembly_tangent_of (as, eq->multiplier, fmax (HOLDING_VISCOSITY, path->viscosity),
                          pairs->tangents, 4);
  eq->statistics.assembly_seconds += qn_clock_seconds () - start;
  eq->factored = false; /* by Newton's method */
  memcpy (eq->live_step, as->live, (size_t) as->unknown_count * sizeof (double));
  return qn_equilibrium_factor (eq, eq->live_step);
}

/* The linear system of a step: displacements from balance, forces from displacements. */
static void
solve_system (QnIpStep *ip, double share, QnIpVector *out)
{
  QnCentralPath *path = (QnCentralPath *) ip;
  QnEquilibrium *eq = path->eq;
  int32_t n = eq->assembly.unknown_count;

  qn_central_pairs_aim (&path->pairs);
  balance (path, eq->step);
  for (int32_t i = 0; share < 1 && i < n; i++)
    eq->step[i] -= (1 - share) * path->lack[i];
  qn_equilibrium_solve (eq, eq->step);
  out->lambda = 0;
  if (path->target->direction != NULL) {
    double along_live;
    out->lambda = qn_equilibrium_complete_step (eq, path->target,
                                                share * path->target_gap, &along_live);
    eq->slope = along_live != 0 ? 1 / along_live : 0;
  }
  memcpy (out->v, eq->step, (size_t) n * sizeof *out->v);
  qn_assembly_elongation_rates (&eq->assembly, out->v, path->pairs.rates);
  qn_central_pairs_complete (&path->pairs, out);
}

bool
qn_central_path_new (QnEquilibrium *eq, bool together, QnCentralPath **made)
{
  const QnAssembly *as = &eq->assembly;
  size_t n = (size_t) as->unknown_count;
  bool has_joints = false;

  *made = NULL;
  for (size_t p = 0; p < as->pair_count; p++)
    has_joints |= as->springs[p].equal && qn_spring_is_plastic (&as->springs[p].a)
                  && !as->inactive[p];
  if (!has_joints)
    return true;
  QnCentralPath *path = qn_alloc (1, sizeof *path);
  if (path == NULL)
    return false;
  path->eq = eq;
  path->may_jump = qn_assembly_may_jump (as);
  path->together = path->may_jump && (together || !as->nonlinear);
  qn_central_pairs_init (&path->pairs, &eq->assembly, &ip_tuning);
  QnPool *pool = &path->pairs.pool;
  path->kept = qn_pool_alloc (pool, n, sizeof *path->kept);
  path->lack = qn_pool_alloc (pool, n, sizeof *path->lack);
  qn_ip_vector_init (&path->near, &path->pairs.problem, pool);
  path->pairs.ip.at.v = eq->u;
  path->pairs.ip.solve = solve_system;
  if (!pool->failed)
    *made = path;
  else
    qn_central_path_free (path);
  return *made != NULL;
}

void
qn_central_path_free (QnCentralPath *path)
{
  if (path == NULL)
    return;
  qn_pool_clear (&path->pairs.pool);
  free (path);
}

/* Whether the iterate is an equilibrium but for this complementarity and lack of balance.
 * Balance, the most expensive one, is asked last. */
static bool
is_within (QnCentralPath *path, double complementarity, double out_of_balance)
{
  QnEquilibrium *eq = path->eq;

  if (!(path->pairs.strength
          <= fmax (EXACT, QN_TOLERANCE_FORCE * path->pairs.largest_force)
        && path->pairs.strain <= STRAIN * path->elongation
        && path->gap <= complementarity * path->elongation
        && fabs (path->target_gap)
             <= 0.5 * QN_TOLERANCE_TARGET * fabs (path->target->advance)))
    return false;

  qn_central_pairs_get_forces (&path->pairs);
  double scale = balance (path, eq->residual);
  return qn_assembly_largest (&eq->assembly, eq->residual, NULL)
         <= out_of_balance * scale;
}

/* Keeps the best iterate that may stand if no better one comes: where the path cannot turn back
 * there is one as good as one likes, and what is in the way is rounding. */
static void
keep_near (QnCentralPath *path)
{
  QnIpVector *at = &path->pairs.ip.at;

  if (path->may_jump || path->gap >= path->near_gap
      || !is_within (path, NEARLY, path->eq->tolerance))
    return;
  path->near_gap = path->gap;
  at->lambda = path->eq->multiplier;
  qn_ip_vector_copy (&path->near, at, &path->pairs.problem);
}

/* Whether the iterate is good enough for Newton's method to finish. */
static bool
has_converged (QnCentralPath *path)
{
  const QnEquilibrium *eq = path->eq;

  path->target_gap = qn_equilibrium_target_lack (eq, path->target);
  keep_near (path);
  return is_within (path, path->complementarity, EXACT);
}

/* Newton's method from where the iteration stands; FAILED leaves it there. */
static QnSolveStatus
finish (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;
  size_t bytes = (size_t) eq->assembly.unknown_count * sizeof (double);
  double multiplier = eq->multiplier;
  QnSolveStatus status = QN_SOLVE_FAILED;

  memcpy (path->kept, eq->u, bytes);
  if (qn_assembly_evaluate (&eq->assembly, eq->u))
    status = qn_equilibrium_newton (eq, path->target, path->viscosity, QN_NEWTON_BUDGET);
  if (status == QN_SOLVE_FAILED) {
    memcpy (eq->u, path->kept, bytes);
    eq->multiplier = multiplier;
    qn_assembly_update_kinematics (&eq->assembly, eq->u);
  }
  return status;
}

/* Accepts what was reached, in balance and within all strengths: where many pairs are neither
 * sliding nor stuck, Newton's method has nothing to hold on to. */
static QnSolveStatus
adopt (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;

  if (!qn_central_pairs_take_flow (&path->pairs))
    return QN_SOLVE_FAILED;
  eq->keeps_forces = true;
  QnSolveStatus status = qn_equilibrium_newton (eq, path->target, path->viscosity, 0);
  if (status != QN_SOLVE_CONVERGED || eq->out_of_balance <= eq->tolerance)
    return status;
  /* The laws by themselves do not find these forces again. */
  return qn_central_pairs_take_flow (&path->pairs)
           ? qn_equilibrium_newton (eq, path->target, path->viscosity, QN_MEASURE_ONLY)
           : QN_SOLVE_FAILED;
}

/* The best iterate, if there is one that may stand. */
static QnSolveStatus
fall_back (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;

  if (isinf (path->near_gap))
    return QN_SOLVE_FAILED;
  qn_ip_vector_copy (&path->pairs.ip.at, &path->near, &path->pairs.problem);
  eq->multiplier = path->near.lambda;
  qn_assembly_update_kinematics (&eq->assembly, eq->u);
  return adopt (path);
}

/* One iteration. Where a measure advances, or time, and the path may turn back, residuals go down with the mean
 * of s z, at one rate: if they vanish sooner, iterates leave the path and get stuck between strengths where it does
 * not turn back at all. Where the multiplier is prescribed, fewer increments get through like that. In nonlinear
 * geometry it is for the caller to say. */
static QnSolveStatus
improve (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;
  QnIpStep *ip = &path->pairs.ip;
  double part;

  if (!qn_equilibrium_go_on (eq))
    return QN_SOLVE_CANCELLED;
  ip->together =
    path->together && (path->target->direction != NULL || path->viscosity > 0);
  if (ip->together) {
    qn_central_pairs_get_forces (&path->pairs);
    balance (path, path->lack);
  }
  QnSolveStatus status = factorize_path (path);
  if (status != QN_SOLVE_CONVERGED)
    return status;
  ip->at.lambda = eq->multiplier;
  qn_ip_vector_add (&ip->at, TO_BOUNDARY * fmin (1, qn_ip_step_find (ip, &part)),
                    &ip->step, ip->problem);
  eq->multiplier = ip->at.lambda;
  return QN_SOLVE_CONVERGED;
}

static QnSolveStatus
iterate_path (QnCentralPath *path)
{
  int finishes = 0, halved = 0; /* the iteration when complementarity had last halved, */
  double gap = INFINITY;        /* and what it was */

  for (int iteration = 0;; iteration++) {
    if (!prepare_path (path) || !isfinite (path->gap))
      return fall_back (path);
    if (has_converged (path)) {
      QnSolveStatus status = finish (path);
      if (status != QN_SOLVE_FAILED)
        return status;
      if (++finishes == MOST_FINISHES)
        return adopt (path);
      path->complementarity *= TIGHTER;
      prepare_path (path);
      has_converged (path);
    }
    if (path->gap <= 0.5 * gap) {
      gap = path->gap;
      halved = iteration;
    }
    if (iteration == QN_TRIED || iteration - halved >= PATIENCE)
      return fall_back (path);
    QnSolveStatus status = improve (path);
    if (status == QN_SOLVE_FAILED)
      return fall_back (path);
    if (status != QN_SOLVE_CONVERGED)
      return status;
  }
}

/* One central path from the current displacements and forces, from mean products of `size`; another one from
 * there where the dilation of joints has turned on the way. */
static QnSolveStatus
follow_path (QnCentralPath *path, double size)
{
  QnEquilibrium *eq = path->eq;
  const double *begun = path->viscosity > 0 ? eq->anchor.u : eq->committed.u;
  double multiplier = eq->multiplier;

  for (int turn = 0;; turn++) {
    path->complementarity = EXACT;
    path->near_gap = INFINITY;
    qn_central_pairs_start (&path->pairs, size, turn > 0);
    QnSolveStatus status = iterate_path (path);
    if (status != QN_SOLVE_FAILED || !path->pairs.turned || turn == MOST_TURNS)
      return status;
    memcpy (eq->u, begun, (size_t) eq->assembly.unknown_count * sizeof *eq->u);
    eq->multiplier = multiplier;
    if (!qn_assembly_evaluate (&eq->assembly, eq->u))
      return QN_SOLVE_FAILED;
  }
}

QnSolveStatus
qn_central_path_solve (QnCentralPath *path, const QnTarget *target, double viscosity)
{
  QnEquilibrium *eq = path->eq;
  const QnAssembly *as = &eq->assembly;
  double sum = target->direction != NULL ? qn_assembly_total (as, target->direction) : 0;
  /* The mean displacement that the target asks for, in units of the path: what elongations will be like. */
  double size = sum > 0 ? fabs (target->advance) / (sum * path->pairs.length) : 1;

  if (viscosity > 0)
    size = PART_OF_MOTION
           * (qn_assembly_elastic_displacements (as, eq->motion, NULL) / viscosity);
  else
    qn_equilibrium_restore (eq);
  if (target->direction == NULL)
    eq->multiplier = target->multiplier;
  path->viscosity = viscosity;
  path->target = target;
  return follow_path (path, fmax (1, size));
}
