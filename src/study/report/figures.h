/* Figures of a study: PNG, SVG or PDF by the ending of the path. */
#pragma once

#include "render/figure/plot.h"
#include "study/report/table.h"

/* In the order of the list of study-page.ui, which has all but the last. */
typedef enum {
  QN_STUDY_FIGURE_CUMULATIVE, /* share of the cases up to a value, with its interval: of a multiplier
                                 the fragility */
  QN_STUDY_FIGURE_SCATTER,   /* an output over a parameter, a point for every case */
  QN_STUDY_FIGURE_HISTOGRAM, /* of an output */
  QN_STUDY_FIGURE_TORNADO, /* sensitivity: Sobol indices of a plan "sobol", ranges of a plan
                                 "one-at-a-time", else rank correlations */
  QN_STUDY_FIGURE_ENVELOPE, /* least and greatest value of an output over a parameter: of
                               a vehicle by its position */
  QN_STUDY_FIGURE_SURFACE, /* an output over two parameters: cells of a grid, else points */
  QN_STUDY_FIGURE_MECHANISMS, /* a typical case of every shape or kind of mechanism */
  QN_STUDY_FIGURE_COUNT
} QnStudyFigureKind;

typedef struct QnStudyFigure {
  QnStudyFigureKind kind;
  int column;        /* of the output (qn_table_find()); MECHANISMS: not used */
  int parameters[2]; /* columns: one for SCATTER and ENVELOPE, two for SURFACE */
  bool monochrome;
} QnStudyFigure;

/* Spelling on the command line: "scatter", … */
extern const char *const qn_study_figure_names[QN_STUDY_FIGURE_COUNT];

/* The plot of a figure (not MECHANISMS), which borrows from the table. NULL with an error as below. */
QnPlot *qn_study_figure_plot (const QnStudyFigure *figure, const QnTable *table,
                              GError **error);

/* Writes the figure with metadata: title, file and digest of the project, program.
 * Errors: QN_IO_ERROR where the table has nothing to show, QN_RENDER_ERROR. */
gboolean qn_study_figure_export (const QnStudyFigure *figure, const QnTable *table,
                                 const char *path, const QnOutput *output,
                                 GError **error);
