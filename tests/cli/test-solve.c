/* quoin-cli solve: outputs, overrides, repeatability, what stays when it fails. */
#include "cli-run.h"
#include "support/room.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>

/* The number behind the first `"key": ` of a JSON text. */
static double
number_of (const char *json, const char *key)
{
  g_autofree char *quoted = g_strdup_printf ("\"%s\":", key);
  const char *found = strstr (json, quoted);
  g_assert_nonnull (found);
  return g_ascii_strtod (found + strlen (quoted), NULL);
}

/* Replaces every number behind a key that ends in "seconds" by 0: times may differ. */
static char *
without_times (const char *json)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GRegex) regex = g_regex_new ("(seconds\": *)[-+0-9.eE]+", G_REGEX_DEFAULT,
                                          G_REGEX_MATCH_DEFAULT, &error);
  g_assert_no_error (error);
  char *text =
    g_regex_replace (regex, json, -1, 0, "\\g<1>0", G_REGEX_MATCH_DEFAULT, &error);
  g_assert_no_error (error);
  return text;
}

/* Solves an example to standard output. */
static char *
solve_example (const char *name, const char *override, const char *variable,
               const char *value)
{
  g_autofree char *model = cli_example (name);
  const char *arguments[] = {
    "solve", model, "-o", "-", override != NULL ? "--set" : NULL, override, NULL
  };
  CliRun run = cli_run_with (arguments, variable, value);
  cli_assert_done (&run);
  char *json = g_steal_pointer (&run.out);
  cli_run_clear (&run);
  return json;
}

static void
test_standard_output (void)
{
  g_autofree char *json = solve_example ("01-sliding-block.quoin", NULL, NULL, NULL);
  g_assert_true (g_str_has_prefix (json, "{"));
  g_assert_nonnull (strstr (json, "\"quoin-result\""));
  g_assert_nonnull (strstr (json, "\"collapse\""));
  g_assert_cmpfloat_with_epsilon (number_of (json, "collapse_multiplier"), 0.4, 1e-3);
}

/* Blocks over a door without a lintel: in both geometries they fall, as they do in time. Equilibria in which
 * their neighbours press them together exist, but no motion leads there. */
static void
test_door_without_lintel (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "door.quoin", NULL);
  cli_do ("generate", "wall", "length=2.94", "height=1.49", "bond=flemish",
          "unit=0.4x0.2",
          "openings=[{ \"at\": [0.45, 0], \"width\": 0.97, \"height\": 0.75 }]",
          "--friction=0.5", "-o", path, NULL);
  cli_fails (4, "wall.4.4", "solve", path, "--set=analysis.geometry=linear", NULL);
  cli_fails (4, "wall.4.4", "solve", path, "--set=analysis.geometry=nonlinear", NULL);
}

/* Of the sliding block 1 by friction; of limit analysis with associative flow alone. */
static void
test_sensitivity (void)
{
  g_autofree char *model = cli_example ("01-sliding-block.quoin");
  CliRun run = cli_run ("limit", "--sensitivity", model, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "dead load 1: 0.4\n"));
  g_assert_nonnull (strstr (run.out, "live load 1: -0.4\n"));
  cli_run_clear (&run);
  cli_fails (2, "associative", "limit", "--sensitivity", "--quiet", "--set",
             "analysis.flow=non-associative", model, NULL);
  cli_fails (2, "--sensitivity", "solve", "--sensitivity", model, NULL);
}

static void
test_set (void)
{
  g_autofree char *json =
    solve_example ("01-sliding-block.quoin", "laws[0].friction=0.3", NULL, NULL);
  g_assert_cmpfloat_with_epsilon (number_of (json, "collapse_multiplier"), 0.3, 1e-3);
}

static void
test_set_is_repeatable (void)
{
  g_autofree char *model = cli_example ("01-sliding-block.quoin");
  cli_says ("\"target-reached\"", "solve", "--set", "laws[0].friction=0.3", model,
            "--set", "analysis.max_multiplier=0.25", "-o", "-", NULL);
}

