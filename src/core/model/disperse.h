/* Distribution of a load on fill to the edges of blocks below.
 *
 * A load spreads along rays. With a rule of widths it comes in equal parts of all rays from an apex above
 * the surface, where the sides of the spreading load meet: at every depth it is uniform over its width.
 * With Boussinesq's half-space (Flamant's line load) the part between the vertical and the angle t is
 * (t + sin t cos t) / pi, the vertical component of the radial stresses. An edge receives the part of the
 * load whose rays meet it first, so all parts add up to the load, on slopes too. Rays that meet an upright
 * face, go through air, or pass beside the structure are lost.
 */
#pragma once

#include "core/model/outline.h"
#include "core/model/vehicle.h"

/* Load on one edge: the force, its first moment about the left end of the edge, and the loaded part. */
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

/* Adds to `shares`, one for each edge. The edges are those seen from above, from left to right. */
void qn_disperse (const QnModel *model, const QnSeenEdges *edges, const QnSource *source,
                  QnShare *shares);
