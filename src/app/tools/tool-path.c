/* The way of a moving load: click along it, Enter or a double click at its end. */
#include "app/canvas/canvas.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const GArray *points = qn_canvas_get_gesture (canvas)->points;
  GVariant *line = g_variant_ref_sink (g_variant_new_fixed_array (
    G_VARIANT_TYPE_DOUBLE, points->data, 2 * (gsize) points->len, sizeof (double)));
  qn_canvas_set_in_gesture (canvas, FALSE);
  gtk_widget_activate_action_variant (GTK_WIDGET (canvas), "win.move-load", line);
  g_variant_unref (line);
  gtk_widget_activate_action (GTK_WIDGET (canvas), "win.tool", "s", "select");
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  if (event->press_count == 2 && gesture->points->len >= 2) {
    complete (canvas);
    return;
  }
  if (event->press_count > 1)
    return;
  g_array_append_val (gesture->points, event->point);
  gesture->to = event->point;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  qn_canvas_get_gesture (canvas)->to = event->point;
}

/* The next point, relative to the last one; none ends the line. */
static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  GArray *points = qn_canvas_get_gesture (canvas)->points;
  if (count == 0 && points->len >= 2) {
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
  cairo_new_path (cr);
  for (guint i = 0; i <= gesture->points->len; i++) {
    QnVec2 s = qn_canvas_to_screen (canvas, i < gesture->points->len
                                              ? g_array_index (gesture->points, QnVec2, i)
                                              : gesture->to);
    cairo_line_to (cr, s.x, s.y);
  }
  cairo_set_source_rgb (cr, 0.85, 0.35, 0.0);
  cairo_set_line_width (cr, 2.0);
  cairo_stroke (cr);
}

const QnTool qn_tool_path = {
  .name = "path",
  .icon = "quoin-force-symbolic",
  .label = N_ ("Way of a Moving Load"),
  .hint = N_ ("Click along the way of the load; double click or press Enter at its end"),
  .accel = "",
  .magnetic = TRUE,
  .numbers_label = N_ ("right; up"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .press = press,
  .motion = motion,
  .numbers = numbers,
  .draw = draw,
};
