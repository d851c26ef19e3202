#include "render/drawing/text.h"
#include "support/room.h"

#include <glib.h>
#include <libintl.h>
#include <locale.h>

static void
expect (const char *format, double value, const char *text)
{
  g_autofree char *number = qn_label_number (format, value);
  g_assert_cmpstr (number, ==, text);
}

/* The locale's numbers are not asked. */
static void
test_numbers (void)
{
  static const char *const names[] = { "C.UTF-8", "de_DE.UTF-8" };
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_assert_nonnull (setlocale (LC_NUMERIC, names[i]));
    expect ("%.2f", 1234.5, "1234.50");
    expect ("%.4g", 1.5e7, "1.5·10⁷");
    expect ("%.1e", 2.5e-14, "2.5·10⁻¹⁴");
    expect ("%.1e", 0, "0.0");
    expect ("%g", 3, "3");
    expect ("%.1f", -0.04, "0.0");
    expect ("%.1f", -0.06, "-0.1");
  }
  setlocale (LC_NUMERIC, "C");
}

/* A picture with French words has French figures. */
static void
test_french (void)
{
  g_assert_true (g_setenv ("LANGUAGE", "fr", TRUE));
  g_assert_nonnull (
    setlocale (LC_MESSAGES, "fr_FR.UTF-8")); /* glibc 2.39: not in C.UTF-8 */
  bindtextdomain ("quoin", g_getenv ("QUOIN_CATALOGUES"));
  bind_textdomain_codeset ("quoin", "UTF-8");
  expect ("%.2f", 1234.5, "1234,50");
  expect ("%.4g", 1.5e7, "1,5·10⁷");
  expect ("%g", 3, "3");
  expect ("%.1f", -0.04, "0,0");
}

QN_TESTS
{
  g_test_add_func ("/text/numbers", test_numbers);
  g_test_add_func ("/text/french", test_french);
}
