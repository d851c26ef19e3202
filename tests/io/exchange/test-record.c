/* Records of ground motion: kinds of files, what they must say, and what is wrong with them. */
#include "io/exchange/record.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static QnRecord
parse (const char *text, const char *unit, double time_step)
{
  QnRecord record;
  GError *error = NULL;
  qn_record_parse (text, strlen (text), "r", unit, time_step, FALSE, &record, &error);
  g_assert_no_error (error);
  return record;
}

static void
assert_refused (const char *text, const char *unit, double time_step, const char *message)
{
  QnRecord record;
  GError *error = NULL;
  g_assert_false (
    qn_record_parse (text, strlen (text), "r", unit, time_step, FALSE, &record, &error));
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
  assert_refused (cut, NULL, 0, "3 samples, and its heading states 6");
  g_autofree char *more = g_strconcat (text, "0\n", NULL);
  assert_refused (more, NULL, 0, "7 samples, and its heading states 6");
  static const gsize cut_off[] = { 2, 5 }; /* "-.5000000E+0", "-.5000000" */
  for (gsize i = 0; i < G_N_ELEMENTS (cut_off); i++) {
    g_autofree char *within = g_strndup (text, strlen (text) - cut_off[i]);
    assert_refused (within, NULL, 0, "r:6: the file ends within its last number");
  }
  assert_samples (parse ("unit: g\nNPTS=3, DT=1\n1e2\n2\n3\n", NULL, 0), 3, 2,
                  3 * 9.80665);
  assert_refused ("unit: g\nNPTS=3\n0 0\n0.1 1\n", NULL, 0, "2 samples"); /* a table */
}

static void
test_esm (void)
{
  const char *text = "EVENT_NAME: NONE\nEVENT_ID: X\nSAMPLING_INTERVAL_S: 0.005\n"
                     "NDATA: 3\nUNITS: cm/s^2\nUSER5:\n1.5\n-2\n4\n";
  assert_samples (parse (text, NULL, 0), 3, 0.01, 0.04);
}

/* The same motion in every format below: 0, 1, -2, 0.5 m/s2 at 0, 0.01, 0.02, 0.03 s; numbers that go
 * round in the unit of the file agree to `digits`. */
static void
assert_motion (QnRecord record, double digits)
{
  static const double motion[] = { 0, 1, -2, 0.5 };
  g_assert_cmpuint (record.count, ==, 4);
  for (int i = 0; i < 4; i++) {
    g_assert_cmpfloat (fabs (record.points[i].x - 0.01 * i), <, 1e-12);
    g_assert_cmpfloat (fabs (record.points[i].y - motion[i]), <=, digits);
  }
  qn_record_clear (&record);
}

static void
test_units (void)
{
  static const char *const spellings[] = { "m/s2",   "m/s^2",     "m/s**2", "m/s²",
                                           "m/sec2", "m/sec/sec", "M/S/S",  "m s-2",
                                           "m·s⁻2",  "m/(s^2)" };
  for (gsize i = 0; i < G_N_ELEMENTS (spellings); i++) {
    g_autofree char *text = g_strdup_printf (
      "time [s];acceleration [%s]\n0;0\n0.01;1\n0.02;-2\n0.03;0.5\n", spellings[i]);
    assert_motion (parse (text, NULL, 0), 0);
  }
  assert_motion (parse ("t [ms], a in gal\n0,0\n10,100\n20,-200\n30,50\n", NULL, 0),
                 1e-15);
  assert_motion (
    parse ("# units: s, CM/S/S\n0 0\n0.01 100\n0.02 -200\n0.03 50\n", NULL, 0), 1e-15);
}

