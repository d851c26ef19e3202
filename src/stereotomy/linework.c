#include "stereotomy/linework.h"
#include "core/base/box-tree.h"
#include "core/base/memory.h"
#include "stereotomy/geos.h"

#include <stdlib.h>

/* Misses below this part of the tolerance are rounding. */
#define NEGLIGIBLE 1e-6

void
qn_segments_add (QnSegments *segments, QnVec2 a, QnVec2 b)
{
  qn_require_memory (QN_ARRAY_PUSH (segments->items, segments->count, segments->capacity,
                                    (QnSegment){ a, b }));
}

void
qn_segments_clear (QnSegments *segments)
{
  free (segments->items);
  *segments = (QnSegments){ 0 };
}

static QnBox
box_of (QnSegment s)
{
  return qn_box_of_segment (s.a, s.b);
}

void
qn_segments_tree (const QnSegments *segments, double margin, QnBoxTree *tree,
                  QnPool *pool)
{
  g_autofree QnBox *boxes = g_new (QnBox, segments->count);
  for (size_t i = 0; i < segments->count; i++)
    boxes[i] = qn_box_grow (box_of (segments->items[i]), margin);
  qn_tree_of (tree, boxes, segments->count, pool);
}

/* By their ends, the lower or left one first. */
static int
compare_segments (const void *left, const void *right)
{
  const QnSegment *s = left, *t = right;
  const double a[] = { s->a.x, s->a.y, s->b.x, s->b.y };
  const double b[] = { t->a.x, t->a.y, t->b.x, t->b.y };
  for (size_t i = 0; i < QN_N_ELEMENTS (a); i++)
    if (a[i] != b[i])
      return a[i] < b[i] ? -1 : 1;
  return 0;
}

/* Drops segments without length and those that are there already. */
static void
drop_needless (QnSegments *segments)
{
  size_t kept = 0;
  for (size_t i = 0; i < segments->count; i++) {
    QnSegment s = segments->items[i];
    bool turn = s.b.x < s.a.x || (s.b.x == s.a.x && s.b.y < s.a.y);
    if (s.a.x != s.b.x || s.a.y != s.b.y)
      segments->items[kept++] = turn ? (QnSegment){ s.b, s.a } : s;
  }
  segments->count = kept;
  if (kept < 2)
    return;
  qsort (segments->items, kept, sizeof *segments->items, compare_segments);
  kept = 1;
  for (size_t i = 1; i < segments->count; i++)
    if (compare_segments (&segments->items[i], &segments->items[kept - 1]) != 0)
      segments->items[kept++] = segments->items[i];
  segments->count = kept;
}

/* Where the line through a and `end` meets the segment `other`, if that is within the tolerance of
 * `end`; else the nearest point of `other` if that is. */
static bool
meet (QnVec2 a, QnVec2 end, QnSegment other, double tolerance, QnVec2 *to)
{
  QnVec2 d = qn_vec2_sub (end, a), e = qn_vec2_sub (other.b, other.a);
  double length = qn_vec2_length (e), square = qn_vec2_dot (e, e);
  double s = qn_vec2_dot (qn_vec2_sub (end, other.a), e) / square;
  if (s * length < -tolerance || (s - 1) * length > tolerance)
    return false;
  QnVec2 foot = qn_vec2_lerp (other.a, other.b, fmin (fmax (s, 0), 1));
  if (qn_vec2_length (qn_vec2_sub (foot, end)) > tolerance)
    return false;
  double cross = qn_vec2_cross (d, e);
  *to = foot;
  if (fabs (cross) > 0.2 * qn_vec2_length (d) * length) {
    double t = qn_vec2_cross (qn_vec2_sub (other.a, a), e) / cross;
    QnVec2 crossing = qn_vec2_add_scaled (a, t, d);
    if (qn_vec2_length (qn_vec2_sub (crossing, end)) <= 5 * tolerance)
      *to = crossing;
  }
  return true;
}

/* A place where the end of one segment meets the inside of another: an exact corner of both, since
 * noding would miss it by rounding. */
typedef struct Split {
  size_t segment;
  double distance; /* from the segment's first end */
  QnVec2 at;
} Split;

/* Brings one end of segment `index` onto the nearest other segment it almost reaches. */
static void
reach (QnSegments *segments, size_t index, bool first, const QnBoxTree *tree,
       double tolerance, GArray *splits, QnHealing *healing)
{
  QnSegment *own = &segments->items[index];
  QnVec2 end = first ? own->a : own->b, start = first ? own->b : own->a, best = end;
  double nearest = INFINITY;
  size_t met = 0;
  QnBoxQuery query = qn_box_tree_query (tree, (QnBox){ end, end });
  for (QnId i; (i = qn_box_query_next (&query)) != QN_NONE;) {
    QnSegment other = segments->items[i];
    if ((size_t) i == index)
      continue;
    /* A shared end is met already. */
    if ((other.a.x == end.x && other.a.y == end.y)
        || (other.b.x == end.x && other.b.y == end.y))
      return;
    QnVec2 to;
    if (!meet (start, end, other, tolerance, &to))
      continue;
    double way = qn_vec2_length (qn_vec2_sub (to, end));
    if (way < nearest) {
      nearest = way;
      best = to;
      met = (size_t) i;
    }
  }
  if (!isfinite (nearest))
    return;
  if (nearest > NEGLIGIBLE * tolerance) {
    *(first ? &own->a : &own->b) = best;
    qn_healing_note (healing, end, best);
  } else {
    best = end;
  }
  const Split split = { met, qn_vec2_length (qn_vec2_sub (best, segments->items[met].a)),
                        best };
  g_array_append_val (splits, split);
}

