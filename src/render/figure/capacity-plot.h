/* A capacity curve and what it is held against: spectral acceleration over displacement. */
#ifndef QN_RENDER_CAPACITY_PLOT_H
#define QN_RENDER_CAPACITY_PLOT_H

#include "core/capacity/capacity.h"
#include "render/backend/output.h"

/* A limit state on the plot; labels are borrowed. */
typedef struct QnCapacityMark {
  const char *capacity_label, *demand_label; /* "SLV: capacity", … */
  QnCapacityState state;
} QnCapacityMark;

typedef struct QnCapacityPlot {
  const char *title; /* or NULL */
  const char *x_label, *y_label, *curve_label, *spectrum_label;
  const QnCapacity *capacity;
  const QnSpectrum *spectrum; /* NULL: the curve alone */
  const QnCapacityMark *marks;
  size_t mark_count;
  bool monochrome;
} QnCapacityPlot;

/* Draws the plot on a surface of this size, px, a point being `unit` px. */
void qn_capacity_plot_draw (const QnCapacityPlot *plot, cairo_t *cr, double width,
                            double height, double unit);

/* Writes the plot as qn_page_export() does. */
bool qn_capacity_plot_export (const QnCapacityPlot *plot, const char *path,
                              const QnOutput *output, const QnMetadata *metadata,
                              GError **error);

#endif
