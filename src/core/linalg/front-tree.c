#include "core/linalg/front-tree.h"

#include "core/base/integer.h"
#include "core/base/memory.h"

#include <amd.h>
#include <stdlib.h>
#include <string.h>

/* Unknowns of a body at most. */
#define SIDE 3

/* A front joins its parent's where the sum of pivots stays small, or where little of the larger
 * front is known to be zero: larger fronts are faster, number for number. */
#define SMALL      9
#define MIDDLING   48
#define SOME_ZEROS 0.25
#define FEW_ZEROS  0.05

/* What the analysis works on: the graph of nodes, which are unknowns that stand together and
 * meet the same others. */
typedef struct {
  QnPool pool; /* of all that follows but rows */
  int32_t n, count;
  const int32_t *ap, *ai;
  int32_t *node;         /* n: of each unknown */
  int32_t *width;        /* unknowns of each node */
  int32_t *start, *next; /* neighbours of nodes, themselves left out */
  int32_t *order;        /* the k-th node to be eliminated, */
  int32_t *place;        /* and the reverse */

  int32_t *column_start,
    *rows; /* pattern of the factor by nodes in order of elimination */
  size_t row_capacity;
  int32_t *group;  /* of each place: the group that it is eliminated with */
  int32_t *counts; /* scratch */
  int32_t *marks;
} Analysis;

static bool
same_column (const Analysis *a, int32_t i, int32_t j)
{
  int32_t length = a->ap[i + 1] - a->ap[i];

  return length == a->ap[j + 1] - a->ap[j]
         && memcmp (a->ai + a->ap[i], a->ai + a->ap[j], (size_t) length * sizeof *a->ai)
              == 0;
}

static void
gather_nodes (Analysis *a)
{
  a->count = 0;
  for (int32_t i = 0, first = 0; i < a->n; i++) {
    if (i == 0 || i - first == SIDE || !same_column (a, first, i)) {
      first = i;
      a->count++;
    }
    a->node[i] = a->count - 1;
    a->width[a->count - 1]++;
  }
}

static void
fill_graph (Analysis *a)
{
  int32_t fill = 0;

  memset (a->marks, -1, (size_t) a->count * sizeof *a->marks);
  for (int32_t i = 0; i < a->n; i++) {
    int32_t k = a->node[i];
    if (i > 0 && a->node[i - 1] == k)
      continue;
    a->start[k] = fill;
    a->marks[k] = k;
    for (int32_t p = a->ap[i]; p < a->ap[i + 1]; p++) {
      int32_t neighbour = a->node[a->ai[p]];
      if (a->marks[neighbour] != k) {
        a->marks[neighbour] = k;
        a->next[fill++] = neighbour;
      }
    }
  }
  a->start[a->count] = fill;
}

/* The rows of column j of the factor: the later neighbours of node j, and the rows of the columns
 * that it is the parent of in the elimination tree, which `child` and `sibling` hold. */
static int32_t
find_column (const Analysis *a, int32_t j, const int32_t *child, const int32_t *sibling,
             int32_t *out)
{
  int32_t length = 0;

  a->marks[j] = j;
  for (int32_t p = a->start[a->order[j]]; p < a->start[a->order[j] + 1]; p++) {
    int32_t i = a->place[a->next[p]];
    if (i > j && a->marks[i] != j) {
      a->marks[i] = j;
      out[length++] = i;
    }
  }
  for (int32_t c = child[j]; c != -1; c = sibling[c])
    for (int32_t p = a->column_start[c]; p < a->column_start[c + 1]; p++) {
      int32_t i = a->rows[p];
      if (a->marks[i] != j) {
        a->marks[i] = j;
        out[length++] = i;
      }
    }
  qsort (out, (size_t) length, sizeof *out, qn_compare_ids);
  return length;
}

/* Fills column_start and rows. */
static void
find_columns (Analysis *a)
{
  size_t nodes = (size_t) a->count;
  int32_t *scratch = qn_pool_alloc (&a->pool, 3 * nodes + 1, sizeof *scratch);
  int32_t *child = scratch, *sibling = scratch + nodes, *column = scratch + 2 * nodes;

  if (scratch == NULL)
    return;
  memset (scratch, -1, 2 * nodes * sizeof *scratch);
  memset (a->marks, -1, nodes * sizeof *a->marks);
  for (int32_t j = 0; j < a->count; j++) {
    int32_t start = a->column_start[j],
            length = find_column (a, j, child, sibling, column);
    a->pool.failed |= !qn_array_reserve (
      &a->rows, &a->row_capacity, (size_t) start + (size_t) length, sizeof *a->rows);
    if (a->pool.failed)
      return;
    memcpy (a->rows + start, column, (size_t) length * sizeof *column);
    a->column_start[j + 1] = start + length;
    if (length > 0) {
      sibling[j] = child[column[0]];
      child[column[0]] = j;
    }
  }
}

