#include "io/json/json-scan.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* One letter for every token up to the end or an error (E). */
static char *
tokens (const char *text, QnJsonScanner *scanner)
{
  static const char letters[] = "{}[]ksntfz.E";
  GString *list = g_string_new (NULL);
  qn_json_scanner_init (scanner, text, strlen (text));
  QnJsonToken token;
  do {
    token = qn_json_next (scanner);
    g_string_append_c (list, letters[token]);
  } while (token != QN_JSON_END && token != QN_JSON_ERROR);
  return g_string_free (list, FALSE);
}

static void
expect (const char *text, const char *expected)
{
  QnJsonScanner scanner;
  g_autofree char *found = tokens (text, &scanner);
  g_assert_cmpstr (found, ==, expected);
}

static void
test_tokens (void)
{
  expect ("0", "n.");
  expect (" \t\r\n\"a\" ", "s.");
  expect ("\xef\xbb\xbf{}", "{}.");
  expect ("[]", "[].");
  expect ("[1, \"b\", true, false, null, {}, []]", "[nstfz{}[]].");
  expect ("{\"a\": 1, \"b\": {\"c\": [2]}}", "{knk{k[n]}}.");
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
    QnJsonScanner scanner;
    g_autofree char *found = tokens (cases[i].text, &scanner);
    g_assert_true (g_str_has_suffix (found, "E"));
    g_assert_nonnull (strstr (scanner.problem, cases[i].problem));
    g_assert_cmpuint (scanner.start, ==, cases[i].at);
    g_assert_cmpint (qn_json_next (&scanner), ==, QN_JSON_ERROR);
  }
}

static void
test_nul_byte (void)
{
  QnJsonScanner scanner;
  qn_json_scanner_init (&scanner, "[1,\0 2]", 7);
  while (qn_json_next (&scanner) != QN_JSON_ERROR)
    g_assert_cmpint (scanner.token, !=, QN_JSON_END);
  g_assert_cmpuint (scanner.start, ==, 3);
}

/* Ten million brackets end at the limit, at once. */
static void
test_deep_nesting (void)
{
  for (const char *bracket = "[{"; *bracket != '\0'; bracket++) {
    g_autofree char *text = g_strnfill (10000000, *bracket);
    QnJsonScanner scanner;
    g_autofree char *found = tokens (text, &scanner);
    g_assert_true (g_str_has_suffix (found, "E"));
    g_assert_cmpuint (scanner.start, <=, QN_JSON_MAX_DEPTH);
  }

  g_autoptr (GString) nested = g_string_new (NULL);
  for (int i = 0; i < QN_JSON_MAX_DEPTH; i++)
    g_string_append_c (nested, '[');
  for (int i = 0; i < QN_JSON_MAX_DEPTH; i++)
    g_string_append_c (nested, ']');
  QnJsonScanner scanner;
  g_autofree char *found = tokens (nested->str, &scanner);
  g_assert_true (g_str_has_suffix (found, "."));
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
  QnJsonScanner scanner;
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++) {
    qn_json_scanner_init (&scanner, numbers[i].text, strlen (numbers[i].text));
    g_assert_cmpint (qn_json_next (&scanner), ==, QN_JSON_NUMBER);
    g_assert_true (qn_json_number (&scanner) == numbers[i].number);
  }

  const char *text = "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\ude00ü\"";
  qn_json_scanner_init (&scanner, text, strlen (text));
  g_assert_cmpint (qn_json_next (&scanner), ==, QN_JSON_STRING);
  g_autofree char *string = qn_json_dup_string (&scanner);
  g_assert_cmpstr (string, ==, "\"\\/\b\f\n\r\té😀ü");
  g_assert_true (qn_json_string_is (&scanner, string));
  g_assert_false (qn_json_string_is (&scanner, "é"));
}

static void
test_skip (void)
{
  QnJsonScanner scanner;
  const char *text = "[ {\"a\": [1, 2]}, 3 ]";
  qn_json_scanner_init (&scanner, text, strlen (text));
  qn_json_next (&scanner);
  qn_json_next (&scanner);
  g_assert_true (qn_json_skip (&scanner));
  g_assert_cmpint (qn_json_next (&scanner), ==, QN_JSON_NUMBER);
  g_assert_true (qn_json_skip (&scanner));
  g_assert_cmpint (qn_json_next (&scanner), ==, QN_JSON_END_ARRAY);
}

QN_TESTS
{
  g_test_add_func ("/json-scan/tokens", test_tokens);
  g_test_add_func ("/json-scan/errors", test_errors);
  g_test_add_func ("/json-scan/nul-byte", test_nul_byte);
  g_test_add_func ("/json-scan/deep-nesting", test_deep_nesting);
  g_test_add_func ("/json-scan/values", test_values);
  g_test_add_func ("/json-scan/skip", test_skip);
}
