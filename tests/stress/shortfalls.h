/* Faults that are known and not corrected: they are reported, not hidden, and do not fail the
 * test. */
#pragma once

#include "stress/stress.h"

typedef struct StressShortfall {
  const char *pattern; /* of the cases' names */
  guint faults;        /* StressFault */
  const char *why;     /* a sentence for the table */
} StressShortfall;

/* What is known of a case; NULL where nothing is. */
const StressShortfall *stress_shortfall (const char *name);