static void
test_people (void)
{
  /* What people and spreadsheets write. */
  assert_motion (
    parse ("\xef\xbb\xbfZeit [s];Beschleunigung [m/s²]\r\n0,00;0,0\r\n0,01;1,0\r\n"
           "0,02;-2,0\r\n0,03;0,5\r\n",
           NULL, 0),
    0);
  assert_motion (
    parse ("Zeit [s]\tBeschl. [m/s\xb2]\r0,00\t0\r0,01\t1\r0,02\t-2\r0,03\t0,5\r", NULL,
           0),
    0);
  assert_motion (parse ("# station X\n# units: m/s2\n0 0\n0.01 1\n# half way\n\n0.02 -2\n"
                        "0.03 0.5\n",
                        NULL, 0),
                 0);
  assert_motion (parse ("0\n1\n-2\n0.5\n", "m/s2", 0.01), 0);
  assert_motion (parse ("0,0\n1,0\n-2,0\n0,5\n", "m/s2", 0.01), 0);
  assert_motion (
    parse ("% dt = 0.01 s\n% unit = m/s2\n0\n1.D0\n-0.2D+01\n5d-1\n", NULL, 0), 0);
  assert_motion (parse ("time [s],acceleration [m/s2],velocity [m/s]\n0,0,9\n0.01,1,9\n"
                        "0.02,-2,9\n0.03,0.5,9\n",
                        NULL, 0),
                 0);
  assert_motion (
    parse ("velocity,time,acceleration\n9,0,0\n9,0.01,1\n9,0.02,-2\n9,0.03,0.5\n", "m/s2",
           0),
    0);
  gsize length;
  g_autofree char *wide =
    g_convert ("t [s]\ta [m/s2]\r\n0\t0\r\n0.01\t1\r\n0.02\t-2\r\n0.03\t0.5", -1,
               "UTF-16", "UTF-8", NULL, &length, NULL);
  QnRecord record;
  g_assert_true (qn_record_parse (wide, length, "r", NULL, 0, FALSE, &record, NULL));
  assert_motion (record, 0);
}

