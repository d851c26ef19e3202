/* Energies of an analysis in time over its time. */
#ifndef QN_DOC_ENERGY_PLOT_H
#define QN_DOC_ENERGY_PLOT_H

#include "core/result/result.h"
#include "render/figure/data-plot.h"

#include <glib.h>

/* The kinds of QnEnergyKind, and behind them what the balance is wrong by. */
#define QN_ENERGY_CURVES (QN_ENERGY_KIND_COUNT + 1)

/* Samples of a history, a few hundred at most: what lies between is left out. */
typedef struct QnEnergyPlot {
  double *times;      /* owned, s */
  double *energies;   /* owned, QN_ENERGY_CURVES x count, over `unit` */
  gsize count;        /* 0: there is nothing to show */
  double unit;        /* J: 1, 1e3 or 1e6, by the largest energy */
  const char *symbol; /* "J", "kJ", "MJ" */
} QnEnergyPlot;

/* Free with qn_energy_plot_clear(). */
void qn_energy_plot_init (QnEnergyPlot *plot, const QnHistory *history);
void qn_energy_plot_clear (QnEnergyPlot *plot);

/* "input" …, translated; colour of its curve as of qn_series_color(), and whether it is dashed. */
const char *qn_energy_text (int curve);
int qn_energy_series (int curve);
gboolean qn_energy_is_dashed (int curve);

/* The sample that is nearest to a time. */
gsize qn_energy_plot_find (const QnEnergyPlot *plot, double time);

/* Draws it on a surface of this size, px, a point being `unit` px. */
void qn_energy_plot_draw (const QnEnergyPlot *plot, gboolean legend, cairo_t *cr,
                          double width, double height, double unit, QnPlotPlace *place);

/* Writes it with a legend as qn_page_export() does. title: or NULL. */
gboolean qn_energy_plot_export (const QnEnergyPlot *plot, const char *title,
                                gboolean monochrome, const char *path,
                                const QnOutput *output, const QnMetadata *metadata,
                                GError **error);

#endif
