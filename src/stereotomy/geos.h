/* The only access to GEOS: a context per computation, rings in and out.
 *
 * Every failure shows in a NULL result and becomes a QnStatus. The messages of GEOS are used only to
 * recognise lack of memory. Private to this layer.
 */
#pragma once

#include "core/base/status.h"
#include "stereotomy/ring.h"

#include <geos_c.h>

typedef struct QnGeos {
  GEOSContextHandle_t handle;
  bool no_memory; /* something failed for lack of it */
} QnGeos;

/* NULL handle when memory runs out. The struct must stay where it is until it is cleared. */
QnStatus qn_geos_init (QnGeos *geos, QnDiag *diag);
void qn_geos_clear (QnGeos *geos);

/* A GEOS polygon; NULL when memory runs out. */
GEOSGeometry *qn_geos_polygon (QnGeos *geos, const QnVec2 *points, size_t count);

/* A line through points; NULL when memory runs out. */
GEOSGeometry *qn_geos_line (QnGeos *geos, const QnVec2 *points, size_t count);

/* A collection of this type of `count` parts, which it takes over as the list of them; NULL when memory
 * ran out, for it or before for any of them. */
GEOSGeometry *qn_geos_gather (QnGeos *geos, int type, GEOSGeometry **parts, size_t count);

/* A collection of polygons, NULL when memory runs out. */
GEOSGeometry *qn_geos_collection (QnGeos *geos, const QnRings *rings);

/* The outer rings of all polygons in `geometry` appended to `rings`, counter-clockwise, first
 * vertex lowest left; lines and points are ignored. `holes` (nullable) counts inner rings. */
void qn_geos_read_polygons (QnGeos *geos, const GEOSGeometry *geometry, QnRings *rings,
                            size_t *holes);

/* A function above or a GEOS operation failed: QN_ERROR_NO_MEMORY, or QN_ERROR_INTERNAL with
 * QN_PROBLEM_GEOMETRY_FAILED. */
QnStatus qn_geos_failed (const QnGeos *geos, QnDiag *diag);
