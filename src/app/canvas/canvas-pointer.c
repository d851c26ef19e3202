/* What the pointer does on the drawing: the magnet places it, the tool gets it. */
#include "app/canvas/canvas-private.h"

#include "app/widgets/settings.h"
#include <math.h>

/* px: how far the magnet pulls. */
#define MAGNET_REACH_PX 9.0

static QnMagnetHit
find_hit (QnCanvas *self, QnVec2 point, gboolean wanted)
{
  GSettings *settings = qn_settings_get ();
  QnMagnet magnet = {
    wanted && qn_canvas_snaps (self), MAGNET_REACH_PX / self->camera.scale,
    g_settings_get_boolean (settings, "grid") ? qn_canvas_grid_distance (self) / 5.0 : 0.0
  };
  QnMagnetHit hit =
    qn_magnet_find (&magnet, qn_canvas_get_model (self), point, self->magnet_skip);
  /* Where nothing attracts, a pixel is worth a round length: nobody means 498.2 mm; so is one along an edge,
   * from its corner on. */
  const double round_to = qn_magnet_round_distance (1.0 / self->camera.scale);
  const QnVec2 edge = qn_vec2_sub (hit.b, hit.a);
  const double length = qn_vec2_length (edge);
  if (hit.kind == QN_MAGNET_EDGE && length > 0.0) {
    double at = qn_vec2_dot (qn_vec2_sub (hit.point, hit.a), edge) / length;
    at = round (at / round_to) * round_to;
    hit.point = qn_vec2_add_scaled (hit.a, fmin (at / length, 1.0), edge);
  } else if (magnet.enabled && hit.kind == QN_MAGNET_NOTHING) {
    hit.point = qn_vec2 (round (hit.point.x / round_to) * round_to,
                         round (hit.point.y / round_to) * round_to);
  }
  return hit;
}

QnVec2
qn_canvas_snap (QnCanvas *self, QnVec2 point)
{
  return find_hit (self, point, TRUE).point;
}

/* What the tool does with an event, if anything. */
static void
send (QnCanvas *self, void (*tool) (QnCanvas *canvas, const QnToolEvent *event),
      QnVec2 at, GdkModifierType modifiers, int count)
{
  self->pointer = at;
  self->modifiers = modifiers;
  const QnVec2 point = qn_camera_to_model (&self->camera, at);
  self->hit =
    find_hit (self, point, self->tool->magnetic || (self->in_gesture && self->pressed));
  const QnToolEvent event = { at, point, self->hit.point, self->hit, modifiers, count };
  if (tool != NULL)
    tool (self, &event);
  gtk_widget_queue_draw (GTK_WIDGET (self));
  qn_canvas_emit_status (self);
}

static void
press (QnCanvas *self, QnVec2 at, GdkModifierType modifiers, int count)
{
  if (self->state == NULL || self->tool == NULL)
    return;
  self->pressed = TRUE;
  g_clear_handle_id (&self->place_timeout, g_source_remove);
  send (self, self->tool->press, at, modifiers, count);
}

static void
release (QnCanvas *self, QnVec2 at, GdkModifierType modifiers, int count)
{
  if (self->pressed)
    send (self, self->tool->release, at, modifiers, count);
  self->pressed = FALSE;
}

void
qn_canvas_point (QnCanvas *self, QnVec2 screen, GdkModifierType modifiers)
{
  if (self->state == NULL || self->tool == NULL)
    return;
  self->pointer_inside = TRUE;
  send (self, self->tool->motion, screen, modifiers, 0);
}

void
qn_canvas_click (QnCanvas *self, GdkModifierType modifiers)
{
  press (self, self->pointer, modifiers, 1);
  release (self, self->pointer, modifiers, 1);
}

/* ---- events ---- */

static GdkModifierType
modifiers_of (gpointer controller)
{
  return gtk_event_controller_get_current_event_state (GTK_EVENT_CONTROLLER (controller));
}

static void
on_press (GtkGestureClick *gesture, int count, double x, double y, QnCanvas *self)
{
  gtk_widget_grab_focus (GTK_WIDGET (self));
  self->keyboard_cursor = FALSE;
  press (self, qn_vec2 (x, y), modifiers_of (gesture), count);
}

static void
on_release (GtkGestureClick *gesture, int count, double x, double y, QnCanvas *self)
{
  release (self, qn_vec2 (x, y), modifiers_of (gesture), count);
}

static void
on_motion (GtkEventControllerMotion *controller, double x, double y, QnCanvas *self)
{
  /* GTK tells of a motion when what lies under a pointer at rest has changed. */
  if (self->keyboard_cursor && x == self->mouse.x && y == self->mouse.y)
    return;
  /* The button was let go while something else had the pointer, and GTK did not tell. */
  if (self->pressed && (modifiers_of (controller) & GDK_BUTTON1_MASK) == 0)
    release (self, self->pointer, modifiers_of (controller), 1);
  if (x != self->mouse.x || y != self->mouse.y)
    qn_canvas_pointer_moved (self);
  self->mouse = qn_vec2 (x, y);
  self->keyboard_cursor = FALSE;
  qn_canvas_point (self, self->mouse, modifiers_of (controller));
}

static void
on_leave (GtkEventControllerMotion *controller, QnCanvas *self)
{
  self->pointer_inside = self->keyboard_cursor;
  g_clear_handle_id (&self->inspect_timeout, g_source_remove);
  gtk_widget_queue_draw (GTK_WIDGET (self));
  qn_canvas_emit_status (self);
}

void
qn_canvas_bind_pointer (GtkWidgetClass *klass)
{
  gtk_widget_class_bind_template_callback (klass, on_press);
  gtk_widget_class_bind_template_callback (klass, on_release);
  gtk_widget_class_bind_template_callback (klass, on_motion);
  gtk_widget_class_bind_template_callback (klass, on_leave);
}
