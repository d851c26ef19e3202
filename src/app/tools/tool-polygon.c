/* Polygonal block: click the corners, close at the first one or with a double click. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit.h"
#include <glib/gi18n.h>

/* px: a click this near to the first corner closes the polygon. */
#define CLOSE_PX 8.0

static gboolean
edit (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  return qn_edit_add_block (draft->model, (const QnVec2 *) gesture->points->data,
                            gesture->points->len, qn_tool_block_style (canvas),
                            &draft->error);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  const GArray *points = canvas->gesture.points;
  if (points->len >= 3) {
    QnVec2 first = qn_canvas_to_screen (canvas, g_array_index (points, QnVec2, 0));
    if (qn_vec2_length (qn_vec2_sub (first, event->screen)) < CLOSE_PX) {
      qn_gesture_complete (canvas);
      return;
    }
  }
  qn_gesture_press_point (canvas, event);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const GArray *points = canvas->gesture.points;
  if (points->len == 0)
    return;
  qn_gesture_trace_points (canvas, cr);
  qn_gesture_paint (cr);
  qn_canvas_draw_dimension (canvas, cr, g_array_index (points, QnVec2, points->len - 1),
                            canvas->gesture.to);
}

const QnTool qn_tool_polygon = {
  .name = "polygon",
  .begins = TRUE,
  .icon = "quoin-polygon-symbolic",
  .label = N_ ("Polygonal Block"),
  .hint =
    N_ ("Click the corners; click the first one, double click or press Enter to close"),
  .accel = "p",
  .magnetic = TRUE,
  .numbers_label = N_ ("right; up"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .least_points = 3,
  .press = press,
  .motion = qn_gesture_motion,
  .numbers = qn_gesture_point_numbers,
  .step = N_ ("Add Block"),
  .edit = edit,
  .draw = draw,
};
