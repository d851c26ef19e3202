/* Threads of the caller for independent parts of a computation. The core starts no threads. */
#pragma once

#include <stddef.h>
#include <stdint.h>

typedef struct QnWorkers {
  /* Calls part (data, i) once for each i = 0 … count - 1, in any order and on any threads, and returns
   * when all of them have returned. */
  void (*run) (void *pool, int32_t count, void (*part) (void *data, int32_t i),
               void *data);
  void *pool;
} QnWorkers;

/* `workers` may be NULL: the caller's thread does all of it, in order. */
static inline void
qn_workers_run (const QnWorkers *workers, int32_t count,
                void (*part) (void *data, int32_t i), void *data)
{
  if (workers != NULL && count > 1) {
    workers->run (workers->pool, count, part, data);
    return;
  }
  for (int32_t i = 0; i < count; i++)
    part (data, i);
}
