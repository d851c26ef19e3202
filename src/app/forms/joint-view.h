/* The forces in the selected joint after a run: normal against shear force with the friction cone,
 * and both along the joint. */
#pragma once

#include <gtk/gtk.h>

#include "render/figure/joint-plot.h"

/* Makes a QnPaperArea one. */
void qn_joint_view_init (GtkWidget *area);

/* Takes over the points of the plot. */
void qn_joint_view_set_plot (GtkWidget *view, const QnJointPlot *plot);
