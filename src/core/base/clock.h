/* Time, for the statistics of an analysis only: no result depends on it. */
#pragma once

#include <time.h>

/* Seconds since an arbitrary moment. */
static inline double
qn_clock_seconds (void)
{
  struct timespec now;

  clock_gettime (CLOCK_MONOTONIC, &now);
  return (double) now.tv_sec + 1e-9 * (double) now.tv_nsec;
}
