/* Input that cannot be used: one line that names the place, the right exit code, and nothing
 * written. */
#include "cli-run.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* One thing wrong in an otherwise sound project: `from` is replaced by `to`. */
typedef struct BadInput {
  const char *name;
  const char *from, *to;
  const char *part; /* of the message */
  int code;
} BadInput;

static const BadInput bad_inputs[] = {
  { "not-json", "{ \"format\"", "hello \"format\"", ":1:", 3 },
  { "wrong-format", "\"quoin\"", "\"brick\"", "format", 3 },
  { "wrong-version", "\"version\": 1", "\"version\": 99", "version", 3 },
  { "version-text", "\"version\": 1", "\"version\": \"1\"", "version", 3 },
  { "nan", "\"friction\": 0.4", "\"friction\": NaN", ":", 3 },
  { "infinite", "\"kn\": 1e7", "\"kn\": 1e999", "laws[0].kn", 3 },
  { "text-for-number", "\"ks\": 1e7", "\"ks\": \"1e7\"", "laws[0].ks", 3 },
  { "negative-stiffness", "\"kn\": 1e7", "\"kn\": -1e7", "laws[0].kn", 3 },
  { "zero-stiffness", "\"ks\": 1e7", "\"ks\": 0", "laws[0].ks", 3 },
  { "negative-friction", "\"friction\": 0.4", "\"friction\": -0.4", "laws[0].friction",
    3 },
  { "negative-thickness", "\"thickness\": 1", "\"thickness\": -1", "blocks[0].thickness",
    3 },
  { "missing-thickness", "\"thickness\": 1, ", "", "blocks[0]", 3 },
  { "dilatancy-above-friction", "\"dilatancy\": 0", "\"dilatancy\": 0.5", "laws[0]", 3 },
  { "unknown-law", "\"law\": \"joint\"", "\"law\": \"mortar\"", "mortar", 3 },
  { "unknown-kind", "\"coulomb\"", "\"treacle\"", "laws[0].kind", 3 },
  { "unknown-placement", "\"ends\"", "\"middle\"", "contact.pairs.placement", 3 },
  { "no-blocks", "\"blocks\": [", "\"blocks\": [], \"guides\": [", "blocks", 3 },
  { "two-vertices", "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]", "[[0, 0], [1, 0]]",
    "blocks[1].vertices", 3 },
  { "zero-area", "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]", "[[0, 0], [1, 0], [2, 0]]",
    "blocks[1].vertices", 3 },
  { "self-crossing", "[1, 0], [1, 0.5], [0, 0.5]]", "[1, 0.5], [1, 0], [0, 0.5]]",
    "blocks[1].vertices", 3 },
  { "duplicate-vertex", "[1, 0], [1, 0.5],", "[1, 0], [1, 0], [1, 0.5],",
    "blocks[1].vertices", 3 },
  { "one-coordinate", "[1, 0.5]", "[1]", "blocks[1].vertices[2]", 3 },
  { "overlap", "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]",
    "[[0, -0.2], [1, -0.2], [1, 0.5], [0, 0.5]]", "stone", 3 },
  { "no-support", ", \"support\": [true, true, true]", "", "support", 3 },
  { "floating", "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]",
    "[[0, 1], [1, 1], [1, 1.5], [0, 1.5]]", "stone", 3 },
  { "name-taken", "\"stone\"", "\"ground\"", "blocks[1]", 3 },
  { "unknown-load-block", "\"direction\": [1, 0] } ]",
    "\"direction\": [1, 0] }, { \"kind\": \"force\", \"block\": \"roof\", \"value\": [1, "
    "0] } ]",
    "roof", 3 },
  { "dead-load-cannot-stand", "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]",
    "[[1.8, 0], [2.8, 0], [2.8, 0.5], [1.8, 0.5]]", "stone", 4 },
  { "empty-course", "\"contact\":",
    "\"walls\": [ { \"name\": \"w\", \"origin\": [0, 5], "
    "\"unit\": [0.4, 0.2], \"thickness\": 1, \"unit_weight\": 1, \"courses\": [[]] } ], "
    "\"contact\":",
    "walls[0].courses[0]", 3 },
  { "zero-length", "\"contact\":",
    "\"walls\": [ { \"name\": \"w\", \"origin\": [0, 5], "
    "\"unit\": [0.4, 0.2], \"thickness\": 1, \"unit_weight\": 1, \"courses\": [[1, 0, "
    "1]] } ], "
    "\"contact\":",
    "walls[0].courses[0]", 3 },
  { "zero-increments", "\"increments\": 10", "\"increments\": 0", "analysis.increments",
    3 },
  { "half-increments", "\"increments\": 10", "\"increments\": 1.5", "analysis.increments",
    3 },
  { "unknown-procedure", "\"load\", \"geometry\"", "\"guess\", \"geometry\"",
    "analysis.procedure", 3 },
  { "negative-offset", "\"offset\": 0", "\"offset\": -1", "contact.pairs", 3 },
  { "offset-too-large", "\"offset\": 0", "\"offset\": 0.6", "offset", 3 },
};

