#include "io/text/file-read.h"

#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

static void
test_bytes (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "file", NULL);
  GError *error = NULL;
  gsize length;

  g_assert_true (g_file_set_contents (path, "a\0b", 3, NULL));
  char *bytes = qn_file_read (path, &length, &error);
  g_assert_no_error (error);
  g_assert_cmpmem (bytes, length + 1, "a\0b", 4);
  g_free (bytes);

  g_assert_true (g_file_set_contents (path, "", 0, NULL));
  bytes = qn_file_read (path, &length, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (length, ==, 0);
  g_assert_cmpstr (bytes, ==, "");
  g_free (bytes);
}

/* A pipe has no size to rely on. */
static void
test_pipe (void)
{
  int ends[2];
  g_assert_cmpint (pipe (ends), ==, 0);
  char *sent = g_strnfill (50000, 'x');
  g_assert_cmpint (write (ends[1], sent, 50000), ==, 50000);
  close (ends[1]);

  char *path = g_strdup_printf ("/dev/fd/%d", ends[0]);
  GError *error = NULL;
  gsize length;
  char *bytes = qn_file_read (path, &length, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (length, ==, 50000);
  g_assert_cmpstr (bytes, ==, sent);
  g_free (bytes);
  g_free (path);
  g_free (sent);
  close (ends[0]);
}

static void
expect_error (const char *path, const char *reason)
{
  gsize length;
  g_autoptr (GError) error = NULL;
  g_assert_null (qn_file_read (path, &length, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_assert_true (g_str_has_prefix (error->message, path));
  g_assert_nonnull (strstr (error->message, reason));
}

static void
test_refused (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "file", NULL);
  expect_error (path, "No such file");
  expect_error (folder, "directory");

  g_assert_true (g_file_set_contents (path, "x", 1, NULL));
  g_assert_cmpint (g_chmod (path, 0), ==, 0);
  if (geteuid () != 0) /* root reads everything */
    expect_error (path, "ermission");
}

QN_TESTS
{
  g_test_add_func ("/file-read/bytes", test_bytes);
  g_test_add_func ("/file-read/pipe", test_pipe);
  g_test_add_func ("/file-read/refused", test_refused);
}
