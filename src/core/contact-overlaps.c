/* Blocks that overlap, how deeply and where. */
#include "core/contact-search.h"
#include "core/memory.h"
#include "core/polygon.h"

#include <stdlib.h>

/* Blocks with more sides than this are searched through the tree. */
#define FEW_SIDES 32

typedef struct {
  double *items;
  size_t count, capacity;
} Numbers;

static bool
add_number (Numbers *numbers, double value)
{
  double *items =
    qn_array_grow (numbers->items, &numbers->capacity, numbers->count + 1, sizeof *items);
  if (items == NULL)
    return false;
  numbers->items = items;
  items[numbers->count++] = value;
  return true;
}

static int
compare_numbers (const void *a, const void *b)
{
  double left = *(const double *) a, right = *(const double *) b;
  return (left > right) - (left < right);
}

/* The sides of one block that meet a box. Blocks of few sides are looked through; the others,
 * a ground of thousands of vertices, are asked through the tree. */
typedef struct {
  const QnContactSearch *search;
  QnId block;
  QnBox box;
  size_t next, end;
  bool by_tree;
  QnBoxQuery query;
} SideWalk;

static size_t
side_count (const QnContactSearch *search, QnId block)
{
  return search->sides.first[block + 1] - search->sides.first[block];
}

static SideWalk
walk_sides (const QnContactSearch *search, QnId block, QnBox box)
{
  SideWalk walk = { .search = search, .block = block, .box = box };
  walk.by_tree = side_count (search, block) > FEW_SIDES;
  walk.next = search->sides.first[block];
  walk.end = search->sides.first[block + 1];
  if (walk.by_tree)
    walk.query = qn_box_tree_query (&search->side_tree, box);
  return walk;
}

static const QnSide *
next_side (SideWalk *walk)
{
  const QnContactSearch *search = walk->search;
  QnId side;
  while (walk->by_tree && (side = qn_box_query_next (&walk->query)) != QN_NONE) {
    if (search->sides.items[side].block == walk->block)
      return &search->sides.items[side];
  }
  while (!walk->by_tree && walk->next < walk->end) {
    size_t i = walk->next++;
    if (qn_box_meets (search->side_boxes[i], walk->box))
      return &search->sides.items[i];
  }
  return NULL;
}

/* How far block b reaches behind the sides of the convex block a: the least over these sides of
 * the largest depth, m; negative or zero where one of them separates the two. Sides after one
 * that separates by more than `enough` are not looked at. */
static double
reach_behind_sides (const QnContactSearch *search, QnId a, QnId b, double enough)
{
  const QnSides *sides = &search->sides;
  double least = INFINITY;
  for (size_t i = sides->first[a]; i < sides->first[a + 1] && least > enough; i++) {
    const QnSide *side = &sides->items[i];
    double deepest = -INFINITY;
    for (size_t j = sides->first[b]; j < sides->first[b + 1]; j++) {
      QnVec2 to = qn_vec2_sub (sides->items[j].start, side->start);
      deepest = fmax (deepest, qn_vec2_cross (side->direction, to));
    }
    least = fmin (least, deepest);
  }
  return least;
}

/* Deepest point found so far. */
typedef struct {
  double depth;
  QnVec2 at;
} Deepest;

static bool
is_inside (const QnContactSearch *search, QnId block, QnVec2 point)
{
  bool inside = false;
  QnBox ray =
    qn_box_of_segment (point, qn_vec2 (search->block_boxes[block].max.x, point.y));
  SideWalk walk = walk_sides (search, block, ray);
  const QnSide *side;
  while ((side = next_side (&walk)) != NULL) {
    QnVec2 p = qn_vec2_sub (side->start, point), q = qn_vec2_sub (side->end, point);
    if ((p.y > 0) != (q.y > 0) && (qn_vec2_cross (p, q) > 0) == (q.y > p.y))
      inside = !inside;
  }
  return inside;
}

/* Notes a point of `other` if it lies deeper in `block` than those before. An overlap cannot be
 * deeper than the other block is wide, so the search for the nearest side ends there. */
static void
try_point (const QnContactSearch *search, QnId block, QnId other, QnVec2 point,
           Deepest *deepest)
{
  QnBox width = search->block_boxes[other];
  double depth = fmin (width.max.x - width.min.x, width.max.y - width.min.y);
  SideWalk walk =
    walk_sides (search, block, qn_box_grow ((QnBox){ point, point }, depth));
  const QnSide *side;
  while ((side = next_side (&walk)) != NULL && depth > deepest->depth)
    depth = fmin (depth, qn_segment_distance (side->start, side->end, point));
  if (depth > deepest->depth && is_inside (search, block, point))
    *deepest = (Deepest){ depth, point };
}

/* Cuts a side of `other` where it meets the boundary of `block` and tries the middle of every
 * piece: a piece lies inside or outside as a whole. */
