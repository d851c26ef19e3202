#include "core/base/box-tree.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/base/polygon.h"
#include "core/base/tolerance.h"
#include "core/model/model.h"

/* Polygons with more edges than this are checked with a broad phase. */
#define FEW_EDGES 48

static const QnPolygonFlaw no_flaw = { QN_PROBLEM_NONE, QN_NONE, QN_NONE };

static QnPolygonFlaw
flaw (QnProblem problem, size_t vertex, size_t other)
{
  return (QnPolygonFlaw){ problem, (QnId) vertex, (QnId) other };
}

static QnPolygonFlaw
check_numbers (const QnVec2 *vertices, size_t count)
{
  for (size_t i = 0; i < count; i++) {
    QnProblem problem =
      qn_number_problem (qn_worse (fabs (vertices[i].x), fabs (vertices[i].y)),
                         QN_RANGE_FINITE, QN_MAX_COORDINATE);
    if (problem != QN_PROBLEM_NONE)
      return flaw (problem, i, (size_t) QN_NONE);
  }
  return no_flaw;
}

/* Whether all vertices lie on one line: that of the first vertex and the one farthest from it. */
static bool
is_flat (const QnVec2 *vertices, size_t count, double tolerance)
{
  size_t far = 0;
  double farthest = 0;
  for (size_t i = 1; i < count; i++) {
    double distance = qn_vec2_length (qn_vec2_sub (vertices[i], vertices[0]));
    if (distance > farthest) {
      farthest = distance;
      far = i;
    }
  }

  QnVec2 along = qn_vec2_sub (vertices[far], vertices[0]);
  for (size_t i = 1; i < count; i++) {
    double cross = qn_vec2_cross (along, qn_vec2_sub (vertices[i], vertices[0]));
    if (fabs (cross) > tolerance * farthest)
      return false;
  }
  return true;
}

/* Whether c and d lie strictly on different sides of the line pq. */
static bool
separates (QnVec2 p, QnVec2 q, QnVec2 c, QnVec2 d)
{
  QnVec2 along = qn_vec2_sub (q, p);
  double side_c = qn_vec2_cross (along, qn_vec2_sub (c, p));
  double side_d = qn_vec2_cross (along, qn_vec2_sub (d, p));
  return (side_c > 0 && side_d < 0) || (side_c < 0 && side_d > 0);
}

/* Problem between edges i < j. */
static QnPolygonFlaw
check_edge_pair (const QnVec2 *v, size_t count, double tolerance, size_t i, size_t j)
{
  size_t i_end = (i + 1) % count, j_end = (j + 1) % count;
  bool follows = i_end == j, precedes = j_end == i;

  if (!follows && !precedes) {
    if (qn_vec2_length (qn_vec2_sub (v[i], v[j])) <= tolerance)
      return flaw (QN_PROBLEM_DUPLICATE_VERTEX, j, i);
    if (qn_segment_distance (v[i], v[i_end], v[j]) <= tolerance
        || qn_segment_distance (v[j], v[j_end], v[i]) <= tolerance
        || (separates (v[i], v[i_end], v[j], v[j_end])
            && separates (v[j], v[j_end], v[i], v[i_end])))
      return flaw (QN_PROBLEM_SELF_CROSSING, i, j);
    return no_flaw;
  }

  /* Neighbours share a vertex by right; they must not fold back on each other. */
  QnVec2 far_i = follows ? v[i] : v[i_end];
  QnVec2 far_j = follows ? v[j_end] : v[j];
  if (qn_segment_distance (v[i], v[i_end], far_j) <= tolerance
      || qn_segment_distance (v[j], v[j_end], far_i) <= tolerance)
    return flaw (QN_PROBLEM_SELF_CROSSING, i, j);
  return no_flaw;
}

/* The worse one of two flaws: a repeated vertex explains a crossing, and the first vertex in the
 * polygon comes first, so that the answer does not depend on the order of the search. */
static QnPolygonFlaw
worse (QnPolygonFlaw a, QnPolygonFlaw b)
{
  if (a.problem == QN_PROBLEM_NONE || b.problem == QN_PROBLEM_NONE)
    return a.problem == QN_PROBLEM_NONE ? b : a;
  if (a.problem != b.problem)
    return a.problem == QN_PROBLEM_DUPLICATE_VERTEX ? a : b;
  if (a.vertex != b.vertex)
    return a.vertex < b.vertex ? a : b;
  return a.other <= b.other ? a : b;
}

static QnPolygonFlaw
check_all_pairs (const QnVec2 *vertices, size_t count, double tolerance)
{
  QnPolygonFlaw worst = no_flaw;
  for (size_t i = 0; i < count; i++) {
    for (size_t j = i + 1; j < count; j++)
      worst = worse (worst, check_edge_pair (vertices, count, tolerance, i, j));
  }
  return worst;
}

static QnPolygonFlaw
check_near_pairs (const QnVec2 *vertices, size_t count, double tolerance)
{
  QnPool room = { 0 };
  QnBoxTree tree;
  QnBox *boxes = qn_pool_alloc (&room, count, sizeof *boxes);
  for (size_t i = 0; boxes != NULL && i < count; i++) {
    QnBox box = qn_box_of_segment (vertices[i], vertices[(i + 1) % count]);
    boxes[i] = qn_box_grow (box, tolerance);
  }
  qn_box_tree_init (&tree, boxes, count, &room);

  QnPolygonFlaw worst = no_flaw;
  if (room.failed)
    worst.problem = QN_PROBLEM_NO_MEMORY;
  for (size_t i = 0; i < count && !room.failed; i++) {
    QnBoxQuery query = qn_box_tree_query (&tree, boxes[i]);
    QnId j;
    while ((j = qn_box_query_next (&query)) != QN_NONE) {
      if ((size_t) j > i)
        worst =
          worse (worst, check_edge_pair (vertices, count, tolerance, i, (size_t) j));
    }
    if (worst.problem != QN_PROBLEM_NONE)
      break; /* one is enough; pairs of later edges cannot be the first */
  }
  qn_pool_clear (&room);
  return worst;
}

QnPolygonFlaw
qn_polygon_check (const QnVec2 *vertices, size_t count)
{
  if (count < 3)
    return (QnPolygonFlaw){ QN_PROBLEM_TOO_FEW_VERTICES, QN_NONE, QN_NONE };
  QnPolygonFlaw found = check_numbers (vertices, count);
  if (found.problem != QN_PROBLEM_NONE)
    return found;

  /* Length below which distances in this polygon count as none. */
  QnBox box = qn_box_of_points (vertices, count);
  double far = fmax (fmax (fabs (box.min.x), fabs (box.max.x)),
                     fmax (fabs (box.min.y), fabs (box.max.y)));
  double tolerance =
    QN_TOLERANCE_POLYGON * qn_box_size (box) + QN_TOLERANCE_COORDINATE * far;
  for (size_t i = 0; i < count; i++) {
    size_t next = (i + 1) % count;
    if (qn_vec2_length (qn_vec2_sub (vertices[next], vertices[i])) <= tolerance)
      return i < next ? flaw (QN_PROBLEM_DUPLICATE_VERTEX, next, i)
                      : flaw (QN_PROBLEM_DUPLICATE_VERTEX, i, next);
  }
  if (is_flat (vertices, count, tolerance))
    return (QnPolygonFlaw){ QN_PROBLEM_ZERO_AREA, QN_NONE, QN_NONE };
  return count <= FEW_EDGES ? check_all_pairs (vertices, count, tolerance)
                            : check_near_pairs (vertices, count, tolerance);
}
