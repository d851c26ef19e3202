/* A case in a process of its own, so that a crash or an endless loop is an outcome like others. */
#ifndef QN_TESTS_STRESS_PROCESS_H
#define QN_TESTS_STRESS_PROCESS_H

#include "stress/stress.h"

typedef struct StressProcess {
  int pid, pipe_end;
} StressProcess;

/* Starts the case; after `seconds` of processor time it counts as endless. */
StressProcess stress_process_start (const StressCase *c, int seconds);

/* Waits for its end and takes what came out. */
void stress_process_finish (StressProcess *process, StressRow *row);

/* Both. */
void stress_process_run (const StressCase *c, int seconds, StressRow *row);

#endif
