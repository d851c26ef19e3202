/* Rotate: press at the centre, drag around it; or type the angle. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>
#include <math.h>

static double
angle_of_gesture (QnCanvas *canvas)
{
  QnVec2 d = qn_vec2_sub (canvas->gesture.to, canvas->gesture.from);
  return atan2 (d.y, d.x);
}

static void
rotate (QnCanvas *canvas, double angle)
{
  QnVec2 low, high, center = canvas->gesture.from;
  /* Typed before a centre was clicked: about the middle of what is selected. */
  if (!canvas->in_gesture && qn_canvas_get_parts_box (canvas, &low, &high))
    center = qn_vec2_lerp (low, high, 0.5);
  qn_canvas_set_in_gesture (canvas, FALSE);
  qn_canvas_transform (canvas, _ ("Rotate"), NULL, qn_transform_rotation (center, angle),
                       0);
}

static void
complete (QnCanvas *canvas)
{
  rotate (canvas, angle_of_gesture (canvas));
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  if (count != 1)
    return FALSE;
  rotate (canvas, values[0]);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  double angle = angle_of_gesture (canvas);
  qn_gesture_draw_moved (canvas, cr, qn_transform_rotation (canvas->gesture.from, angle));
  QnVec2 c = qn_canvas_to_screen (canvas, canvas->gesture.from);
  QnVec2 p = qn_canvas_to_screen (canvas, canvas->gesture.to);
  double radius = 0.5 * qn_vec2_length (qn_vec2_sub (p, c));
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
  cairo_set_line_width (cr, 1.5);
  cairo_move_to (cr, c.x + 2.0 * radius, c.y);
  cairo_line_to (cr, c.x, c.y);
  cairo_line_to (cr, p.x, p.y);
  cairo_stroke (cr);
  if (angle > 0.0)
    cairo_arc_negative (cr, c.x, c.y, radius, 0.0, -angle);
  else
    cairo_arc (cr, c.x, c.y, radius, 0.0, -angle);
  cairo_stroke (cr);
  g_autofree char *text = g_strdup_printf ("%.1f°", angle * 180.0 / G_PI);
  qn_canvas_draw_label (canvas, cr, text, qn_vec2 (c.x + radius + 6.0, c.y - 20.0));
}

const QnTool qn_tool_rotate = {
  .name = "rotate",
  .icon = "quoin-rotate-symbolic",
  .label = N_ ("Rotate"),
  .hint = N_ ("Press at the centre and drag around it to turn what is selected, or type "
              "the angle; Shift turns by steps of 15°"),
  .accel = "t",
  .magnetic = TRUE,
  .numbers_label = N_ ("angle"),
  .quantities = { QN_QUANTITY_ANGLE },
  .numbers_at_rest = TRUE,
  .press = qn_gesture_press,
  .motion = qn_gesture_motion_straight,
  .release = qn_gesture_release,
  .numbers = numbers,
  .complete = complete,
  .draw = draw,
};
