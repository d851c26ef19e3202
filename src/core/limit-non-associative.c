#include "core/limit.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>

/* A sequence ends when two successive programs agree to this, relative to the multiplier … */
#define SETTLED 1e-4

/* … and the shear lines have come this near to the flow rule. */
#define LEAST_REMAINING 1e-3

/* Programs after which a sequence counts as not settled. */
#define MOST_PROGRAMS 60

/* How a sequence is led. Gilbert, Casapulla & Ahmed turn the lines by the same factor after
 * every program and mix the anchors with those before, because anchors alone may swing. */
typedef struct Schedule {
  double turn;  /* factor of `remaining` after each program */
  double mix;   /* share of the new compressions in the next anchors */
  double noise; /* relative size of a random disturbance of the first anchors */
} Schedule;

static const Schedule schedules[QN_LIMIT_STARTS] = {
  { 0.3, 0.6, 0.0 },  /* the values of the paper */
  { 0.01, 0.6, 0.0 }, /* straight to the flow rule */
  { 0.7, 0.4, 0.0 },  /* slowly */
  { 0.3, 0.6, 0.5 },  /* disturbed */
  { 0.3, 0.6, 1.0 },
};

typedef struct Sequence {
  const QnModel *model;
  const QnContacts *contacts;
  QnLimitProblem limit;
  QnInteriorPoint ip;
  QnProgressFunc progress;
  void *user_data;
  double *anchor; /* pair_count: compressions that the shear lines pass through */
  const double *associative; /* pair_count x 2: forces of the associative program */
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

static double
compression (const double *force)
{
  return fmax (0.0, -force[0]);
}

/* Runs one sequence from the associative forces. `last` receives the last program's solution;
 * it is empty where the first had no optimum. */
static QnStatus
follow (Sequence *seq, const Schedule *schedule, uint64_t seed, QnLimitFixedPoint *point,
        QnLimitSolution *last, bool *cancelled, QnDiag *diag)
{
  size_t pairs = seq->contacts->pair_count;
  double remaining = schedule->turn;

  *point = (QnLimitFixedPoint){ .multiplier = NAN };
  *last = (QnLimitSolution){ 0 };
  for (size_t p = 0; p < pairs; p++) {
    double share = 1.0 + schedule->noise * (2.0 * disturbance (seed + p) - 1.0);
    seq->anchor[p] = share * compression (seq->associative + 2 * p);
  }
  while (point->programs < MOST_PROGRAMS && !point->settled) {
    QnLimitSolution solution;
    QnStatus status;

    qn_limit_problem_set_shear (&seq->limit, seq->model, seq->contacts, seq->anchor,
                                remaining);
    status = qn_limit_solve (&seq->limit, &seq->ip, false, seq->progress, seq->user_data,
                             &solution, diag);
    if (status)
      return status;
    point->programs++;
    *cancelled = solution.outcome == QN_OUTCOME_CANCELLED;
    if (solution.outcome != QN_OUTCOME_COLLAPSE) {
      qn_limit_solution_clear (&solution);
      return QN_OK;
    }
    point->settled = remaining <= LEAST_REMAINING
                     && fabs (solution.lower_bound - point->multiplier)
                          <= SETTLED * fabs (point->multiplier);
    point->multiplier = solution.lower_bound;
    for (size_t p = 0; p < pairs; p++)
      seq->anchor[p] +=
        schedule->mix * (compression (solution.forces + 2 * p) - seq->anchor[p]);
    remaining = fmax (LEAST_REMAINING, remaining * schedule->turn);
    qn_limit_solution_clear (last);
    *last = solution;
  }
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
keep_point (QnLimitInterval *interval, const QnLimitFixedPoint *point,
            QnLimitSolution *solution)
{
  bool first = interval->count == 0;

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
  int32_t iterations = associative.iterations,
          factorizations = associative.factorizations;
  bool cancelled = false;
  QnStatus status = QN_OK;

  interval->solution = (QnLimitSolution){ .outcome = QN_OUTCOME_NOT_CONVERGED };
  seq->associative = associative.forces;
  for (int start = 0; start < QN_LIMIT_STARTS && !status && !cancelled; start++) {
    QnLimitFixedPoint point;
    QnLimitSolution last;
    uint64_t seed = (uint64_t) start * seq->contacts->pair_count;

    status = follow (seq, &schedules[start], seed, &point, &last, &cancelled, diag);
    iterations += last.iterations;
    factorizations += last.factorizations;
    if (!status && point.settled && !cancelled)
      keep_point (interval, &point, &last);
    else
      qn_limit_solution_clear (&last);
  }
  if (cancelled) {
    qn_limit_solution_clear (&interval->solution);
    interval->solution.outcome = QN_OUTCOME_CANCELLED;
  }
  interval->solution.iterations = iterations;
  interval->solution.factorizations = factorizations;
  qn_limit_solution_clear (&associative);
  return status;
}

QnStatus
qn_limit_non_associative (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc progress, void *user_data,
                          QnLimitInterval *interval, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();
  Sequence seq = {
    .model = model, .contacts = contacts, .progress = progress, .user_data = user_data
  };
  QnStatus status = qn_limit_problem_init (&seq.limit, model, contacts, true, diag);

  *interval = (QnLimitInterval){ 0 };
  if (status)
    return status;
  seq.anchor = qn_alloc (contacts->pair_count, sizeof *seq.anchor);
  if (seq.anchor)
    status = qn_interior_point_init (&seq.ip, &seq.limit.ip, &settings, diag);
  else
    status = qn_diag_no_memory (diag);
  if (!status)
    status = qn_limit_solve (&seq.limit, &seq.ip, true, progress, user_data,
                             &interval->solution, diag);
  if (!status && interval->solution.outcome == QN_OUTCOME_COLLAPSE) {
    interval->associative = interval->solution.upper_bound;
    status = follow_all (&seq, interval, diag);
  }
  qn_interior_point_clear (&seq.ip);
  qn_limit_problem_clear (&seq.limit);
  free (seq.anchor);
  if (status)
    qn_limit_interval_clear (interval);
  return status;
}
