#include "core/limit/collapse.h"
#include "core/limit/limit.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Starts, in the order in which a collapse is sought. GO_ON: from where the one before was lost. */
typedef enum {
  REST,
  NEAR_REST,
  REST_AGAIN,
  FORCES,
  START_COUNT,
  GO_ON = START_COUNT
} Start;

/* How collapses are sought. Measured on the six walls and 48 seeded walls of 20 to 600 blocks
 * (docs/experiments/limit-analysis.md). */
static const struct {
  double
    strength[GO_ON + 1]; /* that joints have left at the start, in loads of a block */
  double coupling[START_COUNT]; /* least one (collapse.h): others find other walls */
  double large; /* free blocks; from there on starts are from rest, have this coupling, */
  double coupled;
  double excess; /* and this share of the power on excess strength (collapse.h) */
  double
    compliance; /* times the number of free blocks: what a tall wall gives grows with it */
  double softest; /* compliance of a few blocks */
  double softer;  /* where no start leads to an end, and for other collapses */
  double stiffer; /* from one compliance to the next, until the multiplier stands still */
  double rigid;   /* what joints of a mechanism may give, over the largest velocity */
  double reach;   /* of a collapse with stiffer joints, in `growth` */
  double tolerance; /* of one collapse, in tolerances of the multiplier */
  int stiffenings;  /* most, where joints give too much at once */
  int32_t budget;   /* factorisations of the first start, */
  int32_t long_run; /* of that of a large structure, */
  int32_t again;    /* of each further one until there is a collapse, */
  int32_t stiff;    /* of all, as long as it does not stand still, */
  int32_t spare;    /* and until others are sought beside one that does */
} search_tuning = {
  .strength = { [REST] = 10,
                [NEAR_REST] = 3,
                [REST_AGAIN] = 10,
                [FORCES] = 10,
                [GO_ON] = 0.1 },
  .coupling = { [REST] = 0.3, [NEAR_REST] = 0.7, [REST_AGAIN] = 0.6, [FORCES] = 0.5 },
  .large = 2000,
  .coupled = 0.7,
  .excess = 0.5,
  .compliance = 0.03,
  .softest = 1e-3,
  .softer = 10,
  .stiffer = 0.2,
  .rigid = 0.01,
  .reach = 5,
  .tolerance = 0.03,
  .stiffenings = 4,
  .budget = 200,
  .long_run = 300,
  .again = 150,
  .stiff = 110,
  .spare = 38,
};

/* Shear lines of the program that finds a mechanism keep this part of their slope: a pair without force
 * would else have no strength inside. */
#define LEAST_SLOPE 1e-3

/* Forces are those of a mechanism where forces of any other size could not raise the multiplier by more
 * than this part of it. */
#define MECHANISM_GAP 2e-3

/* A collapse that was found. */
typedef struct Collapse {
  double multiplier;
  double growth;      /* as joints become stiffer (collapse.h) */
  double *forces;     /* pair_count x 2 */
  double *velocities; /* block_count x 3 */
} Collapse;

typedef struct Search {
  const QnModel *model;
  const QnContacts *contacts;
  bool elastic;       /* joints have their own stiffness, velocities are displacements, */
  double flexibility; /* and this in the mean, m/N */
  QnLimitProblem limit;
  QnCollapse collapse;
  QnLimitInterval *interval;
  double *forces;    /* cell_count x 2: those that a collapse is sought from, */
  double multiplier; /* and their scaled multiplier */
  Collapse found[QN_LIMIT_STARTS];
  int32_t count;
  double
    gives; /* of the last collapse: what joints give at most, over the largest velocity */
  double
    known; /* what is not below it is of no interest, and one start tells enough; or INFINITY */
  bool cancelled;
  QnProgressFunc progress;
  void *user_data;
} Search;

static bool
go_on_search (void *data)
{
  Search *search = data;

  return qn_limit_count_iteration (&search->collapse, search->progress, search->user_data,
                                   &search->interval->solution.effort);
}

static bool
stands_still (const Search *search, const Collapse *collapse)
{
  return fabs (collapse->growth)
         <= search->model->analysis.multiplier_tolerance * fabs (collapse->multiplier);
}

static const Collapse *
find_least (const Search *search)
{
  const Collapse *least = &search->found[0];

  for (int32_t i = 1; i < search->count; i++)
    if (search->found[i].multiplier < least->multiplier)
      least = &search->found[i];
  return least;
}

