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
  if (!QN_ARRAY_PUSH (segments->items, segments->count, segments->capacity,
                      (QnSegment){ a, b }))
    segments->failed = true;
}

void
qn_segments_clear (QnSegments *segments)
{
  free (segments->items);
  *segments = (QnSegments){ 0 };
}

QnBox *
qn_segments_tree (const QnSegments *segments, double margin, QnBoxTree *tree,
                  QnPool *pool)
{
  QnBox *boxes = qn_pool_alloc (pool, segments->count, sizeof *boxes);
  for (size_t i = 0; boxes != NULL && i < segments->count; i++)
    boxes[i] = qn_box_grow (
      qn_box_of_segment (segments->items[i].a, segments->items[i].b), margin);
  qn_box_tree_init (tree, boxes, segments->count, pool);
  return boxes;
}

/* Welds the ends by handing them over as two-point rings. */
static QnStatus
weld_ends (QnSegments *segments, double tolerance, QnHealing *healing, QnDiag *diag)
{
  QnRings pairs = { .items = qn_alloc (segments->count, sizeof *pairs.items),
                    .count = segments->count };
  if (pairs.items == NULL)
    return qn_diag_no_memory (diag);
  for (size_t i = 0; i < segments->count; i++)
    pairs.items[i] = (QnRing){ &segments->items[i].a, 2 };
  QnStatus status = qn_weld_vertices (&pairs, 0, tolerance, NULL, healing, diag);
  free (pairs.items);
  return status;
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

typedef struct Splits {
  Split *items;
  size_t count, capacity;
} Splits;

/* Brings one end of segment `index` onto the nearest other segment it almost reaches. False when
 * memory runs out. */
static bool
reach (QnSegments *segments, size_t index, bool first, const QnBoxTree *tree,
       double tolerance, Splits *splits, QnHealing *healing)
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
      return true;
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
    return true;
  if (nearest > NEGLIGIBLE * tolerance) {
    *(first ? &own->a : &own->b) = best;
    qn_healing_note (healing, end, best);
  } else {
    best = end;
  }
  return QN_ARRAY_PUSH (
    splits->items, splits->count, splits->capacity,
    (Split){ met, qn_vec2_length (qn_vec2_sub (best, segments->items[met].a)), best });
}

static int
compare_splits (const void *left, const void *right)
{
  const Split *a = left, *b = right;
  if (a->segment != b->segment)
    return a->segment < b->segment ? -1 : 1;
  return a->distance < b->distance ? -1 : a->distance > b->distance;
}

/* Parts the segments at their splits; the last part takes the place of the whole. */
static void
apply_splits (QnSegments *segments, Splits *splits)
{
  if (splits->count > 1)
    qsort (splits->items, splits->count, sizeof *splits->items, compare_splits);
  for (size_t i = 0; i < splits->count; i++) {
    size_t index = splits->items[i].segment;
    QnVec2 from = segments->items[index].a;
    qn_segments_add (segments, from, splits->items[i].at);
    segments->items[index].a = splits->items[i].at;
  }
}

