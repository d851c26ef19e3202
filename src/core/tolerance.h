/* Every epsilon of the core, each with its reason. Relative unless a unit is given. */
#ifndef QN_CORE_TOLERANCE_H
#define QN_CORE_TOLERANCE_H

#include <float.h>

/* Vertices of a polygon coincide, or one lies on an edge, within this part of the polygon's size:
 * what is left of twelve decimal digits typed into a file. */
#define QN_TOLERANCE_POLYGON 1e-12

/* Rounding of a coordinate as read, turned and moved: a few units in the last place. */
#define QN_TOLERANCE_COORDINATE (4 * DBL_EPSILON)

/* Sine of the re-entrant angle below which a corner counts as straight: rounding of the corner's
 * coordinates for edges a millionth of their distance from the origin. */
#define QN_TOLERANCE_CONVEX 1e-9

/* Gaps between facing sides up to this part of the characteristic block length are reported: a
 * slip of the pen, where a mortar joint would be wider. */
#define QN_NEAR_MISS_GAP 0.01

/* Overlaps up to so many contact tolerances are reported, deeper ones refused. */
#define QN_NEAR_MISS_OVERLAP 10.0

#endif
