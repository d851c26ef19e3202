/* A case in a process of its own, so that a crash or an endless loop is an outcome like others. */
#pragma once

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
