#include "disk/file-group.h"

#include "disk/whole-file.h"
#include "support/room.h"
#include "support/scratch.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <stdlib.h>
#include <string.h>

static void
put (QnFileGroup *group, const char *name, const char *text)
{
  char *path;
  g_assert_cmpint (qn_file_group_add (group, name, &path), ==, 0);
  g_assert_cmpint (qn_whole_file_replace (path, text, strlen (text)), ==, 0);
  g_free (path);
}

static void
expect (const char *folder, const char *name, const char *expected)
{
  g_autofree char *path = g_build_filename (folder, name, NULL), *content = NULL;
  g_assert_true (g_file_get_contents (path, &content, NULL, NULL));
  g_assert_cmpstr (content, ==, expected);
}

static void
set (const char *folder, const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static void
test_commit (void)
{
  QnFileGroup group;
  test_autoscratch char *folder = test_scratch_new ();
  set (folder, "a", "old a");
  g_assert_cmpint (qn_file_group_open (&group, folder), ==, 0);
  put (&group, "a", "new a");
  put (&group, "b", "new b");
  expect (folder, "a", "old a");
  g_assert_cmpint (qn_file_group_commit (&group), ==, 0);
  expect (folder, "a", "new a");
  expect (folder, "b", "new b");
  g_assert_cmpuint (test_scratch_count (folder), ==, 2);
}

static void
test_discard (void)
{
  QnFileGroup group;
  test_autoscratch char *folder = test_scratch_new ();
  set (folder, "a", "old a");
  g_assert_cmpint (qn_file_group_open (&group, folder), ==, 0);
  put (&group, "a", "new a");
  put (&group, "b", "new b");
  qn_file_group_discard (&group);
  expect (folder, "a", "old a");
  g_assert_cmpuint (test_scratch_count (folder), ==, 1);
}

/* The last file is missing: those before it, old and new, come back and go. */
static void
test_undone (void)
{
  QnFileGroup group;
  char *folder = test_scratch_new (), *path;
  set (folder, "a", "old a");
  g_assert_cmpint (qn_file_group_open (&group, folder), ==, 0);
  put (&group, "a", "new a");
  put (&group, "b", "new b");
  g_assert_cmpint (qn_file_group_add (&group, "c", &path), ==, 0);
  g_free (path);
  g_assert_cmpint (qn_file_group_commit (&group), ==, ENOENT);
  expect (folder, "a", "old a");
  g_assert_cmpuint (test_scratch_count (folder), ==, 1);
  test_scratch_free (folder);
}

static void
test_refused (void)
{
  QnFileGroup group;
  char *folder = test_scratch_new (), *path;
  g_autofree char *inner = g_build_filename (folder, "inner", NULL);
  g_assert_cmpint (qn_file_group_open (&group, inner), ==, ENOENT);
  g_assert_cmpint (g_mkdir (inner, 0700), ==, 0);
  g_assert_cmpint (qn_file_group_open (&group, folder), ==, 0);
  g_assert_cmpint (qn_file_group_add (&group, "inner", &path), ==, EISDIR);
  g_assert_null (path);
  qn_file_group_discard (&group);
  g_assert_cmpuint (test_scratch_count (folder), ==, 1);
  test_scratch_free (folder);
}

/* What a killed writer has left goes with the next group; what a living one gathers does not. */
static void
test_left (void)
{
  QnFileGroup living, next;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *dead = g_build_filename (folder, ".gather.abcdef", NULL);
  g_assert_cmpint (g_mkdir (dead, 0700), ==, 0);
  set (dead, "a", "half");
  g_assert_cmpint (qn_file_group_open (&living, folder), ==, 0);
  g_assert_false (g_file_test (dead, G_FILE_TEST_EXISTS));
  put (&living, "a", "new a");
  g_assert_cmpint (qn_file_group_open (&next, folder), ==, 0);
  put (&next, "b", "new b");
  g_assert_cmpint (qn_file_group_commit (&living), ==, 0);
  g_assert_cmpint (qn_file_group_commit (&next), ==, 0);
  expect (folder, "a", "new a");
  expect (folder, "b", "new b");
  g_assert_cmpuint (test_scratch_count (folder), ==, 2);
}

QN_TESTS
{
  g_test_add_func ("/disk/file-group/commit", test_commit);
  g_test_add_func ("/disk/file-group/discard", test_discard);
  g_test_add_func ("/disk/file-group/undone", test_undone);
  g_test_add_func ("/disk/file-group/refused", test_refused);
  g_test_add_func ("/disk/file-group/left", test_left);
}
