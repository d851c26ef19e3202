/* printf() for messages, safe against NaN, infinities and line breaks in names; numbers as text, the same in
 * every locale. */
#pragma once

#include <glib.h>
#include <stdarg.h>

/* As g_strdup_printf(), but a number that is not finite is shown as "–", and a line break within an
 * argument as \u000a: a line break in a name from a file would make a line that looks like a message of
 * the program. Conversions are %s, %c, and those of int, long, size_t and
 * double, without positions. *finite (nullable) becomes FALSE if a number was not finite. */
char *qn_text_printf (const char *format, ...) G_GNUC_PRINTF (1, 2);
char *qn_text_vprintf (gboolean *finite, const char *format, va_list arguments)
  G_GNUC_PRINTF (2, 0);

/* The same of a text that is chosen from a table, with one conversion of a double or none. */
char *qn_text_with_number (const char *sentence, double number);

/* As g_string_append_printf(), in the same manner. */
void qn_text_append (GString *text, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* "8 to 20 mm (mean 12 mm)", or "12 mm" where the extremes are the same when they are written;
 * widths in m. The caller frees it. */
char *qn_widths_dup_text (double narrowest, double mean, double widest);

/* Whether a character is safe on a terminal: no control character but line break and tab, no line end
 * (U+2028, U+2029), no change of the text direction (U+202A to U+202E, U+2066 to U+2069). */
static inline gboolean
qn_is_plain_character (gunichar c)
{
  if (c == '\n' || c == '\t')
    return TRUE;
  return !g_unichar_iscntrl (c) && !(c >= 0x2028 && c <= 0x202e)
         && !(c >= 0x2066 && c <= 0x2069);
}

/* ---- numbers ---- */

/* Room for any number with its NUL. */
#define QN_NUMBER_TEXT_SIZE 40

/* The shortest text with 17 or fewer significant digits that reads back as the same double:
 * "0.1", "10000000", "1e-6". Not for infinities and NaN, which JSON cannot hold: they give
 * "null". Minus zero gives "0". Returns `text`. */
const char *qn_number_text (double number, char text[QN_NUMBER_TEXT_SIZE]);
