/* A single rectangular block. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  QnCanvas *canvas = data;
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 a = gesture->from, b = gesture->to;
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  QnBlockStyle style =
    qn_tool_settings_get_block_style (qn_canvas_get_tool_settings (canvas));
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
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_rectangle (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_rectangle = {
  .name = "rectangle",
  .icon = "quoin-rectangle-symbolic",
  .label = N_ ("Rectangular Block"),
  .hint = N_ ("Drag a rectangle, or click a corner and type width; height"),
  .accel = "r",
  QN_GESTURE_RECTANGLE,
  .complete = complete,
  .draw = draw,
};
