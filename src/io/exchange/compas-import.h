/* COMPAS assemblies (JSON) as drawings. */
#ifndef QN_IO_COMPAS_IMPORT_H
#define QN_IO_COMPAS_IMPORT_H

#include "io/exchange/drawing.h"

/* Reads an assembly of blocks that are prisms with a common direction along x, y or z, as
 * compas_assembly writes it: today's form ("data", "graph", "node", "block") and the older one
 * ("assembly", "blocks"). The faces across that direction become outlines, z (or y) upwards, in
 * metres; `is_support` makes a support. Same contract as qn_dxf_import(). */
gboolean qn_compas_import (const char *text, gsize length, const char *name,
                           QnDrawing *drawing, GError **error);

#endif
