/* What is drawn as a line from point to point: reinforcing bars across joints, and ties, an end of which
 * is fixed to the block that it lies on, elsewhere to the ground. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-frame.h"
#include "doc/edit/edit-tie.h"
#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const gboolean tie = qn_canvas_get_tool (canvas) == &qn_tool_tie;
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnVec2 from = gesture->from, to = gesture->to;
  QnDraft draft;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if ((from.x == to.x && from.y == to.y) || !qn_canvas_begin_edit (canvas, &draft)
      || !qn_canvas_end_edit (canvas, &draft, tie ? _ ("Add Tie") : _ ("Add Bar"), NULL,
                              (tie ? qn_edit_draw_tie : qn_edit_draw_bar) (
                                draft.model, from, to, &draft.error)))
    return;
  /* What is new is selected, so that its numbers are there. */
  const QnModel *model = qn_canvas_get_model (canvas);
  const gsize count = tie ? model->tie_count : model->bar_count;
  qn_selection_set_item (qn_canvas_get_selection (canvas),
                         tie ? QN_ITEM_TIE : QN_ITEM_BAR, (QnId) count - 1);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
}

static void
draw_tie (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_held (canvas, cr, qn_tie_end_dup_text);
}

const QnTool qn_tool_bar = {
  .name = "bar",
  .icon = "quoin-bar-symbolic",
  .label = N_ ("Reinforcing Bar"),
  .hint = N_ ("Drag from end to end, across joints at any angle; Shift holds it "
              "straight; law and diameter are in the panel Analysis"),
  .accel = "e",
  QN_GESTURE_LINE,
  .complete = complete,
  .draw = draw,
};

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
  .draw = draw_tie,
};
