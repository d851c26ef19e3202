#include "io/json/json-value.h"

#include "io/text/io-error.h"
#include "io/text/json-text.h"
#include "support/room.h"

static const char document[] = "{\"a\":{\"b\":1},\"l\":[{\"k\":2},3]}";

static void
expect (const char *override, const char *expected)
{
  cJSON *root = cJSON_Parse (document);
  GError *error = NULL;
  gboolean done = qn_json_override (root, override, &error);
  g_assert_no_error (error);
  g_assert_true (done);
  g_autoptr (GString) written = g_string_new (NULL);
  qn_json_append_value (written, root, 0);
  g_assert_cmpstr (written->str, ==, expected);
  cJSON_Delete (root);
}

static void
test_replace (void)
{
  expect ("a.b=37", "{ \"a\": { \"b\": 37 }, \"l\": [{ \"k\": 2 }, 3] }");
  expect ("l[0].k=-0.5", "{ \"a\": { \"b\": 1 }, \"l\": [{ \"k\": -0.5 }, 3] }");
  expect ("l[1]=[1, 2]", "{ \"a\": { \"b\": 1 }, \"l\": [{ \"k\": 2 }, [1, 2]] }");
  expect ("a={}", "{ \"a\": {}, \"l\": [{ \"k\": 2 }, 3] }");
}

static void
test_add (void)
{
  expect ("a.c=true", "{ \"a\": { \"b\": 1, \"c\": true }, \"l\": [{ \"k\": 2 }, 3] }");
  expect (
    "x.y.z=1",
    "{ \"a\": { \"b\": 1 }, \"l\": [{ \"k\": 2 }, 3], \"x\": { \"y\": { \"z\": 1 } } }");
}

/* What is not JSON is a string. */
static void
test_strings (void)
{
  expect ("a.b=stop", "{ \"a\": { \"b\": \"stop\" }, \"l\": [{ \"k\": 2 }, 3] }");
  expect ("a.b=\"37\"", "{ \"a\": { \"b\": \"37\" }, \"l\": [{ \"k\": 2 }, 3] }");
  expect ("a.b=x=y", "{ \"a\": { \"b\": \"x=y\" }, \"l\": [{ \"k\": 2 }, 3] }");
  expect ("a.b=", "{ \"a\": { \"b\": \"\" }, \"l\": [{ \"k\": 2 }, 3] }");
  expect ("a.b=[1", "{ \"a\": { \"b\": \"[1\" }, \"l\": [{ \"k\": 2 }, 3] }");
}

static void
expect_error (const char *override, const char *reason)
{
  cJSON *root = cJSON_Parse (document);
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_json_override (root, override, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
  g_autoptr (GString) quoted = g_string_new (NULL);
  qn_json_append_string (quoted, override);
  g_assert_true (g_str_has_prefix (error->message, quoted->str));
  g_assert_true (g_str_has_suffix (error->message, reason));
  cJSON_Delete (root);
}

static void
test_errors (void)
{
  expect_error ("", "path=value");
  expect_error ("a.b", "path=value");
  expect_error ("=1", "as laws[0].friction");
  expect_error ("a..b=1", "as laws[0].friction");
  expect_error ("l[2]=1", "l has 2 elements, counted from 0");
  expect_error ("l[0][0]=1", "l[0] is not a list");
  expect_error ("l.x=1", "l is a list, whose elements are l[0], …");
  expect_error ("a.b.c=1", "a.b has no members");
  expect_error ("a[0]=1", "a is not a list");
  expect_error ("l[1].x=1", "l[1] has no members");
  expect_error ("l[j].k=1", "as laws[0].friction");
  expect_error ("ll[0].k=1", "there is no list ll; the nearest known key is \"l\"");
  expect_error ("other[0].k=1", "there is no list other");
}

static void
test_path (void)
{
  char *path = qn_json_override_dup_path ("laws[0].dilatancy=0.65");
  g_assert_cmpstr (path, ==, "laws[0].dilatancy");
  g_free (path);
  path = qn_json_override_dup_path ("[\"a=b\"].c=1");
  g_assert_cmpstr (path, ==, "a=b.c");
  g_free (path);
  g_assert_null (qn_json_override_dup_path ("nothing"));
}

QN_TESTS
{
  g_test_add_func ("/json-override/replace", test_replace);
  g_test_add_func ("/json-override/add", test_add);
  g_test_add_func ("/json-override/strings", test_strings);
  g_test_add_func ("/json-override/errors", test_errors);
  g_test_add_func ("/json-override/path", test_path);
}
