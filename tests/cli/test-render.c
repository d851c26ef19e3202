/* quoin-cli render, compare and curve: the files they make, and what they refuse. */
#include "cli-run.h"
#include "support/room.h"
#include "support/table.h"

#include <math.h>
#include <string.h>

/* An arch and its result in a folder of their own. */
typedef struct Solved {
  char *folder, *model, *result;
} Solved;

static void
set_up (Solved *solved, gconstpointer data)
{
  (void) data;
  solved->folder = test_scratch_new ();
  solved->model = cli_example ("06-arch.quoin");
  solved->result = g_build_filename (solved->folder, "arch.json", NULL);
  cli_do ("solve", solved->model, "-q", "-o", solved->result, NULL);
}

static void
tear_down (Solved *solved, gconstpointer data)
{
  (void) data;
  test_scratch_free (solved->folder);
  g_free (solved->model);
  g_free (solved->result);
}

/* Fails unless the file exists and begins like a file of its kind. */
static void
assert_picture (const char *path)
{
  static const char *const kinds[][2] = { { ".png", "\x89PNG" },
                                          { ".svg", "<?xml" },
                                          { ".pdf", "%PDF-" } };
  g_autoptr (GError) error = NULL;
  g_autofree char *bytes = NULL;
  gsize length = 0;
  g_file_get_contents (path, &bytes, &length, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (length, >, 1000);
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++)
    if (g_str_has_suffix (path, kinds[i][0]))
      g_assert_cmpint (memcmp (bytes, kinds[i][1], strlen (kinds[i][1])), ==, 0);
}

static void
test_views_and_formats (Solved *solved, gconstpointer data)
{
  static const char *const views[] = { "model", "contacts", "deformed", "mechanism",
                                       "forces" };
  static const char *const endings[] = { "png", "svg", "pdf" };
  (void) data;
  for (size_t i = 0; i < G_N_ELEMENTS (views); i++)
    for (size_t k = 0; k < G_N_ELEMENTS (endings); k++) {
      g_autofree char *name = g_strdup_printf ("%s.%s", views[i], endings[k]);
      g_autofree char *path = g_build_filename (solved->folder, name, NULL);
      cli_do ("render", solved->model, "--result", solved->result, "--view", views[i],
              "--size", "400x300", "-o", path, NULL);
      assert_picture (path);
    }
}

/* Forces are drawn of every step, and every picture is another one. */
static void
test_forces_of_steps (Solved *solved, gconstpointer data)
{
  g_autofree char *path = g_build_filename (solved->folder, "s.svg", NULL);
  g_autofree char *before = NULL;
  (void) data;
  for (int step = 0; step < 4; step++) {
    g_autofree char *number = g_strdup_printf ("%d", step);
    cli_do ("render", solved->model, "--result", solved->result, "--view", "forces",
            "--field", "stress", "--step", number, "-o", path, NULL);
    char *picture = cli_read (path);
    g_assert_cmpstr (picture, !=, before);
    g_free (before);
    before = picture;
  }
}

/* A mechanism may be coloured by stress: that of the last step, in its unit. */
static void
test_stress_of_mechanism (Solved *solved, gconstpointer data)
{
  static const char *const views[] = { "deformed", "mechanism" };
  g_autofree char *path = g_build_filename (solved->folder, "m.svg", NULL);
  (void) data;
  for (size_t i = 0; i < G_N_ELEMENTS (views); i++) {
    cli_do ("render", solved->model, "--result", solved->result, "--view", views[i],
            "--field", "stress", "-o", path, NULL);
    assert_picture (path);
  }
}

static void
test_render_options (Solved *solved, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (solved->folder, "o.png", NULL);
  cli_do ("render", solved->model, "--result", solved->result, "--view", "deformed",
          "--step", "0", "--scale", "100", "--size", "60mmx40mm", "--dpi", "200",
          "--backend", "cairo", "--transparent", "--monochrome", "-o", path, NULL);
  assert_picture (path);
}

