/* The whole tree is formatted as .clang-format says. */
#include "source-tree.h"
#include "support/room.h"

#include <glib/gstdio.h>

/* Runs the formatter over the given files; complains with the first line of its answer. */
static void
check_format (GPtrArray *paths, GString *complaints)
{
  GStrvBuilder *builder = g_strv_builder_new ();
  g_autofree char *style =
    g_strdup_printf ("--style=file:%s/.clang-format", source_tree_root ());
  g_strv_builder_add_many (builder, g_getenv ("QUOIN_CLANG_FORMAT"), "--dry-run",
                           "-Werror", style, NULL);
  for (guint i = 0; i < paths->len; i++)
    g_strv_builder_add (builder, g_ptr_array_index (paths, i));
  g_auto (GStrv) command = g_strv_builder_end (builder);
  g_strv_builder_unref (builder);

  g_autofree char *answer = NULL;
  g_autoptr (GError) error = NULL;
  int status = 0;
  g_spawn_sync (source_tree_root (), command, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, NULL,
                &answer, &status, &error);
  g_assert_no_error (error);
  if (!g_spawn_check_wait_status (status, NULL)) {
    g_auto (GStrv) lines = g_strsplit (answer, "\n", 2);
    complain (complaints, "not formatted: %s", lines[0]);
  }
}

static void
test_format (void)
{
  static const char *const suffixes[] = { ".c", ".h", NULL };
  static const char *const folders[] = { "src", "tests" };
  GString *complaints = g_string_new (NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++) {
    g_autoptr (GPtrArray) files = source_tree_files (folders[i], suffixes);
    g_assert_cmpuint (files->len, >, 5);
    check_format (files, complaints);
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  g_autoptr (GError) error = NULL;
  char *path = NULL;
  int file = g_file_open_tmp ("quoin-XXXXXX.c", &path, &error);
  g_assert_no_error (error);
  g_close (file, NULL);
  g_file_set_contents (path, "int f(void) { return 0; }\n", -1, &error);
  g_assert_no_error (error);

  GString *complaints = g_string_new (NULL);
  g_autoptr (GPtrArray) paths = g_ptr_array_new_with_free_func (g_free);
  g_ptr_array_add (paths, path);
  check_format (paths, complaints);
  assert_complaint (complaints, "not formatted");
  g_unlink (path);
}

QN_TESTS
{
  if (g_getenv ("QUOIN_CLANG_FORMAT") == NULL)
    return;
  g_test_add_func ("/checks/format/tree", test_format);
  g_test_add_func ("/checks/format/can-fail", test_check_can_fail);
}
