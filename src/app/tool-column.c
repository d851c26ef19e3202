/* Column: a dragged rectangle becomes a stack of drums. */
#include "app/gesture.h"

#include "doc/edit-masonry.h"
#include <glib/gi18n.h>

static gboolean
make_plan (QnCanvas *canvas, QnMasonry *column)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  return qn_plan_column (column, &qn_canvas_get_tool_settings (canvas)->masonry,
                         gesture->from, gesture->to);
}

static gboolean
edit_add (QnProject *draft, gpointer data, GError **error)
{
  QnMasonry column;
  return make_plan (data, &column) ? qn_edit_add_masonry (draft, &column, error)
                                   : qn_edit_no_memory (error);
}

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (gesture->from.x != gesture->to.x && gesture->from.y != gesture->to.y)
    qn_canvas_edit_project (canvas, _ ("Add Column"), NULL, edit_add, canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnMasonry column;
  if (!qn_canvas_is_in_gesture (canvas) || !make_plan (canvas, &column))
    return;
  qn_gesture_draw_masonry (canvas, cr, &column);
  qn_gesture_draw_rectangle (canvas, cr, gesture->from, gesture->to);
  qn_masonry_clear (&column);
}

const QnTool qn_tool_column = {
  .name = "column",
  .icon = "quoin-column-symbolic",
  .label = N_ ("Column"),
  .hint = N_ ("Drag a rectangle: it becomes a column of drums, each about a course high; "
              "or click a corner and type width; height"),
  .accel = "c",
  .magnetic = TRUE,
  .numbers_label = N_ ("width; height"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .press = qn_gesture_press,
  .motion = qn_gesture_motion,
  .release = qn_gesture_release,
  .numbers = qn_gesture_rectangle_numbers,
  .complete = complete,
  .draw = draw,
};
