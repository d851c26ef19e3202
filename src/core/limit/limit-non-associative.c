#include "core/limit/limit.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <math.h>
#include <stdlib.h>

/* REST: from no forces; FORCES: from those of elastic joints; GO_ON: from where the one before was lost. */
typedef enum { REST, FORCES, GO_ON } Start;

/* How collapses are sought. Measured on the six walls and seeded walls of 20 to 2,500 blocks
 * (docs/experiments/limit-analysis.md). */
static const struct {
  double strength[GO_ON + 1]; /* that joints have left at a start, in loads of a block */
  double coupled[2]; /* the least coupling (collapse.h), and that of elastic joints */
  double
    compliance; /* times the number of free blocks: what a tall wall gives grows with it */
  double softest; /* compliance of a few blocks */
  double softer;  /* where no start leads to an end, and for other collapses */
  double stiffer; /* from one compliance to the next, until the multiplier stands still */
  double rigid;   /* what joints of a mechanism may give, over the largest velocity */
  double reach;   /* of a collapse with stiffer joints, in `growth` */
  double tolerance; /* of one collapse, in tolerances of the multiplier */
  double gap;       /* of forces and motion that are found in turn, relative, at least */
  int stiffenings;  /* most, where joints give too much at once */
  int32_t budget;   /* factorisations of each start until it counts as lost, */
  int32_t turns;    /* of two programs in turn, or of a start without them, */
  int32_t more; /* of all, and half as many before another is begun beside a collapse */
} search_tuning = {
  .strength = { [REST] = 5, [FORCES] = 10, [GO_ON] = 0.1 },
  .coupled = { 0.3, 0.5 },
  .compliance = 0.03,
  .softest = 1e-3,
  .softer = 10,
  .stiffer = 0.2,
  .rigid = 0.01,
  .reach = 5,
  .tolerance = 0.03,
  .stiffenings = 4,
  .gap = 1e-3,
  .budget = 40,
  .turns = 150,
  .more = 110,
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
  double growth, gap; /* as joints become stiffer, and of two programs (collapse.h) */
  double *forces;     /* pair_count x 2 */
  double *velocities; /* block_count x 3 */
} Collapse;

typedef struct Search {
  const QnModel *model;
  const QnContacts *contacts;
  bool elastic;       /* joints have their own stiffness, velocities are displacements, */
  double flexibility; /* and this in the mean, m/N */
  QnLimitProblem limit;
  QnLimitSolution *solution;
  double *forces;    /* then: cell_count x 2, those that a collapse is sought from, */
  double multiplier; /* and their scaled multiplier */
  Collapse found[QN_LIMIT_STARTS];
  int32_t count;
  double
    gives; /* of the last collapse: what joints give at most, over the largest velocity */
  double
    known; /* what is not below it is of no interest, and one start tells enough; or INFINITY */
  bool lost; /* the last start */
} Search;

static bool
stands_still (const Search *search, const Collapse *collapse)
{
  return fabs (collapse->growth)
         <= search->model->analysis.multiplier_tolerance * fabs (collapse->multiplier);
}

static Collapse *
find_least (Search *search)
{
  Collapse *least = &search->found[0];

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
  const QnCollapse *c = &limit->engine;
  Collapse new = { .multiplier =
                     fmin (qn_limit_problem_multiplier (limit, c->ip.at.lambda),
                           search->solution->associative),
                   .growth = qn_limit_problem_multiplier (limit, c->growth),
                   .gap = qn_limit_problem_multiplier (limit, c->gap) };
  int32_t place = 0;

  while (place < search->count
         && fabs (search->found[place].multiplier - new.multiplier)
              > reach_of (search, &search->found[place], &new))
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
  new.forces = kept->forces;
  new.velocities = kept->velocities;
  *kept = new;
  qn_limit_problem_forces (limit, c->ip.at.y, 1, kept->forces);
  qn_limit_problem_velocities (limit, c->ip.at.v, kept->velocities);
  double scale =
    search->elastic ? search->flexibility * limit->force_unit / compliance : 1;
  for (size_t i = 0; i < limit->block_count * QN_DOF_COUNT; i++)
    kept->velocities[i] *= scale;
  return QN_OK;
}

/* One start; where its iteration is lost, two programs in turn. A collapse in which joints give too much is
 * none. */
