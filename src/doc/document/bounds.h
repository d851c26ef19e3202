/* HybriDFEM against limit analysis: what the latest runs of a document say about the load that
 * its present model can carry, and what each number guarantees. */
#pragma once

#include "doc/document/document.h"

/* How a value was found. */
typedef enum {
  QN_BOUND_PATH,        /* last equilibrium of the path */
  QN_BOUND_FIRST_LIMIT, /* of the path */
  QN_BOUND_LOWER,       /* limit analysis, associative */
  QN_BOUND_UPPER,
  QN_BOUND_LEAST, /* limit analysis with the laws' dilatancy, of what was found */
  QN_BOUND_GREATEST,
  QN_BOUND_KIND_COUNT
} QnBoundKind;

typedef struct QnBound {
  QnBoundKind kind;
  const char *label;     /* "Limit analysis, upper bound", translated */
  double value;          /* multiplier; INFINITY: no limit */
  const char *guarantee; /* one or two sentences, translated */
} QnBound;

/* Of QnBound, free with g_array_unref(): the path, its first limit point, the associative
 * bounds, the non-associative interval; of each the latest run that is not outdated. Empty where
 * nothing has been solved. */
GArray *qn_bounds_collect (QnDocument *document);

/* The value of a kind, NAN where there is none. */
double qn_bounds_find (const GArray *bounds, QnBoundKind kind);

/* How the numbers stand to each other, and which is to be used, in two sentences; NULL where there is only one kind of
 * analysis. The caller frees it. */
char *qn_bounds_dup_verdict (const GArray *bounds);
