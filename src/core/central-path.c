#include "core/central-path.h"

#include "core/central-pair.h"
#include "core/clock.h"
#include "core/memory.h"
#include "core/tolerance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Residuals of balance and strength, of strain and complementarity (both relative to the
 * elongations) at which Newton's method may finish; complementarity becomes TIGHTER times as
 * small where it does not. Flows that belong to the last trace of a strength, z = product / s,
 * lose their digits to rounding, and strain with them; displacements and forces do not. */
#define BALANCE         1e-9
#define STRAIN          1e-3
#define COMPLEMENTARITY 1e-9
#define TIGHTER         1e-2
#define MOST_FINISHES   3

/* Iterations that Newton's method gets to finish. */
#define FINISH_BUDGET 12

/* Viscosity in the tangent: holds what touches nothing. */
#define TRACE 1e-12

/* The mean product is lowered to this part of itself at most in one iteration. */
#define LEAST_AIM 1e-6

/* Part of the way to the boundary that a step may go. */
#define TO_BOUNDARY 0.995

/* The iteration leads nowhere if complementarity has not halved in so many iterations. */
#define PATIENCE       10
#define SHORT_PATIENCE 5

/* Part of the direction that counts as a short step. */
#define SHORT 0.2

/* Complementarity at which a new central path begins: so many times that at which the last one
 * turned back, and LONGER times that of the last beginning, as long as that gets no further. */
#define RISE   10.0
#define LONGER 10.0

/* Centrality correctors: at most so many, for steps shorter than LONG; products are brought
 * within CENTRAL times their mean either way; a corrector must gain GAIN. */
#define CORRECTORS 2
#define LONG       0.9
#define CENTRAL    10.0
#define GAIN       0.01

struct QnCentralPath {
  QnEquilibrium *eq;
  double force, length;
  bool turns_back; /* may, for some joint is not associative */
  QnCentralPair *pairs;
  QnCentralStep *steps; /* the direction of the pairs, */
  QnCentralStep *kept;  /* and that found so far, while a better one is sought */
  double *kept_step;    /* unknown_count */
  double *rates;        /* pair_count x 2: elongations under a step */
  double *forces;       /* pair_count x 2, N, and tangents, x 4, N/m, as handed over */
  double *tangents;
};

bool
qn_central_path_applies (const QnAssembly *as)
{
  if (as->nonlinear)
    return false;
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->springs[p].equal && as->springs[p].a.kind == QN_LAW_COULOMB)
      return true;
  return false;
}

static bool
is_associative (const QnAssembly *as)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->springs[p].a.dilatancy < as->springs[p].a.friction)
      return false;
  return true;
}

QnCentralPath *
qn_central_path_new (QnEquilibrium *eq)
{
  const QnAssembly *as = &eq->assembly;
  QnCentralPath *path = qn_alloc (1, sizeof *path);

  if (path == NULL)
    return NULL;
  path->eq = eq;
  path->turns_back = !is_associative (as);
  path->force = as->force_scale > 0 ? as->force_scale : 1;
  path->length = path->force / as->stiffness;
  path->pairs = qn_alloc (as->pair_count, sizeof *path->pairs);
  path->rates = qn_alloc (2 * as->pair_count, sizeof *path->rates);
  path->forces = qn_alloc (2 * as->pair_count, sizeof *path->forces);
  path->tangents = qn_alloc (4 * as->pair_count, sizeof *path->tangents);
  path->steps = qn_alloc (as->pair_count, sizeof *path->steps);
  path->kept = qn_alloc (as->pair_count, sizeof *path->kept);
  path->kept_step = qn_alloc ((size_t) as->unknown_count, sizeof *path->kept_step);
  if (!path->pairs || !path->rates || !path->forces || !path->tangents || !path->steps
      || !path->kept || !path->kept_step) {
    qn_central_path_free (path);
    return NULL;
  }
  return path;
}

bool
qn_central_path_turns_back (const QnCentralPath *path)
{
  return path->turns_back;
}

void
qn_central_path_free (QnCentralPath *path)
{
  if (path == NULL)
    return;
  free (path->pairs);
  free (path->rates);
  free (path->forces);
  free (path->tangents);
  free (path->steps);
  free (path->kept);
  free (path->kept_step);
  free (path);
}

