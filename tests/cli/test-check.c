/* quoin-cli check: what it lists, and the independent check of a result. */
#include "cli-run.h"
#include "support/room.h"

#include <string.h>

typedef struct Counts {
  const char *wall;
  guint free_blocks, faces;
} Counts;

/* The walls' counts as the literature has them; each stands on one fixed block more. */
static const Counts counts[] = {
  { "1", 33, 83 },  { "2", 55, 141 }, { "3", 46, 102 },
  { "4", 55, 116 }, { "5", 61, 120 }, { "6", 146, 345 },
};

static void
test_counts (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (counts); i++) {
    g_autofree char *name =
      g_strdup_printf ("ferris-tin-loi/wall%s.quoin", counts[i].wall);
    g_autofree char *model = cli_example (name);
    g_autofree char *blocks = g_strdup_printf ("blocks: %u,", counts[i].free_blocks + 1);
    g_autofree char *faces = g_strdup_printf ("contact faces: %u,", counts[i].faces);
    g_autofree char *pairs = g_strdup_printf ("contact pairs: %u\n", 2 * counts[i].faces);
    CliRun run = cli_run ("check", model, NULL);
    cli_assert_done (&run);
    g_assert_nonnull (strstr (run.out, blocks));
    g_assert_nonnull (strstr (run.out, faces));
    g_assert_nonnull (strstr (run.out, pairs));
    g_assert_nonnull (strstr (run.out, "warnings: none"));
    g_assert_nonnull (strstr (run.out, "base (ux, uy, rz)"));
    cli_run_clear (&run);
  }
}

static guint
count_of (const char *text, const char *part)
{
  guint count = 0;
  for (const char *at = text; (at = strstr (at, part)) != NULL; at++)
    count++;
  return count;
}

static void
test_json (void)
{
  g_autofree char *model = cli_example ("ferris-tin-loi/wall1.quoin");
  CliRun run = cli_run ("check", model, "--json", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "\"quoin-check\""));
  g_assert_nonnull (strstr (run.out, "\"sound\": true"));
  g_assert_cmpuint (count_of (run.out, "{ \"name\": "), ==, 34);
  g_assert_cmpuint (count_of (run.out, "\"normal\": "), ==, 83);
  g_assert_cmpuint (count_of (run.out, "\"tributary\": "), ==, 166);
  cli_run_clear (&run);
}

/* What cannot be analysed is reported before it is refused. */
static void
test_unsound (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text =
    cli_replace (cli_sliding_block, "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]",
                 "[[0, 1], [1, 1], [1, 1.5], [0, 1.5]]");
  g_autofree char *model = cli_write (folder, "wall.quoin", text);
  CliRun run = cli_run ("check", model, NULL);
  g_assert_nonnull (strstr (run.out, "warnings: "));
  g_assert_nonnull (strstr (run.out, "stone"));
  cli_assert_failed (&run, 3, "stone");

  run = cli_run ("check", model, "--json", NULL);
  g_assert_nonnull (strstr (run.out, "\"sound\": false"));
  cli_assert_failed (&run, 3, "stone");
}

/* A gap a little wider than the tolerance is told with its place, and is no error. */
static void
test_gap (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = cli_replace (
    cli_sliding_block, "\"thickness\": 1, \"unit_weight\": 10000 }\n",
    "\"thickness\": 1, \"unit_weight\": 10000 },\n"
    "    { \"name\": \"next\", \"vertices\": [[1.000003, 0], [1.5, 0], "
    "[1.5, 0.5], [1.000003, 0.5]], \"thickness\": 1, \"unit_weight\": 10000 }\n");
  g_autofree char *model = cli_write (folder, "wall.quoin", text);
  CliRun run = cli_run ("check", model, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "warnings: 1"));
  g_assert_nonnull (strstr (run.out, "next"));
  cli_run_clear (&run);
}

/* A load that lifts what it should press on is told. */
static void
test_pulling_edge (void)
{
  static const char *const told = "pulls the block outwards";
  test_autoscratch char *folder = test_scratch_new ();
  for (int pulls = 0; pulls < 2; pulls++) {
    g_autofree char *load =
      g_strdup_printf ("{ \"kind\": \"weight\", \"direction\": [0, -1] }, { \"kind\": "
                       "\"edge\", \"block\": "
                       "\"stone\", \"side\": \"top\", \"intensity\": %s }",
                       pulls ? "-20" : "20");
    g_autofree char *text = cli_replace (
      cli_sliding_block, "{ \"kind\": \"weight\", \"direction\": [0, -1] }", load);
    g_autofree char *model = cli_write (folder, "m.quoin", text);
    CliRun run = cli_run ("check", model, NULL);
    cli_assert_done (&run);
    g_assert_true ((strstr (run.out, told) != NULL) == (pulls == 1));
    cli_run_clear (&run);
  }
}

