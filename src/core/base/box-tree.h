/* Broad phase: which of many axis-parallel boxes meet a given box.
 *
 * A static tree of boxes: the items of a node are divided into at most eight, by the order of their middles along
 * the longer side of its box. Chosen over a uniform grid because it needs no cell size: a foundation a
 * thousand times longer than the bricks on it, or a crowd of splinters in one corner, costs nothing extra.
 * Building takes O(n log^2 n), a query O(log n + k) for well-separated boxes.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/box.h"
#include "core/base/memory.h"

/* An item, or the smallest box around all below it. */
typedef struct QnBoxNode {
  QnBox box;
  QnId item; /* or QN_NONE */
  QnId next; /* the node behind all below this one */
} QnBoxNode;

typedef struct QnBoxTree {
  QnBoxNode *nodes; /* each before those below it; the first one is the root */
  QnId node_count;  /* 0 for an empty tree */
  size_t item_count;
} QnBoxTree;

/* One walk through the tree; several may be under way at once. */
typedef struct QnBoxQuery {
  const QnBoxTree *tree;
  QnBox box;
  QnId node;
} QnBoxQuery;

/* Builds the tree of `count` boxes, which are copied, in memory of the pool; item i is boxes[i]. Empty where
 * the pool has failed, be it before. */
void qn_box_tree_init (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool);

/* Starts a walk over the items whose boxes meet `box`; touching counts. */
static inline QnBoxQuery
qn_box_tree_query (const QnBoxTree *tree, QnBox box)
{
  return (QnBoxQuery){ tree, box, 0 };
}

/* The next item, or QN_NONE. The order depends on the boxes alone. */
QnId qn_box_query_next (QnBoxQuery *query);

/* Pairs of items. */
typedef struct QnBoxPairs {
  QnId (*items)[2]; /* owned */
  size_t count, capacity;
} QnBoxPairs;

/* Fills in the pairs of items whose boxes meet once one of the two is grown by `margin` (m): lower
 * items first in each pair, and pairs ascending by them. O((n + k) log n) for well-separated boxes. Ends
 * once there are `most`. False when memory runs out. `pairs` must be empty. */
bool qn_box_tree_pairs (const QnBoxTree *tree, double margin, size_t most,
                        QnBoxPairs *pairs);

void qn_box_pairs_clear (QnBoxPairs *pairs);
