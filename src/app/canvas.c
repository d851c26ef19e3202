#include "app/canvas-private.h"

#include "app/settings.h"
#include <glib/gi18n.h>

/* px: how far the magnet pulls, and how near the pointer must be to pick. */
#define MAGNET_REACH_PX 9.0
#define PICK_REACH_PX   4.0
#define CLICK_PX        4.0

/* Pixels per metre between which one can zoom. */
#define LEAST_SCALE 0.05
#define MOST_SCALE  200000.0

#define FIT_TOP_PX    44.0
#define FIT_MARGIN_PX 56.0
#define REST_MS       150 /* without motion, until a heavy drawing is drawn anew */
#define PLACE_SECONDS 4
#define WHEEL_FACTOR  1.15
#define PX_PER_POINT  (96.0 / 72.0)

G_DEFINE_FINAL_TYPE (QnCanvas, qn_canvas, GTK_TYPE_WIDGET)

enum { SIGNAL_STATUS, SIGNAL_FAILED, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

static void
emit_status (QnCanvas *self)
{
  g_signal_emit (self, signals[SIGNAL_STATUS], 0);
}

/* ---- scene ---- */

const QnScene *
qn_canvas_get_scene (QnCanvas *self)
{
  if (self->scene != NULL || self->scene_error != NULL || self->state == NULL)
    return self->scene;
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (!qn_view_state_get_content (self->state, &model, &contacts, &result)
      || model->block_count == 0)
    return NULL;
  QnViewOptions options = qn_view_state_get_options (self->state);
  self->scene = qn_scene_build (model, contacts, result, &options, &self->scene_error);
  return self->scene;
}

static void
invalidate (QnCanvas *self)
{
  g_clear_pointer (&self->scene, qn_scene_free);
  g_clear_error (&self->scene_error);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* Another view takes other room; steps and phases of a motion do not move the paper. */
static void
on_state_changed (QnCanvas *self)
{
  QnView view = qn_view_state_get_view (self->state);
  if (view != self->shown_view && self->keeps_fit)
    self->wants_fit = TRUE;
  self->shown_view = view;
  invalidate (self);
}

static void
update_description (QnCanvas *self)
{
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (self));
  const QnContacts *contacts = qn_document_get_contacts (qn_canvas_get_document (self));
  g_autofree char *text = g_strdup_printf (
    _ ("Drawing of %u blocks with %u contact faces; the arrow keys move the selection"),
    (guint) model->block_count, (guint) contacts->face_count);
  gtk_accessible_update_property (GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  _ ("Drawing"), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                  text, -1);
}

/* ---- pointer ---- */

static void
update_hit (QnCanvas *self)
{
  QnVec2 point = qn_camera_to_model (&self->camera, self->pointer);
  GSettings *settings = qn_settings_get ();
  gboolean free_hand = (self->modifiers & GDK_ALT_MASK) != 0;
  gboolean wanted =
    self->tool != NULL && (self->tool->magnetic || self->in_gesture) && !free_hand;
  QnMagnet magnet = { wanted && g_settings_get_boolean (settings, "snap"),
                      MAGNET_REACH_PX / self->camera.scale,
                      g_settings_get_boolean (settings, "grid")
                        ? qn_canvas_grid_distance (self) / 5.0
                        : 0.0 };
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (self));
  self->hit = qn_magnet_find (&magnet, model, point, self->magnet_skip);
}

static QnToolEvent
make_event (QnCanvas *self, double x, double y, GdkModifierType modifiers,
            int press_count)
{
  self->pointer = qn_vec2 (x, y);
  self->modifiers = modifiers;
  update_hit (self);
  return (QnToolEvent){ self->pointer, qn_camera_to_model (&self->camera, self->pointer),
                        self->hit.point, modifiers, press_count };
}

static GdkModifierType
event_modifiers (gpointer controller)
{
  return gtk_event_controller_get_current_event_state (GTK_EVENT_CONTROLLER (controller));
}

