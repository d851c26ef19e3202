#include "io/json/json-locate.h"

#include <glib.h>
#include <string.h>

static const char text[] = "{ \"a\": 1,\n"
                           "  \"b\": [ 10, { \"c\": \"ü\", \"d\": [[2, 3]] } ],\n"
                           "  \"e.f\": true }";

static void
expect (const char *path, const char *value)
{
  gsize offset = qn_json_locate (text, strlen (text), path);
  g_assert_true (strncmp (text + offset, value, strlen (value)) == 0);
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
  gsize line, column;
  qn_json_position (text, 0, &line, &column);
  g_assert_cmpuint (line, ==, 1);
  g_assert_cmpuint (column, ==, 1);

  qn_json_position (text, qn_json_locate (text, strlen (text), "b"), &line, &column);
  g_assert_cmpuint (line, ==, 2);
  g_assert_cmpuint (column, ==, 8);

  /* The column counts characters, not bytes: ü is two of these. */
  qn_json_position (text, qn_json_locate (text, strlen (text), "b[1].d"), &line, &column);
  g_assert_cmpuint (line, ==, 2);
  g_assert_cmpuint (column, ==, 31);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/json-locate/locate", test_locate);
  g_test_add_func ("/json-locate/missing", test_missing);
  g_test_add_func ("/json-locate/position", test_position);
  return g_test_run ();
}
