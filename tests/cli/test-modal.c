/* quoin-cli modal: table, files, and what is refused. */
#include "cli-run.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static void
test_table (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *example = cli_example ("11-vibrating-beam.quoin");
  g_autofree char *result = g_build_filename (folder, "mode.json", NULL);
  g_autofree char *csv = g_build_filename (folder, "modes.csv", NULL);
  cli_says ("omega", "modal", example, "-n", "3", "--csv", csv, "-o", result, "--mode",
            "2", NULL);

  g_autofree char *table = cli_read (csv);
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_auto (GStrv) fields = g_strsplit (lines[1], ",", -1);
  g_assert_cmpfloat_with_epsilon (g_ascii_strtod (fields[1], NULL) / 315.819, 1, 0.01);
  g_assert_cmpuint (g_strv_length (lines), ==, 1 + 3 * 61 + 1);
  g_autofree char *written = cli_read (result);
  g_assert_nonnull (strstr (written, "\"mechanism\": [["));
}

/* Nodes of beams stand behind the blocks, in a frame without blocks alone. */
static void
test_nodes_in_table (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *example = cli_example ("37-beam-vibrating.quoin");
  g_autofree char *csv = g_build_filename (folder, "modes.csv", NULL);
  g_autofree char *result = g_build_filename (folder, "mode.json", NULL);
  cli_says ("omega", "modal", example, "-n", "1", "--csv", csv, "-o", result, NULL);
  g_autofree char *table = cli_read (csv);
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_autofree char *written = cli_read (result);
  double largest = 0;
  guint rows = g_strv_length (lines) - 2;
  for (guint i = 1; i <= rows; i++) {
    g_auto (GStrv) fields = g_strsplit (lines[i], ",", -1);
    for (guint k = 6; k < 8; k++)
      largest = fmax (largest, fabs (g_ascii_strtod (fields[k], NULL)));
  }
  g_assert_nonnull (strstr (written, "\"node_mechanism\""));
  g_assert_cmpuint (rows, >, 10);
  g_assert_cmpfloat_with_epsilon (largest, 1, 1e-9);
}

static void
test_refused (void)
{
  g_autofree char *example = cli_example ("01-sliding-block.quoin");
  cli_fails (2, "count", "modal", example, "--count", "0", NULL);
  cli_fails (2, "damping", "modal", example, "--damping", "1", NULL);
  cli_fails (3, "there is no mode 5", "modal", example, "-n", "2", "-o", "-", "--mode",
             "5", NULL);
  cli_fails (3, "no mass", "modal", example, "--set", "gravity=0", "--set",
             "blocks[1].unit_weight=0", NULL);
}

/* A dry wall has frequencies, and what is left out is told; the mode in its file is proved. */
static void
test_dry_wall (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *example = cli_example ("15-rubble-pier.quoin");
  g_autofree char *result = g_build_filename (folder, "mode.json", NULL);
  cli_says ("closed joints are elastic", "modal", example, "-o", result, NULL);
  cli_says ("passes", "check", example, "--result", result, NULL);
}

/* 2 x 0.05 x w = mass + stiffness w^2 for both frequencies. */
static void
test_damping (void)
{
  g_autofree char *example = cli_example ("11-vibrating-beam.quoin");
  cli_says ("damping by mass 24.773 1/s and by stiffness 6.82035e-05 s", "modal", example,
            "-n", "2", "--damping", "0.05", NULL);
}

/* Rounding presses blocks of one course together or not; without tension the wall stands all the same. */
static void
test_without_tension (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *wall = g_build_filename (folder, "wall.quoin", NULL);
  cli_says ("", "generate", "wall", "length=10", "height=5", "unit=0.4x0.2",
            "foundation=0.2", "-o", wall, NULL);
  cli_says (
    "omega", "modal", wall, "-n", "2", "--set",
    "laws[0]={\"name\": \"dry joint\", \"kind\": \"no-tension\", \"basis\": \"surface\", "
    "\"kn\": 2e10, \"ks\": 2e10}",
    NULL);
}

/* A wall whose pairs slip is sound: the tangent gives no answer, and no line of the file is the reason. */
static void
test_slipping (void)
{
  g_autofree char *example = cli_example ("ferris-tin-loi/wall3.quoin");
  cli_fails (4,
             "wall3.quoin: pairs slip without dilatancy under the dead load: no "
             "symmetric stiffness",
             "modal", example, "--slip", NULL);
  cli_fails (4, "wall3.quoin: pairs slip", "modal", example, "--slip", "--loaded", NULL);
  cli_fails (4, "wall3.quoin: pairs slip", "stability", example, "--set",
             "analysis.geometry=nonlinear", NULL);
}

/* A block on its corner falls: that is no rigid motion of frequency zero. */
static void
test_unstable (void)
{
  g_autofree char *example = cli_example ("24-rocking-block.quoin");
  cli_fails (4, "unstable", "modal", example, "--loaded", NULL);
}

/* What an analysis may spend holds for these as well. */
static void
test_budget (void)
{
  g_autofree char *beam = cli_example ("11-vibrating-beam.quoin");
  g_autofree char *column = cli_example ("20-column-free.quoin");
  const char *budgets[] = { "analysis.max_factorizations=1",
                            "analysis.max_seconds=1e-9" };
  for (int i = 0; i < 2; i++) {
    cli_fails (4, "20-column-free.quoin", "stability", column, "-q", "--set", budgets[i],
               NULL);
    cli_fails (4, "11-vibrating-beam.quoin", "modal", beam, "-q", "--set", budgets[i],
               NULL);
  }
}

QN_TESTS
{
  g_test_add_func ("/cli/modal/table", test_table);
  g_test_add_func ("/cli/modal/nodes-in-table", test_nodes_in_table);
  g_test_add_func ("/cli/modal/refused", test_refused);
  g_test_add_func ("/cli/modal/unstable", test_unstable);
  g_test_add_func ("/cli/modal/dry-wall", test_dry_wall);
  g_test_add_func ("/cli/modal/damping", test_damping);
  g_test_add_func ("/cli/modal/without-tension", test_without_tension);
  g_test_add_func ("/cli/modal/slipping", test_slipping);
  g_test_add_func ("/cli/modal/budget", test_budget);
}
