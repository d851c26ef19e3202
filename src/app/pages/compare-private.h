/* The inside of the page of comparisons, shared by the files that make it up. */
#pragma once

#include "app/pages/pages.h"
#include "doc/document/batch.h"

typedef struct Compare {
  QnDocument *document;
  QnDocumentsFunc list_others;
  QnBatch *batch;    /* files that were opened here */
  GHashTable *known; /* runs of these files that were put on show, of QnRun */
  GtkWidget *page, *grid, *list, *table, *curves;
  GPtrArray *shown;  /* of QnRun, in the order chosen */
  GPtrArray *cells;  /* their pictures; of Cell, which the widgets own */
  double base_scale; /* px per m at which every one fits; 0: not known yet */
  double zoom;       /* times that */
  QnVec2 pan;        /* m, of the middle of the view from that of the structure */
  double phase;      /* of the motion, 0 to 1 */
  gboolean outline;  /* of the first run over the others */
  gint64 started;
  guint tick;
} Compare;

/* Those of the windows, that of this one first, and of the files. */
GPtrArray *qn_compare_list_documents (Compare *compare);

/* compare-table.c: the document that a run belongs to, or NULL where it is closed. */
QnDocument *qn_compare_find_document (Compare *compare, QnRun *run);

/* What distinguishes a run from the others on show: its label, with the method where that is needed; its
 * project; or both. The caller frees it. */
char *qn_compare_dup_title (Compare *compare, QnRun *run);

void qn_compare_fill_table (Compare *compare);

/* Curves that share axes lie in one plot, the plots below each other. */
void qn_compare_draw_curves (GtkDrawingArea *area, cairo_t *cr, int width, int height,
                             gpointer compare);
