/* The load–displacement curve of the current run, with a cursor bound to the drawing: drag it
 * and the wall moves. Other runs of the same blocks are drawn with it. While an analysis runs,
 * the multipliers reached so far, or the history up to now over the whole time.
 *
 * The axes fit the path up to its peak and a little more: a last motion that runs away leaves the
 * picture with an arrow, until the user zooms. The values of the point next to the pointer are
 * told. */
#ifndef QN_APP_CURVE_VIEW_H
#define QN_APP_CURVE_VIEW_H

#include "doc/view/view-state.h"
#include <gtk/gtk.h>

/* Holds the state. The plot view (app/widgets/plot-view.h) is called "curve". */
GtkWidget *qn_curve_view_new (QnViewState *state);

/* What is told of the point next to a place of the widget, px; NULL where there is no curve. The
 * caller frees it. */
char *qn_curve_view_dup_values (GtkWidget *view, double x, double y);

#endif
