#include "io/text/file-writer.h"

#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void
test_pieces (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  GError *error = NULL;
  QnFileWriter *writer = qn_file_writer_open (fixture->path);
  qn_file_writer_puts (writer, "a");
  qn_file_writer_printf (writer, "%d ", 37);
  qn_file_writer_number (writer, 0.175);
  qn_file_writer_json (writer, "%s", "\"q\"");
  qn_file_writer_write (writer, "xyz", 2);
  qn_file_writer_quoted (writer, "\"a\",b");
  /* Nothing has the name of the target before all of it is there. */
  g_assert_false (g_file_test (fixture->path, G_FILE_TEST_EXISTS));
  g_assert_true (qn_file_writer_commit (writer, &error));
  g_assert_no_error (error);
  test_scratch_expect (fixture->path, "a37 0.175\"\\\"q\\\"\"xy\"\"\"a\"\",b\"");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);
}

static void
test_not_finite (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  for (int rounded = 0; rounded < 2; rounded++) {
    g_autoptr (GError) error = NULL;
    QnFileWriter *writer = qn_file_writer_open (fixture->path);
    if (rounded)
      qn_file_writer_rounded (writer, NAN, "%.7e");
    else
      qn_file_writer_number (writer, -INFINITY);
    g_assert_false (qn_file_writer_commit (writer, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
    g_assert_false (g_file_test (fixture->path, G_FILE_TEST_EXISTS));
  }
}

static void
test_larger_than_buffer (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  GError *error = NULL;
  QnFileWriter *writer = qn_file_writer_open (fixture->path);
  for (int i = 0; i < 100000; i++)
    qn_file_writer_printf (writer, "%05d\n", i);
  g_assert_true (qn_file_writer_commit (writer, &error));

  g_autofree char *content = NULL;
  gsize length;
  g_assert_true (g_file_get_contents (fixture->path, &content, &length, NULL));
  g_assert_cmpuint (length, ==, 600000);
  for (int i = 0; i < 100000; i++)
    g_assert_cmpint (atoi (content + 6 * i), ==, i);
}

static void
test_failure_keeps_the_old (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  GError *error = NULL;
  g_assert_true (qn_file_write (fixture->path, "old", 3, &error));
  QnFileWriter *writer = qn_file_writer_open (fixture->path);
  qn_file_writer_puts (writer, "new");
  qn_file_writer_fail (writer, ENOMEM);
  qn_file_writer_fail (writer, EIO); /* the first one is told */
  g_assert_false (qn_file_writer_commit (writer, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY);
  g_clear_error (&error);
  test_scratch_expect (fixture->path, "old");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);

  /* What cannot be opened takes all that is written, and says so at its end. */
  writer = qn_file_writer_open (fixture->folder);
  qn_file_writer_puts (writer, "new");
  g_assert_true (qn_file_writer_failed (writer));
  g_assert_false (qn_file_writer_commit (writer, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&error);
}

/* A file that is replaced keeps its permissions; a link keeps leading to it. */
static void
test_mode_and_link (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *link = g_build_filename (fixture->folder, "link", NULL);
  GError *error = NULL;
  GStatBuf status;
  g_assert_true (qn_file_write (fixture->path, "old", 3, &error));
  g_assert_cmpint (g_chmod (fixture->path, 0640), ==, 0);
  g_assert_cmpint (symlink (fixture->path, link), ==, 0);

  g_assert_true (qn_file_write (link, "new", 3, &error));
  g_assert_no_error (error);
  test_scratch_expect (fixture->path, "new");
  g_assert_true (g_file_test (link, G_FILE_TEST_IS_SYMLINK));
  g_assert_cmpint (g_stat (fixture->path, &status), ==, 0);
  g_assert_cmpuint (status.st_mode & 07777, ==, 0640);
}

static void
expect_refused (const char *path, const char *reason)
{
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_file_write (path, "new", 3, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_assert_true (g_str_has_prefix (error->message, path));
  g_assert_nonnull (strstr (error->message, reason));
}

static void
test_refused (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *nowhere = g_build_filename (fixture->folder, "none", "file", NULL);
  expect_refused (nowhere, "No such file");
  expect_refused (fixture->folder, "directory");
  expect_refused ("/dev/full", "No space left");
  if (geteuid () != 0) { /* root writes everywhere */
    g_assert_true (qn_file_write (fixture->path, "old", 3, NULL));
    g_assert_cmpint (g_chmod (fixture->path, 0400), ==, 0);
    expect_refused (fixture->path, "ermission");
    g_assert_cmpint (g_chmod (fixture->path, 0600), ==, 0);
  }
}

/* Devices are written, not replaced. */
static void
test_device (TestScratchFile *fixture, gconstpointer data)
{
  (void) fixture;
  (void) data;
  GError *error = NULL;
  GStatBuf status;
  g_assert_true (qn_file_write ("/dev/null", "new", 3, &error));
  g_assert_no_error (error);
  g_assert_cmpint (g_stat ("/dev/null", &status), ==, 0);
  g_assert_true (S_ISCHR (status.st_mode));
}

QN_TESTS
{
#define ADD(path, test)                                                                  \
  g_test_add (path, TestScratchFile, NULL, test_scratch_file_set_up, test,               \
              test_scratch_file_tear_down)
  ADD ("/file-writer/pieces", test_pieces);
  ADD ("/file-writer/not-finite", test_not_finite);
  ADD ("/file-writer/larger-than-buffer", test_larger_than_buffer);
  ADD ("/file-writer/failure-keeps-the-old", test_failure_keeps_the_old);
  ADD ("/file-writer/mode-and-link", test_mode_and_link);
  ADD ("/file-writer/refused", test_refused);
  ADD ("/file-writer/device", test_device);
#undef ADD
}
