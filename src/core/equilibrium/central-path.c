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
#define BALANCE         1e-9 /* and of strength */
#define STRAIN          1e-3
#define COMPLEMENTARITY 1e-9
#define TIGHTER         1e-2 /* complementarity, where Newton's method does not finish, */
#define MOST_FINISHES   3    /* so often, */
#define FINISH_BUDGET   12   /* in so many iterations */
#define NEARLY          1e-7 /* complementarity that may stand if only rounding turns back */
#define MOST_TURNS      4 /* central paths of a step, as dilation turns on the last one */

#define HOLDING_VISCOSITY 1e-12 /* holds what touches nothing */
#define LEAST_AIM         1e-6  /* of the mean product, in one iteration */
#define TO_BOUNDARY       0.995 /* of the way to the boundary */
#define PATIENCE          10    /* iterations in which complementarity has to halve */

/* A step of motion begins at this part of how far the structure goes at the velocity it has: at all of it
 * twice as many steps turn back on a wall of 820 blocks, at a hundredth as many again. */
#define PART_OF_MOTION 0.1

/* Centrality correctors: at most so many, for steps shorter than LONG; products are brought
 * within CENTRAL times their mean either way; a corrector must gain GAIN. */
#define CORRECTORS 2
#define LONG       0.9
#define CENTRAL    10.0
#define GAIN       0.01

struct QnCentralPath {
  QnPool pool; /* of vectors */
  QnEquilibrium *eq;
  bool may_jump;    /* and then the path may turn back */
  bool together;    /* residuals go down with complementarity where a measure advances */
  double viscosity; /* of the step; 0: static */
  QnCentralPairs pairs;
  double *near_u;    /* unknown_count: displacements of the best iterate, */
  double *begun;     /* where the last central path began, */
  double *kept_step; /* and of the direction found so far */
  double *lack;      /* out of balance at the iterate, where a part of it is to stay */
};

static bool
has_joints (const QnAssembly *as)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->springs[p].equal && qn_spring_is_plastic (&as->springs[p].a)
        && !as->inactive[p])
      return true;
  return false;
}

bool
qn_central_path_new (QnEquilibrium *eq, bool together, QnCentralPath **made)
{
  const QnAssembly *as = &eq->assembly;
  size_t n = (size_t) as->unknown_count;

  *made = NULL;
  if (!has_joints (as))
    return true;
  QnCentralPath *path = qn_alloc (1, sizeof *path);
  if (path == NULL)
    return false;
  path->eq = eq;
  path->may_jump = qn_assembly_may_jump (as);
  path->together = path->may_jump && (together || !as->nonlinear);
  path->kept_step = qn_pool_alloc (&path->pool, n, sizeof *path->kept_step);
  path->begun = qn_pool_alloc (&path->pool, n, sizeof *path->begun);
  path->near_u = qn_pool_alloc (&path->pool, n, sizeof *path->near_u);
  path->lack = qn_pool_alloc (&path->pool, n, sizeof *path->lack);
  if (qn_central_pairs_init (&path->pairs, &eq->assembly) && !path->pool.failed)
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
  qn_central_pairs_clear (&path->pairs);
  qn_pool_clear (&path->pool);
  free (path);
}

/* One solution in progress. */
typedef struct {
  QnCentralPath *path;
  const QnTarget *target;
  QnCentralResiduals residuals;
  double gap;        /* mean of s z */
  double elongation; /* the largest, at least 1 */
  double target_gap; /* what the target lacks */
  double multiplier_step;
  QnCentralForecast reach;          /* of the direction */
  double complementarity;           /* asked for */
  double watched_gap;               /* when it had last halved, */
  int watched_since;                /* and that iteration */
  bool is_near;                     /* there is an iterate that may stand, */
  double near_gap, near_multiplier; /* its complementarity and multiplier */
} Increment;

