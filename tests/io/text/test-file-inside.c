#include "io/text/file-read.h"

#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

#include <glib/gstdio.h>
#include <unistd.h>

/* A folder with a project's folder "project" in it, and links that lead out of it. */
static char *
make_folders (void)
{
  char *root = test_scratch_new ();
  g_autofree char *project = g_build_filename (root, "project", NULL);
  g_autofree char *pictures = g_build_filename (project, "pictures", NULL);
  g_autofree char *other = g_build_filename (root, "project-2", NULL);
  g_assert_cmpint (g_mkdir_with_parents (pictures, 0700), ==, 0);
  g_assert_cmpint (g_mkdir (other, 0700), ==, 0);
  static const char *const links[][2] = { { "out", "../project-2" },
                                          { "in", "pictures" },
                                          { "nowhere.png", "../new.png" },
                                          { "round.png", "round.png" } };
  for (guint i = 0; i < G_N_ELEMENTS (links); i++) {
    g_autofree char *link = g_build_filename (project, links[i][0], NULL);
    g_assert_cmpint (symlink (links[i][1], link), ==, 0);
  }
  return root;
}

static void
test_inside (void)
{
  char *root = make_folders ();
  g_autofree char *project = g_build_filename (root, "project", NULL);
  g_autofree char *absolute = g_build_filename (project, "a.png", NULL);
  const char *inside[] = { "a.png",    "./a.png",     "pictures/b.png",
                           "in/b.png", "in/../a.png", absolute,
                           "-",        "..a.png",     "pictures/../a",
                           "in" };
  for (guint i = 0; i < G_N_ELEMENTS (inside); i++) {
    g_autoptr (GError) error = NULL;
    g_autofree char *path = qn_file_inside (project, inside[i], FALSE, &error);
    g_assert_no_error (error);
    g_autofree char *expected = g_path_is_absolute (inside[i])
                                  ? g_strdup (inside[i])
                                  : g_build_filename (project, inside[i], NULL);
    g_assert_cmpstr (path, ==, expected);
  }
  test_scratch_free (root);
}

static void
test_outside (void)
{
  char *root = make_folders ();
  g_autofree char *project = g_build_filename (root, "project", NULL);
  const char *outside[] = { "/etc/passwd", "../a.png",      "../project-2/a.png",
                            "out/a.png",   "out",           "..",
                            ".",           "nowhere.png",   "pictures/../../a.png",
                            "round.png",   "in/../../a.png" };
  for (guint i = 0; i < G_N_ELEMENTS (outside); i++) {
    g_autoptr (GError) error = NULL;
    g_autofree char *path = qn_file_inside (project, outside[i], FALSE, &error);
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE);
    g_assert_null (path);
    g_autofree char *allowed = qn_file_inside (project, outside[i], TRUE, NULL);
    g_assert_nonnull (allowed);
  }
  /* A folder that is missing is told as that. */
  const char *missing[] = { "none/a.png", "none/x/a.png", "../none/a.png" };
  for (guint i = 0; i < G_N_ELEMENTS (missing); i++) {
    g_autoptr (GError) absent = NULL;
    g_assert_null (qn_file_inside (project, missing[i], FALSE, &absent));
    g_assert_error (absent, QN_IO_ERROR, QN_IO_ERROR_FILE);
  }
  /* A project without a place has no inside. */
  g_autoptr (GError) error = NULL;
  g_assert_null (qn_file_inside (NULL, "a.png", FALSE, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE);
  test_scratch_free (root);
}

QN_TESTS
{
  g_test_add_func ("/file-inside/inside", test_inside);
  g_test_add_func ("/file-inside/outside", test_outside);
}
