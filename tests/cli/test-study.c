/* quoin-cli study: cases on several processes, what remains after a kill, what is refused. */
#include "cli-run.h"
#include "support/room.h"
#include "support/table.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* A study of the sliding block, whose file lies beside its project. */
static char *
write_study (const char *folder, const char *plan)
{
  g_free (cli_write (folder, "block.quoin", cli_sliding_block));
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"block.quoin\",\n"
    "  \"run\": \"solve\", \"parameters\": [\n"
    "    { \"name\": \"friction\", \"path\": \"laws[0].friction\", \"levels\": 5,\n"
    "      \"distribution\": { \"kind\": \"uniform\", \"min\": 0.2, \"max\": 0.4 } } ],\n"
    "  \"plan\": %s, \"outputs\": [\"collapse_multiplier\", \"mechanism_kind\",\n"
    "  \"mechanism_shape\"] }\n",
    plan);
  return cli_write (folder, "block.quoin-study", text);
}

static char *
table_of (const char *folder)
{
  CliRun run = cli_run ("study", "table", folder, NULL);
  cli_assert_done (&run);
  char *table = g_steal_pointer (&run.out);
  g_ptr_array_unref (test_table_read (table)); /* as other programs will */
  cli_run_clear (&run);
  return table;
}

/* Starts a run in the background. */
static GPid
start (const char *study, const char *folder, const char *jobs)
{
  const char *command[] = { g_getenv ("QUOIN_CLI"),
                            "study",
                            "run",
                            study,
                            "-o",
                            folder,
                            "--jobs",
                            jobs,
                            "--quiet",
                            NULL };
  GPid child;
  g_autoptr (GError) error = NULL;
  g_spawn_async (NULL, (char **) command, NULL, G_SPAWN_DO_NOT_REAP_CHILD, NULL, NULL,
                 &child, &error);
  g_assert_no_error (error);
  return child;
}

/* Waits until the database holds rows. */
static void
wait_for_rows (const char *folder)
{
  gboolean found = FALSE;
  while (!found) {
    CliRun run = cli_run ("study", "table", folder, NULL);
    found = strstr (run.out, ",done,") != NULL;
    cli_run_clear (&run);
  }
}

static int
finish (GPid child)
{
  int status;
  g_assert_cmpint (waitpid (child, &status, 0), ==, child);
  return WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
}

/* One worker or three, or slices gathered: the same table. */
static void
test_any_number_of_workers (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study =
    write_study (folder, "{ \"kind\": \"latin-hypercube\", \"count\": 60, \"seed\": 4 }");
  g_autofree char *one = g_build_filename (folder, "one", NULL);
  g_autofree char *three = g_build_filename (folder, "three", NULL);
  g_autofree char *sliced = g_build_filename (folder, "sliced", NULL);
  cli_says ("60 of 60 cases", "study", "run", study, "-o", one, "-j", "1", NULL);
  CliRun run = cli_run ("study", "run", study, "-o", three, "-j", "3", "--quiet", NULL);
  cli_assert_done (&run);
  g_assert_cmpstr (run.out, ==, "");
  cli_run_clear (&run);
  static const char *const slices[] = { "2/3", "1/3", "3/3" };
  for (gsize i = 0; i < G_N_ELEMENTS (slices); i++) {
    cli_says ("20 of 20 cases", "study", "run", study, "-o", sliced, "--shard", slices[i],
              NULL);
    /* Gathering is safe to repeat, and before all slices are there, or when one has just begun. */
    if (i == 0)
      g_free (cli_write (sliced, "shard-3-of-3.db", ""));
    cli_do ("study", "gather", sliced, NULL);
  }
  g_autofree char *first = table_of (one), *second = table_of (three);
  g_autofree char *third = table_of (sliced);
  g_assert_cmpstr (first, ==, second);
  g_assert_cmpstr (first, ==, third);
  g_assert_true (
    g_str_has_prefix (first, "case,friction,collapse_multiplier,mechanism_kind,mechanism_"
                             "shape,status,outcome,reason\n"));
}

