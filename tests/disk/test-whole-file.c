#include "disk/whole-file.h"

#include "support/room.h"
#include "support/scratch.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static void
test_new_and_old (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  g_assert_cmpint (qn_whole_file_replace (fixture->path, "one", 3), ==, 0);
  test_scratch_expect (fixture->path, "one");
  g_assert_cmpint (g_chmod (fixture->path, 0640), ==, 0);
  g_assert_cmpint (qn_whole_file_replace (fixture->path, "two", 3), ==, 0);
  test_scratch_expect (fixture->path, "two");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);

  struct stat status;
  g_assert_cmpint (stat (fixture->path, &status), ==, 0);
  g_assert_cmpint (status.st_mode & 07777, ==, 0640);
}

static void
test_discard (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  for (int old = 0; old < 2; old++) {
    QnWholeFile file;
    if (old == 1)
      g_assert_cmpint (qn_whole_file_replace (fixture->path, "old", 3), ==, 0);
    g_assert_cmpint (qn_whole_file_open (&file, fixture->path), ==, 0);
    g_assert_cmpint (qn_whole_file_write (&file, "new", 3), ==, 0);
    qn_whole_file_discard (&file);
    g_assert_cmpuint (test_scratch_count (fixture->folder), ==, (guint) old);
  }
  test_scratch_expect (fixture->path, "old");
}

/* Who is faster has made the file: it is replaced all the same. */
static void
test_made_meanwhile (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  QnWholeFile file;
  g_assert_cmpint (qn_whole_file_open (&file, fixture->path), ==, 0);
  g_assert_cmpint (qn_whole_file_write (&file, "mine", 4), ==, 0);
  g_assert_true (g_file_set_contents (fixture->path, "theirs", -1, NULL));
  g_assert_cmpint (qn_whole_file_commit (&file), ==, 0);
  test_scratch_expect (fixture->path, "mine");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);
}

/* A link to a file that is not there yet gets it where the link leads, as with a redirection; where it
 * leads to no folder, or to itself, nothing is written. */
static void
test_link_to_nothing (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  static const struct {
    const char *to;
    int trouble;
  } cases[] = {
    { "sub/new", 0 }, { "chain", 0 }, { "none/new", ENOENT }, { "link", ELOOP }
  };
  g_autofree char *sub = g_build_filename (fixture->folder, "sub", NULL);
  g_autofree char *chain = g_build_filename (fixture->folder, "chain", NULL);
  g_autofree char *link = g_build_filename (fixture->folder, "link", NULL);
  g_autofree char *new = g_build_filename (sub, "new", NULL);
  g_assert_cmpint (g_mkdir (sub, 0700), ==, 0);
  g_assert_cmpint (symlink (new, chain), ==, 0);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_assert_cmpint (symlink (cases[i].to, link), ==, 0);
    g_assert_cmpint (qn_whole_file_replace (link, "new", 3), ==, cases[i].trouble);
    g_assert_true (g_file_test (link, G_FILE_TEST_IS_SYMLINK));
    g_assert_cmpint (g_file_test (new, G_FILE_TEST_EXISTS), ==, cases[i].trouble == 0);
    g_remove (link);
    g_remove (new);
  }
  g_remove (chain);
  g_rmdir (sub);
}

static void
test_link (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  g_autofree char *link = g_build_filename (fixture->folder, "link", NULL);
  g_assert_cmpint (qn_whole_file_replace (fixture->path, "old", 3), ==, 0);
  g_assert_cmpint (symlink ("file", link), ==, 0);
  g_assert_cmpint (qn_whole_file_replace (link, "new", 3), ==, 0);
  g_assert_true (g_file_test (link, G_FILE_TEST_IS_SYMLINK));
  test_scratch_expect (fixture->path, "new");
}

static void
test_refused (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  QnWholeFile file;
  g_autofree char *missing = g_build_filename (fixture->folder, "no", "file", NULL);
  g_autofree char *name = g_strnfill (300, 'a');
  g_autofree char *longest = g_build_filename (fixture->folder, name, NULL);
  g_autofree char *fits = g_strndup (longest, strlen (fixture->folder) + 1 + 255);

  g_assert_cmpint (qn_whole_file_open (&file, fixture->folder), ==, EISDIR);
  g_assert_cmpint (qn_whole_file_open (&file, missing), ==, ENOENT);
  g_assert_cmpint (qn_whole_file_replace (longest, "", 0), ==, ENAMETOOLONG);
  g_assert_cmpint (qn_whole_file_replace ("/dev/full", "x", 1), ==, ENOSPC);
  g_assert_cmpint (qn_whole_file_replace ("/dev/null", "x", 1), ==, 0);
  g_assert_cmpint (qn_whole_file_replace (fits, "x", 1), ==, 0);
  g_assert_cmpint (qn_whole_file_replace (fits, "y", 1), ==, 0);
  test_scratch_expect (fits, "y");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);
}

/* A writer that is killed leaves the old file and no trace, where the system has files without
 * a name. */
static void
test_kill (TestScratchFile *fixture, gconstpointer data)
{
  (void) data;
  int status, fd = open (fixture->folder, O_RDWR | O_TMPFILE, 0600);
  if (fd < 0) {
    g_test_skip ("no files without a name here");
    return;
  }
  close (fd);
  g_assert_cmpint (qn_whole_file_replace (fixture->path, "old", 3), ==, 0);
  pid_t writer = fork ();
  if (writer == 0) {
    QnWholeFile file;
    if (qn_whole_file_open (&file, fixture->path) == 0
        && qn_whole_file_write (&file, "half", 4) == 0)
      kill (getpid (), SIGKILL);
    _exit (1);
  }
  g_assert_cmpint (waitpid (writer, &status, 0), ==, writer);
  g_assert_true (WIFSIGNALED (status) && WTERMSIG (status) == SIGKILL);
  test_scratch_expect (fixture->path, "old");
  g_assert_cmpuint (test_scratch_count (fixture->folder), ==, 1);
}

QN_TESTS
{
  static const struct {
    const char *path;
    void (*function) (TestScratchFile *fixture, gconstpointer data);
  } tests[] = {
    { "/disk/whole-file/new-and-old", test_new_and_old },
    { "/disk/whole-file/discard", test_discard },
    { "/disk/whole-file/made-meanwhile", test_made_meanwhile },
    { "/disk/whole-file/link", test_link },
    { "/disk/whole-file/link-to-nothing", test_link_to_nothing },
    { "/disk/whole-file/refused", test_refused },
    { "/disk/whole-file/kill", test_kill },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add (tests[i].path, TestScratchFile, NULL, test_scratch_file_set_up,
                tests[i].function, test_scratch_file_tear_down);
}
