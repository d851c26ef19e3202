/* Text for a terminal. Names and titles come from files of anybody: an escape sequence in one could
 * rewrite the window's title, hide lines or turn their order, so it is shown as \u001b.
 */
#pragma once

#include "cli/base/exit-code.h"

#include <glib.h>

/* Appends text with all control characters but tab and line break, and those that turn the direction
 * of writing, as \uXXXX; bytes that are no UTF-8 as \xXX. Of `length` bytes it takes all but the
 * beginning of a character at the end; returns how many. */
gsize qn_shown_text_append (GString *shown, const char *text, gsize length);

/* Prints on standard output, as qn_text_printf() writes: a line break in a name begins no line, and what
 * is no number is shown as "–" and ends the program with QN_EXIT_NO_ANSWER. */
void qn_print (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* Completes standard output; the exit code of a program that would end with this one. */
QnExit qn_shown_text_end (QnExit code);

/* Lets everything that is printed on standard output pass through it. Files that are written there
 * ("-o -") do not. */
void qn_shown_text_on_standard_output (void);