/* Within what difference two multipliers may become one with stiffer joints. */
static double
reach_of (const Search *search, const Collapse *a, const Collapse *b)
{
  double exact = search->model->analysis.multiplier_tolerance
                 * fmax (fabs (a->multiplier), fabs (b->multiplier));

  return exact + search_tuning.reach * (fabs (a->growth) + fabs (b->growth));
}

static bool
are_same (const Search *search, const Collapse *a, const Collapse *b)
{
  return fabs (a->multiplier - b->multiplier) <= reach_of (search, a, b);
}

static bool
is_of_interest (const Search *search, const Collapse *found)
{
  const Collapse known = { .multiplier = search->known };

  return search->known == INFINITY
         || known.multiplier - found->multiplier > reach_of (search, &known, found);
}

/* Keeps the collapse just found; in place of one that it is, too, with softer joints. */
static QnStatus
keep (Search *search, double compliance, QnDiag *diag)
{
  const QnLimitProblem *limit = &search->limit;
  const QnCollapse *c = &search->collapse;
  Collapse new = { .multiplier =
                     fmin (qn_limit_problem_multiplier (limit, c->ip.at.lambda),
                           search->interval->associative),
                   .growth = qn_limit_problem_multiplier (limit, c->growth) };
  int32_t place = 0;

  while (place < search->count && !are_same (search, &search->found[place], &new))
    place++;
  bool known = place < search->count;
  if (place == QN_LIMIT_STARTS || search->gives > search_tuning.rigid
      || (known
          && (stands_still (search, &search->found[place])
              || fabs (search->found[place].growth) <= fabs (new.growth))))
    return QN_OK;
  Collapse *kept = &search->found[place];
  if (!known) {
    kept->forces = qn_alloc (2 * limit->pair_count, sizeof (double));
    kept->velocities = qn_alloc (limit->block_count * QN_DOF_COUNT, sizeof (double));
    if (kept->forces == NULL || kept->velocities == NULL)
      return qn_diag_no_memory (diag);
    search->count++;
  }
  kept->multiplier = new.multiplier;
  kept->growth = new.growth;
  qn_limit_problem_forces (limit, c->ip.at.y, 1, kept->forces);
  qn_limit_problem_velocities (limit, c->ip.at.v, kept->velocities);
  double scale =
    search->elastic ? search->flexibility * limit->force_unit / compliance : 1;
  for (size_t i = 0; i < limit->block_count * QN_DOF_COUNT; i++)
    kept->velocities[i] *= scale;
  return QN_OK;
}

/* Joints give so much, in scaled rates per scaled force; elastic ones in the mean. */
static void
set_compliance (Search *search, double compliance)
{
  QnLimitProblem *limit = &search->limit;

  for (int32_t c = 0; c < limit->ip.cell_count; c++) {
    double k[2] = { 1, 1 };
    if (search->elastic) {
      QnPairSprings springs = qn_contacts_pair_springs (search->model, search->contacts,
                                                        (size_t) limit->cell_pairs[c]);
      qn_pair_elastic_stiffness (&springs, k);
      k[0] *= search->flexibility;
      k[1] *= search->flexibility;
    }
    for (int i = 0; i < 2; i++)
      limit->cells[c].quadratic[i] = compliance / k[i];
  }
}

/* Whether iterations stall unless what is left out of the strengths holds the products back. */
static bool
is_large (const Search *search)
{
  return !search->elastic
         && search->limit.ip.row_count > QN_DOF_COUNT * search_tuning.large;
}

/* One start. A collapse in which joints give too much is none. */
static QnStatus
seek (Search *search, Start start, double compliance, int32_t budget, bool *found,
      QnDiag *diag)
{
  QnCollapse *c = &search->collapse;
  double tolerance =
    search_tuning.tolerance * search->model->analysis.multiplier_tolerance;

  set_compliance (search, compliance);
  bool rest = start != FORCES;
  if (start == GO_ON)
    qn_collapse_centre (c, search_tuning.strength[GO_ON]);
  else
    qn_collapse_start (c, rest ? NULL : search->forces, rest ? 0 : search->multiplier,
                       search_tuning.strength[start], search_tuning.coupling[start]);
  if (is_large (search)) {
    c->least_coupling = search_tuning.coupled;
    c->excess = search_tuning.excess;
  }
  QnCollapseState state = qn_collapse_follow (c, tolerance, budget, go_on_search, search);
  qn_limit_take_effort (c, &search->interval->solution.effort);
  search->cancelled = state == QN_COLLAPSE_CANCELLED;
  search->gives = 0;
  *found = false;
  if (state != QN_COLLAPSE_FOUND)
    return QN_OK;
  const QnIpProblem *p = &search->limit.ip;
  search->gives = compliance * qn_largest (c->ip.at.y, 2 * (size_t) p->cell_count)
                  / qn_largest (c->ip.at.v, (size_t) p->row_count);
  *found = search->gives <= search_tuning.rigid;
  return keep (search, compliance, diag);
}

