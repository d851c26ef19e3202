#include "core/base/box-tree.h"

#include <stdlib.h>

/* Nodes right below a node. */
#define FANOUT 8

/* An item, and the middle of its box along the axis by which the items of a node are divided. */
typedef struct {
  double middle;
  QnId item;
} Entry;

static int
compare_entries (const void *a, const void *b)
{
  const Entry *p = a, *q = b;

  return p->middle != q->middle ? (p->middle < q->middle ? -1 : 1) : p->item - q->item;
}

/* Adds the node of some items, and all below it. */
static void
add_node (QnBoxTree *tree, const QnBox *boxes, Entry *entries, size_t count)
{
  QnBoxNode *node = &tree->nodes[tree->node_count++];
  size_t part = 1; /* items of each node right below it */
  QnBox whole = boxes[entries->item];

  for (size_t i = 1; i < count; i++)
    whole = qn_box_union (whole, boxes[entries[i].item]);
  *node = (QnBoxNode){ whole, count == 1 ? entries->item : QN_NONE, QN_NONE };
  if (count > FANOUT) { /* else each is a node of its own */
    bool upright = whole.max.y - whole.min.y > whole.max.x - whole.min.x;
    for (size_t i = 0; i < count; i++) {
      const QnBox *box = &boxes[entries[i].item];
      double sum = upright ? box->min.y + box->max.y : box->min.x + box->max.x;
      entries[i].middle = qn_max (0.5 * sum, -INFINITY); /* of no number too */
    }
    qsort (entries, count, sizeof *entries, compare_entries);
  }
  while (part * FANOUT < count)
    part *= FANOUT;
  for (size_t i = 0; i < count && count > 1; i += part)
    add_node (tree, boxes, entries + i, part < count - i ? part : count - i);
  node->next = tree->node_count;
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
    for (size_t i = 0; i < count; i++)
      entries[i].item = (QnId) i;
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
