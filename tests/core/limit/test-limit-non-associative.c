#include "core/limit/limit.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

static QnLimitSolution
solve (QnModel *model)
{
  g_auto (QnContacts) contacts;
  QnLimitSolution interval;

  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_non_associative (model, &contacts, INFINITY, NULL, NULL, &interval, NULL),
    ==, QN_OK);
  qn_model_clear (model);
  return interval;
}

/* Largest shear beyond the true strength, relative to the largest force. */
static double
excess (const QnLimitSolution *solution, size_t pairs, double friction)
{
  double worst = 0, largest = 0;

  for (size_t p = 0; p < pairs; p++) {
    const double *f = solution->forces + 2 * p;
    largest = fmax (largest, -f[0]);
    worst = fmax (worst, fabs (f[1]) + friction * f[0]);
  }
  return worst / largest;
}

/* Published values of the walls (limit analysis of 2001 and 2006), rounded to three digits
 * there; the collapse lies within one percent of them, below the associative bound, and is found
 * with few factorisations. */
static void
test_published (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    const TestWall *wall = &test_walls[number - 1];
    QnModel model;
    size_t pairs = 2 * wall->faces;

    test_model_init_wall (&model, number, 0);
    QnLimitSolution interval = solve (&model);
    g_test_message ("wall %d: %.6f, %d factorisations", number, interval.lower_bound,
                    interval.effort.factorizations);
    g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (interval.associative, wall->associative, 1e-6);
    g_assert_cmpfloat_with_epsilon (interval.lower_bound, wall->non_associative,
                                    1e-2 * wall->non_associative);
    g_assert_cmpfloat (interval.upper_bound, <=, wall->associative * (1 + 1e-6));
    g_assert_cmpfloat (excess (&interval, pairs, 0.65), <, 1e-7);
    g_assert_cmpint (interval.effort.factorizations, <=, 60);
    for (int32_t i = 0; i < interval.count; i++) {
      g_assert_cmpfloat (interval.multipliers[i], >=, interval.lower_bound);
      g_assert_cmpfloat (interval.multipliers[i], <=, interval.upper_bound);
    }
    qn_limit_solution_clear (&interval);
  }
}

static void
rotate (QnModel *model)
{
  test_model_rotate (model, 2.4);
}

static void
renumber (QnModel *model)
{
  test_model_renumber (model, 7);
}

static void
shrink (QnModel *model)
{
  test_model_scale (model, 1e-3);
}

static void
stiffen (QnModel *model)
{
  model->laws[0].kn *= 1e3;
  model->laws[0].ks *= 10;
}

/* Place, numbering, units, the mirror image and stiffness change nothing. */
static void
test_invariance (void)
{
  static void (*const changes[]) (QnModel *) = { rotate, renumber, shrink, stiffen,
                                                 test_model_mirror };

  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    QnModel model;
    test_model_init_wall (&model, number, 0);
    QnLimitSolution plain = solve (&model);
    for (size_t i = 0; i < G_N_ELEMENTS (changes); i++) {
      test_model_init_wall (&model, number, 0);
      changes[i](&model);
      QnLimitSolution changed = solve (&model);
      g_test_message ("wall %d, change %zu: %.6f, %.6f", number, i, changed.lower_bound,
                      plain.lower_bound);
      g_assert_cmpfloat_with_epsilon (changed.lower_bound, plain.lower_bound,
                                      1e-4 * plain.lower_bound);
      qn_limit_solution_clear (&changed);
    }
    qn_limit_solution_clear (&plain);
  }
}

static double
collapse_at (QnLimitProblem *limit, double compliance, const double *start,
             double coupling, double *growth)
{
  QnCollapse collapse;

  g_assert_cmpint (qn_collapse_init (&collapse, &limit->ip, NULL), ==, QN_OK);
  for (int32_t c = 0; c < limit->ip.cell_count; c++)
    limit->ip.cells[c].quadratic[0] = limit->ip.cells[c].quadratic[1] = compliance;
  qn_collapse_start (&collapse, start, 0, 10, coupling);
  g_assert_cmpint (qn_collapse_follow (&collapse, 1e-9, 200, NULL, NULL), ==,
                   QN_OUTCOME_COLLAPSE);
  *growth = collapse.growth;
  double lambda = collapse.ip.at.lambda;
  qn_collapse_clear (&collapse);
  return lambda;
}

/* At a compliance where the multiplier of wall 6 still grows with stiffness, the derivative is that of
 * differences, and another start leads to the same. */