/* From each start until there is a collapse, with stiffer joints where they give too much, then from
 * rest with softer ones; of a large structure from rest alone. After that with stiffer ones as long as
 * the least multiplier does not stand still; where it does at once, softer joints may lead to another
 * collapse. */
static QnStatus
seek_all (Search *search, QnDiag *diag)
{
  const QnStatistics *effort = &search->interval->solution.effort;
  double blocks = search->limit.ip.row_count / (double) QN_DOF_COUNT;
  double compliance = fmin (search_tuning.softest, search_tuning.compliance / blocks);
  int32_t before = effort->factorizations;
  bool found = false;
  QnStatus status = QN_OK;
  int start = search->elastic ? FORCES : REST, again = search_tuning.stiffenings;

  bool once = search->known < INFINITY;

  for (; start <= (once ? REST : START_COUNT) && !found && !status && !search->cancelled;
       start = is_large (search) && start == REST ? START_COUNT : start + 1) {
    if (start == START_COUNT && !search->elastic)
      compliance *= search_tuning.softer;
    status = seek (search, start % START_COUNT, compliance,
                   start != REST       ? search_tuning.again
                   : is_large (search) ? search_tuning.long_run
                                       : search_tuning.budget,
                   &found, diag);
    if (!found && !status && !search->cancelled && search->gives == 0 && !search->elastic
        && !once)
      status = seek (search, GO_ON, compliance, search_tuning.again, &found, diag);
    if (search->gives > search_tuning.rigid && again-- > 0) {
      compliance *= 0.5 * search_tuning.rigid / search->gives;
      start--;
    }
  }
  while (search->count > 0 && !status && !search->cancelled
         && is_of_interest (search, find_least (search))) {
    int32_t spent = effort->factorizations - before;
    bool still = stands_still (search, find_least (search));
    /* Stiffer ones take longer. */
    if (spent >= (still ? search_tuning.spare : search_tuning.stiff / 2)
        || (still && (search->elastic || once)))
      break;
    if (still)
      return seek (search, REST, search_tuning.softer * compliance,
                   search_tuning.stiff - spent, &found, diag);
    compliance *= search_tuning.stiffer;
    status = seek (search, start++ % START_COUNT, compliance, search_tuning.stiff - spent,
                   &found, diag);
  }
  return status;
}

/* What was found becomes the solution. */
static void
conclude (Search *search)
{
  QnLimitInterval *interval = search->interval;
  QnLimitSolution *solution = &interval->solution;

  solution->outcome = search->cancelled ? QN_OUTCOME_CANCELLED : QN_OUTCOME_NOT_CONVERGED;
  if (search->cancelled || search->count == 0
      || !is_of_interest (search, find_least (search)))
    return;
  Collapse *least = &search->found[find_least (search) - search->found];
  double *forces = solution->forces, *velocities = solution->velocities;
  solution->forces = least->forces;
  solution->velocities = least->velocities;
  least->forces = forces;
  least->velocities = velocities;
  solution->lower_bound = solution->upper_bound = interval->lowest = least->multiplier;
  interval->highest = -INFINITY;
  for (int32_t i = 0; i < search->count; i++) {
    interval->multipliers[i] = search->found[i].multiplier;
    interval->highest = fmax (interval->highest, interval->multipliers[i]);
  }
  interval->count = search->count;
  /* Below zero the mechanism moves on without live load. */
  solution->outcome =
    least->multiplier < 0 ? QN_OUTCOME_DEAD_LOAD_UNSTABLE : QN_OUTCOME_COLLAPSE;
}

static void
search_clear (Search *search)
{
  qn_collapse_clear (&search->collapse);
  qn_limit_problem_clear (&search->limit);
  free (search->forces);
  for (int32_t i = 0; i < QN_LIMIT_STARTS; i++) {
    free (search->found[i].forces);
    free (search->found[i].velocities);
  }
}

