/* Faults that are known and not mended: they are reported, not hidden, and do not fail the
 * test. */
#ifndef QN_TESTS_STRESS_SHORTFALLS_H
#define QN_TESTS_STRESS_SHORTFALLS_H

#include "stress/stress.h"

/* The faults of a case that are known. */
guint stress_shortfalls (const char *name);

#endif
