/* A drawing area that shows a plot. Ctrl and the wheel zoom, once it has been
 * clicked the wheel alone or plus and minus; the middle button pans; a double click or 0 shows all
 * again. */
#pragma once

#include "render/figure/plot.h"
#include <gtk/gtk.h>

/* What the owner of a plot view does; all but `make` may be NULL. Places are px of the widget. */
typedef struct QnPlotHand {
  double text_share; /* the plot's text over that of the window */
  gboolean steps;    /* the arrow keys go from step to step */

  /* The plot to draw, which is freed then; NULL: none, and *message, to be freed, says why. `zoomed`: a part
   * of it is shown that the user has chosen. */
  QnPlot *(*make) (gpointer data, gboolean zoomed, char **message);
  /* The value under the cursor, a line over the height of the plot; not-a-number: there is none. */
  double (*cursor) (gpointer data);
  /* The left button is down here, or has been dragged here. */
  void (*go_to) (gpointer data, QnVec2 at);
  /* The pointer is here; NULL: it is elsewhere. */
  void (*point) (gpointer data, const QnVec2 *at);
  /* What is told in a corner of the plot, to be freed, with the pointer here or elsewhere. */
  char *(*tell) (gpointer data, const QnVec2 *at);
} QnPlotHand;

/* Makes a plot view of a QnPaperArea, whose height is for text of the usual size and grows with it. `data` stays alive as long as `area`. */
void qn_plot_view_init (GtkWidget *area, const QnPlotHand *hand, gpointer data);

/* Shows all of the plot. */
void qn_plot_view_fit (GtkWidget *area);

/* Where what was drawn last lies; the values at a place. */
const QnPlotPlace *qn_plot_view_get_place (GtkWidget *area);
QnVec2 qn_plot_place_value (const QnPlotPlace *place, QnVec2 at);
