/* Cut: a line parts the blocks that it crosses; of the selected ones where some are selected. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-shape.h"
#include <glib/gi18n.h>

static gboolean
edit (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  return qn_edit_cut_blocks (draft->model,
                             qn_selection_get_parts (canvas->selection).blocks,
                             gesture->from, gesture->to, &draft->error);
}

/* The line, and the blocks that it would part. */
static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
  const QnModel *model = qn_canvas_get_model (canvas);
  const guint selected = canvas->selection->ids[QN_PICK_BLOCK]->len;
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    if ((selected == 0 || qn_selection_has (canvas->selection, QN_PICK_BLOCK, i))
        && qn_block_is_crossed (model, i, gesture->from, gesture->to))
      qn_canvas_trace (canvas, cr, qn_model_block_vertices (model, i),
                       (gsize) model->blocks[i].vertex_count);
  }
  qn_gesture_paint (cr);
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_cut = {
  .name = "cut",
  .icon = "quoin-cut-symbolic",
  .label = N_ ("Cut Blocks"),
  .hint = N_ ("Drag a line across blocks: it cuts them, or those of them that are "
              "selected; Shift holds it straight"),
  .accel = "x",
  QN_GESTURE_LINE,
  .step = N_ ("Cut Blocks"),
  .edit = edit,
  .draw = draw,
};