/* The folder that the window makes has one for each state of the study: it stands for the present one. */
static void
test_states (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study = write_study (folder, "{ \"kind\": \"grid\" }");
  g_autofree char *text = cli_read (study);
  g_autofree char *model =
    g_compute_checksum_for_string (G_CHECKSUM_SHA256, cli_sliding_block, -1);
  g_autofree char *both = g_strconcat (text, model, NULL);
  g_autofree char *sum = g_compute_checksum_for_string (G_CHECKSUM_SHA256, both, -1);
  sum[8] = '\0';
  g_autofree char *states = g_build_filename (folder, "block-study", NULL);
  g_autofree char *state = g_build_filename (states, sum, NULL);
  cli_do ("study", "run", study, "-o", state, NULL);
  g_autofree char *named = table_of (states), *own = table_of (state);
  g_assert_cmpstr (named, ==, own);
  cli_says ("5 of 5 cases", "study", "run", states, NULL);
}

/* Killed in the middle, the same command goes on; interrupted, it says so. */
static void
test_goes_on (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study =
    write_study (folder, "{ \"kind\": \"monte-carlo\", \"count\": 3000 }");
  g_autofree char *whole = g_build_filename (folder, "whole", NULL);
  g_autofree char *parts = g_build_filename (folder, "parts", NULL);
  cli_do ("study", "run", study, "-o", whole, NULL);

  GPid child = start (study, parts, "2");
  wait_for_rows (parts);
  g_assert_cmpint (kill (child, SIGKILL), ==, 0);
  g_assert_cmpint (finish (child), ==, 128 + SIGKILL);
  /* Reading in between does no harm. */
  g_autofree char *part = table_of (parts);
  g_assert_nonnull (strstr (part, ",done,"));

  child = start (study, parts, "1");
  g_usleep (100000);
  kill (child, SIGINT);
  int code = finish (child);
  g_assert_true (code == 130 || code == 0 || code == 128 + SIGINT);

  cli_says ("3000 of 3000 cases", "study", "run", study, "-o", parts, NULL);
  g_autofree char *first = table_of (whole), *second = table_of (parts);
  g_assert_cmpstr (first, ==, second);
}

/* The first process that the given one has started; 0 where there is none. */
static GPid
child_of (GPid parent)
{
  g_autofree char *path =
    g_strdup_printf ("/proc/%d/task/%d/children", (int) parent, (int) parent);
  g_autofree char *text = NULL;
  if (!g_file_get_contents (path, &text, NULL, NULL))
    return 0;
  return (GPid) g_ascii_strtoll (text, NULL, 10);
}

/* Whether a process has been started as a worker by now. */
static gboolean
is_worker (GPid pid)
{
  g_autofree char *path = g_strdup_printf ("/proc/%d/cmdline", (int) pid), *text = NULL;
  gsize length = 0;
  if (!g_file_get_contents (path, &text, &length, NULL))
    return FALSE;
  for (gsize i = 0; i + 6 < length; i++)
    if (memcmp (text + i, "worker", 6) == 0)
      return TRUE;
  return FALSE;
}

/* Every outcome that a case may have, and names that hold what separates fields, are read again from
 * the table; a multiplier stands where there is one, and the summary says nothing infinite. */
static void
test_outcomes (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_free (cli_write (folder, "block.quoin", cli_sliding_block));
  g_autofree char *study = cli_write (
    folder, "all.quoin-study",
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"block.quoin\", \"run\": "
    "\"solve\", \"parameters\": [\n"
    "  { \"name\": \"effort, most\", \"path\": \"analysis.max_factorizations\", "
    "\"values\": [1, 50000] },\n"
    "  { \"name\": \"end\", \"path\": \"analysis.max_multiplier\", \"values\": [0, 0.1, "
    "10] "
    "} ],\n"
    "  \"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapse_multiplier\", "
    "\"mechanism_kind\"] }\n");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  cli_do ("study", "run", study, "-o", results, "-q", NULL);
  g_autofree char *text = table_of (results);
  g_autoptr (GPtrArray) table = test_table_read (text);
  guint seen[3] = { 0 };
  static const char *const outcomes[3] = { "collapse", "target-reached",
                                           "" }; /* failed */
  g_assert_cmpuint (table->len, ==, 1 + 6);
  for (guint i = 1; i < table->len; i++) {
    const char *outcome = test_table_field (table, i, "outcome");
    test_table_number (table, i, "effort, most");
    g_assert_cmpstr (test_table_field (table, i, "status"), ==,
                     *outcome == '\0' ? "failed" : "done");
    for (guint k = 0; k < 3; k++)
      seen[k] += g_str_equal (outcome, outcomes[k]);
    if (g_str_equal (outcome, "collapse"))
      g_assert_cmpfloat (test_table_number (table, i, "collapse_multiplier"), >, 0);
    else
      g_assert_cmpstr (test_table_field (table, i, "collapse_multiplier"), ==, "");
  }
  for (guint k = 0; k < 3; k++)
    g_assert_cmpuint (seen[k], >, 0);
  CliRun run = cli_run ("study", "summary", results, NULL);
  cli_assert_done (&run);
  g_assert_null (strstr (run.out, "nan"));
  g_assert_null (strstr (run.out, "inf"));
  cli_run_clear (&run);
}

