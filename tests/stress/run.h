/* Running one case: limit analysis, both paths, and every check. */
#pragma once

#include "stress/stress.h"

/* Iterations that one path may take. It is cancelled then, which is a fault. */
#define STRESS_MOST_ITERATIONS 10000

/* Agreement of associative paths with limit analysis, and of multipliers with statics. */
#define STRESS_AGREEMENT 1e-3

/* To which the bounds of limit analysis meet, so that nothing is above them by less. */
#define STRESS_LIMIT_ACCURACY 1e-6

/* Agreement of walls loaded from the left and from the right, dilatancy 0. */
#define STRESS_MIRROR_AGREEMENT 5e-3

/* Runs a case in this process. It may crash or take for ever: see process.h. */
void stress_run (const StressCase *c, StressRow *row);

/* Writes the case as a project file with the dilatancy of `flow`. */
gboolean stress_write_project (const StressCase *c, StressFlow flow, const char *path,
                               GError **error);
