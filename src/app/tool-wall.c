/* Wall: a dragged rectangle becomes a bonded wall on a fixed base. */
#include "app/tool-rectangle.h"

#include "doc/edit.h"
#include <glib/gi18n.h>

/* Size that the bond allows for what was dragged. */
static QnWallPlan
make_plan (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnWallPlan plan = qn_canvas_get_tool_settings (canvas)->wall;
  double width = fabs (gesture->to.x - gesture->from.x);
  double height = fabs (gesture->to.y - gesture->from.y);
  plan.width = MAX (round (2.0 * width / plan.unit.x), 1.0) * 0.5 * plan.unit.x;
  plan.height = MAX (round (height / plan.unit.y), 1.0) * plan.unit.y;
  plan.origin.x =
    gesture->to.x < gesture->from.x ? gesture->from.x - plan.width : gesture->from.x;
  plan.origin.y =
    gesture->to.y < gesture->from.y ? gesture->from.y - plan.height : gesture->from.y;
  return plan;
}

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_add_wall (model, data, error);
}

static void
complete (QnCanvas *canvas)
{
  QnWallPlan plan = make_plan (canvas);
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  gboolean wanted = gesture->from.x != gesture->to.x && gesture->from.y != gesture->to.y;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (wanted)
    qn_canvas_edit (canvas, _ ("Add Wall"), NULL, edit_add, &plan);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  if (qn_rectangle_press (canvas, event))
    complete (canvas);
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (qn_rectangle_release (canvas, event))
    complete (canvas);
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  if (!qn_rectangle_numbers (canvas, values, count))
    return FALSE;
  complete (canvas);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  if (!qn_canvas_is_in_gesture (canvas))
    return;
  QnWallPlan plan = make_plan (canvas);
  QnVec2 far = qn_vec2 (plan.origin.x + plan.width, plan.origin.y + plan.height);
  for (double y = plan.origin.y; y < far.y + 0.5 * plan.unit.y; y += plan.unit.y) {
    QnVec2 a = qn_canvas_to_screen (canvas, qn_vec2 (plan.origin.x, y));
    QnVec2 b = qn_canvas_to_screen (canvas, qn_vec2 (far.x, y));
    cairo_move_to (cr, a.x, a.y);
    cairo_line_to (cr, b.x, b.y);
  }
  cairo_set_source_rgba (cr, 0.1, 0.4, 0.9, 0.5);
  cairo_set_line_width (cr, 1.0);
  cairo_stroke (cr);
  qn_rectangle_draw (canvas, cr, plan.origin, far);
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
  .press = press,
  .motion = qn_rectangle_motion,
  .release = release,
  .numbers = numbers,
  .draw = draw,
};
