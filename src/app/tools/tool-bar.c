/* Reinforcing bar: from point to point, across joints. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-bar.h"
#include <glib/gi18n.h>

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  const QnGesture *gesture = data;
  return qn_edit_draw_bar (model, gesture->from, gesture->to, error);
}

static void
complete (QnCanvas *canvas)
{
  QnGesture drawn = *qn_canvas_get_gesture (canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
  /* The new bar is selected, so that its numbers are there. */
  if ((drawn.from.x != drawn.to.x || drawn.from.y != drawn.to.y)
      && qn_canvas_edit (canvas, _ ("Add Bar"), NULL, edit_add, &drawn))
    qn_selection_set_item (qn_canvas_get_selection (canvas), QN_ITEM_BAR,
                           (QnId) qn_canvas_get_model (canvas)->bar_count - 1);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_bar = {
  .name = "bar",
  .icon = "quoin-bar-symbolic",
  .label = N_ ("Reinforcing Bar"),
  .hint = N_ ("Drag from end to end, across the joints at right angles; Shift holds it "
              "straight; law and diameter are in the panel Analysis"),
  .accel = "e",
  QN_GESTURE_LINE,
  .complete = complete,
  .draw = draw,
};
