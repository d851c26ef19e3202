/* Sides of blocks: the straight runs of a polygon's boundary.
 *
 * Vertices that lie on a straight line, as where a neighbour's corner was welded in, do not end
 * a side: one joint stays one contact face.
 */
#pragma once

#include "core/base/memory.h"
#include "core/model/model.h"

typedef struct QnSide {
  QnId block;
  QnId vertex;       /* first vertex, counted within the block */
  QnVec2 start, end; /* m; the block lies to the left of start -> end */
  QnVec2 direction;  /* unit */
  double length;     /* m */
} QnSide;

/* The sides of all blocks, those of block i from first[i] up to first[i + 1]. */
typedef struct QnSides {
  QnSide *items;
  size_t *first;
  size_t count;
} QnSides;

/* Collects the sides of a prepared model. Vertices within `tolerance` (m) of the line between
 * the ends of a run are on it. `sides` is overwritten, and in memory of the pool. */
void qn_sides_init (QnSides *sides, const QnModel *model, double tolerance, QnPool *pool);

/* The side of a block that begins with this vertex; NULL: none. */
const QnSide *qn_sides_find (const QnSides *sides, QnId block, QnId vertex);