static void
test_growth (void)
{
  const double h = 1e-3, compliance = 2e-4;
  g_auto (QnContacts) contacts;
  QnLimitProblem limit;
  QnModel model;
  double growth, other;

  test_model_init_wall (&model, 6, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_problem_init (&limit, &model, &contacts, true, NULL), ==,
                   QN_OK);
  double lambda = collapse_at (&limit, compliance, NULL, 0.3, &growth);
  double stiffer = collapse_at (&limit, compliance * exp (-h), NULL, 0.3, &other);
  double softer = collapse_at (&limit, compliance * exp (h), NULL, 0.3, &other);
  g_assert_cmpfloat (growth, >, 1e-4);
  g_assert_cmpfloat_with_epsilon ((stiffer - softer) / (2 * h), growth, 1e-2 * growth);
  g_autofree double *start = g_new (double, 2 * (size_t) limit.ip.cell_count);
  for (int32_t c = 0; c < limit.ip.cell_count; c++) {
    start[2 * c] = -1 - c % 7;
    start[2 * c + 1] = 0.1 * (c % 5);
  }
  g_assert_cmpfloat_with_epsilon (collapse_at (&limit, compliance, start, 0.3, &other),
                                  lambda, 1e-6 * lambda);
  qn_limit_problem_clear (&limit);
  qn_model_clear (&model);
}

/* What an iteration leaves out of the strength of joints is taken off before the end: wall 3 with joints so
 * stiff that iterations leave much out, with different couplings. */
static void
test_coupling (void)
{
  static const double couplings[] = { 0.3, 0.5, 0.7 };
  g_auto (QnContacts) contacts;
  QnLimitProblem limit;
  QnModel model;
  double growth;

  test_model_init_wall (&model, 3, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_problem_init (&limit, &model, &contacts, true, NULL), ==,
                   QN_OK);
  for (size_t i = 0; i < G_N_ELEMENTS (couplings); i++) {
    double lambda = collapse_at (&limit, 5e-5, NULL, couplings[i], &growth);
    g_test_message ("coupling %g: %.6f", couplings[i], lambda);
    g_assert_cmpfloat_with_epsilon (qn_limit_problem_multiplier (&limit, lambda),
                                    0.355817, 1e-5);
  }
  qn_limit_problem_clear (&limit);
  qn_model_clear (&model);
}

static void
check_masonry (int32_t length, int32_t courses, int32_t openings)
{
  QnModel model;

  test_bond_init (&model, TEST_UNIT, length, courses, openings, 7);
  QnLimitSolution interval = solve (&model);
  g_test_message ("%.5f of %.5f, %d factorisations", interval.lower_bound,
                  interval.associative, interval.effort.factorizations);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (interval.lower_bound, >, 0.9 * interval.associative);
  g_assert_cmpfloat (interval.lower_bound, <, interval.associative);
  g_assert_cmpint (interval.effort.factorizations, <=, 150);
  qn_limit_solution_clear (&interval);
}

/* A running bond that takes the path some hundred factorisations. */
static void
test_running_bond (void)
{
  check_masonry (10, 20, 0);
}

/* Joints open on the way in which flows of both directions of slip may grow without end. */
static void
test_facade (void)
{
  check_masonry (11, 26, 5);
}

/* With dilatancy = friction there is one fixed point: the associative value. */
static void
test_associative_law (void)
{
  QnModel model;

  test_model_init_wall (&model, 3, 0.65);
  QnLimitSolution interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lower_bound, test_walls[2].associative, 1e-4);
  g_assert_cmpfloat_with_epsilon (interval.upper_bound, test_walls[2].associative, 1e-4);
  qn_limit_solution_clear (&interval);
}

/* For a single block there is no difference. */
static void
test_block (void)
{
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  QnLimitSolution interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lower_bound, 0.65, 1e-4);
  g_assert_cmpfloat_with_epsilon (interval.upper_bound, 0.65, 1e-4);
  /* It slides without rising: the mechanism obeys the law's dilatancy, 0. */
  const double *v = interval.velocities + 3;
  g_assert_cmpfloat (v[0], >, 0);
  g_assert_cmpfloat (fabs (v[1]), <, 5e-3 * v[0]);
  qn_limit_solution_clear (&interval);
}

static void
test_dead_load (void)
{
  QnModel model;

  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 1, 1);
  test_model_add_rectangle (&model, "block", 0.6, 0, 1, 1);
  test_model_add_weight_loads (&model, 1);
  QnLimitSolution interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  g_assert_cmpint (interval.count, ==, 0);
  qn_limit_solution_clear (&interval);
}

/* A block between walls that press on it slides against cohesion, friction and the caps of its joints. */
static void
test_strengths (void)
{
  QnModel model;

  /* It slides at friction and cohesion: 0.65 + 4 kN / 20 kN, whatever the tension. */
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].cohesion = 2e3;
  model.laws[0].tension = 1e3;
  QnLimitSolution interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lower_bound, 0.85, 1e-4);
  qn_limit_solution_clear (&interval);

  /* A slender one turns: W b / 2 and the tension of one pair, over W h / 2. */
  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].cohesion = 1e5;
  model.laws[0].tension = 1e4;
  interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lower_bound, (20 + 10) / 80.0, 1e-4);
  qn_limit_solution_clear (&interval);
}