/* A path that creeps past its largest multiplier in long steps still ends right there. */
static void
test_ends_at_target (void)
{
  static const double targets[] = { 0.99, 1, 1.1 };
  for (gsize i = 0; i < G_N_ELEMENTS (targets); i++) {
    g_autofree char *set = g_strdup_printf ("analysis.max_multiplier=%g", targets[i]);
    g_autofree char *json = solve_example ("19-settling-wall.quoin", set, NULL, NULL);
    g_assert_nonnull (strstr (json, "\"outcome\": \"target-reached\""));
    const char *last = g_strrstr (json, "\"displacements\"");
    g_assert_nonnull (last);
    last = g_strrstr_len (json, last - json, "\"multiplier\"");
    g_assert_nonnull (last);
    g_assert_cmpfloat_with_epsilon (number_of (last, "multiplier"), targets[i], 1e-9);
  }
}

/* A path that goes on behind its peak: the peak is the collapse, told beside where the path ends; of limit
 * analysis it is told that it does not know of displacements. */
static void
test_ends_behind_peak (void)
{
  g_autofree char *model = cli_example ("02-overturning-block.quoin");
  const char *control =
    "analysis.control={\"block\": \"block\", \"component\": \"ux\", \"target\": 0.2}";
  cli_says (": collapse at load multiplier 0.49", "solve", model, "--set", control,
            "--set", "analysis.geometry=nonlinear", "--set",
            "analysis.procedure=displacement", NULL);
  cli_says ("of the undeformed structure above 0.5000", "limit", model, "--set",
            "analysis.geometry=nonlinear", NULL);
  cli_says ("no equilibrium above 0.5000", "limit", model, NULL);
}

/* A wall of rubble that moves on at a lower multiplier beyond a peak: collapse is the peak, at which load
 * control ends. */
static void
test_peak (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *wall = g_build_filename (folder, "rubble.quoin", NULL);
  cli_do ("generate", "rubble", "width=[1.4,1]", "height=2", "stone=0.4", "seed=12",
          "--plain", "-o", wall, NULL);
  CliRun work = cli_run ("solve", wall, "-q", "--set", "analysis.geometry=linear",
                         "--set", "analysis.procedure=work", "-o", "-", NULL);
  CliRun load =
    cli_run ("solve", wall, "-q", "--set", "analysis.geometry=linear", "-o", "-", NULL);
  cli_assert_done (&work);
  cli_assert_done (&load);
  double peak = number_of (work.out, "collapse_multiplier");
  double held = number_of (load.out, "collapse_multiplier");
  g_autofree char *last = g_strdup (g_strrstr (work.out, "\"multiplier\":"));
  g_assert_cmpfloat (number_of (last, "multiplier"), <, 0.98 * peak);
  g_assert_cmpfloat (held, >=, 0.99 * peak);
  g_free (g_steal_pointer (&last));
  last = g_strdup (g_strrstr (load.out, "\"multiplier\":"));
  g_assert_cmpfloat (number_of (last, "multiplier"), ==, held);
  cli_run_clear (&work);
  cli_run_clear (&load);
}

/* Joints of five pairs open pair by pair, and the path creeps to its collapse. It gets there by its own
 * steps for less than a search for the collapse takes: 71 factorisations with it. */
static void
test_five_pairs (void)
{
  g_autofree char *json = solve_example ("28-arch-under-fill.quoin", NULL, NULL, NULL);
  g_assert_cmpfloat_with_epsilon (number_of (json, "collapse_multiplier"), 4.88779, 1e-4);
  g_assert_cmpfloat (number_of (json, "factorizations"), <=, 62);
}

