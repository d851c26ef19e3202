/* Kinematics of a contact pair: its elongation and the gradient by the displacements of its blocks.
 *
 * Points A and B coincide in the undeformed state. Their distance d = x_B - x_A is measured in
 * a frame (normal n, tangent t) that turns with the pair, by the mean of the two blocks'
 * rotations, so that a rigid motion of both strains nothing:
 *
 *   q = (n . d, t . d)
 *
 * In linear geometry the frame and the arms stay as they were and d is linear in the
 * displacements. In nonlinear geometry rotations are of any size.
 *
 * A contact found during motion joins a corner B of block b to a point A on a side of block a, apart from B
 * in the undeformed state. Its frame turns with block a alone: q_n is the distance of the corner from the
 * side, and the force acts at the corner.
 *
 * Unknowns of a pair, everywhere in this order: ux, uy, L rz of block a, then of block b, in m;
 * L is the length by which rotations are scaled.
 */
#pragma once

#include "core/base/vec2.h"

#include <stdint.h>

typedef struct QnPairKinematics {
  QnVec2 normal;       /* undeformed, unit, from a to b */
  QnVec2 arm_a, arm_b; /* from the centroids to the pair, undeformed, m */
  double length;       /* L, m */
  QnVec2 apart;        /* B - A, undeformed, m */
  double share;        /* of block a's rotation in the frame's: 1/2; found contacts: 1 */

  /* Of the last update, in nonlinear geometry; at rest after qn_pair_kinematics_init(). */
  double elongation[2];      /* q, m */
  QnVec2 frame;              /* normal as turned */
  QnVec2 turned_a, turned_b; /* arms as turned */
} QnPairKinematics;

void qn_pair_kinematics_init (QnPairKinematics *pair, QnVec2 normal, QnVec2 arm_a,
                              QnVec2 arm_b, double length);

/* Makes the pair a found contact; apart = B - A, undeformed, m. */
void qn_pair_kinematics_set_corner (QnPairKinematics *pair, QnVec2 apart);

/* Gradient of a pair in the layout of the inner loops: factors of (L rz of a, u_b - u_a in x and y,
 * L rz of b). The difference of translations avoids cancellation. */
enum { QN_PAIR_FACTORS = 4 };

typedef struct QnPairGradient {
  double factors[2][QN_PAIR_FACTORS];
} QnPairGradient;

/* The gradient of the last update. */
QnPairGradient qn_pair_kinematics_gradient (const QnPairKinematics *pair);

/* Pairs of the same two blocks at displacements v of any size. */
void qn_pair_kinematics_update (QnPairKinematics *pairs, int32_t count,
                                const double v[6]);

/* Adds the geometric stiffness of the last update, force[0] d2 q_n + force[1] d2 q_t, by the factors of the
 * gradient. */
void qn_pair_kinematics_add_stiffness (const QnPairKinematics *pair,
                                       const double force[2],
                                       double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS]);
