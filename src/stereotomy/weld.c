#include "stereotomy/weld.h"

#include "core/base/polygon.h"

#include <stdlib.h>

/* Misses below this part of the tolerance are left alone: rounding, not gaps. */
#define NEGLIGIBLE 1e-6

/* A place where vertices lie, with how many. */
typedef struct Place {
  QnVec2 at;
  size_t first; /* the vertex named first */
  size_t count;
  int rank;      /* 2: corner of the frame, 1: on its boundary, 0: elsewhere */
  size_t target; /* place that it is welded to */
} Place;

void
qn_healing_note (QnHealing *healing, QnVec2 from, QnVec2 to)
{
  if (healing == NULL)
    return;
  double way = qn_vec2_length (qn_vec2_sub (to, from));
  healing->count++;
  if (way > healing->farthest) {
    healing->farthest = way;
    healing->at = from;
  }
}

static int
compare_places (const void *left, const void *right)
{
  const Place *a = left, *b = right;
  if (a->at.x != b->at.x)
    return a->at.x < b->at.x ? -1 : 1;
  if (a->at.y != b->at.y)
    return a->at.y < b->at.y ? -1 : 1;
  return a->first < b->first ? -1 : a->first > b->first;
}

static int
compare_claims (const void *left, const void *right)
{
  const Place *a = *(Place *const *) left, *b = *(Place *const *) right;
  if (a->rank != b->rank)
    return a->rank > b->rank ? -1 : 1;
  if (a->count != b->count)
    return a->count > b->count ? -1 : 1;
  return a->first < b->first ? -1 : 1;
}

static double
distance_to_segment (QnVec2 p, QnVec2 a, QnVec2 b, QnVec2 *foot)
{
  *foot = qn_segment_nearest (a, b, p);
  return qn_vec2_length (qn_vec2_sub (p, *foot));
}

static int
rank_of (QnVec2 p, const QnRing *frame, double tolerance)
{
  int rank = 0;
  for (size_t i = 0; frame != NULL && i < frame->count; i++) {
    QnVec2 a = frame->points[i], b = frame->points[(i + 1) % frame->count], foot;
    if (qn_vec2_length (qn_vec2_sub (p, a)) <= tolerance)
      return 2;
    if (distance_to_segment (p, a, b, &foot) <= tolerance)
      rank = 1;
  }
  return rank;
}

/* The distinct places of all vertices, sorted by coordinates, and which one each vertex has. Returns their
 * number. */
static size_t
collect_places (const QnRings *rings, Place *places, size_t *place_of)
{
  size_t n = 0;
  for (size_t i = 0; i < rings->count; i++)
    for (size_t k = 0; k < rings->items[i].count; k++, n++)
      places[n] = (Place){ .at = rings->items[i].points[k], .first = n, .count = 1 };
  qsort (places, n, sizeof *places, compare_places);
  size_t distinct = 0;
  for (size_t i = 0; i < n; i++) {
    const size_t vertex = places[i].first;
    if (distinct > 0 && places[distinct - 1].at.x == places[i].at.x
        && places[distinct - 1].at.y == places[i].at.y)
      places[distinct - 1].count++;
    else
      places[distinct++] = places[i];
    place_of[vertex] = distinct - 1;
  }
  return distinct;
}

/* Every place, strongest claim first, takes the untaken ones around it. */
static void
choose_targets (Place *places, size_t count, double tolerance)
{
  g_auto (QnPool) room = { 0 };
  g_autofree Place **order = g_new (Place *, count);
  g_autofree QnBox *boxes = g_new (QnBox, count);
  QnBoxTree tree;
  for (size_t i = 0; i < count; i++) {
    order[i] = &places[i];
    places[i].target = SIZE_MAX;
    boxes[i] = (QnBox){ places[i].at, places[i].at };
  }
  qn_tree_of (&tree, boxes, count, &room);
  qsort (order, count, sizeof (Place *), compare_claims);
  for (size_t i = 0; i < count; i++) {
    if (order[i]->target != SIZE_MAX)
      continue;
    QnBox around = qn_box_grow ((QnBox){ order[i]->at, order[i]->at }, tolerance);
    QnBoxQuery query = qn_box_tree_query (&tree, around);
    for (QnId k; (k = qn_box_query_next (&query)) != QN_NONE;)
      if (places[k].target == SIZE_MAX
          && qn_vec2_length (qn_vec2_sub (places[k].at, order[i]->at)) <= tolerance)
        places[k].target = (size_t) (order[i] - places);
  }
}

