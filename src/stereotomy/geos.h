/* The only access to GEOS: rings in and out.
 *
 * A failure shows in a NULL result and becomes a QnStatus. Private to this layer.
 */
#pragma once

#include "core/base/status.h"
#include "stereotomy/ring.h"

#include <geos_c.h>

/* The context of this thread. */
GEOSContextHandle_t qn_geos (void);

static inline void
qn_geos_destroy (GEOSGeometry *geometry)
{
  GEOSGeom_destroy_r (qn_geos (), geometry);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC (GEOSGeometry, qn_geos_destroy)

/* Of three points or more. */
GEOSGeometry *qn_geos_polygon (const QnVec2 *points, size_t count);

/* A line through points. */
GEOSGeometry *qn_geos_line (const QnVec2 *points, size_t count);

/* A collection of polygons. */
GEOSGeometry *qn_geos_collection (const QnRings *rings);

/* The outer rings of all polygons in `geometry` appended to `rings`, counter-clockwise, first
 * vertex lowest left; lines and points are ignored. `holes` (nullable) counts inner rings. */
void qn_geos_read_polygons (const GEOSGeometry *geometry, QnRings *rings, size_t *holes);

/* A GEOS operation failed: QN_ERROR_INTERNAL with QN_PROBLEM_GEOMETRY_FAILED. */
QnStatus qn_geos_failed (QnDiag *diag);
