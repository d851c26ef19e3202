/* Tables of a text in Markdown, written from those of the benchmark programs, so that what the text
 * shows is what was measured.
 *
 * A table stands between two comments, the first of which says what it shows:
 *
 *   <!-- table NAME: heading | heading = title | … -->
 *   <!-- table NAME where heading is value, heading is value: heading | … -->
 *   …
 *   <!-- end -->
 *
 * Rows are those of NAME.csv, columns those with these headings, titled as they are or otherwise.
 */
#ifndef QN_TESTS_BENCH_REPORT_TABLES_H
#define QN_TESTS_BENCH_REPORT_TABLES_H

#include <glib.h>

/* `text` with its tables written anew from those in `folder`. NULL with an error where a table or a
 * column is not there, or a comment is not understood. Free with g_free(). */
char *report_tables_dup (const char *text, const char *folder, GError **error);

#endif