static void
test_bad_set (void)
{
  g_autofree char *model = cli_example ("01-sliding-block.quoin");
  cli_fails (2, "nonsense", "solve", model, "--set", "nonsense", NULL);
  cli_fails (2, "\"friction\"", "limit", model, "-q", "--set", "laws[0].frictoin=1",
             NULL);
  cli_fails (2, "laws has 1 element", "check", model, "--set", "laws[1].kn=1", NULL);
  cli_fails (2, "laws[0].friction", "solve", model, "--set", "laws[j].friction=1", NULL);
  cli_fails (3, "laws[0].friction", "solve", model, "--set", "laws[0].friction=-1", NULL);
  cli_fails (3, "analysis.increments", "solve", model, "--set",
             "analysis.increments=many", NULL);
}

/* A loop over a script reads exit codes and errors: what -q leaves out is no warning. */
static void
test_quiet_warns (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text =
    cli_replace (cli_sliding_block, "\"kn\"", "\"frictoin\": 0.2, \"kn\"");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  static const char *const commands[] = { "solve", "limit", "modal", "stability" };
  for (gsize i = 0; i < G_N_ELEMENTS (commands); i++) {
    g_auto (CliRun) run = cli_run (commands[i], model, "-q", NULL);
    const char *warning = strstr (run.err, "warning: ");
    g_assert_nonnull (warning);
    g_assert_nonnull (strstr (warning, "nearest known one is \"friction\""));
    g_assert_null (strstr (warning + 1, "warning: "));
  }
}

static void
test_outputs (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("05-stack.quoin");
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  g_autofree char *curve = g_build_filename (folder, "r.csv", NULL);
  cli_says ("0.4000", "solve", model, "-o", result, "--csv", curve, NULL);

  g_autofree char *json = cli_read (result);
  g_autofree char *csv = cli_read (curve);
  g_assert_cmpfloat_with_epsilon (number_of (json, "collapse_multiplier"), 0.4, 1e-3);
  g_auto (GStrv) rows = g_strsplit (csv, "\n", -1);
  g_assert_cmpuint (g_strv_length (rows), >, 3);

  CliRun run = cli_run ("solve", model, "-o", result, "--quiet", NULL);
  cli_assert_done (&run);
  g_assert_cmpstr (run.out, ==, "");
  cli_run_clear (&run);
}

static void
test_same_bytes (void)
{
  g_autofree char *first = solve_example ("ferris-tin-loi/wall1.quoin", NULL, NULL, NULL);
  g_autofree char *second =
    solve_example ("ferris-tin-loi/wall1.quoin", NULL, NULL, NULL);
  g_autofree char *a = without_times (first);
  g_autofree char *b = without_times (second);
  g_assert_true (strcmp (a, b) == 0);
}

static void
test_locale (void)
{
  g_autofree char *plain = solve_example ("06-arch.quoin", NULL, "LC_ALL", "C");
  g_autofree char *german =
    solve_example ("06-arch.quoin", NULL, "LC_ALL", "de_DE.UTF-8");
  g_autofree char *a = without_times (plain);
  g_autofree char *b = without_times (german);
  g_assert_true (strcmp (a, b) == 0);
}

static void
test_unwritable (void)
{
  g_autofree char *model = cli_example ("01-sliding-block.quoin");
  cli_fails (5, "/no/such/folder/r.json", "solve", model, "-q", "-o",
             "/no/such/folder/r.json", NULL);
  cli_fails (5, "/no/such/folder/r.csv", "solve", model, "-q", "--csv",
             "/no/such/folder/r.csv", NULL);
  cli_fails (5, "/dev/full", "solve", model, "-q", "-o", "/dev/full", NULL);
}

/* A result that was there stays whole when its successor cannot be computed. */
static void
test_old_result_stays (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model =
    cli_write (folder, "bad.quoin", "{ \"format\": \"quoin\", \"version\": 1 }");
  g_autofree char *result = cli_write (folder, "r.json", "old");
  cli_fails (3, NULL, "solve", model, "-o", result, NULL);
  g_autofree char *text = cli_read (result);
  g_assert_cmpstr (text, ==, "old");
}

static void
test_snap_stop (void)
{
  g_autofree char *json =
    solve_example ("15-rubble-pier.quoin", "analysis.snap=stop", NULL, NULL);
  g_assert_nonnull (strstr (json, "\"outcome\": \"snap\""));
  g_assert_cmpfloat_with_epsilon (number_of (json, "first_limit_multiplier"), 0.2060,
                                  0.002);
}

