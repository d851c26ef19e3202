/* The gesture of dragging a rectangle, shared by the tools that need one: press and drag, or
 * click twice, or type width and height after the first corner. */
#ifndef QN_APP_TOOL_RECTANGLE_H
#define QN_APP_TOOL_RECTANGLE_H

#include "app/canvas.h"

void qn_rectangle_motion (QnCanvas *canvas, const QnToolEvent *event);

/* Each returns TRUE when the rectangle from gesture.from to gesture.to is complete; the tool
 * then ends the gesture. */
gboolean qn_rectangle_press (QnCanvas *canvas, const QnToolEvent *event);
gboolean qn_rectangle_release (QnCanvas *canvas, const QnToolEvent *event);
gboolean qn_rectangle_numbers (QnCanvas *canvas, const double *values, int count);

/* Frame and both dimensions of a rectangle. */
void qn_rectangle_draw (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);

#endif
