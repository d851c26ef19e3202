/* Load stages, settlements and reasons on the command line. */
#include "cli-run.h"
#include "support/room.h"

#include <string.h>

static char *
example (const char *name)
{
  return g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
}

/* One error line with the key, exit code 3. */
static void
test_refused (void)
{
  static const struct {
    const char *model, *set, *expected;
  } cases[] = {
    { "16-load-stages.quoin", "analysis.stages=[{\"loads\":\"wind\",\"target\":1}]",
      "no load set has this name: \"wind\"" },
    { "16-load-stages.quoin", "analysis.stages=[{\"loads\":[],\"target\":1}]",
      "stage applies no load set" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":[\"top\",\"top\"],\"target\":1}]",
      "load set is named twice" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"top\"},{\"loads\":\"push\",\"target\":1}]",
      "target is missing: only the last stage may end by collapse" },
    { "16-load-stages.quoin", "analysis.stages=[{\"loads\":\"top\",\"target\":0}]",
      "stage ends where it begins" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"top\",\"target\":1},{\"loads\":[\"top\",\"push\"],"
      "\"target\":2}]",
      "load sets of the stage have different multipliers" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"push\",\"procedure\":\"displacement\"}]",
      "procedure needs a control block and target" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"push\",\"target\":1,\"control\":{\"block\":\"b6\","
      "\"component\":\"ux\",\"target\":0.1}}]",
      "stage ends at a multiplier or at a displacement, not at both" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"push\",\"procedure\":\"displacement\",\"control\":{"
      "\"block\":\"base\",\"component\":\"ux\",\"target\":0.1}}]",
      "controlled degree of freedom is fixed" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"push\",\"procedure\":\"displacement\",\"control\":{"
      "\"block\":\"b77\",\"component\":\"ux\",\"target\":0.1}}]",
      "no block has this name" },
    { "16-load-stages.quoin",
      "analysis.stages=[{\"loads\":\"push\",\"procedure\":\"limit\"}]",
      "limit analysis has no stages" },
    { "16-load-stages.quoin", "analysis.procedure=limit",
      "limit analysis has no stages" },
    { "16-load-stages.quoin", "analysis.max_multiplier=2",
      "stages have targets of their own" },
    { "18-spreading-arch.quoin", "loads.live[0].block=v3",
      "only a supported degree of freedom can settle" },
    { "18-spreading-arch.quoin", "analysis.procedure=work",
      "work control needs loads: settlements do no work" },
    { "18-spreading-arch.quoin", "analysis.procedure=limit",
      "limit analysis covers loads, not settlements" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *path = example (cases[i].model);
    CliRun run = cli_run ("check", path, "--set", cases[i].set, NULL);
    g_test_message ("%s", run.err);
    g_assert_cmpint (run.code, ==, 3);
    g_assert_nonnull (strstr (run.err, cases[i].expected));
    g_assert_cmpstr (strchr (run.err, '\n'), ==, "\n");
    cli_run_clear (&run);
  }
}

/* A target on the wrong side is found when the analysis begins. */
static void
test_wrong_sign (void)
{
  g_autofree char *path = example ("02-overturning-block.quoin");
  g_auto (CliRun) run = cli_run (
    "solve", path, "--set", "analysis.procedure=displacement", "--set",
    "analysis.control={\"block\":\"block\",\"component\":\"ux\",\"target\":-0.05}", NULL);
  g_assert_cmpint (run.code, ==, 3);
  g_assert_nonnull (strstr (run.err, "target is opposite to the motion"));
  g_assert_nonnull (strstr (run.err, "analysis.control"));
}

static void
test_tables (void)
{
  g_autofree char *staged = example ("17-unloading.quoin");
  g_autofree char *settling = example ("18-spreading-arch.quoin");
  CliRun run = cli_run ("solve", staged, "-q", "--csv", "-", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, ",event,stage,cycle,work [J]\n"));
  g_assert_nonnull (strstr (run.out, ",release,,"));
  cli_run_clear (&run);
  cli_says ("right abutment ux [m],right abutment Rx [N]\n", "solve", settling, "-q",
            "--csv", "-", NULL);
}

