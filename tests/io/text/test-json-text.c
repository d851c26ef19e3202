#include "io/text/json-text.h"
#include "support/room.h"

#include <cjson/cJSON.h>
#include <glib.h>

static void
expect_string (const char *text, const char *expected)
{
  g_autoptr (GString) json = g_string_new (NULL);
  qn_json_append_string (json, text);
  g_assert_cmpstr (json->str, ==, expected);
}

static void
test_string (void)
{
  expect_string ("", "\"\"");
  expect_string ("Würfel", "\"Würfel\"");
  expect_string ("a\"b\\c/", "\"a\\\"b\\\\c/\"");
  expect_string ("\n\t\r\x01", "\"\\n\\t\\u000d\\u0001\"");
  expect_string ("\u202ea\u202bb\u2066c\u2029\u00e2",
                 "\"\\u202ea\\u202bb\\u2066c\\u2029\u00e2\"");
}

static void
expect_value (const char *source, const char *expected)
{
  cJSON *value = cJSON_Parse (source);
  g_autoptr (GString) json = g_string_new (NULL);
  qn_json_append_value (json, value, 2);
  g_assert_cmpstr (json->str, ==, expected);
  cJSON_Delete (value);
}

static void
test_value (void)
{
  expect_value ("null", "null");
  expect_value ("true", "true");
  expect_value ("-0.5", "-0.5");
  expect_value ("[]", "[]");
  expect_value ("{}", "{}");
  expect_value ("[1,[2,\"x\"],{\"a\":false}]", "[1, [2, \"x\"], { \"a\": false }]");
}

/* What does not fit on a line is broken at its outermost container only. */
static void
test_long_value (void)
{
  expect_value ("{\"numbers\":[1,2,3],\"text\":\"0123456789012345678901234567890123456789"
                "0123456789012345678901234567890123456789\"}",
                "{\n    \"numbers\": [1, 2, 3],\n    \"text\": "
                "\"0123456789012345678901234567890123456789"
                "0123456789012345678901234567890123456789\"\n  }");
}

QN_TESTS
{
  g_test_add_func ("/json-text/string", test_string);
  g_test_add_func ("/json-text/value", test_value);
  g_test_add_func ("/json-text/long-value", test_long_value);
}
