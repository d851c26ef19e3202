#include "stereotomy/polygon-ops.h"
#include "core/base/polygon.h"
#include "stereotomy/geos.h"

#include <stdlib.h>

/* Vertices nearer than this part of a polygon's size, or of its distance from the origin, are
 * one: twelve decimal digits, far below every contact tolerance. */
#define VERTEX_TOLERANCE 1e-12

/* Edges of neighbours that cross a third one differ by rounding where they meet it, which leaves
 * slits between them. Where that matters coordinates are rounded to this part of the
 * extent first, four digits coarser than the vertices and far finer than any joint. */
#define GRID 1e-10

/* Parts smaller than this share of the subject's area are rounding, not pieces. */
#define NOTHING 1e-12

/* How often holes are parted; every round removes at least one. */
#define MAX_HOLE_ROUNDS 64

QnStatus
qn_ring_check (const QnRing *ring, QnId index, QnDiag *diag)
{
  QnPolygonFlaw flaw = qn_polygon_check (ring->points, ring->count);
  if (flaw.problem == QN_PROBLEM_NONE)
    return QN_OK;
  qn_require_memory (flaw.problem != QN_PROBLEM_NO_MEMORY);
  qn_refuse (diag, flaw.problem, QN_ENTITY_BLOCK, index);
  if (diag != NULL && flaw.vertex != QN_NONE) {
    diag->sub = flaw.vertex;
    diag->at = ring->points[flaw.vertex];
  }
  return QN_ERROR_INVALID;
}

static QnStatus
check_all (const QnRings *rings, QnDiag *diag)
{
  QnStatus status = QN_OK;
  for (size_t i = 0; i < rings->count && status == QN_OK; i++)
    status = qn_ring_check (&rings->items[i], (QnId) i, diag);
  return status;
}

/* Extent or distance from the origin, whichever is larger: what rounding is measured by. */
static double
bounds_reach (QnBox b)
{
  double reach =
    fmax (fmax (fabs (b.min.x), fabs (b.max.x)), fmax (fabs (b.min.y), fabs (b.max.y)));
  return fmax (qn_box_size (b), reach);
}

static int
compare_rings (const void *left, const void *right)
{
  QnBox a = qn_ring_bounds (left), b = qn_ring_bounds (right);
  if (a.min.x != b.min.x)
    return a.min.x < b.min.x ? -1 : 1;
  if (a.min.y != b.min.y)
    return a.min.y < b.min.y ? -1 : 1;
  return 0;
}

/* Cleans what GEOS returned and moves what has an area into `out`. */
static QnStatus
deliver (QnRings *found, double least_area, QnRings *out, QnDiag *diag)
{
  size_t before = out->count;
  QnStatus status = QN_OK;
  for (size_t i = 0; i < found->count && status == QN_OK; i++) {
    QnRing *ring = &found->items[i];
    qn_ring_simplify (ring, VERTEX_TOLERANCE * bounds_reach (qn_ring_bounds (ring)));
    if (ring->count < 3 || qn_ring_area (ring) <= least_area)
      continue;
    status = qn_ring_check (ring, (QnId) i, diag);
    if (status == QN_OK)
      qn_rings_take (out, ring);
  }
  if (status == QN_OK && out->count > before)
    qsort (out->items + before, out->count - before, sizeof *out->items, compare_rings);
  while (status != QN_OK && out->count > before)
    qn_rings_remove (out, out->count - 1);
  return status;
}

/* The half plane left of x (or right of it) within `bounds`, as a polygon. */
static GEOSGeometry *
half_of (QnBox bounds, double x, bool right)
{
  double margin = 1 + qn_box_size (bounds);
  double x0 = right ? x : bounds.min.x - margin, x1 = right ? bounds.max.x + margin : x;
  double y0 = bounds.min.y - margin, y1 = bounds.max.y + margin;
  const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  return qn_geos_polygon (corners, 4);
}

