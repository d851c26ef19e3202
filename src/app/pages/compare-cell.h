/* One run of a comparison: its mechanism, or its last displacements, and what it is called. */
#pragma once

#include "core/base/vec2.h"
#include "doc/document/run.h"
#include <gtk/gtk.h>

/* What all cells of a comparison share. */
typedef struct QnCompareView {
  double base_scale; /* px per m at which every one fits; 0: not known yet */
  double zoom;       /* times that */
  QnVec2 pan;        /* m, of the middle of the view from that of the structure */
  double phase;      /* of the motion, 0 to 1 */
  gboolean outline;  /* of the first run over the others */
  QnRun *first;      /* borrowed */
  void (*changed) (gpointer data); /* called when a cell was zoomed or moved */
  gpointer changed_data;
} QnCompareView;

/* `view` must live as long as the cell. */
GtkWidget *qn_compare_cell_new (QnRun *run, QnCompareView *view);

/* What stands beneath it, without the title where it is `above` it already (nullable). */
void qn_compare_cell_set_title (GtkWidget *cell, const char *title, const char *above);

/* The whole of it; the caller frees it. */
char *qn_compare_cell_dup_caption (const QnRun *run, const char *title);

QnRun *qn_compare_cell_get_run (GtkWidget *cell);

/* px per m at which the run fits its cell; 0 before the cell has a size. */
double qn_compare_cell_fit_scale (GtkWidget *cell);

/* After a change of what the cell was told to show. */
void qn_compare_cell_redraw (GtkWidget *cell, gpointer unused);
