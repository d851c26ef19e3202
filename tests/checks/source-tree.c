#include "source-tree.h"

#include <string.h>

const char *
source_tree_root (void)
{
  const char *root = g_getenv ("QUOIN_SOURCE_ROOT");
  g_assert_nonnull (root);
  return root;
}

static gboolean
ends_in_one_of (const char *name, const char *const *suffixes)
{
  for (; *suffixes != NULL; suffixes++)
    if (g_str_has_suffix (name, *suffixes))
      return TRUE;
  return FALSE;
}

static void
collect (const char *folder, const char *const *suffixes, GPtrArray *files)
{
  g_autofree char *path = g_build_filename (source_tree_root (), folder, NULL);
  GDir *dir = g_dir_open (path, 0, NULL);
  if (dir == NULL)
    return;

  const char *name;
  while ((name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *relative = g_build_filename (folder, name, NULL);
    g_autofree char *full = g_build_filename (path, name, NULL);
    if (g_file_test (full, G_FILE_TEST_IS_DIR))
      collect (relative, suffixes, files);
    else if (ends_in_one_of (name, suffixes))
      g_ptr_array_add (files, g_steal_pointer (&relative));
  }
  g_dir_close (dir);
}

static int
compare_paths (gconstpointer a, gconstpointer b)
{
  return strcmp (*(char *const *) a, *(char *const *) b);
}

GPtrArray *
source_tree_files (const char *folder, const char *const *suffixes)
{
  GPtrArray *files = g_ptr_array_new_with_free_func (g_free);
  collect (folder, suffixes, files);
  g_ptr_array_sort (files, compare_paths);
  return files;
}

char *
source_tree_read (const char *path)
{
  g_autofree char *full = g_build_filename (source_tree_root (), path, NULL);
  g_autoptr (GError) error = NULL;
  char *text = NULL;
  g_file_get_contents (full, &text, NULL, &error);
  g_assert_no_error (error);
  return text;
}

char **
source_tree_lines (const char *path)
{
  g_autofree char *text = source_tree_read (path);
  return g_strsplit (text, "\n", -1);
}

void
complain (GString *complaints, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_string_append_vprintf (complaints, format, arguments);
  va_end (arguments);
  g_string_append_c (complaints, '\n');
}

void
assert_no_complaints (GString *complaints)
{
  if (complaints->len > 0) {
    g_test_message ("%s", complaints->str);
    g_test_fail_printf ("%s", strtok (complaints->str, "\n"));
  }
  g_string_free (complaints, TRUE);
}

void
assert_complaint (GString *complaints, const char *part)
{
  if (strstr (complaints->str, part) == NULL)
    g_test_fail_printf ("no complaint about '%s' in '%s'", part, complaints->str);
  g_string_free (complaints, TRUE);
}