static void
test_networks (void)
{
  /* PEER before NGA. */
  assert_motion (
    parse ("PEER STRONG MOTION DATABASE RECORD. PROCESSING BY NOBODY.\nNOWHERE\n"
           "ACCELERATION TIME HISTORY IN UNITS OF CM/S/S. FILTER POINTS: HP=0.1 Hz\n"
           "   4    .0100    NPTS, DT\n  .0000000E+00  .1000000E+03\n"
           " -.2000000E+03  .5000000E+02\n",
           NULL, 0),
    1e-15);
  /* ESM, where a velocity differs by its unit and type alone. */
  static const char esm[] =
    "EVENT_NAME: NONE\nDATA_TYPE: %s\nSAMPLING_INTERVAL_S: 0.010000\nNDATA: 4\n"
    "PGA_CM/S^2: 200\nUNITS: %s\nUSER5:\n0\n100\n-200\n50\n";
  g_autofree char *acceleration = g_strdup_printf (esm, "ACCELERATION", "cm/s^2");
  g_autofree char *velocity = g_strdup_printf (esm, "VELOCITY", "cm/s");
  g_autofree char *displacement = g_strdup_printf (esm, "DISPLACEMENT", "cm");
  assert_motion (parse (acceleration, NULL, 0), 1e-15);
  assert_refused (velocity, NULL, 0, "r:6: this is a record of velocity");
  assert_refused (displacement, "g", 0, "r:6: this is a record of displacement");
  /* CSMIP: numbers of fixed width that touch, then velocities. */
  assert_motion (
    parse ("CORRECTED ACCELEROGRAM\n 1 2 3\n"
           "   4 points of accel data equally spaced at   .010 sec, in cm/sec2. "
           "(8f10.5)\n   0.00000 100.00000-200.00000  50.00000\n"
           "   4 points of veloc data equally spaced at   .010 sec, in cm/sec. "
           "(8f10.5)\n   0.00000   1.00000   2.00000   3.00000\n",
           NULL, 0),
    1e-15);
  /* COSMOS: the time between samples is the 34th number of the real header, in ms. */
  GString *cosmos =
    g_string_new ("Corrected acceleration   (Format v01.20 with 1 text lines)\n"
                  "   4 Integer-header values follow on 1 lines, Format= (10I8)\n"
                  "       3       1       4       1\n"
                  "  40 Real-header values follow on  8 lines, Format= (5F15.6)\n");
  for (int i = 1; i <= 40; i++)
    g_string_append_printf (cosmos, "%15.6f%s", i == 34 ? 10.0 : -999.0,
                            i % 5 == 0 ? "\n" : "");
  gsize heading = cosmos->len;
  g_string_append (
    cosmos,
    "   1 Comment line(s) follow, each starting with a \"|\":\n| none\n"
    "       4 acceleration pts, approx   0 secs, units=cm/sec2 (4),Format=(8f10.5)\n"
    "   0.00000 100.00000-200.00000  50.00000\n"
    "End-of-data for Chan  1 acceleration\n");
  assert_motion (parse (cosmos->str, NULL, 0), 1e-15);
  g_string_append (
    cosmos,
    "       4 acceleration pts, approx   0 secs, units=cm/sec2 (4),Format=(8f10.5)\n");
  assert_refused (cosmos->str, NULL, 0, "second record of acceleration");
  g_string_truncate (cosmos, heading);
  g_string_append (
    cosmos, "       4 acceleration pts, approx   0 secs, units=counts (50),Format=(8I8)\n"
            "       0       1      -2       5\n");
  assert_refused (cosmos->str, NULL, 0, "does not state the unit");
  static const char *const ends[] = { "End-of-data for Chan  1 acceleration\n",
                                      "       4 velocity pts, approx 0 secs\n" };
  for (gsize i = 0; i < G_N_ELEMENTS (ends); i++) { /* a sample is missing */
    g_string_truncate (cosmos, heading);
    g_string_append (
      cosmos,
      "       4 acceleration pts, approx   0 secs, units=cm/sec2 (4),Format=(8f10.5)\n"
      "   0.00000 100.00000-200.00000\n");
    g_string_append (cosmos, ends[i]);
    assert_refused (cosmos->str, NULL, 0, "3 samples, and its heading states 4");
  }
  g_string_free (cosmos, TRUE);
  /* K-NET: whole numbers, and the same with an offset that the largest acceleration leaves out. */
  static const char knet[] =
    "Origin Time       2001/01/01 00:00:00\nStation Height(m) 10\n"
    "Sampling Freq(Hz) 100Hz\nDuration Time(s)  0.04\nDir.              E-W\n"
    "Scale Factor      2000(gal)/80000\nMax. Acc. (gal)   %s\n"
    "Memo.\n%s\n";
  g_autofree char *plain = g_strdup_printf (knet, "200.0", "    0  4000 -8000  2000");
  g_autofree char *raw = g_strdup_printf (knet, "187.5", " 9000 13000  1000 11000");
  g_autofree char *other = g_strdup_printf (knet, "400.0", " 9000 13000  1000 11000");
  assert_motion (parse (plain, NULL, 0), 1e-15);
  QnRecord record = parse (raw, "gal", 0);
  g_assert_cmpfloat (fabs (record.offset - 2.125), <, 1e-12);
  g_assert_cmpfloat (fabs (record.points[2].y + 1.875), <, 1e-12);
  qn_record_clear (&record);
  assert_refused (other, NULL, 0, "not that of the heading");
  assert_refused (raw, "g", 0, "another unit");
  /* AFAD has three components beside each other. */
  assert_refused (
    "STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA : 3\n"
    "SAMPLING INTERVAL (sec) : 0.01\nRAW PGA VALUES (gal) : (N-S) 3 (E-W) 3\n"
    "   N-S    E-W    U-D\n 0 0 0\n 1 2 3\n 3 -3 1\n",
    NULL, 0, "r:6: several records side by side");
  assert_motion (
    parse ("STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA : 4\n"
           "SAMPLING INTERVAL (sec) : 0.01\nRAW PGA VALUES (gal) : (N-S) 200\n"
           "   N-S\n 0\n 100\n -200\n 50\n",
           NULL, 0),
    1e-15);
}