/* Numbers that are hardly meant: in check for people and programs, and in every analysis, with -q too. */
static void
test_doubts (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  static const char *const rows[][4] = {
    { "\"friction\": 0.4", "\"friction\": 30", "laws[0].friction: 30, where 0.02 to 3",
      "degrees" },
    { "\"unit_weight\": 10000 }\n", "\"unit_weight\": 20 }\n",
      "blocks[1].unit_weight: 20 N/m3, where", "kN/m3" },
    { "\"kn\": 1e7", "\"kn\": 1e3", "laws[0].kn: 1000 N/m, where", "kN" },
    { "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]", "[[0, 0], [99, 0], [99, 500], [0, 500]]",
      "blocks[1].vertices: 500 m, where 0.002 to 30", "mm" },
    { "{ \"kind\": \"weight\", \"direction\": [0, -1] }", "", "loads.dead: no dead load",
      "is 0" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *text = cli_replace (cli_sliding_block, rows[i][0], rows[i][1]);
    g_autofree char *model = cli_write (folder, "m.quoin", text);
    const char *const commands[][3] = { { "check", NULL, NULL },
                                        { "solve", "-q", NULL },
                                        { "limit", "-q", NULL } };
    for (gsize k = 0; k < G_N_ELEMENTS (commands); k++) {
      g_auto (CliRun) run = cli_run (commands[k][0], model, commands[k][1], NULL);
      const char *said = k == 0 ? run.out : run.err;
      const char *found = strstr (said, rows[i][2]);
      g_test_message ("%s: %s", commands[k][0], said);
      g_assert_nonnull (found);
      g_assert_nonnull (strstr (found, rows[i][3]));
    }
  }
  g_autofree char *text = cli_replace (cli_sliding_block, rows[0][0], rows[0][1]);
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  cli_says ("\"problem\": \"doubt-tangent\"", "check", model, "--json", NULL);
}

static void
test_result (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("06-arch.quoin");
  g_autofree char *result = g_build_filename (folder, "arch.json", NULL);
  cli_do ("solve", model, "-q", "-o", result, NULL);

  cli_says ("passes", "check", model, "--result", result, NULL);

  /* The same forces at another multiplier are no equilibrium. */
  g_autofree char *json = cli_read (result);
  g_autofree char *forged =
    cli_replace (json, "\"collapse_multiplier\": ", "\"collapse_multiplier\": 1");
  g_autofree char *wrong = cli_write (folder, "wrong.json", forged);
  CliRun run = cli_run ("check", model, "--result", wrong, NULL);
  g_assert_nonnull (strstr (run.out, "fails"));
  cli_assert_failed (&run, 3, "wrong.json");

  cli_says ("\"passes\": true", "check", model, "--json", "--result", result, NULL);

  /* A result of another model. */
  g_autofree char *other = cli_example ("05-stack.quoin");
  cli_fails (3, NULL, "check", other, "--result", result, NULL);
}

/* What Poisson's ratio 0.2 misses in a grid: nu/(1 - nu) and nu2. */
static void
test_poisson (void)
{
  g_autofree char *model = cli_example ("52-reinforced-wall.quoin");
  cli_says ("both are 25 % too large, stiffness between rigid sides 4 % too low", "check",
            model, NULL);
}

/* Of a strip of 17 mm2 on 100 mm: t = A / b, and b t sqrt (2 E G / t) = 0.1 sqrt (2 * 2.3e11 * 300 * 1.7e-4). */
static void
test_strip (void)
{
  g_autofree char *model = cli_example ("63-strip-of-fibres.quoin");
  cli_says ("strip 0.17 mm thick debonds at 15316.7 N", "check", model, NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/check/pulling-edge", test_pulling_edge);
  g_test_add_func ("/cli/check/counts", test_counts);
  g_test_add_func ("/cli/check/poisson", test_poisson);
  g_test_add_func ("/cli/check/json", test_json);
  g_test_add_func ("/cli/check/unsound", test_unsound);
  g_test_add_func ("/cli/check/gap", test_gap);
  g_test_add_func ("/cli/check/doubts", test_doubts);
  g_test_add_func ("/cli/check/result", test_result);
  g_test_add_func ("/cli/check/strip", test_strip);
}
