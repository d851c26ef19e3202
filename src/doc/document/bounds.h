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

/* Multipliers: of the path, its first limit point, the associative bounds, the non-associative interval;
 * of each that of the latest run that is not outdated. INFINITY: no limit; NAN: there is none. Returns how
 * many there are. */
guint qn_bounds_collect (QnDocument *document, double values[QN_BOUND_KIND_COUNT]);

/* What each of them is and guarantees, a paragraph each. The caller frees it. */
char *qn_bounds_dup_text (const double values[QN_BOUND_KIND_COUNT]);

/* How the numbers stand to each other, and which is to be used, in two sentences; NULL where there is only one kind of
 * analysis. The caller frees it. */
char *qn_bounds_dup_verdict (const double values[QN_BOUND_KIND_COUNT]);
