/* Which characters are shown as they are. */
#pragma once

#include <glib.h>

/* Whether a terminal takes a character for itself: it is no command (line break and tab may be), does
 * not end the line (U+2028, U+2029), and does not turn the direction of what follows (U+202A to U+202E,
 * U+2066 to U+2069). */
static inline gboolean
qn_is_plain_character (gunichar c)
{
  if (c == '\n' || c == '\t')
    return TRUE;
  return !g_unichar_iscntrl (c) && !(c >= 0x2028 && c <= 0x202e)
         && !(c >= 0x2066 && c <= 0x2069);
}
