/* quoin-cli ida: curves, going on after an interruption, and what is refused. */
#include "cli-run.h"

#include "support/room.h"
#include "support/table.h"

#include <string.h>

/* A block that a pulse of 0.5 s overturns from a certain amplitude on. */
static const char block[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [ { \"name\": \"j\", \"kind\": \"coulomb\", \"basis\": \"contact\", "
  "\"kn\": 1e8,\n"
  "    \"ks\": 1e8, \"friction\": 0.7 } ],\n"
  "  \"blocks\": [ { \"name\": \"ground\", \"vertices\": [[-1, -0.2], [1, -0.2], [1, 0], "
  "[-1, 0]],\n"
  "    \"thickness\": 1, \"density\": 2000, \"support\": [true, true, true] },\n"
  "    { \"name\": \"block\", \"vertices\": [[-0.1, 0], [0.1, 0], [0.1, 1], [-0.1, 1]],\n"
  "    \"thickness\": 1, \"density\": 2000 } ],\n"
  "  \"contact\": { \"law\": \"j\" },\n"
  "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ], "
  "\"live\": [] },\n"
  "  \"analysis\": { \"procedure\": \"dynamic\", \"geometry\": \"nonlinear\",\n"
  "    \"dynamic\": { \"duration\": 4, \"time_step\": 0.005,\n"
  "      \"damping\": { \"stiffness\": 1e-4 } } } }\n";

static const char pulse[] = "time [s],acceleration [m/s2]\n0,0\n0.25,1\n0.5,0\n";

/* What a record still has at the end of the duration is not left out without a word: neither here, nor
 * in a single analysis, whose end follows the record where no duration is given. */
static void
test_long_record (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *late = cli_replace (pulse, "0,0\n", "0,0\n9,0\n");
  g_autofree char *times = cli_replace (late, "0.25,", "9.25,");
  g_autofree char *all = cli_replace (times, "0.5,", "9.5,");
  g_autofree char *record = cli_write (folder, "late.csv", all);
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *text = cli_replace (block, "\"duration\": 4, ", "");
  g_autofree char *follows = cli_write (folder, "follows.quoin", text);
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  const char *ground = "analysis.dynamic.ground=[{\"direction\": [1, 0], \"record\": "
                       "\"late.csv\", \"scale\": 0.01}]";
  cli_fails (3, "lasts 9.5 s", "ida", model, "--record", record, "--scale", "1:2:1", "-o",
             results, NULL);
  cli_fails (3, "the duration of 4 s", "solve", model, "--set", ground, NULL);
  cli_says ("followed to 9.5 s", "solve", follows, "--set", ground, NULL);
  cli_says ("peak 1 m/s2 (0.102 g)", "check", follows, "--set", ground, NULL);
  cli_says ("4 samples to 9.5 s", "check", follows, "--set", ground, NULL);
  cli_says ("drift at the end 0.25 m/s, 0.0625 m", "check", follows, "--set", ground,
            NULL);
  cli_fails (3, "without ground motion", "check", follows, NULL);
}

/* Samples that a record lacks are told, with their line, whatever its peak is scaled to. */
static void
test_gap (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *gap = cli_write (folder, "gap.csv",
                                    "time [s],acceleration [m/s2]\n0,0\n1,.01\n2,0\n"
                                    "3,0\n6,0\n");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  const char *ground = "analysis.dynamic.ground=[{\"direction\": [1, 0], \"record\": "
                       "\"gap.csv\", \"peak\": 0.02}]";
  const char *told = "gap.csv:6: samples are missing from 3 s to 6 s: 2 (2 in the whole";
  cli_says (told, "check", model, "--set", ground, NULL);
  g_auto (CliRun) solve = cli_run ("solve", model, "--set", ground, NULL);
  g_auto (CliRun) ida =
    cli_run ("ida", model, "--record", gap, "--scale", "1:2:1", "-o", results, NULL);
  cli_assert_done (&solve);
  cli_assert_done (&ida);
  g_assert_nonnull (strstr (solve.err, told));
  g_assert_nonnull (strstr (ida.err, told));
}

static void
test_curves (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *record = cli_write (folder, "pulse.csv", pulse);
  g_autofree char *bare = cli_write (folder, "bare.txt", "0 0\n0.1 0.05\n0.2 0\n");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  g_autofree char *csv = g_build_filename (folder, "curves.csv", NULL);
  g_autofree char *svg = g_build_filename (folder, "curves.svg", NULL);
  cli_says ("pulse.csv: overturns first at", "ida", model, "--record", record, "--scale",
            "1:6:1", "-o", results, "--csv", csv, "--picture", svg, "--jobs", "2", NULL);
  g_autofree char *table = cli_read (csv), *picture = cli_read (svg);
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_assert_cmpuint (g_strv_length (lines), ==, 1 + 6 + 1);
  g_ptr_array_unref (test_table_read (table));
  double before = -1;
  gboolean fell = FALSE;
  for (int i = 1; i <= 6; i++) {
    g_auto (GStrv) fields = g_strsplit (lines[i], ",", -1);
    double peak = g_ascii_strtod (fields[3], NULL);
    g_assert_cmpstr (fields[0], ==, "\"pulse.csv\"");
    g_assert_cmpfloat (g_ascii_strtod (fields[1], NULL), ==, i);
    g_assert_cmpfloat (g_ascii_strtod (fields[2], NULL), ==, i); /* the peak is 1 m/s2 */
    gboolean falls = strcmp (fields[4], "1") == 0;
    if (!fell)
      g_assert_cmpfloat (peak, >, before);
    before = peak;
    fell |= falls;
    if (i == 1) /* 0.1 g: it does not even rock */
      g_assert_false (falls);
    g_assert_true (falls == (*fields[5] != '\0'));
  }
  g_assert_true (fell);
  g_assert_nonnull (strstr (picture, "<svg"));

  /* What is there is not computed again, and what is missing is. */
  g_autofree char *database = g_build_filename (results, "record-1", "study.db", NULL);
  g_autofree char *first = cli_read (csv);
  cli_do ("ida", model, "--record", record, "--scale", "1:6:1", "-o", results, "--csv",
          csv, NULL);
  g_autofree char *second = cli_read (csv);
  g_assert_cmpstr (first, ==, second);
  g_assert_true (g_file_test (database, G_FILE_TEST_EXISTS));
  cli_fails (3, "another study", "ida", model, "--record", record, "--scale", "1:6:0.5",
             "-o", results, NULL);

  g_autofree char *other = g_build_filename (folder, "other", NULL);
  cli_fails (3, "does not state the unit", "ida", model, "--record", bare, "--scale",
             "1:2:1", "-o", other, NULL);
  cli_says ("bare.txt: does not overturn", "ida", model, "--record", record, "--record",
            bare, "--unit", "g", "--scale", "1:2:1", "-o", other, NULL);
}

static void
test_refused (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *record = cli_write (folder, "pulse.csv", pulse);
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  static const char *const scales[] = { "1:2",   "0:1:0.1", "1:2:-1",
                                        "2:1:1", "1:2:1:1", "a:b:c" };
  cli_fails (2, "--record is missing", "ida", model, "--scale", "1:2:1", "-o", results,
             NULL);
  cli_fails (2, "-o is missing", "ida", model, "--record", record, "--scale", "1:2:1",
             NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (scales); i++)
    cli_fails (2, "--scale is", "ida", model, "--record", record, "--scale", scales[i],
               "-o", results, NULL);
  cli_fails (5, "nowhere.csv", "ida", model, "--record", "nowhere.csv", "--scale",
             "1:2:1", "-o", results, NULL);
  g_assert_false (g_file_test (results, G_FILE_TEST_IS_REGULAR));
}

QN_TESTS
{
  g_test_add_func ("/ida/curves", test_curves);
  g_test_add_func ("/ida/long-record", test_long_record);
  g_test_add_func ("/ida/gap", test_gap);
  g_test_add_func ("/ida/refused", test_refused);
}
