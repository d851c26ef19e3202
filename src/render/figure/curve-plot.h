/* Load-displacement curves: several runs in one plot with ticks, units, marked collapse and
 * limit points and reference lines. */
#ifndef QN_RENDER_CURVE_PLOT_H
#define QN_RENDER_CURVE_PLOT_H

#include "core/model/model.h"
#include "core/result/curve-motion.h"
#include "render/backend/output.h"

/* One run. */
typedef struct QnCurve {
  const char *label; /* in the legend; borrowed, may be NULL where there is one curve */
  double *x;         /* displacement in SI (m or rad), `count` values; owned */
  double *y;         /* multiplier; owned */
  bool in_time;      /* of an analysis in time: x is the time, s, y the displacement */
  bool settles;      /* x is a settlement, y what the supports that settle take, N */
  char *set;         /* whose multiplier y is; NULL: that of the live loads. Owned */
  bool
    since_dead; /* displacements leave out what the dead load has moved, which is not 0 */
  const char
    *component;  /* "ux", "uy" or "rz": what moves; NULL: the plot's label says it */
  bool rotation; /* what moves turns: rad instead of m */
  size_t count;
  ptrdiff_t limit_point;    /* index of the point marked as first limit, or -1 */
  ptrdiff_t collapse_point; /* index of the point marked as collapse, or -1 */
  ptrdiff_t dot;            /* index of the moving dot of an animation, or -1 */
  bool runs_on;             /* cut at its last point: the motion goes on beyond */
} QnCurve;

/* A horizontal line with a label, for a published value. */
typedef struct QnReferenceLine {
  double y;
  const char *label;
} QnReferenceLine;

typedef struct QnCurvePlot {
  const char *title;   /* or NULL */
  const char *x_label; /* without unit, or NULL: "Displacement ux", and since when */
  const char
    *x_unit; /* unit of x as it is, "" for none; NULL: x is in m or rad, or s where
                          the first curve is in time */
  const char *y_label; /* or NULL: "Load multiplier", or the displacement in time */
  bool x_log, y_log;   /* decades: values that are not positive are left out */
  bool points;         /* every point of the curves is marked */
  const QnCurve *curves;
  size_t curve_count;
  const QnReferenceLine *references;
  size_t reference_count;
  bool monochrome;
} QnCurvePlot;

/* The curve of a displacement over the steps of a result, empty where there is none: the multiplier of the loads
 * that its last stage drives, at all steps. Of an analysis in time its history, of a settlement the
 * reaction. False when memory runs out. */
bool qn_curve_from_result (QnCurve *curve, const QnModel *model, const QnResult *result,
                           QnCurveMotion motion);

/* Whether two curves may be drawn over the same axes. */
bool qn_curve_shares_axes (const QnCurve *a, const QnCurve *b);

/* Where a curve has nothing more to tell: from near its peak on the multiplier stays as it is to
 * the end, while the displacement grows to many times what it was. Gives a displacement a little
 * beyond the peak; false where the whole curve matters, as where it descends from its peak. */
bool qn_curve_get_end (const QnCurve *curve, double *end);

/* Ends the curve where it first leaves -until .. until; marks beyond are left out. */
void qn_curve_cut (QnCurve *curve, double until);

/* Ends the curve at the end above and marks it as running on; marks beyond move there. */
void qn_curve_cut_runaway (QnCurve *curve);

void qn_curve_clear (QnCurve *curve);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnCurve, qn_curve_clear)

/* Writes the plot as qn_page_export() does. */
bool qn_curve_export (const QnCurvePlot *plot, const char *path, const QnOutput *output,
                      const QnMetadata *metadata, GError **error);

/* Draws the plot into a rectangle of a page. */
void qn_curve_plot_draw (const QnCurvePlot *plot, cairo_t *cr, const QnPage *page,
                         double x, double y, double width, double height);

#endif
