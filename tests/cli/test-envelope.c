/* quoin-cli envelope: mirror images, refined positions, vehicles, and the faults of early bridge programs. */
#include "cli-run.h"

#include "support/room.h"

#include <math.h>
#include <string.h>

/* Multipliers by position: rows of position, to the right, to the left; what is empty is not a number. */
typedef struct Row {
  double x, m[2];
} Row;

static GArray *
read_rows (const char *path)
{
  g_autofree char *text = cli_read (path);
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  GArray *rows = g_array_new (FALSE, FALSE, sizeof (Row));
  for (int i = 1; lines[i] != NULL && lines[i][0] != '\0'; i++) {
    g_auto (GStrv) cells = g_strsplit (lines[i], ",", -1);
    Row row = { g_ascii_strtod (cells[0], NULL), { NAN, NAN } };
    for (guint way = 0; way < 2 && way + 1 < g_strv_length (cells); way++)
      if (cells[way + 1][0] != '\0')
        row.m[way] = g_ascii_strtod (cells[way + 1], NULL);
    g_array_append_val (rows, row);
  }
  return rows;
}

static double
least (const GArray *rows)
{
  double found = INFINITY;
  for (guint i = 0; i < rows->len; i++)
    for (int way = 0; way < 2; way++)
      found = fmin (found, g_array_index (rows, Row, i).m[way]);
  return found;
}

/* The least multiplier of the example with one key set, over a few positions. */
static double
least_with (const char *set)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  g_autofree char *csv = g_build_filename (folder, "e.csv", NULL);
  cli_do ("envelope", bridge, "--from", "3", "--to", "5", "--step", "1", "-q", "--csv",
          csv, "--set", set, NULL);
  g_autoptr (GArray) rows = read_rows (csv);
  return least (rows);
}

/* Multiplier of the bridge that was tested, with one key set. */
static double
limit_with (const char *set)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("55-tested-bridge.quoin");
  g_autofree char *csv = g_build_filename (folder, "e.csv", NULL);
  cli_do ("envelope", bridge, "--from", "1.225", "--to", "1.225", "--one-way", "-q",
          "--csv", csv, "--set", set, NULL);
  g_autoptr (GArray) rows = read_rows (csv);
  return least (rows);
}

/* With plain friction no vehicle is carried that associated flow does not bound; the joints of the
 * abutment slide, so that less is. */
static void
test_flow (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  double found[2];
  for (int i = 0; i < 2; i++) {
    g_autofree char *csv = g_build_filename (folder, "f.csv", NULL);
    cli_do ("envelope", bridge, "--from", "5.45", "--to", "5.45", "-q", "--csv", csv,
            "--set",
            i == 0 ? "analysis.flow=associative" : "analysis.flow=non-associative", NULL);
    g_autoptr (GArray) rows = read_rows (csv);
    found[i] = least (rows);
  }
  g_assert_cmpfloat (found[1], <, 0.99 * found[0]);
  g_assert_cmpfloat (found[1], >, 0.9 * found[0]);
}

/* The bridge is symmetric about x = 5: what goes to the right there goes to the left here. Positions
 * half as far apart hold the same multipliers, and a least one that is not larger. */
static void
test_mirror (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  g_autofree char *coarse = g_build_filename (folder, "c.csv", NULL);
  g_autofree char *fine = g_build_filename (folder, "f.csv", NULL);
  g_autofree char *svg = g_build_filename (folder, "e.svg", NULL);
  cli_do ("envelope", bridge, "--from", "2", "--to", "8", "--step", "1", "-q", "--csv",
          coarse, NULL);
  cli_says ("adequacy factor 4.7", "envelope", bridge, "--from", "2", "--to", "8",
            "--step", "0.5", "--csv", fine, "-o", svg, NULL);
  g_autoptr (GArray) a = read_rows (coarse);
  g_autoptr (GArray) b = read_rows (fine);
  cli_says ("bounds from above where joints slide", "envelope", bridge, "--from", "5",
            "--to", "5", NULL);
  g_assert_cmpuint (a->len, ==, 7);
  g_assert_cmpuint (b->len, ==, 13);
  for (guint i = 0; i < a->len; i++) {
    Row row = g_array_index (a, Row, i), mirror = g_array_index (a, Row, a->len - 1 - i);
    g_assert_cmpfloat_with_epsilon (row.m[0], mirror.m[1], 1e-6 * row.m[0]);
    g_assert_cmpfloat (row.m[0], ==, g_array_index (b, Row, 2 * i).m[0]);
  }
  g_assert_cmpfloat (least (b), <=, least (a));
  g_assert_cmpfloat (least (b), >, 0.95 * least (a));
  g_autofree char *picture = cli_read (svg);
  g_assert_nonnull (strstr (picture, "</svg>"));
}

