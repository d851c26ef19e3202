#include "io/json/json-path.h"
#include "support/room.h"

#include <glib.h>

/* Writes the steps back in the one spelling. */
static char *
spell (const char *text)
{
  GArray *steps = qn_json_path_parse (text);
  if (steps == NULL)
    return NULL;
  char *path = qn_json_path_dup_text (steps);
  g_array_unref (steps);
  return path;
}

static void
expect (const char *text, const char *spelling)
{
  g_autofree char *spelt = spell (text);
  g_assert_cmpstr (spelt, ==, spelling);
}

static void
test_paths (void)
{
  expect ("", "");
  expect ("title", "title");
  expect ("analysis.increments", "analysis.increments");
  expect ("laws[0].dilatancy", "laws[0].dilatancy");
  expect ("walls[1].courses[2][12]", "walls[1].courses[2][12]");
  expect ("[3]", "[3]");
  expect ("a[\"b.c\"].d", "a[\"b.c\"].d");
  expect ("[\"plain\"]", "plain");
  expect ("a[\"\\\"\\\\\"]", "a[\"\\\"\\\\\"]");
  expect ("a[\"\\n\"].b", "a[\"\\n\"].b");
  expect ("[\"\"]", "[\"\"]");
}

static void
test_not_a_path (void)
{
  static const char *const texts[] = {
    ".",     ".a",     "a.",      "a..b",      "a[",
    "a[]",   "a[x]",   "a[-1]",   "a[1",       "a[1]b",
    "a]",    "a[\"b]", "a[\"b\"", "a\"b",      "[+1]",
    "a[ 1]", "a[1 ]",  "a[.]",    "a[\"b\"]c", "a[99999999999999999999]"
  };
  for (gsize i = 0; i < G_N_ELEMENTS (texts); i++)
    expect (texts[i], NULL);
}

static void
test_is_within (void)
{
  g_assert_true (qn_json_path_is_within ("laws[0].kn", "laws[0]"));
  g_assert_true (qn_json_path_is_within ("laws[0].kn", "laws"));
  g_assert_true (qn_json_path_is_within ("laws", "laws"));
  g_assert_true (qn_json_path_is_within ("laws", ""));
  g_assert_false (qn_json_path_is_within ("laws", "laws[0]"));
  g_assert_false (qn_json_path_is_within ("laws[10]", "laws[1]"));
  g_assert_false (qn_json_path_is_within ("lawsuit", "laws"));
}

QN_TESTS
{
  g_test_add_func ("/json-path/paths", test_paths);
  g_test_add_func ("/json-path/not-a-path", test_not_a_path);
  g_test_add_func ("/json-path/is-within", test_is_within);
}
