#include "io/project-text.h"
#include "io/result-fixture.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static void
test_round_trip (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->project.overrides = g_strsplit ("analysis.snap=stop", "|", -1);
  fixture->result.mechanism_uncertain = fixture->result.mechanism_by_work = true;
  g_autofree char *text = result_fixture_dup_text (fixture);
  g_auto (QnResultFile) file;
  GError *error = NULL;
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_no_error (error);

  const QnResult *read = &file.result, *written = &fixture->result;
  g_assert_cmpstr (file.model, ==, "wall.quoin");
  g_assert_cmpstr (file.model_sha256, ==, fixture->project.sha256);
  g_assert_cmpstr (file.overrides[0], ==, "analysis.snap=stop");
  g_assert_cmpstr (file.block_names[1], ==, "top");
  g_assert_null (file.block_names[2]);
  g_assert_cmpint (read->outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_true (read->has_collapse_multiplier && read->has_first_limit_multiplier);
  g_assert_cmpfloat (read->collapse_multiplier, ==, 0.2);
  g_assert_cmpfloat (read->first_limit_multiplier, ==, 0.1);
  g_assert_cmpint (read->solution_count, ==, 1);
  g_assert_cmpfloat (read->solutions[0].multiplier, ==, 0.2);
  g_assert_cmpint (read->solutions[0].found_by, ==, QN_PROCEDURE_WORK);
  g_assert_cmpfloat (read->solutions[0].displacement, ==, 2e-6);
  g_assert_true (read->has_associative_bound);
  g_assert_cmpfloat (read->associative_bound, ==, 0.25);
  g_assert_cmpint (read->linearity, ==, QN_LINEARITY_HOLDS);
  g_assert_cmpuint (read->event_count, ==, 1);
  g_assert_cmpint (read->events[0].kind, ==, QN_EVENT_KIND_SNAP);
  g_assert_cmpfloat (read->events[0].multiplier, ==, 0.1);
  g_assert_cmpfloat (read->events[0].displacement_after, ==, 2e-6);
  g_assert_cmpfloat (read->events[0].energy, ==, 0.5);
  g_assert_cmpuint (read->events[0].block_count, ==, 1);
  g_assert_cmpint (read->events[0].blocks[0], ==, 1);
  g_assert_cmpuint (read->block_count, ==, 2);
  g_assert_cmpuint (read->step_count, ==, 2);
  g_assert_cmpmem (read->displacements, 12 * sizeof (double), written->displacements,
                   12 * sizeof (double));
  g_assert_cmpint (read->steps[1].event, ==, QN_EVENT_COLLAPSE);
  g_assert_cmpint (read->steps[1].iterations, ==, 4);
  g_assert_cmpfloat (read->steps[1].residual, ==, 3e-10);
  g_assert_cmpmem (read->mechanism, 6 * sizeof (double), written->mechanism,
                   6 * sizeof (double));
  g_assert_true (read->mechanism_uncertain);
  g_assert_true (read->mechanism_by_work);
  g_assert_cmpuint (read->pair_count, ==, 2);
  for (size_t i = 0; i < 2; i++) {
    g_assert_cmpint (read->pairs[i].state, ==, written->pairs[i].state);
    g_assert_cmpfloat (read->pairs[i].normal_force, ==, written->pairs[i].normal_force);
    g_assert_cmpfloat (read->pairs[i].shear_force, ==, written->pairs[i].shear_force);
    g_assert_cmpint (file.contacts[i].blocks[1], ==, 1);
  }
  g_assert_cmpint (read->statistics.factorizations, ==, 400);
  g_assert_cmpint (read->statistics.peak_memory_bytes, ==, 12345678);
}

typedef struct Case {
  const char *what, *by, *message;
} Case;

static const Case cases[] = {
  { "\"quoin-result\"", "\"quoin\"",
    "r.json:2:13: format: this is not a result: expected \"quoin-result\"" },
  { "\"version\": 1", "\"version\": 2",
    "r.json:2:40: version: this program reads version 1 of the format only" },
  { "\"outcome\": \"collapse\"", "\"outcome\": \"glory\"",
    "r.json:6:14: outcome: \"glory\" is not one of collapse, target-reached, snap, "
    "unbounded, dead-load-unstable, cancelled, not-converged, rest" },
  { "\"collapse_multiplier\": 0.2", "\"collapse_multiplier\": \"0.2\"",
    "r.json:7:26: collapse_multiplier: expected a number, found a string" },
  { "\"blocks\": [\"base\", \"top\"]", "\"blocks\": [\"base\", \"top\", \"roof\"]",
    "r.json:19:41: steps[0].displacements: there are not as many displacements as "
    "blocks" },
  { "\"blocks\": [\"base\", \"top\"]", "\"blocks\": [\"base\", 3]",
    "r.json:17:22: blocks[1]: expected a string" },
  { "\"multiplier\": 0.2", "\"multiplier\": 1e999",
    "r.json:11:33: solutions[0].multiplier: number is not finite" },
  { "\"multiplier\": 0.2, ", "",
    "r.json:11:17: solutions[0].multiplier: required key is missing" },
  { "[1e-6, -2e-6, 3e-9]", "[1e-6, -2e-6]",
    "r.json:20:55: steps[1].displacements[1]: expected 3 numbers" },
  { "[1e-6, -2e-6, 3e-9]", "[1e-6, -2e-6, 3e-9, 1]",
    "r.json:20:55: steps[1].displacements[1]: expected 3 numbers" },
  { "[0, 0, 0], [1e-6, -2e-6, 3e-9]", "[1e-6, -2e-6, 3e-9]",
    "r.json:20:43: steps[1].displacements: there are not as many displacements as "
    "blocks" },
  { "\"event\": \"collapse\"", "\"event\": \"boom\"",
    "r.json:20:122: steps[1].event: \"boom\" is not one of null, snap, collapse" },
  { "\"found_by\": \"work\"", "\"found_by\": \"luck\"",
    "r.json:11:50: solutions[0].found_by: \"luck\" is not one of load, displacement, "
    "work, arc-length, limit, dynamic" },
  { "[0.2, 0.25]", "[0.2]",
    "r.json:12:24: collapse_interval: expected two numbers or null" },
  { "\"iterations\": 4", "\"iterations\": 4.5",
    "r.json:20:91: steps[1].iterations: expected a whole number that is not negative" },
  { "\"blocks\": [0, 1]", "\"blocks\": [0, 2]",
    "r.json:22:28: contacts[0].blocks: there are no such two blocks" },
  { "\"blocks\": [0, 1]", "\"blocks\": [1, 1]",
    "r.json:22:28: contacts[0].blocks: there are no such two blocks" },
  { "\"blocks\": [0, 1]", "\"blocks\": [0, -1]",
    "r.json:22:32: contacts[0].blocks[1]: expected a whole number that is not negative" },
  { "\"normal\": [0, 1]", "\"normal\": [0, 2]",
    "r.json:22:65: contacts[0].normal: normal is not of length 1" },
  { "\"state\": \"stick\"", "\"state\": \"glue\"",
    "r.json:22:95: contacts[0].state: \"glue\" is not one of stick, slip, open, yield" },
  { "\"mechanism\": [[0, 0, 0], ", "\"mechanism\": [",
    "r.json:24:16: mechanism: there are not as many velocities as blocks" },
  { "\"seconds\": 0.012", "\"seconds\": true",
    "r.json:32:27: timings.seconds: expected a number, found true or false" },
};

static void
test_errors (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *text = result_fixture_dup_text (fixture);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *changed = test_replace (text, cases[i].what, cases[i].by);
    QnResultFile file;
    g_autoptr (GError) error = NULL;
    g_assert_false (
      qn_result_file_parse (changed, strlen (changed), "r.json", &file, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_cmpstr (error->message, ==, cases[i].message);
  }
}

static void
test_truncated (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *text = result_fixture_dup_text (fixture);
  for (gsize length = 0; length < strlen (text) - 2; length++) {
    QnResultFile file;
    GError *error = NULL;
    g_assert_false (qn_result_file_parse (text, length, "r.json", &file, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_clear_error (&error);
  }
}

/* Keys may come in any order, and keys of a later version are passed over. */
static void
test_order_and_unknown (void)
{
  const char *text =
    "{ \"later\": { \"kind\": [1, 2] }, \"steps\": [ { \"multiplier\": 0.5, "
    "\"displacements\": [[1, 2, 3]] } ], \"contacts\": [], "
    "\"blocks\": [\"b\"], \"outcome\": \"target-reached\", \"version\": 1, "
    "\"format\": \"quoin-result\" }";
  g_auto (QnResultFile) file;
  GError *error = NULL;
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_no_error (error);
  g_assert_cmpint (file.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_false (file.result.has_collapse_multiplier);
  g_assert_null (file.result.mechanism);
  g_assert_cmpfloat (qn_result_step_displacements (&file.result, 0)[2], ==, 3);
}

/* A file of another kind is told so, not by the first of its members that differs. */
static void
test_other_format (void)
{
  static const char text[] =
    "{ \"format\": \"quoin\", \"version\": 1, \"blocks\": [{ \"name\": \"b\" }] }";
  QnResultFile file;
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_result_file_parse (text, strlen (text), "r.json", &file, &error));
  g_assert_cmpstr (
    error->message, ==,
    "r.json:1:13: format: this is not a result: expected \"quoin-result\"");
}

/* What limit analysis, stages and beams add. */
static const char further_text[] =
  "{ \"format\": \"quoin-result\", \"version\": 1, \"outcome\": \"collapse\", "
  "\"lower_bound\": 0.25, \"upper_bound\": 0.5, \"flow\": \"non-associative\", "
  "\"associative_bound\": 0.75, \"supports\": [0], \"solutions\": [ "
  "{ \"multiplier\": 0.3, \"found_by\": \"limit\" }, "
  "{ \"multiplier\": 0.4, \"found_by\": \"limit\" } ], "
  "\"stage\": 1, \"blocks\": [\"base\", \"top\"], \"nodes\": [\"free\"], "
  "\"steps\": [ { \"multiplier\": 0.5, \"stage\": 1, \"relaxed\": true, "
  "\"displacements\": [[0, 0, 0], [1, 2, 3]], \"reactions\": [[4, 5, 6]], "
  "\"node_displacements\": [[7, 8, 9]] } ], \"contacts\": [], "
  "\"mechanism\": [[0, 0, 0], [1, 0, 0]], \"mechanism_uncertain\": false, "
  "\"node_mechanism\": [[0, 1, 0]], \"events\": [ { \"multiplier\": 0.5, "
  "\"kind\": \"local\", \"displacement_before\": 0, \"displacement_after\": 1, "
  "\"energy\": 0, \"blocks\": [1] } ] }";

static void
test_further (void)
{
  g_auto (QnResultFile) file;
  GError *error = NULL;
  g_assert_true (
    qn_result_file_parse (further_text, strlen (further_text), "r.json", &file, &error));
  g_assert_no_error (error);
  const QnResult *result = &file.result;
  g_assert_true (result->limit.given && result->has_associative_bound);
  g_assert_cmpfloat (result->limit.lower_bound, ==, 0.25);
  g_assert_cmpfloat (result->limit.upper_bound, ==, 0.5);
  g_assert_cmpint (result->limit.flow, ==, QN_FLOW_NON_ASSOCIATIVE);
  g_assert_cmpfloat (result->associative_bound, ==, 0.75);
  g_assert_cmpuint (result->solution_count, ==, 2);
  g_assert_cmpfloat (result->solutions[1].multiplier, ==, 0.4);
  g_assert_cmpint (result->stage, ==, 2);
  g_assert_cmpint (result->steps[0].stage, ==, 2);
  g_assert_true (result->steps[0].relaxed);
  g_assert_false (result->mechanism_uncertain);
  g_assert_false (result->mechanism_by_work);
  g_assert_cmpfloat (result->mechanism[2 * 3 + 1], ==, 1);
  g_assert_cmpint (result->events[0].kind, ==, QN_EVENT_KIND_LOCAL);
}

static void
test_further_errors (void)
{
  static const Case wrong[] = {
    { "\"non-associative\"", "\"plastic\"",
      "flow: \"plastic\" is not one of associative, non-associative" },
    { "\"non-associative\"", "3", "flow: expected a string, found a number" },
    { "0.4, \"found_by\"", "true, \"found_by\"",
      "solutions[1].multiplier: expected a number" },
    { "\"stage\": 1, \"blocks\"", "\"stage\": 1000, \"blocks\"",
      "stage: there is no such stage" },
    { "\"stage\": 1, \"relaxed\"", "\"stage\": 1.5, \"relaxed\"", "steps[0].stage: " },
    { "\"relaxed\": true", "\"relaxed\": 1", "steps[0].relaxed: " },
    { "\"relaxed\": true", "\"relaxed\": true, \"beam_forces\": {}",
      "steps[0].beam_forces: expected an array" },
    { "[[4, 5, 6]]", "[[4, 5, 6], [7, 8, 9]]",
      "there are not as many reactions as supports in every step" },
    { "[[7, 8, 9]]", "[]", "there are not as many displacements as nodes in every step" },
    { "[[0, 1, 0]]", "[]", "there are not as many velocities as nodes" },
    { "\"supports\": [0]", "\"supports\": [2]", "supports[0]: there is no such block" },
    { "\"local\"", "\"global\"", "events[0].kind: \"global\" is not one of local" },
    { "\"blocks\": [1]", "\"blocks\": [2]",
      "events[0].blocks[0]: there is no such block" },
    { "\"blocks\": [1]", "\"blocks\": [\"top\"]", "events[0].blocks[0]: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_autofree char *text = test_replace (further_text, wrong[i].what, wrong[i].by);
    QnResultFile file;
    g_autoptr (GError) error = NULL;
    if (qn_result_file_parse (text, strlen (text), "r.json", &file, &error))
      g_error ("accepted: %s", wrong[i].by);
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    if (strstr (error->message, wrong[i].message) == NULL)
      g_error ("'%s' is not in '%s'", wrong[i].message, error->message);
  }
}

static void
test_file (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "r.json", NULL);
  g_auto (QnResultFile) file;
  GError *error = NULL;
  g_assert_false (qn_result_file_read (path, &file, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&error);
  g_assert_true (qn_result_file_write (path, &fixture->project, &fixture->contacts,
                                       &fixture->result, QN_DETAIL_FORCES, &error));
  g_assert_true (qn_result_file_read (path, &file, &error));
  g_assert_no_error (error);
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-read/round-trip", test_round_trip);
  RESULT_FIXTURE_ADD ("/result-read/errors", test_errors);
  RESULT_FIXTURE_ADD ("/result-read/truncated", test_truncated);
  RESULT_FIXTURE_ADD ("/result-read/file", test_file);
  g_test_add_func ("/result-read/order-and-unknown", test_order_and_unknown);
  g_test_add_func ("/result-read/other-formatother-format", test_other_format);
  g_test_add_func ("/result-read/further", test_further);
  g_test_add_func ("/result-read/further-errors", test_further_errors);
}
