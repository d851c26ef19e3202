/* What the tangents at both ends of an increment of the multiplier say about it.
 *
 * Where the path is smooth, the displacements of an increment are those of the trapezoidal rule,
 * 1/2 dlambda (du/dlambda at its start + du/dlambda at its end), but for the kinks in between;
 * a jump is in neither tangent, and stays however small the increment becomes.
 */
#ifndef QN_CORE_PATH_TANGENTS_H
#define QN_CORE_PATH_TANGENTS_H

#include "core/equilibrium/equilibrium.h"

typedef struct QnPathTangents {
  QnEquilibrium *eq; /* borrowed */
  double
    *start;    /* unknown_count: du/dlambda at the last accepted equilibrium, m or rad */
  double *end; /* and at the current one */
  bool start_known, end_known; /* not where the tangent is singular */
} QnPathTangents;

/* For the equilibria of `eq`, neither tangent being known. False when memory runs out; to be
 * cleared all the same. */
bool qn_path_tangents_init (QnPathTangents *tangents, QnEquilibrium *eq);

void qn_path_tangents_clear (QnPathTangents *tangents);

/* From the tangent stiffness of the current state, K du/dlambda = live load. False when memory
 * runs out. */
bool qn_path_tangents_take_start (QnPathTangents *tangents);
bool qn_path_tangents_take_end (QnPathTangents *tangents);

/* The largest displacement since the last accepted equilibrium that the tangents at both ends do
 * not explain, as a part of the largest displacement there is. Both have to be known. */
double qn_path_tangents_unexplained (const QnPathTangents *tangents, double increment);

/* The end of this increment is the start of the next. */
void qn_path_tangents_accept (QnPathTangents *tangents);

#endif
