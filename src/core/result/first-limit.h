/* Selection of the losses of stability that reports mention. */
#pragma once

#include "core/result/result.h"

/* Whether a path has a first limit point at 1/1000 of the collapse multiplier or more. At lower loads joints
 * settle, and displacements are so small that any jump is relatively large. */
bool qn_result_has_felt_limit (const QnResult *result);

/* Whether an event is reported: not LOCAL, and at 1/1000 of the collapse multiplier or more. */
bool qn_result_is_felt (const QnResult *result, const QnPathEvent *event);

/* The first event BUCKLING, or NULL. */
const QnPathEvent *qn_result_find_buckling (const QnResult *result);

/* First step of the event's stage at its multiplier; -1: none. */
ptrdiff_t qn_result_buckling_step (const QnResult *result, const QnPathEvent *event);
