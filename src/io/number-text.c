#include "io/number-text.h"

#include <math.h>

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
  return text;
}
