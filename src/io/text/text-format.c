#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#pragma GCC diagnostic ignored "-Wformat-nonliteral" /* specs come from checked formats */

char *
qn_text_vprintf (gboolean *finite, const char *format, va_list arguments)
{
  GString *text = g_string_new (NULL);
  /* A conversion, "%-12.4g", with its width and precision written out where arguments gave them. */
  g_autoptr (GString) spec = g_string_new (NULL);
  for (const char *at = format; *at != '\0'; at++) {
    gboolean is_long = FALSE, is_size = FALSE;
    gsize plain = strcspn (at, "%");
    g_string_append_len (text, at, (gssize) plain);
    at += plain;
    if (*at == '\0')
      break;
    if (at[1] == '%') {
      g_string_append_c (text, *at++);
      continue;
    }
    g_string_assign (spec, "%");
    for (at++; strchr ("#0- +.123456789*lz", *at) != NULL && *at != '\0'; at++) {
      is_long |= *at == 'l';
      is_size |= *at == 'z';
      if (*at == '*')
        g_string_append_printf (spec, "%d", va_arg (arguments, int));
      else
        g_string_append_c (spec, *at);
    }
    g_string_append_c (spec, *at);
    if (strchr ("efgEG", *at) != NULL) {
      const double number = va_arg (arguments, double);
      if (isfinite (number))
        g_string_append_printf (text, spec->str, number);
      else
        g_string_append (text, "–");
      if (finite != NULL && !isfinite (number))
        *finite = FALSE;
    } else if (*at == 's') {
      g_autofree char *cell =
        g_strdup_printf (spec->str, va_arg (arguments, const char *));
      for (const char *c = cell; *c != '\0'; c++)
        if (*c == '\n')
          g_string_append (text, "\\u000a");
        else
          g_string_append_c (text, *c);
    } else if (is_size) {
      g_string_append_printf (text, spec->str, va_arg (arguments, size_t));
    } else if (is_long) {
      g_string_append_printf (text, spec->str, va_arg (arguments, long));
    } else {
      g_assert (strchr ("diuxXoc", *at) != NULL);
      g_string_append_printf (text, spec->str, va_arg (arguments, int));
    }
  }
  return g_string_free (text, FALSE);
}

char *
qn_text_printf (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *text = qn_text_vprintf (NULL, format, arguments);
  va_end (arguments);
  return text;
}

char *
qn_text_with_number (const char *sentence, double number)
{
  return qn_text_printf (sentence, number);
}

void
qn_text_append (GString *text, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *more = qn_text_vprintf (NULL, format, arguments);
  va_end (arguments);
  g_string_append (text, more);
}

char *
qn_widths_dup_text (double narrowest, double mean, double widest)
{
  g_autofree char *from = qn_text_printf ("%.3g", 1e3 * narrowest);
  g_autofree char *to = qn_text_printf ("%.3g mm", 1e3 * widest);
  return g_str_has_prefix (to, from) && to[strlen (from)] == ' '
           ? g_steal_pointer (&to)
           : qn_text_printf (_ ("%s to %s (mean %.3g mm)"), from, to, 1e3 * mean);
}
