/* The line of thrust: where the forces pass from one row of blocks to the next.
 *
 * A cut is a row of contact faces that follow each other along one line: a joint between two
 * voussoirs, or a bed joint all the way through a pier. Its resultant follows from the contact
 * forces of its faces. Two cuts are neighbours where the blocks between them have no other loaded
 * joint: then the forces at the two cuts and the loads on these blocks are in equilibrium, and the
 * line of thrust leads from the one to the other. Where a wall forks, at openings, it ends, and so
 * it does where a joint is bent or pulled: the force acts outside of it.
 */
#pragma once

#include "render/scene/reading.h"

/* The normal of a cut points from side 0 to side 1. */
typedef struct QnCut {
  QnVec2 start, end;   /* m, undeformed */
  QnVec2 normal;       /* unit, that of its first face */
  QnVec2 force;        /* N, of side 1 on side 0 */
  QnVec2 at;           /* m, where it acts, kept within the cut */
  double length;       /* m */
  double eccentricity; /* m, from the middle towards the end; 0 where place is NOWHERE */
  double moment; /* N m, about the middle, counter-clockwise: -normal * eccentricity */
  QnPressurePlace place;
  QnId face;    /* the one that `at` lies in; from the number of faces on, a touch */
  QnId next[2]; /* neighbouring cut on either side, or QN_NONE */
} QnCut;

typedef struct QnThrust {
  QnCut *cuts;
  size_t count;
  QnId *cut_of;   /* of every face, then of every touch */
  double largest; /* N, of all cuts */
} QnThrust;

/* Forces below this share of the largest are none. */
#define QN_THRUST_LEAST_SHARE 2e-3

/* `pairs` of all contacts; `touches` of the same step, or NULL: each is a joint without length, and
 * those between the same two sides one joint from the one to the other. */
void qn_thrust_find (QnThrust *thrust, const QnModel *model, const QnContacts *contacts,
                     const QnPairResult *pairs, const QnTouch *touches,
                     size_t touch_count);

void qn_thrust_clear (QnThrust *thrust);
