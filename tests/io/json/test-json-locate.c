#include "io/json/json-path.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

static const char text[] = "{ \"a\": 1,\n"
                           "  \"b\": [ 10, { \"c\": \"ü\", \"d\": [[2, 3]] } ],\n"
                           "  \"e.f\": true }";

/* The value that a path leads to begins so. */
static void
expect (const char *path, const char *value)
{
  QnJsonPlace place = qn_json_locate (text, strlen (text), path), at;
  const char *found = text;
  do {
    found = strstr (found + (found > text), value);
    g_assert_nonnull (found);
    at = qn_json_position (text, (gsize) (found - text));
  } while (at.line != place.line || at.column != place.column);
}

static void
test_locate (void)
{
  expect ("", "{ \"a\"");
  expect ("a", "1,");
  expect ("b", "[ 10");
  expect ("b[0]", "10,");
  expect ("b[1]", "{ \"c\"");
  expect ("b[1].c", "\"ü\"");
  expect ("b[1].d[0][1]", "3]");
  expect ("[\"e.f\"]", "true");
}

/* A missing key is shown at the object that lacks it. */
static void
test_missing (void)
{
  expect ("x", "{ \"a\"");
  expect ("b[1].x", "{ \"c\"");
  expect ("b[7]", "[ 10");
  expect ("b.c", "[ 10");
  expect ("a[0].y", "1,");
  expect ("not a [path", "{ \"a\"");
}

static void
test_position (void)
{
  QnJsonPlace place = qn_json_position (text, 0);
  g_assert_cmpuint (place.line, ==, 1);
  g_assert_cmpuint (place.column, ==, 1);

  place = qn_json_locate (text, strlen (text), "b");
  g_assert_cmpuint (place.line, ==, 2);
  g_assert_cmpuint (place.column, ==, 8);

  /* The column counts characters, not bytes: ü is two of these. */
  place = qn_json_locate (text, strlen (text), "b[1].d");
  g_assert_cmpuint (place.line, ==, 2);
  g_assert_cmpuint (place.column, ==, 31);
}

/* All at once are where each is by itself, those too that lead to nothing or are no path. */
static void
test_all (void)
{
  static const char list[] =
    "{ \"x\": 0,\n \"l\": [ 1,\n\n  { \"ü\": [] }, \"ü\", [2,\n3], 4 ], \"a.b\": [[5]] }";
  static const char *const wanted[] = {
    "l[4]", "x",         "l[1].ü", "l[1]", "l[3][1]",         "l[0]", "l[3]",    "l[2]",
    "y",    "l[9].z[2]", "x[1]",   "",     "[\"a.b\"][0][0]", "l",    "l[3][1]", "not a ["
  };
  g_autoptr (GPtrArray) paths = g_ptr_array_new ();
  for (gsize i = 0; i < G_N_ELEMENTS (wanted); i++)
    g_ptr_array_add (paths, (gpointer) wanted[i]);
  g_autofree QnJsonPlace *places = qn_json_locate_all (list, strlen (list), paths);
  for (guint i = 0; i < paths->len; i++) {
    QnJsonPlace place = qn_json_locate (list, strlen (list), wanted[i]);
    g_assert_cmpuint (places[i].line, ==, place.line);
    g_assert_cmpuint (places[i].column, ==, place.column);
  }
}

QN_TESTS
{
  g_test_add_func ("/json-locate/locate", test_locate);
  g_test_add_func ("/json-locate/missing", test_missing);
  g_test_add_func ("/json-locate/position", test_position);
  g_test_add_func ("/json-locate/all", test_all);
}