/* One solution in progress. */
typedef struct {
  QnCentralPath *path;
  const QnTarget *target;
  double strain, strength; /* largest residuals */
  double gap;              /* mean of s z */
  double elongation;       /* 1 + the largest */
  double target_gap;       /* what the target lacks */
  double multiplier_step;
  double boundary;        /* how fast the direction leads there: see central-pair.h */
  double complementarity; /* asked for */
  double watched_gap;     /* when it had last halved, */
  int watched_since;      /* and that iteration */
  bool relaxes;           /* a new central path may begin where this one ends */
  int short_steps;        /* one after the other, up to now */
} Increment;

/* The elongations of all pairs at eq->u, in units of the path; the pairs of other laws are
 * evaluated. Sets the residuals of strain and strength. */
static bool
prepare (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnAssembly *as = &path->eq->assembly;
  size_t rows = 0;
  double products = 0;

  qn_assembly_update_kinematics (as, path->eq->u);
  qn_beam_assembly_evaluate (&as->beams);
  increment->strain = increment->strength = 0;
  increment->elongation = 1;
  for (size_t p = 0; p < as->pair_count; p++) {
    QnCentralPair *pair = &path->pairs[p];
    const double *elongation = as->kinematics[p].elongation;
    if (pair->rows == 0) {
      if (!qn_pair_evaluate (&as->springs[p], &as->committed[p], elongation,
                             &as->responses[p]))
        return false;
      for (int i = 0; i < 2; i++) {
        pair->y[i] = as->responses[p].force[i] / path->force;
        for (int j = 0; j < 2; j++)
          pair->inverse[i][j] =
            as->responses[p].tangent[i][j] * path->length / path->force;
      }
      continue;
    }
    double q[2] = { elongation[0] / path->length, elongation[1] / path->length };
    qn_central_pair_prepare (pair, q);
    for (int i = 0; i < 2; i++) {
      increment->strain = qn_larger (fabs (pair->strain[i]), increment->strain);
      increment->elongation =
        qn_larger (fabs (q[i] - pair->plastic[i]), increment->elongation);
    }
    for (int i = 0; i < pair->rows; i++) {
      increment->strength = qn_larger (fabs (pair->strength[i]), increment->strength);
      products += pair->s[i] * pair->z[i];
    }
    rows += (size_t) pair->rows;
  }
  increment->gap = products / (double) rows;
  return true;
}

/* residual = what the forces of the pairs leave unbalanced; `aiming`: the forces that they would
 * exert if no block moved. Returns what it is measured by. */
static double
balance (QnCentralPath *path, bool aiming, double *residual)
{
  const QnEquilibrium *eq = path->eq;

  for (size_t p = 0; p < eq->assembly.pair_count; p++) {
    QnCentralPair *pair = &path->pairs[p];
    double change[2] = { 0 };
    if (aiming && pair->rows > 0)
      qn_central_pair_aim (pair, change);
    for (int i = 0; i < 2; i++)
      path->forces[2 * p + i] = path->force * (pair->y[i] + change[i]);
  }
  return qn_assembly_residual_of (&eq->assembly, eq->multiplier, path->forces, 2,
                                  residual);
}

static QnFactorStatus
factorize (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;
  double start = qn_clock_seconds ();

  for (size_t p = 0; p < eq->assembly.pair_count; p++)
    for (int i = 0; i < 4; i++)
      path->tangents[4 * p + i] =
        path->pairs[p].inverse[i / 2][i % 2] * path->force / path->length;
  qn_assembly_tangent_of (&eq->assembly, eq->multiplier, TRACE, path->tangents, 4);
  double assembled = qn_clock_seconds ();
  QnFactorStatus status = qn_linsys_factor (eq->linsys, eq->assembly.ax);
  eq->statistics.assembly_seconds += assembled - start;
  eq->statistics.factor_seconds += qn_clock_seconds () - assembled;
  qn_equilibrium_count_factorization (eq);
  eq->factored = false; /* by Newton's method */
  return status;
}

/* The direction that brings every s z to its product and all residuals to zero: eq->step,
 * multiplier_step and the pairs' steps. */
