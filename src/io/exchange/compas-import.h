/* COMPAS assemblies (JSON) and meshes (OBJ) as drawings. */
#pragma once

#include "io/exchange/drawing.h"

/* Reads blocks that are prisms with a common direction along y, z or x, tried in this order, from what the
 * classes of COMPAS write as JSON: assemblies of all versions, networks, models with elements; and from
 * Wavefront's OBJ, where an object is a block. The faces of the front become one outline, z (or y)
 * upwards, in metres; `is_support` makes a support. A view in which blocks lie behind each other is none.
 * The view is told, and what spoils the first one. Same contract as qn_dxf_import(). */
gboolean qn_compas_import (const char *text, gsize length, const char *name,
                           QnDrawing *drawing, GError **error);