/* Abscissa through the middle of the first hole of a geometry; false where there is none. */
static bool
first_hole (const GEOSGeometry *geometry, double *x)
{
  GEOSContextHandle_t h = qn_geos ();
  int parts = GEOSGetNumGeometries_r (h, geometry);
  for (int i = 0; i < parts; i++) {
    const GEOSGeometry *part = GEOSGetGeometryN_r (h, geometry, i);
    if (GEOSGeomTypeId_r (h, part) != GEOS_POLYGON
        || GEOSGetNumInteriorRings_r (h, part) <= 0)
      continue;
    const GEOSGeometry *hole = GEOSGetInteriorRingN_r (h, part, 0);
    double x0, x1;
    if (GEOSGeom_getXMin_r (h, hole, &x0) != 1 || GEOSGeom_getXMax_r (h, hole, &x1) != 1)
      return false;
    *x = x0 / 2 + x1 / 2;
    return true;
  }
  return false;
}

/* Reads the polygons of `geometry`, parting what has holes. */
static QnStatus
collect (const GEOSGeometry *geometry, QnBox bounds, int round, QnRings *found,
         QnDiag *diag)
{
  double x;
  QnStatus status = QN_OK;
  if (!first_hole (geometry, &x) || round == MAX_HOLE_ROUNDS) {
    size_t holes = 0;
    qn_geos_read_polygons (geometry, found, &holes);
    return holes == 0
             ? QN_OK
             : qn_refuse (diag, QN_PROBLEM_GEOMETRY_HOLE, QN_ENTITY_MODEL, QN_NONE);
  }
  for (int side = 0; side < 2 && status == QN_OK; side++) {
    g_autoptr (GEOSGeometry) half = half_of (bounds, x, side == 1);
    g_autoptr (GEOSGeometry) part = GEOSIntersection_r (qn_geos (), geometry, half);
    status = part != NULL ? collect (part, bounds, round + 1, found, diag)
                          : qn_geos_failed (diag);
  }
  return status;
}

typedef GEOSGeometry *(*Overlay) (GEOSContextHandle_t, const GEOSGeometry *,
                                  const GEOSGeometry *, double grid);

/* Polygons that may touch or overlap, as one valid geometry; `grid` 0 keeps every digit. */
static GEOSGeometry *
merged (const QnRings *rings, double grid)
{
  g_autoptr (GEOSGeometry) parts = qn_geos_collection (rings);
  return grid > 0 ? GEOSUnaryUnionPrec_r (qn_geos (), parts, grid)
                  : GEOSUnaryUnion_r (qn_geos (), parts);
}

/* out += subject (op) others, which are merged first where they are several and may touch. Where the result touches
 * itself within rounding, as a vault whose crown just reaches a joint does, it is computed again on a grid that
 * parts it there. */
static QnStatus
combine (const QnRing *subject, const QnRings *others, bool merge, Overlay op,
         double least_area, QnRings *out, QnDiag *diag)
{
  const QnBox bounds = qn_ring_bounds (subject);
  const double grids[] = { 0, GRID * bounds_reach (bounds) };
  QnStatus status = qn_ring_check (subject, 0, diag);
  if (status == QN_OK)
    status = check_all (others, diag);
  if (status != QN_OK)
    return status;
  g_autoptr (GEOSGeometry) one = qn_geos_polygon (subject->points, subject->count);
  g_autoptr (GEOSGeometry) other =
    merge ? merged (others, 0)
          : qn_geos_polygon (others->items->points, others->items->count);
  if (other == NULL)
    return qn_geos_failed (diag);
  for (size_t i = 0; i < QN_N_ELEMENTS (grids); i++) {
    g_autoptr (GEOSGeometry) result = op (qn_geos (), one, other, grids[i]);
    g_auto (QnRings) found = { 0 };
    status =
      result != NULL ? collect (result, bounds, 0, &found, diag) : qn_geos_failed (diag);
    if (status == QN_OK)
      status = deliver (&found, NOTHING * least_area, out, diag);
    if (status != QN_ERROR_INVALID)
      break;
  }
  return status;
}

QnStatus
qn_polygon_difference (const QnRing *subject, const QnRings *cutters, QnRings *out,
                       QnDiag *diag)
{
  return combine (subject, cutters, true, GEOSDifferencePrec_r,
                  fabs (qn_ring_area (subject)), out, diag);
}