/* --- Groups of nodes that make a front -------------------------------------------------- */

/* A group is known by its last node, whose column of the factor is what waits. */
typedef struct {
  int32_t pivots, rest; /* unknowns */
  double zeros;         /* numbers of its pivots' columns that are known to be zero */
} Group;

static int32_t
rows_below (const Analysis *a, int32_t j)
{
  int32_t sum = 0;

  for (int32_t p = a->column_start[j]; p < a->column_start[j + 1]; p++)
    sum += a->width[a->order[a->rows[p]]];
  return sum;
}

static bool
is_worth_joining (const Group *child, const Group *parent, double *zeros)
{
  double pivots = child->pivots + parent->pivots;
  double size = pivots * (pivots + 2.0 * parent->rest);

  *zeros = child->zeros + parent->zeros
           + 2.0 * child->pivots * (parent->pivots + parent->rest - child->rest);
  return *zeros == 0 || pivots <= SMALL
         || *zeros <= (pivots <= MIDDLING ? SOME_ZEROS : FEW_ZEROS) * size;
}

/* Every node starts as a group, and joins its parent's in the elimination tree where that is
 * faster. */
static void
form_groups (Analysis *a)
{
  Group *groups = qn_pool_alloc (&a->pool, (size_t) a->count, sizeof *groups);

  if (a->pool.failed)
    return;
  for (int32_t j = 0; j < a->count; j++) {
    a->group[j] = j;
    groups[j].pivots = a->width[a->order[j]];
    groups[j].rest = rows_below (a, j);
  }
  for (int32_t j = 0; j < a->count; j++) {
    double zeros;
    if (a->column_start[j] == a->column_start[j + 1])
      continue;
    Group *parent = &groups[a->rows[a->column_start[j]]], *child = &groups[j];
    if (is_worth_joining (child, parent, &zeros)) {
      a->group[j] = a->rows[a->column_start[j]];
      parent->pivots += child->pivots;
      parent->zeros = zeros;
    }
  }
  for (int32_t j = a->count - 1; j >= 0; j--) /* parents have higher numbers */
    a->group[j] = a->group[a->group[j]];
}

/* a->marks becomes the front of each node that is the last of a group: in postorder, whatever
 * the order of nodes is, so that subtrees stay together. Returns their number. */
static int32_t
number_groups (Analysis *a)
{
  int32_t *size = a->counts, *next = a->marks, count = 0; /* of and in subtrees */

  memset (size, 0, (size_t) (a->count + 1) * sizeof *size);
  for (int32_t j = 0; j < a->count; j++)
    if (a->group[j] == j) {
      size[j]++;
      if (a->column_start[j] < a->column_start[j + 1])
        size[a->group[a->rows[a->column_start[j]]]] += size[j];
    }
  for (int32_t j = a->count - 1; j >= 0; j--)
    if (a->group[j] == j) {
      bool is_root = a->column_start[j] == a->column_start[j + 1];
      int32_t *end = is_root ? &count : &next[a->group[a->rows[a->column_start[j]]]];
      next[j] = *end;
      *end += size[j];
    }
  return count; /* and next is where each of them itself comes, after its subtree */
}

/* Puts the nodes of a group side by side: a->counts becomes the place of each in the final
 * order. */
static void
order_groups (Analysis *a, QnFrontTree *tree)
{
  int32_t *index = a->marks, sum = 0; /* index: of the front that a node is the last of */

  tree->front_count = number_groups (a);
  memset (a->counts, 0, (size_t) (a->count + 1) * sizeof *a->counts);
  for (int32_t j = 0; j < a->count; j++)
    tree->fronts[index[a->group[j]]].pivots += a->width[a->order[j]];
  for (int32_t f = 0; f < tree->front_count; f++) {
    QnFront *front = &tree->fronts[f];
    int32_t pivots = front->pivots;
    *front = (QnFront){ .first = sum, .child = QN_NONE, .sibling = QN_NONE };
    sum += pivots;
  }
  for (int32_t j = 0; j < a->count; j++) {
    QnFront *front = &tree->fronts[index[a->group[j]]];
    a->counts[j] = front->first + front->pivots; /* first position of the node */
    front->pivots += a->width[a->order[j]];
  }
  for (int32_t i = 0; i < a->n; i++) {
    int32_t j = a->place[a->node[i]];
    bool begins = i == 0 || a->node[i - 1] != a->node[i];
    tree->position[i] = begins ? a->counts[j] : tree->position[i - 1] + 1;
  }
}

