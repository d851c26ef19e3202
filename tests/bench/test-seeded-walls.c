#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "io/project/project.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include "support/walls.h"

#include <math.h>

/* The same number, the same wall; another number, another one. */
static void
test_same_seed (void)
{
  for (guint32 seed = 1; seed <= 6; seed++) {
    char *texts[3];
    for (guint32 i = 0; i < 3; i++) {
      QnProject project = { 0 };
      test_wall_draw_sized (&project.model, i < 2 ? seed : seed + 6, 100, 300);
      texts[i] = qn_project_to_text (&project, NULL);
      qn_model_clear (&project.model);
    }
    g_assert_cmpstr (texts[0], ==, texts[1]);
    g_assert_cmpstr (texts[0], !=, texts[2]);
    for (guint32 i = 0; i < 3; i++)
      g_free (texts[i]);
  }
}

/* Sizes are within the range, and spread over it. */
static void
test_sizes (void)
{
  double lowest = INFINITY, highest = 0;
  for (guint32 seed = 1; seed <= 12; seed++) {
    g_auto (QnModel) model;
    test_wall_draw_sized (&model, seed, 200, 1000);
    double blocks = (double) model.block_count;
    g_assert_cmpfloat (blocks, >, 0.9 * 200);
    g_assert_cmpfloat (blocks, <, 1.1 * 1000);
    lowest = fmin (lowest, blocks);
    highest = fmax (highest, blocks);
  }
  g_assert_cmpfloat (lowest, <, 300);
  g_assert_cmpfloat (highest, >, 700);
}

/* What is written reads back as the same wall. */
static void
test_saved (void)
{
  for (guint32 seed = 1; seed <= 6; seed++) {
    g_auto (QnModel) model;
    g_auto (QnProject) again;
    g_autoptr (GError) error = NULL;
    gsize length;
    test_wall_draw_sized (&model, seed, 60, 120);
    const QnProject project = { .model = model };
    g_autofree char *text = qn_project_to_text (&project, &length);
    g_assert_true (qn_project_parse (text, length, "wall.quoin", NULL, &again, &error));
    g_assert_no_error (error);
    g_assert_cmpuint (again.warnings->len, ==, 0);
    g_assert_cmpuint (again.model.block_count, ==, model.block_count);
    g_assert_cmpfloat (again.model.laws[0].friction, ==, model.laws[0].friction);
  }
}

/* Sound, standing under its own weight, and falling under some part of it sideways. */
static void
test_stands (void)
{
  for (guint32 seed = 1; seed <= 36; seed++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnLimitSolution) solution;
    test_wall_draw_sized (&model, seed, 60, 400);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (
      qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL), ==, QN_OK);
    if (solution.outcome != QN_OUTCOME_COLLAPSE || !(solution.lower_bound > 0.005))
      g_error ("seed %u: %s at %g", seed, qn_outcome_names[solution.outcome],
               solution.lower_bound);
  }
}

/* Its dead load makes this one slide by ten thousand elastic displacements before it rests. */
static void
test_creeps (void)
{
  QnModel model;
  QnContacts contacts;
  QnResult result;

  if (!g_test_slow ()) {
    g_test_skip ("takes a quarter of a minute");
    return;
  }
  test_wall_draw_sized (&model, 20, 800, 5000);
  model.analysis.max_multiplier = 1e-4;
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat (result.steps[0].residual, <, 1e-8);
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

static void
solve (QnModel *model, QnProcedure procedure, int increments, QnResult *result)
{
  g_auto (QnContacts) contacts;
  model->analysis.procedure = procedure;
  model->analysis.increments = increments;
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
  g_assert_cmpint (result->outcome, ==, QN_OUTCOME_COLLAPSE);
}

/* Walls on which increments of the load alone jump to equilibria that the structure does not reach
 * while it moves, up to a third above its collapse. Load control answers with the least, whatever its
 * increments, and ends with that equilibrium. */
static void
test_least_collapse (void)
{
  static const guint32 seeds[] = { 9, 21, 26, 29 };
  static const int increments[] = { 10, 14, 100 };

  for (gsize i = 0; i < G_N_ELEMENTS (seeds); i++) {
    g_auto (QnModel) model;
    g_auto (QnResult) by_work;
    test_wall_draw_sized (&model, seeds[i], 20, 80);
    solve (&model, QN_PROCEDURE_WORK, 10, &by_work);
    for (gsize k = 0; k < G_N_ELEMENTS (increments); k++) {
      g_auto (QnResult) result;
      solve (&model, QN_PROCEDURE_LOAD, increments[k], &result);
      const QnStep *last = &result.steps[result.step_count - 1];
      g_assert_cmpfloat_with_epsilon (result.collapse_multiplier,
                                      by_work.collapse_multiplier,
                                      5e-3 * by_work.collapse_multiplier);
      g_assert_cmpint (last->event, ==, QN_EVENT_COLLAPSE);
      g_assert_cmpfloat (last->multiplier, ==, result.collapse_multiplier);
      g_assert_cmpfloat (result.first_limit_multiplier, <=, result.collapse_multiplier);
      g_assert_nonnull (result.mechanism);
    }
  }
}

/* A large running bond whose first start is lost: it is found from where that one ended. */
static void
test_found_directly (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnLimitSolution interval;

  test_wall_draw_sized (&model, 207, 20, 600);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_non_associative (&model, &contacts, INFINITY, NULL, NULL, &interval, NULL),
    ==, QN_OK);
  g_assert_cmpint (interval.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (interval.lower_bound, >, 0);
  g_assert_cmpfloat (interval.upper_bound, <=, interval.associative);
  qn_limit_solution_clear (&interval);
}

/* A collapse found directly below that of the path, which passes it by, stands in the solutions. */
static void
test_lower_collapse (void)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  QnProcedure found_by;
  double least, bound;

  test_wall_draw_sized (&model, 251, 20, 600);
  solve (&model, QN_PROCEDURE_LOAD, 10, &result);
  qn_result_collapse_interval (&result, &least, &found_by, &bound);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (found_by, ==, QN_PROCEDURE_LIMIT);
  g_assert_cmpint (result.solution_count, ==, 2);
  g_assert_cmpfloat (least, <, result.collapse_multiplier);
  g_assert_cmpfloat (result.collapse_multiplier, <, bound);
}

QN_TESTS
{
  g_test_add_func ("/bench/seeded-walls/same-seed", test_same_seed);
  g_test_add_func ("/bench/seeded-walls/sizes", test_sizes);
  g_test_add_func ("/bench/seeded-walls/saved", test_saved);
  g_test_add_func ("/bench/seeded-walls/stands", test_stands);
  g_test_add_func ("/bench/seeded-walls/least-collapse", test_least_collapse);
  g_test_add_func ("/bench/seeded-walls/found-directly", test_found_directly);
  g_test_add_func ("/bench/seeded-walls/lower-collapse", test_lower_collapse);
  g_test_add_func ("/bench/seeded-walls/creeps", test_creeps);
}
