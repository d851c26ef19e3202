/* Results for ParaView: one VTU file per step and a PVD file that lists them. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"

#include <glib.h>

/* Writes `path` (….pvd) and, beside it, NAME_0000.vtu and so on, one per step, the multiplier as
 * their time; where `result` is NULL a single one of the undeformed model.
 *
 * Every block is one polygon on points of its own, undeformed, so that "Warp by vector" shows the
 * motion. Point data: displacement (m, the rigid motion with a finite rotation). Cell data: block,
 * supported, motion (ux, uy, rz of the centroid), weight (N).
 *
 * Beams are in NAME_beams_0000.vtu and so on, a line per element on points of its own; point data:
 * displacement, normal_shear_moment (N, N, N m, at the element's ends); cell data: beam.
 *
 * The forces at the last equilibrium are in NAME_forces.vtu, a line per contact pair from its
 * point along the force on the second block, the largest a tenth of the model's extent long; cell
 * data: state (0 stick, 1 slip, 2 open, 3 yield), normal_shear_force (N), face.
 *
 * All files appear together or none of them. Errors: QN_IO_ERROR. */
gboolean qn_vtu_export (const QnModel *model, const QnContacts *contacts,
                        const QnResult *result, const char *path, GError **error);
