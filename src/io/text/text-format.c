#include "io/text/text-format.h"

#include "core/base/integer.h"

#include <float.h>
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

/* ---- numbers ---- */

/* 1e-06 to 1e-6, 1e+20 to 1e20 */
static void
tidy_exponent (char *text)
{
  char *exponent = strchr (text, 'e');
  if (exponent == NULL)
    return;
  char *out = exponent + 1, *in = out;
  if (*in == '-')
    out++;
  in += *in == '-' || *in == '+';
  while (*in == '0' && in[1] != '\0')
    in++;
  memmove (out, in, strlen (in) + 1);
}

/* Whether 15 digits may be enough, judged by 17 of them. A decimal number of 15 digits and the
 * double next to it differ by at most 2^-53 of their size, 11.1 units of the 17th digit: the
 * last two digits are then close to 00 or 99. Spares most numbers a vain attempt. */
static gboolean
may_be_short (const char *digits17)
{
  int count = 0, last = 0, before = 0;
  for (const char *c = digits17; *c != '\0' && *c != 'e'; c++) {
    if (!g_ascii_isdigit (*c) || (count == 0 && *c == '0'))
      continue;
    before = last;
    last = *c - '0';
    count++;
  }
  int tail = count == 17 ? before * 10 + last : count == 16 ? last * 10 : 0;
  return tail <= 12 || tail >= 88;
}

const char *
qn_number_text (double number, char text[QN_NUMBER_TEXT_SIZE])
{
  if (!isfinite (number)) {
    g_strlcpy (text, "null", QN_NUMBER_TEXT_SIZE);
    return text;
  }
  if (fabs (number) < 1e15 && number == trunc (number)) {
    g_snprintf (text, QN_NUMBER_TEXT_SIZE, "%" G_GINT64_FORMAT,
                qn_to_integer (number, G_MININT64, G_MAXINT64));
    return text;
  }

  static const char *const shorter[] = { "%.15g", "%.16g" };
  char exact[QN_NUMBER_TEXT_SIZE];
  g_ascii_formatd (exact, sizeof exact, "%.17g", number);
  gboolean coarse = fabs (number) < DBL_MIN; /* fewer digits than the judgement assumes */
  gboolean found = FALSE;
  for (gsize i = coarse || may_be_short (exact) ? 0 : 1;
       i < G_N_ELEMENTS (shorter) && !found; i++) {
    g_ascii_formatd (text, QN_NUMBER_TEXT_SIZE, shorter[i], number);
    found = g_ascii_strtod (text, NULL) == number;
  }
  if (!found)
    g_strlcpy (text, exact, QN_NUMBER_TEXT_SIZE);
  tidy_exponent (text);
  return text;
}