static void
on_press (GtkGestureClick *gesture, int count, double x, double y, QnCanvas *self)
{
  gtk_widget_grab_focus (GTK_WIDGET (self));
  if (self->state == NULL || self->tool == NULL)
    return;
  QnToolEvent event = make_event (self, x, y, event_modifiers (gesture), count);
  self->pressed = TRUE;
  self->has_place = FALSE;
  if (self->tool->press != NULL)
    self->tool->press (self, &event);
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
}

static void
on_release (GtkGestureClick *gesture, int count, double x, double y, QnCanvas *self)
{
  if (!self->pressed)
    return;
  QnToolEvent event = make_event (self, x, y, event_modifiers (gesture), count);
  self->pressed = FALSE;
  if (self->tool->release != NULL)
    self->tool->release (self, &event);
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
}

static void
on_motion (GtkEventControllerMotion *controller, double x, double y, QnCanvas *self)
{
  if (self->state == NULL || self->tool == NULL)
    return;
  self->pointer_inside = TRUE;
  QnToolEvent event = make_event (self, x, y, event_modifiers (controller), 0);
  if (self->tool->motion != NULL)
    self->tool->motion (self, &event);
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
}

static void
on_leave (GtkEventControllerMotion *controller, QnCanvas *self)
{
  (void) controller;
  self->pointer_inside = FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
}

/* ---- camera ---- */

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
  emit_status (self);
}

static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, QnCanvas *self)
{
  GdkEvent *event =
    gtk_event_controller_get_current_event (GTK_EVENT_CONTROLLER (controller));
  gboolean touchpad =
    event != NULL && gdk_scroll_event_get_direction (event) == GDK_SCROLL_SMOOTH
    && gdk_device_get_source (gdk_event_get_device (event)) == GDK_SOURCE_TOUCHPAD;
  GdkModifierType modifiers = event_modifiers (controller);
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
  (void) gesture;
  (void) x;
  (void) y;
  self->gesture_camera = self->camera;
  gtk_widget_set_cursor_from_name (GTK_WIDGET (self), "grabbing");
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, QnCanvas *self)
{
  (void) gesture;
  QnCamera camera = self->gesture_camera;
  qn_camera_pan (&camera, qn_vec2 (dx, dy));
  self->camera.center = camera.center;
  camera_moved (self);
}

static void
on_pan_end (GtkGestureDrag *gesture, double dx, double dy, QnCanvas *self)
{
  (void) gesture;
  (void) dx;
  (void) dy;
  gtk_widget_set_cursor (GTK_WIDGET (self), NULL);
}

static void
on_pinch_begin (GtkGesture *gesture, GdkEventSequence *sequence, QnCanvas *self)
{
  (void) sequence;
  double x, y;
  self->gesture_camera = self->camera;
  if (gtk_gesture_get_bounding_box_center (gesture, &x, &y))
    self->zoom_center = qn_vec2 (x, y);
}

static void
on_pinch_changed (GtkGestureZoom *gesture, double factor, QnCanvas *self)
{
  (void) gesture;
  self->camera = self->gesture_camera;
  zoom_at (self, self->zoom_center, factor);
}

void
qn_canvas_fit (QnCanvas *self)
{
  self->wants_fit = self->keeps_fit = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
fit_now (QnCanvas *self)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  QnBox box = scene != NULL ? scene->box : (QnBox){ { -0.5, -0.5 }, { 5.5, 4.5 } };
  /* Room for the rulers, the choice of view above and the buttons below. */
  self->camera.y = FIT_TOP_PX;
  self->camera.height -= FIT_TOP_PX;
  qn_camera_fit (&self->camera, box, FIT_MARGIN_PX);
  self->camera.height += FIT_TOP_PX;
  self->camera.y = 0.0;
  self->camera.center.y += 0.5 * FIT_TOP_PX / self->camera.scale;
  self->wants_fit = FALSE;
  self->camera.scale = CLAMP (self->camera.scale, LEAST_SCALE, MOST_SCALE);
}

void
qn_canvas_zoom (QnCanvas *self, double factor)
{
  zoom_at (self, qn_vec2 (0.5 * self->camera.width, 0.5 * self->camera.height), factor);
}

const QnCamera *
qn_canvas_get_camera (QnCanvas *self)
{
  return &self->camera;
}