/* What early programs had wrong: an arch of rings that do not hang together is weaker, soil that resists
 * helps and is not there where nothing is mobilised, wider axles weigh less on a strip. */
static void
test_monotone (void)
{
  const double usual = least_with ("title=\"as it is\"");
  g_assert_cmpfloat (least_with ("masonry[0].arch.rings=1"), >, 1.05 * usual);
  g_assert_cmpfloat (least_with ("laws[1].friction=0.1"), <, usual);
  g_assert_cmpfloat (least_with ("loads.dead[1].mobilisation=1"), >, usual);
  g_assert_cmpfloat (least_with ("loads.dead[1].mobilisation=0"), <, usual);
  g_assert_cmpfloat (least_with ("loads.live[0].convoy=2"), <=, usual * (1 + 1e-9));
}

/* Beside the bridge a vehicle loads nothing, and part of it is not made up for. */
static void
test_beside (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  g_autofree char *csv = g_build_filename (folder, "e.csv", NULL);
  cli_do ("envelope", bridge, "--vehicle", "CS 454 single axle", "--from", "-4", "--to",
          "4", "--step", "2", "--one-way", "-q", "--csv", csv, NULL);
  g_autoptr (GArray) rows = read_rows (csv);
  g_assert_true (isnan (g_array_index (rows, Row, 0).m[0]));
  g_assert_true (isnan (g_array_index (rows, Row, 1).m[0]));
  g_assert_cmpfloat (g_array_index (rows, Row, 4).m[0], >, 1);
  g_assert_true (isnan (g_array_index (rows, Row, 4).m[1]));
}

/* A position is the decimal number that the table says: at 0.3 m, the end of the deck, the axle still acts,
 * which three steps of 0.1 m in binary would pass. */
static void
test_decimal_positions (void)
{
  static const char deck[] =
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "
    "\"coulomb\", \"kn\": 1e9, \"ks\": 1e9, \"friction\": 0.6 } ], \"blocks\": [\n"
    "{ \"name\": \"g\", \"vertices\": [[-0.2, -1], [0, -1], [0, 0], [-0.2, 0]], "
    "\"thickness\": 3, \"unit_weight\": 0, \"support\": [true, true, true] },\n"
    "{ \"name\": \"d\", \"vertices\": [[-0.5, 0], [0.3, 0], [0.3, 0.2], [-0.5, 0.2]], "
    "\"thickness\": 3, \"unit_weight\": 20000 } ], \"contact\": { \"law\": \"j\" },\n"
    "\"vehicles\": [ { \"name\": \"axle\", \"axles\": [[0, 1000]], \"patch\": [0.01, "
    "0.2], \"track\": 1.6 } ], \"loads\": { \"dead\": [ { \"kind\": \"weight\", "
    "\"direction\": [0, -1] } ], \"live\": [ { \"kind\": \"vehicle\", \"vehicle\": "
    "\"axle\", \"position\": 0 } ] } }";
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = g_build_filename (folder, "deck.quoin", NULL);
  g_autofree char *csv = g_build_filename (folder, "e.csv", NULL);
  g_assert_true (g_file_set_contents (model, deck, -1, NULL));
  cli_do ("envelope", model, "--from", "0", "--to", "0.3", "--step", "0.1", "--one-way",
          "-q", "--csv", csv, NULL);
  g_autoptr (GArray) rows = read_rows (csv);
  g_assert_cmpuint (rows->len, ==, 4);
  /* Half of its patch on the deck: 9.6 kN at 0.1 m from the edge of the pier, 500 N at 0.2975 m. */
  g_assert_cmpfloat_with_epsilon (g_array_index (rows, Row, 3).m[0], 960 / (500 * 0.2975),
                                  1e-5);
}

/* Without fill it stands on the blocks, and is drawn there. */
static void
test_bare (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  g_autofree char *svg = g_build_filename (folder, "b.svg", NULL);
  cli_do ("render", bridge, "--view", "model", "-o", svg, "--set",
          "loads.dead=[{\"kind\":\"weight\",\"direction\":[0,-1]}]", NULL);
  g_autofree char *picture = cli_read (svg);
  g_assert_nonnull (strstr (picture, "93.19 kN"));
}

