/* Load-displacement curves: several runs in one plot with units, marked collapse and
 * limit points and reference lines. */
#pragma once

#include "core/model/model.h"
#include "core/result/curve-motion.h"
#include "render/figure/plot.h"

/* One run. */
typedef struct QnCurve {
  const char *label; /* in the legend; borrowed, may be NULL where there is one curve */
  double *x;         /* displacement in SI (m or rad), `count` values; owned */
  double *y;         /* multiplier; owned */
  bool in_time;      /* of an analysis in time: x is the time, s, y the displacement */
  bool settles;      /* x is a settlement, y the reaction of the settling supports, N */
  char *set;         /* load set of the multiplier y; NULL: live loads. Owned */
  char *loads, *loaded; /* the loads at multiplier 1, and the bodies they act on, as
                           text that is equal for equal loads; owned */
  size_t bodies;        /* of the structure */
  bool
    since_dead; /* displacements count from the dead load, whose displacements are not 0 */
  const char
    *component;  /* "ux", "uy" or "rz": component of x; NULL: see the label of the plot */
  bool rotation; /* x in rad instead of m */
  size_t count;
  double size; /* of the structure in linear geometry, m: no motion is as large; 0: any */
  ptrdiff_t limit_point;    /* index of the point marked as first limit, or -1 */
  ptrdiff_t collapse_point; /* index of the point marked as collapse, or -1 */
  ptrdiff_t dot;            /* index of the moving dot of an animation, or -1 */
  bool runs_on;             /* cut at its last point: the motion goes on beyond */
} QnCurve;

/* Share of the largest value that plots of curves leave free above it. */
#define QN_CURVE_ROOM 0.04

/* A horizontal line with a label, for a published value. */
typedef struct QnReferenceLine {
  double y;
  const char *label;
} QnReferenceLine;

/* Reads "0.36" or "0.36=Ferris and Tin-Loi"; the label is borrowed, NULL where there is none. False
 * where the text is neither. */
bool qn_reference_line_parse (const char *text, QnReferenceLine *line);

/* The curve of a displacement over the steps of a result, empty where there is none: the
 * multiplier of the loads that its last stage drives, at all steps. Of an analysis in
 * time its history, of a settlement the reaction. */
void qn_curve_from_result (QnCurve *curve, const QnModel *model, const QnResult *result,
                           QnCurveMotion motion);

/* Whether two curves may be drawn over the same axes: multipliers where they multiply the same
 * kinds of loads with the same directions and sizes, in structures of equally many bodies also the
 * same bodies, whatever the names of their sets. */
bool qn_curve_shares_axes (const QnCurve *a, const QnCurve *b);

/* Ends the curve where it first leaves -until .. until; marks beyond are left out. */
void qn_curve_cut (QnCurve *curve, double until);

/* Ends a curve whose motion grows without limit a little beyond its peak and marks it as running on; marks
 * beyond move there. */
void qn_curve_cut_runaway (QnCurve *curve);

void qn_curve_clear (QnCurve *curve);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnCurve, qn_curve_clear)

/* The plot of curves that share axes, with their marks; both arrays are borrowed. */
QnPlot *qn_curve_plot (const QnCurve *curves, size_t count,
                       const QnReferenceLine *references, size_t reference_count);
