/* Axes of plots: ranges, round ticks, and how they are drawn. */
#pragma once

#include <cairo.h>
#include <stdbool.h>

/* Size of the numbers at the ticks and of the axes' names, pt. */
#define QN_TYPE_TICK  7.5
#define QN_TYPE_LABEL 8.5

/* Axes aim at a tick every so many pt. */
#define QN_TICK_SPACING_X 62.0
#define QN_TICK_SPACING_Y 36.0

typedef struct QnAxis {
  double low, high;   /* in displayed units, of a logarithmic axis their decades */
  double step, first; /* of the ticks */
  bool log;
  double start, end; /* px */
  /* Instead of ticks: names at 0, 1, …, borrowed; NULL: numbers. */
  const char *const *names;
  int name_count;
} QnAxis;

/* Place of a value, px. */
double qn_axis_place (const QnAxis *axis, double value);

/* Ticks at multiples of a nice step over a length in px; an end is rounded to the next tick where
 * it is near. */
void qn_axis_set (QnAxis *axis, double low, double high, double length, double spacing);

/* Lets a linear axis end at these values instead, with its ticks as they are. */
void qn_axis_cut (QnAxis *axis, double low, double high);

/* Ticks at decades, at most so many that they do not touch; short axes divide them. */
void qn_axis_set_log (QnAxis *axis, double low, double high, double length,
                      double spacing);

/* One tick per name, the first at the end of the axis that is drawn on top or right. */
void qn_axis_set_names (QnAxis *axis, const char *const *names, int count);

/* Width of the widest number or name at a vertical axis, px. */
double qn_axis_text_width (const QnAxis *axis, cairo_t *cr, double unit);

/* Grid lines, numbers and the frame of a plot; `unit`: px per typographic point. */
void qn_axes_draw (const QnAxis *x, const QnAxis *y, cairo_t *cr, double unit,
                   bool monochrome);

/* Names of the axes: the vertical one at px `left`, the horizontal one above px `bottom`. */
void qn_axes_draw_names (const QnAxis *x, const QnAxis *y, cairo_t *cr, double unit,
                         const char *x_name, const char *y_name, double left,
                         double bottom, bool monochrome);
