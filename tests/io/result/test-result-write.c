#include "io/result-fixture.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <locale.h>
#include <string.h>

/* Numbers have a point; the sentence is as the user writes it. */
static void
test_text (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  const char *sign = localeconv ()->decimal_point;
  char *expected = g_strdup_printf (
    "{\n"
    "  \"format\": \"quoin-result\", \"version\": 1,\n"
    "  \"generator\": \"quoin " QN_VERSION "\",\n"
    "  \"model\": \"wall.quoin\",\n"
    "  \"model_sha256\": \"%s\",\n"
    "  \"outcome\": \"collapse\",\n"
    "  \"collapse_multiplier\": 0.2,\n"
    "  \"first_limit_multiplier\": 0.1,\n"
    "  \"events\": [\n"
    "    { \"multiplier\": 0.1, \"kind\": \"snap\", \"displacement_before\": 1e-6, "
    "\"displacement_after\": 2e-6, \"energy\": 0.5, \"blocks\": [1] }],\n"
    "  \"solutions\": [{ \"multiplier\": 0.2, \"found_by\": \"work\", "
    "\"displacement\": 2e-6 }],\n"
    "  \"collapse_interval\": [0.2, 0.25],\n"
    "  \"collapse_interval_ends\": [\"work\", \"associative-bound\"],\n"
    "  \"beyond_linear\": false,\n"
    "  \"beyond_linear_multiplier\": null,\n"
    "  \"reason\": \"Collapse at a load multiplier of 0%s2. Before, at 0%s1, the path "
    "jumps to another equilibrium. Above the collapse multiplier the structure moves on "
    "along its mechanism and does not "
    "come to rest.\",\n"
    "  \"blocks\": [\"base\", \"top\"],\n"
    "  \"steps\": [\n"
    "    { \"multiplier\": 0, \"displacements\": [[0, 0, 0], [0, 0, 0]], \"iterations\": "
    "3, "
    "\"residual\": 1e-12, \"event\": null },\n"
    "    { \"multiplier\": 0.2, \"displacements\": [[0, 0, 0], [1e-6, -2e-6, 3e-9]], "
    "\"iterations\": 4, \"residual\": 3e-10, \"event\": \"collapse\" }],\n"
    "  \"contacts\": [\n"
    "    { \"face\": 0, \"blocks\": [0, 1], \"point\": [1.5, 0], \"normal\": [0, 1], "
    "\"area\": 0.5, \"state\": \"stick\", \"normal_force\": -6000, \"shear_force\": "
    "-1000 },\n"
    "    { \"face\": 0, \"blocks\": [0, 1], \"point\": [0.5, 0], \"normal\": [0, 1], "
    "\"area\": 0.5, \"state\": \"stick\", \"normal_force\": -4000, \"shear_force\": "
    "-1000 }],\n"
    "  \"mechanism\": [[0, 0, 0], [0.8944271909999159, 0.4472135954999579, "
    "-0.8944271909999159]],\n"
    "  \"mechanism_facts\": {\n    \"kind\": \"overturning\",\n    \"bodies\": [\n"
    "      { \"blocks\": [1], \"velocity\": [0.8944271909999159, 0.4472135954999579], "
    "\"rotation\": -0.8944271909999159, \"centre\": [1.5, -0.5] }],\n"
    "    \"joints\": [\n      { \"face\": 0, \"kind\": \"hinge-start\", \"slides\": "
    "true, "
    "\"hinge\": [1.5, 0], \"opening\": [0, 0.8944271909999159], "
    "\"slip\": -0.4472135954999579 }]\n  },\n"
    "  \"timings\": { \"seconds\": 0.012, \"factor_seconds\": 0, \"assembly_seconds\": "
    "0, "
    "\"law_seconds\": 0, \"peak_memory_bytes\": 12345678 },\n"
    "  \"statistics\": { \"seconds\": 0.012, \"factor_seconds\": 0, "
    "\"assembly_seconds\": 0, "
    "\"law_seconds\": 0, \"iterations\": 420, \"factorizations\": 400, "
    "\"peak_memory_bytes\": 12345678 }\n"
    "}\n",
    fixture->project.sha256, sign, sign);
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_cmpstr (text, ==, expected);
  g_free (expected);
}

/* No equilibrium: nothing about contacts, the blocks that fall by their numbers. */
static void
test_unstable (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnResult *result = &fixture->result;
  qn_result_clear (result);
  g_assert_cmpint (qn_result_init (result, 2, 2, NULL), ==, QN_OK);
  result->outcome = QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  result->unstable_blocks = g_malloc (sizeof (QnId));
  result->unstable_blocks[0] = 1;
  result->unstable_count = 1;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_nonnull (strstr (text, "\"outcome\": \"dead-load-unstable\","));
  g_assert_nonnull (strstr (text, "\"collapse_multiplier\": null,"));
  g_assert_nonnull (strstr (text, "\"unstable_blocks\": [1],"));
  g_assert_nonnull (strstr (text, "\"steps\": [],"));
  g_assert_nonnull (strstr (text, "\"contacts\": [],"));
  g_assert_nonnull (strstr (text, "\"mechanism\": null,"));
}

/* What is certain is not mentioned; what is not is said in words too. */
static void
test_uncertain_mechanism (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *certain = result_fixture_dup_text (fixture);
  g_assert_null (strstr (certain, "uncertain"));
  g_assert_null (strstr (certain, "by_work"));
  fixture->result.mechanism_uncertain = fixture->result.mechanism_by_work = true;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_nonnull (strstr (text, "\"mechanism_uncertain\": true,"));
  g_assert_nonnull (strstr (text, "\"mechanism_by_work\": true,"));
  g_assert_nonnull (strstr (text, "How the structure moves further was not determined"));
}

static void
test_overrides (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->project.overrides = g_strsplit ("analysis.snap=stop|title=\"x\"", "|", -1);
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_assert_nonnull (
    strstr (text, "\"overrides\": [\"analysis.snap=stop\", \"title=\\\"x\\\"\"],"));
}

static void
test_disk_full (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_result_file_write ("/dev/full", &fixture->project,
                                        &fixture->contacts, &fixture->result,
                                        QN_DETAIL_FORCES, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_assert_cmpstr (error->message, ==,
                   "/dev/full: cannot be written: No space left on device");
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-write/text", test_text);
  RESULT_FIXTURE_ADD ("/result-write/unstable", test_unstable);
  RESULT_FIXTURE_ADD ("/result-write/uncertain-mechanism", test_uncertain_mechanism);
  RESULT_FIXTURE_ADD ("/result-write/overrides", test_overrides);
  RESULT_FIXTURE_ADD ("/result-write/disk-full", test_disk_full);
}
