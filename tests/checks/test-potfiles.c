/* po/POTFILES.in names every file with a string to translate, and no file without. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

/* Marks of a translatable string. The core's sentences stand in one list, which extraction
 * takes by its macro's name. */
static const char *const marks[] = {
  "_ (\"", "N_ (\"", "C_ (\"", "ngettext (", "g_dngettext (", "translatable=\"yes\""
};

static gboolean
is_translatable (const char *path, const char *text)
{
  if (strcmp (path, "src/core/base/problem.h") == 0)
    return TRUE;
  for (size_t i = 0; i < G_N_ELEMENTS (marks); i++) {
    const char *found = text;
    while ((found = strstr (found, marks[i])) != NULL) {
      gboolean whole_word =
        found == text || !(g_ascii_isalnum (found[-1]) || found[-1] == '_');
      if (whole_word)
        return TRUE;
      found++;
    }
  }
  return FALSE;
}

static void
check_file (char **listed, const char *path, const char *text, GString *complaints)
{
  gboolean named = g_strv_contains ((const char *const *) listed, path);
  gboolean needed = is_translatable (path, text);
  if (needed && !named)
    complain (complaints, "po/POTFILES.in lacks %s", path);
  if (named && !needed)
    complain (complaints, "po/POTFILES.in names %s, which has no string", path);
}

static void
test_potfiles (void)
{
  static const char *const suffixes[] = { ".c", ".h", ".ui", NULL };
  static const char *const folders[] = { "src", "ui" };
  g_auto (GStrv) listed = source_tree_lines ("po/POTFILES.in");
  GString *complaints = g_string_new (NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++) {
    g_autoptr (GPtrArray) files = source_tree_files (folders[i], suffixes);
    for (guint k = 0; k < files->len; k++) {
      const char *path = g_ptr_array_index (files, k);
      g_autofree char *text = source_tree_read (path);
      check_file (listed, path, text, complaints);
    }
  }
  for (char **line = listed; *line != NULL; line++) {
    g_autofree char *path = g_build_filename (source_tree_root (), *line, NULL);
    if (**line != '\0' && **line != '#' && !g_file_test (path, G_FILE_TEST_IS_REGULAR))
      complain (complaints, "po/POTFILES.in names %s, which does not exist", *line);
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  char *listed[] = { "src/a.c", NULL };
  GString *complaints = g_string_new (NULL);
  check_file (listed, "src/b.c", "puts (_ (\"hello\"));", complaints);
  assert_complaint (complaints, "lacks src/b.c");

  complaints = g_string_new (NULL);
  check_file (listed, "src/a.c", "puts (\"hello\");", complaints);
  assert_complaint (complaints, "no string");

  complaints = g_string_new (NULL);
  check_file (listed, "src/a.c", "puts (_ (\"hello\"));", complaints);
  check_file (listed, "src/b.c", "start_ (\"hello\");", complaints);
  assert_no_complaints (complaints);
}

QN_TESTS
{
  g_test_add_func ("/checks/potfiles/tree", test_potfiles);
  g_test_add_func ("/checks/potfiles/can-fail", test_check_can_fail);
}
