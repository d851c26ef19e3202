/* What arrives on edges of blocks of a load that stands above them on fill.
 *
 * A load spreads along rays. With a rule of widths it comes in equal parts of all rays from an apex above
 * the surface, where the sides of the spreading load meet: at every depth it is uniform over its width.
 * With Boussinesq's half-space (Flamant's line load) the part between the vertical and the angle t is
 * (t + sin t cos t) / pi, the vertical component of the radial stresses. What arrives on an edge is the part
 * of the rays that meet it first, so all parts add up to the load, on slopes too. Rays that meet an upright
 * face, go through air, or pass beside the structure bring nothing, and nothing makes up for them.
 */
#pragma once

#include "core/model/outline.h"
#include "core/model/vehicle.h"

/* Of one edge: the force, its first moment about the edge's left end, and the part that is met. */
typedef struct QnShare {
  double force, moment; /* N, N m: along the edge */
  double from, to;      /* m along the edge from its left end */
} QnShare;

typedef struct QnSource {
  double x, surface; /* m: where it stands */
  double load;       /* N */
  QnSpread spread;
  bool boussinesq;
  double width;          /* m: no load is wider than this; 0: no limit */
  double effective;      /* m: width across at all depths; 0: that of `spread` */
  const QnVec2 *profile; /* of the surface, from the left; NULL: no fill */
  int32_t profile_count;
} QnSource;

/* Adds to the shares, one for each of the edges, which are seen from above and ordered from left to
 * right. */
void qn_disperse (const QnModel *model, const QnSeenEdges *edges, const QnSource *source,
                  QnShare *shares);
