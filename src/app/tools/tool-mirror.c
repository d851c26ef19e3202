/* Mirror: draw the line; Control, or the switch in the panel, keeps the original. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

typedef struct Mirror {
  QnPartSet set;
  QnTransform transform;
  gboolean keep;
} Mirror;

static gboolean
edit_mirror (QnProject *draft, gpointer data, GError **error)
{
  const Mirror *mirror = data;
  return mirror->keep
           ? qn_edit_copy_all (draft, mirror->set, mirror->transform, 1, error)
           : qn_edit_transform_all (draft, mirror->set, mirror->transform, error);
}

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 a = gesture->from, b = gesture->to;
  QnPartSet set = qn_canvas_dup_parts (canvas);
  Mirror mirror = { set, qn_transform_mirror (a, b),
                    qn_canvas_get_tool_settings (canvas)->mirror_copy };
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (a.x != b.x || a.y != b.y)
    qn_canvas_edit_project (canvas, _ ("Mirror"), NULL, edit_mirror, &mirror);
  qn_part_set_clear (&set);
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