/* What an analysis may spend ends it, with where it came to and why: not with advice for another
 * trouble. */
static void
test_budgets (void)
{
  static const char *const rows[][3] = {
    { "13-aqueduct.quoin", "analysis.max_factorizations=20",
      "after as many factorisations as max_factorizations allows" },
    { "13-aqueduct.quoin", "analysis.max_seconds=1e-9",
      "after the time that max_seconds allows" },
    { "40-rocking-in-time.quoin", "analysis.max_factorizations=20",
      " s, after as many factorisations as max_factorizations allows" },
    { "40-rocking-in-time.quoin", "analysis.max_seconds=1e-9",
      "after the time that max_seconds allows" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *model = cli_example (rows[i][0]);
    cli_fails (4, rows[i][2], "solve", model, "-q", "--set", rows[i][1], NULL);
  }
  g_autofree char *wall = cli_example ("19-settling-wall.quoin");
  cli_says ("without collapse", "solve", wall, "--set", "walls[0].unit_weight=0", NULL);
}

/* Stiffness that leaves nothing of a displacement in doubles ends in a true answer or in none. */
static void
test_stiff_joints (void)
{
  static const struct {
    const char *example, *multiplier;
  } rows[] = { { "01-sliding-block.quoin", "0.40000" },
               { "02-overturning-block.quoin", "0.50000" },
               { "04-block-on-slope.quoin", "0.30123" } };
  static const char *const stiffnesses[] = { "laws[0].ks=1e17", "laws[0].ks=1e18",
                                             "laws[0].ks=1e19" };
  for (gsize i = 0; i < G_N_ELEMENTS (rows) * G_N_ELEMENTS (stiffnesses); i++) {
    g_autofree char *model = cli_example (rows[i / 3].example);
    CliRun run = cli_run ("solve", model, "--set", stiffnesses[i % 3], NULL);
    g_assert_true (run.code == 0 || run.code == 4);
    if (run.code == 0)
      g_assert_nonnull (strstr (run.out, rows[i / 3].multiplier));
    cli_run_clear (&run);
  }
}

/* By the associative theorem friction holds a block between two fixed ones; no path presses it there. Both
 * are told, in both geometries, and where the joint's flow is that of the theorem neither is untrue. */
static void
test_limit_without_dead_load (void)
{
  static const char *const geometries[] = { "analysis.geometry=linear",
                                            "analysis.geometry=nonlinear" };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *wider =
    cli_replace (cli_sliding_block, "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]",
                 "[[2, -0.4], [4, -0.4], [4, -0.1], [2, -0.1]]");
  g_autofree char *held = cli_replace (
    wider, "    { \"name\": \"stone\"",
    "    { \"name\": \"far\", \"vertices\": [[4, -0.5], [5, -0.5], [5, 0], [4, 0]],\n"
    "      \"thickness\": 1, \"unit_weight\": 10000, \"support\": [true, true, true] },\n"
    "    { \"name\": \"stone\"");
  g_autofree char *rough = cli_replace (held, "\"friction\": 0.4", "\"friction\": 0.8");
  g_autofree char *model = cli_write (folder, "held.quoin", rough);
  for (gsize i = 0; i < G_N_ELEMENTS (geometries); i++) {
    g_auto (CliRun) run = cli_run ("limit", model, "--set", geometries[i], NULL);
    g_assert_cmpint (run.code, ==, 4);
    g_assert_nonnull (strstr (run.out, "By the associative theorem"));
    g_assert_nonnull (
      strstr (run.err, "no stable equilibrium under the dead load: stone"));
    g_assert_null (strstr (run.out, "followed"));
    cli_fails (4, "under the dead load: stone", "solve", model, "--set", geometries[i],
               NULL);
  }
}

/* What `limit` sets by itself nobody is blamed for; what somebody sets is named. */
static void
test_limit_of_beams (void)
{
  g_autofree char *model = cli_example ("32-frame-beams.quoin");
  cli_fails (3, "use another procedure (set by quoin-cli limit)", "limit", model, NULL);
  cli_fails (3, "(set by \"analysis.procedure=limit\")", "solve", model, "--set",
             "analysis.procedure=limit", NULL);
}

/* Waits until a process catches SIGINT, whatever that takes on a busy machine. */
static void
wait_for_handler (GPid pid)
{
  g_autofree char *path = g_strdup_printf ("/proc/%d/status", (int) pid);
  guint64 caught = 0;
  while ((caught >> (SIGINT - 1)) % 2 == 0) {
    g_autofree char *status = NULL;
    g_assert_true (g_file_get_contents (path, &status, NULL, NULL));
    const char *mask = strstr (status, "SigCgt:");
    g_assert_nonnull (mask); /* a process that has ended has none */
    caught = g_ascii_strtoull (mask + strlen ("SigCgt:\t"), NULL, 16);
    g_usleep (1000);
  }
}

/* The multiplier at which a wall of units of 0.4 x 0.2 m with two windows collapses in large
 * displacements. */
static double
collapse_of_wall (const char *length, const char *height, const char *first,
                  const char *second, const char *stiffness)
{
  char *folder = test_scratch_new ();
  g_autofree char *model = g_build_filename (folder, "wall.quoin", NULL);
  const char *opening = "\"span\": \"lintel\", \"depth\": 0.2, \"bearing\": 0.2}";
  g_autofree char *openings =
    g_strdup_printf ("openings=[{%s, %s, {%s, %s]", first, opening, second, opening);
  g_autofree char *kn = g_strconcat ("laws[0].kn=", stiffness, NULL);
  g_autofree char *ks = g_strconcat ("laws[0].ks=", stiffness, NULL);
  cli_do ("generate", "wall", length, height, "unit=0.4x0.2", openings, "-o", model,
          NULL);
  g_auto (CliRun) run = cli_run ("solve", model, "--set", "analysis.geometry=nonlinear",
                                 "--set", kn, "--set", ks, "-o", "-", NULL);
  cli_assert_done (&run);
  double multiplier = number_of (run.out, "collapse_multiplier");
  test_scratch_free (folder);
  return multiplier;
}

/* A sill under which the wall bulges stands on one edge, an equilibrium that it leaves: it turns by
 * micrometres until the next edge touches, and the wall stands. In linear geometry it collapses at 0.503,
 * and no equilibrium is above 0.5335. */
static void
test_block_on_an_edge (void)
{
  double multiplier = collapse_of_wall (
    "length=4.8", "height=2.4", "\"at\": [0.75, 0.78], \"width\": 0.87, \"height\": 0.88",
    "\"at\": [2.8, 0.62], \"width\": 0.79, \"height\": 1.06", "2e10");
  g_assert_cmpfloat (multiplier, >, 0.45);
  g_assert_cmpfloat (multiplier, <, 0.5335);
}

/* The sill of a window rocks on the joint below it. With the work of the live load prescribed it would unload
 * the whole wall, which would seem to collapse at 0.00004; linear geometry, with joints that do not give
 * way, has 0.349, and these joints, bent as 40 even pairs bend them, 0.3025. */
static void
test_rocking_sill (void)
{
  double multiplier = collapse_of_wall (
    "length=3.2", "height=2.8", "\"at\": [0.5, 0.8], \"width\": 0.6, \"height\": 0.8",
    "\"at\": [1.9, 0.6], \"width\": 1, \"height\": 1.2", "2e9");
  g_assert_cmpfloat_with_epsilon (multiplier, 0.3025, 0.01 * 0.3025);
}

/* Ctrl+C during a large analysis: the code is 130 and a file that was written is a whole one. */
static void
test_interrupt (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = g_build_filename (folder, "large.quoin", NULL);
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  const char *command[] = {
    g_getenv ("QUOIN_CLI"), "solve", model, "-q", "-o", result, NULL
  };
  cli_do ("generate", "wall", "length=20", "height=10", "-o", model, NULL);
  g_autoptr (GError) error = NULL;
  GPid pid;
  int status = 0;
  g_spawn_async (NULL, (char **) command, NULL,
                 G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL, &pid,
                 &error);
  g_assert_no_error (error);
  wait_for_handler (pid);
  kill (pid, SIGINT);
  g_assert_cmpint (waitpid (pid, &status, 0), ==, pid);
  g_assert_true (WIFEXITED (status));
  g_assert_cmpint (WEXITSTATUS (status), ==, 130);
  if (g_file_test (result, G_FILE_TEST_EXISTS)) {
    g_autofree char *json = cli_read (result);
    g_assert_nonnull (strstr (json, "\"cancelled\""));
    g_assert_true (g_str_has_suffix (json, "}\n"));
  }
}

/* A column that is loaded beyond its Euler load has lost its stability, whatever the path reaches: summary,
 * reason, event and curve say so, with the multiplier. */
static void
test_buckling (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *column =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "35-beam-column.quoin", NULL);
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  g_autofree char *curve = g_build_filename (folder, "c.csv", NULL);
  static const char *const procedures[] = { "analysis.procedure=load",
                                            "analysis.procedure=work" };
  for (gsize i = 0; i < G_N_ELEMENTS (procedures); i++) {
    cli_says ("stability is lost at load multiplier 617.38", "solve", column, "--set",
              procedures[i], "-o", result, NULL);
    g_autofree char *written = cli_read (result);
    g_assert_nonnull (strstr (written, "\"kind\": \"buckling\""));
    cli_do ("check", column, "--set", procedures[i], "--result", result, NULL);
    g_autofree char *both = g_strconcat (column, "=", result, NULL);
    cli_do ("curve", both, "-o", curve, NULL);
    g_autofree char *rows = cli_read (curve);
    g_assert_nonnull (strstr (rows, "limit point"));
  }
}

