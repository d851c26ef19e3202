/* Columns of a study's table as statistics take them. */
#pragma once

#include "study/report/statistics.h"
#include "study/report/table.h"

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
