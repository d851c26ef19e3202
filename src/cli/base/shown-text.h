/* Text for a terminal. Names and titles come from files of anybody: an escape sequence in one could
 * rewrite the window's title, hide lines or turn their order, so it is shown as \u001b.
 */
#pragma once

#include "cli/base/exit-code.h"

#include <glib.h>

/* The text with all control characters but tab and line break, and those that turn the direction of
 * writing, as \uXXXX; bytes that are no UTF-8 as \xXX. Free with g_free(). */
char *qn_shown_text_dup (const char *text);

/* Prints on standard output, as qn_text_printf() writes: a line break in a name begins no line, and what
 * is no number is shown as "–" and ends the program with QN_EXIT_NO_ANSWER. Files that are written there
 * ("-o -") do not go this way. */
void qn_print (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* The same of lines that are complete. */
void qn_print_text (const char *text);

/* Completes standard output; the exit code of a program that would end with this one. */
QnExit qn_shown_text_end (QnExit code);
