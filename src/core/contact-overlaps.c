/* Blocks that overlap, how deeply and where. */
#include "core/contact-search.h"
#include "core/memory.h"
#include "core/polygon.h"

#include <stdlib.h>

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

static void
try_point (const QnContactSearch *search, QnId block, QnVec2 point, Deepest *deepest)
{
  const QnModel *model = search->model;
  double depth = qn_polygon_depth (qn_model_block_vertices (model, block),
                                   (size_t) model->blocks[block].vertex_count, point);
  if (depth > deepest->depth)
    *deepest = (Deepest){ depth, point };
}

/* Cuts a side where it meets the boundary of `block` and tries the middle of every piece: a
 * piece lies inside or outside as a whole. */
static bool
try_side (const QnContactSearch *search, const QnSide *side, QnId block, Numbers *cuts,
          Deepest *deepest)
{
  const QnSides *sides = &search->sides;
  cuts->count = 0;
  bool done = add_number (cuts, 0) && add_number (cuts, side->length);
  for (size_t j = sides->first[block]; j < sides->first[block + 1] && done; j++) {
    QnVec2 p = qn_vec2_sub (sides->items[j].start, side->start);
    QnVec2 q = qn_vec2_sub (sides->items[j].end, side->start);
    double left_p = qn_vec2_cross (side->direction, p);
    double left_q = qn_vec2_cross (side->direction, q);
    double at = NAN;
    if (fabs (left_p) <= search->tolerance)
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
    try_point (search, block, qn_vec2_add_scaled (side->start, middle, side->direction),
               deepest);
  }
  try_point (search, block, side->start, deepest);
  return true;
}

/* Looks for the point on the boundary of a that lies deepest in b. */
static bool
try_boundary (const QnContactSearch *search, QnId a, QnId b, Numbers *cuts,
              Deepest *deepest)
{
  const QnSides *sides = &search->sides;
  for (size_t i = sides->first[a]; i < sides->first[a + 1]; i++) {
    if (qn_box_meets (search->side_boxes[i], search->block_boxes[b])
        && !try_side (search, &sides->items[i], b, cuts, deepest))
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
  Deepest own = { 0, inner };
  try_point (search, a, inner, &own);
  Deepest other = { 0, inner };
  try_point (search, b, inner, &other);
  double depth = fmin (own.depth, other.depth);
  if (depth > deepest->depth)
    *deepest = (Deepest){ depth, inner };
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
  if (deepest->depth <= search->tolerance)
    try_inner_point (search, a, b, deepest);
  return true;
}

static bool
check_pair (const QnContactSearch *search, QnId a, QnId b, Numbers *cuts,
            QnFindings *findings)
{
  double depth = INFINITY;
  if (search->convex[a])
    depth = reach_behind_sides (search, a, b, search->tolerance);
  if (search->convex[b] && depth > search->tolerance)
    depth = fmin (depth, reach_behind_sides (search, b, a, search->tolerance));
  if (depth <= search->tolerance)
    return true;

  Deepest deepest;
  if (!find_deepest (search, a, b, cuts, &deepest))
    return false;
  /* For two convex blocks the separating axes know the depth exactly. */
  if (!search->convex[a] || !search->convex[b])
    depth = deepest.depth;
  if (depth <= search->tolerance)
    return true;
  QnProblem problem = depth > search->overlap_limit ? QN_PROBLEM_BLOCKS_OVERLAP
                                                    : QN_PROBLEM_NEAR_MISS_OVERLAP;
  return qn_findings_add (findings, (QnFinding){ problem, a, b, deepest.at, depth });
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
    QnBoxQuery query = qn_box_tree_query (
      &search->block_tree, qn_box_grow (search->block_boxes[a], -search->tolerance));
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
