#include "io/text/text-format.h"
#include "support/room.h"

#include <math.h>

static void
expect (char *text, const char *expected)
{
  g_assert_cmpstr (text, ==, expected);
  g_free (text);
}

static void
test_as_printf (void)
{
  expect (qn_text_printf ("%s, %5.2f|%-8.3g|%+d %zu %02u %c%% %.1e", "wall", 1.005,
                          12345.678, -3, (size_t) 7, 5u, 'x', 1e-3),
          "wall,  1.00|1.23e+04|-3 7 05 x% 1.0e-03");
  expect (qn_text_printf ("%-6s|%6s|%.3s|%*s|%.*f|%ld", "ab", "cd", "efgh", 4, "", 2,
                          0.125, -5L),
          "ab    |    cd|efg|    |0.12|-5");
  g_autoptr (GString) text = g_string_new ("a");
  qn_text_append (text, "%d", 1);
  g_assert_cmpstr (text->str, ==, "a1");
}

/* A name cannot begin a line. */
static void
test_breaks (void)
{
  expect (qn_text_printf ("%s\n", "a\nwarnings: none"), "a\\u000awarnings: none\n");
}

G_GNUC_PRINTF (2, 3)
static char *
print (gboolean *finite, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *text = qn_text_vprintf (finite, format, arguments);
  va_end (arguments);
  return text;
}

static void
test_not_finite (void)
{
  gboolean finite = TRUE;
  expect (print (&finite, "%g", 1e300), "1e+300");
  g_assert_true (finite);
  expect (print (&finite, "%g, %8.3f, %d", NAN, -INFINITY, 1), "–, –, 1");
  g_assert_false (finite);
}

QN_TESTS
{
  g_test_add_func ("/text-format/as-printf", test_as_printf);
  g_test_add_func ("/text-format/breaks", test_breaks);
  g_test_add_func ("/text-format/not-finite", test_not_finite);
}
