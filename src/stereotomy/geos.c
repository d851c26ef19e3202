#include "stereotomy/geos.h"

#include <string.h>

static void
finish (gpointer context)
{
  GEOS_finish_r (context);
}

GEOSContextHandle_t
qn_geos (void)
{
  static GPrivate contexts = G_PRIVATE_INIT (finish);
  GEOSContextHandle_t context = g_private_get (&contexts);
  if (context == NULL) {
    context = GEOS_init_r ();
    qn_require_memory (context != NULL);
    g_private_set (&contexts, context);
  }
  return context;
}

QnStatus
qn_geos_failed (QnDiag *diag)
{
  return qn_diag_set (diag, QN_ERROR_INTERNAL, QN_PROBLEM_GEOMETRY_FAILED);
}

static GEOSCoordSequence *
sequence_of (const QnVec2 *points, size_t count)
{
  GEOSCoordSequence *sequence = GEOSCoordSeq_copyFromBuffer_r (
    qn_geos (), (const double *) points, (unsigned) count, 0, 0);
  qn_require_memory (sequence != NULL);
  return sequence;
}

GEOSGeometry *
qn_geos_polygon (const QnVec2 *points, size_t count)
{
  g_autofree QnVec2 *closed = g_new (QnVec2, count + 1);
  memcpy (closed, points, count * sizeof *closed);
  closed[count] = closed[0];
  GEOSGeometry *ring =
    GEOSGeom_createLinearRing_r (qn_geos (), sequence_of (closed, count + 1));
  GEOSGeometry *polygon =
    ring != NULL ? GEOSGeom_createPolygon_r (qn_geos (), ring, NULL, 0) : NULL;
  qn_require_memory (polygon != NULL);
  return polygon;
}

GEOSGeometry *
qn_geos_line (const QnVec2 *points, size_t count)
{
  return GEOSGeom_createLineString_r (qn_geos (), sequence_of (points, count));
}

GEOSGeometry *
qn_geos_collection (const QnRings *rings)
{
  g_autofree GEOSGeometry **parts = g_new (GEOSGeometry *, rings->count);
  for (size_t i = 0; i < rings->count; i++)
    parts[i] = qn_geos_polygon (rings->items[i].points, rings->items[i].count);
  return GEOSGeom_createCollection_r (qn_geos (), GEOS_MULTIPOLYGON, parts,
                                      (unsigned) rings->count);
}

static void
read_polygon (const GEOSGeometry *polygon, QnRings *rings)
{
  GEOSContextHandle_t h = qn_geos ();
  const GEOSGeometry *shell = GEOSGetExteriorRing_r (h, polygon);
  const GEOSCoordSequence *sequence =
    shell != NULL ? GEOSGeom_getCoordSeq_r (h, shell) : NULL;
  unsigned size = 0;
  if (sequence == NULL || !GEOSCoordSeq_getSize_r (h, sequence, &size) || size < 4)
    return;

  QnRing ring = { g_new (QnVec2, size), size - 1 };
  qn_require_memory (
    GEOSCoordSeq_copyToBuffer_r (h, sequence, (double *) ring.points, 0, 0));
  qn_ring_orient (&ring);
  qn_ring_normalize (&ring);
  qn_rings_take (rings, &ring);
}

void
qn_geos_read_polygons (const GEOSGeometry *geometry, QnRings *rings, size_t *holes)
{
  GEOSContextHandle_t h = qn_geos ();
  if (GEOSisEmpty_r (h, geometry))
    return;
  if (GEOSGeomTypeId_r (h, geometry) == GEOS_POLYGON) {
    if (holes != NULL)
      *holes += (size_t) GEOSGetNumInteriorRings_r (h, geometry);
    read_polygon (geometry, rings);
  } else if (GEOSGeomTypeId_r (h, geometry) >= GEOS_MULTIPOINT) {
    int count = GEOSGetNumGeometries_r (h, geometry);
    for (int i = 0; i < count; i++)
      qn_geos_read_polygons (GEOSGetGeometryN_r (h, geometry, i), rings, holes);
  }
}
