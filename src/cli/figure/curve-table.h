/* The curves of a plot as a table. */
#ifndef QN_CLI_CURVE_TABLE_H
#define QN_CLI_CURVE_TABLE_H

#include "cli/base/picture.h"
#include "cli/figure/sheet-input.h"
#include "render/figure/curve-plot.h"

/* Fills `output` as qn_picture_output() does, for a picture or a table. */
QnExit qn_picture_or_table (const QnSubcommand *self, const QnPictureOptions *options,
                            QnOutput *output);

/* Whether a file of this name (nullable) is a table: the ending .csv. */
gboolean qn_is_table (const char *path);

/* Writes `run`, `step`, `displacement [m or rad]`, `multiplier [-]`, `mark` ("limit point",
 * "collapse" or nothing) for every point of every curve. */
gboolean qn_curve_table_write (const char *path, const QnCurve *curves, gsize count,
                               GError **error);

/* Writes what results of several projects amount to: `project`, `title`, `outcome`, `multiplier [-]`
 * (empty where there is none), `mechanism`, `steps`, a row each. */
gboolean qn_comparison_table_write (const char *path, const QnSheetItem *items,
                                    gsize count, GError **error);

#endif
