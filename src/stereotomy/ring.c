#include "stereotomy/ring.h"
#include "core/base/memory.h"
#include "core/base/polygon.h"

#include <stdlib.h>
#include <string.h>

QnRing
qn_ring_of (const QnVec2 *points, size_t count)
{
  return (QnRing){ g_memdup2 (points, count * sizeof *points), count };
}

void
qn_ring_clear (QnRing *ring)
{
  g_free (ring->points);
  *ring = (QnRing){ 0 };
}

double
qn_ring_area (const QnRing *ring)
{
  return ring->count < 3 ? 0 : qn_polygon_properties (ring->points, ring->count).area;
}

QnVec2
qn_ring_centroid (const QnRing *ring)
{
  return qn_polygon_properties (ring->points, ring->count).centroid;
}

double
qn_ring_perimeter (const QnRing *ring)
{
  double sum = 0;
  for (size_t i = 0; i < ring->count; i++)
    sum +=
      qn_vec2_length (qn_vec2_sub (ring->points[(i + 1) % ring->count], ring->points[i]));
  return sum;
}

QnBox
qn_ring_bounds (const QnRing *ring)
{
  return qn_box_of_points (ring->points, ring->count);
}

QnBox
qn_rings_bounds (const QnRings *rings)
{
  QnBox bounds = QN_BOX_EMPTY;
  for (size_t i = 0; i < rings->count; i++)
    qn_box_add_box (&bounds, qn_ring_bounds (&rings->items[i]));
  return bounds;
}

void
qn_ring_orient (QnRing *ring)
{
  if (qn_ring_area (ring) < 0)
    qn_polygon_reverse (ring->points, ring->count);
}

/* Whether `b` says nothing between its neighbours `a` and `c`: a repeated point, a point of
 * the segment ac, or the tip of a spike. */
static bool
is_superfluous (QnVec2 a, QnVec2 b, QnVec2 c, double tolerance)
{
  QnVec2 ab = qn_vec2_sub (b, a), cb = qn_vec2_sub (b, c), ac = qn_vec2_sub (c, a);
  double la = qn_vec2_length (ab), lc = qn_vec2_length (cb), base = qn_vec2_length (ac);
  if (la <= tolerance || lc <= tolerance || base <= tolerance)
    return true;
  /* Height of the triangle over its longest side. */
  return fabs (qn_vec2_cross (ab, ac)) <= tolerance * fmax (base, fmax (la, lc));
}

size_t
qn_ring_simplify (QnRing *ring, double tolerance)
{
  size_t before = ring->count, quiet = 0, i = 0;
  while (ring->count >= 3 && quiet < ring->count) {
    size_t n = ring->count;
    i %= n;
    QnVec2 a = ring->points[(i + n - 1) % n], c = ring->points[(i + 1) % n];
    if (is_superfluous (a, ring->points[i], c, tolerance)) {
      memmove (ring->points + i, ring->points + i + 1,
               (n - 1 - i) * sizeof *ring->points);
      ring->count--;
      quiet = 0;
      i = i > 0 ? i - 1 : ring->count - 1;
    } else {
      quiet++;
      i++;
    }
  }
  return before - ring->count;
}

void
qn_ring_normalize (QnRing *ring)
{
  size_t first = 0;
  for (size_t i = 1; i < ring->count; i++) {
    QnVec2 p = ring->points[i], q = ring->points[first];
    if (p.y < q.y || (p.y == q.y && p.x < q.x))
      first = i;
  }
  if (first == 0)
    return;
  g_autofree QnVec2 *before = g_memdup2 (ring->points, ring->count * sizeof *before);
  for (size_t i = 0; i < ring->count; i++)
    ring->points[i] = before[(first + i) % ring->count];
}

void
qn_rings_add (QnRings *rings, const QnVec2 *points, size_t count)
{
  QnRing ring = qn_ring_of (points, count);
  qn_rings_take (rings, &ring);
}

void
qn_rings_take (QnRings *rings, QnRing *ring)
{
  qn_require_memory (QN_ARRAY_PUSH (rings->items, rings->count, rings->capacity, *ring));
  *ring = (QnRing){ 0 };
}

void
qn_rings_remove (QnRings *rings, size_t index)
{
  QN_ASSERT (index < rings->count);
  qn_ring_clear (&rings->items[index]);
  memmove (rings->items + index, rings->items + index + 1,
           (rings->count - index - 1) * sizeof *rings->items);
  rings->count--;
}

void
qn_rings_clear (QnRings *rings)
{
  for (size_t i = 0; i < rings->count; i++)
    qn_ring_clear (&rings->items[i]);
  free (rings->items);
  *rings = (QnRings){ 0 };
}

double
qn_rings_area (const QnRings *rings)
{
  double area = 0;
  for (size_t i = 0; i < rings->count; i++)
    area += qn_ring_area (&rings->items[i]);
  return area;
}

void
qn_tree_of (QnBoxTree *tree, const QnBox *boxes, size_t count, QnPool *pool)
{
  qn_box_tree_init (tree, boxes, count, pool);
  qn_require_memory (!pool->failed);
}

void
qn_rings_tree (const QnRings *rings, double margin, QnBoxTree *tree, QnPool *pool)
{
  g_autofree QnBox *boxes = g_new0 (QnBox, rings->count);
  for (size_t i = 0; i < rings->count; i++)
    boxes[i] = qn_box_grow (rings->items[i].count > 0 ? qn_ring_bounds (&rings->items[i])
                                                      : (QnBox){ { 0, 0 }, { 0, 0 } },
                            margin);
  qn_tree_of (tree, boxes, rings->count, pool);
}

QnRingSide *
qn_rings_side_tree (const QnRings *rings, double margin, QnBoxTree *tree, QnPool *pool)
{
  size_t count = 0, n = 0;
  for (size_t i = 0; i < rings->count; i++)
    count += rings->items[i].count;
  g_autofree QnBox *boxes = g_new0 (QnBox, count);
  QnRingSide *sides = qn_pool_alloc (pool, count, sizeof *sides);
  qn_require_memory (sides != NULL);
  for (size_t i = 0; i < rings->count; i++)
    for (size_t k = 0; k < rings->items[i].count; k++, n++) {
      const QnRing *ring = &rings->items[i];
      sides[n] = (QnRingSide){ i, k };
      boxes[n] = qn_box_grow (
        qn_box_of_segment (ring->points[k], ring->points[(k + 1) % ring->count]), margin);
    }
  qn_tree_of (tree, boxes, count, pool);
  return sides;
}
