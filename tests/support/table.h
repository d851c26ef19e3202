/* Tables as comma-separated values, read as any program would read them. */
#pragma once

#include <glib.h>

/* Rows of a table as RFC 4180 has it, the headings first, each a GStrv; free with g_ptr_array_unref().
 * Fails the test where a row has another number of fields than the first one, a quote is left open, or a
 * field stands for a number that is infinite or none. */
GPtrArray *test_table_read (const char *text);

/* A field, and the same as a number; row 0 has the headings. Fail the test where it is not there. */
const char *test_table_field (const GPtrArray *table, guint row, const char *heading);
double test_table_number (const GPtrArray *table, guint row, const char *heading);