/* A process that dies takes one case with it, whose row says how; --retry computes it again. */
static void
test_worker_dies (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study =
    write_study (folder, "{ \"kind\": \"monte-carlo\", \"count\": 3000 }");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  GPid child = start (study, results, "1"), victim;
  wait_for_rows (results);
  while ((victim = child_of (child)) == 0 || !is_worker (victim)) {
    g_assert_cmpint (waitpid (child, NULL, WNOHANG), ==, 0);
    g_usleep (1000);
  }
  g_assert_cmpint (kill (victim, SIGKILL), ==, 0);
  g_assert_cmpint (finish (child), ==, 0);

  g_autofree char *table = table_of (results);
  const char *failed = strstr (table, ",failed,");
  g_assert_nonnull (failed);
  g_assert_nonnull (strstr (failed, "signal 9"));
  g_assert_null (strstr (failed + 1, ",failed,"));

  cli_do ("study", "run", study, "-o", results, "--retry", NULL);
  g_autofree char *mended = table_of (results);
  g_assert_null (strstr (mended, ",failed,"));
}

/* How many processes that the given one has started are workers by now. */
static guint
count_workers (GPid parent)
{
  g_autofree char *path =
    g_strdup_printf ("/proc/%d/task/%d/children", (int) parent, (int) parent);
  g_autofree char *text = NULL;
  guint count = 0;
  if (!g_file_get_contents (path, &text, NULL, NULL))
    return 0;
  g_auto (GStrv) children = g_strsplit (g_strstrip (text), " ", -1);
  for (guint i = 0; children[i] != NULL; i++)
    count += is_worker ((GPid) g_ascii_strtoll (children[i], NULL, 10));
  return count;
}

/* As many cases at once as asked for, or as there are cores: none of these ends by itself while the
 * test looks. */
static void
test_cases_at_once (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s/%s\",\n"
    "  \"run\": \"dynamic\", \"limits\": { \"factorizations\": 1000000000 },\n"
    "  \"parameters\": [ { \"name\": \"duration\",\n"
    "    \"path\": [\"analysis.dynamic.duration\",\n"
    "      \"analysis.dynamic.ground[0].pulse.duration\"],\n"
    "    \"range\": [20000, 30000, 100] } ],\n"
    "  \"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapsed\"] }\n",
    g_getenv ("QUOIN_EXAMPLES"), "42-arch-pulse.quoin");
  g_autofree char *study = cli_write (folder, "long.quoin-study", text);
  static const char *const jobs[] = { "1", "3", "0" };
  for (gsize i = 0; i < G_N_ELEMENTS (jobs); i++) {
    g_autofree char *results = g_build_filename (folder, jobs[i], NULL);
    guint wanted = (guint) g_ascii_strtoll (jobs[i], NULL, 10);
    GPid child = start (study, results, jobs[i]);
    if (wanted == 0)
      wanted = MIN (g_get_num_processors (), 100);
    while (count_workers (child) < wanted) {
      g_assert_cmpint (waitpid (child, NULL, WNOHANG), ==, 0);
      g_usleep (1000);
    }
    for (int look = 0; look < 20; look++) {
      g_assert_cmpuint (count_workers (child), ==, wanted);
      g_usleep (1000);
    }
    g_assert_cmpint (kill (child, SIGINT), ==, 0);
    g_assert_cmpint (finish (child), ==, 130);
  }
}

static void
test_two_at_once (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study =
    write_study (folder, "{ \"kind\": \"monte-carlo\", \"count\": 20000 }");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  GPid child = start (study, results, "1");
  wait_for_rows (results);
  cli_fails (5, "study.db: another process", "study", "run", study, "-o", results, NULL);
  kill (child, SIGKILL);
  finish (child);
}

