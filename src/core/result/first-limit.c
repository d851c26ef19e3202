#include "core/result/first-limit.h"

#include <math.h>

#define FELT 1e-3 /* of the collapse multiplier */

static bool
is_felt_at (const QnResult *result, double multiplier)
{
  return !(result->has_collapse_multiplier
           && fabs (multiplier) < FELT * fabs (result->collapse_multiplier));
}

bool
qn_result_has_felt_limit (const QnResult *result)
{
  return result->has_first_limit_multiplier
         && is_felt_at (result, result->first_limit_multiplier);
}

bool
qn_result_is_felt (const QnResult *result, const QnPathEvent *event)
{
  return event->kind != QN_EVENT_KIND_LOCAL && is_felt_at (result, event->multiplier);
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
