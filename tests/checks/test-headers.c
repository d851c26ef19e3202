/* Every header of src/ compiles alone: whoever includes it needs nothing before it. The build has compiled
 * those that a source of their name includes first; the others are compiled here. */
#include "source-tree.h"
#include "support/room.h"

#include <glib/gstdio.h>

/* Compiles a header by itself; complains with the first line of the compiler's answer. */
static void
check_header (const char *path, GString *complaints)
{
  g_auto (GStrv) command = NULL;
  g_autoptr (GError) error = NULL;
  g_autofree char *line =
    g_strdup_printf ("%s -std=gnu11 -fsyntax-only -Wall -Wextra -x c %s",
                     g_getenv ("QUOIN_COMPILE"), path);
  g_assert_true (g_shell_parse_argv (line, NULL, &command, &error));

  g_autofree char *answer = NULL;
  int status = 0;
  g_spawn_sync (NULL, command, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, NULL, &answer,
                &status, &error);
  g_assert_no_error (error);
  if (!g_spawn_check_wait_status (status, NULL)) {
    g_auto (GStrv) lines = g_strsplit (answer, "\n", 2);
    complain (complaints, "%s does not compile alone: %s", path, lines[0]);
  }
}

/* "src/core/base/box-tree.h": whether box-tree.c beside it includes it before all else. */
static gboolean
is_first_of_its_source (const char *header)
{
  gsize length = strlen (header);
  g_autofree char *source = g_strdup_printf ("%.*sc", (int) length - 1, header);
  g_autofree char *path = g_build_filename (source_tree_root (), source, NULL);
  g_autofree char *line = g_strdup_printf ("#include \"%s\"\n", header + strlen ("src/"));
  g_autofree char *text = NULL;
  if (!g_file_get_contents (path, &text, NULL, NULL))
    return FALSE;
  const char *first = strstr (text, "#include");
  return first != NULL && g_str_has_prefix (first, line);
}

static void
test_headers (void)
{
  static const char *const suffixes[] = { ".h", NULL };
  /* Without GTK the window's cannot. */
  g_auto (GStrv) folders = g_strsplit (g_getenv ("QUOIN_HEADER_FOLDERS"), " ", -1);
  GString *complaints = g_string_new (NULL);
  for (guint k = 0; folders[k] != NULL; k++) {
    g_autofree char *folder = g_build_filename ("src", folders[k], NULL);
    g_autoptr (GPtrArray) files = source_tree_files (folder, suffixes);
    g_assert_cmpuint (files->len, >, 0);
    for (guint i = 0; i < files->len; i++) {
      const char *file = g_ptr_array_index (files, i);
      g_autofree char *path = g_build_filename (source_tree_root (), file, NULL);
      if (!is_first_of_its_source (file))
        check_header (path, complaints);
    }
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  g_autofree char *path = NULL;
  g_autoptr (GError) error = NULL;
  int file = g_file_open_tmp ("quoin-XXXXXX.h", &path, &error);
  g_assert_no_error (error);
  g_close (file, NULL);
  g_file_set_contents (path, "size_t count_of (const char *text);\n", -1, &error);
  g_assert_no_error (error);

  GString *complaints = g_string_new (NULL);
  check_header (path, complaints);
  assert_complaint (complaints, "does not compile alone");
  g_unlink (path);
}

static void
test_first (void)
{
  g_assert_true (is_first_of_its_source ("src/core/base/box-tree.h"));
  g_assert_false (is_first_of_its_source ("src/core/base/box.h"));
}

QN_TESTS
{
  g_test_add_func ("/checks/headers/first", test_first);
  g_test_add_func ("/checks/headers/alone", test_headers);
  g_test_add_func ("/checks/headers/can-fail", test_check_can_fail);
}
