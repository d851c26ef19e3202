#include "core/limit/limit.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <math.h>
#include <stdlib.h>

/* A sequence has settled when two successive programs agree to this, relative to the
 * multiplier, the shear lines have come this near to the flow rule, and no pair's shear exceeds
 * its true strength by more than this part of the largest force: a tenth of what the check of a
 * result lets pass. */
#define SETTLED         1e-6
#define LEAST_REMAINING 1e-3
#define ADMISSIBLE      1e-7

/* Programs after which a sequence counts as not settled: the excess falls by a quarter a program. */
#define MOST_PROGRAMS 70

/* Where the excess does not fall the anchors swing, and so much less of the new compressions is mixed
 * into them, but no less than this. */
#define CALMER    0.7
#define LEAST_MIX 0.15

/* Accuracy of one program of a sequence. */
#define PROGRAM_TOLERANCE 1e-8

/* A settled state is a fixed point where forces alone, whatever their size, could not raise the
 * multiplier by more than this part of it: then there is a mechanism too. */
#define MECHANISM_GAP 2e-3

/* How a sequence starts and is led. Gilbert, Casapulla & Ahmed start from the associative
 * forces, turn the lines by the same factor after every program and mix the anchors with those
 * before, because anchors alone may swing. Where the optimal forces are not unique, their choice
 * decides which fixed point is reached: forces wedged between each other raise the friction that
 * carries them. A small price on the forces (the elastic energy of joints of one stiffness)
 * makes the choice that a structure built without wedging makes.
 *
 * How small a price is small follows from no formula. Every power of ten from 1e-2 to 1e-5 is
 * tried, and the mechanism decides which state counts: a price too high holds the multiplier
 * below what the forces it chose could carry, the search for the mechanism finds that out, and
 * the state is dropped. No published multiplier enters. */
typedef struct Schedule {
  double
    dead; /* share of the dead load's forces in the first anchors; the rest is that of
                   the associative ones */
  double noise; /* relative size of a random disturbance of the first anchors */
  double turn;  /* factor of `remaining` after each program */
  double mix;   /* share of the new compressions in the next anchors */
  double price; /* compliance, in scaled terms */
} Schedule;

static const Schedule schedules[QN_LIMIT_STARTS] = {
  { 0.0, 0.0, 0.3, 0.6, 1e-2 },  { 0.0, 0.0, 0.3, 0.6, 1e-3 },
  { 1.0, 0.0, 0.01, 0.6, 1e-3 }, { 0.0, 0.0, 0.3, 0.6, 1e-4 },
  { 0.5, 1.0, 0.01, 0.6, 1e-4 }, { 0.0, 0.0, 0.3, 0.6, 1e-5 },
};

typedef struct Sequence {
  const QnModel *model;
  const QnContacts *contacts;
  QnLimitProblem limit;
  QnInteriorPoint ip;
  QnProgressFunc progress;
  void *user_data;
  double
    *anchor; /* pair_count: compressions that the shear lines pass through; of joints that
                     hold together negative ones, too, for tension takes strength from shear */
  const QnLimitSolution *associative;
  QnStatistics effort; /* of all programs */
} Sequence;

/* A number in [0, 1) from a pair's number: the same on every machine. */
static double
disturbance (uint64_t seed)
{
  seed += 0x9e3779b97f4a7c15u; /* splitmix64, S. Vigna, public domain */
  seed = (seed ^ (seed >> 30)) * 0xbf58476d1ce4e5b9u;
  seed = (seed ^ (seed >> 27)) * 0x94d049bb133111ebu;
  seed ^= seed >> 31;
  return (double) (seed >> 11) / 9007199254740992.0;
}

static void
set_first_anchors (Sequence *seq, const Schedule *schedule, uint64_t seed)
{
  const double *live = seq->associative->forces, *dead = seq->associative->dead_forces;

  for (size_t p = 0; p < seq->contacts->pair_count; p++) {
    double share = 1.0 + schedule->noise * (2.0 * disturbance (seed + p) - 1.0);
    double start = -live[2 * p];
    if (dead)
      start += schedule->dead * (-dead[2 * p] - start);
    seq->anchor[p] = share * start;
  }
}

/* Moves the anchors towards the compressions of a solution; returns by how much shear exceeds
 * the true strength at most, relative to the largest force: the lines are above it where they
 * have an anchor greater than the compression. */
