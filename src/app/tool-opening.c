/* Opening: a rectangle dragged on a wall becomes a window or door; a click on an opening
 * with Shift fills it again. */
#include "app/tool-rectangle.h"

#include "doc/edit.h"
#include <glib/gi18n.h>

typedef struct Opening {
  QnId wall;
  QnVec2 a, b;
  gboolean lintel;
} Opening;

static QnId
wall_of_gesture (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (canvas));
  QnId wall = qn_model_wall_at (model, qn_vec2_lerp (gesture->from, gesture->to, 0.5));
  return wall != QN_NONE ? wall : qn_model_wall_at (model, gesture->from);
}

static gboolean
edit_cut (QnModel *model, gpointer data, GError **error)
{
  const Opening *opening = data;
  if (opening->wall == QN_NONE) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("Openings are cut into walls: drag on a wall"));
    return FALSE;
  }
  return qn_edit_cut_opening (model, opening->wall, opening->a, opening->b,
                              opening->lintel, error);
}

static gboolean
edit_fill (QnModel *model, gpointer data, GError **error)
{
  const Opening *opening = data;
  return qn_edit_fill_opening (model, opening->wall, opening->a, error);
}

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  Opening opening = { wall_of_gesture (canvas), gesture->from, gesture->to,
                      qn_canvas_get_tool_settings (canvas)->lintel };
  qn_canvas_set_in_gesture (canvas, FALSE);
  qn_canvas_edit (canvas, _ ("Cut Opening"), NULL, edit_cut, &opening);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (canvas));
  if (event->modifiers & GDK_SHIFT_MASK) {
    Opening opening = { qn_model_wall_at (model, event->model), event->model,
                        event->model, FALSE };
    if (opening.wall != QN_NONE)
      qn_canvas_edit (canvas, _ ("Fill Opening"), NULL, edit_fill, &opening);
    return;
  }
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
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (canvas));
  QnId wall = wall_of_gesture (canvas);
  QnVec2 a, b;
  if (wall != QN_NONE
      && qn_wall_snap_opening (&model->walls[wall], gesture->from, gesture->to, &a, &b))
    qn_rectangle_draw (canvas, cr, a, b);
}

const QnTool qn_tool_opening = {
  .name = "opening",
  .icon = "quoin-opening-symbolic",
  .label = N_ ("Opening"),
  .hint = N_ ("Drag on a wall: window or door; Shift+click fills an opening"),
  .accel = "o",
  .press = press,
  .motion = qn_rectangle_motion,
  .release = release,
  .numbers = numbers,
  .draw = draw,
};