static void
test_render_refuses (Solved *solved, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (solved->folder, "o.png", NULL);
  cli_fails (2, NULL, "render", solved->model, "--result", solved->result, "--view",
             "deformed", "--step", "100000", "-o", path, NULL);
  g_assert_false (g_file_test (path, G_FILE_TEST_EXISTS));

  cli_fails (5, "/no/such/folder/o.png", "render", solved->model, "-o",
             "/no/such/folder/o.png", NULL);
  cli_fails (5, "/no/such/r.json", "render", solved->model, "--result", "/no/such/r.json",
             "--view", "forces", "-o", path, NULL);
  cli_fails (3, NULL, "render", solved->model, "--result", solved->model, "--view",
             "forces", "-o", path, NULL);
}

static void
test_same_bytes (Solved *solved, gconstpointer data)
{
  (void) data;
  char *bytes[2];
  gsize lengths[2];
  for (int i = 0; i < 2; i++) {
    g_autofree char *path = g_build_filename (solved->folder, "o.pdf", NULL);
    cli_do ("render", solved->model, "--result", solved->result, "--view", "mechanism",
            "-o", path, NULL);
    g_assert_true (g_file_get_contents (path, &bytes[i], &lengths[i], NULL));
  }
  g_assert_cmpmem (bytes[0], lengths[0], bytes[1], lengths[1]);
  g_free (bytes[0]);
  g_free (bytes[1]);
}

static void
test_compare_and_curve (Solved *solved, gconstpointer data)
{
  static const char *const subcommands[] = { "compare", "curve" };
  (void) data;
  g_autofree char *given = g_strdup_printf ("%s=%s", solved->model, solved->result);
  g_autofree char *stack = cli_example ("05-stack.quoin");
  for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++) {
    g_autofree char *name = g_strconcat (subcommands[i], ".png", NULL);
    g_autofree char *path = g_build_filename (solved->folder, name, NULL);
    cli_do (subcommands[i], given, stack, "--size", "800x600", "-o", path, NULL);
    assert_picture (path);

    cli_fails (5, NULL, subcommands[i], given, "-o", "/no/such/folder/o.png", NULL);
    cli_fails (2, NULL, subcommands[i], given, "-o", "o.txt", NULL);
  }
}

/* The ending .csv gives the numbers that stand beneath the figures. */
static void
test_compare_table (Solved *solved, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (solved->folder, "table.csv", NULL);
  g_autofree char *given = g_strdup_printf ("%s=%s", solved->model, solved->result);
  g_autofree char *stack = cli_example ("05-stack.quoin");
  cli_do ("compare", given, stack, "-o", path, NULL);
  g_autofree char *table = cli_read (path);
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_assert_cmpuint (g_strv_length (lines), ==, 4);
  g_assert_cmpstr (lines[0], ==, "project,title,outcome,multiplier [-],mechanism,steps");
  g_assert_nonnull (strstr (lines[1], ",collapse,"));
  g_assert_nonnull (strstr (lines[2], "05-stack.quoin"));
  cli_fails (5, NULL, "compare", stack, "-o", "/no/such/folder/c.csv", NULL);
}

static void
test_columns (Solved *solved, gconstpointer data)
{
  static const char *const wrong[] = { "0", "-2", "many" };
  (void) data;
  g_autofree char *given = g_strdup_printf ("%s=%s", solved->model, solved->result);
  g_autofree char *path = g_build_filename (solved->folder, "columns.png", NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (wrong); i++)
    cli_fails (2, i < 2 ? "--columns must be positive" : wrong[i], "compare", given,
               "--columns", wrong[i], "-o", path, NULL);
  cli_do ("compare", given, given, "--columns", "1", "-o", path, NULL);
  assert_picture (path);
}

