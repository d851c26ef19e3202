/* generate, import and export: models in and out. */
#include "cli-run.h"
#include "support/room.h"
#include "support/table.h"

#include <string.h>

static char *
file_in (const char *folder, const char *name)
{
  return g_build_filename (folder, name, NULL);
}

static void
test_generate (void)
{
  static const char *const kinds[] = { "wall",   "arch",   "column", "buttress",
                                       "portal", "rubble", "grid",   "voronoi" };
  test_autoscratch char *folder = test_scratch_new ();
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = file_in (folder, kinds[i]);
    cli_do ("generate", kinds[i], "-o", path, NULL);
    /* Cells of an elastic material have no strength. */
    cli_do (i < 6 ? "limit" : "solve", path, NULL);
  }
}

static void
test_generate_keys (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = file_in (folder, "wall.quoin");
  cli_do ("generate", "wall", "--length", "3", "unit=0.5x0.25", "--bond=flemish", "-o",
          path, NULL);
  g_autofree char *text = cli_read (path);
  g_assert_nonnull (strstr (text, "\"length\": 3"));
  g_assert_nonnull (strstr (text, "\"unit\": [0.5, 0.25]"));
  g_assert_nonnull (strstr (text, "\"flemish\""));

  /* A number as people write it; a member that excludes a default takes its place. */
  cli_do ("generate", "wall", "foundation=.3", "unit=.5x.25", "-o", path, NULL);
  g_autofree char *short_numbers = cli_read (path);
  g_assert_nonnull (strstr (short_numbers, "\"foundation\": 0.3"));
  g_assert_nonnull (strstr (short_numbers, "\"unit\": [0.5, 0.25]"));
  cli_do ("generate", "portal", "arch.shape=\"circular\"", "arch.rise=0.5",
          "arch.ring=0.3", "arch.voussoirs=9", "-o", path, NULL);
  g_autofree char *portal = cli_read (path);
  g_assert_nonnull (strstr (portal, "\"arch\""));
  g_assert_null (strstr (portal, "\"lintel\""));

  cli_fails (2, "lenth", "generate", "wall", "lenth=3", "-o", path, NULL);
  cli_fails (3, "length", "generate", "wall", "length=-3", "-o", path, NULL);
  cli_fails (2, "wall", "generate", "tower", "-o", path, NULL);
  cli_fails (2, "-o", "generate", "wall", NULL);
}

/* DXF to a project and back gives the same project again. */
static void
test_round_trip (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *drawing = cli_example ("dxf/wall-clean.dxf");
  g_autofree char *first = file_in (folder, "first.quoin");
  g_autofree char *back = file_in (folder, "back.dxf");
  g_autofree char *second = file_in (folder, "second.quoin");
  cli_says ("blocks: 47", "import", drawing, "-o", first, "--report", NULL);
  cli_do ("export", first, "--unit", "mm", "-o", back, NULL);
  cli_do ("import", back, "-o", second, NULL);
  g_autofree char *a = cli_read (first), *b = cli_read (second);
  g_assert_cmpstr (a, ==, b);
}

