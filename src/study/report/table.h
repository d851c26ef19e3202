/* The results of a study in memory, and as a table for other programs. */
#pragma once

#include "study/cases/store.h"

/* Known values of one case. */
typedef struct QnRow {
  gsize index; /* place of the case, from 0 */
  gboolean failed;
  char *outcome, *reason, *mechanism; /* nullable, owned */
  guint
    shape; /* group of cases that move alike, from 1, the most frequent first; 0: not known */
} QnRow;

/* Rows by ascending case; columns of numbers, of the parameters first, then of the outputs. Where
 * a case has no such number stands NaN. */
typedef struct QnTable {
  const QnStudy *study; /* borrowed */
  GArray *rows;         /* of QnRow */
  gsize parameters;     /* columns of parameters, and of all: */
  gsize width;
  double *numbers; /* rows x width, owned */
} QnTable;

/* Reads the database of a folder; errors QN_IO_ERROR. */
gboolean qn_table_read (QnTable *table, const QnStudy *study, const char *folder,
                        GError **error);

void qn_table_clear (QnTable *table);

/* Column of a parameter or an output by its name; -1 where there is none. Of the mechanism's kind,
 * which is no number, too. */
int qn_table_find (const QnTable *table, const char *name);

/* Name of a column in files. */
const char *qn_table_column_name (const QnTable *table, gsize column);

/* Name of a column for readers: as the study names a parameter, of an output translated with its
 * unit. */
const char *qn_table_column_text (const QnTable *table, gsize column);

/* Meaning for collapse of the share of cases up to a value of a column, translated: for a bound the least
 * share of collapses; NULL: no meaning. */
const char *qn_table_fragility_text (const QnTable *table, gsize column);

static inline double
qn_table_number (const QnTable *table, gsize row, gsize column)
{
  return table->numbers[row * table->width + column];
}

/* Comma-separated values, RFC 4180, without times, which depend on the machine. "-" is standard
 * output. */
gboolean qn_table_write (const QnTable *table, const char *path, GError **error);
