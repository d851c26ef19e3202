#include "core/result/first-limit.h"

#include <math.h>

#define FELT 1e-3 /* of the collapse multiplier */
#define SAME 1e-9 /* numbers that stand in a result twice */

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

const QnPathEvent *
qn_result_find_buckling (const QnResult *result)
{
  for (size_t i = 0; i < result->event_count; i++)
    if (result->events[i].kind == QN_EVENT_KIND_BUCKLING)
      return &result->events[i];
  return NULL;
}

ptrdiff_t
qn_result_buckling_step (const QnResult *result, const QnPathEvent *event)
{
  double at = event->multiplier;

  for (size_t s = 0; s < result->step_count; s++)
    if (result->steps[s].stage == event->stage
        && fabs (result->steps[s].multiplier - at) <= SAME * fabs (at))
      return (ptrdiff_t) s;
  return -1;
}
