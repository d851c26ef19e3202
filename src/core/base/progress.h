/* Progress and cancelling of long computations, through one callback. */
#pragma once

#include "core/base/base.h"

typedef struct QnProgress {
  double multiplier; /* load multiplier reached */
  int32_t steps;     /* converged steps so far */
  int32_t iterations;
  int32_t factorizations;
  double time,
    end; /* of an analysis in time: time reached, latest end, s; of others: end = 0 */
  double
    displacement; /* in time: of qn_model_followed(), since the dead load, m or rad */
  bool rigid;     /* limit analysis, also for the bound of a path */
} QnProgress;

/* Called at least once per iteration, from the computing thread; false cancels and keeps converged steps. */
typedef bool (*QnProgressFunc) (const QnProgress *progress, void *user_data);