static QnStatus
close_gaps (QnSegments *segments, double tolerance, QnHealing *healing, QnDiag *diag)
{
  QnPool room = { 0 };
  QnBoxTree tree;
  Splits splits = { 0 };
  qn_segments_tree (segments, tolerance, &tree, &room);
  bool done = !room.failed;
  for (size_t i = 0, count = segments->count; done && i < count; i++)
    done = reach (segments, i, true, &tree, tolerance, &splits, healing)
           && reach (segments, i, false, &tree, tolerance, &splits, healing);
  if (done)
    apply_splits (segments, &splits);
  qn_pool_clear (&room);
  free (splits.items);
  return done && !segments->failed ? QN_OK : qn_diag_no_memory (diag);
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

/* Refuses a soup whose lines cross too often. */
static QnStatus
check_crossings (const QnSegments *segments, QnDiag *diag)
{
  QnPool room = { 0 };
  QnBoxTree tree;
  QnBox *boxes = qn_segments_tree (segments, 0, &tree, &room);
  size_t crossings = 0, meetings = 0;
  bool done = !room.failed, most = false;
  for (size_t i = 0; done && !most && i < segments->count; i++) {
    QnBoxQuery query = qn_box_tree_query (&tree, boxes[i]);
    for (QnId k; !most && (k = qn_box_query_next (&query)) != QN_NONE;) {
      meetings++;
      crossings += (size_t) k > i && crosses (segments->items[i], segments->items[k]);
      most = crossings > QN_MOST_CROSSINGS || meetings > QN_MOST_LINE_MEETINGS;
    }
  }
  qn_pool_clear (&room);
  if (most)
    return qn_refuse (diag, QN_PROBLEM_TOO_MANY_CROSSINGS, QN_ENTITY_MODEL, QN_NONE);
  return done ? QN_OK : qn_diag_no_memory (diag);
}

static GEOSGeometry *
lines_geometry (QnGeos *geos, const QnSegments *segments)
{
  GEOSGeometry **lines = qn_alloc (segments->count, sizeof *lines);
  for (size_t i = 0; lines != NULL && i < segments->count; i++)
    lines[i] = qn_geos_line (geos, &segments->items[i].a, 2); /* and b behind it */
  return qn_geos_gather (geos, GEOS_MULTILINESTRING, lines, segments->count);
}

/* Polygons without holes; those with holes are counted. */
static void
read_faces (QnGeos *geos, const GEOSGeometry *polygons, QnRings *faces, size_t *holes)
{
  int count = GEOSGetNumGeometries_r (geos->handle, polygons);
  for (int i = 0; i < count; i++) {
    const GEOSGeometry *polygon = GEOSGetGeometryN_r (geos->handle, polygons, i);
    if (GEOSGetNumInteriorRings_r (geos->handle, polygon) == 0)
      qn_geos_read_polygons (geos, polygon, faces, NULL);
    else if (holes != NULL)
      (*holes)++;
  }
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
  QnGeos geos = { 0 };
  QnStatus status = qn_geos_init (&geos, diag);
  if (status != QN_OK)
    return status;
  size_t before = faces->count;
  GEOSGeometry *lines = lines_geometry (&geos, segments);
  GEOSGeometry *noded = lines != NULL ? GEOSUnaryUnion_r (geos.handle, lines) : NULL;
  const GEOSGeometry *input = noded;
  GEOSGeometry *polygons =
    noded != NULL ? GEOSPolygonize_r (geos.handle, &input, 1) : NULL;
  if (polygons != NULL)
    read_faces (&geos, polygons, faces, holes);
  status = polygons != NULL ? qn_rings_status (faces, diag)
           : lines == NULL  ? qn_diag_no_memory (diag)
                            : qn_geos_failed (&geos, diag);
  GEOSGeom_destroy_r (geos.handle, lines);
  GEOSGeom_destroy_r (geos.handle, noded);
  GEOSGeom_destroy_r (geos.handle, polygons);
  qn_geos_clear (&geos);
  for (size_t i = before; i < faces->count; i++) {
    qn_ring_simplify (&faces->items[i], NEGLIGIBLE * tolerance);
    qn_ring_normalize (&faces->items[i]);
  }
  return status;
}

QnStatus
qn_linework_polygonize (QnSegments *segments, double tolerance, QnRings *faces,
                        size_t *holes, QnHealing *healing, QnDiag *diag)
{
  QnStatus status = segments->failed ? qn_diag_no_memory (diag)
                                     : weld_ends (segments, tolerance, healing, diag);
  drop_needless (segments);
  if (status != QN_OK || segments->count == 0)
    return status;
  status = check_crossings (segments, diag);
  if (status == QN_OK)
    status = close_gaps (segments, tolerance, healing, diag);
  drop_needless (segments);
  QnRings found = { 0 };
  if (status == QN_OK)
    status = enclosed_faces (segments, tolerance, &found, holes, diag);
  qn_drop_collapsed (&found);
  if (found.count > 1)
    qsort (found.items, found.count, sizeof *found.items, compare_faces);
  for (size_t i = 0; i < found.count && status == QN_OK; i++)
    qn_rings_take (faces, &found.items[i]);
  qn_rings_clear (&found);
  return status == QN_OK ? qn_rings_status (faces, diag) : status;
}
