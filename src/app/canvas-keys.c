/* Keys of the drawing: shortcuts that mean something here alone, and numbers typed for a gesture. */
#include "app/canvas-private.h"

#include "app/settings.h"
#include <glib/gi18n.h>

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
      qn_canvas_emit_failed (self, error->message);
      return;
    }
    count++;
  }
  g_string_truncate (self->typed, 0);
  if (self->tool->numbers == NULL || !self->tool->numbers (self, values, count))
    qn_canvas_emit_failed (self,
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
  qn_canvas_emit_status (self);
  return TRUE;
}

void
qn_canvas_add_key_controller (QnCanvas *self)
{
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (GTK_WIDGET (self), key);
}