void
qn_canvas_set_camera (QnCanvas *self, const QnCamera *camera)
{
  self->camera.center = camera->center;
  self->camera.scale = camera->scale;
  camera_moved (self);
}

static gboolean
on_place_timeout (gpointer data)
{
  QnCanvas *self = data;
  self->place_timeout = 0;
  self->has_place = FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  return G_SOURCE_REMOVE;
}

void
qn_canvas_show_place (QnCanvas *self, QnVec2 at)
{
  QnVec2 screen = qn_camera_to_screen (&self->camera, at);
  double margin = FIT_MARGIN_PX;
  if (screen.x < margin || screen.y < margin || screen.x > self->camera.width - margin
      || screen.y > self->camera.height - margin)
    self->camera.center = at;
  self->place = at;
  self->has_place = TRUE;
  self->wants_fit = self->keeps_fit = FALSE;
  g_clear_handle_id (&self->place_timeout, g_source_remove);
  self->place_timeout = g_timeout_add_seconds (PLACE_SECONDS, on_place_timeout, self);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* ---- keys ---- */

static void
finish_typed (QnCanvas *self)
{
  double values[4];
  int count = 0;
  QnUnits units = qn_settings_get_units ();
  g_auto (GStrv) words = g_strsplit_set (self->typed->str, ";x×", -1);
  for (guint i = 0; words[i] != NULL && count < (int) G_N_ELEMENTS (values); i++) {
    if (*g_strstrip (words[i]) == '\0')
      continue;
    g_autoptr (GError) error = NULL;
    if (!qn_units_parse (units, QN_QUANTITY_LENGTH, words[i], &values[count], &error)) {
      g_signal_emit (self, signals[SIGNAL_FAILED], 0, error->message);
      return;
    }
    count++;
  }
  g_string_truncate (self->typed, 0);
  if (self->tool->numbers == NULL || !self->tool->numbers (self, values, count))
    g_signal_emit (self, signals[SIGNAL_FAILED], 0,
                   _ ("Type a width and a height, separated by a semicolon"));
}

static gboolean
is_number_character (gunichar c)
{
  return (c < 128 && g_ascii_isdigit ((char) c)) || c == '.' || c == ',' || c == ';'
         || c == '-' || c == ' ' || c == 'x' || c == 'm' || c == 'c';
}

/* Keys that mean something for the drawing alone, so that entries keep theirs. */
static const struct {
  guint keyval;
  GdkModifierType modifiers;
  const char *action; /* detailed name */
} canvas_keys[] = {
  { GDK_KEY_Delete, 0, "win.delete" },
  { GDK_KEY_BackSpace, 0, "win.delete" },
  { GDK_KEY_Left, 0, "win.nudge((-1.0,0.0))" },
  { GDK_KEY_Right, 0, "win.nudge((1.0,0.0))" },
  { GDK_KEY_Up, 0, "win.nudge((0.0,1.0))" },
  { GDK_KEY_Down, 0, "win.nudge((0.0,-1.0))" },
  { GDK_KEY_space, 0, "win.play" },
  { GDK_KEY_period, 0, "win.next-step" },
  { GDK_KEY_comma, 0, "win.previous-step" },
  { GDK_KEY_c, GDK_CONTROL_MASK, "win.copy" },
  { GDK_KEY_x, GDK_CONTROL_MASK, "win.cut" },
  { GDK_KEY_v, GDK_CONTROL_MASK, "win.paste" },
  { GDK_KEY_a, GDK_CONTROL_MASK, "win.select-all" },
};

static gboolean
activate_key (QnCanvas *self, guint keyval, GdkModifierType modifiers)
{
  GdkModifierType held = modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK | GDK_SHIFT_MASK);
  for (gsize i = 0; i < G_N_ELEMENTS (canvas_keys); i++) {
    if (canvas_keys[i].keyval != keyval || canvas_keys[i].modifiers != held)
      continue;
    g_autofree char *name = NULL;
    g_autoptr (GVariant) target = NULL;
    g_action_parse_detailed_name (canvas_keys[i].action, &name, &target, NULL);
    return gtk_widget_activate_action_variant (GTK_WIDGET (self), name, target);
  }
  for (int i = 0; qn_tools[i] != NULL && held == 0; i++) {
    if (gdk_keyval_to_unicode (keyval) == (gunichar) qn_tools[i]->accel[0])
      return gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s",
                                         qn_tools[i]->name);
  }
  return FALSE;
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnCanvas *self)
{
  (void) controller;
  (void) keycode;
  gboolean control = (modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK)) != 0;
  if (keyval == GDK_KEY_Escape) {
    if (self->typed->len > 0)
      g_string_truncate (self->typed, 0);
    else if (self->in_gesture)
      qn_canvas_cancel_gesture (self);
    else if (self->tool != &qn_tool_select)
      gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s", "select");
    else
      qn_selection_clear (qn_canvas_get_selection (self));
  } else if (!self->in_gesture || control)
    return activate_key (self, keyval, modifiers);
  else if ((keyval == GDK_KEY_Return || keyval == GDK_KEY_KP_Enter)
           && self->tool->numbers)
    finish_typed (self);
  else if (keyval == GDK_KEY_BackSpace && self->typed->len > 0)
    g_string_truncate (self->typed, self->typed->len - 1);
  else if (is_number_character (gdk_keyval_to_unicode (keyval))
           && (self->typed->len > 0 || gdk_keyval_to_unicode (keyval) < 0x3a))
    g_string_append_unichar (self->typed, gdk_keyval_to_unicode (keyval));
  else
    return FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
  return TRUE;
}

