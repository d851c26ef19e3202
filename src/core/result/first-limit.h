/* Which first loss of stability people are told of. */
#pragma once

#include "core/result/result.h"

/* Whether a path has a first limit point under a load that is felt. Below a thousandth of the
 * collapse multiplier joints settle as the load begins: the displacement is so small there that any
 * jump is a large part of it. */
bool qn_result_has_felt_limit (const QnResult *result);

/* Whether people are told of an event: not of joints that settle, be it by a large part of the displacement at a
 * load that is not felt. */
bool qn_result_is_felt (const QnResult *result, const QnPathEvent *event);

/* Where the branch that a path came on has lost its stability first: its event "buckling", or NULL. */
const QnPathEvent *qn_result_find_buckling (const QnResult *result);

/* The step where a branch loses its stability: the first of the event's stage at its multiplier. -1 for
 * none. */
ptrdiff_t qn_result_buckling_step (const QnResult *result, const QnPathEvent *event);
