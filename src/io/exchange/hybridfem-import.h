/* The text geometry of HybriDFEM as a drawing. */
#pragma once

#include "io/exchange/drawing.h"

/* Reads blocks of the form
 *
 *   Box 1:
 *   [0, 0], [1, 0], [1, 0.5], [0, 0.5]
 *   rho = 2400
 *   material = 0
 *
 * in metres. Finite elements (FE) and what else stands there is counted and left out. Same
 * contract as qn_dxf_import(). */
gboolean qn_hybridfem_import (const char *text, gsize length, const char *name,
                              QnDrawing *drawing, GError **error);
