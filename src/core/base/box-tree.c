#include "core/base/box-tree.h"

#include "core/base/integer.h"

#include <stdlib.h>

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

static void
sort_items (QnBoxTree *tree, const QnBox *boxes, Entry *entries)
{
  QnBox whole = boxes[0];
  for (size_t i = 1; i < tree->item_count; i++)
    whole = qn_box_union (whole, boxes[i]);
  double extent = qn_max (whole.max.x - whole.min.x, whole.max.y - whole.min.y);

  for (size_t i = 0; i < tree->item_count; i++) {
    QnVec2 middle = qn_vec2_lerp (boxes[i].min, boxes[i].max, 0.5);
    entries[i].key = hilbert_place (cell_of (middle.x, whole.min.x, extent),
                                    cell_of (middle.y, whole.min.y, extent));
    entries[i].item = (QnId) i;
  }
  qsort (entries, tree->item_count, sizeof *entries, compare_entries);
  for (size_t i = 0; i < tree->item_count; i++) {
    tree->items[i] = entries[i].item;
    tree->nodes[i] = boxes[entries[i].item];
  }
}

void
qn_box_tree_init (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool)
{
  *tree = (QnBoxTree){ 0 };
  if (count == 0 || pool->failed)
    return;

  size_t node_count = 0;
  size_t size = count;
  for (;;) {
    tree->level_starts[tree->level_count] = node_count;
    tree->level_sizes[tree->level_count++] = size;
    node_count += size;
    if (size <= QN_BOX_TREE_FANOUT)
      break;
    size = (size + QN_BOX_TREE_FANOUT - 1) / QN_BOX_TREE_FANOUT;
  }

  tree->item_count = count;
  tree->nodes = qn_pool_alloc (pool, node_count, sizeof *tree->nodes);
  tree->items = qn_pool_alloc (pool, count, sizeof *tree->items);
  Entry *entries = qn_alloc (count, sizeof *entries);
  pool->failed |= entries == NULL;
  if (pool->failed)
    *tree = (QnBoxTree){ 0 };
  else
    sort_items (tree, boxes, entries);
  free (entries);
  /* Fills the levels above the items, each node around QN_BOX_TREE_FANOUT of the level
   * below. */
  for (int32_t level = 1; level < tree->level_count; level++) {
    const QnBox *below = tree->nodes + tree->level_starts[level - 1];
    QnBox *nodes = tree->nodes + tree->level_starts[level];
    for (size_t i = 0; i < tree->level_sizes[level - 1]; i++) {
      size_t parent = i / QN_BOX_TREE_FANOUT;
      nodes[parent] =
        i % QN_BOX_TREE_FANOUT == 0 ? below[i] : qn_box_union (nodes[parent], below[i]);
    }
  }
}

QnBoxQuery
qn_box_tree_query (const QnBoxTree *tree, QnBox box)
{
  QnBoxQuery query;
  query.tree = tree;
  query.box = box;
  query.level = tree->level_count - 1;
  if (query.level >= 0) {
    query.cursor[query.level] = 0;
    query.end[query.level] = tree->level_sizes[query.level];
  }
  return query;
}

QnId
qn_box_query_next (QnBoxQuery *query)
{
  const QnBoxTree *tree = query->tree;
  while (query->level >= 0) {
    int32_t level = query->level;
    if (query->cursor[level] == query->end[level]) {
      query->level = level + 1 < tree->level_count ? level + 1 : -1;
      continue;
    }

    size_t node = query->cursor[level]++;
    if (!qn_box_meets (tree->nodes[tree->level_starts[level] + node], query->box))
      continue;
    if (level == 0)
      return tree->items[node];

    size_t below = tree->level_sizes[level - 1];
    query->level = level - 1;
    query->cursor[level - 1] = node * QN_BOX_TREE_FANOUT;
    query->end[level - 1] = node * QN_BOX_TREE_FANOUT + QN_BOX_TREE_FANOUT;
    if (query->end[level - 1] > below)
      query->end[level - 1] = below;
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
  for (size_t i = 0; i < tree->item_count; i++) {
    QnId a = tree->items[i], b;
    QnBoxQuery query = qn_box_tree_query (tree, qn_box_grow (tree->nodes[i], margin));
    while (pairs->count < most && (b = qn_box_query_next (&query)) != QN_NONE) {
      if (b <= a)
        continue;
      if (!qn_array_reserve (&pairs->items, &pairs->capacity, pairs->count + 1,
                             sizeof *pairs->items))
        return false;
      pairs->items[pairs->count][0] = a;
      pairs->items[pairs->count++][1] = b;
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