static double
move_anchors (Sequence *seq, const double *forces, double mix)
{
  double worst = 0.0, largest = 0.0;

  for (size_t p = 0; p < seq->contacts->pair_count; p++) {
    double friction = qn_limit_problem_friction (seq->model, seq->contacts, (QnId) p);
    double now = -forces[2 * p];
    largest = fmax (largest, fabs (now));
    worst = qn_worse (worst, friction * (seq->anchor[p] - now));
    seq->anchor[p] += mix * (now - seq->anchor[p]);
  }
  return largest > 0.0 ? worst / largest : 0.0;
}

/* Runs one sequence. `last` receives the last program's solution; it is empty where the first
 * had no optimum. */
static QnStatus
follow (Sequence *seq, const Schedule *schedule, QnLimitFixedPoint *point,
        QnLimitSolution *last, bool *cancelled, QnDiag *diag)
{
  double remaining = schedule->turn, mix = schedule->mix, before = INFINITY;
  QnStatus status = QN_OK;

  *point = (QnLimitFixedPoint){ .multiplier = NAN };
  *last = (QnLimitSolution){ 0 };
  qn_limit_problem_set_compliance (&seq->limit, schedule->price);
  while (point->programs < MOST_PROGRAMS && !point->settled) {
    QnLimitSolution solution;
    double excess;

    qn_limit_problem_set_shear (&seq->limit, seq->model, seq->contacts, seq->anchor,
                                remaining);
    status = qn_limit_solve (&seq->limit, &seq->ip, false, NULL, seq->progress,
                             seq->user_data, &solution, diag);
    if (status)
      break;
    point->programs++;
    qn_statistics_add (&seq->effort, &solution.effort);
    *cancelled = solution.outcome == QN_OUTCOME_CANCELLED;
    if (solution.outcome != QN_OUTCOME_COLLAPSE) {
      qn_limit_solution_clear (&solution);
      break;
    }
    excess = move_anchors (seq, solution.forces, mix);
    if (remaining <= LEAST_REMAINING && excess > before)
      mix = fmax (LEAST_MIX, CALMER * mix);
    before = excess;
    point->settled = remaining <= LEAST_REMAINING && excess <= ADMISSIBLE
                     && fabs (solution.lower_bound - point->multiplier)
                          <= SETTLED * fabs (point->multiplier);
    point->multiplier = solution.lower_bound;
    remaining = fmax (LEAST_REMAINING, remaining * schedule->turn);
    qn_limit_solution_clear (last);
    *last = solution;
  }
  return status;
}

/* Finds the mechanism by the linear program with the shear lines of a settled state: *point stays
 * settled only if there is one, and *last receives its velocities. */
static QnStatus
find_mechanism (Sequence *seq, QnLimitFixedPoint *point, QnLimitSolution *last,
                bool *cancelled, QnDiag *diag)
{
  QnLimitSolution free_forces;
  double *swap;
  QnStatus status;

  qn_limit_problem_set_compliance (&seq->limit, 0.0);
  status = qn_limit_solve (&seq->limit, &seq->ip, false, NULL, seq->progress,
                           seq->user_data, &free_forces, diag);
  if (status)
    return status;
  *cancelled = free_forces.outcome == QN_OUTCOME_CANCELLED;
  point->settled = free_forces.outcome == QN_OUTCOME_COLLAPSE
                   && free_forces.lower_bound - point->multiplier
                        <= MECHANISM_GAP * fabs (free_forces.lower_bound);
  swap = last->velocities;
  last->velocities = free_forces.velocities;
  free_forces.velocities = swap;
  qn_statistics_add (&seq->effort, &free_forces.effort);
  qn_limit_solution_clear (&free_forces);
  return QN_OK;
}

void
qn_limit_interval_clear (QnLimitInterval *interval)
{
  qn_limit_solution_clear (&interval->solution);
  *interval = (QnLimitInterval){ 0 };
}

/* Keeps a fixed point; the solution of the least one replaces that of the others. */
static void
keep_point (QnLimitInterval *interval, QnLimitFixedPoint *point,
            QnLimitSolution *solution)
{
  bool first = interval->count == 0;

  /* Lines above the true strength by up to ADMISSIBLE may carry a little too much. */
  solution->lower_bound = fmin (point->multiplier, interval->associative);
  point->multiplier = solution->lower_bound;
  interval->points[interval->count++] = *point;
  if (first || point->multiplier > interval->highest)
    interval->highest = point->multiplier;
  if (!first && point->multiplier >= interval->lowest) {
    qn_limit_solution_clear (solution);
    return;
  }
  interval->lowest = point->multiplier;
  qn_limit_solution_clear (&interval->solution);
  interval->solution = *solution;
}

