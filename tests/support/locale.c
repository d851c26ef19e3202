#include "support/locale.h"

#include <glib.h>
#include <locale.h>
#include <stdlib.h>

__attribute__ ((constructor)) static void
take_locale (void)
{
  if (setlocale (LC_ALL, "") == NULL)
    abort (); /* the machine lacks it: the test would show nothing */
}

char *
test_with_decimal_sign (const char *text)
{
  GString *result = g_string_new (text);
  g_string_replace (result, ".", localeconv ()->decimal_point, 0);
  return g_string_free (result, FALSE);
}
