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
test_numbers (void)
{
  static const struct {
    const char *text;
    double number;
  } numbers[] = {
    { "0", 0 },           { "-0", 0 },           { "1.5", 1.5 },         { "1e3", 1000 },
    { "-2.5E-1", -0.25 }, { "1e999", INFINITY }, { "-1e999", -INFINITY }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++) {
    cJSON *value = qn_json_parse (numbers[i].text, strlen (numbers[i].text), "f", NULL);
    g_assert_true (cJSON_IsNumber (value));
    g_assert_true (value->valuedouble == numbers[i].number);
    cJSON_Delete (value);
  }
}

static void
test_strings (void)
{
  const char *text = "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\ude00ü\"";
  cJSON *value = qn_json_parse (text, strlen (text), "f", NULL);
  g_assert_cmpstr (value->valuestring, ==, "\"\\/\b\f\n\r\té😀ü");
  g_assert_cmpuint (qn_json_string_length (text), ==, strlen (text));
  g_assert_cmpuint (qn_json_string_length ("\"a"), ==, 0);
  cJSON_Delete (value);
}

/* Values know the byte where they begin; blanks and a byte order mark may stand before the first. */
static void
test_places (void)
{
  const char *text = "\xef\xbb\xbf [ {\"a\": [1, 2], \"b\": {}}, null ]";
  cJSON *value = qn_json_parse (text, strlen (text), "f", NULL);
  g_assert_cmpint (value->valueint, ==, 4);
  const cJSON *a = value->child->child;
  g_assert_cmpint (a->child->next->valueint, ==, strstr (text, "2]") - text);
  g_assert_cmpint (a->next->valueint, ==, strstr (text, "{}") - text);
  g_assert_cmpint (value->child->next->valueint, ==, strstr (text, "null") - text);
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

/* Every error with the byte that it is reported at. */
static void
test_wrong (void)
{
  static const struct {
    const char *text;
    gsize at;
    const char *problem;
  } cases[] = {
    { "", 0, "empty" },
    { "  \n", 3, "empty" },
    { "{", 1, "inside an object" },
    { "[", 1, "value is expected" },
    { "[1", 2, "inside an array" },
    { "[1,", 3, "value is expected" },
    { "[1,]", 3, "not a JSON value" },
    { "[1 2]", 3, "comma" },
    { "{\"a\":1,}", 7, "key in quotes" },
    { "{\"a\" 1}", 5, "colon" },
    { "{\"a\":}", 5, "not a JSON value" },
    { "{a:1}", 1, "key in quotes" },
    { "{\"a\":1]", 6, "comma or }" },
    { "[1}", 2, "comma or ]" },
    { "1 2", 2, "after the end" },
    { "{} x", 3, "after the end" },
    { "\"abc", 0, "no end" },
    { "\"a\nb\"", 2, "control character" },
    { "\"\\x\"", 1, "escape" },
    { "\"\\u12g4\"", 1, "escape" },
    { "\"\\ud800\"", 1, "escape" },
    { "\"\\udc00\"", 1, "escape" },
    { "\"\\u0000\"", 1, "escape" },
    { "\"\\", 1, "escape" },
    { "NaN", 0, "not finite" },
    { "[-Infinity]", 1, "not a number" },
    { "Infinity", 0, "not finite" },
    { "nul", 0, "not a JSON value" },
    { "{\"a\": 1, // one\n \"b\": 2}", 9, "JSON has no comments" },
    { "{ # one\n}", 2, "JSON has no comments" },
    { "[ /* one */ 1]", 2, "JSON has no comments" },
    { "nullx", 0, "not a JSON value" },
    { "01", 0, "number" },
    { "1.", 0, "number" },
    { ".5", 0, "not a JSON value" },
    { "+1", 0, "not a JSON value" },
    { "-", 0, "number" },
    { "1e", 0, "number" },
    { "0x10", 0, "number" },
    { "1.2.3", 0, "number" },
    { "'a'", 0, "not a JSON value" },
    { "// c", 0, "JSON has no comments" },
    { "\"\xff\"", 1, "UTF-8" },
    { "\"\xc3\"", 1, "UTF-8" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autoptr (GError) error = NULL;
    QnJsonPlace place = qn_json_position (cases[i].text, cases[i].at);
    g_autofree char *begin = g_strdup_printf ("f:%zu:%zu: ", place.line, place.column);
    g_assert_null (qn_json_parse (cases[i].text, strlen (cases[i].text), "f", &error));
    g_assert_nonnull (strstr (error->message, cases[i].problem));
    g_assert_true (g_str_has_prefix (error->message, begin));
  }
}

static void
test_nul_byte (void)
{
  g_autoptr (GError) error = NULL;
  g_assert_null (qn_json_parse ("[1,\0 2]", 7, "f", &error));
  g_assert_true (g_str_has_prefix (error->message, "f:1:4: "));
}

/* Ten million brackets end at the limit, at once. */
static void
test_deep_nesting (void)
{
  for (const char *bracket = "[{"; *bracket != '\0'; bracket++) {
    g_autoptr (GError) error = NULL;
    g_autofree char *text = g_strnfill (10000000, *bracket);
    g_assert_null (qn_json_parse (text, strlen (text), "f", &error));
  }

  g_autofree char *open = g_strnfill (QN_JSON_MAX_DEPTH, '['),
                  *close = g_strnfill (QN_JSON_MAX_DEPTH, ']'),
                  *nested = g_strconcat (open, close, NULL);
  cJSON *value = qn_json_parse (nested, strlen (nested), "f", NULL);
  g_assert_nonnull (value);
  cJSON_Delete (value);
  g_autofree char *deeper = g_strconcat ("[", nested, "]", NULL);
  g_assert_null (qn_json_parse (deeper, strlen (deeper), "f", NULL));
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
  g_test_add_func ("/json-parse/numbers", test_numbers);
  g_test_add_func ("/json-parse/strings", test_strings);
  g_test_add_func ("/json-parse/places", test_places);
  g_test_add_func ("/json-parse/wrong", test_wrong);
  g_test_add_func ("/json-parse/nul-byte", test_nul_byte);
  g_test_add_func ("/json-parse/deep-nesting", test_deep_nesting);
  g_test_add_func ("/json-parse/errors", test_errors);
  g_test_add_func ("/json-parse/duplicate-keys", test_duplicate_keys);
}
