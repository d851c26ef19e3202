/* Mirror: draw the line; Control, or the switch in the panel, keeps the original. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 a = gesture->from, b = gesture->to;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (a.x != b.x || a.y != b.y)
    qn_canvas_transform (canvas, _ ("Mirror"), NULL, qn_transform_mirror (a, b),
                         qn_canvas_get_tool_settings (canvas)->mirror_copy ? 1 : 0);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_moved (canvas, cr, qn_transform_mirror (gesture->from, gesture->to));
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_mirror = {
  .name = "mirror",
  .icon = "quoin-mirror-symbolic",
  .label = N_ ("Mirror"),
  .hint = N_ ("Drag the line about which to mirror what is selected; Shift holds it "
              "straight"),
  .accel = "y",
  QN_GESTURE_LINE,
  .complete = complete,
  .draw = draw,
};
