/* The results of a study in memory, and as a table for other programs. */
#pragma once

#include "study/cases/store.h"
#include "study/report/statistics.h"

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

/* ---- columns, as statistics take them ---- */

/* Whether the cases are a sample of the parameters' distributions: not those of plans by levels. */
gboolean qn_table_is_sample (const QnTable *table);

/* The known numbers of an output, ascending; of a plan "sobol" those of its independent points
 * alone. Free with g_free(). */
double *qn_table_dup_sorted (const QnTable *table, gsize column, gsize *count);

/* The known pairs of two columns, of the same rows. Free both with g_free(). */
gsize qn_table_dup_pairs (const QnTable *table, gsize x, gsize y, double **xs,
                          double **ys);

/* Sobol indices of an output, one per parameter; FALSE where the plan is another or too little is
 * known. */
gboolean qn_table_sobol (const QnTable *table, gsize column, QnSobolIndex *indices);

/* Least and greatest value of an output while one parameter goes through its levels and all others
 * stay as in the project, that value included, of a plan "one-at-a-time". *base is that of the
 * project, NaN where it is not known. FALSE where nothing is known. */
gboolean qn_table_effect (const QnTable *table, gsize parameter, gsize column,
                          double *base, QnInterval *effect);

/* Mechanisms of one shape, or of one kind where shapes are not kept, and how often they occur. */
typedef struct QnMechanismShare {
  guint shape; /* 0: not known */
  const char
    *kind; /* of all of them, or of the typical case; NULL: not known. Borrowed from the
                       table */
  gsize count;
  int column;       /* the collapse multiplier, else its associative bound; -1: neither */
  QnInterval range; /* of it, NaN where it is not known */
  gsize row;        /* a typical case: the middle one by multiplier */
} QnMechanismShare;

/* The word for an outcome or kind of mechanism, translated; `name` itself where it is neither. */
const char *qn_study_word (const char *name);

/* "overturning", "shape 2, overturning"; translated. Free with g_free(). */
char *qn_mechanism_share_dup_name (const QnMechanismShare *share);

/* Most frequent first, of QnMechanismShare; *whole counts the cases that have one. Free with
 * g_array_unref(). */
GArray *qn_table_dup_mechanisms (const QnTable *table, gsize *whole);

/* ---- summary.c ---- */

/* Several lines, translated: how many cases there are and how they ended; of every output its
 * mean, deviation, quantiles with intervals, the share that has collapsed at a multiplier
 * (fragility), rank correlations, Sobol indices; of mechanisms how often each occurs. Plans by
 * levels are no sample: of them least and greatest values, and the effect of each parameter alone.
 * Free with g_free(). */
char *qn_summary_dup_text (const QnTable *table);