/* Everything at eq->u: residuals, tangents, the pairs of other laws. */
static bool
prepare_path (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnAssembly *as = &path->eq->assembly;

  qn_assembly_update_kinematics (as, path->eq->u);
  qn_beam_assembly_evaluate (&as->beams);
  if (!qn_central_pairs_prepare (&path->pairs, &increment->residuals))
    return false;
  increment->elongation = fmax (1, increment->residuals.elongation);
  increment->gap = increment->residuals.products / path->pairs.products;
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

/* Factorises the tangent, and overwrites b with its solution. The geometric stiffness is that of the forces on
 * the central path. */
static QnSolveStatus
factorize_path (QnCentralPath *path, double *b)
{
  QnEquilibrium *eq = path->eq;
  QnCentralPairs *pairs = &path->pairs;
  double start = qn_clock_seconds ();

  if (eq->assembly.nonlinear)
    qn_central_pairs_get_forces (pairs);
  for (size_t p = 0; eq->assembly.nonlinear && p < eq->assembly.pair_count; p++)
    memcpy (eq->assembly.responses[p].force, pairs->forces + 2 * p,
            sizeof eq->assembly.responses[p].force);
  pairs->loops->tangents (pairs->packs, pairs->count, pairs->force / pairs->length,
                          pairs->tangents);
  qn_assembly_tangent_of (&eq->assembly, eq->multiplier,
                          fmax (HOLDING_VISCOSITY, path->viscosity), pairs->tangents, 4);
  eq->statistics.assembly_seconds += qn_clock_seconds () - start;
  eq->factored = false; /* by Newton's method */
  return qn_equilibrium_factor (eq, QN_LINSYS_ONCE, b);
}

/* The direction that belongs to eq->step, a solution for what the pairs aim at: eq->step,
 * multiplier_step and the pairs' steps. */
static void
complete_direction (Increment *increment, double part)
{
  QnEquilibrium *eq = increment->path->eq;
  QnCentralPairs *pairs = &increment->path->pairs;
  const QnTarget *target = increment->target;

  increment->multiplier_step = 0;
  if (target->direction != NULL) {
    double along_live;
    increment->multiplier_step = qn_equilibrium_complete_step (
      eq, target, part * increment->target_gap, &along_live);
    eq->slope = along_live != 0 ? 1 / along_live : 0;
  }
  qn_assembly_elongation_rates (&eq->assembly, eq->step, pairs->rates);
  increment->reach = pairs->loops->complete (pairs->packs, pairs->count, pairs->rates,
                                             1 / pairs->length, pairs->steps);
}

/* The direction that brings every s z to what is aimed at, and takes that part off all residuals. */
static void
find_path_direction (Increment *increment, const QnCentralAim *aim)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  qn_central_pairs_aim (&path->pairs, aim);
  balance (path, eq->step);
  if (aim->part < 1)
    for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
      eq->step[i] -= (1 - aim->part) * path->lack[i];
  qn_equilibrium_solve (eq, eq->step);
  complete_direction (increment, aim->part);
}

/* The same from a tangent that is not factorised yet, towards nothing. */
static QnSolveStatus
find_predictor (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;
  bool bordered = increment->target->direction != NULL;

  qn_central_pairs_aim (&path->pairs,
                        &(QnCentralAim){ .target = QN_CENTRAL_NOTHING, .part = 1 });
  balance (path, eq->step);
  if (bordered)
    memcpy (eq->live_step, eq->assembly.live,
            (size_t) eq->assembly.unknown_count * sizeof (double));
  QnSolveStatus status = factorize_path (path, bordered ? eq->live_step : eq->step);
  if (status != QN_SOLVE_CONVERGED)
    return status;
  if (bordered)
    qn_equilibrium_solve (eq, eq->step);
  complete_direction (increment, 1);
  return QN_SOLVE_CONVERGED;
}

/* Largest part of the direction, up to all of it, that leaves s and z at zero or above. */
static double
path_to_boundary (const Increment *increment)
{
  return 1 / qn_larger (increment->reach.boundary, 1);
}

/* Mehrotra: the predictor, which aims at nothing, says how far the mean of s z can be lowered. */
static double
mean_by_predictor (const Increment *increment)
{
  const QnCentralForecast *reach = &increment->reach;
  double part = path_to_boundary (increment), products = increment->residuals.products;
  double left = (products + part * (reach->first + part * reach->second)) / products;

  return fmax (LEAST_AIM, left * left * left) * increment->gap;
}

/* Gondzio: corrects the direction, keeping what lengthens the step, which is returned. */
static double
centre_pairs (Increment *increment, double mean, double part, double step)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;
  size_t step_bytes = (size_t) eq->assembly.unknown_count * sizeof (double);

  for (int corrector = 0; corrector < CORRECTORS && step < LONG; corrector++) {
    double longer = fmin (1, 1.3 * step + 0.1),
           multiplier_step = increment->multiplier_step;
    memcpy (path->kept_step, eq->step, step_bytes);
    find_path_direction (increment, &(QnCentralAim){ .target = QN_CENTRAL_CENTRE,
                                                     .part = part,
                                                     .mean = mean,
                                                     .length = longer,
                                                     .spread = CENTRAL });
    double reached = path_to_boundary (increment);
    if (reached < step + GAIN) {
      qn_central_pairs_exchange_steps (&path->pairs);
      memcpy (eq->step, path->kept_step, step_bytes);
      increment->multiplier_step = multiplier_step;
      break;
    }
    step = reached;
  }
  return step;
}

