#include "app/tool-rectangle.h"

#include <glib/gi18n.h>

void
qn_rectangle_motion (QnCanvas *canvas, const QnToolEvent *event)
{
  if (qn_canvas_is_in_gesture (canvas))
    qn_canvas_get_gesture (canvas)->to = event->point;
}

gboolean
qn_rectangle_press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (qn_canvas_is_in_gesture (canvas)) {
    gesture->to = event->point;
    return TRUE;
  }
  gesture->from = gesture->to = event->point;
  gesture->from_screen = event->screen;
  qn_canvas_set_in_gesture (canvas, TRUE);
  return FALSE;
}

gboolean
qn_rectangle_release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (!qn_canvas_is_in_gesture (canvas) || !qn_canvas_is_drag (canvas, event))
    return FALSE;
  qn_canvas_get_gesture (canvas)->to = event->point;
  return TRUE;
}

gboolean
qn_rectangle_numbers (QnCanvas *canvas, const double *values, int count)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (count != 2)
    return FALSE;
  /* Towards the side on which the pointer is. */
  double right = gesture->to.x < gesture->from.x ? -1.0 : 1.0;
  double up = gesture->to.y < gesture->from.y ? -1.0 : 1.0;
  gesture->to =
    qn_vec2 (gesture->from.x + right * values[0], gesture->from.y + up * values[1]);
  return TRUE;
}

void
qn_rectangle_draw (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  qn_canvas_trace (canvas, cr, corners, G_N_ELEMENTS (corners));
  cairo_set_source_rgba (cr, 0.1, 0.4, 0.9, 0.15);
  cairo_fill_preserve (cr);
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
  cairo_set_line_width (cr, 1.5);
  cairo_stroke (cr);
  double low = MIN (a.y, b.y), right = MAX (a.x, b.x);
  qn_canvas_draw_dimension (canvas, cr, qn_vec2 (a.x, low), qn_vec2 (b.x, low));
  qn_canvas_draw_dimension (canvas, cr, qn_vec2 (right, a.y), qn_vec2 (right, b.y));
}

/* ---- a single rectangular block ---- */

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  QnCanvas *canvas = data;
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 a = gesture->from, b = gesture->to;
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  QnBlockStyle style = qn_canvas_get_tool_settings (canvas)->wall.style;
  return qn_edit_add_block (model, corners, G_N_ELEMENTS (corners), style, error);
}

static void
complete (QnCanvas *canvas)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (gesture->from.x != gesture->to.x && gesture->from.y != gesture->to.y)
    qn_canvas_edit (canvas, _ ("Add Block"), NULL, edit_add, canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  if (qn_rectangle_press (canvas, event))
    complete (canvas);
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (qn_rectangle_release (canvas, event))
    complete (canvas);
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  if (!qn_rectangle_numbers (canvas, values, count))
    return FALSE;
  complete (canvas);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (qn_canvas_is_in_gesture (canvas))
    qn_rectangle_draw (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_rectangle = {
  .name = "rectangle",
  .icon = "quoin-rectangle-symbolic",
  .label = N_ ("Rectangular Block"),
  .hint = N_ ("Drag a rectangle, or click a corner and type width; height"),
  .accel = "r",
  .magnetic = TRUE,
  .press = press,
  .motion = qn_rectangle_motion,
  .release = release,
  .numbers = numbers,
  .draw = draw,
};