/* What a heading says twice, in other places, or not of an acceleration in time. */
static void
test_headings (void)
{
  /* A line of 80 characters whose numbers touch. */
  assert_samples (
    parse ("   8 points of accel data equally spaced at .010 sec, in g/10.\n"
           "-100.00000-100.00000-100.00000-100.00000-100.00000-100.00000"
           "-100.00000 -10.00000\n",
           NULL, 0),
    8, 0.07, -9.80665);
  assert_motion (parse ("4 .01\n0 1\n-2 .5\n", "m/s2", 0), 0);
  assert_motion (parse ("4\n0\n1\n-2\n.5\n", "m/s2", 0.01), 0);
  assert_motion (parse ("\"Zeit [s]\",\"a [m/s2]\"\n\"0,00\",\"0,0\"\n\"0,01\",\"1,0\"\n"
                        "\"0,02\",\"\xe2\x88\x92"
                        "2,0\"\n\"0,03\",\"0,5\"\n",
                        NULL, 0),
                 0);
  assert_motion (parse ("Time,Acc,Vel\ns,cm/s2,m/s\n0,0,9\n.01,100,9\n.02,-200,9\n"
                        ".03,50,9\n",
                        NULL, 0),
                 1e-15);
  assert_samples (parse ("t (min),a (%g)\n0,0\n1,100\n", NULL, 0), 2, 60, 9.80665);
  assert_samples (parse ("PGA (g) = 0.5 (NS), 0.2\ndt = 0.1\n0\n-.5\n", NULL, 0), 2, 0.1,
                  -0.5 * 9.80665);
  assert_refused ("PGA (gal) = 200\ndt = 0.1\n0\n-.2\n", NULL, 0,
                  "r:1: the largest acceleration is not that");
  assert_refused ("dt = 0.1\nsampling rate 200 Hz\nunit: g\n0\n1\n", NULL, 0,
                  "r:2: the heading states two different time steps");
  assert_refused ("dt = 0.1\nunit: g\nunit: gal\n0\n1\n", NULL, 0,
                  "r:3: the heading states two different units");
  assert_refused ("Period (s),Sa (g)\n0,1\n1,2\n", NULL, 0, "r:1: this is a spectrum");
  assert_refused ("T [s];PSA [g]\n0;1\n1;2\n", NULL, 0, "this is a spectrum");
  assert_refused ("DATA_TYPE: ACCELERATION SPECTRUM\nUNITS: g\n0 1\n1 2\n", NULL, 0,
                  "this is a spectrum");
  assert_refused ("<a>1 2</a>\n", NULL, 0, "no line has numbers alone");
  assert_refused ("TIMESERIES XX_A_00_HNZ_D, 2 samples, TSPAIR, FLOAT, M/S**2\n"
                  "2011-01-01T00:00:00.000000  1.5\n2011-01-01T00:00:00.010000  -2\n\n",
                  NULL, 0,
                  "r:3: no line has numbers alone; the last one is "
                  "\"2011-01-01T00:00:00.010000  -2\"");
}

static void
test_quantities (void)
{
  static const char peer[] =
    "PEER NGA STRONG MOTION DATABASE RECORD\nNowhere\n"
    "%s TIME SERIES IN UNITS OF %s\nNPTS=   4, DT=   .0100 SEC\n 0 1 -2 .5\n";
  g_autofree char *velocity = g_strdup_printf (peer, "VELOCITY", "CM/S");
  g_autofree char *displacement = g_strdup_printf (peer, "DISPLACEMENT", "CM");
  g_autofree char *other = g_strdup_printf (peer, "ACCELERATION", "M/S/S");
  g_autofree char *words = g_strdup_printf (peer, "VELOCITY", "KNOTS");
  assert_refused (velocity, NULL, 0, "r:3: this is a record of velocity");
  assert_refused (displacement, NULL, 0, "r:3: this is a record of displacement");
  assert_refused (words, "g", 0, "this is a record of velocity");
  assert_motion (parse (other, NULL, 0), 0);
  assert_refused ("time [s],velocity [cm/s]\n0,0\n1,1\n", NULL, 0, "record of velocity");
  assert_refused ("t,v\n# unit: mm\n0,0\n1,1\n", NULL, 0, "record of displacement");
  assert_refused ("Zeit;Geschwindigkeit\n0;0\n1;1\n", "g", 0, "record of velocity");
  assert_refused ("0 0 0\n1 1 1\n2 2 2\n", "g", 0, "more than two columns");
  assert_refused ("t,acc NS [g],acc EW [g]\n0,0,0\n1,1,1\n", NULL, 0, "several columns");
  assert_refused ("0 5 2\n1 1 1\n0 0 0\n", "g", 0.01, "side by side");
}

