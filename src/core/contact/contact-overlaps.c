/* Blocks that overlap, how deeply and where. */
#include "core/contact/contact-search.h"

#include "core/base/numbers.h"
#include "core/base/polygon.h"

#include <stdlib.h>

static void
add_number (const QnContactSearch *search, QnContactCuts *numbers, double value)
{
  search->room->failed |=
    !QN_ARRAY_PUSH (numbers->items, numbers->count, numbers->capacity, value);
}

/* How far block b reaches behind the sides of the convex block a: the least over these sides of
 * the largest depth, m; at most the tolerance where one of them separates the two. Sides after that one are
 * not looked at. */
static double
reach_behind_sides (const QnContactSearch *search, QnId a, QnId b)
{
  const QnSides *sides = &search->sides;
  double least = INFINITY;
  for (size_t i = sides->first[a];
       i < sides->first[a + 1] && least > search->lengths.tolerance; i++) {
    const QnSide *side = &sides->items[i];
    double deepest = -INFINITY;
    for (size_t j = sides->first[b]; j < sides->first[b + 1]; j++) {
      QnVec2 to = qn_vec2_sub (sides->items[j].start, side->start);
      deepest = qn_max (deepest, qn_vec2_cross (side->direction, to));
    }
    least = qn_min (least, deepest);
  }
  return least;
}

/* Deepest point found so far; of equally deep ones that on the lowest side, in whatever order the
 * sides are visited. */
typedef struct {
  double depth;
  QnVec2 at;
  size_t side;
} Deepest;

/* Whether a point on a side that lies so deep takes the place of the deepest one. */
static bool
is_deeper (double depth, size_t side, const Deepest *deepest)
{
  return depth > deepest->depth || (depth == deepest->depth && side < deepest->side);
}

static bool
is_inside (const QnContactSearch *search, QnId block, QnVec2 point)
{
  bool inside = false;
  QnBox ray =
    qn_box_of_segment (point, qn_vec2 (search->block_boxes[block].max.x, point.y));
  QnSideWalk walk;
  qn_side_walk_start (&walk, search, block, ray);
  const QnSide *side;
  while ((side = qn_side_walk_next (&walk)) != NULL) {
    QnVec2 p = qn_vec2_sub (side->start, point), q = qn_vec2_sub (side->end, point);
    if ((p.y > 0) != (q.y > 0) && (qn_vec2_cross (p, q) > 0) == (q.y > p.y))
      inside = !inside;
  }
  return inside;
}

/* Notes a point of a side of `other` if it lies deeper in `block` than those before. An overlap cannot be
 * deeper than the other block is wide, so the search for the nearest side ends there; it begins with as
 * near ones as would rule the point out. */
static void
try_point (const QnContactSearch *search, QnId block, QnId other, QnVec2 point,
           size_t point_side, Deepest *deepest)
{
  QnBox width = search->block_boxes[other];
  double most = fmin (width.max.x - width.min.x, width.max.y - width.min.y);
  double depth = most,
         reach = fmax (deepest->depth, search->sides.items[point_side].length);
  for (bool more = true; more; reach *= 2) {
    more = reach < most;
    QnSideWalk walk;
    qn_side_walk_start (&walk, search, block,
                        qn_box_grow ((QnBox){ point, point }, qn_min (reach, most)));
    const QnSide *side;
    while ((side = qn_side_walk_next (&walk)) != NULL) {
      depth = qn_min (depth, qn_segment_distance (side->start, side->end, point));
      if (!is_deeper (depth, point_side, deepest))
        return;
    }
    more = more && depth > reach;
  }
  if (is_deeper (depth, point_side, deepest) && is_inside (search, block, point))
    *deepest = (Deepest){ depth, point, point_side };
}

/* Cuts a side of `other` where it meets the boundary of `block` and tries the middle of every
 * piece: a piece lies inside or outside as a whole. */
