/* Wall: a dragged rectangle becomes a bonded wall that stays parametric. */
#include "app/gesture.h"

#include "doc/edit-masonry.h"
#include <glib/gi18n.h>

static gboolean
make_plan (QnCanvas *canvas, QnMasonry *wall)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  return qn_plan_wall (wall, &qn_canvas_get_tool_settings (canvas)->masonry,
                       gesture->from, gesture->to);
}

static gboolean
edit_add (QnProject *draft, gpointer data, GError **error)
{
  QnMasonry wall;
  return make_plan (data, &wall) ? qn_edit_add_masonry (draft, &wall, error)
                                 : qn_edit_no_memory (error);
}

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (gesture->from.x != gesture->to.x && gesture->from.y != gesture->to.y)
    qn_canvas_edit_project (canvas, _ ("Add Wall"), NULL, edit_add, canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  QnMasonry wall;
  if (!qn_canvas_is_in_gesture (canvas) || !make_plan (canvas, &wall))
    return;
  QnVec2 far = { wall.origin.x + wall.wall.leaves[0].length,
                 wall.origin.y + wall.wall.height };
  qn_gesture_draw_masonry (canvas, cr, &wall);
  qn_gesture_draw_rectangle (canvas, cr, wall.origin, far);
  qn_masonry_clear (&wall);
}

const QnTool qn_tool_wall = {
  .name = "wall",
  .icon = "quoin-wall-symbolic",
  .label = N_ ("Wall"),
  .hint =
    N_ ("Drag a rectangle: it becomes a bonded wall; or click a corner and type width; "
        "height"),
  .accel = "w",
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
