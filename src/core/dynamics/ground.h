/* The acceleration of the ground in time: the sum of all ground motions of a model.
 *
 * A step of the integration takes the mean over the step, from the exact integral of the signal:
 * then the velocity that the ground passes on does not depend on where steps begin and end, and a
 * pulse that starts or ends within a step counts as long as it lasts.
 */
#pragma once

#include "core/model/model.h"

typedef struct QnGround {
  const QnModel *model;
  double **velocities; /* integrals of every motion's points, m/s; NULL: pulse */
  double end;          /* when the last motion is over, s */
} QnGround;

/* Integrates the points of all motions, which must have them. `ground` is overwritten without
 * being cleared; the model must outlive it. False when memory runs out. */
bool qn_ground_init (QnGround *ground, const QnModel *model);

void qn_ground_clear (QnGround *ground);

/* Acceleration at a time, m/s2, in the axes of the model; where it jumps, that before: what begins
 * with a step belongs to the step. */
QnVec2 qn_ground_acceleration (const QnGround *ground, double time);

/* Mean acceleration from `start` to `end` > start; and how much it changes over that time. */
QnVec2 qn_ground_mean (const QnGround *ground, double start, double end);
QnVec2 qn_ground_change (const QnGround *ground, double start, double end);

/* Which share of a motion's Arias intensity, the integral of its acceleration squared (A. Arias, in
 * Seismic Design for Nuclear Power Plants, MIT Press 1970, 438-483), comes after a time. Its points
 * must be there. */
double qn_ground_motion_share_after (const QnGroundMotion *motion, double time);
