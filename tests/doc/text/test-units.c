#include "doc/text/units.h"

#include "support/locale.h"
#include "support/room.h"
#include <math.h>
#include <string.h>

static const QnUnits cm_kn = { QN_LENGTH_CM, QN_FORCE_KN, QN_STRESS_MPA };

static void
check_parse (QnUnits units, QnQuantity quantity, const char *text, double expected)
{
  double value = NAN;
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_units_parse (units, quantity, text, &value, &error));
  g_assert_no_error (error);
  g_assert_cmpfloat_with_epsilon (value, expected, 1e-12 * (1.0 + fabs (expected)));
}

/* Lists: units and decimal signs of each number, nothing, too many, and what is no number. */
static void
test_list (void)
{
  double values[3] = { 0, 0, 9 };
  gsize count;
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_units_parse_list (cm_kn, QN_QUANTITY_LENGTH, "320; 3,5 m", values, 3,
                                      &count, &error));
  g_assert_cmpuint (count, ==, 2);
  g_assert_cmpfloat (values[0], ==, 3.2);
  g_assert_cmpfloat (values[1], ==, 3.5);
  g_assert_cmpfloat (values[2], ==, 9);
  g_autofree char *text =
    qn_units_format_list (QN_UNITS_SI, QN_QUANTITY_NUMBER, values, count, 15);
  g_assert_cmpstr (g_strdelimit (text, ",", '.'), ==, "3.2; 3.5"); /* of any locale */
  g_assert_true (
    qn_units_parse_list (cm_kn, QN_QUANTITY_LENGTH, " ", values, 3, &count, &error));
  g_assert_cmpuint (count, ==, 0);
  g_assert_false (qn_units_parse_list (cm_kn, QN_QUANTITY_NUMBER, "1;2;3;4", values, 3,
                                       &count, &error));
  g_assert_nonnull (strstr (error->message, "expected up to 3 numbers"));
  g_clear_error (&error);
  g_assert_false (
    qn_units_parse_list (cm_kn, QN_QUANTITY_NUMBER, "1;;2", values, 3, &count, &error));
  g_assert_nonnull (error);
}

static void
test_parse (void)
{
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "0.4", 0.4);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, " 0,4 ", 0.4);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "40 cm", 0.4);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "400mm", 0.4);
  check_parse (cm_kn, QN_QUANTITY_LENGTH, "40", 0.4);
  check_parse (cm_kn, QN_QUANTITY_LENGTH, "0.4 m", 0.4);
  check_parse (cm_kn, QN_QUANTITY_FORCE, "−1,5", -1500.0);
  check_parse (cm_kn, QN_QUANTITY_FORCE, "2e3 N", 2000.0);
  check_parse (cm_kn, QN_QUANTITY_UNIT_WEIGHT, "10", 1e4);
  check_parse (cm_kn, QN_QUANTITY_UNIT_WEIGHT, "10 kN/m3", 1e4);
  check_parse (cm_kn, QN_QUANTITY_STRESS, "0.2", 2e5);
  check_parse (cm_kn, QN_QUANTITY_STRESS, "3 N/mm²", 3e6);
  check_parse (cm_kn, QN_QUANTITY_PRESSURE, "5", 5e3); /* of loads: kPa */
  check_parse (QN_UNITS_SI, QN_QUANTITY_PRESSURE, "5 kPa", 5e3);
  check_parse (QN_UNITS_SI, QN_QUANTITY_DIAMETER, "16", 0.016);
  check_parse (cm_kn, QN_QUANTITY_DIAMETER, "1.6 cm", 0.016);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ANGLE, "45", G_PI / 4.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ANGLE, "45°", G_PI / 4.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ANGLE, "1 rad", 1.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ROTATION, "5", 0.005);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ROTATION, "45°", G_PI / 4.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_STIFFNESS, "1e7", 1e7);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "0.4*3+0.01", 1.21);
  check_parse (cm_kn, QN_QUANTITY_LENGTH, "40*3+1", 1.21);
  check_parse (cm_kn, QN_QUANTITY_LENGTH, "3 × 0,4 m + 1", 1.21);
  check_parse (cm_kn, QN_QUANTITY_LENGTH, "2*(40 cm + 1 cm)", 0.82);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "(1+2) m / 4", 0.75);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "3 m / 40 cm", 7.5);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "1-2-3", -4.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "8/2/2", 2.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "2+3*4", 14.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "-(1 − 3)", 2.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "2*-3", -6.0);
  check_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, "1e-1*2", 0.2);
  check_parse (QN_UNITS_SI, QN_QUANTITY_ANGLE, "360°/8", G_PI / 4.0);
  check_parse (cm_kn, QN_QUANTITY_UNIT_WEIGHT, "2*10 kN/m³", 2e4);
  check_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, "1/3", 1.0 / 3.0);
  double value = 0.0;
  g_assert_true (qn_units_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, "∞", &value, NULL));
  g_assert_true (isinf (value));
}

