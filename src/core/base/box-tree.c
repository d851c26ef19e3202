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

/* Bits of a key that one pass of the sort looks at. */
#define DIGIT_BITS 8
#define DIGITS     (1 << DIGIT_BITS)

/* Sorts by key, digit by digit from the last one; equal keys stay in their order. `spare` has room
 * for as many entries; the sorted ones end in `entries`, since the passes are even in number. */
static void
sort_entries (Entry *entries, Entry *spare, size_t count)
{
  Entry *from = entries, *to = spare;
  for (int shift = 0; shift < 2 * CURVE_BITS; shift += DIGIT_BITS) {
    size_t next[DIGITS + 1] = { 0 };
    for (size_t i = 0; i < count; i++)
      next[((from[i].key >> shift) & (DIGITS - 1)) + 1]++;
    for (int digit = 1; digit < DIGITS; digit++)
      next[digit] += next[digit - 1];
    for (size_t i = 0; i < count; i++)
      to[next[(from[i].key >> shift) & (DIGITS - 1)]++] = from[i];
    Entry *swap = from;
    from = to;
    to = swap;
  }
}
_Static_assert(2 * CURVE_BITS % (2 * DIGIT_BITS) == 0, "an even number of passes");

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
  sort_entries (entries, entries + tree->item_count, tree->item_count);
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
  tree->nodes = qn_pool_add (pool, qn_alloc_unset (node_count, sizeof *tree->nodes));
  tree->items = qn_pool_add (pool, qn_alloc_unset (count, sizeof *tree->items));
  Entry *entries = qn_alloc_unset (2 * count, sizeof *entries);
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

static bool
add_pair (QnBoxPairs *pairs, QnId a, QnId b)
{
  if (pairs->count == pairs->capacity
      && !qn_array_reserve (&pairs->items, &pairs->capacity, pairs->count + 1,
                            sizeof *pairs->items))
    return false;
  pairs->items[pairs->count][0] = a;
  pairs->items[pairs->count++][1] = b;
  return true;
}

/* One walk of a tree against itself. */
typedef struct {
  const QnBoxTree *tree;
  double margin;
  size_t most;
  QnBoxPairs *pairs;
} Join;

/* The children of a node: nodes of the level below it. */
typedef struct {
  size_t begin, end;
} Children;

static Children
children_of (const QnBoxTree *tree, int32_t level, size_t node)
{
  size_t begin = node * QN_BOX_TREE_FANOUT, below = tree->level_sizes[level - 1];
  size_t end = begin + QN_BOX_TREE_FANOUT;
  return (Children){ begin, end < below ? end : below };
}

/* Finds the pairs below two nodes, whose children `u` and `v` are of the level given; all of `v` lie
 * within `around_v`. A node is paired with itself, an item is not. */
static bool
join_nodes (const Join *how, int32_t level, Children u, Children v, QnBox around_v)
{
  const QnBoxTree *tree = how->tree;
  const QnBox *boxes = tree->nodes + tree->level_starts[level];
  for (size_t i = u.begin; i < u.end; i++) {
    QnBox box = qn_box_grow (boxes[i], how->margin);
    if (!qn_box_meets (box, around_v))
      continue;
    size_t j = u.begin != v.begin ? v.begin : level == 0 ? i + 1 : i;
    for (; j < v.end && how->pairs->count < how->most; j++) {
      if (!qn_box_meets (box, boxes[j]))
        continue;
      bool done = level == 0 ? add_pair (how->pairs, tree->items[i], tree->items[j])
                             : join_nodes (how, level - 1, children_of (tree, level, i),
                                           children_of (tree, level, j), boxes[j]);
      if (!done)
        return false;
    }
  }
  return true;
}

bool
qn_box_tree_pairs (const QnBoxTree *tree, double margin, size_t most, QnBoxPairs *pairs)
{
  static const QnBox everywhere = { { -INFINITY, -INFINITY }, { INFINITY, INFINITY } };
  if (tree->level_count == 0)
    return true;
  int32_t top = tree->level_count - 1;
  Children all = { 0, tree->level_sizes[top] };
  Join how = { tree, margin, most, pairs };
  return join_nodes (&how, top, all, all, everywhere);
}

static int
compare_pairs (const void *a, const void *b)
{
  const QnId *p = a, *q = b;

  return p[0] != q[0] ? (p[0] < q[0] ? -1 : 1) : (p[1] > q[1]) - (p[1] < q[1]);
}

void
qn_box_pairs_sort (QnBoxPairs *pairs)
{
  for (size_t i = 0; i < pairs->count; i++) {
    QnId *pair = pairs->items[i], first = pair[0];
    if (pair[1] < first) {
      pair[0] = pair[1];
      pair[1] = first;
    }
  }
  if (pairs->count > 1)
    qsort (pairs->items, pairs->count, sizeof *pairs->items, compare_pairs);
}

void
qn_box_pairs_clear (QnBoxPairs *pairs)
{
  free (pairs->items);
  *pairs = (QnBoxPairs){ 0 };
}
