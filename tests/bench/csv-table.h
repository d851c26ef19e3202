/* The tables that the benchmark programs write, read again. */
#ifndef QN_TESTS_BENCH_CSV_TABLE_H
#define QN_TESTS_BENCH_CSV_TABLE_H

#include <glib.h>

typedef struct CsvTable {
  GPtrArray *rows; /* of char **, NULL-terminated; the first one has the headings */
} CsvTable;

/* Reads FOLDER/NAME.csv; quotes keep commas together. FALSE with an error where it cannot be read or
 * has no headings. */
gboolean csv_table_read (CsvTable *table, const char *folder, const char *name,
                         GError **error);
void csv_table_clear (CsvTable *table);

/* Row 0 has the headings. */
char **csv_table_get_row (const CsvTable *table, guint index);

/* Number of the column with this heading, or -1. */
int csv_table_find_column (const CsvTable *table, const char *heading);

/* A field, "" where the row is too short or the column -1. */
const char *csv_field (char **row, int column);

/* The same as a number, NAN where it is none. */
double csv_number (char **row, int column);

#endif