/* A cyclic protocol: the energy of each cycle in words, in the result, and as the work of the table. */
static void
test_cycles (void)
{
  g_autofree char *block = example ("01-sliding-block.quoin");
  const char *set =
    "analysis.stages=[{\"name\":\"shear\",\"loads\":\"live\",\"procedure\":"
    "\"displacement\","
    "\"increments\":10,\"control\":{\"block\":\"block\",\"component\":\"ux\"},"
    "\"amplitudes\":[0.001],\"cycles\":2}]";
  CliRun run = cli_run ("solve", block, "--set", set, "--csv", "-", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, ",shear 1+,1,"));
  g_assert_nonnull (strstr (run.out, ",shear 2 0,2,"));
  cli_run_clear (&run);
  cli_says ("cycle 2: load multiplier from", "solve", block, "--set", set, NULL);
  run = cli_run ("solve", block, "-q", "--set", set, "-o", "-", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (
    strstr (run.out, "\"stage\": 3, \"cycle\": 2, \"lowest_multiplier\""));
  cli_run_clear (&run);
}

static void
test_reasons (void)
{
  g_autofree char *staged = example ("16-load-stages.quoin");
  g_autofree char *settling = example ("18-spreading-arch.quoin");
  g_autofree char *block = example ("02-overturning-block.quoin");
  CliRun run = cli_run ("solve", staged, "-q", "-o", "-", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "\"reason\": \"Stage 2 of 2, “push”. Collapse"));
  g_assert_nonnull (strstr (run.out, "\"stages\": [\"load on top\", \"push\"]"));
  g_assert_nonnull (strstr (run.out, "\"stage\": 0"));
  g_assert_nonnull (strstr (run.out, "\"reactions\": [["));
  cli_run_clear (&run);
  cli_says ("The supports have settled to their targets", "solve", settling, NULL);

  /* Nothing drives a path without live loads: refused, unless the dead load alone is wanted. */
  cli_fails (3, "analysis.max_multiplier=0", "solve", block, "--set", "loads.live=[]",
             NULL);
  cli_fails (3, "no live load acts on any free block", "solve", block, "--set",
             "loads.live=[]", "--set", "analysis.procedure=arc-length", NULL);
  cli_says ("No live load acts on any free block", "solve", block, "--set",
            "loads.live=[]", "--set", "analysis.max_multiplier=0", NULL);
  cli_fails (2, "the same file", "solve", block, "-o", "a.json", "--csv", "./a.json",
             NULL);
  cli_run_clear (&run);
  run = cli_run ("solve", block, "--set", "analysis.max_multiplier=0.1", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (
    strstr (run.out, "The load multiplier has reached its end value of 0.1"));
  cli_run_clear (&run);
}

static void
test_stability (void)
{
  g_autofree char *column = example ("21-column-pinned.quoin");
  g_autofree char *staged = example ("16-load-stages.quoin");
  cli_says ("stability is lost at load multiplier 2470", "stability", column, NULL);
  cli_says ("stable along the whole path", "stability", column, "--set",
            "analysis.max_multiplier=2000", NULL);
  g_auto (CliRun) run =
    cli_run ("stability", staged, "--set", "analysis.geometry=nonlinear", NULL);
  g_assert_cmpint (run.code, ==, 3);
  g_assert_nonnull (strstr (run.err, "not along stages"));
}

/* In linear geometry every column would be stable. */
static void
test_stability_linear (void)
{
  g_autofree char *example = cli_example ("20-column-free.quoin");
  cli_fails (
    3,
    "20-column-free.quoin: analysis.geometry: linear geometry has no buckling: set it "
    "to nonlinear (set by",
    "stability", example, "--set", "analysis.geometry=linear", NULL);

  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = cli_read (example);
  g_autofree char *linear = cli_replace (text, "\"nonlinear\"", "\"linear\"");
  g_autofree char *path = cli_write (folder, "linear.quoin", linear);
  cli_fails (3, "linear.quoin:43:49: analysis.geometry: linear geometry has no buckling",
             "stability", path, NULL);
}

