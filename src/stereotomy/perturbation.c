#include "stereotomy/perturbation.h"

#include "core/base/box-tree.h"
#include "core/base/memory.h"
#include "core/base/polygon.h"
#include "stereotomy/noise.h"

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
  QnPool pool; /* of all but the cycle */
  Node *nodes;
  size_t node_count;
  QnId *corners; /* node of every vertex of every piece */
  QnId *cycle;   /* nodes around the pieces, those in the middle of sides included */
  size_t cycle_count, cycle_capacity;
  size_t *ends; /* of every piece in the cycle */
  Part *parts;  /* of all sides */
  double tolerance;
  QnBoxTree tree; /* of the nodes */
} Net;

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
static bool
find_nodes (const QnPieces *pieces, Net *net)
{
  size_t count = 0, at = 0;
  for (size_t i = 0; i < pieces->count; i++)
    count += pieces->items[i].ring.count;
  QnBoxTree vertices;
  QnBox *boxes = qn_pool_alloc (&net->pool, count, sizeof *boxes);
  net->nodes = qn_pool_alloc (&net->pool, count, sizeof *net->nodes);
  net->corners = qn_pool_alloc (&net->pool, count, sizeof *net->corners);
  net->ends = qn_pool_alloc (&net->pool, pieces->count, sizeof *net->ends);
  if (net->pool.failed)
    return false;
  QnBox all = QN_BOX_EMPTY;
  for (size_t i = 0; i < pieces->count; i++)
    for (size_t k = 0; k < pieces->items[i].ring.count; k++, at++) {
      QnVec2 p = pieces->items[i].ring.points[k];
      boxes[at] = (QnBox){ p, p };
      all = qn_box_union (all, boxes[at]);
      net->corners[at] = QN_NONE;
    }
  net->tolerance = ROUNDING * qn_box_size (all);
  qn_box_tree_init (&vertices, boxes, count, &net->pool);
  for (size_t v = 0; !net->pool.failed && v < count; v++) {
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
  qn_box_tree_init (&net->tree, boxes, net->node_count, &net->pool);
  return !net->pool.failed;
}

static bool
append (Net *net, QnId node)
{
  return QN_ARRAY_PUSH (net->cycle, net->cycle_count, net->cycle_capacity, node);
}

/* Puts the start of a side and the nodes in its middle into the cycle, in their order; a side that
 * has such nodes stays straight. */
static bool
add_side (Net *net, QnId from, QnId to)
{
  QnVec2 p = net->nodes[from].at, q = net->nodes[to].at;
  double length = qn_vec2_length (qn_vec2_sub (q, p));
  QnVec2 direction = qn_vec2_scale (1 / length, qn_vec2_sub (q, p));
  size_t first = net->cycle_count;
  QnBoxQuery query = qn_box_tree_query (
    &net->tree, qn_box_grow (qn_box_of_segment (p, q), net->tolerance));
  if (!append (net, from))
    return false;
  for (QnId near = qn_box_query_next (&query); near != QN_NONE;
       near = qn_box_query_next (&query)) {
    double along = qn_vec2_dot (qn_vec2_sub (net->nodes[near].at, p), direction);
    if (near == from || near == to || along <= 0 || along >= length
        || qn_segment_distance (p, q, net->nodes[near].at) > net->tolerance)
      continue;
    if (!append (net, near))
      return false;
    for (size_t i = net->cycle_count - 1; i > first + 1; i--) {
      QnId before = net->cycle[i - 1];
      if (qn_vec2_dot (qn_vec2_sub (net->nodes[before].at, p), direction) <= along)
        break;
      net->cycle[i] = before;
      net->cycle[i - 1] = near;
    }
  }
  if (net->cycle_count == first + 1)
    return true;
  for (size_t i = first; i < net->cycle_count; i++)
    hold (&net->nodes[net->cycle[i]], direction);
  hold (&net->nodes[to], direction);
  return true;
}

/* How far the nodes around a piece are from its other sides. */
static void
measure_clearance (Net *net, size_t first, size_t end)
{
  size_t count = end - first;
  for (size_t i = 0; i < count; i++) {
    Node *node = &net->nodes[net->cycle[first + i]];
    for (size_t k = 0; k < count; k++) {
      QnId a = net->cycle[first + k], b = net->cycle[first + (k + 1) % count];
      QnVec2 p = net->nodes[a].at, q = net->nodes[b].at;
      bool own = k == i || (k + 1) % count == i;
      double distance =
        own ? qn_vec2_length (qn_vec2_sub (q, p)) : qn_segment_distance (p, q, node->at);
      node->clearance = fmin (node->clearance, distance);
    }
  }
}

static bool
walk_around (const QnPieces *pieces, Net *net)
{
  size_t at = 0;
  for (size_t i = 0; i < pieces->count; i++) {
    size_t count = pieces->items[i].ring.count, first = net->cycle_count;
    for (size_t k = 0; k < count; k++) {
      net->nodes[net->corners[at + k]].pieces++;
      if (!add_side (net, net->corners[at + k], net->corners[at + (k + 1) % count]))
        return false;
    }
    at += count;
    net->ends[i] = net->cycle_count;
    measure_clearance (net, first, net->cycle_count);
    for (size_t k = first; pieces->items[i].fixed && k < net->cycle_count; k++)
      net->nodes[net->cycle[k]].freedom = FIXED;
  }
  return true;
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
static bool
find_outline (const QnPieces *pieces, Net *net)
{
  size_t count = 0, first = 0;
  Part *parts = net->parts = qn_pool_alloc (&net->pool, net->cycle_count, sizeof *parts);
  if (parts == NULL)
    return false;
  for (size_t i = 0; i < pieces->count; first = net->ends[i++])
    for (size_t k = first; k < net->ends[i]; k++) {
      QnId a = net->cycle[k], b = net->cycle[k + 1 < net->ends[i] ? k + 1 : first];
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
  return true;
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

QnStatus
qn_pieces_perturb (double size, uint32_t seed, QnPieces *pieces, QnDiag *diag)
{
  Net net = { 0 };
  bool done = find_nodes (pieces, &net) && walk_around (pieces, &net)
              && find_outline (pieces, &net);
  for (size_t i = 0, at = 0; done && i < pieces->count; i++)
    for (size_t k = 0; k < pieces->items[i].ring.count; k++, at++) {
      QnId n = net.corners[at];
      /* What stays keeps every digit. */
      if (net.nodes[n].freedom != FIXED)
        pieces->items[i].ring.points[k] =
          new_place (&net.nodes[n], size, seed, (uint32_t) n);
    }
  free (net.cycle);
  qn_pool_clear (&net.pool);
  return done ? QN_OK : qn_diag_no_memory (diag);
}
