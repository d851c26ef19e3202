#include "support/scratch.h"

#include <glib/gstdio.h>

char *
test_scratch_new (void)
{
  g_autoptr (GError) error = NULL;
  char *folder = g_dir_make_tmp ("quoin-test-XXXXXX", &error);
  g_assert_no_error (error);
  return folder;
}

void
test_scratch_empty (const char *folder)
{
  GDir *entries = g_dir_open (folder, 0, NULL);
  const char *name;
  while (entries != NULL && (name = g_dir_read_name (entries)) != NULL) {
    char *path = g_build_filename (folder, name, NULL);
    if (g_file_test (path, G_FILE_TEST_IS_DIR)
        && !g_file_test (path, G_FILE_TEST_IS_SYMLINK)) {
      test_scratch_free (path);
    } else {
      g_assert_cmpint (g_unlink (path), ==, 0);
      g_free (path);
    }
  }
  if (entries != NULL)
    g_dir_close (entries);
}

void
test_scratch_free (char *folder)
{
  test_scratch_empty (folder);
  g_assert_cmpint (g_rmdir (folder), ==, 0);
  g_free (folder);
}

void
test_scratch_file_set_up (TestScratchFile *file, gconstpointer data)
{
  (void) data;
  file->folder = test_scratch_new ();
  file->path = g_build_filename (file->folder, "file", NULL);
}

void
test_scratch_file_tear_down (TestScratchFile *file, gconstpointer data)
{
  (void) data;
  g_free (file->path);
  test_scratch_free (file->folder);
}

guint
test_scratch_count (const char *folder)
{
  g_autoptr (GDir) entries = g_dir_open (folder, 0, NULL);
  guint count = 0;
  while (g_dir_read_name (entries) != NULL)
    count++;
  return count;
}

void
test_scratch_expect (const char *path, const char *text)
{
  g_autofree char *content = NULL;
  g_assert_true (g_file_get_contents (path, &content, NULL, NULL));
  g_assert_cmpstr (content, ==, text);
}
