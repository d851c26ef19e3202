/* A plot as data: points, lines, bands, bars and coloured cells over two axes. One function lays it
 * out and draws it, in files and in the window. */
#pragma once

#include "render/backend/output.h"
#include "render/drawing/scene.h"
#include "render/figure/figure.h"

typedef enum {
  QN_MARKS_POINTS,     /* a marker at every x, y */
  QN_MARKS_LINE,       /* from x, y to x, y */
  QN_MARKS_STEPS,      /* the same, level up to the next x */
  QN_MARKS_BAND,       /* filled, in steps, between y and y_end */
  QN_MARKS_RECTANGLES, /* from x, y to x_end, y_end */
  QN_MARKS_WHISKERS,   /* a thin level line from x to x_end at y, with ends */
  QN_MARKS_LEVEL       /* a thin line over the whole plot at y */
} QnMarkKind;

/* Colours other than those of the series. */
enum { QN_SERIES_INK = -1, QN_SERIES_REFERENCE = -2 };

/* `count` marks of one kind; 0 with a label: in the legend alone. Arrays and texts are borrowed; arrays
 * that a kind does not need are NULL. Values that are not finite, and those without a place on a logarithmic
 * axis, are left out. */
typedef struct QnMarks {
  QnMarkKind kind;
  const char *label;                   /* in the legend; NULL: not there */
  int series;                          /* as of qn_series_color() */
  double dash;                         /* pt; 0: none */
  const double *x, *y, *x_end, *y_end; /* y of lines: not-a-number is a gap */
  const double *values; /* NULL: the colour of the series; else that of the colour bar */
  size_t count;
  QnMarker marker; /* of points; an arrow head begins at its point */
  double size;     /* of the marker, pt; 0: the more there are, the smaller */
  double angle;    /* of the marker */
} QnMarks;

#define QN_USUAL_DASH 4.0

typedef struct QnPlotAxis {
  const char *label;
  bool log;         /* decades */
  bool from_zero;   /* the axis holds 0, unless it is logarithmic */
  double factor;    /* from values to what is written; 0: 1 */
  double room;      /* share of the largest value that is left free beyond it */
  double low, high; /* the part that is shown; both 0: all */
  const char *const
    *names; /* names at 0, 1, … instead of numbers, from the top; or NULL */
  size_t name_count;
} QnPlotAxis;

typedef struct QnPlot {
  const char *title; /* or NULL */
  QnPlotAxis x, y;
  const char *bar_title; /* of the colour bar, where marks have values; or NULL */
  bool monochrome, without_legend;
  GArray *marks;   /* of QnMarks, in the order of drawing */
  GPtrArray *kept; /* memory that goes with the plot */
} QnPlot;

/* Where a drawn plot lies, px: values at zero + scale * value, with linear axes; and the frame. */
typedef struct QnPlotPlace {
  double x_zero, x_scale, y_zero, y_scale;
  QnBox frame;
} QnPlotPlace;

/* Axes that hold 0; texts are borrowed. */
QnPlot *qn_plot_new (const char *x_label, const char *y_label);
void qn_plot_free (QnPlot *plot);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnPlot, qn_plot_free)

/* Frees `memory` of g_malloc() with the plot; returns it. */
void *qn_plot_keep (QnPlot *plot, void *memory);

/* Adds marks; what comes back is valid until the next ones. */
QnMarks *qn_plot_add (QnPlot *plot, QnMarks marks);

/* The same by what most have; points with a marker of their own. */
QnMarks *qn_plot_mark (QnPlot *plot, QnMarkKind kind, const char *label, int series,
                       const double *x, const double *y, size_t count);
QnMarks *qn_plot_points (QnPlot *plot, const char *label, int series, const double *x,
                         const double *y, size_t count, QnMarker marker, double size);

/* Draws the plot into a rectangle, a point being `unit` px. `place` may be NULL. */
void qn_plot_draw (const QnPlot *plot, cairo_t *cr, double unit, const QnFrame *frame,
                   QnPlotPlace *place);

/* Writes the plot as qn_page_export() does. */
bool qn_plot_export (const QnPlot *plot, const char *path, const QnOutput *output,
                     const QnMetadata *metadata, GError **error);
