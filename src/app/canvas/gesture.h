/* Gestures between points. Between two: pressed at the one and released at the other, or clicked at both,
 * or clicked at the first and typed. Rectangles and lines share them; what becomes of the two
 * points is the tool's `edit`. */
#pragma once

#include "app/canvas/canvas.h"

/* Carries out what the gesture has, and ends it. */
void qn_gesture_complete (QnCanvas *canvas);

/* For QnTool.press, .motion and .release. */
void qn_gesture_press (QnCanvas *canvas, const QnToolEvent *event);
void qn_gesture_motion (QnCanvas *canvas, const QnToolEvent *event);
/* The same, level or upright where it is nearly so, and held to multiples of 15 degrees while Shift is
 * pressed. */
void qn_gesture_motion_straight (QnCanvas *canvas, const QnToolEvent *event);
void qn_gesture_release (QnCanvas *canvas, const QnToolEvent *event);

/* For QnTool.numbers: width and height towards the pointer; or length and angle of a line, the
 * angle that of the pointer where it is not given. */
gboolean qn_gesture_rectangle_numbers (QnCanvas *canvas, const double *values, int count);
gboolean qn_gesture_line_numbers (QnCanvas *canvas, const double *values, int count);

/* These, and what can be typed, as members of a QnTool that draws a line, or a rectangle. */
#define QN_GESTURE_LINE                                                                  \
  .magnetic = TRUE, .numbers_label = N_ ("length; angle"),                               \
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_ANGLE }, .press = qn_gesture_press,    \
  .motion = qn_gesture_motion_straight, .release = qn_gesture_release,                   \
  .numbers = qn_gesture_line_numbers
#define QN_GESTURE_RECTANGLE                                                             \
  .magnetic = TRUE, .wide = TRUE, .numbers_label = N_ ("width; height"),                 \
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH }, .press = qn_gesture_press,   \
  .motion = qn_gesture_motion, .release = qn_gesture_release,                            \
  .numbers = qn_gesture_rectangle_numbers

/* Lines of many points, kept in gesture.points, which a double click or Enter completes from the tool's
 * `least_points` of them on; two numbers are the next point, relative to the last one. */
void qn_gesture_press_point (QnCanvas *canvas, const QnToolEvent *event);
gboolean qn_gesture_point_numbers (QnCanvas *canvas, const double *values, int count);
/* Adds the points, and the pointer behind them, to the path of `cr`. */
void qn_gesture_trace_points (QnCanvas *canvas, cairo_t *cr);

/* What one typed number, a length in the direction of the pointer, or two, a length and an angle,
 * mean as a way from gesture.from; FALSE for any other count. */
gboolean qn_gesture_typed_way (const QnGesture *gesture, const double *values, int count,
                               QnVec2 *way);

/* A rectangle, filled lightly. */
void qn_gesture_draw_frame (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);
/* The same with its dimensions. */
void qn_gesture_draw_rectangle (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);
/* A line with its length. */
void qn_gesture_draw_line (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b);

/* Words beside a point. */
void qn_gesture_draw_words (QnCanvas *canvas, cairo_t *cr, const char *text, QnVec2 at);

/* The angle of the way from gesture.from to gesture.to, in words; the caller frees it. */
char *qn_gesture_dup_angle (const QnGesture *gesture);

/* A line with words beside its ends: what each is held by, as `dup_text` says. */
void qn_gesture_draw_held (QnCanvas *canvas, cairo_t *cr,
                           char *(*dup_text) (const QnModel *model, QnVec2 at));

/* Joints of an object that is not laid yet. */
void qn_gesture_draw_masonry (QnCanvas *canvas, cairo_t *cr, const QnMasonry *masonry);

/* The block's outline as a path, moved. */
void qn_gesture_trace_block (QnCanvas *canvas, cairo_t *cr, QnId block,
                             QnTransform transform);

/* Outlines of the selected blocks as a transform would put them. */
void qn_gesture_draw_moved (QnCanvas *canvas, cairo_t *cr, QnTransform transform);

/* Strokes the path twice, the first time wider, px: such a line is seen on any ground. */
void qn_gesture_stroke (cairo_t *cr, GdkRGBA below, double wide, GdkRGBA ink,
                        double narrow);

/* Fill and outline of everything that is about to be. */
void qn_gesture_paint (cairo_t *cr);
