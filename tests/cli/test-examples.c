/* Every example can be checked, and solved where that is quick. */
#include "cli-run.h"
#include "support/room.h"

#include <string.h>

/* Adds the paths of all project files below `folder`. */
static void
collect (const char *folder, GPtrArray *paths)
{
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *name;
  g_assert_nonnull (dir);
  while ((name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL);
    if (g_file_test (path, G_FILE_TEST_IS_DIR))
      collect (path, paths);
    else if (g_str_has_suffix (name, ".quoin"))
      g_ptr_array_add (paths, g_steal_pointer (&path));
  }
}

static void
test_check (gconstpointer path)
{
  cli_do ("check", path, NULL);
}

/* A structure without supports is listed, and refused. */
static void
test_check_free (gconstpointer path)
{
  CliRun run = cli_run ("check", path, NULL);
  g_assert_nonnull (strstr (run.out, "contact faces: 5"));
  cli_assert_failed (&run, 3, "no block is supported");
}

/* Solves, and holds the result against the independent check. */
static void
test_solve (gconstpointer path)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *result = g_build_filename (folder, "result.json", NULL);
  cli_do ("solve", path, "-q", "-o", result, NULL);

  cli_do ("check", path, "--result", result, NULL);
}

/* Without supports there is no path to follow, but there are frequencies. */
static void
test_modes (gconstpointer path)
{
  cli_says ("rigid motion", "modal", path, "-n", "6", NULL);
}

static gboolean
is_free (const char *name)
{
  return strcmp (name, "25-four-bricks.quoin") == 0;
}

static GPtrArray *paths;

static void
forget (void)
{
  g_ptr_array_unref (paths);
}

QN_TESTS
{
  paths = g_ptr_array_new_with_free_func (g_free);
  atexit (forget);
  collect (g_getenv ("QUOIN_EXAMPLES"), paths);
  g_assert_cmpuint (paths->len, >=, 12);

  for (guint i = 0; i < paths->len; i++) {
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *base = g_path_get_basename (path);
    g_autofree char *check = g_strconcat ("/cli/examples/check/", base, NULL);
    g_autofree char *solve = g_strconcat ("/cli/examples/solve/", base, NULL);
    g_test_add_data_func (check, path, is_free (base) ? test_check_free : test_check);
    g_test_add_data_func (solve, path, is_free (base) ? test_modes : test_solve);
  }
}
