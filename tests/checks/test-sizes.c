/* Nothing is left for later. Long files and functions are listed as hints and do not fail: one page
 * that tells one algorithm is better than many parts that are each called once. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

enum { LONGEST_FILE = 800, LONGEST_FUNCTION = 80 };

/* Put together at run time, so that this file does not contain what it looks for. */
static const char *const unfinished[][2] = { { "TO", "DO" },
                                             { "FIX", "ME" },
                                             { "XX", "X:" } };

/* Counts from the opening to the closing brace in the first column, both left out. */
static void
list_functions (const char *path, char **lines, GString *hints)
{
  int opened = -1;
  for (int i = 0; lines[i] != NULL; i++) {
    if (strcmp (lines[i], "{") == 0)
      opened = i;
    if (strcmp (lines[i], "};") == 0)
      opened = -1;
    if (strcmp (lines[i], "}") == 0 && opened >= 0) {
      if (i - opened - 1 > LONGEST_FUNCTION)
        complain (hints, "%s:%d: function of %d lines", path, opened, i - opened - 1);
      opened = -1;
    }
  }
}

static void
check_file (const char *path, char **lines, GString *complaints, GString *hints)
{
  guint count = g_strv_length (lines);
  if (count > LONGEST_FILE)
    complain (hints, "%s has %u lines", path, count);
  list_functions (path, lines, hints);

  for (guint i = 0; i < count; i++)
    for (size_t k = 0; k < G_N_ELEMENTS (unfinished); k++) {
      g_autofree char *mark = g_strconcat (unfinished[k][0], unfinished[k][1], NULL);
      if (strstr (lines[i], mark) != NULL)
        complain (complaints, "%s:%u: unfinished", path, i + 1);
    }
}

static void
test_sizes (void)
{
  static const char *const suffixes[] = { ".c", ".h", NULL };
  static const char *const folders[] = { "src", "tests" };
  GString *complaints = g_string_new (NULL), *hints = g_string_new (NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++) {
    g_autoptr (GPtrArray) files = source_tree_files (folders[i], suffixes);
    for (guint k = 0; k < files->len; k++) {
      const char *path = g_ptr_array_index (files, k);
      g_auto (GStrv) lines = source_tree_lines (path);
      check_file (path, lines, complaints, hints);
    }
  }
  if (hints->len > 0)
    g_test_message ("hints:\n%s", hints->str);
  g_string_free (hints, TRUE);
  assert_no_complaints (complaints);
}

static char **
make_lines (const char *before, guint count, const char *after)
{
  g_autoptr (GString) text = g_string_new (before);
  for (guint i = 0; i < count; i++)
    g_string_append (text, "x\n");
  g_string_append (text, after);
  char **lines = g_strsplit (text->str, "\n", -1);
  return lines;
}

/* What is found in `lines` is a complaint that contains `complaint` and a hint that contains `hint`,
 * or none of them where that is NULL. */
static void
expect (char **lines, const char *complaint, const char *hint)
{
  GString *complaints = g_string_new (NULL), *hints = g_string_new (NULL);
  check_file ("a.c", lines, complaints, hints);
  if (complaint != NULL)
    assert_complaint (complaints, complaint);
  else
    assert_no_complaints (complaints);
  if (hint != NULL)
    assert_complaint (hints, hint);
  else
    assert_no_complaints (hints);
  g_strfreev (lines);
}

static void
test_check_can_fail (void)
{
  expect (make_lines ("int\nf (void)\n{\n", LONGEST_FUNCTION + 1, "}\n"), NULL,
          "function of 81");
  expect (make_lines ("int\nf (void)\n{\n", LONGEST_FUNCTION, "}\n"), NULL, NULL);
  expect (make_lines ("", LONGEST_FILE + 1, ""), NULL, "lines");
  expect (make_lines ("/* TO"
                      "DO later */\n",
                      1, ""),
          "unfinished", NULL);
}

QN_TESTS
{
  g_test_add_func ("/checks/sizes/tree", test_sizes);
  g_test_add_func ("/checks/sizes/can-fail", test_check_can_fail);
}
