/* The curves of a plot as a table. */
#ifndef QN_CLI_CURVE_TABLE_H
#define QN_CLI_CURVE_TABLE_H

#include "render/figure/curve-plot.h"

/* Writes `run`, `step`, `displacement [m or rad]`, `multiplier [-]`, `mark` ("limit point",
 * "collapse" or nothing) for every point of every curve. */
gboolean qn_curve_table_write (const char *path, const QnCurve *curves, gsize count,
                               GError **error);

#endif
