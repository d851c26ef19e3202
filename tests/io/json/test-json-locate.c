#include "io/json/json-locate.h"
#include "support/room.h"

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

/* All elements at once are where each is by itself. */
static void
test_elements (void)
{
  static const char list[] =
    "{ \"x\": 0,\n \"l\": [ 1,\n\n  { \"ü\": [] }, \"ü\", [2,\n3], 4 ] }";
  g_autoptr (GArray) places = qn_json_locate_elements (list, strlen (list), "l");
  g_assert_cmpuint (places->len, ==, 5);
  for (guint i = 0; i < places->len; i++) {
    g_autofree char *path = g_strdup_printf ("l[%u]", i);
    QnJsonPlace place;
    qn_json_position (list, qn_json_locate (list, strlen (list), path), &place.line,
                      &place.column);
    g_assert_cmpuint (g_array_index (places, QnJsonPlace, i).line, ==, place.line);
    g_assert_cmpuint (g_array_index (places, QnJsonPlace, i).column, ==, place.column);
  }
  g_autoptr (GArray) none = qn_json_locate_elements (list, strlen (list), "x");
  g_assert_cmpuint (none->len, ==, 0);
  g_autoptr (GArray) missing = qn_json_locate_elements (list, strlen (list), "y");
  g_assert_cmpuint (missing->len, ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/json-locate/locate", test_locate);
  g_test_add_func ("/json-locate/missing", test_missing);
  g_test_add_func ("/json-locate/position", test_position);
  g_test_add_func ("/json-locate/elements", test_elements);
}
