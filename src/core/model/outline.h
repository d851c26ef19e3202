/* Edges of the outlines of blocks: which one faces a side, and which are seen from afar. */
#pragma once

#include "core/base/memory.h"
#include "core/model/model.h"

/* The edge that faces a side most; of several such the longest. Blocks are counter-clockwise. */
QnId qn_block_facing_edge (const QnModel *model, QnId block, QnBlockSide side);

/* A stretch of an edge that nothing lies in front of. */
typedef struct QnSeenEdge {
  QnId block, edge;
  QnVec2 ends[2]; /* m, counter-clockwise around the block */
} QnSeenEdge;

typedef struct QnSeenEdges {
  QnSeenEdge *items;
  size_t count;
} QnSeenEdges;

/* The edges that parallel rays from a side meet first: the envelope of n edges, in O(n log n) by merging
 * the envelopes of halves. Edges along the rays are not seen. Where blocks overlap, the one
 * that lies in front in the middle of the common stretch hides the other. In memory of the pool; no edges
 * where it has failed. */
void qn_model_find_seen_edges (const QnModel *model, QnBlockSide from, QnSeenEdges *seen,
                               QnPool *pool);

/* The fill that lies at x, NULL for none, and the height at which a vehicle stands there, on the first fill or
 * else on the blocks, whose edges seen from above are `top`; NAN beside both. */
const QnLoad *qn_model_find_road (const QnModel *model, const QnSeenEdges *top, double x,
                                  double *height);
