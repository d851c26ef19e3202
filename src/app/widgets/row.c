#include "app/widgets/row.h"

#define SPACING 12

/* A label that is longer asks for no more width than this: it may wrap. */
#define LABEL_CHARS 14

struct _QnRow {
  GtkBox parent_instance;
  GtkLabel *label;
  GtkWidget *field;
};

G_DEFINE_FINAL_TYPE (QnRow, qn_row, GTK_TYPE_BOX)

enum { PROPERTY_LABEL = 1, PROPERTY_FIELD, PROPERTY_COUNT };

static void
set_field (QnRow *self, GtkWidget *field)
{
  self->field = field;
  gtk_box_append (GTK_BOX (self), field);
  gtk_label_set_mnemonic_widget (self->label, field);
  gtk_accessible_update_relation (
    GTK_ACCESSIBLE (field), GTK_ACCESSIBLE_RELATION_LABELLED_BY, self->label, NULL, -1);
  g_object_bind_property (field, "visible", self, "visible", G_BINDING_SYNC_CREATE);
}

static void
qn_row_set_property (GObject *object, guint id, const GValue *value, GParamSpec *pspec)
{
  QnRow *self = QN_ROW (object);
  if (id == PROPERTY_LABEL)
    gtk_label_set_text_with_mnemonic (self->label, g_value_get_string (value));
  else if (id == PROPERTY_FIELD)
    set_field (self, g_value_get_object (value));
  else
    G_OBJECT_WARN_INVALID_PROPERTY_ID (object, id, pspec);
}

static void
qn_row_class_init (QnRowClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  object_class->set_property = qn_row_set_property;
  g_object_class_install_property (
    object_class, PROPERTY_LABEL,
    g_param_spec_string ("label", NULL, NULL, "", G_PARAM_WRITABLE));
  g_object_class_install_property (
    object_class, PROPERTY_FIELD,
    g_param_spec_object ("field", NULL, NULL, GTK_TYPE_WIDGET, G_PARAM_WRITABLE));
}

static void
qn_row_init (QnRow *self)
{
  self->label = GTK_LABEL (gtk_label_new (NULL));
  gtk_label_set_xalign (self->label, 0.0f);
  gtk_label_set_wrap (self->label, TRUE);
  gtk_label_set_max_width_chars (self->label, LABEL_CHARS);
  gtk_widget_set_hexpand (GTK_WIDGET (self->label), TRUE);
  gtk_box_set_spacing (GTK_BOX (self), SPACING);
  gtk_box_append (GTK_BOX (self), GTK_WIDGET (self->label));
}

GtkWidget *
qn_row_new (const char *label, GtkWidget *field)
{
  return g_object_new (QN_TYPE_ROW, "label", label, "field", field, NULL);
}

GtkWidget *
qn_row_get_label (QnRow *self)
{
  return GTK_WIDGET (self->label);
}

GtkWidget *
qn_row_get_field (QnRow *self)
{
  return self->field;
}

char *
qn_row_dup_name (QnRow *self)
{
  return g_strdup (gtk_label_get_text (self->label));
}
