#include "io/json/json-value.h"

#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

typedef struct Fixture {
  QnReader reader;
  cJSON *document;
  QnJsonValue root;
} Fixture;

static const char text[] =
  "{ \"n\": -1.5, \"c\": 3, \"h\": 2.5, \"s\": \"two\", \"b\": true,\n"
  "  \"v\": [1, 2], \"w\": [1], \"x\": [1, \"2\"], \"inf\": 1e999 }";

static void
set_up (Fixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->document = qn_json_parse (text, strlen (text), "f", NULL);
  fixture->reader = (QnReader){ .name = "f",
                                .text = text,
                                .length = strlen (text),
                                .warnings = g_ptr_array_new_with_free_func (g_free) };
  fixture->root = qn_json_value_root (&fixture->reader, fixture->document);
}

static void
tear_down (Fixture *fixture, gconstpointer data)
{
  (void) data;
  cJSON_Delete (fixture->document);
  g_ptr_array_unref (fixture->reader.warnings);
  g_clear_error (&fixture->reader.error);
}

static void
expect_error (Fixture *fixture, const char *message)
{
  g_assert_error (fixture->reader.error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_cmpstr (fixture->reader.error->message, ==, message);
  g_clear_error (&fixture->reader.error);
}

static const char *const names[] = { "one", "two" };

static void
test_values (Fixture *fixture, gconstpointer data)
{
  (void) data;
  const QnJsonValue *root = &fixture->root;
  double number = 0;
  int32_t count = 0;
  int choice = -1;
  bool flag = false;
  const char *string = NULL;
  QnVec2 vector = { 0, 0 };
  g_assert_true (qn_member_number (root, "n", QN_REQUIRED, QN_RANGE_FINITE, &number));
  g_assert_cmpfloat (number, ==, -1.5);
  g_assert_true (qn_member_count (root, "c", QN_REQUIRED, 3, &count));
  g_assert_cmpint (count, ==, 3);
  g_assert_true (qn_member_bool (root, "b", QN_REQUIRED, &flag));
  g_assert_true (flag);
  g_assert_true (qn_member_string (root, "s", QN_REQUIRED, &string));
  g_assert_cmpstr (string, ==, "two");
  g_assert_true (qn_member_choice (root, "s", QN_REQUIRED, names, 2, &choice));
  g_assert_cmpint (choice, ==, 1);
  g_assert_true (qn_member_vec2 (root, "v", QN_REQUIRED, &vector));
  g_assert_cmpfloat (vector.y, ==, 2);
  g_assert_no_error (fixture->reader.error);
}

static void
test_optional (Fixture *fixture, gconstpointer data)
{
  (void) data;
  double number = 7;
  int choice = 1;
  g_assert_true (
    qn_member_number (&fixture->root, "none", QN_OPTIONAL, QN_RANGE_POSITIVE, &number));
  g_assert_cmpfloat (number, ==, 7);
  g_assert_true (
    qn_member_choice (&fixture->root, "none", QN_OPTIONAL, names, 2, &choice));
  g_assert_cmpint (choice, ==, 1);
  g_assert_false (
    qn_member_number (&fixture->root, "none", QN_REQUIRED, QN_RANGE_POSITIVE, &number));
  expect_error (fixture, "f:1:1: none: required key is missing");
}

static void
test_errors (Fixture *fixture, gconstpointer data)
{
  (void) data;
  const QnJsonValue *root = &fixture->root;
  double number;
  int32_t count;
  int choice;
  QnVec2 vector;
  g_assert_false (
    qn_member_number (root, "n", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE, &number));
  expect_error (fixture, "f:1:8: n: number must not be negative");
  g_assert_false (qn_member_number (root, "n", QN_REQUIRED, QN_RANGE_POSITIVE, &number));
  expect_error (fixture, "f:1:8: n: number must be positive");
  g_assert_false (qn_member_number (root, "inf", QN_REQUIRED, QN_RANGE_FINITE, &number));
  expect_error (fixture, "f:2:48: inf: number is not finite");
  g_assert_false (qn_member_number (root, "s", QN_REQUIRED, QN_RANGE_FINITE, &number));
  expect_error (fixture, "f:1:37: s: expected a number, found a string");
  g_assert_false (qn_member_count (root, "h", QN_REQUIRED, 9, &count));
  expect_error (fixture, "f:1:27: h: expected a whole number from 1 to 9");
  g_assert_false (qn_member_count (root, "c", QN_REQUIRED, 2, &count));
  g_clear_error (&fixture->reader.error);
  g_assert_false (qn_member_choice (root, "s", QN_REQUIRED, names, 1, &choice));
  expect_error (fixture, "f:1:37: s: \"two\" is not one of one");
  g_assert_false (qn_member_vec2 (root, "w", QN_REQUIRED, &vector));
  expect_error (fixture, "f:2:21: w: expected two numbers");
  g_assert_false (qn_member_vec2 (root, "x", QN_REQUIRED, &vector));
  expect_error (fixture, "f:2:35: x[1]: expected a number, found a string");
}

/* Only the first error counts: what follows from it would mislead. */
static void
test_first_error (Fixture *fixture, gconstpointer data)
{
  (void) data;
  QnJsonValue first = qn_json_value_member (&fixture->root, "n");
  QnJsonValue second = qn_json_value_member (&fixture->root, "c");
  g_assert_false (qn_json_value_fail (&first, "one"));
  g_assert_false (qn_json_value_fail (&second, "two"));
  expect_error (fixture, "f:1:8: n: one");
}

static void
test_warnings (Fixture *fixture, gconstpointer data)
{
  (void) data;
  static const char *const known[] = { "n", "c", "h", "s", "b", "v", "w", "x" };
  g_assert_true (qn_json_value_check_keys (&fixture->root, known, G_N_ELEMENTS (known)));
  g_assert_cmpuint (fixture->reader.warnings->len, ==, 1);
  g_assert_cmpstr (g_ptr_array_index (fixture->reader.warnings, 0), ==,
                   "f:2:48: inf: unknown key");

  for (guint i = 0; i < 2 * QN_READER_MAX_WARNINGS; i++)
    qn_json_value_warn (&fixture->root, "again");
  g_assert_cmpuint (fixture->reader.warnings->len, ==, QN_READER_MAX_WARNINGS);
  g_assert_cmpuint (fixture->reader.dropped_warnings, ==, QN_READER_MAX_WARNINGS + 1);
}

static void
test_override_named (Fixture *fixture, gconstpointer data)
{
  (void) data;
  static const char *const overrides[] = { "c=4", "v=[5, 6]", "v[1]=7", "v[0]=8", NULL };
  fixture->reader.overrides = overrides;
  QnJsonValue list = qn_json_value_member (&fixture->root, "v");
  QnJsonValue element = qn_json_value_element (&list, 1, list.json->child->next);
  g_assert_false (qn_json_value_fail (&element, "is wrong"));
  expect_error (fixture, "f: v[1]: is wrong (set by \"v[1]=7\")");
}

QN_TESTS
{
#define ADD(path, test) g_test_add (path, Fixture, NULL, set_up, test, tear_down)
  ADD ("/json-value/values", test_values);
  ADD ("/json-value/optional", test_optional);
  ADD ("/json-value/errors", test_errors);
  ADD ("/json-value/first-error", test_first_error);
  ADD ("/json-value/warnings", test_warnings);
  ADD ("/json-value/override-named", test_override_named);
#undef ADD
}
