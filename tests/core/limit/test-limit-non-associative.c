#include "core/limit/limit.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static QnLimitInterval
solve (QnModel *model)
{
  g_auto (QnContacts) contacts;
  QnLimitInterval interval;

  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_non_associative (model, &contacts, NULL, NULL, &interval, NULL), ==, QN_OK);
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
 * there; the least fixed point lies within one percent of them, and none above the
 * associative bound. */
static void
test_published (void)
{
  for (int number = 1; number <= 5; number++) {
    const TestWall *wall = &test_walls[number - 1];
    QnModel model;
    size_t pairs = 2 * wall->faces;

    test_model_init_wall (&model, number, 0);
    QnLimitInterval interval = solve (&model);
    g_assert_cmpint (interval.solution.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpint (interval.count, >=, 2);
    g_assert_cmpfloat_with_epsilon (interval.associative, wall->associative, 1e-6);
    g_assert_cmpfloat_with_epsilon (interval.lowest, wall->non_associative,
                                    0.01 * wall->non_associative);
    g_assert_cmpfloat (interval.highest, <=, wall->associative * (1 + 1e-6));
    g_assert_cmpfloat (interval.lowest, ==, interval.solution.lower_bound);
    g_assert_cmpfloat (excess (&interval.solution, pairs, 0.65), <, 2e-3);
    for (int32_t i = 0; i < interval.count; i++) {
      g_assert_true (interval.points[i].settled);
      g_assert_cmpfloat (interval.points[i].multiplier, >=, interval.lowest);
      g_assert_cmpfloat (interval.points[i].multiplier, <=, interval.highest);
    }
    qn_limit_interval_clear (&interval);
  }
}

/* With dilatancy = friction there is one fixed point: the associative value. */
static void
test_associative_law (void)
{
  QnModel model;

  test_model_init_wall (&model, 3, 0.65);
  QnLimitInterval interval = solve (&model);
  g_assert_cmpint (interval.solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lowest, test_walls[2].associative, 2e-3);
  g_assert_cmpfloat_with_epsilon (interval.highest, test_walls[2].associative, 2e-3);
  qn_limit_interval_clear (&interval);
}

/* For a single block there is no difference. */
static void
test_block (void)
{
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  QnLimitInterval interval = solve (&model);
  g_assert_cmpint (interval.solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (interval.lowest, 0.65, 1e-3);
  g_assert_cmpfloat_with_epsilon (interval.highest, 0.65, 1e-3);
  /* It slides without rising: the mechanism obeys the law's dilatancy, 0. */
  const double *v = interval.solution.velocities + 3;
  g_assert_cmpfloat (v[0], >, 0);
  g_assert_cmpfloat (fabs (v[1]), <, 5e-3 * v[0]);
  qn_limit_interval_clear (&interval);
}

static void
test_dead_load (void)
{
  QnModel model;

  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 1, 1);
  test_model_add_rectangle (&model, "block", 0.6, 0, 1, 1);
  test_model_add_weight_loads (&model, 1);
  QnLimitInterval interval = solve (&model);
  g_assert_cmpint (interval.solution.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  g_assert_cmpint (interval.count, ==, 0);
  qn_limit_interval_clear (&interval);
}

QN_TESTS
{
  g_test_add_func ("/limit-non-associative/published", test_published);
  g_test_add_func ("/limit-non-associative/associative-law", test_associative_law);
  g_test_add_func ("/limit-non-associative/block", test_block);
  g_test_add_func ("/limit-non-associative/dead-load", test_dead_load);
}
