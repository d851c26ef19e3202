/* Force: drag from a point of a block into the direction of the force. */
#include "app/canvas.h"

#include "doc/edit.h"
#include <glib/gi18n.h>

typedef struct Force {
  QnId block;
  gboolean live;
  QnVec2 vector, at;
} Force;

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  const Force *force = data;
  return qn_edit_add_force (model, force->block, force->live, force->vector, force->at,
                            error);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
  if (pick.kind != QN_PICK_BLOCK)
    return;
  gesture->from = gesture->to = event->point;
  gesture->from_screen = event->screen;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  gesture->to = event->point;
  if (event->modifiers & GDK_SHIFT_MASK) {
    QnVec2 d = qn_vec2_sub (gesture->to, gesture->from);
    if (fabs (d.x) > fabs (d.y))
      gesture->to.y = gesture->from.y;
    else
      gesture->to.x = gesture->from.x;
  }
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (!qn_canvas_is_in_gesture (canvas))
    return;
  qn_canvas_set_in_gesture (canvas, FALSE);
  QnPick pick = qn_canvas_pick (canvas, gesture->from_screen, 1u << QN_PICK_BLOCK);
  QnVec2 direction = qn_vec2_sub (gesture->to, gesture->from);
  double length = qn_vec2_length (direction);
  if (pick.kind != QN_PICK_BLOCK || length == 0.0 || !qn_canvas_is_drag (canvas, event))
    return;
  const QnToolSettings *settings = qn_canvas_get_tool_settings (canvas);
  Force force = { pick.id, settings->live,
                  qn_vec2_scale (settings->force / length, direction), gesture->from };
  qn_canvas_edit (canvas, _ ("Add Force"), NULL, edit_add, &force);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (!qn_canvas_is_in_gesture (canvas))
    return;
  QnVec2 a = qn_canvas_to_screen (canvas, gesture->from);
  QnVec2 b = qn_canvas_to_screen (canvas, gesture->to);
  double angle = atan2 (b.y - a.y, b.x - a.x);
  cairo_set_source_rgb (cr, 0.8, 0.1, 0.1);
  cairo_set_line_width (cr, 2.0);
  cairo_move_to (cr, a.x, a.y);
  cairo_line_to (cr, b.x, b.y);
  cairo_stroke (cr);
  cairo_move_to (cr, b.x, b.y);
  cairo_line_to (cr, b.x - 12.0 * cos (angle - 0.4), b.y - 12.0 * sin (angle - 0.4));
  cairo_line_to (cr, b.x - 12.0 * cos (angle + 0.4), b.y - 12.0 * sin (angle + 0.4));
  cairo_close_path (cr);
  cairo_fill (cr);
}

const QnTool qn_tool_force = {
  .name = "force",
  .icon = "quoin-force-symbolic",
  .label = N_ ("Force"),
  .hint =
    N_ ("Drag from a point of a block in the direction of the force; its size is in the "
        "panel"),
  .accel = "f",
  .magnetic = TRUE,
  .press = press,
  .motion = motion,
  .release = release,
  .draw = draw,
};
