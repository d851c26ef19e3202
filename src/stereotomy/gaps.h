/* Joints of mortar: gaps between blocks as they are drawn in a survey, found and closed.
 *
 * A gap lies between two sides of different blocks that face each other: they run within
 * QN_GAP_ANGLE of parallel, overlap by more than the gap is wide, and no third block lies between.
 * Sides that bound one joint (a bed along a whole course, the head between two bricks) share one
 * line once they are closed, so that beds stay straight and parallel and every block of the joint
 * touches its neighbours along it: the sides' mean direction in the middle of the gaps, or the
 * line nearest to it that lies within all of them. Where none does, the joint is parted where it
 * must be. Blocks grow to these lines; corners are where the lines of two sides meet, and corners
 * of several blocks that miss each other by less than half a joint become one. No side moves
 * farther than the gaps of its joint are wide; blocks that would come to overlap stay as they are.
 *
 * This is the usual simplification of a wall for analysis by blocks: "units are expanded to the
 * middle of the joint". Source: Lourenco, Computational strategies for masonry structures (1996),
 * section 2.2. Lengths in m; rings counter-clockwise.
 */
#pragma once

#include "stereotomy/ring.h"

/* Sides that deviate more from parallel (degrees) bound no joint. */
#define QN_GAP_ANGLE 25.0

/* Pairs of sides near each other that are compared at most, and so many more for every side. */
#define QN_MOST_SIDE_PAIRS 1000000
#define QN_PAIRS_PER_SIDE  50

typedef struct QnGap {
  size_t rings[2];
  size_t edges[2]; /* the side of each ring from this vertex on */
  QnVec2
    sides[2]
         [2]; /* m: the parts that face each other, both in the direction of the first */
  double width; /* m: mean */
} QnGap;

typedef struct QnGaps {
  QnGap *items;
  size_t count, capacity;
} QnGaps;

/* Closed gaps. */
typedef struct QnGapClosing {
  size_t left;    /* gaps that are still open */
  QnVec2 left_at; /* the middle of the first of them */
  double grown;   /* m2: by how much all blocks together grew */
} QnGapClosing;

/* All gaps wider than `least` and up to `most` (m) from end to end; with `least` < 0 also sides that
 * touch, and overlap by up to that. Of very many sides in one place only the first
 * QN_MOST_SIDE_PAIRS pairs are compared. `gaps` is overwritten without being cleared. */
void qn_gaps_find (const QnRings *rings, double least, double most, QnGaps *gaps);
void qn_gaps_clear (QnGaps *gaps);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnGaps, qn_gaps_clear)

/* Widths of gaps at their ends: least, mean, most; m. There must be one. */
void qn_gaps_widths (const QnGaps *gaps, double *least, double *mean, double *most);

/* Lets blocks grow until the gaps between them that are wider than `least` and up to `most` (m) are
 * closed. Rings keep their order; those without such gaps keep every digit. */
QnGapClosing qn_gaps_close (QnRings *rings, double least, double most);

/* Appends to `rings` the body of mortar in each gap, a quadrangle. */
void qn_gaps_fill (const QnGaps *gaps, QnRings *rings);

/* The width up to which gaps are looked for where nobody says: the median of area by perimeter of the
 * blocks (a quarter to half of what they are wide), at most 40 mm. */
double qn_gaps_usual_width (const QnRings *rings);
