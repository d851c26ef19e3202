#include "app/widgets/quantity-entry.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <math.h>

#define SHOWN_DIGITS 7

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
  static const char *const names[] = {
    "number",  "length", "diameter", "angle",         "rotation",          "force",
    "moment",  "stress", "pressure", "stiffness",     "surface-stiffness", "unit-weight",
    "density", "time",   "energy",   "surface-energy"
  };
  G_STATIC_ASSERT (G_N_ELEMENTS (names) == QN_QUANTITY_COUNT);
  static GEnumValue values[QN_QUANTITY_COUNT + 1];
  for (int i = 0; i < QN_QUANTITY_COUNT; i++)
    values[i] = (GEnumValue){ i, names[i], names[i] };
  return g_enum_register_static ("QnQuantity", values);
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

/* What GTK's context menu, which opens next, has besides its own. */
static void
make_menu (QnQuantityEntry *self)
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

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnQuantityEntry *self)
{
  if (keyval == GDK_KEY_Escape)
    show_value (self);
  else if (keyval == GDK_KEY_Menu
           || (keyval == GDK_KEY_F10 && (modifiers & GDK_SHIFT_MASK) != 0))
    make_menu (self);
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
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
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
  gtk_widget_class_set_template_from_resource (
    widget_class, "/io/github/quoin/Quoin/quantity-entry.ui");
  gtk_widget_class_bind_template_callback (widget_class, commit);
  gtk_widget_class_bind_template_callback (widget_class, on_key);
  gtk_widget_class_bind_template_callback (widget_class, make_menu);
}

static void
qn_quantity_entry_init (QnQuantityEntry *self)
{
  self->least = -INFINITY;
  self->most = INFINITY;
  gtk_widget_init_template (GTK_WIDGET (self));
  /* Numbers run from left to right in every script. */
  gtk_widget_set_direction (GTK_WIDGET (self), GTK_TEXT_DIR_LTR);
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
