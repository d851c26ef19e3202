/* Keys of the drawing: shortcuts that mean something here alone, and numbers typed for a gesture. */
#include "app/canvas/canvas-private.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <string.h>

static void
refuse_typed (QnCanvas *self)
{
  g_autofree char *message =
    g_strdup_printf (_ ("What can be typed here: %s"), _ (self->tool->numbers_label));
  qn_canvas_tell (self, message);
}

static void
finish_typed (QnCanvas *self)
{
  double values[QN_TOOL_NUMBERS];
  int count = 0;
  QnUnits units = qn_settings_get_units ();
  g_auto (GStrv) words = g_strsplit_set (self->typed->str, ";x×", -1);
  for (guint i = 0; words[i] != NULL; i++) {
    if (*g_strstrip (words[i]) == '\0')
      continue;
    g_autoptr (GError) error = NULL;
    /* What an earlier phase of the gesture has settled is not typed again. */
    int place = count + self->gesture.phase;
    if (place >= QN_TOOL_NUMBERS) {
      refuse_typed (self);
      return;
    }
    QnQuantity quantity = self->gesture.grip.kind == QN_GRIP_TURN
                            ? QN_QUANTITY_ANGLE
                            : self->tool->quantities[place];
    if (!qn_units_parse (units, quantity, words[i], &values[count], &error)) {
      qn_canvas_tell (self, error->message);
      return;
    }
    count++;
  }
  g_string_truncate (self->typed, 0);
  if (!self->tool->numbers (self, values, count))
    refuse_typed (self);
}

/* Numbers are typed for a gesture, with the button held or up, and for what is selected; the first
 * sign of the latter is one that no shortcut has. */
static gboolean
can_type (QnCanvas *self, gunichar first)
{
  if (self->in_gesture || self->typed->len > 0)
    return TRUE;
  QnVec2 low, high;
  return self->tool->numbers_at_rest && !qn_view_needs_result (self->state->options.view)
         && ((first < 128 && g_ascii_isdigit ((char) first)) || first == '-'
             || first == '(')
         && qn_canvas_get_parts_box (self, &low, &high);
}

/* ---- the pointer by keys ---- */

/* Grid lines that a press of an arrow key passes: usually, with Control, with Shift. */
#define CURSOR_STEP      1.0
#define CURSOR_LEAP      5.0
#define CURSOR_FINE_STEP 0.2

/* Arrow keys move the pointer unless they nudge what is selected. */
static gboolean
move_cursor (QnCanvas *self, guint keyval, GdkModifierType modifiers)
{
  const QnVec2 way = { (keyval == GDK_KEY_Right) - (keyval == GDK_KEY_Left),
                       (keyval == GDK_KEY_Down) - (keyval == GDK_KEY_Up) };
  if (way.x == 0.0 && way.y == 0.0)
    return FALSE;
  if (self->tool == self->resting && !self->in_gesture
      && !qn_selection_is_empty (self->selection))
    return FALSE;
  if (!self->keyboard_cursor && !self->pointer_inside)
    self->pointer = qn_vec2 (0.5 * self->camera.width, 0.5 * self->camera.height);
  double lines = modifiers & GDK_CONTROL_MASK ? CURSOR_LEAP
                 : modifiers & GDK_SHIFT_MASK ? CURSOR_FINE_STEP
                                              : CURSOR_STEP;
  double step = lines * qn_canvas_grid_distance (self) / 5.0;
  /* From where the magnet has it, so that steps along the grid stay on the grid. */
  QnVec2 from = self->hit.kind != QN_MAGNET_NOTHING && self->keyboard_cursor
                  ? qn_camera_to_screen (&self->camera, self->hit.point)
                  : self->pointer;
  QnVec2 at = qn_vec2_add_scaled (from, step * self->camera.scale, way);
  at.x = CLAMP (at.x, 0.0, self->camera.width);
  at.y = CLAMP (at.y, 0.0, self->camera.height);
  self->keyboard_cursor = TRUE;
  qn_canvas_point (self, at, modifiers & GDK_ALT_MASK);
  return TRUE;
}

/* Enter where nothing is typed is a click at the pointer that the keys have moved. */
static gboolean
click_cursor (QnCanvas *self, guint keyval, GdkModifierType modifiers)
{
  if ((keyval != GDK_KEY_Return && keyval != GDK_KEY_KP_Enter) || self->typed->len > 0
      || !self->keyboard_cursor)
    return FALSE;
  qn_canvas_click (self, modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK));
  return TRUE;
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnCanvas *self)
{
  gboolean control = (modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK)) != 0;
  gunichar c = gdk_keyval_to_unicode (keyval);
  if (keyval == GDK_KEY_Escape) {
    if (self->typed->len > 0)
      g_string_truncate (self->typed, 0);
    else if (self->in_gesture)
      qn_canvas_cancel_gesture (self);
    else if (self->tool != self->resting)
      gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s",
                                  self->resting->name);
    else
      qn_selection_clear (self->selection);
  } else if (move_cursor (self, keyval, modifiers)
             || click_cursor (self, keyval, modifiers))
    return TRUE;
  else if (control || !can_type (self, c))
    return FALSE;
  else if ((keyval == GDK_KEY_Return || keyval == GDK_KEY_KP_Enter)
           && self->tool->numbers)
    finish_typed (self);
  else if (keyval == GDK_KEY_BackSpace && self->typed->len > 0)
    g_string_truncate (self->typed, self->typed->len - 1);
  /* A number begins without a letter; behind it every sign belongs to it, so that a unit which does not
   * fit is refused and not passed over. */
  else if (self->typed->len > 0
             ? g_unichar_isprint (c)
             : c > 0 && c < 128 && strchr ("0123456789.,-+( ", (int) c) != NULL)
    g_string_append_unichar (self->typed, c);
  else
    return FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
  qn_canvas_emit_status (self);
  return TRUE;
}

void
qn_canvas_bind_keys (GtkWidgetClass *klass)
{
  gtk_widget_class_bind_template_callback (klass, on_key);
}
