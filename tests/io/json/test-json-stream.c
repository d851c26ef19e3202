#include "io/json/json-stream.h"

#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

typedef struct Record {
  double number;
  gint32 count;
  gint64 bytes;
  char *name;
  double triple[3];
  double sum;
} Record;

static gboolean
read_triple (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_numbers (stream, target, 3);
}

static gboolean
add_element (QnJsonStream *stream, gpointer target)
{
  double number;
  if (!qn_json_stream_number (stream, &number))
    return FALSE;
  *(double *) target += number;
  return TRUE;
}

static gboolean
read_sum (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, add_element, target);
}

static gboolean
read_record (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "number", qn_json_stream_number, offsetof (Record, number), QN_JSON_REQUIRED },
    { "count", qn_json_stream_int32, offsetof (Record, count), QN_JSON_OPTIONAL },
    { "bytes", qn_json_stream_int64, offsetof (Record, bytes), QN_JSON_OPTIONAL },
    { "name", qn_json_stream_string, offsetof (Record, name), QN_JSON_OPTIONAL },
    { "triple", read_triple, offsetof (Record, triple), QN_JSON_OPTIONAL },
    { "sum", read_sum, offsetof (Record, sum), QN_JSON_OPTIONAL },
  };
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

static void
test_record (void)
{
  const char *text =
    "{ \"unknown\": {\"number\": [\"deep\", {}]}, \"sum\": [1, 2, 3.5],\n"
    "\"count\": 4, \"bytes\": 5000000000, \"name\": \"ü\",\n"
    "\"triple\": [1, 2, 3], \"number\": -0.25 }";
  QnJsonStream stream;
  Record record = { 0 };
  qn_json_stream_init (&stream, text, strlen (text), "f");
  g_assert_true (qn_json_stream_document (&stream, read_record, &record));
  g_assert_no_error (stream.error);
  g_assert_cmpfloat (record.number, ==, -0.25);
  g_assert_cmpint (record.count, ==, 4);
  g_assert_cmpint (record.bytes, ==, 5000000000);
  g_assert_cmpstr (record.name, ==, "ü");
  g_assert_cmpfloat (record.triple[2], ==, 3);
  g_assert_cmpfloat (record.sum, ==, 6.5);
  g_free (record.name);
}

static void
test_errors (void)
{
  static const char *const cases[][2] = {
    { "", "f:1:1: file is empty" },
    { "[]", "f:1:1: expected an object" },
    { "{}", "f:1:1: number: required key is missing" },
    { "{ \"number\": 1", "f:1:14: text ends inside an object" },
    { "{ \"number\": 1 } 2", "f:1:17: text after the end of the document" },
    { "{ \"number\": \"1\" }", "f:1:13: number: expected a number" },
    { "{ \"number\": 1e999 }", "f:1:13: number: number is not finite" },
    { "{ \"number\": NaN }", "f:1:13: number: number is not finite" },
    { "{ \"number\": 1, \"number\": 2 }", "f:1:16: number: key is given twice" },
    { "{ \"count\": -1 }",
      "f:1:12: count: expected a whole number that is not negative" },
    { "{ \"count\": 2147483648 }",
      "f:1:12: count: expected a whole number that is not negative" },
    { "{ \"name\": 1 }", "f:1:11: name: expected a string" },
    { "{ \"triple\": [1, 2] }", "f:1:18: triple: expected a number" },
    { "{ \"triple\": [1, 2, 3, 4] }", "f:1:23: triple: array has too many elements" },
    { "{ \"sum\": 1 }", "f:1:10: sum: expected an array" },
    { "{ \"sum\": [1, \"2\"] }", "f:1:14: sum[1]: expected a number" },
    { "{ \"sum\": [1, 2", "f:1:15: sum[2]: text ends inside an array" },
    { "{ \"skipped\": [1, }", "f:1:18: this is not a JSON value" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnJsonStream stream;
    Record record = { 0 };
    qn_json_stream_init (&stream, cases[i][0], strlen (cases[i][0]), "f");
    g_assert_false (qn_json_stream_document (&stream, read_record, &record));
    g_assert_error (stream.error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_cmpstr (stream.error->message, ==, cases[i][1]);
    g_error_free (stream.error);
    g_free (record.name);
  }
}

static void
test_fail_at (void)
{
  const char *text = "{ \"a\": [1,\n 2] }";
  QnJsonStream stream;
  qn_json_stream_init (&stream, text, strlen (text), "f");
  g_assert_false (qn_json_stream_fail_at (&stream, "a[1]", "is wrong"));
  g_assert_cmpstr (stream.error->message, ==, "f:2:2: a[1]: is wrong");
  g_error_free (stream.error);
}

QN_TESTS
{
  g_test_add_func ("/json-stream/record", test_record);
  g_test_add_func ("/json-stream/errors", test_errors);
  g_test_add_func ("/json-stream/fail-at", test_fail_at);
}