/* `forces` of pairs and then ties, at a multiplier: what a collapse is sought from. */
static QnStatus
search_init (Search *search, const double *forces, double multiplier, QnDiag *diag)
{
  QnLimitProblem *limit = &search->limit;
  QnStatus status =
    qn_limit_problem_init (limit, search->model, search->contacts, true, diag);

  if (status)
    return status;
  search->forces = qn_alloc (2 * (size_t) limit->ip.cell_count, sizeof (double));
  if (search->forces == NULL)
    return qn_diag_no_memory (diag);
  for (int32_t i = 0; i < 2 * limit->ip.cell_count; i++)
    search->forces[i] = forces[2 * limit->cell_pairs[i / 2] + i % 2] / limit->force_unit;
  search->multiplier = multiplier / qn_limit_problem_multiplier (limit, 1);
  status = qn_collapse_init (&search->collapse, &limit->ip, diag);
  search->collapse.holds_flows = !search->elastic;
  return status;
}

void
qn_limit_interval_clear (QnLimitInterval *interval)
{
  qn_limit_solution_clear (&interval->solution);
  *interval = (QnLimitInterval){ 0 };
}

QnStatus
qn_limit_non_associative (const QnModel *model, const QnContacts *contacts, double known,
                          QnProgressFunc progress, void *user_data,
                          QnLimitInterval *interval, QnDiag *diag)
{
  Search search = { .model = model,
                    .contacts = contacts,
                    .known = known,
                    .interval = interval,
                    .progress = progress,
                    .user_data = user_data };

  *interval = (QnLimitInterval){ 0 };
  QnStatus status = qn_limit_associative (model, contacts, progress, user_data,
                                          &interval->solution, diag);
  if (status || interval->solution.outcome != QN_OUTCOME_COLLAPSE)
    return status;
  interval->associative = interval->solution.upper_bound;
  status = search_init (&search, interval->solution.forces,
                        interval->solution.lower_bound, diag);
  if (!status)
    status = seek_all (&search, diag);
  conclude (&search);
  search_clear (&search);
  if (status)
    qn_limit_interval_clear (interval);
  return status;
}

QnStatus
qn_limit_go_on (const QnModel *model, const QnContacts *contacts, const double *forces,
                double multiplier, QnProgressFunc progress, void *user_data,
                QnLimitSolution *solution, QnDiag *diag)
{
  QnLimitInterval interval = { .associative = INFINITY,
                               .solution.effort = solution->effort };
  Search search = { .model = model,
                    .contacts = contacts,
                    .elastic = true,
                    .known = INFINITY,
                    .interval = &interval,
                    .progress = progress,
                    .user_data = user_data };
  QnStatus status = search_init (&search, forces, multiplier, diag);

  for (size_t p = 0; p < contacts->pair_count; p++) {
    QnPairSprings springs = qn_contacts_pair_springs (model, contacts, p);
    double k[2];
    qn_pair_elastic_stiffness (&springs, k);
    search.flexibility += 1 / (k[0] * (double) contacts->pair_count);
  }
  if (!status)
    status = seek_all (&search, diag);
  conclude (&search);
  *solution = interval.solution;
  search_clear (&search);
  if (status)
    qn_limit_solution_clear (solution);
  return status;
}

QnStatus
qn_limit_find_mechanism (const QnModel *model, const QnContacts *contacts,
                         const QnPairResult *pairs, double multiplier,
                         QnProgressFunc progress, void *user_data, double **velocities,
                         QnDiag *diag)
{
  QnLimitSolution solution = { 0 };
  QnCollapse engine = { 0 };
  QnLimitProblem limit;
  QnStatus status = qn_limit_problem_init (&limit, model, contacts, true, diag);

  *velocities = NULL;
  if (status)
    return status;
  for (int32_t c = 0; c < limit.ip.cell_count; c++) {
    const QnIpCell *cell = &limit.cells[c];
    if ((size_t) limit.cell_pairs[c] >= contacts->pair_count)
      continue; /* ties flow as they are strong */
    double normal = pairs[limit.cell_pairs[c]].normal_force / limit.force_unit;
    for (int32_t i = 0; i < cell->bound_count; i++) {
      QnIpBound *bound = &limit.bounds[cell->first_bound + i];
      double slope = bound->opening + LEAST_SLOPE * (bound->normal - bound->opening);
      bound->limit += (slope - bound->normal) * normal;
      bound->normal = bound->opening = slope;
    }
  }
  status = qn_collapse_init (&engine, &limit.ip, diag);
  if (!status)
    status =
      qn_limit_solve (&limit, &engine, false, progress, user_data, &solution, diag);
  if (!status && solution.outcome == QN_OUTCOME_COLLAPSE
      && solution.lower_bound - multiplier
           <= MECHANISM_GAP * fabs (solution.lower_bound)) {
    *velocities = solution.velocities;
    solution.velocities = NULL;
  }
  qn_limit_solution_clear (&solution);
  qn_collapse_clear (&engine);
  qn_limit_problem_clear (&limit);
  return status;
}