static void
test_refuse (void)
{
  static const struct {
    const char *text;
    const char *said;
  } cases[] = {
    { "", "is not a number" },
    { "abc", "is not a number" },
    { "1.2.3", "is not a number" },
    { "--4", "is not a number" },
    { "3 kN", "is not a unit" },
    { "3 furlong", "is not a unit" },
    { "1e999", "is too large" },
    { "nan", "is not a number" },
    { "1+", "is not a number" },
    { "(1", "is not a number" },
    { "1)", "is not a unit" },
    { "1 m * 2 m", "is not a number" },
    { "1 / 2 m", "is not a number" },
    { "1/0", "is too large" },
    { "0/0", "is too large" },
    { "1 2", "is not a unit" },
    { "\xff", "is not a number" },
    { "((((((((((((((((((((((((((((((((((((((((((1", "is not a number" },
    { "1e308 km", "is not a unit" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    double value = 7.0;
    g_autoptr (GError) error = NULL;
    g_assert_false (
      qn_units_parse (QN_UNITS_SI, QN_QUANTITY_LENGTH, cases[i].text, &value, &error));
    g_assert_nonnull (strstr (error->message, cases[i].said));
    g_assert_cmpfloat (value, ==, 7.0);
  }
}

static void
check_format (QnUnits units, QnQuantity quantity, double value, int digits,
              const char *expected)
{
  g_autofree char *text = qn_units_format_full (units, quantity, value, digits);
  g_autofree char *localized = test_with_decimal_sign (expected);
  g_assert_cmpstr (text, ==, localized);
}

static void
test_format (void)
{
  check_format (QN_UNITS_SI, QN_QUANTITY_LENGTH, 0.4, 6, "0.4\u00a0m");
  check_format (cm_kn, QN_QUANTITY_LENGTH, 0.4, 6, "40\u00a0cm");
  check_format (cm_kn, QN_QUANTITY_UNIT_WEIGHT, 1e4, 6, "10\u00a0kN/m³");
  check_format (QN_UNITS_SI, QN_QUANTITY_DIAMETER, 0.016, 6, "16\u00a0mm");
  check_format (cm_kn, QN_QUANTITY_DIAMETER, 0.016, 6, "16\u00a0mm");
  check_format (QN_UNITS_SI, QN_QUANTITY_ANGLE, G_PI / 6.0, 6, "30°");
  check_format (QN_UNITS_SI, QN_QUANTITY_ROTATION, 0.0125, 6, "12.5\u00a0mrad");
  check_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, -0.0, 6, "0");
  check_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, INFINITY, 6, "∞");
  /* Longer than its digits. */
  check_format (cm_kn, QN_QUANTITY_FORCE, 1.6949e6, 3, "1690\u00a0kN");
  check_format (cm_kn, QN_QUANTITY_FORCE, -9.996e5, 3, "-1000\u00a0kN");
  check_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, 123456.0, 4, "123500");
  check_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, 1.5e6, 4, "1.5e+06");
  check_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, 1.5e-6, 4, "1.5e-06");
}

/* What a field shows with all its digits is what it reads. */
static void
test_round_trip (void)
{
  static const double values[] = { 0.1, 1.0 / 3.0, 12345.678901234567, 1e-9, -2.5e7 };
  for (int quantity = 0; quantity < QN_QUANTITY_COUNT; quantity++) {
    for (gsize i = 0; i < G_N_ELEMENTS (values); i++) {
      g_autofree char *text =
        qn_units_format_full (cm_kn, (QnQuantity) quantity, values[i], 17);
      double value = 0.0;
      g_assert_true (qn_units_parse (cm_kn, (QnQuantity) quantity, text, &value, NULL));
      g_assert_cmpfloat_with_epsilon (value, values[i], 1e-15 * fabs (values[i]));
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/units/parse", test_parse);
  g_test_add_func ("/doc/units/list", test_list);
  g_test_add_func ("/doc/units/refuse", test_refuse);
  g_test_add_func ("/doc/units/format", test_format);
  g_test_add_func ("/doc/units/round-trip", test_round_trip);
}
