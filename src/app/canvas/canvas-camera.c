/* How the paper moves under the window: zoom, pan, pinch, fit. */
#include "app/canvas/canvas-private.h"

/* Pixels per metre between which one can zoom. */
#define LEAST_SCALE 0.05
#define MOST_SCALE  200000.0

#define FIT_TOP_POINTS    33.0
#define FIT_MARGIN_POINTS 42.0
#define MOST_STRIP_SHARE  0.17
#define DIMENSION_POINTS  33.0 /* from the structure to the far side of a dimension */
#define REST_MS           150  /* without motion, until a heavy drawing is drawn anew */
#define PLACE_SECONDS     4
#define WHEEL_FACTOR      1.15

static gboolean
on_rest (gpointer data)
{
  QnCanvas *self = data;
  self->rest_timeout = 0;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  return G_SOURCE_REMOVE;
}

/* The user has moved the paper: heavy drawings wait for it to come to rest. */
static void
camera_moved (QnCanvas *self)
{
  self->wants_fit = self->keeps_fit = FALSE;
  g_clear_handle_id (&self->rest_timeout, g_source_remove);
  self->rest_timeout = g_timeout_add (REST_MS, on_rest, self);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
zoom_at (QnCanvas *self, QnVec2 at, double factor)
{
  double scale = CLAMP (self->camera.scale * factor, LEAST_SCALE, MOST_SCALE);
  qn_camera_zoom_at (&self->camera, at, scale / self->camera.scale);
  camera_moved (self);
  qn_canvas_emit_status (self);
}

static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, QnCanvas *self)
{
  GdkEvent *event =
    gtk_event_controller_get_current_event (GTK_EVENT_CONTROLLER (controller));
  gboolean touchpad =
    event != NULL && gdk_scroll_event_get_direction (event) == GDK_SCROLL_SMOOTH
    && gdk_device_get_source (gdk_event_get_device (event)) == GDK_SOURCE_TOUCHPAD;
  GdkModifierType modifiers =
    gtk_event_controller_get_current_event_state (GTK_EVENT_CONTROLLER (controller));
  if (touchpad && (modifiers & GDK_CONTROL_MASK) == 0) {
    qn_camera_pan (&self->camera, qn_vec2 (-dx * 10.0, -dy * 10.0));
    camera_moved (self);
  } else if (modifiers & GDK_SHIFT_MASK) {
    qn_camera_pan (&self->camera, qn_vec2 (-(dx + dy) * 40.0, 0.0));
    camera_moved (self);
  } else
    zoom_at (self, self->pointer, pow (WHEEL_FACTOR, -dy));
  return TRUE;
}

static void
on_pan_begin (GtkGestureDrag *gesture, double x, double y, QnCanvas *self)
{
  self->gesture_camera = self->camera;
  gtk_widget_set_cursor_from_name (GTK_WIDGET (self), "grabbing");
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, QnCanvas *self)
{
  QnCamera camera = self->gesture_camera;
  qn_camera_pan (&camera, qn_vec2 (dx, dy));
  self->camera.center = camera.center;
  camera_moved (self);
}

static void
on_pan_end (GtkGestureDrag *gesture, double dx, double dy, QnCanvas *self)
{
  gtk_widget_set_cursor (GTK_WIDGET (self), NULL);
}

static void
on_pinch_begin (GtkGesture *gesture, GdkEventSequence *sequence, QnCanvas *self)
{
  double x, y;
  self->gesture_camera = self->camera;
  if (gtk_gesture_get_bounding_box_center (gesture, &x, &y))
    self->zoom_center = qn_vec2 (x, y);
}

static void
on_pinch_changed (GtkGestureZoom *gesture, double factor, QnCanvas *self)
{
  self->camera = self->gesture_camera;
  zoom_at (self, self->zoom_center, factor);
}