QN_TESTS
{
  g_test_add_func ("/cli/limit/sensitivity", test_sensitivity);
  g_test_add_func ("/cli/solve/standard-output", test_standard_output);
  g_test_add_func ("/cli/solve/door-without-lintel", test_door_without_lintel);
  g_test_add_func ("/cli/solve/set", test_set);
  g_test_add_func ("/cli/solve/set-is-repeatable", test_set_is_repeatable);
  g_test_add_func ("/cli/solve/ends-at-target", test_ends_at_target);
  g_test_add_func ("/cli/solve/five-pairs", test_five_pairs);
  g_test_add_func ("/cli/solve/ends-behind-peak", test_ends_behind_peak);
  g_test_add_func ("/cli/solve/peak", test_peak);
  g_test_add_func ("/cli/solve/bad-set", test_bad_set);
  g_test_add_func ("/cli/solve/quiet-warns", test_quiet_warns);
  g_test_add_func ("/cli/solve/outputs", test_outputs);
  g_test_add_func ("/cli/solve/same-bytes", test_same_bytes);
  g_test_add_func ("/cli/solve/locale", test_locale);
  g_test_add_func ("/cli/solve/unwritable", test_unwritable);
  g_test_add_func ("/cli/solve/old-result-stays", test_old_result_stays);
  g_test_add_func ("/cli/solve/snap-stop", test_snap_stop);
  g_test_add_func ("/cli/solve/budgets", test_budgets);
  g_test_add_func ("/cli/solve/stiff-joints", test_stiff_joints);
  g_test_add_func ("/cli/solve/limit-of-beams", test_limit_of_beams);
  g_test_add_func ("/cli/solve/limit-without-dead-load", test_limit_without_dead_load);
  g_test_add_func ("/cli/solve/block-on-an-edge", test_block_on_an_edge);
  g_test_add_func ("/cli/solve/rocking-sill", test_rocking_sill);
  g_test_add_func ("/cli/solve/buckling", test_buckling);
  g_test_add_func ("/cli/solve/interrupt", test_interrupt);
}