static void
test_bad_input (gconstpointer data)
{
  const BadInput *bad = data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = cli_replace (cli_sliding_block, bad->from, bad->to);
  g_autofree char *model = cli_write (folder, "bad.quoin", text);
  g_autofree char *output = g_build_filename (folder, "bad.json", NULL);
  g_autofree char *curve = g_build_filename (folder, "bad.csv", NULL);

  CliRun run = cli_run ("solve", model, "-o", output, "--csv", curve, "--quiet", NULL);
  g_assert_nonnull (strstr (run.err, "bad.quoin"));
  g_assert_cmpstr (run.out, ==, "");
  cli_assert_failed (&run, bad->code, bad->part);
  if (bad->code == 3) {
    g_assert_false (g_file_test (output, G_FILE_TEST_EXISTS));
    g_assert_false (g_file_test (curve, G_FILE_TEST_EXISTS));
  }
}

/* Walls of cells and their bars: one change of a sound one. */
static void
test_cells (void)
{
  static const char *const changes[][2] = {
    { "laws[0].kn=1e10", "laws[0].kn: elasticity excludes" },
    { "laws[0].poisson=0.5", "laws[0].poisson" },
    { "laws[0].poisson=-0.1", "laws[0].poisson" },
    { "laws[0].basis=surface", "laws[0].elasticity" },
    { "bars[0].end=[0.06,6]", "bars[0].end: bar ends in no block" },
    { "bars[0].end=[0.06,-0.1]", "bars[0]: bar crosses no contact face" },
    { "bars[0].start=[0.06,2.1]", "bars[0].end: bar has no length" },
    { "blocks[0].vertices=[[0,2],[1.2,2],[1.2,2],[0,2]]", "polygon repeats a vertex" },
    { "masonry[0].cells=[0,5]", "masonry[0].cells" },
    { "masonry[0].cells=[5000,2000]", "masonry[0].cells" },
    { "masonry[0].size=[0,2]", "masonry[0].size: number must be positive" },
    { "masonry[0].size=[1.2,-1]", "masonry[0].size: number must be positive" },
  };
  g_autofree char *model = cli_example ("52-reinforced-wall.quoin");
  for (size_t i = 0; i < G_N_ELEMENTS (changes); i++)
    cli_fails (3, changes[i][1], "check", model, "--set", changes[i][0], NULL);
  cli_fails (3, "masonry[0].cell: more blocks", "generate", "voronoi", "size=3x1",
             "cell=0.0001", "-o", "-", NULL);
  cli_fails (3, "masonry[0].cell: number must be positive", "generate", "voronoi",
             "size=3x1", "cell=0", "-o", "-", NULL);
}

/* Whole files that are wrong, not single keys. */
static void
file_fails (const char *text, const char *part)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "bad.quoin", text);
  CliRun run = cli_run ("check", model, NULL);
  g_assert_nonnull (strstr (run.err, "bad.quoin"));
  g_assert_cmpstr (run.out, ==, "");
  cli_assert_failed (&run, 3, part);
}

static void
test_empty (void)
{
  file_fails ("", NULL);
  file_fails (" \n\n ", NULL);
  file_fails ("[]", NULL);
  file_fails ("null", NULL);
  file_fails ("{}", "format");
}

