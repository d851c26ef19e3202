/* Results of one or several projects side by side: their curves over the same axes, their mechanisms on one
 * sheet, and both as tables. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"
#include "io/project/project.h"
#include "render/figure/curve-plot.h"
#include "render/figure/plot.h"

/* A result with its project; all borrowed. */
typedef struct QnSheetRun {
  const QnProject *project;
  const QnContacts *contacts;
  const QnResult *result;
  const char *name; /* of its own: tells results of one project apart */
} QnSheetRun;

/* Title of the project, or else the name of its file without folders. */
const char *qn_project_title (const QnProject *project);

/* What a picture says of the project that it shows, which it borrows from; `model` is the name of
 * its file without folders. `project` may be NULL. */
void qn_project_get_metadata (const QnProject *project, QnMetadata *metadata);

/* Whether a file of this name (nullable) is a table: the ending .csv. */
gboolean qn_is_table (const char *path);

typedef struct QnCurveSheet {
  const char *title; /* or NULL */
  /* The curves end at this displacement, m or rad; 0: where they have nothing more to tell, */
  double until;
  bool whole; /* or at their own end; tables do where `until` is 0 */
  const QnReferenceLine *references;
  size_t reference_count;
  gboolean monochrome;
} QnCurveSheet;

/* Writes the load-displacement curves as PNG, SVG, PDF or, by the ending .csv, a table: `run`, `step`,
 * `displacement [m or rad]`, `multiplier [-]`, `mark` ("limit point", "collapse" or nothing) for every point.
 * Curves without axes in common are QN_IO_ERROR_INVALID. */
gboolean qn_curve_sheet_export (const QnCurveSheet *sheet, const QnSheetRun *runs,
                                gsize count, const char *path, const QnOutput *output,
                                GError **error);

/* The energies of one analysis in time, over its time. */
gboolean qn_energy_sheet_export (const QnCurveSheet *sheet, const QnSheetRun *run,
                                 const char *path, const QnOutput *output,
                                 GError **error);

/* Writes their mechanisms at one scale, or where there is none the deformed structure, as PNG, SVG, PDF or,
 * by the ending .csv, a table: `project`, `title`, `outcome`, `multiplier [-]` (empty where there is none),
 * `mechanism`, `steps`, a row each. columns: 0, chosen for the format of the page; title: or NULL. */
gboolean qn_comparison_export (const QnSheetRun *runs, gsize count, int columns,
                               const char *title, gboolean monochrome, const char *path,
                               const QnOutput *output, GError **error);

/* Every joint that has opened at the last equilibrium, the widest first: its blocks, its largest width and
 * where that is, the mean over its length, and the number of its line of joints. Only the header where there is no equilibrium. */
gboolean qn_cracks_csv_write (const char *path, const QnProject *project,
                              const QnContacts *contacts, const QnResult *result,
                              GError **error);

/* The kinds of QnEnergyKind, then the error of the balance. */
#define QN_ENERGY_CURVES (QN_ENERGY_KIND_COUNT + 1)

/* A line for each of them at the same times, a few hundred at most: what lies between is left out. The
 * unit, "J", "kJ" or "MJ", goes by the largest energy. */
QnPlot *qn_energy_plot (const QnHistory *history, const char **unit);
