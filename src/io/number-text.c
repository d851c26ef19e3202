#include "io/number-text.h"

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

const char *
qn_number_text (double number, char text[QN_NUMBER_TEXT_SIZE])
{
  if (!isfinite (number)) {
    g_strlcpy (text, "null", QN_NUMBER_TEXT_SIZE);
    return text;
  }
  if (fabs (number) < 1e15 && number == trunc (number)) {
    g_snprintf (text, QN_NUMBER_TEXT_SIZE, "%" G_GINT64_FORMAT, (gint64) number);
    return text;
  }

  static const char *const formats[] = { "%.15g", "%.16g", "%.17g" };
  for (size_t i = 0; i < G_N_ELEMENTS (formats); i++) {
    g_ascii_formatd (text, QN_NUMBER_TEXT_SIZE, formats[i], number);
    if (g_ascii_strtod (text, NULL) == number)
      break;
  }
  tidy_exponent (text);
  return text;
}