static void
test_truncated (void)
{
  for (size_t length = 1; length < strlen (cli_sliding_block) - 2; length += 97) {
    g_autofree char *text = g_strndup (cli_sliding_block, length);
    file_fails (text, NULL);
  }
}

static void
test_nested_brackets (void)
{
  enum { LENGTH = 10 << 20 };
  g_autofree char *text = g_malloc (LENGTH + 1);
  memset (text, '[', LENGTH);
  text[LENGTH] = '\0';
  file_fails (text, NULL);
}

/* One wall with these courses on the ground of the sliding block. */
static void
course_fails (const char *courses, const char *part)
{
  g_autofree char *wall = g_strdup_printf (
    "\"walls\": [ { \"name\": \"w\", \"origin\": [0, 0.5], \"unit\": [1, 0.5],"
    " \"thickness\": 1, \"unit_weight\": 1, \"courses\": %s } ],\n  \"contact\":",
    courses);
  g_autofree char *text = cli_replace (cli_sliding_block, "\"contact\":", wall);
  file_fails (text, part);
}

static void
test_absurd_courses (void)
{
  course_fails ("[[1e999]]", "walls[0].courses[0][0]");
  course_fails ("[[\"long\"]]", "walls[0].courses[0][0]");
  course_fails ("[[true]]", "walls[0].courses[0][0]");
  course_fails ("[]", "walls[0].courses");
  course_fails ("{}", "walls[0].courses");
}

/* 2,000 courses of 1,000 blocks are more than any model may have. */
static void
test_too_many_blocks (void)
{
  g_autoptr (GString) courses = g_string_new ("[");
  g_autoptr (GString) course = g_string_new ("[");
  for (int i = 0; i < 1000; i++)
    g_string_append (course, i > 0 ? ",1" : "1");
  g_string_append_c (course, ']');
  for (int i = 0; i < 2000; i++)
    g_string_append_printf (courses, "%s%s", i > 0 ? "," : "", course->str);
  g_string_append_c (courses, ']');
  course_fails (courses->str, "walls[0]");
}

static void
test_folder_as_model (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  cli_fails (5, folder, "solve", folder, NULL);
}

static void
test_unreadable (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "secret.quoin", cli_sliding_block);
  g_assert_cmpint (g_chmod (model, 0), ==, 0);
  if (access (model, R_OK) == 0) {
    g_test_skip ("this user may read everything");
  } else {
    cli_fails (5, "secret.quoin", "solve", model, NULL);
  }
}

static void
test_unknown_key_is_a_warning (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text =
    cli_replace (cli_sliding_block, "\"title\"", "\"colour\": \"red\", \"title\"");
  g_autofree char *model = cli_write (folder, "wall.quoin", text);
  CliRun run = cli_run ("solve", model, NULL);
  g_assert_cmpint (run.code, ==, 0);
  g_assert_nonnull (strstr (run.err, "colour"));
  cli_run_clear (&run);
}

QN_TESTS
{
  for (size_t i = 0; i < G_N_ELEMENTS (bad_inputs); i++) {
    g_autofree char *path = g_strconcat ("/cli/bad-input/", bad_inputs[i].name, NULL);
    g_test_add_data_func (path, &bad_inputs[i], test_bad_input);
  }
  g_test_add_func ("/cli/bad-input/cells", test_cells);
  g_test_add_func ("/cli/bad-input/empty", test_empty);
  g_test_add_func ("/cli/bad-input/truncated", test_truncated);
  g_test_add_func ("/cli/bad-input/nested-brackets", test_nested_brackets);
  g_test_add_func ("/cli/bad-input/absurd-courses", test_absurd_courses);
  g_test_add_func ("/cli/bad-input/too-many-blocks", test_too_many_blocks);
  g_test_add_func ("/cli/bad-input/folder", test_folder_as_model);
  g_test_add_func ("/cli/bad-input/unreadable", test_unreadable);
  g_test_add_func ("/cli/bad-input/unknown-key", test_unknown_key_is_a_warning);
}
