/* What a load–displacement curve shows of a result. */
#pragma once

#include "core/result/result.h"

/* The displacement of one body, block or node behind the blocks. */
typedef struct QnCurveMotion {
  QnId body; /* QN_NONE: there is nothing to show */
  QnDof dof;
  bool since_dead; /* counts from the equilibrium under dead load, step 0 */
} QnCurveMotion;

/* The settlement that a path follows, the largest of those that its last stage drives alone; NULL: forces grow,
 * or it is no path with reactions. */
const QnLoad *qn_result_settlement (const QnModel *model, const QnResult *result);

/* What the support that settles takes, N or N m: along that settlement, with all supports that settle with it. */
double qn_result_settlement_reaction (const QnModel *model, const QnResult *result,
                                      const QnLoad *settlement, size_t step);

/* Of a settlement the support that settles. Else the component that the analysis controls, as a total, as its target is. In time the one of
 * qn_model_followed(), otherwise that of the free block (where there is none, of the node) that
 * moves furthest from the equilibrium under dead load on, in its larger direction: what moves in the
 * mechanism. */
QnCurveMotion qn_result_curve_motion (const QnModel *model, const QnResult *result);

/* The displacement at a step, m or rad. */
double qn_curve_motion_at (const QnResult *result, QnCurveMotion motion, size_t step);
