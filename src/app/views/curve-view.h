/* The load–displacement curve of the current run, with a cursor bound to the drawing: drag it
 * and the wall moves. Other runs of the same blocks are drawn beneath it. While an analysis runs,
 * the multipliers reached so far, or the history up to now over the whole time.
 *
 * The axes fit the path up to its peak and a little more: a last motion that runs away leaves the
 * picture with an arrow. Ctrl and the wheel, or plus and minus, zoom; the middle button pans; a
 * double click or 0 fits again. The values of the point next to the pointer are told. */
#ifndef QN_APP_CURVE_VIEW_H
#define QN_APP_CURVE_VIEW_H

#include "doc/view/view-state.h"
#include <gtk/gtk.h>

#define QN_TYPE_CURVE_VIEW (qn_curve_view_get_type ())
G_DECLARE_FINAL_TYPE (QnCurveView, qn_curve_view, QN, CURVE_VIEW, GtkWidget)

/* Holds the state. */
GtkWidget *qn_curve_view_new (QnViewState *state);

/* What is in view, displacement in SI and multiplier: lower left and upper right corner. */
void qn_curve_view_get_range (QnCurveView *view, QnVec2 *low, QnVec2 *high);

/* What is told of the point next to a place of the widget, px; NULL where there is no curve. The
 * caller frees it. */
char *qn_curve_view_dup_values (QnCurveView *view, double x, double y);

#endif
