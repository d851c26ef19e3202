#include "core/result/first-limit.h"

#include <math.h>

#define FELT 1e-3 /* of the collapse multiplier */

bool
qn_result_has_felt_limit (const QnResult *result)
{
  return result->has_first_limit_multiplier
         && !(result->has_collapse_multiplier
              && fabs (result->first_limit_multiplier)
                   < FELT * fabs (result->collapse_multiplier));
}

bool
qn_result_has_buckled (const QnResult *result, double *multiplier)
{
  for (size_t i = 0; i < result->event_count; i++)
    if (result->events[i].kind == QN_EVENT_KIND_BUCKLING) {
      if (multiplier != NULL)
        *multiplier = result->events[i].multiplier;
      return true;
    }
  return false;
}
