/* Plots of tables: points, curves, bands, bars and coloured cells over two axes. */
#ifndef QN_RENDER_DATA_PLOT_H
#define QN_RENDER_DATA_PLOT_H

#include "render/backend/output.h"

#include <stddef.h>

typedef enum {
  QN_MARKS_POINTS,     /* a dot at every x, y */
  QN_MARKS_LINE,       /* from x, y to x, y */
  QN_MARKS_STEPS,      /* the same, level up to the next x */
  QN_MARKS_BAND,       /* filled, in steps, between y and y_end */
  QN_MARKS_RECTANGLES, /* from x, y to x_end, y_end */
  QN_MARKS_WHISKERS    /* a thin level line from x to x_end at y, with ends */
} QnMarkKind;

/* `count` marks of one kind. Arrays are borrowed; those that a kind does not need are NULL. */
typedef struct QnMarks {
  QnMarkKind kind;
  const char *label; /* in the legend; NULL: not there */
  int series;        /* which colour of the series */
  bool dashed;
  const double *x, *y, *x_end, *y_end; /* y of lines: not-a-number is a gap */
  const double *values; /* NULL: the colour of the series; else that of the colour bar */
  size_t count;
} QnMarks;

typedef struct QnDataPlot {
  const char *title; /* or NULL */
  const char *x_label, *y_label;
  const char *bar_title;      /* of the colour bar, where marks have values */
  const char *const *y_names; /* names at y = 0, 1, … from the top; NULL: numbers */
  size_t y_name_count;
  bool x_from_zero, y_from_zero; /* the axis holds 0 */
  const QnMarks *marks;          /* in the order of drawing */
  size_t mark_count;
  bool monochrome;
} QnDataPlot;

/* Where the values of a drawn plot lie, px: x_zero + x_scale * x, and so for y. */
typedef struct QnPlotPlace {
  double x_zero, x_scale, y_zero, y_scale;
} QnPlotPlace;

/* Draws the plot on a surface of this size, px, a point being `unit` px. `place` may be NULL. */
void qn_data_plot_draw (const QnDataPlot *plot, cairo_t *cr, double width, double height,
                        double unit, QnPlotPlace *place);

/* Writes the plot as qn_page_export() does. */
bool qn_data_plot_export (const QnDataPlot *plot, const char *path,
                          const QnOutput *output, const QnMetadata *metadata,
                          GError **error);

#endif