static void
test_another_study (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  g_autofree char *study = write_study (folder, "{ \"kind\": \"grid\" }");
  cli_says ("5 cases to compute", "study", "run", study, "-o", results, "--prepare",
            NULL);
  g_free (write_study (folder, "{ \"kind\": \"one-at-a-time\" }"));
  cli_fails (3, "another study", "study", "run", study, "-o", results, NULL);
}

static void
test_bad_folder (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study = write_study (folder, "{ \"kind\": \"grid\" }");
  cli_fails (5, "/proc/nowhere", "study", "run", study, "-o", "/proc/nowhere", NULL);
  cli_fails (2, "the same file", "study", "run", study, "-o", study, NULL);
  cli_fails (5, "study.quoin-study", "study", "table", folder, NULL);
}

static void
test_bad_usage (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study = write_study (folder, "{ \"kind\": \"grid\" }");
  cli_fails (2, "action", "study", NULL);
  cli_fails (2, "walk", "study", "walk", NULL);
  cli_fails (2, "-o", "study", "run", study, NULL);
  cli_fails (2, "--shard", "study", "run", study, "-o", "x", "--shard", "4/3", NULL);
  cli_fails (2, "--jobs", "study", "run", study, "-o", "x", "--jobs", "-1", NULL);
  g_autofree char *bad = cli_write (folder, "bad.quoin-study", "{ \"format\": 3 }");
  cli_fails (3, "bad.quoin-study:1:13: format: ", "study", "run", bad, "-o", "x", NULL);
}

/* A kept result is one that the other subcommands read. */
static void
test_keep (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study = write_study (folder, "{ \"kind\": \"grid\" }");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  cli_do ("study", "run", study, "-o", results, "--keep", NULL);
  g_autofree char *kept =
    g_build_filename (results, "results", "case-0000003.json", NULL);
  g_autofree char *model = g_build_filename (results, "model.quoin", NULL);
  g_autofree char *picture = g_build_filename (folder, "p.png", NULL);
  cli_do ("render", model, "--result", kept, "--view", "mechanism", "-o", picture, NULL);
}

/* A full disk, here a limit on the size of files: one error, and what was committed stays. */
static void
test_full_disk (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *study =
    write_study (folder, "{ \"kind\": \"monte-carlo\", \"count\": 3000 }");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  g_autofree char *command =
    g_strdup_printf ("ulimit -f 100; exec '%s' study run '%s' -o '%s' -j 1",
                     g_getenv ("QUOIN_CLI"), study, results);
  const char *shell[] = { "/bin/sh", "-c", command, NULL };
  CliRun run = { 0 };
  int status;
  g_assert_true (g_spawn_sync (NULL, (char **) shell, NULL, G_SPAWN_DEFAULT, NULL, NULL,
                               &run.out, &run.err, &status, NULL));
  run.code = WEXITSTATUS (status);
  cli_assert_failed (&run, 5, "study.db: ");
  cli_says ("3000 of 3000 cases", "study", "run", study, "-o", results, NULL);
}

/* A case that takes longer than it may is a row that says so, and the others go on. */
static void
test_time_limit (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"%s/%s\",\n"
    "  \"run\": \"dynamic\", \"limits\": { \"seconds\": 2, \"factorizations\": "
    "1000000000 }, \"parameters\": [\n"
    "    { \"name\": \"amplitude\", \"values\": [0.01],\n"
    "      \"path\": \"analysis.dynamic.ground[0].pulse.amplitude\" },\n"
    "    { \"name\": \"duration\", \"path\": [\"analysis.dynamic.duration\",\n"
    "      \"analysis.dynamic.ground[0].pulse.duration\"],\n"
    "      \"values\": [0.004, 20000, 0.006] } ],\n"
    "  \"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"collapsed\"] }\n",
    g_getenv ("QUOIN_EXAMPLES"), "42-arch-pulse.quoin");
  g_autofree char *study = cli_write (folder, "long.quoin-study", text);
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  cli_says ("3 of 3 cases, 1 of those computed now failed", "study", "run", study, "-o",
            results, "-j", "1", NULL);
  g_autofree char *table = table_of (results);
  g_assert_nonnull (strstr (table, "\n1,0.01,0.004,0,done,"));
  g_assert_nonnull (strstr (
    table, "\n2,0.01,20000,,failed,,the case took longer than 2 s (limits.seconds)\n"));
  g_assert_nonnull (strstr (table, "\n3,0.01,0.006,0,done,"));
}

