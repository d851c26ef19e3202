#include "app/widgets/quantity-entry.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <math.h>

#define SHOWN_DIGITS 7
#define WIDTH_CHARS  9
#define USUAL_CHARS  12 /* all digits with a unit */

struct _QnQuantityEntry {
  GtkEntry parent_instance;
  QnQuantity quantity;
  double least, most;
  double value, previous; /* SI; before the last one was entered */
  gboolean troubled;
  gboolean mixed;
};

G_DEFINE_FINAL_TYPE (QnQuantityEntry, qn_quantity_entry, GTK_TYPE_ENTRY)

enum { SIGNAL_COMMITTED, SIGNAL_REFUSED, SIGNAL_MENU, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

enum { PROPERTY_QUANTITY = 1, PROPERTY_LEAST, PROPERTY_MOST };

/* Quantities as .ui files name them. */
static GType
quantity_type (void)
{
  static const GEnumValue values[] = {
    { QN_QUANTITY_NUMBER, "QN_QUANTITY_NUMBER", "number" },
    { QN_QUANTITY_LENGTH, "QN_QUANTITY_LENGTH", "length" },
    { QN_QUANTITY_DIAMETER, "QN_QUANTITY_DIAMETER", "diameter" },
    { QN_QUANTITY_ANGLE, "QN_QUANTITY_ANGLE", "angle" },
    { QN_QUANTITY_ROTATION, "QN_QUANTITY_ROTATION", "rotation" },
    { QN_QUANTITY_FORCE, "QN_QUANTITY_FORCE", "force" },
    { QN_QUANTITY_MOMENT, "QN_QUANTITY_MOMENT", "moment" },
    { QN_QUANTITY_STRESS, "QN_QUANTITY_STRESS", "stress" },
    { QN_QUANTITY_PRESSURE, "QN_QUANTITY_PRESSURE", "pressure" },
    { QN_QUANTITY_STIFFNESS, "QN_QUANTITY_STIFFNESS", "stiffness" },
    { QN_QUANTITY_SURFACE_STIFFNESS, "QN_QUANTITY_SURFACE_STIFFNESS",
      "surface-stiffness" },
    { QN_QUANTITY_UNIT_WEIGHT, "QN_QUANTITY_UNIT_WEIGHT", "unit-weight" },
    { QN_QUANTITY_DENSITY, "QN_QUANTITY_DENSITY", "density" },
    { QN_QUANTITY_TIME, "QN_QUANTITY_TIME", "time" },
    { QN_QUANTITY_ENERGY, "QN_QUANTITY_ENERGY", "energy" },
    { QN_QUANTITY_SURFACE_ENERGY, "QN_QUANTITY_SURFACE_ENERGY", "surface-energy" },
    { 0, NULL, NULL }
  };
  G_STATIC_ASSERT (G_N_ELEMENTS (values) == QN_QUANTITY_COUNT + 1);
  static GType type;
  if (type == 0)
    type = g_enum_register_static ("QnQuantity", values);
  return type;
}

static void
set_trouble (QnQuantityEntry *self, const char *message)
{
  GtkWidget *widget = GTK_WIDGET (self);
  self->troubled = message != NULL;
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
on_secondary_press (GtkGestureClick *gesture, int count, double x, double y,
                    QnQuantityEntry *self)
{
  g_signal_emit (self, signals[SIGNAL_MENU], 0);
}

static char *
dup_shown (QnQuantityEntry *self)
{
  return self->mixed ? g_strdup ("")
                     : qn_units_format_full (qn_settings_get_units (), self->quantity,
                                             self->value, SHOWN_DIGITS);
}

static void
show_value (QnQuantityEntry *self)
{
  g_autofree char *text = dup_shown (self);
  gtk_editable_set_text (GTK_EDITABLE (self), text);
  gtk_entry_set_placeholder_text (GTK_ENTRY (self), self->mixed ? _ ("various") : NULL);
  set_trouble (self, NULL);
}

static void
commit (QnQuantityEntry *self)
{
  QnUnits units = qn_settings_get_units ();
  const char *text = gtk_editable_get_text (GTK_EDITABLE (self));
  g_autofree char *shown = dup_shown (self);
  if (g_str_equal (text, shown)) {
    set_trouble (self, NULL);
    return;
  }
  double value = 0.0;
  g_autoptr (GError) error = NULL;
  if (!qn_units_parse (units, self->quantity, text, &value, &error)) {
    set_trouble (self, error->message);
    g_signal_emit (self, signals[SIGNAL_REFUSED], 0, error->message);
    return;
  }
  if (!(value >= self->least && value <= self->most)) {
    g_autofree char *least =
      qn_units_format_full (units, self->quantity, self->least, SHOWN_DIGITS);
    g_autofree char *most =
      qn_units_format_full (units, self->quantity, self->most, SHOWN_DIGITS);
    g_autofree char *message = g_strdup_printf (_ ("Must be from %s to %s"), least, most);
    set_trouble (self, message);
    g_signal_emit (self, signals[SIGNAL_REFUSED], 0, message);
    return;
  }
  self->previous = self->value;
  self->value = value;
  self->mixed = FALSE;
  show_value (self);
  g_signal_emit (self, signals[SIGNAL_COMMITTED], 0);
}

static void
on_focus_leave (GtkEventControllerFocus *controller, QnQuantityEntry *self)
{
  commit (self);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnQuantityEntry *self)
{
  if (keyval == GDK_KEY_Escape)
    show_value (self);
  else if (keyval == GDK_KEY_Menu
           || (keyval == GDK_KEY_F10 && (modifiers & GDK_SHIFT_MASK) != 0))
    g_signal_emit (self, signals[SIGNAL_MENU], 0);
  return FALSE;
}

static void
qn_quantity_entry_set_property (GObject *object, guint id, const GValue *value,
                                GParamSpec *pspec)
{
  QnQuantityEntry *self = QN_QUANTITY_ENTRY (object);
  if (id == PROPERTY_QUANTITY) {
    self->quantity = (QnQuantity) g_value_get_enum (value);
    show_value (self);
  } else if (id == PROPERTY_LEAST)
    self->least = g_value_get_double (value);
  else if (id == PROPERTY_MOST)
    self->most = g_value_get_double (value);
  else
    G_OBJECT_WARN_INVALID_PROPERTY_ID (object, id, pspec);
}

/* Not before: GTK empties an entry that is being made. */
static void
qn_quantity_entry_constructed (GObject *object)
{
  G_OBJECT_CLASS (qn_quantity_entry_parent_class)->constructed (object);
  gtk_entry_set_input_hints (GTK_ENTRY (object), GTK_INPUT_HINT_NO_EMOJI);
  show_value (QN_QUANTITY_ENTRY (object));
}

static void
qn_quantity_entry_class_init (QnQuantityEntryClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  object_class->constructed = qn_quantity_entry_constructed;
  object_class->set_property = qn_quantity_entry_set_property;
  g_object_class_install_property (
    object_class, PROPERTY_QUANTITY,
    g_param_spec_enum ("quantity", NULL, NULL, quantity_type (), QN_QUANTITY_NUMBER,
                       G_PARAM_WRITABLE));
  g_object_class_install_property (object_class, PROPERTY_LEAST,
                                   g_param_spec_double ("least", NULL, NULL, -INFINITY,
                                                        INFINITY, -INFINITY,
                                                        G_PARAM_WRITABLE));
  g_object_class_install_property (object_class, PROPERTY_MOST,
                                   g_param_spec_double ("most", NULL, NULL, -INFINITY,
                                                        INFINITY, INFINITY,
                                                        G_PARAM_WRITABLE));
  signals[SIGNAL_COMMITTED] =
    g_signal_new ("committed", QN_TYPE_QUANTITY_ENTRY, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                  NULL, G_TYPE_NONE, 0);
  signals[SIGNAL_REFUSED] =
    g_signal_new ("refused", QN_TYPE_QUANTITY_ENTRY, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                  NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
  signals[SIGNAL_MENU] = g_signal_new ("menu", QN_TYPE_QUANTITY_ENTRY, G_SIGNAL_RUN_LAST,
                                       0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void
qn_quantity_entry_init (QnQuantityEntry *self)
{
  self->least = -INFINITY;
  self->most = INFINITY;
  gtk_editable_set_width_chars (GTK_EDITABLE (self), WIDTH_CHARS);
  gtk_editable_set_max_width_chars (GTK_EDITABLE (self), USUAL_CHARS);
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
  GtkGesture *press = gtk_gesture_click_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (press), GDK_BUTTON_SECONDARY);
  gtk_event_controller_set_propagation_phase (GTK_EVENT_CONTROLLER (press),
                                              GTK_PHASE_CAPTURE);
  g_signal_connect (press, "pressed", G_CALLBACK (on_secondary_press), self);
  gtk_widget_add_controller (GTK_WIDGET (self), GTK_EVENT_CONTROLLER (press));
  g_signal_connect_object (qn_settings_get (), "changed", G_CALLBACK (show_value), self,
                           G_CONNECT_SWAPPED);
}

GtkWidget *
qn_quantity_entry_new (QnQuantity quantity, double least, double most)
{
  return g_object_new (QN_TYPE_QUANTITY_ENTRY, "quantity", quantity, "least", least,
                       "most", most, NULL);
}

void
qn_quantity_entry_refuse (QnQuantityEntry *self, const char *message)
{
  self->value = self->previous;
  set_trouble (self, message);
}

double
qn_quantity_entry_get_value (QnQuantityEntry *self)
{
  return self->value;
}

gboolean
qn_quantity_entry_get_other (QnQuantityEntry *self, guint attempt, double *value)
{
  double near = 1e-3 * fabs (self->value);
  const double steps[] = { near > 0 ? near : 1e-3, near > 0 ? -near : -1e-3, 1, -1 };
  if (attempt >= G_N_ELEMENTS (steps))
    return FALSE;
  *value = CLAMP (self->value + steps[attempt], self->least, self->most);
  return TRUE;
}

void
qn_quantity_entry_set_value (QnQuantityEntry *self, double value)
{
  if (self->value == value && !self->troubled && !self->mixed)
    return;
  self->value = value;
  self->mixed = FALSE;
  show_value (self);
}

void
qn_quantity_entry_set_mixed (QnQuantityEntry *self)
{
  if (self->mixed && !self->troubled)
    return;
  self->mixed = TRUE;
  show_value (self);
}
