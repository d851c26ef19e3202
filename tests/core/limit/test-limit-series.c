#include "core/limit/limit-series.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* What a case changes. */
typedef struct Change {
  double friction, cohesion, weight, gravity;
} Change;

static void
init_case (QnModel *model, QnContacts *contacts, int wall, Change change)
{
  test_model_init_wall (model, wall, 0);
  model->laws[0].friction = change.friction;
  model->laws[0].cohesion = change.cohesion;
  for (size_t b = 0; b < model->block_count; b += 2)
    model->blocks[b].unit_weight *= change.weight;
  for (size_t i = 0; i < model->dead_load_count; i++)
    model->dead_loads[i].vector =
      qn_vec2_scale (change.gravity, model->dead_loads[i].vector);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, NULL), ==, QN_OK);
}

static QnLimitSolution
solve (QnLimitSeries *series, int wall, Change change)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnLimitSolution solution;

  init_case (&model, &contacts, wall, change);
  g_assert_cmpint (
    series != NULL
      ? qn_limit_series_solve (series, &model, &contacts, NULL, NULL, &solution, NULL)
      : qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
    ==, QN_OK);
  return solution;
}

static void
begin (QnLimitSeries *series, int wall, Change change)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;

  init_case (&model, &contacts, wall, change);
  g_assert_cmpint (qn_limit_series_init (series, &model, &contacts, NULL), ==, QN_OK);
}

static const Change middle = { 0.65, 50, 1, 1 };

static const Change changes[] = {
  { 0.65, 50, 1, 1 },   { 0.3, 50, 1, 1 },    { 1.2, 50, 1, 1 },  { 0.65, 2000, 1, 1 },
  { 0.65, 50, 1.4, 1 }, { 0.65, 50, 0.6, 1 }, { 0.5, 150, 2, 1 }, { 0.65, 50, 1, 2 },
};

/* Every answer is that of an analysis by itself, whatever came before. */
static void
test_same_answers (void)
{
  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++) {
    QnLimitSeries series;

    begin (&series, wall, middle);
    for (size_t i = 0; i < G_N_ELEMENTS (changes); i++) {
      QnLimitSolution expected = solve (NULL, wall, changes[i]);
      QnLimitSolution found = solve (&series, wall, changes[i]);
      g_assert_cmpint (found.outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_cmpint (expected.outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_true (found.lower_bound == expected.lower_bound);
      g_assert_true (found.upper_bound == expected.upper_bound);
      qn_limit_solution_clear (&expected);
      qn_limit_solution_clear (&found);
    }
    qn_limit_series_clear (&series);
  }
}

/* Bit for bit the same in another order. */
static void
test_order_does_not_matter (void)
{
  QnLimitSeries series;
  QnLimitSolution first[G_N_ELEMENTS (changes)];

  begin (&series, 3, middle);
  for (size_t i = 0; i < G_N_ELEMENTS (changes); i++)
    first[i] = solve (&series, 3, changes[i]);
  for (size_t i = G_N_ELEMENTS (changes); i-- > 0;) {
    QnLimitSolution again = solve (&series, 3, changes[i]);
    g_assert_true (again.lower_bound == first[i].lower_bound);
    g_assert_true (again.upper_bound == first[i].upper_bound);
    qn_limit_solution_clear (&again);
    qn_limit_solution_clear (&first[i]);
  }
  qn_limit_series_clear (&series);
}

/* Without weight there is no equilibrium under a dead load that lifts; no cohesion leaves out rows, so
 * that the structure is another. */
static void
test_other_outcomes (void)
{
  static const Change lifted = { 0.65, 50, 1, -1 }, loose = { 0.65, 0, 1, 1 };
  QnLimitSeries series;

  begin (&series, 3, middle);
  QnLimitSolution solution = solve (&series, 3, lifted);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  qn_limit_solution_clear (&solution);
  solution = solve (&series, 3, loose);
  g_assert_cmpfloat_with_epsilon (solution.upper_bound, test_walls[2].associative, 1e-6);
  qn_limit_solution_clear (&solution);
  solution = solve (&series, 1, loose);
  g_assert_cmpfloat_with_epsilon (solution.upper_bound, test_walls[0].associative, 1e-6);
  qn_limit_solution_clear (&solution);
  qn_limit_series_clear (&series);

  begin (&series, 3, lifted);
  solution = solve (&series, 3, middle);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  qn_limit_solution_clear (&solution);
  qn_limit_series_clear (&series);
}

QN_TESTS
{
  g_test_add_func ("/core/limit-series/same-answers", test_same_answers);
  g_test_add_func ("/core/limit-series/order", test_order_does_not_matter);
  g_test_add_func ("/core/limit-series/other-outcomes", test_other_outcomes);
}