static void
take_step (Increment *increment, double part)
{
  QnEquilibrium *eq = increment->path->eq;
  QnCentralPairs *pairs = &increment->path->pairs;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    eq->u[i] += part * eq->step[i];
  eq->multiplier += part * increment->multiplier_step;
  pairs->loops->go (pairs->packs, pairs->steps, pairs->count, part);
}

/* Whether the iterate is an equilibrium but for this complementarity and lack of balance.
 * Balance, the most expensive one, is asked last. */
static bool
is_within (Increment *increment, double complementarity, double out_of_balance)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  if (!(increment->residuals.strength
          <= fmax (BALANCE, QN_TOLERANCE_FORCE * increment->residuals.force)
        && increment->residuals.strain <= STRAIN * increment->elongation
        && increment->gap <= complementarity * increment->elongation
        && fabs (increment->target_gap)
             <= 0.5 * QN_TOLERANCE_TARGET * fabs (increment->target->advance)))
    return false;

  qn_central_pairs_get_forces (&path->pairs);
  double scale = balance (path, eq->residual);
  return qn_assembly_largest (&eq->assembly, eq->residual, NULL)
         <= out_of_balance * scale;
}

/* Keeps the best iterate that may stand if no better one comes: where the path cannot turn back
 * there is one as good as one likes, and what is in the way is rounding. */
static void
keep_near (Increment *increment)
{
  QnCentralPath *path = increment->path;
  const QnAssembly *as = &path->eq->assembly;

  if (path->may_jump || (increment->is_near && increment->gap >= increment->near_gap)
      || !is_within (increment, NEARLY, path->eq->tolerance))
    return;
  increment->is_near = true;
  increment->near_gap = increment->gap;
  increment->near_multiplier = path->eq->multiplier;
  qn_central_pairs_keep (&path->pairs);
  memcpy (path->near_u, path->eq->u, (size_t) as->unknown_count * sizeof *path->near_u);
}

/* Whether the iterate is good enough for Newton's method to finish. */
static bool
has_converged (Increment *increment)
{
  const QnEquilibrium *eq = increment->path->eq;

  increment->target_gap = qn_equilibrium_target_lack (eq, increment->target, eq->u);
  keep_near (increment);
  return is_within (increment, increment->complementarity, BALANCE);
}

/* Newton's method from where the iteration stands; FAILED leaves it there. */
static QnSolveStatus
finish (Increment *increment)
{
  QnEquilibrium *eq = increment->path->eq;
  size_t bytes = (size_t) eq->assembly.unknown_count * sizeof (double);
  double multiplier = eq->multiplier;
  QnSolveStatus status = QN_SOLVE_FAILED;

  memcpy (increment->path->kept_step, eq->u, bytes);
  if (qn_assembly_evaluate (&eq->assembly, eq->u))
    status = qn_equilibrium_newton (eq, increment->target, increment->path->viscosity,
                                    FINISH_BUDGET);
  if (status == QN_SOLVE_FAILED) {
    memcpy (eq->u, increment->path->kept_step, bytes);
    eq->multiplier = multiplier;
    qn_assembly_update_kinematics (&eq->assembly, eq->u);
  }
  return status;
}

/* Accepts what was reached, in balance and within all strengths: where many pairs are neither
 * sliding nor stuck, Newton's method has nothing to hold on to. */
static QnSolveStatus
adopt (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  if (!qn_central_pairs_take_flow (&path->pairs))
    return QN_SOLVE_FAILED;
  eq->keeps_forces = true;
  QnSolveStatus status =
    qn_equilibrium_newton (eq, increment->target, path->viscosity, 0);
  if (status != QN_SOLVE_CONVERGED || eq->out_of_balance <= eq->tolerance)
    return status;
  /* The laws by themselves do not find these forces again. */
  return qn_central_pairs_take_flow (&path->pairs) ? qn_equilibrium_newton (
           eq, increment->target, path->viscosity, QN_MEASURE_ONLY)
                                                   : QN_SOLVE_FAILED;
}

/* The best iterate, if there is one that may stand. */
static QnSolveStatus
fall_back (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  if (!increment->is_near)
    return QN_SOLVE_FAILED;
  qn_central_pairs_come_back (&path->pairs);
  memcpy (eq->u, path->near_u, (size_t) eq->assembly.unknown_count * sizeof *eq->u);
  eq->multiplier = increment->near_multiplier;
  qn_assembly_update_kinematics (&eq->assembly, eq->u);
  return adopt (increment);
}

