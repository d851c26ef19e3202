/* Records of ground motion: kinds of files, what they must say, and what is wrong with them. */
#include "io/exchange/record.h"

#include <math.h>
#include <string.h>

static QnRecord
parse (const char *text, const char *unit, double time_step)
{
  QnRecord record;
  GError *error = NULL;
  qn_record_parse (text, strlen (text), "r", unit, time_step, &record, &error);
  g_assert_no_error (error);
  return record;
}

static void
assert_refused (const char *text, const char *unit, double time_step, const char *message)
{
  QnRecord record;
  GError *error = NULL;
  g_assert_false (
    qn_record_parse (text, strlen (text), "r", unit, time_step, &record, &error));
  if (strstr (error->message, message) == NULL)
    g_error ("'%s' is not in '%s'", message, error->message);
  g_assert_cmpuint (record.count, ==, 0);
  g_assert_null (record.points);
  g_error_free (error);
}

static void
assert_samples (QnRecord record, gsize count, double time, double value)
{
  g_assert_cmpuint (record.count, ==, count);
  g_assert_cmpfloat (fabs (record.points[count - 1].x - time), <, 1e-12);
  g_assert_cmpfloat (fabs (record.points[count - 1].y - value), <, 1e-12);
  qn_record_clear (&record);
}

static void
test_tables (void)
{
  assert_samples (parse ("time [s],a [m/s2]\n0,0\n0.5,2\n", NULL, 0), 2, 0.5, 2);
  assert_samples (parse ("time [s];a [cm/s2]\r\n0;0\r\n0.5;200\r\n", NULL, 0), 2, 0.5, 2);
  assert_samples (parse ("t a\n0 0\n0.5 1\n1 -1\n", "g", 0), 3, 1, -9.80665);
  assert_samples (parse ("0 0\n0.01\t300\n", "gal", 0), 2, 0.01, 3);
}

static void
test_at2 (void)
{
  const char *text = "PEER NGA STRONG MOTION DATABASE RECORD\n"
                     "Somewhere, 1/1/2000, Station, 90\n"
                     "ACCELERATION TIME SERIES IN UNITS OF G\n"
                     "NPTS=   6, DT=   .0050 SEC,\n"
                     "  .1000000E+00  .2000000E+00  .3000000E+00\n"
                     " -.1000000E+00 -.2000000E+00 -.5000000E+00\n";
  assert_samples (parse (text, NULL, 0), 6, 0.025, -0.5 * 9.80665);
  assert_refused (text, "m/s2", 0, "another unit");
  assert_refused (text, NULL, 0.01, "another time step");
  const char *last = strstr (text, " -.1000000E+00");
  g_assert_nonnull (last);
  g_autofree char *cut = g_strndup (text, (gsize) (last - text));
  assert_refused (cut, NULL, 0, "fewer samples");
}

static void
test_esm (void)
{
  const char *text = "EVENT_NAME: NONE\nEVENT_ID: X\nSAMPLING_INTERVAL_S: 0.005\n"
                     "NDATA: 3\nUNITS: cm/s^2\nUSER5:\n1.5\n-2\n4\n";
  assert_samples (parse (text, NULL, 0), 3, 0.01, 0.04);
}

static void
test_refused (void)
{
  assert_refused ("0 0\n1 1\n", NULL, 0, "does not state the unit");
  assert_refused ("0 0\n1 1\n", "furlong", 0, "not one of m/s2");
  assert_refused ("time [s],a [m/s2]\n0,0\n1,1\n", "g", 0, "another unit");
  assert_refused ("0 0\n1 1\n", "g", 0.1, "no time step may be given");
  assert_refused ("", "g", 0, "empty");
  assert_refused ("0 1\n", "g", 0, "at least two points");
  assert_refused ("0 0\n1 1\n1 2\n", "g", 0, "r:3: times of the signal must increase");
  assert_refused ("0 0\n1 nan\n2 2\n", "g", 0, "r:2: number is not finite");
  assert_refused ("0 0\n1 x\n2 2\n", "g", 0, "r:2: expected two numbers");
  assert_refused ("-1 0\n1 2\n", "g", 0, "r:1: times must not be negative");
}

/* A constant acceleration of 1 m/s2 for 2 s drifts to 2 m/s and 2 m. */
static void
test_facts (void)
{
  QnRecord record = parse ("0 1\n0.5 1\n2 1\n", "m/s2", 0);
  QnRecordFacts facts = qn_record_facts (&record);
  g_assert_cmpfloat (facts.duration, ==, 2);
  g_assert_cmpfloat (facts.peak, ==, 1);
  g_assert_cmpfloat (fabs (facts.velocity - 2), <, 1e-12);
  g_assert_cmpfloat (fabs (facts.displacement - 2), <, 1e-12);
  qn_record_clear (&record);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/record/tables", test_tables);
  g_test_add_func ("/record/at2", test_at2);
  g_test_add_func ("/record/esm", test_esm);
  g_test_add_func ("/record/refused", test_refused);
  g_test_add_func ("/record/facts", test_facts);
  return g_test_run ();
}
