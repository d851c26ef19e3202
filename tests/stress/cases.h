/* The cases, by subject. Every function appends its own to a GArray of StressCase. */
#pragma once

#include "stress/stress.h"

typedef void (*StressBuild) (const StressCase *c, QnModel *model);

/* Appends a case of the long programme and returns it, valid until the next one. */
StressCase *stress_cases_add (GArray *cases, const char *subject, StressBuild build,
                              int number, double value, const char *format, ...)
  G_GNUC_PRINTF (6, 7);

/* One case for each of the six walls; the quick set takes the first five in turn. */
void stress_cases_add_on_walls (GArray *cases, const char *subject, StressBuild build,
                                double value, const char *what);

void stress_cases_add_joints (GArray *cases); /* stiffness, friction, strength */
void
stress_cases_add_shapes (GArray *cases); /* units, place, slivers, slenderness, size */
void stress_cases_add_starts (GArray *cases); /* singular, nearly so, or no structure */
void stress_cases_add_steps (GArray *cases);  /* increments, procedures, symmetry */

/* Random walls with the seeds first … first + count - 1. */
void stress_cases_add_random (GArray *cases, guint32 first, guint count);

/* StressCase.build of random walls: `number` is the seed. */
void stress_case_build_random (const StressCase *c, QnModel *model);

/* All but random walls. */
GArray *stress_cases_new (void);
