/* SVG files as drawings. */
#ifndef QN_IO_SVG_IMPORT_H
#define QN_IO_SVG_IMPORT_H

#include "io/exchange/drawing.h"

/* Reads path, polygon, polyline, rect, circle, ellipse and line elements with their transforms; the
 * label or id of the innermost group is the layer. The y axis is turned upwards. The unit follows
 * from a width with a unit and the view box. Same contract as qn_dxf_import(). */
gboolean qn_svg_import (const char *text, gsize length, const char *name,
                        QnDrawing *drawing, GError **error);

#endif