static void
test_vehicles (void)
{
  static const char fleet[] =
    "{ \"format\": \"quoin-vehicles\", \"version\": 1, \"vehicles\": [ { \"name\": "
    "\"cart\", \"axles\": [[0, 20000], [2, 30000]], \"patch\": [0.2, 0.2], \"track\": "
    "1.2 "
    "} ] }";
  static const char *const built_in[] = {
    "LM1 tandem", "LM1 lane", "LM71", "SW/0", "CS 454 bogie 1.8 m", "CS 454 triple 2.6 m"
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  g_autofree char *file = cli_write (folder, "fleet.json", fleet);
  g_autofree char *bad = cli_write (folder, "bad.json", "{ \"vehicles\": [ { } ] }");
  cli_says ("cart: adequacy factor", "envelope", bridge, "--vehicles", file, "--vehicle",
            "cart", "--from", "4", "--to", "5", NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (built_in); i++)
    cli_says ("adequacy factor", "envelope", bridge, "--vehicle", built_in[i], "--from",
              "5", "--to", "5", "--one-way", NULL);
  cli_fails (3, "name", "envelope", bridge, "--vehicles", bad, NULL);
  cli_fails (2, "no such vehicle; built in are LM1 tandem", "envelope", bridge,
             "--vehicle", "?", NULL);
  cli_fails (2, "no positions", "envelope", bridge, "--from", "2", "--to", "1", NULL);
  g_autofree char *none = cli_example ("28-arch-under-fill.quoin");
  cli_fails (2, "no vehicle", "envelope", none, NULL);
  cli_fails (3, "no vehicle has this name", "check", bridge, "--set",
             "loads.live[0].vehicle=tram", NULL);
}

/* The thinnest semicircular arch under its own weight: t/R = 0.1075 (Milankovitch 1907). */
static void
test_thinnest_arch (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  for (int stands = 0; stands < 2; stands++) {
    const double t = stands ? 0.1077 : 0.1073, inner = 1 - t / 2;
    g_autofree char *json = g_strdup_printf (
      "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"m\", \"kind\": "
      "\"coulomb\", \"basis\": \"contact\", \"kn\": 1e9, \"ks\": 1e9, \"friction\": 2 } "
      "], "
      "\"masonry\": [ { \"kind\": \"arch\", \"name\": \"a\", \"span\": %.9f, \"rise\": "
      "%.9f, "
      "\"ring\": %.9f, \"voussoirs\": 40, \"thickness\": 1, \"unit_weight\": 20000, "
      "\"foundation\": 0.2 } ], \"contact\": { \"law\": \"m\" }, \"loads\": { \"dead\": "
      "[ { "
      "\"kind\": \"weight\", \"direction\": [0, -1] } ], \"live\": [ { \"kind\": "
      "\"weight\", "
      "\"direction\": [1, 0] } ] } }",
      2 * inner, inner, t);
    g_autofree char *arch = cli_write (folder, "arch.quoin", json);
    if (stands)
      cli_do ("limit", arch, "-q", NULL);
    else
      cli_fails (4, "no stable equilibrium", "limit", arch, NULL);
  }
}

/* Torksey bridge carried 1,080 kN: what is predicted without anything fitted is within a fifth of it, and
 * separate rings, as early programs did not have them, carry less than half of one as thick. */
static void
test_tested_bridge (void)
{
  const double predicted = 100 * limit_with ("title=\"as it is\"");
  g_assert_cmpfloat (fabs (predicted - 1080), <, 0.2 * 1080);
  g_assert_cmpfloat (100 * limit_with ("masonry[0].rings=3"), <, 0.5 * predicted);
  g_assert_cmpfloat (100 * limit_with ("laws[0].compression=1e12"), >, predicted);
  g_assert_cmpfloat (100 * limit_with ("loads.dead[1].mobilisation=1"), >, predicted);
}

QN_TESTS
{
  g_test_add_func ("/cli/envelope/mirror", test_mirror);
  g_test_add_func ("/cli/envelope/flow", test_flow);
  g_test_add_func ("/cli/envelope/monotone", test_monotone);
  g_test_add_func ("/cli/envelope/beside", test_beside);
  g_test_add_func ("/cli/envelope/decimal-positions", test_decimal_positions);
  g_test_add_func ("/cli/envelope/bare", test_bare);
  g_test_add_func ("/cli/envelope/vehicles", test_vehicles);
  g_test_add_func ("/cli/envelope/thinnest-arch", test_thinnest_arch);
  g_test_add_func ("/cli/envelope/tested-bridge", test_tested_bridge);
}