/* Bonded joints carry forces a hundred times those of dry ones, and give as much more: the compliance
 * follows. Such a wall turns as a whole, whatever the dilatancy. */
static void
test_bonded (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    QnModel model;

    test_model_init_wall (&model, number, 0);
    model.laws[0].cohesion = model.laws[0].tension = 1e6;
    QnLimitSolution interval = solve (&model);
    g_test_message ("wall %d: %.4f of %.4f", number, interval.lower_bound,
                    interval.associative);
    g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat (interval.lower_bound, >, 0.98 * interval.associative);
    qn_limit_solution_clear (&interval);
  }
}

/* Springs of two laws in every joint: the weaker one limits the shear, whichever block it belongs to. */
static void
test_unequal_springs (void)
{
  QnModel model;

  test_model_init_wall (&model, 3, 0);
  test_model_soften_every_other_block (&model, 10);
  model.laws[1].friction = 0.5;
  QnLimitSolution both = solve (&model);
  test_model_init_wall (&model, 3, 0);
  model.laws[0].friction = 0.5;
  QnLimitSolution weaker = solve (&model);
  g_assert_cmpint (both.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (both.lower_bound, <=, both.associative);
  g_assert_cmpfloat (both.lower_bound, >=, 0.99 * weaker.lower_bound);
  g_assert_cmpfloat (both.lower_bound, <, test_walls[2].non_associative * 1.01);
  qn_limit_solution_clear (&both);
  qn_limit_solution_clear (&weaker);
}

static void
test_unbounded (void)
{
  QnModel model;

  test_model_init_stack (&model, 2, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, -1);
  QnLimitSolution interval = solve (&model);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_UNBOUNDED);
  qn_limit_solution_clear (&interval);
}

typedef struct Patience {
  int left;
} Patience;

static bool
lose_patience (const QnProgress *progress, void *data)
{
  Patience *patience = data;

  (void) progress;
  return --patience->left > 0;
}

/* Cancelled wherever it is, in the program or on a curve. */
static void
test_cancel (void)
{
  for (int left = 1; left < 45; left += 6) {
    g_auto (QnContacts) contacts;
    Patience patience = { left };
    QnLimitSolution interval;
    QnModel model;

    test_model_init_wall (&model, 6, 0);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_limit_non_associative (&model, &contacts, INFINITY, lose_patience,
                                               &patience, &interval, NULL),
                     ==, QN_OK);
    g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_CANCELLED);
    g_assert_cmpint (patience.left, ==, 0);
    qn_limit_solution_clear (&interval);
    qn_model_clear (&model);
  }
}

/* A live load a thousand times as large is carried a thousandth as often: whether the multiplier still changes with
 * softer joints is told beside the multiplier itself. */
static void
test_larger_load (void)
{
  double lowest[2];
  for (int larger = 0; larger < 2; larger++) {
    QnModel model;
    test_model_init_wall (&model, 6, 0);
    model.live_loads[0].vector.x *= larger ? 1000 : 1;
    QnLimitSolution interval = solve (&model);
    g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
    lowest[larger] = interval.lower_bound;
    qn_limit_solution_clear (&interval);
  }
  g_test_message ("%.8f, times 1000 %.8f", lowest[0], 1000 * lowest[1]);
  g_assert_cmpfloat_with_epsilon (1000 * lowest[1] / lowest[0], 1, 1e-4);
}

QN_TESTS
{
  g_test_add_func ("/limit-non-associative/published", test_published);
  g_test_add_func ("/limit-non-associative/invariance", test_invariance);
  g_test_add_func ("/limit-non-associative/larger-load", test_larger_load);
  g_test_add_func ("/limit-non-associative/growth", test_growth);
  g_test_add_func ("/limit-non-associative/coupling", test_coupling);
  g_test_add_func ("/limit-non-associative/running-bond", test_running_bond);
  g_test_add_func ("/limit-non-associative/facade", test_facade);
  g_test_add_func ("/limit-non-associative/associative-law", test_associative_law);
  g_test_add_func ("/limit-non-associative/block", test_block);
  g_test_add_func ("/limit-non-associative/strengths", test_strengths);
  g_test_add_func ("/limit-non-associative/bonded", test_bonded);
  g_test_add_func ("/limit-non-associative/unequal-springs", test_unequal_springs);
  g_test_add_func ("/limit-non-associative/dead-load", test_dead_load);
  g_test_add_func ("/limit-non-associative/unbounded", test_unbounded);
  g_test_add_func ("/limit-non-associative/cancel", test_cancel);
}
