/* Loads on their way: which block they stand on, where, and what has not come yet. */
#include "study/cases/moving-load.h"

#include "study/cases/case.h"
#include "study/fixture.h"
#include "support/room.h"

#define MODEL                                                                            \
  "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "   \
  "\"coulomb\", \"kn\": 1e8, \"ks\": 1e8, \"friction\": 0.6 } ], \"blocks\": ["          \
  "{ \"name\": \"base\", \"vertices\": [[0,-1],[2,-1],[2,0],[0,0]], \"thickness\": 1, "  \
  "\"unit_weight\": 1000, \"support\": [true,true,true] },"                              \
  "{ \"name\": \"a\", \"vertices\": [[0,0],[1,0],[1,1],[0,1]], \"thickness\": 1, "       \
  "\"unit_weight\": 1000 },"                                                             \
  "{ \"name\": \"b \\\"2\\\"\", \"vertices\": [[1,0],[2,0],[2,1],[1,1]], "               \
  "\"thickness\": 1, \"unit_weight\": 1000 } ], \"contact\": { \"law\": \"j\" }, "       \
  "\"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0,-1] } ], "         \
  "\"live\": [ { \"kind\": \"force\", \"block\": \"a\", \"value\": [5, 0] }, "           \
  "{ \"kind\": \"force\", \"block\": \"a\", \"value\": [5, 0], \"moment\": 2 } ] } }"

#define STUDY                                                                            \
  "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"m.quoin\", \"run\": "     \
  "\"solve\", \"parameters\": [ { \"name\": \"way\", \"path\": [\"loads.live[0]\", "     \
  "\"loads.live[1]\"], \"offsets\": [0, 0.75], \"along\": [[0.25, 1.5], [1.25, 1.5], "   \
  "[1.25, 0.5]], \"steps\": 5 } ], \"plan\": { \"kind\": \"grid\" }, \"outputs\": "      \
  "[\"collapse_multiplier\"] }"

static void
read_study (const char *folder, const char *text, QnStudy *study, GError **error)
{
  g_autofree char *model = g_build_filename (folder, "m.quoin", NULL);
  g_assert_true (g_file_set_contents (model, MODEL, -1, NULL));
  fixture_read (folder, text, study, error);
}

static void
test_places (void)
{
  static const char *const expected[] = {
    "loads.live[0].block=\"a\" loads.live[0].at=[0.25, 1] "
    "loads.live[1].value=[0, 0] loads.live[1].moment=0",
    "loads.live[0].block=\"a\" loads.live[0].at=[0.75, 1] "
    "loads.live[1].value=[0, 0] loads.live[1].moment=0",
    "loads.live[0].block=\"b \\\"2\\\"\" loads.live[0].at=[1.25, 1] "
    "loads.live[1].block=\"a\" loads.live[1].at=[0.5, 1]",
    "loads.live[0].block=\"b \\\"2\\\"\" loads.live[0].at=[1.25, 1] "
    "loads.live[1].block=\"a\" loads.live[1].at=[1, 1]",
    "loads.live[0].block=\"b \\\"2\\\"\" loads.live[0].at=[1.25, 0.5] "
    "loads.live[1].block=\"b \\\"2\\\"\" loads.live[1].at=[1.25, 1]",
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autoptr (GError) error = NULL;
  g_auto (QnStudy) study;
  read_study (folder, STUDY, &study, &error);
  g_assert_no_error (error);
  const QnParameter *way = qn_study_parameter (&study, 0);
  g_assert_cmpuint (qn_study_case_count (&study), ==, 5);
  for (gsize i = 0; i < 5; i++) {
    g_autoptr (GPtrArray) overrides = g_ptr_array_new_with_free_func (g_free);
    qn_moving_load_add_overrides (overrides, way, qn_parameter_level (way, i),
                                  &study.project.model);
    g_ptr_array_add (overrides, NULL);
    g_autofree char *text = g_strjoinv (" ", (char **) overrides->pdata);
    g_assert_cmpstr (text, ==, expected[i]);
  }
}

/* A block that is pushed at 1 m turns about its corner: the multiplier is known. */
static void
test_case (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_auto (QnStudy) study;
  g_auto (QnCaseResult) result;
  read_study (folder, STUDY, &study, NULL);
  const double at_end = 2;
  qn_case_solve (&study, &at_end, NULL, NULL, &result);
  g_assert_false (result.failed);
  /* b alone: 1000 N, pushed by 5 N at 0.5 m and 5 N at 1 m with 2 Nm more against it: it slides
   * at 600/10 and turns at 500/(2.5 + 5 - 2). */
  g_assert_cmpfloat_with_epsilon (result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER], 60, 1e-6);
}

static void
expect_error (const char *from, const char *to, const char *place, const char *message)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autoptr (GError) error = NULL;
  QnStudy study;
  g_auto (GStrv) parts = g_strsplit (STUDY, from, 2);
  g_autofree char *text = g_strjoinv (to, parts);
  g_assert_cmpuint (g_strv_length (parts), ==, 2);
  read_study (folder, text, &study, &error);
  g_assert_nonnull (error);
  g_assert_nonnull (strstr (error->message, place));
  g_assert_nonnull (strstr (error->message, message));
}

static void
test_bad_input (void)
{
  expect_error ("[1.25, 1.5], [1.25, 0.5]", "[0.25, 1.5]",
                "parameters[0].along: ", "two different points");
  expect_error ("[0.25, 1.5]", "[0.25]", "parameters[0].along[0]: ", "");
  expect_error ("\"steps\": 5", "\"steps\": 1", "parameters[0].along: ", "2 steps");
  expect_error (", \"steps\": 5", "", "steps", "required");
  expect_error ("[0, 0.75]", "[0]", "parameters[0].offsets: ", "every path");
  expect_error ("[0, 0.75]", "[0, -1]", "parameters[0].offsets[1]: ", "");
  expect_error ("\"loads.live[1]\"", "\"loads.live[2]\"",
                "parameters[0].path: ", "no force on a block stands at loads.live[2]");
  expect_error ("\"loads.live[1]\"", "\"loads.dead[0]\"",
                "parameters[0].path: ", "no force on a block");
  expect_error ("\"grid\"", "\"one-at-a-time\"", "parameters[0]: ", "gives none here");
}

QN_TESTS
{
  g_test_add_func ("/study/moving-load/places", test_places);
  g_test_add_func ("/study/moving-load/case", test_case);
  g_test_add_func ("/study/moving-load/bad-input", test_bad_input);
}
