/* Joints that are not quite where the drawing has them.
 *
 * Corners that pieces share are moved as one, at random, so that who touches whom stays as it was
 * and no gap opens:
 *
 *   - a corner in the middle of another piece's side stays on that side, and so do the ends of the
 *     side: the bed joints of a wall stay straight, its head joints lean;
 *   - what lies on a straight part of the outline stays on it;
 *   - corners of the outline that belong to one piece alone, and corners of foundations, stay.
 *
 * A corner moves by `size` times its distance from what it does not belong to, at most.
 */

#include "core/base/box-tree.h"
#include "core/base/polygon.h"
#include "stereotomy/masonry-parts.h"

#include <stdlib.h>

/* Rounding in the places of corners, part of the object's size; and in directions. */
#define ROUNDING  1e-9
#define DIRECTION 1e-6

typedef enum { FREE, ON_LINE, FIXED } Freedom;

/* A place where corners of pieces meet. */
typedef struct Node {
  QnVec2 at;
  Freedom freedom;
  QnVec2 line;        /* ON_LINE: its direction */
  double clearance;   /* from what it does not belong to, m */
  int32_t pieces;     /* that have it as a corner */
  QnVec2 outline;     /* direction of a side of the outline */
  bool outline_turns; /* sides of the outline with two directions meet here */
} Node;

/* A part of a side, between two nodes that follow each other on it. */
typedef struct Part {
  QnId a, b; /* a < b */
} Part;

typedef struct Net {
  QnPool pool; /* of the trees */
  Node *nodes;
  size_t node_count;
  QnId *corners; /* node of every vertex of every piece */
  GArray
    *cycle; /* of QnId: nodes around the pieces, those in the middle of sides included */
  guint *ends; /* of every piece in the cycle */
  double tolerance;
  QnBoxTree tree; /* of the nodes */
} Net;

static QnId *
cycle_of (const Net *net)
{
  return (QnId *) net->cycle->data;
}

static void
hold (Node *node, QnVec2 direction)
{
  if (node->freedom == FREE) {
    node->freedom = ON_LINE;
    node->line = direction;
  } else if (node->freedom == ON_LINE
             && fabs (qn_vec2_cross (node->line, direction)) > DIRECTION) {
    node->freedom = FIXED;
  }
}

/* Gives equal vertices one node. */
static void
find_nodes (const QnPieces *pieces, Net *net)
{
  size_t count = 0, at = 0;
  for (size_t i = 0; i < pieces->count; i++)
    count += pieces->items[i].ring.count;
  QnBoxTree vertices;
  g_autofree QnBox *boxes = g_new (QnBox, count);
  net->nodes = g_new (Node, count);
  net->corners = g_new (QnId, count);
  net->ends = g_new (guint, pieces->count);
  QnBox all = QN_BOX_EMPTY;
  for (size_t i = 0; i < pieces->count; i++)
    for (size_t k = 0; k < pieces->items[i].ring.count; k++, at++) {
      QnVec2 p = pieces->items[i].ring.points[k];
      boxes[at] = (QnBox){ p, p };
      all = qn_box_union (all, boxes[at]);
      net->corners[at] = QN_NONE;
    }
  net->tolerance = ROUNDING * qn_box_size (all);
  qn_tree_of (&vertices, boxes, count, &net->pool);
  for (size_t v = 0; v < count; v++) {
    if (net->corners[v] != QN_NONE)
      continue;
    QnBoxQuery query =
      qn_box_tree_query (&vertices, qn_box_grow (boxes[v], net->tolerance));
    for (QnId near = qn_box_query_next (&query); near != QN_NONE;
         near = qn_box_query_next (&query))
      if (net->corners[near] == QN_NONE)
        net->corners[near] = (QnId) net->node_count;
    net->nodes[net->node_count++] = (Node){ .at = boxes[v].min, .clearance = INFINITY };
  }
  for (size_t n = 0; n < net->node_count; n++)
    boxes[n] = (QnBox){ net->nodes[n].at, net->nodes[n].at };
  qn_tree_of (&net->tree, boxes, net->node_count, &net->pool);
}

/* Puts the start of a side and the nodes in its middle into the cycle, in their order; a side that
 * has such nodes stays straight. */
static void
add_side (Net *net, QnId from, QnId to)
{
  QnVec2 p = net->nodes[from].at, q = net->nodes[to].at;
  double length = qn_vec2_length (qn_vec2_sub (q, p));
  QnVec2 direction = qn_vec2_scale (1 / length, qn_vec2_sub (q, p));
  guint first = net->cycle->len;
  QnBoxQuery query = qn_box_tree_query (
    &net->tree, qn_box_grow (qn_box_of_segment (p, q), net->tolerance));
  g_array_append_val (net->cycle, from);
  for (QnId near = qn_box_query_next (&query); near != QN_NONE;
       near = qn_box_query_next (&query)) {
    double along = qn_vec2_dot (qn_vec2_sub (net->nodes[near].at, p), direction);
    if (near == from || near == to || along <= 0 || along >= length
        || qn_segment_distance (p, q, net->nodes[near].at) > net->tolerance)
      continue;
    g_array_append_val (net->cycle, near);
    QnId *cycle = cycle_of (net);
    for (guint i = net->cycle->len - 1; i > first + 1; i--) {
      QnId before = cycle[i - 1];
      if (qn_vec2_dot (qn_vec2_sub (net->nodes[before].at, p), direction) <= along)
        break;
      cycle[i] = before;
      cycle[i - 1] = near;
    }
  }
  if (net->cycle->len == first + 1)
    return;
  for (guint i = first; i < net->cycle->len; i++)
    hold (&net->nodes[cycle_of (net)[i]], direction);
  hold (&net->nodes[to], direction);
}

