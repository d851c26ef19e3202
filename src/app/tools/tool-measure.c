/* Measure: the distance between two points. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  /* The second of two clicks is the end. */
  if (canvas->in_gesture && gesture->dragging) {
    gesture->to = event->point;
    return;
  }
  gesture->from = gesture->to = event->point;
  gesture->from_screen = event->screen;
  qn_canvas_set_in_gesture (canvas, TRUE);
  gesture->dragging = TRUE;
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->gesture.dragging)
    canvas->gesture.to = event->point;
}

/* The measure stays until the next press. */
static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (gesture->to.x != gesture->from.x || gesture->to.y != gesture->from.y
      || qn_canvas_is_drag (canvas, event))
    gesture->dragging = FALSE;
}

/* A length is marked off in the pointer's direction, or at an angle. */
static void
complete (QnCanvas *canvas)
{
  canvas->gesture.dragging = FALSE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
  QnVec2 corner = qn_vec2 (gesture->to.x, gesture->from.y);
  qn_canvas_draw_dimension (canvas, cr, gesture->from, gesture->to);
  if (gesture->from.x == gesture->to.x || gesture->from.y == gesture->to.y)
    return;
  qn_canvas_draw_dimension (canvas, cr, gesture->from, corner);
  qn_canvas_draw_dimension (canvas, cr, corner, gesture->to);
}

const QnTool qn_tool_measure = {
  .name = "measure",
  .icon = "quoin-measure-symbolic",
  .label = N_ ("Measure"),
  .hint = N_ ("Drag from point to point"),
  .accel = "m",
  .magnetic = TRUE,
  .numbers_label = N_ ("length; angle"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_ANGLE },
  .press = press,
  .motion = motion,
  .release = release,
  .numbers = qn_gesture_line_numbers,
  .complete = complete,
  .draw = draw,
};
