/* Text for a terminal. Names and titles come from files of anybody: an escape sequence in one could
 * rewrite the window's title, hide lines or turn their order, so it is shown as \u001b.
 */
#ifndef QN_CLI_SHOWN_TEXT_H
#define QN_CLI_SHOWN_TEXT_H

#include <glib.h>

/* Appends text with all control characters but tab and line break, and those that turn the direction
 * of writing, as \uXXXX; bytes that are no UTF-8 as \xXX. Of `length` bytes it takes all but the
 * beginning of a character at the end; returns how many. */
gsize qn_shown_text_append (GString *shown, const char *text, gsize length);

/* Lets everything that is printed on standard output pass through it. Files that are written there
 * ("-o -") do not. */
void qn_shown_text_on_standard_output (void);

#endif