/* Whether complementarity still improves. */
static bool
makes_headway (Increment *increment, int iteration)
{
  if (increment->gap <= 0.5 * increment->watched_gap || iteration == 0) {
    increment->watched_gap = increment->gap;
    increment->watched_since = iteration;
  }
  return iteration - increment->watched_since < PATIENCE;
}

/* The part that the direction is to take off the residuals. Where a measure advances, or time, and the path
 * may turn back, they go down with the mean of s z, at one rate: if they vanish sooner, iterates leave
 * the path and get stuck between strengths where it does not turn back at all. Where the multiplier
 * is prescribed, fewer increments get through like that. In nonlinear geometry it is for the caller to say. */
static double
part_of_residuals (const Increment *increment, double mean)
{
  const QnCentralPath *path = increment->path;
  bool moves = increment->target->direction != NULL || path->viscosity > 0;

  return path->together && moves ? fmax (0, 1 - mean / increment->gap) : 1;
}

/* One iteration of the interior-point method. */
static QnSolveStatus
improve (Increment *increment)
{
  QnEquilibrium *eq = increment->path->eq;

  if (!qn_equilibrium_go_on (eq))
    return QN_SOLVE_CANCELLED;
  QnSolveStatus status = find_predictor (increment);
  if (status != QN_SOLVE_CONVERGED)
    return status;
  double mean = mean_by_predictor (increment);
  double part = part_of_residuals (increment, mean);
  if (part < 1) {
    qn_central_pairs_get_forces (&increment->path->pairs);
    balance (increment->path, increment->path->lack);
  }
  find_path_direction (
    increment,
    &(QnCentralAim){ .target = QN_CENTRAL_SECOND_ORDER, .part = part, .mean = mean });
  double step = centre_pairs (increment, mean, part, path_to_boundary (increment));
  take_step (increment, fmin (1, TO_BOUNDARY * step));
  return QN_SOLVE_CONVERGED;
}

static QnSolveStatus
iterate_path (Increment *increment, int budget)
{
  int finishes = 0;

  for (int iteration = 0;; iteration++) {
    if (!prepare_path (increment) || !isfinite (increment->gap))
      return fall_back (increment);
    if (has_converged (increment)) {
      QnSolveStatus status = finish (increment);
      if (status != QN_SOLVE_FAILED)
        return status;
      if (++finishes == MOST_FINISHES)
        return adopt (increment);
      increment->complementarity *= TIGHTER;
      prepare_path (increment);
      has_converged (increment);
    }
    if (iteration == budget || !makes_headway (increment, iteration))
      return fall_back (increment);
    QnSolveStatus status = improve (increment);
    if (status == QN_SOLVE_FAILED)
      return fall_back (increment);
    if (status != QN_SOLVE_CONVERGED)
      return status;
  }
}

/* The mean displacement that the target asks for, in units of the path: what elongations will
 * be like. */
static double
expected_elongation (const QnCentralPath *path, const QnTarget *target)
{
  if (target->direction == NULL)
    return 1;
  double sum = qn_assembly_total (&path->eq->assembly, target->direction);
  return sum > 0 ? fabs (target->advance) / (sum * path->pairs.length) : 1;
}

/* One central path from the current displacements and forces, from mean products of `size`; another one from
 * there where the dilation of joints has turned on the way. */
static QnSolveStatus
follow_path (Increment *increment, double size, int budget)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;
  size_t bytes = (size_t) eq->assembly.unknown_count * sizeof *eq->u;
  double multiplier = eq->multiplier;

  memcpy (path->begun, eq->u, bytes);
  for (int turn = 0;; turn++) {
    increment->complementarity = COMPLEMENTARITY;
    increment->is_near = false;
    qn_central_pairs_start (&path->pairs, size, turn > 0);
    QnSolveStatus status = iterate_path (increment, budget);
    if (status != QN_SOLVE_FAILED || !path->pairs.turned || turn == MOST_TURNS)
      return status;
    memcpy (eq->u, path->begun, bytes);
    eq->multiplier = multiplier;
    if (!qn_assembly_evaluate (&eq->assembly, eq->u))
      return QN_SOLVE_FAILED;
  }
}

QnSolveStatus
qn_central_path_solve (QnCentralPath *path, const QnTarget *target, double viscosity,
                       int budget)
{
  QnEquilibrium *eq = path->eq;
  Increment increment = { .path = path, .target = target };
  double size = expected_elongation (path, target);

  if (viscosity > 0)
    size =
      PART_OF_MOTION
      * (qn_assembly_elastic_displacements (&eq->assembly, eq->motion, NULL) / viscosity);
  else
    qn_equilibrium_restore (eq);
  if (target->direction == NULL)
    eq->multiplier = target->multiplier;
  path->viscosity = viscosity;
  return follow_path (&increment, fmax (1, size), budget);
}