/* Joints of mortar are told of, closed or filled; what is left open is told again by the check. */
static void
test_mortar (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *drawing = cli_example ("dxf/wall-mortar.dxf");
  g_autofree char *path = file_in (folder, "wall.quoin");
  static const struct {
    const char *options[2], *told, *checked;
  } cases[] = {
    { { NULL }, "left open", "158 joints of mortar" },
    { { "--close-joints", "0.02" }, "closed: blocks grew", "contact faces: 158" },
    { { "--close-joints", "0" }, "closed: blocks grew", "contact faces: 158" },
    { { "--mortar-joints", "0.02" }, "each became a block", "contact faces: 316" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    cli_says (cases[i].told, "import", drawing, "-o", path, "--report",
              cases[i].options[0], cases[i].options[1], NULL);
    CliRun run = cli_run ("check", path, NULL);
    g_assert_nonnull (strstr (run.out, cases[i].checked));
    g_assert_true ((strstr (run.out, "joints of mortar") != NULL) == (i == 0));
    cli_run_clear (&run);
  }
  cli_fails (2, "exclude", "import", drawing, "-o", path, "--close-joints", "0.02",
             "--mortar-joints", "0.02", NULL);
}

static void
test_export_results (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", cli_sliding_block);
  g_autofree char *result = file_in (folder, "result.json");
  cli_do ("solve", model, "-q", "-o", result, NULL);
  static const char *const outputs[] = { "out.dxf", "out.pvd", "out.csv" };
  for (size_t i = 0; i < G_N_ELEMENTS (outputs); i++) {
    g_autofree char *output = file_in (folder, outputs[i]);
    cli_do ("export", model, "--result", result, "-o", output, NULL);
    g_autofree char *text = cli_read (output);
    g_assert_cmpuint (strlen (text), >, 50);
  }
  cli_fails (2, "--result", "export", model, "-o", "out.csv", NULL);
  cli_fails (2, ".dxf", "export", model, "-o", "out.stl", NULL);
}

/* Walls and masonry become polygons of the same names; nothing else is changed. */
static void
test_export_polygons (void)
{
  static const char *const models[] = { "14-pointed-arch.quoin",
                                        "ferris-tin-loi/wall3.quoin",
                                        "01-sliding-block.quoin" };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *polygons = file_in (folder, "polygons.quoin");
  for (gsize i = 0; i < G_N_ELEMENTS (models); i++) {
    g_autofree char *model = cli_example (models[i]);
    cli_do ("export", model, "-o", polygons, NULL);
    g_autofree char *text = cli_read (polygons);
    g_assert_null (strstr (text, "\"masonry\""));
    g_assert_null (strstr (text, "\"walls\""));
    CliRun before = cli_run ("check", model, NULL),
           after = cli_run ("check", polygons, NULL);
    g_assert_cmpstr (strchr (before.out, '\n'), ==, strchr (after.out, '\n'));
    cli_run_clear (&before);
    cli_run_clear (&after);
  }
}

static void
test_bad_import (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bad = cli_write (folder, "bad.dxf", "0\nSECTION\n2\nENTITIES\nLINE\n");
  g_autofree char *output = file_in (folder, "out.quoin");
  cli_fails (3, "bad.dxf:5: ", "import", bad, "-o", output, NULL);
  cli_fails (5, "missing.dxf", "import", "missing.dxf", "-o", output, NULL);
  cli_fails (2, "--unit", "import", bad, "--unit", "parsec", "-o", output, NULL);
}

/* Two bars hold a block, nothing else does: 100 kN on 400 mm2 are 250 MPa in both, and both yield. */
static void
test_export_bars (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (
    folder, "tie.quoin",
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"concrete\", "
    "\"kind\": "
    "\"no-tension\", \"basis\": \"material\", \"kn\": 3e10, \"ks\": 3e10 }, { \"name\": "
    "\"steel\", \"kind\": \"elastic-plastic\", \"basis\": \"material\", \"kn\": 2e11, "
    "\"ks\": 8e10, \"yield\": 5e8 } ], \"blocks\": [ { \"name\": \"held\", \"vertices\": "
    "[[0, "
    "0], [1, 0], [1, 0.2], [0, 0.2]], \"thickness\": 0.2, \"unit_weight\": 0, "
    "\"support\": "
    "[true, true, true] }, { \"name\": \"pulled\", \"vertices\": [[1, 0], [2, 0], [2, "
    "0.2], "
    "[1, 0.2]], \"thickness\": 0.2, \"unit_weight\": 0 } ], \"bars\": [ { \"law\": "
    "\"steel\", "
    "\"area\": 1e-4, \"start\": [0.5, 0.05], \"end\": [1.5, 0.05] }, { \"law\": "
    "\"steel\", "
    "\"area\": 3e-4, \"start\": [0.5, 0.15], \"end\": [1.5, 0.15] } ], \"contact\": { "
    "\"law\": "
    "\"concrete\" }, \"loads\": { \"live\": [ { \"kind\": \"force\", \"block\": "
    "\"pulled\", "
    "\"at\": [1.5, 0.125], \"value\": [1000, 0] } ] }, \"analysis\": { "
    "\"max_multiplier\": 100 "
    "} }");
  g_autofree char *result = file_in (folder, "tie.json"),
                  *csv = file_in (folder, "b.csv");
  for (int yields = 0; yields < 2; yields++) {
    cli_do ("solve", model, "-q", "-o", result, "--set",
            yields ? "analysis.max_multiplier=300" : "analysis.max_multiplier=100", NULL);
    cli_do ("export", model, "--result", result, "--table", "bars", "-o", csv,
            yields ? "--set=analysis.max_multiplier=300"
                   : "--set=analysis.max_multiplier=100",
            NULL);
    g_autofree char *text = cli_read (csv);
    g_autoptr (GPtrArray) table = test_table_read (text);
    g_assert_cmpuint (table->len, ==, 3);
    for (guint bar = 0; bar < 2; bar++) {
      const double stress = yields ? 5e8 : 2.5e8, area = bar == 0 ? 1e-4 : 3e-4;
      g_assert_cmpfloat_with_epsilon (test_table_number (table, bar + 1, "stress [Pa]"),
                                      stress, 1e-6 * stress);
      g_assert_cmpfloat_with_epsilon (test_table_number (table, bar + 1, "force [N]"),
                                      stress * area, 1e-6 * stress * area);
      g_assert_cmpfloat (test_table_number (table, bar + 1, "x [m]"), ==, 1);
    }
    g_assert_true ((strstr (text, ",yield\n") != NULL) == (yields == 1));
  }
}

QN_TESTS
{
  g_test_add_func ("/cli/exchange/generate", test_generate);
  g_test_add_func ("/cli/exchange/generate-keys", test_generate_keys);
  g_test_add_func ("/cli/exchange/round-trip", test_round_trip);
  g_test_add_func ("/cli/exchange/mortar", test_mortar);
  g_test_add_func ("/cli/exchange/export-results", test_export_results);
  g_test_add_func ("/cli/exchange/export-bars", test_export_bars);
  g_test_add_func ("/cli/exchange/export-polygons", test_export_polygons);
  g_test_add_func ("/cli/exchange/bad-import", test_bad_import);
}
