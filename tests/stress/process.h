/* A case in a process of its own, so that a crash or an endless loop is an outcome like others. */
#ifndef QN_TESTS_STRESS_PROCESS_H
#define QN_TESTS_STRESS_PROCESS_H

#include "stress/stress.h"

/* Runs the case; after `seconds` of processor time it counts as endless. */
void stress_process_run (const StressCase *c, int seconds, StressRow *row);

#endif