void
qn_canvas_fit (QnCanvas *self)
{
  self->wants_fit = self->keeps_fit = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* px beside what is fitted for things that grow with the text, but not so far that nothing is left in a
 * small window. */
static double
fit_strip (const QnCanvas *self, double points)
{
  return fmin (points * self->camera.unit,
               MOST_STRIP_SHARE * fmin (self->camera.width, self->camera.height));
}

/* Centres the box in what strips on the left, at the top and at the bottom leave. */
static void
fit_beside (QnCanvas *self, QnBox box, double left, double bottom)
{
  QnCamera room = self->camera;
  room.width -= left;
  double top = fit_strip (self, FIT_TOP_POINTS);
  room.height -= top + bottom;
  /* Rulers and dimensions. */
  qn_camera_fit (&room, box, fit_strip (self, FIT_MARGIN_POINTS));
  self->camera.scale = CLAMP (room.scale, LEAST_SCALE, MOST_SCALE);
  self->camera.center.x = room.center.x - 0.5 * left / self->camera.scale;
  self->camera.center.y = room.center.y + 0.5 * (top - bottom) / self->camera.scale;
}

void
qn_canvas_fit_now (QnCanvas *self)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  QnBox box = scene != NULL ? scene->box : (QnBox){ { -0.5, -0.5 }, { 5.5, 4.5 } };
  /* Room for the rulers, the choice of view above and the buttons below. */
  fit_beside (self, box, 0.0, 0.0);
  if (scene != NULL) {
    /* The legend hides nothing, nor the dimensions: the structure goes beside it or above it, where it
     * is larger. */
    QnBox legend = qn_canvas_legend_box (self, scene);
    QnVec2 low = qn_camera_to_screen (&self->camera, box.min);
    QnVec2 high = qn_camera_to_screen (&self->camera, box.max);
    double dimensions = DIMENSION_POINTS * self->camera.unit;
    if (low.x - dimensions < legend.max.x && high.x > legend.min.x
        && low.y + dimensions > legend.min.y && high.y < legend.max.y) {
      double left = legend.max.x, bottom = self->camera.height - legend.min.y;
      fit_beside (self, box, left, 0.0);
      double beside = self->camera.scale;
      fit_beside (self, box, 0.0, bottom);
      if (beside > self->camera.scale)
        fit_beside (self, box, left, 0.0);
    }
  }
  self->wants_fit = FALSE;
}

void
qn_canvas_zoom (QnCanvas *self, double factor)
{
  zoom_at (self, qn_vec2 (0.5 * self->camera.width, 0.5 * self->camera.height), factor);
}

static gboolean
on_place_timeout (gpointer data)
{
  QnCanvas *self = data;
  self->place_timeout = 0;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  return G_SOURCE_REMOVE;
}

void
qn_canvas_show_place (QnCanvas *self, QnVec2 at)
{
  QnVec2 screen = qn_camera_to_screen (&self->camera, at);
  double margin = fit_strip (self, FIT_MARGIN_POINTS);
  if (screen.x < margin || screen.y < margin || screen.x > self->camera.width - margin
      || screen.y > self->camera.height - margin)
    self->camera.center = at;
  self->place = at;
  self->wants_fit = self->keeps_fit = FALSE;
  g_clear_handle_id (&self->place_timeout, g_source_remove);
  self->place_timeout = g_timeout_add_seconds (PLACE_SECONDS, on_place_timeout, self);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

void
qn_canvas_show_gaps (QnCanvas *self, QnGaps *gaps)
{
  qn_gaps_clear (&self->gaps);
  self->gaps = *gaps;
  *gaps = (QnGaps){ 0 };
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

void
qn_canvas_show_area (QnCanvas *self, QnVec2 low, QnVec2 high)
{
  QnBox seen = qn_camera_visible_box (&self->camera);
  if (low.x >= seen.min.x && high.x <= seen.max.x && low.y >= seen.min.y
      && high.y <= seen.max.y)
    return;
  if (self->keeps_fit) {
    qn_canvas_fit (self);
    return;
  }
  self->camera.center = qn_vec2_lerp (low, high, 0.5);
  camera_moved (self);
}

void
qn_canvas_bind_camera (GtkWidgetClass *klass)
{
  gtk_widget_class_bind_template_callback (klass, on_pan_begin);
  gtk_widget_class_bind_template_callback (klass, on_pan_update);
  gtk_widget_class_bind_template_callback (klass, on_pan_end);
  gtk_widget_class_bind_template_callback (klass, on_pinch_begin);
  gtk_widget_class_bind_template_callback (klass, on_pinch_changed);
  gtk_widget_class_bind_template_callback (klass, on_scroll);
}
