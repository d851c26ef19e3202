#include "core/base/decimal.h"
#include "support/room.h"

#include <glib.h>

static void
test_write (void)
{
  const int32_t numbers[] = { 0, 7, 10, 99, 100, 1234567890, INT32_MAX };
  for (size_t i = 0; i < G_N_ELEMENTS (numbers); i++) {
    char text[QN_DECIMAL_SIZE];
    g_autofree char *expected = g_strdup_printf ("%d", numbers[i]);
    char *end = qn_write_decimal (text, numbers[i]);
    g_assert_cmpstr (text, ==, expected);
    g_assert_true (*end == '\0' && end == text + strlen (expected));
  }
}

QN_TESTS
{
  g_test_add_func ("/decimal/write", test_write);
}