static bool
try_side (const QnContactSearch *search, const QnSide *side, QnId block, Numbers *cuts,
          Deepest *deepest)
{
  cuts->count = 0;
  bool done = add_number (cuts, 0) && add_number (cuts, side->length);
  QnBox box =
    qn_box_grow (qn_box_of_segment (side->start, side->end), search->lengths.tolerance);
  SideWalk walk = walk_sides (search, block, box);
  const QnSide *cutter;
  while (done && (cutter = next_side (&walk)) != NULL) {
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
      done = add_number (cuts, at);
  }
  if (!done)
    return false;

  qsort (cuts->items, cuts->count, sizeof *cuts->items, compare_numbers);
  for (size_t i = 0; i + 1 < cuts->count; i++) {
    double middle = (cuts->items[i] + cuts->items[i + 1]) / 2;
    try_point (search, block, side->block,
               qn_vec2_add_scaled (side->start, middle, side->direction), deepest);
  }
  try_point (search, block, side->block, side->start, deepest);
  return true;
}

/* Looks for the point on the boundary of a that lies deepest in b. */
static bool
try_boundary (const QnContactSearch *search, QnId a, QnId b, Numbers *cuts,
              Deepest *deepest)
{
  SideWalk walk = walk_sides (search, a, search->block_boxes[b]);
  const QnSide *side;
  while ((side = next_side (&walk)) != NULL) {
    if (!try_side (search, side, b, cuts, deepest))
      return false;
  }
  return true;
}

static void
try_inner_point (const QnContactSearch *search, QnId a, QnId b, Deepest *deepest)
{
  const QnModel *model = search->model;
  QnVec2 inner = qn_polygon_inner_point (qn_model_block_vertices (model, a),
                                         (size_t) model->blocks[a].vertex_count);
  Deepest own = { 0, inner }, other = { 0, inner };
  try_point (search, a, b, inner, &own);
  try_point (search, b, a, inner, &other);
  double depth = fmin (own.depth, other.depth);
  if (depth > deepest->depth)
    *deepest = (Deepest){ depth, inner };
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

/* Depth and place of the overlap of two blocks of any shape, depth 0 where they do not overlap.
 * If the interiors meet, the boundary of one passes through the other, or they are equal. */
static bool
find_deepest (const QnContactSearch *search, QnId a, QnId b, Numbers *cuts,
              Deepest *deepest)
{
  *deepest = (Deepest){ 0, { 0, 0 } };
  if (!try_boundary (search, a, b, cuts, deepest)
      || !try_boundary (search, b, a, cuts, deepest))
    return false;
  if (deepest->depth <= search->lengths.tolerance && fill_same_box (search, a, b))
    try_inner_point (search, a, b, deepest);
  return true;
}

static bool
check_pair (const QnContactSearch *search, QnId a, QnId b, Numbers *cuts,
            QnFindings *findings)
{
  bool small = side_count (search, a) * side_count (search, b) <= FEW_SIDES * FEW_SIDES;
  double depth = INFINITY;
  if (small && search->convex[a])
    depth = reach_behind_sides (search, a, b, search->lengths.tolerance);
  if (small && search->convex[b] && depth > search->lengths.tolerance)
    depth = fmin (depth, reach_behind_sides (search, b, a, search->lengths.tolerance));
  if (depth <= search->lengths.tolerance)
    return true;

  Deepest deepest;
  if (!find_deepest (search, a, b, cuts, &deepest))
    return false;
  /* For two convex blocks the separating axes know the depth exactly. */
  if (!small || !search->convex[a] || !search->convex[b])
    depth = deepest.depth;
  if (depth <= search->lengths.tolerance)
    return true;
  QnProblem problem = depth > search->lengths.overlap_limit
                        ? QN_PROBLEM_BLOCKS_OVERLAP
                        : QN_PROBLEM_NEAR_MISS_OVERLAP;
  return qn_findings_add (findings,
                          (QnFinding){ problem, a, b, deepest.at, depth, QN_NONE });
}

static int
compare_findings (const void *a, const void *b)
{
  const QnFinding *left = a, *right = b;
  return (left->block_b > right->block_b) - (left->block_b < right->block_b);
}

QnStatus
qn_contact_search_overlaps (const QnContactSearch *search, QnFindings *findings,
                            QnDiag *diag)
{
  Numbers cuts = { 0 };
  bool done = true;
  for (size_t a = 0; a < search->model->block_count && done; a++) {
    size_t first = findings->count;
    QnBoxQuery query =
      qn_box_tree_query (&search->block_tree, qn_box_grow (search->block_boxes[a],
                                                           -search->lengths.tolerance));
    QnId b;
    while (done && (b = qn_box_query_next (&query)) != QN_NONE) {
      if ((size_t) b > a)
        done = check_pair (search, (QnId) a, b, &cuts, findings);
    }
    if (findings->count > first + 1)
      qsort (findings->items + first, findings->count - first, sizeof *findings->items,
             compare_findings);
  }
  free (cuts.items);
  return done ? QN_OK : qn_diag_no_memory (diag);
}