/* How far the nodes around a piece are from its other sides. */
static void
measure_clearance (Net *net, guint first, guint end)
{
  const QnId *cycle = cycle_of (net);
  guint count = end - first;
  for (guint i = 0; i < count; i++) {
    Node *node = &net->nodes[cycle[first + i]];
    for (guint k = 0; k < count; k++) {
      QnId a = cycle[first + k], b = cycle[first + (k + 1) % count];
      QnVec2 p = net->nodes[a].at, q = net->nodes[b].at;
      bool own = k == i || (k + 1) % count == i;
      double distance =
        own ? qn_vec2_length (qn_vec2_sub (q, p)) : qn_segment_distance (p, q, node->at);
      node->clearance = fmin (node->clearance, distance);
    }
  }
}

static void
walk_around (const QnPieces *pieces, Net *net)
{
  size_t at = 0;
  for (size_t i = 0; i < pieces->count; i++) {
    size_t count = pieces->items[i].ring.count;
    guint first = net->cycle->len;
    for (size_t k = 0; k < count; k++) {
      net->nodes[net->corners[at + k]].pieces++;
      add_side (net, net->corners[at + k], net->corners[at + (k + 1) % count]);
    }
    at += count;
    net->ends[i] = net->cycle->len;
    measure_clearance (net, first, net->cycle->len);
    for (guint k = first; pieces->items[i].fixed && k < net->cycle->len; k++)
      net->nodes[cycle_of (net)[k]].freedom = FIXED;
  }
}

static int
compare_parts (const void *a, const void *b)
{
  const Part *x = a, *y = b;
  if (x->a != y->a)
    return x->a < y->a ? -1 : 1;
  return (x->b > y->b) - (x->b < y->b);
}

static void
meet_outline (Node *node, QnVec2 direction)
{
  if (node->outline.x == 0 && node->outline.y == 0)
    node->outline = direction;
  else if (fabs (qn_vec2_cross (node->outline, direction)) > DIRECTION)
    node->outline_turns = true;
}

/* Parts of sides that belong to one piece alone make the outline. */
static void
find_outline (const QnPieces *pieces, Net *net)
{
  const QnId *cycle = cycle_of (net);
  size_t count = 0;
  guint first = 0;
  g_autofree Part *parts = g_new (Part, net->cycle->len);
  for (size_t i = 0; i < pieces->count; first = net->ends[i++])
    for (guint k = first; k < net->ends[i]; k++) {
      QnId a = cycle[k], b = cycle[k + 1 < net->ends[i] ? k + 1 : first];
      parts[count++] = a < b ? (Part){ a, b } : (Part){ b, a };
    }
  qsort (parts, count, sizeof *parts, compare_parts);
  for (size_t i = 0, end; i < count; i = end) {
    for (end = i + 1; end < count && compare_parts (&parts[i], &parts[end]) == 0;)
      end++;
    if (end > i + 1)
      continue;
    QnVec2 way = qn_vec2_sub (net->nodes[parts[i].b].at, net->nodes[parts[i].a].at);
    QnVec2 direction = qn_vec2_scale (1 / qn_vec2_length (way), way);
    meet_outline (&net->nodes[parts[i].a], direction);
    meet_outline (&net->nodes[parts[i].b], direction);
  }
  for (size_t n = 0; n < net->node_count; n++) {
    Node *node = &net->nodes[n];
    bool outside = node->outline.x != 0 || node->outline.y != 0;
    if (outside && !node->outline_turns)
      hold (node, node->outline);
    else if (outside && node->pieces == 1)
      node->freedom = FIXED;
  }
}

/* splitmix64 (Steele, Lea & Flood, "Fast splittable pseudorandom number generators", 2014). */
double
qn_noise (uint32_t seed, uint32_t a, uint32_t b, uint32_t direction)
{
  uint64_t z =
    ((uint64_t) seed << 32) ^ ((uint64_t) a << 17) ^ ((uint64_t) b << 1) ^ direction;
  for (int i = 0; i < 2; i++) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return (double) (z >> 11) * 0x1p-52 - 1;
}

static QnVec2
new_place (const Node *node, double size, uint32_t seed, uint32_t number)
{
  double reach = size * node->clearance;
  QnVec2 way = { qn_noise (seed, number, 0, 0), qn_noise (seed, number, 0, 1) };
  if (node->freedom == FIXED)
    return node->at;
  if (node->freedom == ON_LINE)
    return qn_vec2_add_scaled (node->at, reach * way.x, node->line);
  return qn_vec2_add_scaled (node->at, reach * sqrt (0.5),
                             way); /* no longer than reach */
}

void
qn_pieces_perturb (double size, uint32_t seed, QnPieces *pieces)
{
  Net net = { .cycle = g_array_new (FALSE, FALSE, sizeof (QnId)) };
  find_nodes (pieces, &net);
  walk_around (pieces, &net);
  find_outline (pieces, &net);
  for (size_t i = 0, at = 0; i < pieces->count; i++)
    for (size_t k = 0; k < pieces->items[i].ring.count; k++, at++) {
      QnId n = net.corners[at];
      /* What stays keeps every digit. */
      if (net.nodes[n].freedom != FIXED)
        pieces->items[i].ring.points[k] =
          new_place (&net.nodes[n], size, seed, (uint32_t) n);
    }
  g_array_unref (net.cycle);
  g_free (net.nodes);
  g_free (net.corners);
  g_free (net.ends);
  qn_pool_clear (&net.pool);
}
