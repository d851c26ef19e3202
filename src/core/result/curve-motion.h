/* Displacement of the load–displacement curve of a result. */
#pragma once

#include "core/result/result.h"

/* The displacement of one body, block or node behind the blocks. */
typedef struct QnCurveMotion {
  QnId body; /* QN_NONE: no displacement */
  QnDof dof;
  bool since_dead; /* counts from the equilibrium under dead load, step 0 */
} QnCurveMotion;

/* Largest settlement of the last stage of a path, if the stage drives settlements alone; NULL: it drives forces,
 * or the result has no reactions. */
const QnLoad *qn_result_settlement (const QnModel *model, const QnResult *result);

/* Reaction along a settlement, N or N m: sum over the supports with a settlement of its set and direction. */
double qn_result_settlement_reaction (const QnModel *model, const QnResult *result,
                                      const QnLoad *settlement, size_t step);

/* A settlement: its support. Else the controlled displacement, as a total. In time: qn_model_followed(). Else
 * the larger component of the free block (without blocks: node) with the largest displacement since the dead
 * load. */
QnCurveMotion qn_result_curve_motion (const QnModel *model, const QnResult *result);

/* The displacement at a step, m or rad. */
double qn_curve_motion_at (const QnResult *result, QnCurveMotion motion, size_t step);
