/* The way of a moving load: click along it, Enter or a double click at its end. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const GArray *points = qn_canvas_get_gesture (canvas)->points;
  GVariant *line = g_variant_ref_sink (g_variant_new_fixed_array (
    G_VARIANT_TYPE_DOUBLE, points->data, 2 * (gsize) points->len, sizeof (double)));
  qn_canvas_set_in_gesture (canvas, FALSE);
  gtk_widget_activate_action (GTK_WIDGET (canvas), "win.tool", "s", "select");
  gtk_widget_activate_action_variant (GTK_WIDGET (canvas), "win.move-load", line);
  g_variant_unref (line);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_trace_points (canvas, cr);
  cairo_set_source_rgb (cr, 0.85, 0.35, 0.0);
  cairo_set_line_width (cr, 2.0);
  cairo_stroke (cr);
}

const QnTool qn_tool_path = {
  .name = "path",
  .icon = "quoin-force-symbolic",
  .label = N_ ("Path of a Moving Load"),
  .hint = N_ ("Click along the path of the load; double click or press Enter at its end"),
  .accel = "",
  .magnetic = TRUE,
  .numbers_label = N_ ("right; up"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .least_points = 2,
  .press = qn_gesture_press_point,
  .motion = qn_gesture_motion,
  .numbers = qn_gesture_point_numbers,
  .complete = complete,
  .draw = draw,
};