/* A record of ground motion goes with the folder, and belongs to the study. */
static void
test_record (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *source =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "43-shaken-wall.quoin", NULL);
  g_autofree char *record_source =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "43-synthetic-record.csv", NULL);
  g_autofree char *whole = cli_read (source), *record = cli_read (record_source);
  g_autofree char *project = cli_replace (whole, "\"duration\": 10, ", "");
  g_auto (GStrv) samples = g_strsplit (record, "\n", 7); /* to 0.025 s */
  record[strlen (record) - strlen (samples[6])] = '\0';
  g_free (cli_write (folder, "wall.quoin", project));
  g_autofree char *record_path = cli_write (folder, "43-synthetic-record.csv", record);
  g_autofree char *study = cli_write (
    folder, "s.quoin-study",
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"wall.quoin\",\n"
    "  \"run\": \"dynamic\", \"parameters\": [ { \"name\": \"scale\",\n"
    "    \"path\": \"analysis.dynamic.ground[0].scale\", \"values\": [0.1] },\n"
    "    { \"name\": \"duration\", \"path\": \"analysis.dynamic.duration\",\n"
    "      \"values\": [0.025] } ],\n"
    "  \"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"peak_displacement\"] }\n");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  cli_do ("study", "run", study, "-o", results, "--prepare", NULL);
  g_autofree char *other = g_strconcat (record, "11,0\n", NULL);
  g_assert_true (g_file_set_contents (record_path, other, -1, NULL));
  cli_fails (3, "another study", "study", "run", study, "-o", results, NULL);
  g_assert_cmpint (unlink (record_path), ==, 0);
  CliRun run = cli_run ("study", "run", results, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "1 of 1 cases;"));
  cli_run_clear (&run);
  cli_fails (5, "43-synthetic-record.csv", "study", "run", study, "-o", results, NULL);
}

/* What does not depend on a parameter has one share, not the same line again and again. */
static void
test_one_value (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_free (cli_write (folder, "block.quoin", cli_sliding_block));
  g_autofree char *study = cli_write (
    folder, "s.quoin-study",
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"block.quoin\",\n"
    "  \"run\": \"solve\", \"parameters\": [ { \"name\": \"stiffness\",\n"
    "    \"path\": [\"laws[0].kn\", \"laws[0].ks\"], \"distribution\":\n"
    "    { \"kind\": \"uniform\", \"min\": 1e7, \"max\": 1e8 } } ],\n"
    "  \"plan\": { \"kind\": \"latin-hypercube\", \"count\": 40 },\n"
    "  \"outputs\": [\"collapse_multiplier\"] }\n");
  g_autofree char *results = g_build_filename (folder, "results", NULL);
  cli_do ("study", "run", study, "-o", results, NULL);
  CliRun run = cli_run ("study", "summary", results, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "100.00 %"));
  g_auto (GStrv) lines = g_strsplit (run.out, "\n", -1);
  for (guint i = 1; lines[i] != NULL; i++)
    if (strstr (lines[i], " % (") != NULL)
      g_assert_false (g_str_has_prefix (lines[i - 1], "      ")
                      && strncmp (lines[i - 1], lines[i], 14) == 0);
  cli_run_clear (&run);
}

/* Most pieces of one line in the colour of the first series. */
static guint
longest_line (const char *svg)
{
  guint longest = 0;
  g_auto (GStrv) lines = g_strsplit (svg, "\n", -1);
  for (guint i = 0; lines[i] != NULL; i++) {
    const char *path = strstr (lines[i], " d=\"M");
    guint pieces = 0;
    /* One style in Cairo 1.16, attributes in 1.18. */
    if (path == NULL
        || !g_regex_match_simple ("fill[:=]\"?none.*stroke-linejoin[:=]\"?round",
                                  lines[i], 0, 0))
      continue;
    for (const char *c = path; *c != '\0' && *c != '>'; c++) {
      pieces = *c == 'M' ? 0 : pieces + (*c == 'L');
      longest = MAX (longest, pieces);
    }
  }
  return longest;
}

