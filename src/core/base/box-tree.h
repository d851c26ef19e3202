/* Broad phase: which of many axis-parallel boxes meet a given box.
 *
 * A static tree of boxes, packed along a Hilbert curve. Chosen over a uniform grid because it
 * needs no cell size: a foundation a thousand times longer than the bricks on it, or a crowd of
 * splinters in one corner, costs nothing extra. Building takes O(n log n), a query O(log n + k)
 * for well-separated boxes. Source: Kamel & Faloutsos, "On packing R-trees" (1993).
 */
#pragma once

#include "core/base/base.h"
#include "core/base/box.h"
#include "core/base/memory.h"

#define QN_BOX_TREE_FANOUT     8
#define QN_BOX_TREE_MAX_LEVELS 12 /* 8^11 items are more than a QnId can number */

typedef struct QnBoxTree {
  QnBox *nodes; /* the items' boxes in tree order, then level by level to the root */
  QnId *items;  /* item in each of the first item_count nodes */
  size_t item_count;
  size_t level_starts[QN_BOX_TREE_MAX_LEVELS]; /* of the nodes */
  size_t level_sizes[QN_BOX_TREE_MAX_LEVELS];
  int32_t level_count; /* 0 for an empty tree */
} QnBoxTree;

/* One walk through the tree; several may be under way at once. */
typedef struct QnBoxQuery {
  const QnBoxTree *tree;
  QnBox box;
  int32_t level;
  size_t cursor[QN_BOX_TREE_MAX_LEVELS], end[QN_BOX_TREE_MAX_LEVELS];
} QnBoxQuery;

/* Builds the tree of `count` boxes, which are copied, in memory of the pool; item i is boxes[i]. Empty where
 * the pool has failed, be it before. */
void qn_box_tree_init (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool);

/* Starts a walk over the items whose boxes meet `box`; touching counts. */
QnBoxQuery qn_box_tree_query (const QnBoxTree *tree, QnBox box);

/* The next item, or QN_NONE. The order depends on the boxes alone. */
QnId qn_box_query_next (QnBoxQuery *query);

/* Pairs of items. */
typedef struct QnBoxPairs {
  QnId (*items)[2]; /* owned */
  size_t count, capacity;
} QnBoxPairs;

/* Fills in the pairs of items whose boxes meet once that of the lower one is grown by `margin` (m): lower
 * items first in each pair, and pairs ascending by them. O((n + k) log n) for well-separated boxes. Ends
 * once there are `most`. False when memory runs out. `pairs` must be empty. */
bool qn_box_tree_pairs (const QnBoxTree *tree, double margin, size_t most,
                        QnBoxPairs *pairs);

void qn_box_pairs_clear (QnBoxPairs *pairs);
