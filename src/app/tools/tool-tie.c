/* Tie: from point to point; an end on a block is fixed to it, elsewhere to the ground. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-tie.h"
#include <glib/gi18n.h>

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  const QnGesture *gesture = data;
  return qn_edit_draw_tie (model, gesture->from, gesture->to, error);
}

static void
complete (QnCanvas *canvas)
{
  QnGesture drawn = *qn_canvas_get_gesture (canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
  /* The new tie is selected, so that its numbers are there. */
  if ((drawn.from.x != drawn.to.x || drawn.from.y != drawn.to.y)
      && qn_canvas_edit (canvas, _ ("Add Tie"), NULL, edit_add, &drawn))
    qn_selection_set_item (qn_canvas_get_selection (canvas), QN_ITEM_TIE,
                           (QnId) qn_canvas_get_model (canvas)->tie_count - 1);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_tie = {
  .name = "tie",
  .icon = "quoin-tie-symbolic",
  .label = N_ ("Tie"),
  .hint =
    N_ ("Click both ends; an end on a block is fixed to it, elsewhere to the ground; "
        "Shift holds it straight; steel and anchors are in the panel Analysis"),
  .accel = "k",
  QN_GESTURE_LINE,
  .complete = complete,
  .draw = draw,
};
