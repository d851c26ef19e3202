#include "stereotomy/gaps.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/base/polygon.h"

#include <stdlib.h>

/* The usual width at most, m. */
#define USUAL_MOST 0.04

typedef struct Search {
  const QnRings *rings;
  double least, most; /* m */
  double parallel;    /* cosine of the angle that still counts as parallel */
  QnBoxTree rings_tree;
} Search;

static void
ends_of (const QnRings *rings, QnRingSide side, QnVec2 *from, QnVec2 *to)
{
  const QnRing *ring = &rings->items[side.ring];
  *from = ring->points[side.edge];
  *to = ring->points[(side.edge + 1) % ring->count];
}

/* The point of a segment whose projection on `along` is `s`. */
static QnVec2
point_along (QnVec2 from, QnVec2 to, QnVec2 along, double s)
{
  double a = qn_vec2_dot (from, along), b = qn_vec2_dot (to, along);
  return qn_vec2_lerp (from, to, (s - a) / (b - a));
}

/* Whether two sides face each other across a gap of this width; fills in all but `rings`. */
static bool
face_each_other (const Search *search, QnRingSide one, QnRingSide two, QnGap *gap)
{
  QnVec2 p, q, u, v;
  ends_of (search->rings, one, &p, &q);
  ends_of (search->rings, two, &u, &v);
  QnVec2 first = qn_vec2_sub (q, p), second = qn_vec2_sub (u, v);
  double lengths = qn_vec2_length (first) * qn_vec2_length (second);
  if (!(lengths > 0) || qn_vec2_dot (first, second) < search->parallel * lengths)
    return false;
  QnVec2 along = qn_vec2_add (qn_vec2_scale (1 / qn_vec2_length (first), first),
                              qn_vec2_scale (1 / qn_vec2_length (second), second));
  along = qn_vec2_scale (1 / qn_vec2_length (along), along);
  QnVec2 outward = qn_vec2 (along.y, -along.x);
  double from = fmax (qn_vec2_dot (p, along), qn_vec2_dot (v, along));
  double to = fmin (qn_vec2_dot (q, along), qn_vec2_dot (u, along));
  if (!(to > from))
    return false;
  double widths[2];
  for (int end = 0; end < 2; end++) {
    double s = end == 0 ? from : to;
    gap->sides[0][end] = point_along (p, q, along, s);
    gap->sides[1][end] = point_along (v, u, along, s);
    widths[end] =
      qn_vec2_dot (qn_vec2_sub (gap->sides[1][end], gap->sides[0][end]), outward);
    if (widths[end] > search->most || widths[end] < fmin (search->least, 0))
      return false;
  }
  gap->width = 0.5 * (widths[0] + widths[1]);
  return gap->width > search->least && to - from > fmax (widths[0], widths[1]);
}

/* Whether a third block lies between the sides, in the middle or near an end. */
static bool
is_filled (const Search *search, const QnGap *gap)
{
  const double places[] = { 0.5, 0.1, 0.9 };
  size_t filled = 0;
  for (size_t i = 0; i < QN_N_ELEMENTS (places); i++) {
    QnVec2 at =
      qn_vec2_lerp (qn_vec2_lerp (gap->sides[0][0], gap->sides[0][1], places[i]),
                    qn_vec2_lerp (gap->sides[1][0], gap->sides[1][1], places[i]), 0.5);
    bool inside = false;
    QnBoxQuery query = qn_box_tree_query (&search->rings_tree, (QnBox){ at, at });
    for (QnId k; !inside && (k = qn_box_query_next (&query)) != QN_NONE;) {
      const QnRing *ring = &search->rings->items[k];
      inside = (size_t) k != gap->rings[0] && (size_t) k != gap->rings[1]
               && ring->count >= 3
               && qn_polygon_depth (ring->points, ring->count, at) > 0;
    }
    filled += inside;
  }
  return filled == QN_N_ELEMENTS (places);
}

void
qn_gaps_find (const QnRings *rings, double least, double most, QnGaps *gaps)
{
  g_auto (QnPool) room = { 0 };
  g_auto (QnBoxPairs) pairs = { 0 };
  Search search = { .rings = rings,
                    .least = least,
                    .most = most,
                    .parallel = cos (QN_GAP_ANGLE * acos (-1.0) / 180) };
  QnBoxTree tree;
  *gaps = (QnGaps){ 0 };
  if (rings->count < 2 || !(most > least))
    return;
  qn_rings_tree (rings, 0, &search.rings_tree, &room);
  QnRingSide *sides = qn_rings_side_tree (rings, 0, &tree, &room);
  qn_require_memory (qn_box_tree_pairs (
    &tree, most, QN_MOST_SIDE_PAIRS + QN_PAIRS_PER_SIDE * tree.item_count, &pairs));
  for (size_t i = 0; i < pairs.count; i++) {
    QnRingSide one = sides[pairs.items[i][0]], two = sides[pairs.items[i][1]];
    QnGap gap = { .rings = { one.ring, two.ring }, .edges = { one.edge, two.edge } };
    if (one.ring != two.ring && face_each_other (&search, one, two, &gap)
        && !is_filled (&search, &gap))
      qn_require_memory (QN_ARRAY_PUSH (gaps->items, gaps->count, gaps->capacity, gap));
  }
}

void
qn_gaps_clear (QnGaps *gaps)
{
  free (gaps->items);
  *gaps = (QnGaps){ 0 };
}

void
qn_gaps_widths (const QnGaps *gaps, double *least, double *mean, double *most)
{
  *least = INFINITY;
  *mean = *most = 0;
  for (size_t i = 0; i < gaps->count; i++)
    for (int end = 0; end < 2; end++) {
      const QnGap *gap = &gaps->items[i];
      double width =
        qn_vec2_length (qn_vec2_sub (gap->sides[1][end], gap->sides[0][end]));
      *least = fmin (*least, width);
      *most = fmax (*most, width);
      *mean += width / (2 * (double) gaps->count);
    }
}

void
qn_gaps_fill (const QnGaps *gaps, QnRings *rings)
{
  for (size_t i = 0; i < gaps->count; i++) {
    const QnGap *gap = &gaps->items[i];
    const QnVec2 corners[] = { gap->sides[0][1], gap->sides[0][0], gap->sides[1][0],
                               gap->sides[1][1] };
    QnRing body = qn_ring_of (corners, QN_N_ELEMENTS (corners));
    qn_ring_simplify (&body, 1e-9 * gap->width);
    qn_ring_orient (&body);
    qn_rings_take (rings, &body);
  }
}

double
qn_gaps_usual_width (const QnRings *rings)
{
  size_t count = 0;
  g_autofree double *widths = g_new (double, rings->count);
  for (size_t i = 0; i < rings->count; i++)
    if (rings->items[i].count >= 3)
      widths[count++] =
        qn_ring_area (&rings->items[i]) / qn_ring_perimeter (&rings->items[i]);
  if (count == 0)
    return 0;
  qsort (widths, count, sizeof *widths, qn_compare_doubles);
  return fmin (widths[count / 2], USUAL_MOST);
}