static QnStatus
seek (Search *search, Start start, double compliance, int32_t budget, bool *found,
      QnDiag *diag)
{
  QnCollapse *c = &search->limit.engine;
  double tolerance = search->model->analysis.multiplier_tolerance;
  bool exact = search->known < INFINITY;
  QnOutcome state = QN_OUTCOME_NOT_CONVERGED;

  /* Joints give so much, in scaled rates per scaled force; elastic ones in the mean. */
  QnLimitProblem *limit = &search->limit;
  for (int32_t cell = 0; cell < limit->ip.cell_count; cell++) {
    double k[2] = { 1, 1 };
    if (search->elastic) {
      QnPairSprings springs = qn_contacts_pair_springs (search->model, search->contacts,
                                                        (size_t) limit->cell_pairs[cell]);
      qn_pair_elastic_stiffness (&springs, k);
      k[0] *= search->flexibility;
      k[1] *= search->flexibility;
    }
    for (int i = 0; i < 2; i++)
      limit->ip.cells[cell].quadratic[i] = compliance / k[i];
  }
  if (start == GO_ON)
    qn_collapse_centre (c, search_tuning.strength[start]);
  else
    qn_collapse_start (c, start == FORCES ? search->forces : NULL,
                       start == FORCES ? search->multiplier : 0,
                       search_tuning.strength[start],
                       search_tuning.coupled[search->elastic]);
  if (start != GO_ON || !search->lost)
    state = qn_collapse_follow (c, search_tuning.tolerance * tolerance,
                                exact ? budget : search_tuning.budget, NULL, NULL);
  search->lost = state == QN_OUTCOME_NOT_CONVERGED && !exact;
  if (search->lost)
    state = qn_collapse_alternate (c, fmax (tolerance, search_tuning.gap), budget);
  search->gives = 0;
  *found = false;
  if (state != QN_OUTCOME_COLLAPSE)
    return QN_OK;
  const QnIpProblem *p = &search->limit.ip;
  search->gives = compliance * qn_largest (c->ip.at.y, 2 * (size_t) p->cell_count)
                  / qn_largest (c->ip.at.v, (size_t) p->row_count);
  *found = search->gives <= search_tuning.rigid;
  return keep (search, compliance, diag);
}

/* From rest until there is a collapse: from where a start ended with stiffer joints where they give too much, then
 * from rest with softer ones. After that with stiffer ones from the collapse before, as long as the least multiplier
 * does not stand still; where it does at once, softer joints may lead from rest to another collapse. Elastic joints
 * have one stiffness. */
static QnStatus
seek_all (Search *search, QnDiag *diag)
{
  const QnCollapse *c = &search->limit.engine;
  double compliance = fmin (search_tuning.softest,
                            search_tuning.compliance
                              / (search->limit.ip.row_count / (double) QN_DOF_COUNT));
  int32_t before = c->effort.factorizations;
  bool found = false, once = search->known < INFINITY;
  QnStatus status = QN_OK;
  Start start = search->elastic ? FORCES : REST, next = search->elastic ? REST : GO_ON;
  int left = once ? 1 : 2, stiffenings = search_tuning.stiffenings;

  while (left > 0 && !found && !status && !c->cancelled) {
    status = seek (search, start, compliance, search_tuning.turns, &found, diag);
    if (search->lost && search->gives == 0 && !status && !c->cancelled) {
      search->lost = false;
      status = seek (search, GO_ON, compliance, search_tuning.turns, &found, diag);
    }
    start = next;
    if (search->gives > search_tuning.rigid && stiffenings-- > 0) {
      compliance *= 0.5 * search_tuning.rigid / search->gives;
      continue;
    }
    left--;
    if (!found && !search->elastic)
      compliance *= search_tuning.softer;
    start = REST;
  }
  bool at_once = true;
  while (search->count > 0 && !search->elastic && !status && !c->cancelled
         && is_of_interest (search, find_least (search))) {
    int32_t spent = c->effort.factorizations - before;
    bool still = stands_still (search, find_least (search)), lost = search->lost;
    if ((spent >= search_tuning.more / 2 && (still || !at_once || !lost))
        || (still && (!at_once || once)))
      break;
    compliance *= still  ? search_tuning.softer
                  : lost ? search_tuning.stiffer * search_tuning.stiffer
                         : search_tuning.stiffer;
    status =
      seek (search, still ? REST : next, compliance, search_tuning.more, &found, diag);
    if (still)
      break;
    at_once = false;
  }
  return status;
}

/* What was found becomes the solution. */
static void
conclude (Search *search)
{
  QnLimitSolution *solution = search->solution;
  bool cancelled = search->limit.engine.cancelled;

  solution->effort = search->limit.engine.effort;
  solution->outcome = cancelled ? QN_OUTCOME_CANCELLED : QN_OUTCOME_NOT_CONVERGED;
  solution->count = 0;
  if (cancelled || search->count == 0 || !is_of_interest (search, find_least (search)))
    return;
  Collapse *least = find_least (search);
  double *forces = solution->forces, *velocities = solution->velocities;
  solution->forces = least->forces;
  solution->velocities = least->velocities;
  least->forces = forces;
  least->velocities = velocities;
  solution->lower_bound = least->multiplier;
  solution->upper_bound = -INFINITY;
  solution->uncertainty = fabs (least->growth) + least->gap;
  for (int32_t i = 0; i < search->count; i++) {
    solution->multipliers[i] = search->found[i].multiplier;
    solution->upper_bound = fmax (solution->upper_bound, solution->multipliers[i]);
  }
  solution->count = search->count;
  /* Below zero the mechanism moves on without live load. */
  solution->outcome =
    least->multiplier < 0 ? QN_OUTCOME_DEAD_LOAD_UNSTABLE : QN_OUTCOME_COLLAPSE;
}