QnStatus
qn_polygon_intersection (const QnRing *a, const QnRing *b, QnRings *out, QnDiag *diag)
{
  QnRing other = *b;
  return combine (a, &(QnRings){ .items = &other, .count = 1 }, false,
                  GEOSIntersectionPrec_r,
                  fmin (fabs (qn_ring_area (a)), fabs (qn_ring_area (b))), out, diag);
}

static QnStatus
union_problem (QnDiag *diag, QnProblem problem)
{
  return qn_refuse (diag, problem, QN_ENTITY_MODEL, QN_NONE);
}

static QnStatus
union_on_grid (const QnRings *rings, double grid, QnRing *out, QnDiag *diag)
{
  g_autoptr (GEOSGeometry) all = merged (rings, grid);
  g_auto (QnRings) found = { 0 }, joined = { 0 };
  size_t holes = 0;
  if (all == NULL)
    return qn_geos_failed (diag);
  qn_geos_read_polygons (all, &found, &holes);
  if (holes > 0)
    return union_problem (diag, QN_PROBLEM_GEOMETRY_HOLE);
  QnStatus status = deliver (&found, 0, &joined, diag);
  if (status == QN_OK && joined.count != 1)
    status = union_problem (diag, joined.count == 0 ? QN_PROBLEM_GEOMETRY_EMPTY
                                                    : QN_PROBLEM_GEOMETRY_SEVERAL);
  if (status == QN_OK) {
    *out = joined.items[0];
    joined.items[0] = (QnRing){ 0 };
  }
  return status;
}

QnStatus
qn_polygons_union (const QnRings *rings, QnRing *out, QnDiag *diag)
{
  *out = (QnRing){ 0 };
  QnStatus status = check_all (rings, diag);
  if (status != QN_OK)
    return status;
  if (rings->count == 0)
    return union_problem (diag, QN_PROBLEM_GEOMETRY_EMPTY);

  status = union_on_grid (rings, 0, out, diag);
  if (status == QN_ERROR_INVALID)
    status =
      union_on_grid (rings, GRID * bounds_reach (qn_rings_bounds (rings)), out, diag);
  return status;
}

QnStatus
qn_polygon_cut (const QnRing *subject, QnVec2 a, QnVec2 b, QnRings *out, QnDiag *diag)
{
  QnStatus status = qn_ring_check (subject, 0, diag);
  if (status != QN_OK)
    return status;
  QnVec2 along = qn_vec2_sub (b, a);
  double length = qn_vec2_length (along);
  if (!isfinite (a.x) || !isfinite (a.y) || !isfinite (length))
    return union_problem (diag, QN_PROBLEM_NOT_FINITE);
  if (length == 0)
    return union_problem (diag, QN_PROBLEM_ZERO_AREA);

  /* A strip that covers the subject on the left of the line, and one on its right. The line is
   * carried to the subject first, so that the strips are no larger than they must be. */
  QnBox bounds = qn_ring_bounds (subject);
  QnVec2 middle = qn_vec2_lerp (bounds.min, bounds.max, 0.5);
  along = qn_vec2_scale (1 / length, along);
  QnVec2 foot =
    qn_vec2_add_scaled (a, qn_vec2_dot (qn_vec2_sub (middle, a), along), along);
  double reach = 2 * (qn_box_size (bounds) + qn_vec2_length (qn_vec2_sub (middle, foot)));
  size_t before = out->count;
  for (int side = -1; side <= 1 && status == QN_OK; side += 2) {
    QnVec2 across = qn_vec2_scale (side * reach, qn_vec2_perp (along));
    QnVec2 p = qn_vec2_add_scaled (foot, -reach, along);
    QnVec2 q = qn_vec2_add_scaled (foot, reach, along);
    QnVec2 strip[] = { p, q, qn_vec2_add (q, across), qn_vec2_add (p, across) };
    QnRing half = { strip, 4 };
    status = combine (subject, &(QnRings){ .items = &half, .count = 1 }, false,
                      GEOSIntersectionPrec_r, fabs (qn_ring_area (subject)), out, diag);
  }
  while (status != QN_OK && out->count > before)
    qn_rings_remove (out, out->count - 1);
  return status;
}
