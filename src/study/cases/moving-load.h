/* A load on its way over a structure. */
#pragma once

#include "study/plan/study.h"

/* The block that a point lies in, or the nearest one; QN_NONE where there is none. */
QnId qn_nearest_block (const QnModel *model, QnVec2 point);

/* Adds "path=value" strings that put every axle of a parameter with a line on the block of `model`
 * that is nearest, at its nearest point; the first axle is `distance_of_first` m from
 * the start of the line, and what has not come to the line yet carries nothing. */
void qn_moving_load_add_overrides (GPtrArray *overrides, const QnParameter *parameter,
                                   double distance_of_first, const QnModel *model);