static void
find_direction (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;
  const QnTarget *target = increment->target;

  balance (path, true, eq->step);
  double start = qn_clock_seconds ();
  qn_linsys_solve (eq->linsys, eq->step);
  increment->multiplier_step = 0;
  if (target->direction != NULL) {
    double along_live;
    increment->multiplier_step =
      qn_equilibrium_complete_step (eq, target, increment->target_gap, &along_live);
  }
  eq->statistics.factor_seconds += qn_clock_seconds () - start;

  increment->boundary = 0;
  qn_assembly_elongation_rates (&eq->assembly, eq->step, path->rates);
  for (size_t p = 0; p < eq->assembly.pair_count; p++)
    if (path->pairs[p].rows > 0) {
      double rate[2] = { path->rates[2 * p] / path->length,
                         path->rates[2 * p + 1] / path->length };
      double fastest = qn_central_pair_complete (&path->pairs[p], rate, &path->steps[p]);
      increment->boundary = qn_larger (fastest, increment->boundary);
    }
}

/* Largest part of the direction, up to all of it, that leaves s and z at zero or above. */
static double
way_to_boundary (const Increment *increment)
{
  return 1 / qn_larger (increment->boundary, 1);
}

/* Mean of s z after `part` of the direction. */
static double
gap_after (const QnCentralPath *path, double part)
{
  double sum = 0;
  size_t rows = 0;

  for (size_t p = 0; p < path->eq->assembly.pair_count; p++) {
    const QnCentralPair *pair = &path->pairs[p];
    const QnCentralStep *step = &path->steps[p];
    for (int i = 0; i < pair->rows; i++)
      sum += (pair->s[i] + part * step->ds[i]) * (pair->z[i] + part * step->dz[i]);
    rows += (size_t) pair->rows;
  }
  return sum / (double) rows;
}

/* Mehrotra: the predictor, which aims at zero, says how far mu can be lowered and what its
 * second order is. */
static double
aim_by_predictor (Increment *increment)
{
  QnCentralPath *path = increment->path;
  size_t count = path->eq->assembly.pair_count;

  for (size_t p = 0; p < count; p++)
    memset (path->pairs[p].product, 0, sizeof path->pairs[p].product);
  find_direction (increment);

  double left = gap_after (path, way_to_boundary (increment)) / increment->gap;
  double mean = fmax (LEAST_AIM, left * left * left) * increment->gap;
  for (size_t p = 0; p < count; p++) {
    QnCentralPair *pair = &path->pairs[p];
    const QnCentralStep *step = &path->steps[p];
    for (int i = 0; i < pair->rows; i++)
      pair->product[i] = mean - step->ds[i] * step->dz[i];
  }
  return mean;
}

/* Asks products that a step of this length would leave far from `mean` to be nearer. */
static void
ask_for_centrality (QnCentralPath *path, double mean, double length)
{
  for (size_t p = 0; p < path->eq->assembly.pair_count; p++) {
    QnCentralPair *pair = &path->pairs[p];
    const QnCentralStep *step = &path->steps[p];
    for (int i = 0; i < pair->rows; i++) {
      double product =
        (pair->s[i] + length * step->ds[i]) * (pair->z[i] + length * step->dz[i]);
      double wanted = product < mean / CENTRAL   ? mean / CENTRAL
                      : product > mean * CENTRAL ? mean * CENTRAL
                                                 : product;
      pair->product[i] += qn_larger (wanted - product, -mean * CENTRAL);
    }
  }
}

static void
exchange_steps (QnCentralPath *path)
{
  QnCentralStep *steps = path->steps;

  path->steps = path->kept;
  path->kept = steps;
}