/* The rests, and where they stand in the parents. */
static void
list_rests (const Analysis *a, QnFrontTree *tree)
{
  size_t total = 0;
  int32_t fill = 0;

  for (int32_t j = 0; j < a->count; j++)
    if (a->group[j] == j)
      total += (size_t) rows_below (a, j);
  tree->rows = qn_pool_alloc (&tree->pool, total + 1, sizeof *tree->rows);
  tree->places = qn_pool_alloc (&tree->pool, total + 1, sizeof *tree->places);
  if (tree->pool.failed)
    return;
  for (int32_t j = 0; j < a->count; j++) {
    if (a->group[j] != j)
      continue;
    QnFront *front = &tree->fronts[a->marks[j]];
    front->first_row = fill;
    for (int32_t p = a->column_start[j]; p < a->column_start[j + 1]; p++)
      for (int32_t w = 0; w < a->width[a->order[a->rows[p]]]; w++)
        tree->rows[fill++] = a->counts[a->rows[p]] + w;
    front->rest = fill - front->first_row;
    qsort (tree->rows + front->first_row, (size_t) front->rest, sizeof *tree->rows,
           qn_compare_ids);
    front->parent =
      front->rest > 0 ? a->marks[a->group[a->rows[a->column_start[j]]]] : QN_NONE;
  }
}

/* Makes each front a child of its parent, and finds where its rest goes there. */
static void
link_fronts (QnFrontTree *tree)
{
  for (int32_t f = tree->front_count - 1; f >= 0; f--) {
    QnFront *front = &tree->fronts[f];
    if (front->parent == QN_NONE)
      continue;
    QnFront *parent = &tree->fronts[front->parent];
    int32_t next = 0;
    front->sibling = parent->child;
    parent->child = f;
    for (int32_t k = front->first_row; k < front->first_row + front->rest; k++) {
      int32_t row = tree->rows[k];
      if (row < parent->first + parent->pivots) {
        tree->places[k] = row - parent->first;
        continue;
      }
      while (tree->rows[parent->first_row + next] < row)
        next++;
      tree->places[k] = parent->pivots + next;
    }
  }
}

static bool
analyse (Analysis *a, QnFrontTree *tree)
{
  size_t n = (size_t) a->n, entries = (size_t) a->ap[a->n];
  int32_t **lists[] = { &a->node,  &a->width,        &a->start, &a->order, &a->place,
                        &a->marks, &a->column_start, &a->group, &a->counts };

  for (size_t i = 0; i < QN_N_ELEMENTS (lists); i++)
    *lists[i] = qn_pool_alloc (&a->pool, n + 1, sizeof (int32_t));
  a->next = qn_pool_alloc (&a->pool, entries, sizeof *a->next);
  tree->position = qn_pool_alloc (&tree->pool, n + 1, sizeof *tree->position);
  tree->fronts = qn_pool_alloc (&tree->pool, n, sizeof *tree->fronts);
  if (a->pool.failed || tree->pool.failed)
    return false;
  gather_nodes (a);
  fill_graph (a);
  /* The order of elimination, by minimum degree, and the columns that belong to it. */
  a->pool.failed = amd_order (a->count, a->start, a->next, a->order, NULL, NULL) < AMD_OK;
  for (int32_t j = 0; j < a->count && !a->pool.failed; j++)
    a->place[a->order[j]] = j;
  if (!a->pool.failed)
    find_columns (a);
  form_groups (a);
  if (a->pool.failed)
    return false;
  order_groups (a, tree);
  list_rests (a, tree);
  if (tree->pool.failed)
    return false;
  link_fronts (tree);
  return true;
}

bool
qn_front_tree_init (QnFrontTree *tree, int32_t n, const int32_t *ap, const int32_t *ai)
{
  Analysis a = { .n = n, .ap = ap, .ai = ai };

  *tree = (QnFrontTree){ .n = n };
  bool ok = analyse (&a, tree);
  free (a.rows);
  qn_pool_clear (&a.pool);
  return ok;
}

void
qn_front_tree_clear (QnFrontTree *tree)
{
  qn_pool_clear (&tree->pool);
  *tree = (QnFrontTree){ 0 };
}
