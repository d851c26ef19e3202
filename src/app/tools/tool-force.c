/* Force: drag from a point of a block, or from a node of beams, into the direction of the force. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "app/widgets/settings.h"
#include "doc/edit/edit.h"
#include <glib/gi18n.h>
#include <math.h>

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->in_gesture || qn_canvas_pick_node (canvas, event->screen) != QN_NONE
      || qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK).kind
           == QN_PICK_BLOCK)
    qn_gesture_press (canvas, event);
}

static void
add (QnCanvas *canvas, QnVec2 vector)
{
  QnPick pick = qn_canvas_pick (canvas, canvas->gesture.from_screen, 1u << QN_PICK_BLOCK);
  const QnId node = qn_canvas_pick_node (canvas, canvas->gesture.from_screen);
  const gboolean live = canvas->settings->live;
  const QnVec2 at = canvas->gesture.from;
  QnCanvasDraft draft;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if ((pick.kind == QN_PICK_BLOCK || node != QN_NONE)
      && qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (
      canvas, &draft, _ ("Add Force"), NULL,
      node != QN_NONE
        ? qn_edit_add_node_force (draft.model, node, live, vector, &draft.error)
        : qn_edit_add_force (draft.model, pick.id, live, vector, at, &draft.error));
}

static void
complete (QnCanvas *canvas)
{
  QnVec2 direction = qn_vec2_sub (canvas->gesture.to, canvas->gesture.from);
  double length = qn_vec2_length (direction);
  double size = canvas->settings->force;
  if (length > 0.0)
    add (canvas, qn_vec2_scale (size / length, direction));
  else
    qn_canvas_set_in_gesture (canvas, FALSE);
}

/* The size, in the pointer's direction or at an angle. */
static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  QnVec2 force;
  if (!qn_gesture_typed_way (&canvas->gesture, values, count, &force) || values[0] == 0.0)
    return FALSE;
  add (canvas, force);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
  QnVec2 a = qn_canvas_to_screen (canvas, gesture->from);
  QnVec2 b = qn_canvas_to_screen (canvas, gesture->to);
  double angle = atan2 (b.y - a.y, b.x - a.x);
  cairo_set_source_rgb (cr, 0.8, 0.1, 0.1);
  cairo_set_line_width (cr, 2.0);
  qn_canvas_trace_line (canvas, cr, gesture->from, gesture->to);
  cairo_stroke (cr);
  cairo_move_to (cr, b.x, b.y);
  cairo_line_to (cr, b.x - 12.0 * cos (angle - 0.4), b.y - 12.0 * sin (angle - 0.4));
  cairo_line_to (cr, b.x - 12.0 * cos (angle + 0.4), b.y - 12.0 * sin (angle + 0.4));
  cairo_close_path (cr);
  cairo_fill (cr);
  QnUnits units = qn_settings_get_units ();
  g_autofree char *size =
    qn_units_format_full (units, QN_QUANTITY_FORCE, canvas->settings->force, 4);
  g_autofree char *turned = qn_gesture_dup_angle (gesture);
  g_autofree char *text = g_strdup_printf ("%s; %s", size, turned);
  qn_gesture_draw_words (canvas, cr, text, gesture->to);
}

const QnTool qn_tool_force = {
  .name = "force",
  .icon = "quoin-force-symbolic",
  .label = N_ ("Force"),
  .hint =
    N_ ("Drag from a point of a block or an end of a beam in the direction of the force; "
        "its size is in the panel, or typed"),
  .accel = "f",
  .magnetic = TRUE,
  .numbers_label = N_ ("size; angle"),
  .quantities = { QN_QUANTITY_FORCE, QN_QUANTITY_ANGLE },
  .press = press,
  .motion = qn_gesture_motion_straight,
  .release = qn_gesture_release,
  .numbers = numbers,
  .complete = complete,
  .draw = draw,
};