/* The quick groups of the published cases. */
static void
test_verify (void)
{
  g_auto (CliRun) run = cli_run ("verify", "-q", "members", "stages", "columns",
                                 "rocking", "vibrations", NULL);
  cli_assert_done (&run);
  g_assert_null (strstr (run.out, "MISSED"));
  g_assert_nonnull (strstr (run.out, "19 met, 0 missed, 3 reported only."));
}

/* A wall whose mechanism was not settled bears a sign, and its footnote is there. */
static void
test_verify_uncertain (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  CliRun run = cli_run ("verify", "-q", "walls", "--keep", folder, NULL);
  cli_assert_done (&run);
  gboolean any = FALSE;
  for (int wall = 1; wall <= 6; wall++) {
    g_autofree char *row = g_strdup_printf ("\nWall %d‡ ", wall);
    g_autofree char *path = g_strdup_printf ("%s/walls/wall%d.json", folder, wall);
    g_autofree char *result = cli_read (path);
    gboolean uncertain = strstr (result, "\"mechanism_uncertain\": true") != NULL;
    g_assert_cmpint (strstr (run.out, row) != NULL, ==, uncertain);
    any = any || uncertain;
  }
  g_assert_cmpint (strstr (run.out, "\n‡ How the structure") != NULL, ==, any);
  cli_run_clear (&run);
}

/* A loss of stability is told of every stage: in text, events, curve and table, and the check of the result
 * finds its step. */
static void
test_buckled_before (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = example ("35-beam-column.quoin");
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  g_autofree char *table = g_build_filename (folder, "r.csv", NULL);
  g_autofree char *item = g_strconcat (model, "=", result, NULL);
  g_autofree char *curve = g_build_filename (folder, "c.csv", NULL);
  static const char *const stages[] = {
    "analysis={\"geometry\":\"nonlinear\",\"stages\":[{\"loads\":\"live\",\"target\":700}"
    "]}",
    "analysis={\"geometry\":\"nonlinear\",\"stages\":[{\"loads\":\"live\",\"target\":700}"
    ","
    "{\"loads\":\"live\",\"target\":10}]}",
  };
  for (size_t i = 0; i < G_N_ELEMENTS (stages); i++) {
    cli_says (i == 0 ? "Stability is lost at a load multiplier of 617.3"
                     : "Stability was lost in stage 1, at a load multiplier of 617.3",
              "solve", model, "--set", stages[i], "-o", result, "--csv", table, NULL);
    cli_do ("check", model, "--result", result, NULL);
    g_autofree char *json = cli_read (result), *rows = cli_read (table);
    g_assert_nonnull (strstr (json, "\"kind\": \"buckling\", \"stage\": 0"));
    g_assert_nonnull (strstr (rows, "buckling"));
    cli_do ("curve", item, "-o", curve, NULL);
    g_autofree char *points = cli_read (curve);
    const char *point = strstr (points, "limit point");
    g_assert_nonnull (point);
    while (point > points && point[-1] != '\n')
      point--;
    g_assert_nonnull (g_strstr_len (point, 80, ",617.3"));
  }
}

/* Twelve stages may take twelve times as many factorisations as an analysis without: 468. */
static void
test_budget (void)
{
  g_autofree char *panel = example ("46-cyclic-panel.quoin");
  cli_says ("stage 12,", "solve", panel, "--set", "analysis.max_factorizations=100",
            NULL);
  cli_fails (4, "Stage 1 of 12, “cycles 1+”. Stopped at a load multiplier of", "solve",
             panel, "--set", "analysis.max_factorizations=10", NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/stages/refused", test_refused);
  g_test_add_func ("/cli/stages/wrong-sign", test_wrong_sign);
  g_test_add_func ("/cli/stages/tables", test_tables);
  g_test_add_func ("/cli/stages/cycles", test_cycles);
  g_test_add_func ("/cli/stages/budget", test_budget);
  g_test_add_func ("/cli/stages/reasons", test_reasons);
  g_test_add_func ("/cli/stages/stability", test_stability);
  g_test_add_func ("/cli/stages/stability-linear", test_stability_linear);
  g_test_add_func ("/cli/stages/buckled-before", test_buckled_before);
  g_test_add_func ("/cli/stages/verify", test_verify);
  g_test_add_func ("/cli/stages/verify-uncertain", test_verify_uncertain);
}
