/* One case: its outputs are those of the project with these values, whether or not contacts are
 * found anew. */
#include "study/cases/case.h"

#include "core/limit/limit.h"
#include "io/text/number-text.h"
#include "study/fixture.h"

#include <math.h>

#define PLAN "{ \"kind\": \"monte-carlo\", \"count\": 10 }"

static void
test_outputs (void)
{
  QnStudy study;
  QnCaseSolver solver;
  QnCaseResult result;
  const double values[] = { 0.37, 12000 };
  fixture_study (&study, PLAN, "");
  g_assert_true (qn_case_solver_init (&solver, &study, NULL));
  qn_case_solve (&solver, values, NULL, NULL, &result);
  g_assert_false (result.failed);
  g_assert_cmpstr (result.outcome, ==, "collapse");
  g_assert_cmpstr (result.mechanism, ==, "sliding");
  g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER], 0.37,
                                  1e-6);
  g_assert_true (isnan (result.numbers[QN_STUDY_UPPER_BOUND])); /* not asked for */
  qn_case_result_clear (&result);
  qn_case_solver_clear (&solver);
  qn_study_clear (&study);
}

/* A value that the project does not allow is a failed case that says which. */
static void
test_failed (void)
{
  QnStudy study;
  QnCaseSolver solver;
  QnCaseResult result;
  const double values[] = { 0.4, -1 };
  fixture_study (&study, PLAN, "");
  g_assert_true (qn_case_solver_init (&solver, &study, NULL));
  qn_case_solve (&solver, values, NULL, NULL, &result);
  g_assert_true (result.failed);
  g_assert_nonnull (strstr (result.reason, "blocks[1].unit_weight"));
  qn_case_result_clear (&result);
  qn_case_solver_clear (&solver);
  qn_study_clear (&study);
}

/* The width of an opening moves blocks: what the case finds is what the project says afresh. */
static void
test_geometry (void)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *model =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "12-facade.quoin", NULL);
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s\", \"run\": "
    "\"limit\", "
    "\"parameters\": [ { \"name\": \"width\", \"path\": "
    "\"masonry[0].openings[0].width\", \"values\": [0.8, 1.0] } ], "
    "\"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapse_multiplier\"] }",
    model);
  char *folder = test_scratch_new ();
  QnStudy study;
  fixture_read (folder, text, &study, &error);
  g_assert_no_error (error);
  QnCaseSolver solver;
  g_assert_true (qn_case_solver_init (&solver, &study, NULL));
  for (gsize i = 0; i < 2; i++) {
    double value = qn_parameter_level (qn_study_parameter (&study, 0), i);
    char number[QN_NUMBER_TEXT_SIZE];
    g_autofree char *override =
      g_strconcat ("masonry[0].openings[0].width=", qn_number_text (value, number), NULL);
    const char *overrides[] = { override, NULL };
    QnCaseResult result;
    QnProject project;
    QnContacts contacts;
    QnLimitSolution solution;
    qn_case_solve (&solver, &value, NULL, NULL, &result);
    g_assert_false (result.failed);
    g_assert_true (qn_project_load (model, overrides, &project, NULL));
    g_assert_true (qn_contacts_detect (&project.model, &contacts, NULL) == QN_OK);
    g_assert_true (
      qn_limit_associative (&project.model, &contacts, NULL, NULL, &solution, NULL)
      == QN_OK);
    g_assert_cmpfloat (result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER], ==,
                       solution.lower_bound);
    qn_limit_solution_clear (&solution);
    qn_contacts_clear (&contacts);
    qn_project_clear (&project);
    qn_case_result_clear (&result);
  }
  qn_case_solver_clear (&solver);
  qn_study_clear (&study);
  test_scratch_free (folder);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/study/case/outputs", test_outputs);
  g_test_add_func ("/study/case/failed", test_failed);
  g_test_add_func ("/study/case/geometry", test_geometry);
  return g_test_run ();
}
