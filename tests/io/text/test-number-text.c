#include "io/text/text-format.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static void
expect (double number, const char *text)
{
  char buffer[QN_NUMBER_TEXT_SIZE];
  g_assert_cmpstr (qn_number_text (number, buffer), ==, text);
}

static void
test_shortest (void)
{
  expect (0, "0");
  expect (-0.0, "0");
  expect (1, "1");
  expect (-350, "-350");
  expect (1e7, "10000000");
  expect (0.1, "0.1");
  expect (0.175, "0.175");
  expect (1e-6, "1e-6");
  expect (-1.5e-10, "-1.5e-10");
  expect (1e20, "1e20");
  expect (1e300, "1e300");
  expect (1.0 / 3, "0.3333333333333333");
  expect (0.1 + 0.2, "0.30000000000000004");
  expect (-0.5, "-0.5");
  expect (0.0001, "0.0001");
  expect (0.000123456789, "0.000123456789");
  expect (123456.789, "123456.789");
  expect (999999.999999999, "999999.999999999");
  expect (1.000000001, "1.000000001");
  expect (10.05, "10.05");
  expect (5.55e-5, "5.55e-5");
}

static void
test_not_finite (void)
{
  expect (INFINITY, "null");
  expect (-INFINITY, "null");
  expect (NAN, "null");
}

/* Whatever the bits, the same double comes back. */
static void
test_round_trip (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (7);
  for (int i = 0; i < 100000; i++) {
    union {
      guint64 bits;
      double number;
    } value = { (guint64) g_rand_int (random) << 32 | g_rand_int (random) };
    char text[QN_NUMBER_TEXT_SIZE];
    if (isfinite (value.number))
      g_assert_true (g_ascii_strtod (qn_number_text (value.number, text), NULL)
                     == value.number);
  }
}

/* Every decimal of up to 15 digits comes back as it was typed. */
static void
test_typed_numbers (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (11);
  for (int i = 0; i < 100000; i++) {
    int digits = g_rand_int_range (random, 1, 16);
    char typed[40], text[QN_NUMBER_TEXT_SIZE];
    gint64 mantissa = 1 + (gint64) (g_rand_double (random) * (pow (10, digits) - 1));
    g_snprintf (typed, sizeof typed, "%" G_GINT64_FORMAT "e%d", mantissa,
                g_rand_int_range (random, -300, 280));
    double number = g_ascii_strtod (typed, NULL);
    qn_number_text (number, text);
    g_assert_true (g_ascii_strtod (text, NULL) == number);
    int found = 0;
    for (const char *c = text; *c != '\0' && *c != 'e'; c++)
      found += g_ascii_isdigit (*c) && (found > 0 || *c != '0');
    g_assert_cmpint (found, <=, MAX (digits, 15));
  }
}

QN_TESTS
{
  g_test_add_func ("/number-text/shortest", test_shortest);
  g_test_add_func ("/number-text/not-finite", test_not_finite);
  g_test_add_func ("/number-text/round-trip", test_round_trip);
  g_test_add_func ("/number-text/typed-numbers", test_typed_numbers);
}