static void
test_doubts (void)
{
  QnRecord strong = parse ("0 0\n1 29.5\n", "m/s2", 0),
           weak = parse ("0 0\n1 2.9\n", "g", 0);
  g_autofree char *doubt = qn_record_dup_doubt (&strong);
  g_assert_nonnull (strstr (doubt, "29.5 m/s2, more than 3 g"));
  /* The first column counts the samples. */
  QnRecord counted = { .points = g_new (QnVec2, 100), .count = 100 };
  for (gsize k = 0; k < counted.count; k++)
    counted.points[k] = qn_vec2 ((double) k, 1);
  g_autofree char *apart = qn_record_dup_doubt (&counted);
  g_assert_nonnull (strstr (apart, "1 s apart"));
  qn_record_clear (&counted);
  g_assert_null (qn_record_dup_doubt (&weak));
  qn_record_clear (&strong);
  qn_record_clear (&weak);
}

/* NULL: no warning is expected. */
static void
assert_gap (const char *text, const char *warning)
{
  QnRecord record = parse (text, "m/s2", 0);
  g_autofree char *gap = qn_record_dup_gap (&record, "r.csv");
  g_assert_cmpstr (gap, ==, warning);
  qn_record_clear (&record);
}

/* Missing samples are told with the line behind the first gap. A column that is uneven by design has none. */
static void
test_gaps (void)
{
  assert_gap ("t\tacc\n# one\n0 0\n0.01 1\n0.02 2\n0.03 1\n# two\n0.06 0\n0.07 1\n",
              "r.csv:8: samples are missing from 0.03 s to 0.06 s: 2 (2 in the whole "
              "record); straight lines take their place");
  assert_gap ("0 0\n1 1\n2 2\n3.001 1\n5 0\n6 1\n7 0\n8 0\n12.4 0\n",
              "r.csv:5: samples are missing from 3.001 s to 5 s: 1 (4 in the whole "
              "record); straight lines take their place");
  assert_gap ("0 0\n0.01 1\n0.02 2\n0.0301 1\n0.04 0\n", NULL);
  assert_gap ("0 0\n1 1\n2 2\n3 1\n4.3 0\n5 1\n7 0\n", NULL);
  assert_gap ("0 0\n1 1\n3 2\n4 1\n7 0\n", NULL);
  assert_gap ("0 0\n0.01 1\n0.03 2\n0.07 1\n0.2 0\n0.5 1\n", NULL);
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
  assert_refused ("0 0\n1 x\n2 2\n", "g", 0, "r:2: expected numbers, as many as");
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

QN_TESTS
{
  g_test_add_func ("/record/tables", test_tables);
  g_test_add_func ("/record/at2", test_at2);
  g_test_add_func ("/record/esm", test_esm);
  g_test_add_func ("/record/units", test_units);
  g_test_add_func ("/record/people", test_people);
  g_test_add_func ("/record/networks", test_networks);
  g_test_add_func ("/record/headings", test_headings);
  g_test_add_func ("/record/quantities", test_quantities);
  g_test_add_func ("/record/doubts", test_doubts);
  g_test_add_func ("/record/gaps", test_gaps);
  g_test_add_func ("/record/refused", test_refused);
  g_test_add_func ("/record/facts", test_facts);
}
