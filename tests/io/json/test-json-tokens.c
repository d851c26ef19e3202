#include "io/json/json-tokens.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* One letter for every token; E where the text is wrong. */
static char *
tokens (const char *text, QnJson *json)
{
  static const char letters[] = "{[ksntfz";
  GString *list = g_string_new (NULL);
  gboolean scanned = qn_json_scan (json, text, strlen (text), "f");
  for (gsize i = 0; i < json->count; i++)
    g_string_append_c (list, letters[json->tokens[i].type]);
  return g_string_free (g_string_append (list, scanned ? "" : "E"), FALSE);
}

static void
expect (const char *text, const char *expected)
{
  QnJson json;
  g_autofree char *found = tokens (text, &json);
  g_assert_cmpstr (found, ==, expected);
  qn_json_clear (&json);
}

static void
test_tokens (void)
{
  expect ("0", "n");
  expect (" \t\r\n\"a\" ", "s");
  expect ("\xef\xbb\xbf{}", "{");
  expect ("[]", "[");
  expect ("[1, \"b\", true, false, null, {}, []]", "[nstfz{[");
  expect ("{\"a\": 1, \"b\": {\"c\": [2]}}", "{knk{k[n");
}

/* Items of containers are found one behind the other, and by their keys and numbers. */
static void
test_walk (void)
{
  QnJson json;
  const char *text = "[ {\"a\": [1, 2], \"b\": {}}, 3, [] ]";
  g_assert_true (qn_json_scan (&json, text, strlen (text), "f"));
  g_assert_cmpuint (qn_json_count (&json, 0), ==, 3);
  g_assert_cmpuint (qn_json_count (&json, 1), ==, 2);
  gsize a = qn_json_member (&json, 1, "a");
  g_assert_cmpfloat (qn_json_number (&json, a + 2), ==, 2);
  g_assert_cmpuint (json.tokens[a].next, ==, a + 3);
  g_assert_cmpuint (qn_json_member (&json, 1, "c"), ==, 0);
  g_assert_cmpuint (qn_json_member (&json, 0, "a"), ==, 0);
  g_autofree char *path = qn_json_dup_path (&json, a + 2);
  g_assert_cmpstr (path, ==, "[0].a[1]");
  qn_json_fail (&json, a + 2, "is wrong");
  qn_json_fail (&json, 0, "is wrong too");
  g_assert_cmpstr (json.error->message, ==, "f:1:13: [0].a[1]: is wrong");
  qn_json_clear (&json);
}

/* Every error with the byte that it is reported at. */
static void
test_errors (void)
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
    QnJson json;
    g_autofree char *found = tokens (cases[i].text, &json);
    g_assert_true (g_str_has_suffix (found, "E"));
    g_assert_nonnull (strstr (json.error->message, cases[i].problem));
    g_assert_cmpuint (json.trouble, ==, cases[i].at);
    qn_json_clear (&json);
  }
}

static void
test_nul_byte (void)
{
  QnJson json;
  g_assert_false (qn_json_scan (&json, "[1,\0 2]", 7, "f"));
  g_assert_cmpuint (json.trouble, ==, 3);
  qn_json_clear (&json);
}

/* Ten million brackets end at the limit, at once. */
static void
test_deep_nesting (void)
{
  QnJson json;
  for (const char *bracket = "[{"; *bracket != '\0'; bracket++) {
    g_autofree char *text = g_strnfill (10000000, *bracket);
    g_autofree char *found = tokens (text, &json);
    g_assert_true (g_str_has_suffix (found, "E"));
    g_assert_cmpuint (json.trouble, <=, QN_JSON_MAX_DEPTH);
    qn_json_clear (&json);
  }

  g_autoptr (GString) nested = g_string_new (NULL);
  for (int i = 0; i < QN_JSON_MAX_DEPTH; i++)
    g_string_append_c (nested, '[');
  for (int i = 0; i < QN_JSON_MAX_DEPTH; i++)
    g_string_append_c (nested, ']');
  g_assert_true (qn_json_scan (&json, nested->str, nested->len, "f"));
  qn_json_clear (&json);
}

static void
test_values (void)
{
  static const struct {
    const char *text;
    double number;
  } numbers[] = {
    { "0", 0 },           { "-0", 0 },           { "1.5", 1.5 },         { "1e3", 1000 },
    { "-2.5E-1", -0.25 }, { "1e999", INFINITY }, { "-1e999", -INFINITY }
  };
  QnJson json;
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++) {
    g_assert_true (qn_json_scan (&json, numbers[i].text, strlen (numbers[i].text), "f"));
    g_assert_true (qn_json_number (&json, 0) == numbers[i].number);
    qn_json_clear (&json);
  }

  const char *text = "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\ude00ü\"";
  g_assert_true (qn_json_scan (&json, text, strlen (text), "f"));
  g_autofree char *string = qn_json_dup_string (&json, 0);
  g_assert_cmpstr (string, ==, "\"\\/\b\f\n\r\té😀ü");
  g_assert_true (qn_json_string_is (&json, 0, string));
  g_assert_false (qn_json_string_is (&json, 0, "é"));
  g_assert_false (qn_json_string_is (&json, 0, "\""));
  g_assert_cmpuint (qn_json_string_length (text), ==, strlen (text));
  g_assert_cmpuint (qn_json_string_length ("\"a"), ==, 0);
  qn_json_clear (&json);
}

QN_TESTS
{
  g_test_add_func ("/json-tokens/tokens", test_tokens);
  g_test_add_func ("/json-tokens/errors", test_errors);
  g_test_add_func ("/json-tokens/nul-byte", test_nul_byte);
  g_test_add_func ("/json-tokens/deep-nesting", test_deep_nesting);
  g_test_add_func ("/json-tokens/values", test_values);
  g_test_add_func ("/json-tokens/walk", test_walk);
}
