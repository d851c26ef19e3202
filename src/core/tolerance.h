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

#endif
