/* Plane polygons: vertices in order around the boundary, the first one not repeated at the end.
 *
 * All sums run over coordinates relative to the first vertex, so a polygon a million metres
 * from the origin keeps its digits. Nothing here allocates except qn_polygon_check().
 */
#pragma once

#include "core/base/base.h"
#include "core/base/problem.h"
#include "core/base/vec2.h"

typedef struct QnPolygonProperties {
  double area;         /* m2, positive for counter-clockwise polygons */
  QnVec2 centroid;     /* m */
  double polar_moment; /* about the centroid, m4, sign as the area */
} QnPolygonProperties;

/* Area, centroid and polar moment by summing triangles with the first vertex (Green's theorem;
 * Steger, "On the calculation of arbitrary moments of polygons", 1996). The centroid of a
 * polygon without area is its first vertex. */
QnPolygonProperties qn_polygon_properties (const QnVec2 *vertices, size_t count);

/* Reverses the order; the first vertex stays the first. */
void qn_polygon_reverse (QnVec2 *vertices, size_t count);

/* Distance of a point from the segment pq, m, and what of the segment is nearest to it. */
double qn_segment_distance (QnVec2 p, QnVec2 q, QnVec2 point);
QnVec2 qn_segment_nearest (QnVec2 p, QnVec2 q, QnVec2 point);

/* Least extent of a polygon across one of its own sides, m. */
double qn_polygon_width (const QnVec2 *vertices, size_t count);

/* Depth of a point in a simple polygon: its distance from the boundary, positive inside and
 * negative outside, m. */
double qn_polygon_depth (const QnVec2 *vertices, size_t count, QnVec2 point);

/* A point well inside a simple counter-clockwise polygon (O(n)). */
QnVec2 qn_polygon_inner_point (const QnVec2 *vertices, size_t count);

/* Defect of a polygon. */
typedef struct QnPolygonFlaw {
  QnProblem problem; /* NONE, TOO_FEW_VERTICES, NOT_FINITE, TOO_LARGE, DUPLICATE_VERTEX,
                        ZERO_AREA, SELF_CROSSING or NO_MEMORY */
  QnId vertex;       /* where it shows first, or QN_NONE */
  QnId other; /* the vertex repeated, first vertex of the edge crossed, or QN_NONE */
} QnPolygonFlaw;

/* Checks that a polygon of either orientation is simple and has an area. Distances below
 * rounding (QN_TOLERANCE_POLYGON of its size) count as none, so a polygon that touches itself is
 * refused like one that crosses itself. O(n log n), except for constructed cases. */
QnPolygonFlaw qn_polygon_check (const QnVec2 *vertices, size_t count);
