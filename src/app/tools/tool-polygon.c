/* Polygonal block: click the corners, close at the first one or with a double click. */
#include "app/canvas/canvas.h"
#include "app/tools/tools.h"

#include "doc/edit/edit.h"
#include <glib/gi18n.h>

/* px: a click this near to the first corner closes the polygon. */
#define CLOSE_PX 8.0

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  QnCanvas *canvas = data;
  const GArray *points = qn_canvas_get_gesture (canvas)->points;
  QnBlockStyle style =
    qn_tool_settings_get_block_style (qn_canvas_get_tool_settings (canvas));
  return qn_edit_add_block (model, (const QnVec2 *) points->data, points->len, style,
                            error);
}

static void
complete (QnCanvas *canvas)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (gesture->points->len >= 3)
    qn_canvas_edit (canvas, _ ("Add Block"), NULL, edit_add, canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  GArray *points = gesture->points;
  if (points->len >= 3) {
    QnVec2 first = qn_canvas_to_screen (canvas, g_array_index (points, QnVec2, 0));
    if (event->press_count == 2
        || qn_vec2_length (qn_vec2_sub (first, event->screen)) < CLOSE_PX) {
      complete (canvas);
      return;
    }
  }
  if (event->press_count > 1)
    return;
  g_array_append_val (points, event->point);
  gesture->to = event->point;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  qn_canvas_get_gesture (canvas)->to = event->point;
}

/* Coordinates of the next corner, relative to the last one; none closes the polygon. */
static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  GArray *points = qn_canvas_get_gesture (canvas)->points;
  if (count == 0 && points->len >= 3) {
    complete (canvas);
    return TRUE;
  }
  if (count != 2 || points->len == 0)
    return FALSE;
  QnVec2 last = g_array_index (points, QnVec2, points->len - 1);
  QnVec2 next = qn_vec2 (last.x + values[0], last.y + values[1]);
  g_array_append_val (points, next);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const GArray *points = gesture->points;
  if (points->len == 0)
    return;
  for (guint i = 0; i < points->len; i++) {
    QnVec2 s = qn_canvas_to_screen (canvas, g_array_index (points, QnVec2, i));
    cairo_line_to (cr, s.x, s.y);
  }
  QnVec2 s = qn_canvas_to_screen (canvas, gesture->to);
  cairo_line_to (cr, s.x, s.y);
  cairo_set_source_rgba (cr, 0.1, 0.4, 0.9, 0.15);
  cairo_fill_preserve (cr);
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
  cairo_set_line_width (cr, 1.5);
  cairo_stroke (cr);
  qn_canvas_draw_dimension (canvas, cr, g_array_index (points, QnVec2, points->len - 1),
                            gesture->to);
}

const QnTool qn_tool_polygon = {
  .name = "polygon",
  .icon = "quoin-polygon-symbolic",
  .label = N_ ("Polygonal Block"),
  .hint =
    N_ ("Click the corners; click the first one, double click or press Enter to close"),
  .accel = "p",
  .magnetic = TRUE,
  .numbers_label = N_ ("right; up"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .press = press,
  .motion = motion,
  .numbers = numbers,
  .draw = draw,
};