/* Gondzio: corrects the direction, keeping what lengthens the step, which is returned. */
static double
centre (Increment *increment, double mean, double step)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;
  size_t step_bytes = (size_t) eq->assembly.unknown_count * sizeof (double);

  for (int corrector = 0; corrector < CORRECTORS && step < LONG; corrector++) {
    double longer = fmin (1, 1.3 * step + 0.1),
           multiplier_step = increment->multiplier_step;
    ask_for_centrality (path, mean, longer);
    exchange_steps (path);
    memcpy (path->kept_step, eq->step, step_bytes);
    find_direction (increment);
    double reached = way_to_boundary (increment);
    if (reached < step + GAIN) {
      exchange_steps (path);
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
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    eq->u[i] += part * eq->step[i];
  eq->multiplier += part * increment->multiplier_step;
  for (size_t p = 0; p < eq->assembly.pair_count; p++) {
    QnCentralPair *pair = &path->pairs[p];
    const QnCentralStep *step = &path->steps[p];
    if (pair->rows == 0)
      continue;
    for (int i = 0; i < 2; i++)
      pair->y[i] += part * step->dy[i];
    for (int i = 0; i < pair->rows; i++) {
      pair->s[i] += part * step->ds[i];
      pair->z[i] += part * step->dz[i];
    }
  }
}

/* Whether the iterate is good enough for Newton's method to finish. Balance, the dearest
 * question, is asked last. */
static bool
has_converged (Increment *increment)
{
  QnCentralPath *path = increment->path;
  QnEquilibrium *eq = path->eq;

  increment->target_gap =
    qn_equilibrium_target_lack (eq, increment->target, eq->u, eq->multiplier);
  if (increment->strength > BALANCE || increment->strain > STRAIN * increment->elongation
      || increment->gap > increment->complementarity * increment->elongation
      || fabs (increment->target_gap)
           > 0.5 * QN_TOLERANCE_TARGET * fabs (increment->target->advance))
    return false;

  double scale = balance (path, false, eq->residual), largest = 0;
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    largest = qn_larger (fabs (eq->residual[i]), largest);
  return largest <= BALANCE * scale;
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
    status = qn_equilibrium_newton (eq, increment->target, 0, FINISH_BUDGET);
  if (status == QN_SOLVE_FAILED) {
    memcpy (eq->u, increment->path->kept_step, bytes);
    eq->multiplier = multiplier;
    qn_assembly_update_kinematics (&eq->assembly, eq->u);
  }
  return status;
}

/* The responses of the laws become the forces as they are, with the plastic elongations that
 * belong to them. */
static void
take_flow (QnCentralPath *path)
{
  QnEquilibrium *eq = path->eq;
  QnAssembly *as = &eq->assembly;

  for (size_t p = 0; p < as->pair_count; p++) {
    const QnCentralPair *pair = &path->pairs[p];
    QnPairResponse *response = &as->responses[p];
    double flow[2], q[2];

    if (pair->rows == 0) {
      qn_pair_evaluate (&as->springs[p], &as->committed[p], as->kinematics[p].elongation,
                        response);
      continue;
    }
    qn_central_pair_flow (pair, pair->z, flow);
    for (int i = 0; i < 2; i++)
      q[i] =
        path->length * (pair->plastic[i] + flow[i] + pair->flexibility[i] * pair->y[i]);
    qn_pair_evaluate (&as->springs[p], &as->committed[p], q, response);
    response->force[0] = path->force * pair->y[0];
    response->force[1] = path->force * pair->y[1];
    if (pair->rows == QN_CENTRAL_ROWS)
      response->memory.a.slip = as->kinematics[p].elongation[1]
                                - path->length * pair->flexibility[1] * pair->y[1];
  }
}

/* Accepts what was reached, in balance and within all strengths: where many pairs are neither
 * sliding nor stuck, Newton's method has nothing to hold on to. */
static QnSolveStatus
adopt (Increment *increment)
{
  take_flow (increment->path);
  return qn_equilibrium_newton (increment->path->eq, increment->target, 0, 0);
}

/* Whether complementarity still improves. Where relaxation waits to go on from here, two short
 * steps one after the other are a sign that the central path turns back. */
static bool
makes_headway (Increment *increment, int iteration)
{
  if (increment->gap <= 0.5 * increment->watched_gap || iteration == 0) {
    increment->watched_gap = increment->gap;
    increment->watched_since = iteration;
  }
  if (!increment->path->eq->assembly.model->analysis.shortcuts.early_failure)
    return true;
  int patience = increment->relaxes ? SHORT_PATIENCE : PATIENCE;
  return iteration - increment->watched_since < patience
         && !(increment->relaxes && increment->short_steps == 2);
}

/* One iteration of the interior-point method. */
static QnSolveStatus
improve (Increment *increment)
{
  QnEquilibrium *eq = increment->path->eq;

  if (!qn_equilibrium_go_on (eq))
    return QN_SOLVE_CANCELLED;
  switch (factorize (increment->path)) {
  case QN_FACTOR_OK:
    break;
  case QN_FACTOR_SINGULAR:
    return QN_SOLVE_FAILED;
  case QN_FACTOR_NO_MEMORY:
    return QN_SOLVE_NO_MEMORY;
  }
  if (increment->target->direction != NULL) {
    memcpy (eq->live_step, eq->assembly.live,
            (size_t) eq->assembly.unknown_count * sizeof (double));
    qn_linsys_solve (eq->linsys, eq->live_step);
  }

  double mean = aim_by_predictor (increment);
  find_direction (increment);
  double step = centre (increment, mean, way_to_boundary (increment));
  take_step (increment, fmin (1, TO_BOUNDARY * step));
  increment->short_steps = step < SHORT ? increment->short_steps + 1 : 0;
  return QN_SOLVE_CONVERGED;
}

static QnSolveStatus
iterate (Increment *increment, int budget)
{
  int finishes = 0;

  for (int iteration = 0;; iteration++) {
    if (!prepare (increment) || !isfinite (increment->gap))
      return QN_SOLVE_FAILED;
    if (has_converged (increment)) {
      QnSolveStatus status = finish (increment);
      if (status != QN_SOLVE_FAILED)
        return status;
      if (++finishes == MOST_FINISHES)
        return adopt (increment);
      increment->complementarity *= TIGHTER;
      prepare (increment);
      has_converged (increment);
    }
    if (iteration == budget || !makes_headway (increment, iteration))
      return QN_SOLVE_FAILED;
    QnSolveStatus status = improve (increment);
    if (status != QN_SOLVE_CONVERGED)
      return status;
  }
}

static void
start_pair (const QnCentralPath *path, size_t p, double size)
{
  const QnAssembly *as = &path->eq->assembly;
  double q[2], y[2];

  for (int i = 0; i < 2; i++) {
    q[i] = as->kinematics[p].elongation[i] / path->length;
    y[i] = as->responses[p].force[i] / path->force;
  }
  qn_central_pair_start (&path->pairs[p], &as->springs[p], &as->committed[p], q, y,
                         path->force, path->length, size);
}

/* The mean displacement that the target asks for, in units of the path: what elongations will
 * be like. */
static double
expected_elongation (const QnCentralPath *path, const QnTarget *target)
{
  double sum = 0;

  if (target->direction == NULL)
    return 1;
  for (int32_t i = 0; i < path->eq->assembly.unknown_count; i++)
    sum += fabs (target->direction[i]);
  return sum > 0 ? fmax (1, fabs (target->advance) / (sum * path->length)) : 1;
}

/* From the committed state towards the target. */
static Increment
begin (QnCentralPath *path, const QnTarget *target)
{
  QnEquilibrium *eq = path->eq;

  qn_equilibrium_restore (eq);
  if (target->direction == NULL)
    eq->multiplier = target->multiplier;
  return (Increment){ .path = path, .target = target };
}

/* One central path from the current displacements and forces, from mean products of `size`. */
static QnSolveStatus
follow (Increment *increment, double size, int budget)
{
  QnCentralPath *path = increment->path;

  increment->complementarity = COMPLEMENTARITY;
  increment->short_steps = 0;
  for (size_t p = 0; p < path->eq->assembly.pair_count; p++)
    start_pair (path, p, size);
  return iterate (increment, budget);
}

QnSolveStatus
qn_central_path_solve (QnCentralPath *path, const QnTarget *target, int budget)
{
  Increment increment = begin (path, target);

  return follow (&increment, expected_elongation (path, target), budget);
}

QnSolveStatus
qn_central_path_relax (QnCentralPath *path, const QnTarget *target, int budget,
                       int passes)
{
  QnEquilibrium *eq = path->eq;
  double size = expected_elongation (path, target), gap_before = INFINITY;

  if (!path->turns_back)
    return qn_central_path_solve (path, target, budget);
  Increment increment = begin (path, target);

  increment.relaxes = true;
  for (int pass = 0; pass < passes; pass++) {
    QnSolveStatus status = follow (&increment, size, budget);
    if (status != QN_SOLVE_FAILED)
      return status;
    if (!isfinite (increment.gap))
      return QN_SOLVE_FAILED;
    if (target->direction != NULL && eq->multiplier < eq->committed.multiplier)
      return QN_SOLVE_FAILED; /* a branch that falls */
    if (qn_equilibrium_elastic_displacements (eq) > QN_RUNAWAY)
      return QN_SOLVE_MECHANISM;

    take_flow (path);
    qn_assembly_commit (&eq->assembly);
    bool nearer = increment.gap <= 0.5 * gap_before;
    size = fmax (fmax (1, RISE * increment.gap), nearer ? size / LONGER : size * LONGER);
    gap_before = increment.gap;
  }
  return QN_SOLVE_FAILED;
}