void
qn_weld_vertices (QnRings *rings, double least, double tolerance, const QnRing *frame,
                  QnHealing *healing)
{
  size_t total = 0, n = 0;
  for (size_t i = 0; i < rings->count; i++)
    total += rings->items[i].count;
  if (total == 0)
    return;
  g_autofree Place *places = g_new (Place, total);
  g_autofree size_t *place_of = g_new (size_t, total);
  size_t count = collect_places (rings, places, place_of);
  for (size_t i = 0; i < count; i++)
    places[i].rank = rank_of (places[i].at, frame, NEGLIGIBLE * tolerance);
  choose_targets (places, count, tolerance);
  for (size_t i = 0; i < rings->count; i++) {
    QnRing *ring = &rings->items[i];
    bool moved = false;
    for (size_t k = 0; k < ring->count; k++) {
      QnVec2 to = places[places[place_of[n++]].target].at;
      double way = qn_vec2_length (qn_vec2_sub (to, ring->points[k]));
      if (way > least) {
        if (way > NEGLIGIBLE * tolerance)
          qn_healing_note (healing, ring->points[k], to);
        ring->points[k] = to;
        moved = true;
      }
    }
    if (moved && ring->count > 2)
      qn_ring_simplify (ring, NEGLIGIBLE * tolerance);
  }
}

/* Notes by 1 + index the rings that come near to a side of ring `index`. */
static void
find_near (const QnRing *ring, size_t index, const QnBoxTree *tree,
           const QnRingSide *sides, size_t *near)
{
  for (size_t k = 0; k < ring->count; k++) {
    QnBox side = qn_box_of_segment (ring->points[k], ring->points[(k + 1) % ring->count]);
    QnBoxQuery query = qn_box_tree_query (tree, side);
    for (QnId i; (i = qn_box_query_next (&query)) != QN_NONE;)
      near[sides[i].ring] = index + 1;
  }
}

/* Whether `p` may be within the tolerance of a segment: much less work than the distance. */
static bool
may_be_near (QnVec2 p, QnVec2 a, QnVec2 b, double tolerance)
{
  return qn_box_meets (qn_box_grow (qn_box_of_segment (a, b), 2 * tolerance),
                       (QnBox){ p, p });
}

/* A place near to a point. */
typedef struct Foot {
  QnVec2 at;
  double distance; /* INFINITY: none is within the tolerance */
} Foot;

static void
take_nearer (QnVec2 at, double distance, double tolerance, Foot *foot)
{
  if (distance <= tolerance && distance < foot->distance)
    *foot = (Foot){ at, distance };
}

/* Moves the vertices of ring `index` onto the rings before it: to vertices before edges. */
static void
fit_vertices (QnRings *rings, size_t index, const QnBoxTree *tree, const size_t *near,
              double tolerance, QnHealing *healing)
{
  QnRing *ring = &rings->items[index];
  for (size_t k = 0; k < ring->count; k++) {
    QnVec2 p = ring->points[k];
    Foot vertex = { p, INFINITY }, edge = vertex;
    QnBoxQuery query = qn_box_tree_query (tree, (QnBox){ p, p });
    for (QnId i; (i = qn_box_query_next (&query)) != QN_NONE;) {
      const QnRing *other = &rings->items[i];
      for (size_t m = 0; (size_t) i < index && near[i] == index + 1 && m < other->count;
           m++) {
        QnVec2 a = other->points[m], b = other->points[(m + 1) % other->count], foot;
        if (!may_be_near (p, a, b, tolerance))
          continue;
        take_nearer (a, qn_vec2_length (qn_vec2_sub (p, a)), tolerance, &vertex);
        double way = distance_to_segment (p, a, b, &foot);
        take_nearer (foot, way, tolerance, &edge);
      }
    }
    const Foot *to = isfinite (vertex.distance) ? &vertex : &edge;
    if (isfinite (to->distance) && to->distance > NEGLIGIBLE * tolerance) {
      ring->points[k] = to->at;
      qn_healing_note (healing, p, to->at);
    }
  }
}

