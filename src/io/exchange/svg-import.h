/* SVG files as drawings. */
#pragma once

#include "io/exchange/drawing.h"

/* Reads path, polygon, polyline, rect, circle, ellipse and line elements where the standard (SVG 2)
 * places them: transforms, lengths with units, view ports, used elements and symbols; the label or id
 * of the innermost group is the layer. What attributes, style or style sheets do not show, or paint with
 * nothing, is marked as hidden. A hole in a shape is cut out where it reaches the edge, else told. The y
 * axis is turned upwards. The unit follows from a width with a unit and the view box. The file may be
 * compressed by gzip. Same contract as qn_dxf_import(). */
gboolean qn_svg_import (const char *text, gsize length, const char *name,
                        QnDrawing *drawing, GError **error);
