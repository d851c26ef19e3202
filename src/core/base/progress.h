/* Progress and cancelling of long computations, through one callback. */
#ifndef QN_CORE_PROGRESS_H
#define QN_CORE_PROGRESS_H

#include "core/base/base.h"

typedef struct QnProgress {
  double multiplier; /* load multiplier reached */
  int32_t steps;     /* converged steps so far */
  int32_t iterations;
  int32_t factorizations;
} QnProgress;

/* Called at least once per iteration, from the thread that computes; returns false to cancel.
 * What has converged by then is kept. */
typedef bool (*QnProgressFunc) (const QnProgress *progress, void *user_data);

#endif
