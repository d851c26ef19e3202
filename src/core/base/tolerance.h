/* Tolerances of geometry, laws and solutions, each with its reason. Relative unless a unit is given.
 * Parameters of a single method are at the beginning of its file. */
#pragma once

#include <float.h>

/* Vertices of a polygon coincide, or one lies on an edge, within this part of the polygon's size:
 * what is left of twelve decimal digits typed into a file. */
#define QN_TOLERANCE_POLYGON 1e-12

/* Rounding of a coordinate as read, turned and moved: a few units in the last place. */
#define QN_TOLERANCE_COORDINATE (4 * DBL_EPSILON)

/* Sine of the re-entrant angle below which a corner counts as straight: rounding of the corner's
 * coordinates for edges a millionth of their distance from the origin. */
#define QN_TOLERANCE_CONVEX 1e-9

/* Gaps between facing sides up to this part of the characteristic block length are reported: 1 mm
 * between blocks of 50 mm. A mortar joint is wider. */
#define QN_NEAR_MISS_GAP 0.02

/* Overlaps up to this many contact tolerances are reported, deeper ones refused. */
#define QN_NEAR_MISS_OVERLAP 10.0

/* Two springs in series carry the same force to this part of it: four digits above the
 * rounding of double precision, six below the default residual tolerance. */
#define QN_TOLERANCE_SERIES 1e-12

/* A moment exceeds the plastic moment if it is larger by more than this part: rounding of a few products. */
#define QN_TOLERANCE_YIELD 1e-12

/* Range of the settings of an analysis. Below, rounding decides; above, a structure that
 * falls counts as one that rests. */
#define QN_LEAST_MULTIPLIER_TOLERANCE   1e-12
#define QN_LARGEST_MULTIPLIER_TOLERANCE 0.1
#define QN_LEAST_RESIDUAL_TOLERANCE     1e-14
#define QN_LARGEST_RESIDUAL_TOLERANCE   1e-3

/* Largest stiffness of a law, in its own unit: hundreds of millions of times that of steel. The forces
 * of a building shorten stiffer joints by less than rounding. */
#define QN_LARGEST_STIFFNESS 1e20

/* Largest load of the kind weight, in weights. */
#define QN_LARGEST_DIRECTION 1e6

/* Weights of explicitly placed pairs add up to 1 within what nine decimal digits leave. */
#define QN_TOLERANCE_WEIGHTS 1e-9

/* Two springs of the same law differ by their length only when their numbers agree to this part:
 * rounding of areas and lengths. */
#define QN_TOLERANCE_SIMILAR 1e-13

/* A force of limit analysis, in units of the loads, exceeds a strength by rounding up to this. */
#define QN_TOLERANCE_STRENGTH 1e-10

/* Rounding of the strength that a force leaves of itself, relative to the force: a few units in the
 * last place. */
#define QN_TOLERANCE_FORCE (8 * DBL_EPSILON)

/* A prescribed displacement, work or length is met to this part of its advance. */
#define QN_TOLERANCE_TARGET 1e-10

/* Rounding of a measure of displacements, relative to the terms of its sum. */
#define QN_TOLERANCE_MEASURE (8 * DBL_EPSILON)

/* A matrix whose pivots differ by more than this is singular to working precision. */
#define QN_TOLERANCE_SINGULAR 1e-15

/* Largest backward error of a factorisation without free pivoting that suits Newton's method, whose
 * residual must reach 1e-8. */
#define QN_TOLERANCE_BACKWARD 1e-12

/* Entries of a stiffness and of its transpose that differ by more than this part of the largest
 * make it unsymmetric. */
#define QN_TOLERANCE_SYMMETRIC 1e-9
