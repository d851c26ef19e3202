#include "core/base/box-tree.h"

#include "core/base/integer.h"

#include <stdlib.h>

/* Nodes right below a node. */
#define FANOUT 8

typedef struct {
  uint64_t key;
  QnId item;
} Entry;

/* Cells of the curve along each side of the square: splinters a millionth of the whole still find
 * an order. */
#define CURVE_BITS   24
#define LARGEST_CELL ((INT64_C (1) << CURVE_BITS) - 1)

/* Place of a cell along the Hilbert curve that fills a square of 2^24 x 2^24 cells. Two digits
 * of the place, one quadrant, are settled per turn of the loop; the rest of the square is then
 * turned so that the curve inside the quadrant has the standard position. Without branches, which
 * could not be predicted. */
static uint64_t
hilbert_place (uint32_t x, uint32_t y)
{
  uint64_t place = 0;
  for (int bit = CURVE_BITS - 1; bit >= 0; bit--) {
    uint32_t right = (x >> bit) & 1, upper = (y >> bit) & 1;
    place = (place << 2) | ((3 * right) ^ upper);
    uint32_t lower = upper - 1;         /* all bits where the quadrant is a lower one */
    uint32_t reversed = lower & -right; /* and where it is the lower right one */
    uint32_t exchange = (x ^ y) & lower;
    x ^= reversed ^ exchange;
    y ^= reversed ^ exchange;
  }
  return place;
}

static uint32_t
cell_of (double value, double low, double extent)
{
  double share = extent > 0 ? (value - low) / extent : 0;
  return (uint32_t) qn_to_integer (share * LARGEST_CELL, 0, LARGEST_CELL);
}

static int
compare_entries (const void *a, const void *b)
{
  const Entry *p = a, *q = b;

  return p->key != q->key ? (p->key < q->key ? -1 : 1) : p->item - q->item;
}

/* The items in their order along the curve. */
static void
sort_items (const QnBox *boxes, size_t count, Entry *entries)
{
  QnBox whole = boxes[0];
  for (size_t i = 1; i < count; i++)
    whole = qn_box_union (whole, boxes[i]);
  double extent = qn_max (whole.max.x - whole.min.x, whole.max.y - whole.min.y);

  for (size_t i = 0; i < count; i++) {
    QnVec2 middle = qn_vec2_lerp (boxes[i].min, boxes[i].max, 0.5);
    entries[i].key = hilbert_place (cell_of (middle.x, whole.min.x, extent),
                                    cell_of (middle.y, whole.min.y, extent));
    entries[i].item = (QnId) i;
  }
  qsort (entries, count, sizeof *entries, compare_entries);
}

/* Adds the node of some items, and all below it. */
static QnBox
add_node (QnBoxTree *tree, const QnBox *boxes, const Entry *entries, size_t count)
{
  QnBoxNode *node = &tree->nodes[tree->node_count++];
  size_t part = 1; /* items of each node right below it */

  *node = (QnBoxNode){ boxes[entries->item], QN_NONE, QN_NONE };
  if (count == 1)
    node->item = entries->item;
  while (part * FANOUT < count)
    part *= FANOUT;
  for (size_t i = 0; i < count && count > 1; i += part)
    node->box = qn_box_union (node->box, add_node (tree, boxes, entries + i,
                                                   part < count - i ? part : count - i));
  node->next = tree->node_count;
  return node->box;
}

void
qn_box_tree_init (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool)
{
  *tree = (QnBoxTree){ 0 };
  if (count == 0 || pool->failed)
    return;
  /* Of n items the levels above have n / 8, n / 64, …, each rounded up. */
  tree->nodes =
    qn_pool_alloc (pool, count + count / (FANOUT - 1) + 12, sizeof *tree->nodes);
  Entry *entries = qn_alloc (count, sizeof *entries);
  pool->failed |= entries == NULL;
  if (!pool->failed) {
    sort_items (boxes, count, entries);
    add_node (tree, boxes, entries, count);
    tree->item_count = count;
  }
  free (entries);
}

QnId
qn_box_query_next (QnBoxQuery *query)
{
  while (query->node < query->tree->node_count) {
    const QnBoxNode *node = &query->tree->nodes[query->node];
    bool meets = qn_box_meets (node->box, query->box);
    query->node = meets ? query->node + 1 : node->next;
    if (meets && node->item != QN_NONE)
      return node->item;
  }
  return QN_NONE;
}

static int
compare_pairs (const void *a, const void *b)
{
  const QnId *p = a, *q = b;

  return p[0] != q[0] ? (p[0] < q[0] ? -1 : 1) : (p[1] > q[1]) - (p[1] < q[1]);
}

bool
qn_box_tree_pairs (const QnBoxTree *tree, double margin, size_t most, QnBoxPairs *pairs)
{
  for (QnId i = 0; i < tree->node_count; i++) {
    QnId a = tree->nodes[i].item, b;
    /* With those behind it. */
    QnBoxQuery query = { tree, qn_box_grow (tree->nodes[i].box, margin), i + 1 };
    while (a != QN_NONE && pairs->count < most
           && (b = qn_box_query_next (&query)) != QN_NONE) {
      if (!qn_array_reserve (&pairs->items, &pairs->capacity, pairs->count + 1,
                             sizeof *pairs->items))
        return false;
      pairs->items[pairs->count][0] = a < b ? a : b;
      pairs->items[pairs->count++][1] = a < b ? b : a;
    }
  }
  if (pairs->count > 1)
    qsort (pairs->items, pairs->count, sizeof *pairs->items, compare_pairs);
  return true;
}

void
qn_box_pairs_clear (QnBoxPairs *pairs)
{
  free (pairs->items);
  *pairs = (QnBoxPairs){ 0 };
}