/* All starts, after the associative program has given the first anchors. */
static QnStatus
follow_all (Sequence *seq, QnLimitInterval *interval, QnDiag *diag)
{
  QnLimitSolution associative = interval->solution;
  bool cancelled = false;
  QnStatus status = QN_OK;

  interval->solution = (QnLimitSolution){ .outcome = QN_OUTCOME_NOT_CONVERGED };
  seq->associative = &associative;
  seq->effort = associative.effort;
  for (int start = 0; start < QN_LIMIT_STARTS && !status && !cancelled; start++) {
    QnLimitFixedPoint point;
    QnLimitSolution last;

    set_first_anchors (seq, &schedules[start],
                       (uint64_t) start * seq->contacts->pair_count);
    status = follow (seq, &schedules[start], &point, &last, &cancelled, diag);
    if (!status && point.settled && !cancelled)
      status = find_mechanism (seq, &point, &last, &cancelled, diag);
    if (!status && point.settled && !cancelled)
      keep_point (interval, &point, &last);
    else
      qn_limit_solution_clear (&last);
  }
  if (cancelled) {
    qn_limit_solution_clear (&interval->solution);
    interval->solution.outcome = QN_OUTCOME_CANCELLED;
  }
  interval->solution.effort = seq->effort;
  qn_limit_solution_clear (&associative);
  return status;
}

static QnStatus
sequence_init (Sequence *seq, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();
  QnStatus status =
    qn_limit_problem_init (&seq->limit, seq->model, seq->contacts, true, diag);

  if (status)
    return status;
  settings.tolerance = PROGRAM_TOLERANCE;
  seq->anchor = qn_alloc (seq->contacts->pair_count, sizeof *seq->anchor);
  if (!seq->anchor)
    return qn_diag_no_memory (diag);
  return qn_interior_point_init (&seq->ip, &seq->limit.ip, &settings, diag);
}

static void
sequence_clear (Sequence *seq)
{
  qn_interior_point_clear (&seq->ip);
  qn_limit_problem_clear (&seq->limit);
  free (seq->anchor);
}

QnStatus
qn_limit_find_mechanism (const QnModel *model, const QnContacts *contacts,
                         const QnPairResult *pairs, double multiplier,
                         QnProgressFunc progress, void *user_data, double **velocities,
                         QnDiag *diag)
{
  Sequence seq = {
    .model = model, .contacts = contacts, .progress = progress, .user_data = user_data
  };
  QnLimitFixedPoint point = { .multiplier = multiplier };
  QnLimitSolution solution = { 0 };
  bool cancelled;
  QnStatus status = sequence_init (&seq, diag);

  *velocities = NULL;
  for (size_t p = 0; !status && p < contacts->pair_count; p++)
    seq.anchor[p] = -pairs[p].normal_force;
  if (!status) {
    qn_limit_problem_set_shear (&seq.limit, model, contacts, seq.anchor, LEAST_REMAINING);
    status = find_mechanism (&seq, &point, &solution, &cancelled, diag);
  }
  if (!status && point.settled) {
    *velocities = solution.velocities;
    solution.velocities = NULL;
  }
  qn_limit_solution_clear (&solution);
  sequence_clear (&seq);
  return status;
}

QnStatus
qn_limit_non_associative (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc progress, void *user_data,
                          QnLimitInterval *interval, QnDiag *diag)
{
  Sequence seq = {
    .model = model, .contacts = contacts, .progress = progress, .user_data = user_data
  };
  QnStatus status;

  *interval = (QnLimitInterval){ 0 };
  status = qn_limit_associative (model, contacts, progress, user_data,
                                 &interval->solution, diag);
  if (status || interval->solution.outcome != QN_OUTCOME_COLLAPSE)
    return status;
  interval->associative = interval->solution.upper_bound;
  status = sequence_init (&seq, diag);
  if (!status)
    status = follow_all (&seq, interval, diag);
  sequence_clear (&seq);
  if (status)
    qn_limit_interval_clear (interval);
  return status;
}
