/* Measure: the distance between two points. */
#include "app/canvas.h"

#include <glib/gi18n.h>

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  gesture->from = gesture->to = event->point;
  qn_canvas_set_in_gesture (canvas, TRUE);
  gesture->dragging = TRUE;
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (gesture->dragging)
    gesture->to = event->point;
}

/* The measure stays until the next press. */
static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  (void) event;
  qn_canvas_get_gesture (canvas)->dragging = FALSE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (!qn_canvas_is_in_gesture (canvas))
    return;
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
  .press = press,
  .motion = motion,
  .release = release,
  .draw = draw,
};
