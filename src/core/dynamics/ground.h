/* The acceleration of the ground in time: the sum of all ground motions of a model.
 *
 * A step of the integration takes the mean over the step, from the exact integral of the signal:
 * then the velocity that the ground passes on does not depend on where steps begin and end, and a
 * pulse that starts or ends within a step counts as long as it lasts.
 */
#pragma once

#include "core/base/memory.h"
#include "core/model/model.h"

typedef struct QnGround {
  QnPool pool; /* of velocities */
  const QnModel *model;
  double **velocities; /* integrals of every motion's points, m/s; NULL: pulse */
  double end;          /* when the last motion is over, s */
} QnGround;

/* Integrates the points of all motions, which must have them. `ground` is overwritten without
 * being cleared; the model must outlive it. False when memory runs out. */
bool qn_ground_init (QnGround *ground, const QnModel *model);

void qn_ground_clear (QnGround *ground);

/* Acceleration at a time, m/s2, in the axes of the model; at a jump, the value before it: a jump at the start
 * of a step belongs to the step. */
QnVec2 qn_ground_acceleration (const QnGround *ground, double time);

/* Mean acceleration from `start` to `end` > start, m/s2; change of the acceleration over that time. */
QnVec2 qn_ground_mean (const QnGround *ground, double start, double end);
QnVec2 qn_ground_change (const QnGround *ground, double start, double end);

/* Share (0 to 1) of a motion's Arias intensity, the integral of its acceleration squared (A. Arias, in Seismic
 * Design for Nuclear Power Plants, MIT Press 1970, 438-483), after a time, s. Requires its points. */
double qn_ground_motion_share_after (const QnGroundMotion *motion, double time);