static int
compare_splits (const void *left, const void *right)
{
  const Split *a = left, *b = right;
  if (a->segment != b->segment)
    return a->segment < b->segment ? -1 : 1;
  return a->distance < b->distance ? -1 : a->distance > b->distance;
}

/* Brings ends onto segments, and parts those there; the last part takes the place of the whole. */
static void
close_gaps (QnSegments *segments, double tolerance, QnHealing *healing)
{
  g_auto (QnPool) room = { 0 };
  g_autoptr (GArray) splits = g_array_new (FALSE, FALSE, sizeof (Split));
  QnBoxTree tree;
  qn_segments_tree (segments, tolerance, &tree, &room);
  for (size_t i = 0; i < segments->count; i++)
    for (int end = 0; end < 2; end++)
      reach (segments, i, end == 0, &tree, tolerance, splits, healing);
  g_array_sort (splits, compare_splits);
  for (guint i = 0; i < splits->len; i++) {
    const Split *split = &g_array_index (splits, Split, i);
    qn_segments_add (segments, segments->items[split->segment].a, split->at);
    segments->items[split->segment].a = split->at;
  }
}

static bool
crosses (QnSegment s, QnSegment t)
{
  QnVec2 d = qn_vec2_sub (s.b, s.a), e = qn_vec2_sub (t.b, t.a);
  double a = qn_vec2_cross (d, qn_vec2_sub (t.a, s.a));
  double b = qn_vec2_cross (d, qn_vec2_sub (t.b, s.a));
  double c = qn_vec2_cross (e, qn_vec2_sub (s.a, t.a));
  double f = qn_vec2_cross (e, qn_vec2_sub (s.b, t.a));
  return ((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && f < 0) || (c < 0 && f > 0));
}

/* Whether the lines of a soup cross too often. */
static bool
cross_too_often (const QnSegments *segments)
{
  g_auto (QnPool) room = { 0 };
  QnBoxTree tree;
  size_t crossings = 0, meetings = 0;
  qn_segments_tree (segments, 0, &tree, &room);
  for (size_t i = 0; i < segments->count; i++) {
    QnBoxQuery query = qn_box_tree_query (&tree, box_of (segments->items[i]));
    for (QnId k; (k = qn_box_query_next (&query)) != QN_NONE;) {
      meetings++;
      crossings += (size_t) k > i && crosses (segments->items[i], segments->items[k]);
      if (crossings > QN_MOST_CROSSINGS || meetings > QN_MOST_LINE_MEETINGS)
        return true;
    }
  }
  return false;
}

static int
compare_faces (const void *left, const void *right)
{
  const QnRing *a = left, *b = right;
  QnVec2 p = a->points[0], q = b->points[0];
  if (p.y != q.y)
    return p.y < q.y ? -1 : 1;
  return p.x < q.x ? -1 : p.x > q.x;
}

static QnStatus
enclosed_faces (const QnSegments *segments, double tolerance, QnRings *faces,
                size_t *holes, QnDiag *diag)
{
  GEOSContextHandle_t geos = qn_geos ();
  g_autofree GEOSGeometry **parts = g_new (GEOSGeometry *, segments->count);
  for (size_t i = 0; i < segments->count; i++)
    parts[i] = qn_geos_line (&segments->items[i].a, 2); /* and b behind it */
  g_autoptr (GEOSGeometry) lines = GEOSGeom_createCollection_r (
    geos, GEOS_MULTILINESTRING, parts, (unsigned) segments->count);
  g_autoptr (GEOSGeometry) noded = GEOSUnaryUnion_r (geos, lines);
  const GEOSGeometry *input = noded;
  g_autoptr (GEOSGeometry) polygons =
    noded != NULL ? GEOSPolygonize_r (geos, &input, 1) : NULL;
  if (polygons == NULL)
    return qn_geos_failed (diag);
  /* Polygons without holes; those with holes are counted. */
  int count = GEOSGetNumGeometries_r (qn_geos (), polygons);
  for (int i = 0; i < count; i++) {
    const GEOSGeometry *polygon = GEOSGetGeometryN_r (qn_geos (), polygons, i);
    if (GEOSGetNumInteriorRings_r (qn_geos (), polygon) == 0)
      qn_geos_read_polygons (polygon, faces, NULL);
    else if (holes != NULL)
      (*holes)++;
  }
  for (size_t i = 0; i < faces->count; i++) {
    qn_ring_simplify (&faces->items[i], NEGLIGIBLE * tolerance);
    qn_ring_normalize (&faces->items[i]);
  }
  return QN_OK;
}

QnStatus
qn_linework_polygonize (QnSegments *segments, double tolerance, QnRings *faces,
                        size_t *holes, QnHealing *healing, QnDiag *diag)
{
  g_auto (QnRings) found = { 0 };
  /* The ends are welded as those of rings of two points. */
  g_autofree QnRing *pairs = g_new (QnRing, segments->count);
  for (size_t i = 0; i < segments->count; i++)
    pairs[i] = (QnRing){ &segments->items[i].a, 2 };
  qn_weld_vertices (&(QnRings){ .items = pairs, .count = segments->count }, 0, tolerance,
                    NULL, healing);
  drop_needless (segments);
  if (segments->count == 0)
    return QN_OK;
  if (cross_too_often (segments))
    return qn_refuse (diag, QN_PROBLEM_TOO_MANY_CROSSINGS, QN_ENTITY_MODEL, QN_NONE);
  close_gaps (segments, tolerance, healing);
  drop_needless (segments);
  QnStatus status = enclosed_faces (segments, tolerance, &found, holes, diag);
  qn_drop_collapsed (&found);
  if (found.count > 1)
    qsort (found.items, found.count, sizeof *found.items, compare_faces);
  for (size_t i = 0; i < found.count && status == QN_OK; i++)
    qn_rings_take (faces, &found.items[i]);
  return status;
}