/* ---- widget ---- */

static void
qn_canvas_snapshot (GtkWidget *widget, GtkSnapshot *snapshot)
{
  QnCanvas *self = QN_CANVAS (widget);
  int width = gtk_widget_get_width (widget), height = gtk_widget_get_height (widget);
  if (self->state == NULL || width <= 0 || height <= 0)
    return;
  gboolean resized = self->camera.width != width || self->camera.height != height;
  self->camera.width = width;
  self->camera.height = height;
  if (self->wants_fit || (resized && self->keeps_fit))
    fit_now (self);
  cairo_t *cr = gtk_snapshot_append_cairo (
    snapshot, &GRAPHENE_RECT_INIT (0, 0, (float) width, (float) height));
  qn_canvas_draw (self, cr);
  cairo_destroy (cr);
}

static void
qn_canvas_dispose (GObject *object)
{
  QnCanvas *self = QN_CANVAS (object);
  if (self->state != NULL) {
    QnDocument *document = qn_view_state_get_document (self->state);
    g_signal_handlers_disconnect_by_data (self->state, self);
    g_signal_handlers_disconnect_by_data (qn_document_get_selection (document), self);
  }
  g_signal_handlers_disconnect_by_data (qn_settings_get (), self);
  g_clear_handle_id (&self->place_timeout, g_source_remove);
  g_clear_handle_id (&self->rest_timeout, g_source_remove);
  qn_scene_cache_clear (&self->cache);
  g_clear_pointer (&self->scene, qn_scene_free);
  g_clear_error (&self->scene_error);
  g_clear_object (&self->state);
  G_OBJECT_CLASS (qn_canvas_parent_class)->dispose (object);
}

static void
qn_canvas_finalize (GObject *object)
{
  QnCanvas *self = QN_CANVAS (object);
  g_free (self->magnet_skip);
  g_string_free (self->typed, TRUE);
  g_array_unref (self->gesture.points);
  G_OBJECT_CLASS (qn_canvas_parent_class)->finalize (object);
}