static void
try_side (const QnContactSearch *search, const QnSide *side, QnId block,
          QnContactCuts *cuts, Deepest *deepest)
{
  cuts->count = 0;
  add_number (search, cuts, 0);
  add_number (search, cuts, side->length);
  QnSideWalk walk;
  qn_side_walk_start (&walk, search, block,
                      qn_box_grow (qn_side_box (side), search->lengths.tolerance));
  const QnSide *cutter;
  while ((cutter = qn_side_walk_next (&walk)) != NULL) {
    QnVec2 p = qn_vec2_sub (cutter->start, side->start);
    QnVec2 q = qn_vec2_sub (cutter->end, side->start);
    double left_p = qn_vec2_cross (side->direction, p);
    double left_q = qn_vec2_cross (side->direction, q);
    double at = NAN;
    if (fabs (left_p) <= search->lengths.tolerance)
      at = qn_vec2_dot (side->direction, p);
    else if ((left_p > 0) != (left_q > 0))
      at = qn_vec2_dot (side->direction, qn_vec2_lerp (p, q, left_p / (left_p - left_q)));
    if (at > 0 && at < side->length)
      add_number (search, cuts, at);
  }
  if (search->room->failed)
    return;

  qsort (cuts->items, cuts->count, sizeof *cuts->items, qn_compare_doubles);
  size_t number = (size_t) (side - search->sides.items);
  for (size_t i = 0; i + 1 < cuts->count; i++) {
    double middle = (cuts->items[i] + cuts->items[i + 1]) / 2;
    try_point (search, block, side->block,
               qn_vec2_add_scaled (side->start, middle, side->direction), number,
               deepest);
  }
  try_point (search, block, side->block, side->start, number, deepest);
}

/* Finds the point on the boundary of a that lies deepest in b. */
static void
try_boundary (const QnContactSearch *search, QnId a, QnId b, QnContactCuts *cuts,
              Deepest *deepest)
{
  QnSideWalk walk;
  qn_side_walk_start (&walk, search, a, search->block_boxes[b]);
  const QnSide *side;
  while ((side = qn_side_walk_next (&walk)) != NULL)
    try_side (search, side, b, cuts, deepest);
}

/* Whether two blocks fill the same box, up to what may pass unnoticed on either. */
static bool
fill_same_box (const QnContactSearch *search, QnId a, QnId b)
{
  QnBox left = search->block_boxes[a], right = search->block_boxes[b];
  double most =
    fmax (fmax (fabs (left.min.x - right.min.x), fabs (left.min.y - right.min.y)),
          fmax (fabs (left.max.x - right.max.x), fabs (left.max.y - right.max.y)));
  return most <= 4 * search->lengths.tolerance;
}

void
qn_contact_check_overlap (const QnContactSearch *search, QnId a, QnId b,
                          QnContactCuts *cuts, QnFindings *findings)
{
  double tolerance = search->lengths.tolerance;
  if (!qn_box_meets (search->block_boxes[b],
                     qn_box_grow (search->block_boxes[a], -tolerance)))
    return;

  bool small =
    qn_side_count (search, a) * qn_side_count (search, b) <= QN_FEW_SIDES * QN_FEW_SIDES;
  double depth = INFINITY;
  if (small && search->convex[a])
    depth = reach_behind_sides (search, a, b);
  if (small && search->convex[b] && depth > search->lengths.tolerance)
    depth = qn_min (depth, reach_behind_sides (search, b, a));
  if (depth <= search->lengths.tolerance)
    return;

  /* Depth and place of the overlap of two blocks of any shape, depth 0 where they do not
   * overlap. If the interiors meet, the boundary of one passes through the other, or they
   * are equal. */
  Deepest deepest = { 0, { 0, 0 }, 0 };
  try_boundary (search, a, b, cuts, &deepest);
  try_boundary (search, b, a, cuts, &deepest);
  if (deepest.depth <= search->lengths.tolerance && fill_same_box (search, a, b)) {
    const QnModel *model = search->model;
    QnVec2 inner = qn_polygon_inner_point (qn_model_block_vertices (model, a),
                                           (size_t) model->blocks[a].vertex_count);
    Deepest own = { 0, inner, 0 }, other = { 0, inner, 0 };
    try_point (search, a, b, inner, 0, &own);
    try_point (search, b, a, inner, 0, &other);
    double within = fmin (own.depth, other.depth);
    if (within > deepest.depth)
      deepest = (Deepest){ within, inner, 0 };
  }
  /* For two convex blocks the separating axes know the depth exactly. */
  if (!small || !search->convex[a] || !search->convex[b])
    depth = deepest.depth;
  if (depth <= search->lengths.tolerance)
    return;
  QnProblem problem = depth > search->lengths.overlap_limit
                        ? QN_PROBLEM_BLOCKS_OVERLAP
                        : QN_PROBLEM_NEAR_MISS_OVERLAP;
  search->room->failed |=
    !QN_ARRAY_PUSH (findings->items, findings->count, findings->capacity,
                    (QnFinding){ problem, a, b, deepest.at, depth, QN_NONE, NULL });
}
