/* A single rectangular block. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static gboolean
edit (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  QnVec2 a = gesture->from, b = gesture->to;
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  return qn_edit_add_block (draft->model, corners, G_N_ELEMENTS (corners),
                            qn_tool_block_style (canvas), &draft->error);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_rectangle (canvas, cr, canvas->gesture.from, canvas->gesture.to);
}

const QnTool qn_tool_rectangle = {
  .name = "rectangle",
  .begins = TRUE,
  .icon = "quoin-rectangle-symbolic",
  .label = N_ ("Rectangular Block"),
  .hint = N_ ("Drag a rectangle, or click a corner and type width; height"),
  .accel = "r",
  QN_GESTURE_RECTANGLE,
  .step = N_ ("Add Block"),
  .edit = edit,
  .draw = draw,
};