static void
insert_vertex (QnRing *ring, size_t after, QnVec2 p)
{
  ring->points = g_renew (QnVec2, ring->points, ring->count + 1);
  for (size_t i = ring->count; i > after + 1; i--)
    ring->points[i] = ring->points[i - 1];
  ring->points[after + 1] = p;
  ring->count++;
}

/* Lets the edges of ring `index` run through the vertices of earlier rings beside them. */
static void
fit_edges (QnRings *rings, size_t index, const QnBoxTree *tree, const size_t *near,
           double tolerance, QnHealing *healing)
{
  QnRing *ring = &rings->items[index];
  QnBox bounds = qn_ring_bounds (ring);
  QnBoxQuery query = qn_box_tree_query (tree, bounds);
  for (QnId i; (i = qn_box_query_next (&query)) != QN_NONE;) {
    if ((size_t) i >= index || near[i] != index + 1)
      continue;
    const QnRing *other = &rings->items[i];
    for (size_t v = 0; v < other->count; v++) {
      QnVec2 p = other->points[v], foot;
      for (size_t k = 0; k < ring->count; k++) {
        QnVec2 a = ring->points[k], b = ring->points[(k + 1) % ring->count];
        if (!may_be_near (p, a, b, tolerance))
          continue;
        double way = distance_to_segment (p, a, b, &foot);
        if (way > tolerance || way <= NEGLIGIBLE * tolerance
            || qn_vec2_length (qn_vec2_sub (p, a)) <= tolerance
            || qn_vec2_length (qn_vec2_sub (p, b)) <= tolerance)
          continue;
        insert_vertex (ring, k, p);
        qn_healing_note (healing, foot, p);
        break;
      }
    }
  }
}

void
qn_snap_neighbours (QnRings *rings, double tolerance, QnHealing *healing)
{
  g_auto (QnPool) room = { 0 };
  QnBoxTree tree, side_tree;
  QnHealing own = { 0 };
  QnHealing *told = healing != NULL ? healing : &own;
  g_autofree size_t *near = g_new0 (size_t, rings->count); /* see find_near() */
  /* Rings, and sides of both, move by up to the tolerance while others look for them. */
  QnRingSide *sides = qn_rings_side_tree (rings, 4 * tolerance, &side_tree, &room);
  qn_rings_tree (rings, 2 * tolerance, &tree, &room);
  for (size_t i = 0; i < rings->count; i++) {
    const size_t before = told->count;
    find_near (&rings->items[i], i, &side_tree, sides, near);
    fit_vertices (rings, i, &tree, near, tolerance, told);
    fit_edges (rings, i, &tree, near, tolerance, told);
    if (told->count > before)
      qn_ring_simplify (&rings->items[i], NEGLIGIBLE * tolerance);
  }
}

/* Length over which the edges ab and cd lie on each other in opposite directions. */
static double
edge_overlap (QnVec2 a, QnVec2 b, QnVec2 c, QnVec2 d, double tolerance)
{
  QnVec2 along = qn_vec2_sub (b, a);
  double length = qn_vec2_length (along);
  if (length == 0)
    return 0;
  along = qn_vec2_scale (1 / length, along);
  QnVec2 ac = qn_vec2_sub (c, a), ad = qn_vec2_sub (d, a);
  if (fabs (qn_vec2_cross (along, ac)) > tolerance
      || fabs (qn_vec2_cross (along, ad)) > tolerance)
    return 0;
  double begin = fmax (0, qn_vec2_dot (along, ad));
  double end = fmin (length, qn_vec2_dot (along, ac));
  return fmax (0, end - begin);
}

double
qn_joint_length (const QnRing *a, const QnRing *b, double tolerance)
{
  if (!qn_box_meets_within (qn_ring_bounds (a), qn_ring_bounds (b), tolerance))
    return 0;
  double sum = 0;
  for (size_t i = 0; i < a->count; i++)
    for (size_t k = 0; k < b->count; k++)
      sum += edge_overlap (a->points[i], a->points[(i + 1) % a->count], b->points[k],
                           b->points[(k + 1) % b->count], tolerance);
  return sum > tolerance ? sum : 0;
}

void
qn_drop_collapsed (QnRings *rings)
{
  size_t kept = 0;
  for (size_t i = 0; i < rings->count; i++) {
    if (rings->items[i].count >= 3)
      rings->items[kept++] = rings->items[i];
    else
      qn_ring_clear (&rings->items[i]);
  }
  rings->count = kept;
}
