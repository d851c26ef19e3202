/* Cutting and joining polygons.
 *
 * Every result is a list of valid simple polygons, counter-clockwise, free of repeated and
 * collinear vertices, sorted from left to right, then from the bottom up; or a named error.
 * Inputs are checked first: not finite, too large, self-crossing … are refused with
 * QN_ENTITY_BLOCK and the index of the ring in its list. Results are appended to `out`, which
 * is left as it was on failure. Coordinates in m; precision is relative to the polygons' size
 * plus their distance from the origin, so work near a local origin where it matters.
 */
#pragma once

#include "core/base/status.h"
#include "stereotomy/ring.h"

/* Whether the ring may be a block: QN_OK or the problem, with `index` in the diagnostic. */
QnStatus qn_ring_check (const QnRing *ring, QnId index, QnDiag *diag);

/* What belongs to `subject` and to none of `cutters`. Where a cutter lies inside the subject, the
 * remainder around it is parted by vertical lines through the holes, so that it is simple.
 * Nothing left is an empty result. */
QnStatus qn_polygon_difference (const QnRing *subject, const QnRings *cutters,
                                QnRings *out, QnDiag *diag);

/* What belongs to both. */
QnStatus qn_polygon_intersection (const QnRing *a, const QnRing *b, QnRings *out,
                                  QnDiag *diag);

/* All of them joined into one. QN_PROBLEM_GEOMETRY_SEVERAL where they do not hang together along
 * an edge, QN_PROBLEM_GEOMETRY_HOLE where they surround a hole. */
QnStatus qn_polygons_union (const QnRings *rings, QnRing *out, QnDiag *diag);

/* The two sides (or more parts) of `subject` along the infinite line through a and b; the
 * subject itself where the line misses it. */
QnStatus qn_polygon_cut (const QnRing *subject, QnVec2 a, QnVec2 b, QnRings *out,
                         QnDiag *diag);
