/* A single rectangular block. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 a = gesture->from, b = gesture->to;
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  QnBlockStyle style =
    qn_tool_settings_get_block_style (qn_canvas_get_tool_settings (canvas));
  QnDraft draft;
  if (a.x != b.x && a.y != b.y && qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (canvas, &draft, _ ("Add Block"), NULL,
                        qn_edit_add_block (draft.model, corners, G_N_ELEMENTS (corners),
                                           style, &draft.error));
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
  .begins = TRUE,
  .icon = "quoin-rectangle-symbolic",
  .label = N_ ("Rectangular Block"),
  .hint = N_ ("Drag a rectangle, or click a corner and type width; height"),
  .accel = "r",
  QN_GESTURE_RECTANGLE,
  .complete = complete,
  .draw = draw,
};
