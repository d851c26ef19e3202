/* Linked into a test program, locale.c takes the locale of the environment before anything else, as
 * the programs of the project do. Run with a decimal comma, a test of what is written to files
 * shows that its numbers stay as they are, and one of what is shown that they do not. */
#pragma once

/* `text` with the decimal sign of the locale for every point; free with g_free(). */
char *test_with_decimal_sign (const char *text);