static void
qn_canvas_class_init (QnCanvasClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  object_class->dispose = qn_canvas_dispose;
  object_class->finalize = qn_canvas_finalize;
  widget_class->snapshot = qn_canvas_snapshot;
  signals[SIGNAL_STATUS] = g_signal_new ("status", QN_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0,
                                         NULL, NULL, NULL, G_TYPE_NONE, 0);
  signals[SIGNAL_FAILED] = g_signal_new ("failed", QN_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0,
                                         NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
  gtk_widget_class_set_css_name (widget_class, "canvas");
  gtk_widget_class_set_accessible_role (widget_class, GTK_ACCESSIBLE_ROLE_IMG);
}

static void
add_controllers (QnCanvas *self)
{
  GtkWidget *widget = GTK_WIDGET (self);
  GtkGesture *click = gtk_gesture_click_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (click), GDK_BUTTON_PRIMARY);
  g_signal_connect (click, "pressed", G_CALLBACK (on_press), self);
  g_signal_connect (click, "released", G_CALLBACK (on_release), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (click));

  GtkGesture *pan = gtk_gesture_drag_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (pan), GDK_BUTTON_MIDDLE);
  g_signal_connect (pan, "drag-begin", G_CALLBACK (on_pan_begin), self);
  g_signal_connect (pan, "drag-update", G_CALLBACK (on_pan_update), self);
  g_signal_connect (pan, "drag-end", G_CALLBACK (on_pan_end), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (pan));

  GtkGesture *pinch = gtk_gesture_zoom_new ();
  g_signal_connect (pinch, "begin", G_CALLBACK (on_pinch_begin), self);
  g_signal_connect (pinch, "scale-changed", G_CALLBACK (on_pinch_changed), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (pinch));

  GtkEventController *motion = gtk_event_controller_motion_new ();
  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), self);
  g_signal_connect (motion, "leave", G_CALLBACK (on_leave), self);
  gtk_widget_add_controller (widget, motion);

  GtkEventController *scroll =
    gtk_event_controller_scroll_new (GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES);
  g_signal_connect (scroll, "scroll", G_CALLBACK (on_scroll), self);
  gtk_widget_add_controller (widget, scroll);

  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (widget, key);
}

static void
qn_canvas_init (QnCanvas *self)
{
  gtk_widget_set_focusable (GTK_WIDGET (self), TRUE);
  gtk_widget_set_overflow (GTK_WIDGET (self), GTK_OVERFLOW_HIDDEN);
  gtk_widget_set_hexpand (GTK_WIDGET (self), TRUE);
  gtk_widget_set_vexpand (GTK_WIDGET (self), TRUE);
  self->camera.scale = 100.0;
  self->camera.unit = PX_PER_POINT;
  self->typed = g_string_new (NULL);
  self->gesture.points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  self->tool = &qn_tool_select;
  self->wants_fit = self->keeps_fit = TRUE;
  add_controllers (self);
}

static void
on_document_changed (QnCanvas *self)
{
  /* Gestures point at blocks of the model that has just gone. */
  if (self->in_gesture)
    qn_canvas_cancel_gesture (self);
  update_description (self);
}

