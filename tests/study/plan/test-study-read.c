/* Study files: what they say, and where they are wrong. */
#include "study/fixture.h"

#include "io/text/io-error.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

#define PLAN "{ \"kind\": \"monte-carlo\", \"count\": 10 }"

static char *
replace (const char *text, const char *from, const char *to)
{
  const char *found = strstr (text, from);
  g_assert_nonnull (found);
  g_autofree char *head = g_strndup (text, (gsize) (found - text));
  return g_strconcat (head, to, found + strlen (from), NULL);
}

static void
test_sound (void)
{
  g_auto (QnStudy) study;
  fixture_study (&study, "{ \"kind\": \"latin-hypercube\", \"count\": 100, \"seed\": 7 }",
                 ", \"correlation\": [[\"friction\", \"weight\", -0.3]]");
  g_assert_cmpint (study.run, ==, QN_STUDY_SOLVE);
  g_assert_cmpuint (study.parameters->len, ==, 2);
  g_assert_cmpstr (qn_study_parameter (&study, 0)->paths[0], ==, "laws[0].friction");
  g_assert_cmpuint (study.seed, ==, 7);
  g_assert_cmpuint (qn_study_case_count (&study), ==, 100);
  g_assert_cmpfloat (study.correlation[1], ==, -0.3);
  g_assert_cmpuint (study.outputs->len, ==, 2);
  g_assert_cmpuint (study.warnings->len, ==, 0);
  g_assert_false (isnan (qn_study_parameter (&study, 0)->base));
}

/* What bounds the collapse multiplier is not called by its name, whoever asks for it. */
static void
test_bound_is_named (void)
{
  static const struct {
    const char *run, *flow;
    QnStudyOutput output;
  } cases[] = {
    { "solve", "non-associative", QN_STUDY_COLLAPSE_MULTIPLIER },
    { "limit", "associative", QN_STUDY_ASSOCIATIVE_MULTIPLIER },
    { "limit", "non-associative", QN_STUDY_COLLAPSE_MULTIPLIER },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    test_autoscratch char *folder = test_scratch_new ();
    g_autofree char *example =
      g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "01-sliding-block.quoin", NULL);
    g_autofree char *flow =
      g_strdup_printf ("\"analysis\": { \"flow\": \"%s\",", cases[i].flow);
    g_autofree char *sound = fixture_study_text (PLAN, "");
    g_autofree char *run = g_strdup_printf ("\"run\": \"%s\"", cases[i].run);
    g_autofree char *text = replace (sound, "\"run\": \"solve\"", run);
    g_autoptr (GError) error = NULL;
    g_auto (QnStudy) study;
    g_autofree char *given = NULL;
    g_assert_true (g_file_get_contents (example, &given, NULL, &error));
    g_autofree char *project = replace (given, "\"analysis\": {", flow);
    g_autofree char *model = g_build_filename (folder, "m.quoin", NULL);
    g_autofree char *path = g_build_filename (folder, "s.quoin-study", NULL);
    g_assert_true (g_file_set_contents (model, project, -1, NULL));
    g_assert_true (g_file_set_contents (path, text, -1, NULL));
    g_assert_true (qn_study_read (path, model, &study, &error));
    g_assert_no_error (error);
    g_assert_cmpint (qn_study_output (&study, 0), ==, cases[i].output);
    g_assert_cmpuint (study.warnings->len, ==, i == 1 ? 1 : 0);
  }
}

