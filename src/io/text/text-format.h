/* printf() for what people read. Numbers that are none, and line breaks in names, do not reach them. */
#pragma once

#include <glib.h>
#include <stdarg.h>

/* As g_strdup_printf(), but a number that is not finite is shown as "–", and a line break within an
 * argument as \u000a: names and titles come from files of anybody, and a break in one would make a
 * line that looks like the program's. Conversions are %s, %c, and those of int, long, size_t and
 * double, without positions. *finite, which may be NULL, becomes FALSE where a number was none. */
char *qn_text_printf (const char *format, ...) G_GNUC_PRINTF (1, 2);
char *qn_text_vprintf (gboolean *finite, const char *format, va_list arguments)
  G_GNUC_PRINTF (2, 0);

/* As g_string_append_printf(), in the same manner. */
void qn_text_append (GString *text, const char *format, ...) G_GNUC_PRINTF (2, 3);
