#include "app/widgets/quantity-entry.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <math.h>

#define SHOWN_DIGITS 7
#define WIDTH_CHARS  9

struct _QnQuantityEntry {
  GtkEntry parent_instance;
  QnQuantity quantity;
  double least, most;
  double value;
  gulong settings_handler;
};

G_DEFINE_FINAL_TYPE (QnQuantityEntry, qn_quantity_entry, GTK_TYPE_ENTRY)

enum { SIGNAL_COMMITTED, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

static void
set_trouble (QnQuantityEntry *self, const char *message)
{
  GtkWidget *widget = GTK_WIDGET (self);
  gtk_widget_set_tooltip_text (widget, message);
  if (message != NULL)
    gtk_widget_add_css_class (widget, "error");
  else
    gtk_widget_remove_css_class (widget, "error");
  gtk_accessible_update_state (
    GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_STATE_INVALID,
    message != NULL ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

static void
show_value (QnQuantityEntry *self)
{
  g_autofree char *text = qn_units_format_full (qn_settings_get_units (), self->quantity,
                                                self->value, SHOWN_DIGITS);
  gtk_editable_set_text (GTK_EDITABLE (self), text);
  set_trouble (self, NULL);
}

static void
commit (QnQuantityEntry *self)
{
  QnUnits units = qn_settings_get_units ();
  const char *text = gtk_editable_get_text (GTK_EDITABLE (self));
  g_autofree char *shown =
    qn_units_format_full (units, self->quantity, self->value, SHOWN_DIGITS);
  if (g_str_equal (text, shown)) {
    set_trouble (self, NULL);
    return;
  }
  double value = 0.0;
  g_autoptr (GError) error = NULL;
  if (!qn_units_parse (units, self->quantity, text, &value, &error)) {
    set_trouble (self, error->message);
    return;
  }
  if (!(value >= self->least && value <= self->most)) {
    g_autofree char *least =
      qn_units_format_full (units, self->quantity, self->least, SHOWN_DIGITS);
    g_autofree char *most =
      qn_units_format_full (units, self->quantity, self->most, SHOWN_DIGITS);
    g_autofree char *message = g_strdup_printf (_ ("Must be from %s to %s"), least, most);
    set_trouble (self, message);
    return;
  }
  self->value = value;
  show_value (self);
  g_signal_emit (self, signals[SIGNAL_COMMITTED], 0);
}

static void
on_focus_leave (GtkEventControllerFocus *controller, QnQuantityEntry *self)
{
  (void) controller;
  commit (self);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnQuantityEntry *self)
{
  (void) controller;
  (void) keycode;
  (void) modifiers;
  if (keyval != GDK_KEY_Escape)
    return FALSE;
  show_value (self);
  return FALSE;
}

static void
qn_quantity_entry_dispose (GObject *object)
{
  QnQuantityEntry *self = QN_QUANTITY_ENTRY (object);
  g_clear_signal_handler (&self->settings_handler, qn_settings_get ());
  G_OBJECT_CLASS (qn_quantity_entry_parent_class)->dispose (object);
}

static void
qn_quantity_entry_class_init (QnQuantityEntryClass *klass)
{
  G_OBJECT_CLASS (klass)->dispose = qn_quantity_entry_dispose;
  signals[SIGNAL_COMMITTED] =
    g_signal_new ("committed", QN_TYPE_QUANTITY_ENTRY, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                  NULL, G_TYPE_NONE, 0);
}

static void
qn_quantity_entry_init (QnQuantityEntry *self)
{
  gtk_editable_set_width_chars (GTK_EDITABLE (self), WIDTH_CHARS);
  gtk_editable_set_max_width_chars (GTK_EDITABLE (self), WIDTH_CHARS);
  gtk_editable_set_alignment (GTK_EDITABLE (self), 1.0f);
  /* Numbers run from left to right in every script. */
  gtk_widget_set_direction (GTK_WIDGET (self), GTK_TEXT_DIR_LTR);
  g_signal_connect (self, "activate", G_CALLBACK (commit), NULL);
  GtkEventController *focus = gtk_event_controller_focus_new ();
  g_signal_connect (focus, "leave", G_CALLBACK (on_focus_leave), self);
  gtk_widget_add_controller (GTK_WIDGET (self), focus);
  GtkEventController *key = gtk_event_controller_key_new ();
  gtk_event_controller_set_propagation_phase (key, GTK_PHASE_CAPTURE);
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (GTK_WIDGET (self), key);
  self->settings_handler = g_signal_connect_swapped (qn_settings_get (), "changed",
                                                     G_CALLBACK (show_value), self);
}

GtkWidget *
qn_quantity_entry_new (QnQuantity quantity, double least, double most)
{
  QnQuantityEntry *self = g_object_new (QN_TYPE_QUANTITY_ENTRY, NULL);
  self->quantity = quantity;
  self->least = least;
  self->most = most;
  show_value (self);
  return GTK_WIDGET (self);
}

double
qn_quantity_entry_get_value (QnQuantityEntry *self)
{
  return self->value;
}

void
qn_quantity_entry_set_value (QnQuantityEntry *self, double value)
{
  if (self->value == value)
    return;
  self->value = value;
  show_value (self);
}
