#include "stereotomy/geos.h"
#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

static void
on_message (const char *message, void *data)
{
  QnGeos *geos = data;
  if (strstr (message, "bad_alloc") != NULL)
    geos->no_memory = true;
}

QnStatus
qn_geos_init (QnGeos *geos, QnDiag *diag)
{
  *geos = (QnGeos){ .handle = GEOS_init_r () };
  if (geos->handle == NULL)
    return qn_diag_no_memory (diag);
  GEOSContext_setErrorMessageHandler_r (geos->handle, on_message, geos);
  return QN_OK;
}

void
qn_geos_clear (QnGeos *geos)
{
  if (geos->handle != NULL)
    GEOS_finish_r (geos->handle);
  geos->handle = NULL;
}

QnStatus
qn_geos_failed (const QnGeos *geos, QnDiag *diag)
{
  if (geos->no_memory)
    return qn_diag_no_memory (diag);
  return qn_diag_set (diag, QN_ERROR_INTERNAL, QN_PROBLEM_GEOMETRY_FAILED);
}

GEOSGeometry *
qn_geos_polygon (QnGeos *geos, const QnVec2 *points, size_t count)
{
  GEOSContextHandle_t h = geos->handle;
  QnVec2 *closed = qn_alloc (count + 1, sizeof *closed);
  if (closed == NULL) {
    geos->no_memory = true;
    return NULL;
  }
  memcpy (closed, points, count * sizeof *closed);
  closed[count] = closed[0];
  GEOSCoordSequence *sequence = GEOSCoordSeq_copyFromBuffer_r (
    h, (const double *) closed, (unsigned) count + 1, 0, 0);
  free (closed);
  GEOSGeometry *ring =
    sequence != NULL ? GEOSGeom_createLinearRing_r (h, sequence) : NULL;
  return ring != NULL ? GEOSGeom_createPolygon_r (h, ring, NULL, 0) : NULL;
}

GEOSGeometry *
qn_geos_line (QnGeos *geos, const QnVec2 *points, size_t count)
{
  GEOSCoordSequence *sequence = GEOSCoordSeq_copyFromBuffer_r (
    geos->handle, (const double *) points, (unsigned) count, 0, 0);
  return sequence != NULL ? GEOSGeom_createLineString_r (geos->handle, sequence) : NULL;
}

GEOSGeometry *
qn_geos_gather (QnGeos *geos, int type, GEOSGeometry **parts, size_t count)
{
  bool whole = parts != NULL;
  geos->no_memory |= !whole;
  for (size_t i = 0; parts != NULL && i < count; i++)
    whole = whole && parts[i] != NULL;
  GEOSGeometry *all = NULL;
  if (whole)
    all = GEOSGeom_createCollection_r (geos->handle, type, parts, (unsigned) count);
  for (size_t i = 0; parts != NULL && !whole && i < count; i++)
    GEOSGeom_destroy_r (geos->handle, parts[i]);
  free (parts);
  return all;
}

GEOSGeometry *
qn_geos_collection (QnGeos *geos, const QnRings *rings)
{
  GEOSGeometry **parts = qn_alloc (rings->count, sizeof *parts);
  for (size_t i = 0; parts != NULL && i < rings->count; i++)
    parts[i] = qn_geos_polygon (geos, rings->items[i].points, rings->items[i].count);
  return qn_geos_gather (geos, GEOS_MULTIPOLYGON, parts, rings->count);
}

static void
read_polygon (QnGeos *geos, const GEOSGeometry *polygon, QnRings *rings)
{
  GEOSContextHandle_t h = geos->handle;
  const GEOSGeometry *shell = GEOSGetExteriorRing_r (h, polygon);
  const GEOSCoordSequence *sequence =
    shell != NULL ? GEOSGeom_getCoordSeq_r (h, shell) : NULL;
  unsigned size = 0;
  if (sequence != NULL && GEOSCoordSeq_getSize_r (h, sequence, &size) && size < 4)
    return;

  QnRing ring = { qn_alloc (size, sizeof *ring.points), 0 };
  if (size > 0 && ring.points != NULL
      && GEOSCoordSeq_copyToBuffer_r (h, sequence, (double *) ring.points, 0, 0))
    ring.count = size - 1;
  else
    qn_ring_clear (&ring);
  qn_ring_orient (&ring);
  qn_ring_normalize (&ring);
  qn_rings_take (rings, &ring);
}

void
qn_geos_read_polygons (QnGeos *geos, const GEOSGeometry *geometry, QnRings *rings,
                       size_t *holes)
{
  GEOSContextHandle_t h = geos->handle;
  if (GEOSisEmpty_r (h, geometry))
    return;
  if (GEOSGeomTypeId_r (h, geometry) == GEOS_POLYGON) {
    if (holes != NULL)
      *holes += (size_t) GEOSGetNumInteriorRings_r (h, geometry);
    read_polygon (geos, geometry, rings);
  } else if (GEOSGeomTypeId_r (h, geometry) >= GEOS_MULTIPOINT) {
    int count = GEOSGetNumGeometries_r (h, geometry);
    for (int i = 0; i < count; i++)
      qn_geos_read_polygons (geos, GEOSGetGeometryN_r (h, geometry, i), rings, holes);
  }
}