void
qn_canvas_set_state (QnCanvas *self, QnViewState *state, QnToolSettings *settings)
{
  g_return_if_fail (self->state == NULL);
  self->state = g_object_ref (state);
  self->settings = settings;
  g_signal_connect_swapped (state, "changed", G_CALLBACK (on_state_changed), self);
  QnDocument *document = qn_view_state_get_document (state);
  g_signal_connect_object (document, "changed", G_CALLBACK (on_document_changed), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_swapped (qn_document_get_selection (document), "changed",
                            G_CALLBACK (gtk_widget_queue_draw), self);
  g_signal_connect_swapped (qn_settings_get (), "changed",
                            G_CALLBACK (gtk_widget_queue_draw), self);
  update_description (self);
}

QnViewState *
qn_canvas_get_state (QnCanvas *self)
{
  return self->state;
}

QnDocument *
qn_canvas_get_document (QnCanvas *self)
{
  return qn_view_state_get_document (self->state);
}

QnSelection *
qn_canvas_get_selection (QnCanvas *self)
{
  return qn_document_get_selection (qn_canvas_get_document (self));
}

QnToolSettings *
qn_canvas_get_tool_settings (QnCanvas *self)
{
  return self->settings;
}

void
qn_canvas_cancel_gesture (QnCanvas *self)
{
  g_string_truncate (self->typed, 0);
  if (self->tool->cancel != NULL)
    self->tool->cancel (self);
  qn_canvas_set_magnet_skip (self, NULL);
  qn_canvas_set_in_gesture (self, FALSE);
}

void
qn_canvas_set_in_gesture (QnCanvas *self, gboolean in_gesture)
{
  self->in_gesture = in_gesture;
  if (!in_gesture) {
    g_string_truncate (self->typed, 0);
    g_array_set_size (self->gesture.points, 0);
    self->gesture.dragging = FALSE;
    self->gesture.band = FALSE;
  }
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

void
qn_canvas_set_tool (QnCanvas *self, const QnTool *tool)
{
  if (self->in_gesture)
    qn_canvas_cancel_gesture (self);
  self->tool = tool;
  gtk_widget_set_cursor_from_name (GTK_WIDGET (self),
                                   tool == &qn_tool_select ? NULL : "crosshair");
  gtk_widget_queue_draw (GTK_WIDGET (self));
  emit_status (self);
}

const QnTool *
qn_canvas_get_tool (QnCanvas *self)
{
  return self->tool;
}

/* ---- for tools ---- */

QnGesture *
qn_canvas_get_gesture (QnCanvas *self)
{
  return &self->gesture;
}

gboolean
qn_canvas_is_in_gesture (QnCanvas *self)
{
  return self->in_gesture;
}

gboolean
qn_canvas_is_drag (QnCanvas *self, const QnToolEvent *event)
{
  QnVec2 moved = qn_vec2_sub (event->screen, self->gesture.from_screen);
  return qn_vec2_length (moved) > CLICK_PX;
}

QnVec2
qn_canvas_to_screen (QnCanvas *self, QnVec2 point)
{
  return qn_camera_to_screen (&self->camera, point);
}

QnPick
qn_canvas_pick (QnCanvas *self, QnVec2 screen, unsigned kinds)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  if (scene == NULL)
    return (QnPick){ QN_PICK_NOTHING, QN_NONE, 0 };
  return qn_pick_at (scene, &self->camera, screen, PICK_REACH_PX, kinds);
}

void
qn_canvas_pick_inside (QnCanvas *self, QnVec2 a, QnVec2 b, GArray *ids)
{
  const QnScene *scene = qn_canvas_get_scene (self);
  if (scene != NULL)
    qn_pick_inside (scene, &self->camera, a, b, QN_PICK_BLOCK, ids);
}

void
qn_canvas_set_magnet_skip (QnCanvas *self, gboolean *skip)
{
  g_free (self->magnet_skip);
  self->magnet_skip = skip;
}

gboolean
qn_canvas_edit (QnCanvas *self, const char *name, const char *key, QnEditFunc func,
                gpointer data)
{
  g_autoptr (GError) error = NULL;
  if (qn_document_edit (qn_canvas_get_document (self), name, key, func, data, &error))
    return TRUE;
  g_signal_emit (self, signals[SIGNAL_FAILED], 0, error->message);
  return FALSE;
}

static const char *
magnet_word (QnMagnetKind kind)
{
  switch (kind) {
  case QN_MAGNET_CORNER:
    return _ ("corner");
  case QN_MAGNET_MIDDLE:
    return _ ("middle of an edge");
  case QN_MAGNET_EDGE:
    return _ ("edge");
  case QN_MAGNET_COURSE:
    return _ ("course line");
  case QN_MAGNET_GRID:
    return _ ("grid");
  case QN_MAGNET_NOTHING:
    break;
  }
  return NULL;
}

char *
qn_canvas_dup_status (QnCanvas *self)
{
  if (!self->pointer_inside || self->state == NULL)
    return g_strdup ("");
  QnUnits units = qn_settings_get_units ();
  QnVec2 p = self->hit.point;
  double resolution = 1.0 / self->camera.scale;
  p = qn_vec2 (round (p.x / resolution) * resolution,
               round (p.y / resolution) * resolution);
  if (self->hit.kind != QN_MAGNET_NOTHING)
    p = self->hit.point;
  g_autofree char *x = qn_units_format (units, QN_QUANTITY_LENGTH, p.x, 5);
  g_autofree char *y = qn_units_format_full (units, QN_QUANTITY_LENGTH, p.y, 5);
  const char *word = magnet_word (self->hit.kind);
  return word != NULL ? g_strdup_printf ("%s; %s  (%s)", x, y, word)
                      : g_strdup_printf ("%s; %s", x, y);
}
