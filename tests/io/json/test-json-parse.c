#include "io/json/json-value.h"

#include "io/text/io-error.h"
#include "io/text/json-text.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static void
expect_same (const char *text)
{
  cJSON *value = qn_json_parse (text, strlen (text), "f", NULL);
  g_assert_nonnull (value);
  g_autoptr (GString) written = g_string_new (NULL);
  qn_json_append_value (written, value, 0);
  g_assert_cmpstr (written->str, ==, text);
  cJSON_Delete (value);
}

static void
test_tree (void)
{
  expect_same ("null");
  expect_same ("[]");
  expect_same ("{}");
  expect_same ("[1, [2, [3]], \"ü\", { \"a\": { \"b\": [true, false, null] } }]");
  expect_same ("{ \"z\": 1, \"a\": 2, \"A\": 3 }");
}

static void
test_infinite (void)
{
  cJSON *value = qn_json_parse ("1e999", 5, "f", NULL);
  g_assert_true (cJSON_IsNumber (value));
  g_assert_true (isinf (value->valuedouble));
  cJSON_Delete (value);
}

static void
expect_error (const char *text, const char *message)
{
  g_autoptr (GError) error = NULL;
  g_assert_null (qn_json_parse (text, strlen (text), "wall.quoin", &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_cmpstr (error->message, ==, message);
}

static void
test_errors (void)
{
  expect_error ("", "wall.quoin:1:1: file is empty");
  expect_error ("{\n  \"a\": 1", "wall.quoin:2:9: text ends inside an object");
  expect_error ("{ \"a\": [1, { \"b\": NaN }] }",
                "wall.quoin:1:19: a[1].b: number is not finite");
  expect_error ("{ \"a\": 1 } 2", "wall.quoin:1:12: text after the end of the document");
}

static void
test_duplicate_keys (void)
{
  expect_error ("{ \"a\": 1,\n  \"a\": 2 }", "wall.quoin:2:3: a: key is given twice");
  expect_error ("{ \"a\": 1, \"\\u0061\": 2 }", "wall.quoin:1:11: a: key is given twice");
  expect_error ("[{ \"b\": {}, \"b\": [] }]",
                "wall.quoin:1:13: [0].b: key is given twice");

  /* Far more keys than are compared one by one, and a nested one among them. */
  g_autoptr (GString) text = g_string_new ("{ \"nested\": { \"k\": 1 }");
  for (int i = 0; i < 100000; i++)
    g_string_append_printf (text, ", \"k%d\": [%d]", i, i);
  g_string_append (text, " }");
  g_autoptr (GError) error = NULL;
  cJSON *value = qn_json_parse (text->str, text->len, "f", NULL);
  g_assert_nonnull (value);
  cJSON_Delete (value);

  g_string_truncate (text, text->len - 2);
  g_string_append (text, ", \"k99999\": 0 }");
  g_assert_null (qn_json_parse (text->str, text->len, "f", &error));
  g_assert_nonnull (strstr (error->message, ": k99999: key is given twice"));
}

QN_TESTS
{
  g_test_add_func ("/json-parse/tree", test_tree);
  g_test_add_func ("/json-parse/infinite", test_infinite);
  g_test_add_func ("/json-parse/errors", test_errors);
  g_test_add_func ("/json-parse/duplicate-keys", test_duplicate_keys);
}