static void
search_clear (Search *search)
{
  qn_limit_problem_clear (&search->limit);
  free (search->forces);
  for (int32_t i = 0; i < QN_LIMIT_STARTS; i++) {
    free (search->found[i].forces);
    free (search->found[i].velocities);
  }
}

/* From the effort of the solution on. `forces` of pairs and then ties, at a multiplier: what a collapse is sought
 * from; NULL: from rest. */
static QnStatus
search_init (Search *search, const double *forces, double multiplier,
             QnProgressFunc progress, void *user_data, QnDiag *diag)
{
  QnLimitProblem *limit = &search->limit;
  QnStatus status =
    qn_limit_problem_init (limit, search->model, search->contacts, true, diag);

  if (status)
    return status;
  int32_t count = forces != NULL ? 2 * limit->ip.cell_count : 0;
  search->forces = qn_alloc ((size_t) count, sizeof (double));
  if (search->forces == NULL)
    return qn_diag_no_memory (diag);
  for (int32_t i = 0; i < count; i++)
    search->forces[i] = forces[2 * limit->cell_pairs[i / 2] + i % 2] / limit->force_unit;
  search->multiplier = multiplier / qn_limit_problem_multiplier (limit, 1);
  limit->engine.holds_flows = !search->elastic;
  limit->engine.effort = search->solution->effort;
  limit->engine.progress = progress;
  limit->engine.user_data = user_data;
  return QN_OK;
}

QnStatus
qn_limit_non_associative (const QnModel *model, const QnContacts *contacts, double known,
                          QnProgressFunc progress, void *user_data,
                          QnLimitSolution *solution, QnDiag *diag)
{
  Search search = {
    .model = model, .contacts = contacts, .known = known, .solution = solution
  };
  QnStatus status =
    qn_limit_associative (model, contacts, progress, user_data, solution, diag);

  if (status || solution->outcome != QN_OUTCOME_COLLAPSE)
    return status;
  status = search_init (&search, NULL, 0, progress, user_data, diag);
  if (!status)
    status = seek_all (&search, diag);
  conclude (&search);
  search_clear (&search);
  if (status)
    qn_limit_solution_clear (solution);
  return status;
}

QnStatus
qn_limit_go_on (const QnModel *model, const QnContacts *contacts, const double *forces,
                double multiplier, QnProgressFunc progress, void *user_data,
                QnLimitSolution *solution)
{
  Search search = { .model = model,
                    .contacts = contacts,
                    .elastic = true,
                    .known = INFINITY,
                    .solution = solution };

  *solution = (QnLimitSolution){ .associative = INFINITY, .effort = solution->effort };
  QnStatus status = search_init (&search, forces, multiplier, progress, user_data, NULL);

  for (size_t p = 0; p < contacts->pair_count; p++) {
    QnPairSprings springs = qn_contacts_pair_springs (model, contacts, p);
    double k[2];
    qn_pair_elastic_stiffness (&springs, k);
    search.flexibility += 1 / (k[0] * (double) contacts->pair_count);
  }
  if (!status)
    status = seek_all (&search, NULL);
  conclude (&search);
  search_clear (&search);
  if (status)
    qn_limit_solution_clear (solution);
  return status;
}

QnStatus
qn_limit_find_mechanism (const QnModel *model, const QnContacts *contacts,
                         const QnPairResult *pairs, double multiplier,
                         QnProgressFunc progress, void *user_data, double **velocities)
{
  QnLimitSolution solution;
  QnLimitProblem limit;
  QnStatus status = qn_limit_problem_init (&limit, model, contacts, true, NULL);

  *velocities = NULL;
  if (status)
    return status;
  for (int32_t c = 0; c < limit.ip.cell_count; c++) {
    const QnIpCell *cell = &limit.ip.cells[c];
    if ((size_t) limit.cell_pairs[c] >= contacts->pair_count)
      continue; /* ties flow as they are strong */
    double normal = pairs[limit.cell_pairs[c]].normal_force / limit.force_unit;
    for (int32_t i = 0; i < cell->bound_count; i++) {
      QnIpBound *bound = &limit.ip.bounds[cell->first_bound + i];
      double slope = bound->opening + LEAST_SLOPE * (bound->normal - bound->opening);
      bound->limit += (slope - bound->normal) * normal;
      bound->normal = bound->opening = slope;
    }
  }
  limit.engine.progress = progress;
  limit.engine.user_data = user_data;
  status = qn_limit_solve (&limit, false, &solution, NULL);
  if (!status && solution.outcome == QN_OUTCOME_COLLAPSE
      && solution.lower_bound - multiplier
           <= MECHANISM_GAP * fabs (solution.lower_bound)) {
    *velocities = solution.velocities;
    solution.velocities = NULL;
  }
  qn_limit_solution_clear (&solution);
  qn_limit_problem_clear (&limit);
  return status;
}
