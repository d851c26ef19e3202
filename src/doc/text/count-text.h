/* How many there are of something: "1 block · 3 faces", translated, with the plural of each. */
#pragma once

#include <glib.h>

typedef enum {
  QN_COUNTED_BLOCKS,
  QN_COUNTED_BEAMS,
  QN_COUNTED_FACES,
  QN_COUNTED_PAIRS,
  QN_COUNTED_FINDINGS,
  QN_COUNTED_STEPS,
  QN_COUNTED_ITERATIONS,
  QN_COUNTED_FACTORISATIONS,
} QnCounted;

typedef struct QnCount {
  QnCounted what;
  gsize number;
} QnCount;

/* The counts in their order with `separator` between them. Free with g_free(). */
char *qn_counts_dup_text (const QnCount *counts, gsize n_counts, const char *separator);
