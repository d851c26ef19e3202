#include "core/box-tree.h"

#include "core/memory.h"

#include <stdlib.h>

typedef struct {
  uint64_t key;
  QnId item;
} Entry;

/* Cells of the curve along each side of the square: splinters a millionth of the whole still find
 * an order. */
#define CURVE_BITS 24

/* Place of a cell along the Hilbert curve that fills a square of 2^24 x 2^24 cells. Two digits
 * of the place, one quadrant, are settled per turn of the loop; the rest of the square is then
 * turned so that the curve inside the quadrant has the standard position. */
static uint64_t
hilbert_place (uint32_t x, uint32_t y)
{
  uint64_t place = 0;
  for (uint32_t bit = UINT32_C (1) << (CURVE_BITS - 1); bit > 0; bit >>= 1) {
    uint32_t right = (x & bit) != 0;
    uint32_t upper = (y & bit) != 0;
    place = (place << 2) | ((3 * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      uint32_t swap = x;
      x = y;
      y = swap;
    }
  }
  return place;
}

static uint32_t
cell_of (double value, double low, double extent)
{
  double share = extent > 0 ? (value - low) / extent : 0;
  return (uint32_t) (fmin (fmax (share, 0), 1) * ((UINT32_C (1) << CURVE_BITS) - 1));
}

static int
compare_entries (const void *a, const void *b)
{
  const Entry *left = a, *right = b;
  if (left->key != right->key)
    return left->key < right->key ? -1 : 1;
  return (left->item > right->item) - (left->item < right->item);
}

static bool
sort_items (QnBoxTree *tree, const QnBox *boxes)
{
  Entry *entries = qn_alloc (tree->item_count, sizeof *entries);
  if (entries == NULL)
    return false;

  QnBox whole = boxes[0];
  for (size_t i = 1; i < tree->item_count; i++)
    whole = qn_box_union (whole, boxes[i]);
  double extent = fmax (whole.max.x - whole.min.x, whole.max.y - whole.min.y);

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
  free (entries);
  return true;
}

/* Fills the levels above the items, each node around QN_BOX_TREE_FANOUT of the level below. */
static void
build_levels (QnBoxTree *tree)
{
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

bool
qn_box_tree_init (QnBoxTree *tree, const QnBox *boxes, size_t count)
{
  *tree = (QnBoxTree){ 0 };
  if (count == 0)
    return true;

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
  tree->nodes = qn_alloc (node_count, sizeof *tree->nodes);
  tree->items = qn_alloc (count, sizeof *tree->items);
  if (tree->nodes == NULL || tree->items == NULL || !sort_items (tree, boxes)) {
    qn_box_tree_clear (tree);
    return false;
  }
  build_levels (tree);
  return true;
}

void
qn_box_tree_clear (QnBoxTree *tree)
{
  free (tree->nodes);
  free (tree->items);
  *tree = (QnBoxTree){ 0 };
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

QnBox
qn_box_of_points (const QnVec2 *points, size_t count)
{
  QnBox box = { points[0], points[0] };
  for (size_t i = 1; i < count; i++)
    box = qn_box_union (box, (QnBox){ points[i], points[i] });
  return box;
}