/* Where no case has a value the envelope has a gap: the middle case, without a growing load, fails. */
static void
test_gap (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_free (cli_write (folder, "block.quoin", cli_sliding_block));
  char *paths[2] = { NULL, NULL };
  static const char *const middles[] = { "0", "0.5" };
  for (gsize i = 0; i < G_N_ELEMENTS (middles); i++) {
    g_autofree char *text = g_strdup_printf (
      "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"block.quoin\",\n"
      "  \"run\": \"limit\", \"parameters\": [ { \"name\": \"push\",\n"
      "    \"path\": \"loads.live[0].direction[0]\", \"values\": [-2, -1, %s, 1, 2] } "
      "],\n"
      "  \"plan\": { \"kind\": \"grid\" }, \"outputs\": [\"associative_multiplier\"] }\n",
      middles[i]);
    g_autofree char *study = cli_write (folder, "s.quoin-study", text);
    g_autofree char *results = g_build_filename (folder, middles[i], NULL);
    g_autofree char *picture = g_build_filename (folder, "e.svg", NULL);
    cli_do ("study", "run", study, "-o", results, NULL);
    cli_do ("study", "plot", results, "--kind", "envelope", "-o", picture, NULL);
    paths[i] = cli_read (picture);
  }
  /* Five points: one line of four pieces, or two of one each. */
  g_assert_cmpuint (longest_line (paths[0]), ==, 1);
  g_assert_cmpuint (longest_line (paths[1]), ==, 4);
  g_free (paths[0]);
  g_free (paths[1]);
}

/* Every figure of every plan that has it; again, the same bytes. */
static void
test_figures (void)
{
  static const char *const kinds[] = { "scatter",  "histogram",  "cumulative", "tornado",
                                       "envelope", "mechanisms", "surface" };
  static const char *const plans[] = { "{ \"kind\": \"grid\" }",
                                       "{ \"kind\": \"one-at-a-time\" }",
                                       "{ \"kind\": \"latin-hypercube\", \"count\": 40 }",
                                       "{ \"kind\": \"sobol\", \"count\": 16 }" };
  test_autoscratch char *folder = test_scratch_new ();
  for (gsize p = 0; p < G_N_ELEMENTS (plans); p++) {
    g_autofree char *study = write_study (folder, plans[p]);
    g_autofree char *name = g_strdup_printf ("results-%zu", p);
    g_autofree char *results = g_build_filename (folder, name, NULL);
    cli_do ("study", "run", study, "-o", results, NULL);
    cli_says ("collapse_multiplier", "study", "summary", results, NULL);
    for (gsize k = 0; k < G_N_ELEMENTS (kinds) - 1; k++) {
      g_autofree char *first = NULL, *second = NULL;
      for (int again = 0; again < 2; again++) {
        g_autofree char *path = g_build_filename (folder, "figure.svg", NULL);
        cli_do ("study", "plot", results, "--kind", kinds[k], "-o", path, NULL);
        *(again ? &second : &first) = cli_read (path);
      }
      g_assert_cmpstr (first, ==, second);
      g_assert_nonnull (strstr (first, "</svg>"));
    }
    /* One parameter has no surface; no output, no figure. */
    cli_fails (2, "--by", "study", "plot", results, "-k", "surface", "-o", "x.svg", NULL);
    cli_fails (2, "pie", "study", "plot", results, "-k", "pie", "-o", "x.svg", NULL);
    cli_fails (2, "--of", "study", "plot", results, "-k", "histogram", "--of", "steps",
               "-o", "x.svg", NULL);
  }
}

QN_TESTS
{
  g_test_add_func ("/cli/study/any-number-of-workers", test_any_number_of_workers);
  g_test_add_func ("/cli/study/states", test_states);
  g_test_add_func ("/cli/study/goes-on", test_goes_on);
  g_test_add_func ("/cli/study/outcomes", test_outcomes);
  g_test_add_func ("/cli/study/worker-dies", test_worker_dies);
  g_test_add_func ("/cli/study/cases-at-once", test_cases_at_once);
  g_test_add_func ("/cli/study/two-at-once", test_two_at_once);
  g_test_add_func ("/cli/study/another-study", test_another_study);
  g_test_add_func ("/cli/study/bad-folder", test_bad_folder);
  g_test_add_func ("/cli/study/bad-usage", test_bad_usage);
  g_test_add_func ("/cli/study/keep", test_keep);
  g_test_add_func ("/cli/study/full-disk", test_full_disk);
  g_test_add_func ("/cli/study/time-limit", test_time_limit);
  g_test_add_func ("/cli/study/record", test_record);
  g_test_add_func ("/cli/study/one-value", test_one_value);
  g_test_add_func ("/cli/study/gap", test_gap);
  g_test_add_func ("/cli/study/figures", test_figures);
}
