/* The data of paths in SVG, and lists of numbers and points as other files have them, too. Private to reading
 * drawings. */
#pragma once

#include "io/exchange/drawing.h"

/* Where the pen is while a shape is read. */
typedef struct QnSvgPen {
  QnDrawing *drawing;
  const char *layer; /* of the paths that it begins */
  guint line;
  QnDrawingPath *path; /* open, or NULL */
  QnVec2 at, start, handle;
  char last; /* command */
} QnSvgPen;

/* The next number of a list, behind blanks and commas; FALSE where there is none. */
gboolean qn_svg_next_number (const char **text, double *number);

/* Begins a path. */
void qn_svg_pen_move (QnSvgPen *pen, QnVec2 to);

/* The data of a path element; FALSE where they are not well-formed. Likewise the points of a polygon. */
gboolean qn_svg_read_path (QnSvgPen *pen, const char *data);
gboolean qn_svg_read_points (QnSvgPen *pen, const char *text, gboolean closed);