/* Two runs of one project are told apart, known values are drawn, and all of it is a table. */
static void
test_curve_runs (Solved *solved, gconstpointer data)
{
  (void) data;
  g_autofree char *other = g_build_filename (solved->folder, "other.json", NULL);
  g_autofree char *svg = g_build_filename (solved->folder, "c.svg", NULL);
  g_autofree char *csv = g_build_filename (solved->folder, "c.csv", NULL);
  g_autofree char *first = g_strdup_printf ("%s=%s", solved->model, solved->result);
  g_autofree char *second = g_strdup_printf ("%s=%s", solved->model, other);
  cli_do ("solve", solved->model, "-q", "--set", "analysis.increments=10", "-o", other,
          NULL);
  cli_do ("curve", first, second, "--reference", "0.25=published", "--reference", "0.1",
          "-o", svg, NULL);
  cli_do ("curve", first, second, "-o", csv, NULL);
  g_autofree char *table = cli_read (csv);
  g_assert_true (
    g_str_has_prefix (table, "run,step,displacement [m or rad],multiplier [-],mark\n"));
  g_assert_nonnull (strstr (table, "(arch.json)\",0,"));
  g_assert_nonnull (strstr (table, "(other.json)\",0,"));
  g_assert_nonnull (strstr (table, ",collapse\n"));

  g_autofree char *shaken = cli_example ("40-rocking-in-time.quoin");
  cli_fails (3, "no axes in common", "curve", first, shaken, "-o", csv, NULL);
  /* A settlement has the reaction of its support: at 40 mm the least thrust of the arch. A path in stages has the
   * multiplier of the set that its last stage drives, 0 until then. */
  g_autofree char *spread = cli_example ("18-spreading-arch.quoin");
  g_autofree char *stages = cli_example ("16-load-stages.quoin");
  cli_fails (3, "no axes in common", "curve", first, spread, "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", first, stages, "-o", csv, NULL);
  /* Loads without names have them where they are the same: not in another direction, of another size or on
   * another block; the weight pushes structures of any size alike. */
  g_autofree char *block = cli_example ("01-sliding-block.quoin");
  g_autofree char *stack = cli_example ("05-stack.quoin");
  g_autofree char *mast = cli_example ("36-mast-on-block.quoin");
  cli_do ("curve", block, stack, "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", stack, mast, "-o", csv, NULL);
  static const char *const forces[] = {
    "loads.live=[{\"kind\": \"force\", \"block\": \"block 5\", \"value\": [100, 0]}]",
    "loads.live=[{\"kind\": \"force\", \"block\": \"block 5\", \"value\": [200, 0]}]",
    "loads.live=[{\"kind\": \"force\", \"block\": \"block 4\", \"value\": [100, 0]}]",
    ("loads.live=[{\"kind\": \"force\", \"block\": \"block 5\", \"value\": [40, 0]}, "
     "{\"kind\": \"force\", \"block\": \"block 5\", \"value\": [60, 0]}]"),
    "loads.live=[{\"kind\": \"weight\", \"direction\": [-1, 0]}]",
  };
  char *runs[G_N_ELEMENTS (forces)];
  for (gsize i = 0; i < G_N_ELEMENTS (forces); i++) {
    g_autofree char *name = g_strdup_printf ("force-%zu.json", i);
    g_autofree char *path = g_build_filename (solved->folder, name, NULL);
    cli_do ("solve", stack, "-q", "--set", forces[i], "-o", path, NULL);
    runs[i] = g_strdup_printf ("%s=%s", stack, path);
  }
  cli_do ("curve", runs[0], runs[3], "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", runs[0], runs[1], "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", runs[0], runs[2], "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", stack, runs[0], "-o", csv, NULL);
  cli_fails (3, "no axes in common", "curve", stack, runs[4], "-o", csv, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (forces); i++)
    g_free (runs[i]);
  cli_do ("curve", spread, "-o", csv, NULL);
  g_autofree char *reactions = cli_read (csv);
  g_autoptr (GPtrArray) rows = test_table_read (reactions);
  g_assert_cmpfloat_with_epsilon (
    fabs (test_table_number (rows, rows->len - 1, "reaction [N or N m]")), 47880.156,
    1e-2);
  g_assert_cmpfloat_with_epsilon (
    test_table_number (rows, rows->len - 1, "settlement [m or rad]"), 0.04, 1e-9);
  cli_fails (2, "a reference is a number", "curve", first, "--reference", "much", "-o",
             svg, NULL);
  cli_fails (5, NULL, "curve", first, "-o", "/no/such/folder/c.csv", NULL);
}

QN_TESTS
{
#define ADD(path, function)                                                              \
  g_test_add ("/cli/render/" path, Solved, NULL, set_up, function, tear_down)
  ADD ("views-and-formats", test_views_and_formats);
  ADD ("forces-of-steps", test_forces_of_steps);
  ADD ("stress-of-mechanism", test_stress_of_mechanism);
  ADD ("options", test_render_options);
  ADD ("refuses", test_render_refuses);
  ADD ("same-bytes", test_same_bytes);
  ADD ("compare-and-curve", test_compare_and_curve);
  ADD ("compare-table", test_compare_table);
  ADD ("columns", test_columns);
  ADD ("curve-runs", test_curve_runs);
#undef ADD
}
