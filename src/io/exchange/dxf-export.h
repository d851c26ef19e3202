/* Blocks as DXF, for CAD programs. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"

#include <glib.h>

/* Writes AutoCAD 2000 DXF (AC1015) in metres, or in units of `unit` metres: closed polylines on the
 * layers BLOCKS and SUPPORTS (what is fixed in all directions), lines on CONTACTS where `contacts`
 * is given, the blocks of the last step on DEFORMED where `result` is, displacements times
 * `scale`. Beams are lines on BEAM_AXES, a layer that is there for them alone and that an import
 * leaves out as it does all axes. Numbers have the digits that bring back the same coordinates.
 * Errors: QN_IO_ERROR. */
gboolean qn_dxf_export (const QnModel *model, const QnContacts *contacts,
                        const QnResult *result, double scale, double unit,
                        const char *path, GError **error);
