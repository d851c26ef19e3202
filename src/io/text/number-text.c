#include "io/text/number-text.h"
#include "core/base/integer.h"

#include <float.h>
#include <math.h>
#include <string.h>

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
