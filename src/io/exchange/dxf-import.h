/* DXF files as drawings. */
#pragma once

#include "io/exchange/drawing.h"

/* Reads the text of a DXF file: lines, polylines with bulges, arcs, circles, ellipses, splines,
 * solids and inserts nested to any sensible depth, those of layer 0 in a block on the layer of
 * its insert; faces in space and boundaries of hatches where there is nothing else. What lies in an
 * upright plane is seen from the front. Layers that are off or frozen are marked as hidden, invisible
 * parts left out. The text is in UTF-8 or in the code page that the file states. `drawing` is overwritten without being cleared and holds nothing on failure;
 * errors are one line with file and line, domain QN_IO_ERROR. */
gboolean qn_dxf_import (const char *text, gsize length, const char *name,
                        QnDrawing *drawing, GError **error);
