/* Rings: polygons that own their vertices, and lists of them.
 *
 * The common type of this layer: what is cut, welded, joined or read from a drawing. A ring's
 * vertices go around the boundary, the first one not repeated at the end. Coordinates in m.
 * Zeroed structs are empty and may be cleared.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/box-tree.h"
#include "core/base/status.h"

#include <glib.h>

/* Ends the program where there was no memory, as GLib does wherever this layer asks it for some. */
static inline void
qn_require_memory (bool there)
{
  if (!there)
    g_error ("not enough memory");
}

typedef struct QnRing {
  QnVec2 *points; /* owned */
  size_t count;
} QnRing;

typedef struct QnRings {
  QnRing *items;
  size_t count, capacity;
} QnRings;

/* Of a copy of the points. */
QnRing qn_ring_of (const QnVec2 *points, size_t count);
void qn_ring_clear (QnRing *ring);

/* Signed area, m2, positive counter-clockwise; centroid, of at least one point; perimeter, m; extents. */
double qn_ring_area (const QnRing *ring);
QnVec2 qn_ring_centroid (const QnRing *ring);
double qn_ring_perimeter (const QnRing *ring);
QnBox qn_ring_bounds (const QnRing *ring);

/* Makes the ring counter-clockwise. */
void qn_ring_orient (QnRing *ring);

/* Drops vertices closer than `tolerance` (m) to the one before and vertices that lie on the
 * straight line between their neighbours or at the tip of a spike, within the same distance.
 * A ring that has no area left ends with fewer than three points. Returns how many went. */
size_t qn_ring_simplify (QnRing *ring, double tolerance);

/* Starts with the lowest, then leftmost vertex: makes equal polygons equal lists. */
void qn_ring_normalize (QnRing *ring);

/* Appends a copy of the points. */
void qn_rings_add (QnRings *rings, const QnVec2 *points, size_t count);

/* Moves `ring` to the end of the list and zeroes it. */
void qn_rings_take (QnRings *rings, QnRing *ring);

/* Removes one and closes the gap, or all. */
void qn_rings_remove (QnRings *rings, size_t index);
void qn_rings_clear (QnRings *rings);

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnRing, qn_ring_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnRings, qn_rings_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnPool, qn_pool_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnBoxPairs, qn_box_pairs_clear)

/* Extents and area of all of them. */
QnBox qn_rings_bounds (const QnRings *rings);
double qn_rings_area (const QnRings *rings);

/* A side of one of them, by its first vertex. */
typedef struct QnRingSide {
  size_t ring, edge;
} QnRingSide;

/* A tree of boxes in memory of the pool. */
void qn_tree_of (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool);

/* A tree of the rings, each grown by the margin, and one of all their sides in order, which are returned, in
 * memory of the pool. */
void qn_rings_tree (const QnRings *rings, double margin, QnBoxTree *tree, QnPool *pool);
QnRingSide *qn_rings_side_tree (const QnRings *rings, double margin, QnBoxTree *tree,
                                QnPool *pool);
