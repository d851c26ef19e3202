/* The load–displacement curve of the current run, with a cursor bound to the drawing: drag it
 * and the wall moves. While an analysis runs, the multipliers reached so far. */
#ifndef QN_APP_CURVE_VIEW_H
#define QN_APP_CURVE_VIEW_H

#include "doc/view/view-state.h"
#include <gtk/gtk.h>

#define QN_TYPE_CURVE_VIEW (qn_curve_view_get_type ())
G_DECLARE_FINAL_TYPE (QnCurveView, qn_curve_view, QN, CURVE_VIEW, GtkWidget)

/* Holds the state. */
GtkWidget *qn_curve_view_new (QnViewState *state);

#endif