static void
expect_error_in (const char *more, const char *from, const char *to, const char *place,
                 const char *message)
{
  g_autofree char *sound = fixture_study_text (PLAN, more);
  g_autofree char *text = replace (sound, from, to);
  g_autoptr (GError) error = NULL;
  QnStudy study;
  test_autoscratch char *folder = test_scratch_new ();
  g_assert_false (fixture_read (folder, text, &study, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  if (strstr (error->message, place) == NULL || strstr (error->message, message) == NULL)
    g_test_fail_printf ("'%s' lacks '%s' or '%s'", error->message, place, message);
}

static void
expect_error (const char *from, const char *to, const char *place, const char *message)
{
  expect_error_in (", \"correlation\": []", from, to, place, message);
}

static void
test_bad_input (void)
{
  expect_error ("quoin-study\",", "quoin\",",
                "s.quoin-study:1:13: format: ", "not a study");
  expect_error ("\"version\": 1", "\"version\": 2", ":1:39: version: ", "version 1");
  expect_error ("\"run\":", "\"parmeters\": [], \"run\":", "parmeters: ",
                "unknown key; the nearest known one is \"parameters\"");
  expect_error ("\"uniform\",", "\"uniform\", \"maxx\": 1,",
                "parameters[0].distribution.maxx: ", "unknown key");
  expect_error ("\"solve\"", "\"guess\"", "run: ", "solve, limit, modal, dynamic");
  expect_error ("\"solve\"", "\"dynamic\"", ":2:", "time_step");
  expect_error ("laws[0].friction", "laws[3].friction",
                ":4:35: parameters[0].path: ", "no such place");
  expect_error ("laws[0].friction", "laws[0].frictoin", "parameters[0].path: ",
                "laws[0].frictoin: unknown key; the nearest known one is \"friction\"");
  expect_error ("laws[0].friction", "laws[0].name",
                "parameters[0].path: ", "no number stands at");
  expect_error ("laws[0].friction", "laws[0", "parameters[0].path: ", "no number stands");
  expect_error ("blocks[1].unit_weight", "laws[0].friction",
                ":7:33: parameters[1].path: ", "laws[0].friction varies already");
  expect_error ("\"blocks[1].unit_weight\"", "[\"gravity\", \"gravity\"]",
                "parameters[1].path[1]: ", "gravity varies already");
  expect_error ("\"uniform\"", "\"gauss\"",
                "parameters[0].distribution.kind: ", "normal");
  expect_error ("\"max\": 0.8", "\"max\": 0.1",
                "parameters[0].distribution: ", "min must be less than max");
  expect_error ("\"uniform\",", "\"normal\", \"mean\": 9, \"deviation\": 0.1,",
                "parameters[0].distribution: ", "no value lies between");
  expect_error ("\"uniform\",", "\"normal\", \"mean\": 9,",
                "parameters[0].distribution: ", "either cov or deviation");
  expect_error ("\"uniform\",", "\"lognormal\", \"mean\": -1, \"cov\": 0.1,",
                "parameters[0].distribution.mean: ", "positive");
  expect_error ("\"uniform\",", "\"weibull\", \"scale\": 1, \"shape\": 0,",
                "parameters[0].distribution.shape: ", "positive");
  expect_error ("\"uniform\",", "\"triangular\", \"mode\": 3,",
                "parameters[0].distribution: ", "mode");
  expect_error ("[10000, 20000, 3]", "[10000, 20000, 1]",
                "parameters[1].range: ", "at least 2 values");
  expect_error ("\"range\": [10000, 20000, 3]", "\"values\": []",
                "parameters[1].values: ", "at least one number");
  expect_error ("\"range\"", "\"values\": [1], \"range\"",
                ":7:5: parameters[1]: ", "expected one of");
  expect_error ("\"weight\"", "\"friction\"", "parameters[1].name: ", "used twice");
  expect_error ("\"weight\"", "\"seconds\"", "parameters[1].name: ", "another column");
  expect_error ("\"count\": 10", "\"count\": 0", "plan.count: ", "");
  expect_error ("\"count\": 10", "\"count\": 1000000000", "plan.count: ", "");
  expect_error ("\"count\": 10", "\"count\": 10, \"seed\": -1", "plan.seed: ", "");
  expect_error ("monte-carlo\", \"count\": 10", "sobol\", \"count\": 900000",
                "plan: ", "more than 1000000 cases");
  expect_error ("\"correlation\": []",
                "\"cracks\": [{ \"width\": 0, \"blocks\": [1, 2] }]",
                "cracks[0].blocks[0]: ", "expected the name of a block");
  expect_error ("\"correlation\": []", "\"limits\": { \"seconds\": 0 }",
                "limits.seconds: ", "positive");
  expect_error ("\"correlation\": []", "\"limits\": { \"factorizations\": 0.5 }",
                "limits.factorizations: ", "");
  expect_error ("\"mechanism_kind\"", "\"time_of_collapse\"",
                "outputs[1]: ", "no such output");
  expect_error ("\"levels\": 3", "\"levels\": 0", "parameters[0].levels: ", "");
  expect_error ("\"mechanism_kind\"", "\"frequency_1\"",
                "outputs[1]: ", "no such output");
  expect_error ("\"mechanism_kind\"", "\"collapse_multiplier\"", "outputs[1]: ", "twice");
  expect_error ("\"correlation\": []", "\"correlation\": [[\"friction\", \"x\", 0.1]]",
                "correlation[0][1]: ", "no parameter has this name");
  expect_error ("\"correlation\": []",
                "\"correlation\": [[\"friction\", \"weight\", 1.5]]",
                "correlation[0][2]: ", "between -1 and 1");
}

/* A hundred parameters are read, to where the first is wrong; of one more, or none, the number is told. */
static void
test_most_parameters (void)
{
  static const struct {
    gsize count;
    const char *place, *message;
  } cases[] = { { 0, "parameters: ", "expected 1 to 100 parameters" },
                { 100, "parameters[0]", "" },
                { 101, "parameters: ", "expected 1 to 100 parameters" } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autoptr (GString) list = g_string_new ("\"parameters\": [");
    for (gsize k = 0; k < cases[i].count; k++)
      g_string_append (list, k == 0 ? "{}" : ", {}");
    g_string_append (list, "], \"plan\": " PLAN " }");
    g_autofree char *sound = fixture_study_text (PLAN, "");
    expect_error_in ("", strstr (sound, "\"parameters\""), list->str, cases[i].place,
                     cases[i].message);
  }
}

/* No three variables are all opposed to each other. */
static void
test_impossible_correlation (void)
{
  expect_error_in (
    ", \"correlation\": [[\"friction\", \"weight\", -0.9], "
    "[\"friction\", \"third\", -0.9], [\"weight\", \"third\", -0.9]]",
    "[10000, 20000, 3] }",
    "[10000, 20000, 3] }, { \"name\": \"third\", \"path\": \"laws[0].kn\", "
    "\"values\": [1e7, 2e7] }",
    "correlation: ", "not positive definite");
}

static void
test_missing_model (void)
{
  g_autofree char *sound = fixture_study_text (PLAN, "");
  g_autofree char *text = replace (sound, "01-sliding", "99-missing");
  g_autoptr (GError) error = NULL;
  QnStudy study;
  test_autoscratch char *folder = test_scratch_new ();
  g_assert_false (fixture_read (folder, text, &study, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
}

QN_TESTS
{
  g_test_add_func ("/study/read/sound", test_sound);
  g_test_add_func ("/study/read/bad-input", test_bad_input);
  g_test_add_func ("/study/read/most-parameters", test_most_parameters);
  g_test_add_func ("/study/read/bound-is-named", test_bound_is_named);
  g_test_add_func ("/study/read/impossible-correlation", test_impossible_correlation);
  g_test_add_func ("/study/read/missing-model", test_missing_model);
}
