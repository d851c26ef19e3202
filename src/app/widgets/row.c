#include "app/widgets/row.h"

#define SPACING 12

/* A label that is longer asks for no more width than this: it may wrap. */
#define LABEL_CHARS 14

/* Steps in which a row is widened until it is low enough, and the width at which that ends, px. */
#define WIDER  16
#define WIDEST 2000

struct _QnRow {
  GtkWidget parent_instance;
  GtkLabel *label;
  GtkWidget *field;
};

G_DEFINE_FINAL_TYPE (QnRow, qn_row, GTK_TYPE_WIDGET)

enum { PROPERTY_LABEL = 1, PROPERTY_FIELD, PROPERTY_COUNT };

/* ---- layout ----
 *
 * As a horizontal box, but for the widths, which are asked of label and field without a height: a box
 * asks with the height that it is given, and labels of one size group that wrap in other rows would
 * answer as if they stood in one line here. The natural width for a height is one at which the row is no
 * higher: a box above takes the least such width for its own minimum, which may not exceed what it finds
 * natural. */

static void
split (QnRow *self, int width, int *label, int *field)
{
  GtkWidget *const parts[] = { GTK_WIDGET (self->label), self->field };
  GtkRequestedSize sizes[2];
  int rest = width - SPACING;
  for (int i = 0; i < 2; i++) {
    sizes[i].data = parts[i];
    gtk_widget_measure (parts[i], GTK_ORIENTATION_HORIZONTAL, -1, &sizes[i].minimum_size,
                        &sizes[i].natural_size, NULL, NULL);
    rest -= sizes[i].minimum_size;
  }
  rest = gtk_distribute_natural_allocation (MAX (rest, 0), 2, sizes);
  int more =
    gtk_widget_compute_expand (self->field, GTK_ORIENTATION_HORIZONTAL) ? rest / 2 : 0;
  *label = sizes[0].minimum_size + rest - more;
  *field = sizes[1].minimum_size + more;
}

static void
measure (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
         int *natural, int *minimum_baseline, int *natural_baseline)
{
  QnRow *self = QN_ROW (widget);
  int sizes[2] = { -1, -1 }, least[2], usual[2];
  *minimum_baseline = *natural_baseline = -1;
  if (orientation == GTK_ORIENTATION_VERTICAL && for_size >= 0)
    split (self, for_size, &sizes[0], &sizes[1]);
  gtk_widget_measure (GTK_WIDGET (self->label), orientation, sizes[0], &least[0],
                      &usual[0], NULL, NULL);
  gtk_widget_measure (self->field, orientation, sizes[1], &least[1], &usual[1], NULL,
                      NULL);
  gboolean beside = orientation == GTK_ORIENTATION_HORIZONTAL;
  *minimum = beside ? least[0] + SPACING + least[1] : MAX (least[0], least[1]);
  *natural = beside ? usual[0] + SPACING + usual[1] : MAX (usual[0], usual[1]);
  for (int high; beside && for_size >= 0 && *natural < WIDEST; *natural += WIDER) {
    gtk_widget_measure (widget, GTK_ORIENTATION_VERTICAL, *natural, &high, NULL, NULL,
                        NULL);
    if (high <= for_size)
      break;
  }
}

static void
allocate (GtkWidget *widget, int width, int height, int baseline)
{
  QnRow *self = QN_ROW (widget);
  gboolean mirrored = gtk_widget_get_direction (widget) == GTK_TEXT_DIR_RTL;
  int label, field;
  split (self, width, &label, &field);
  gtk_widget_size_allocate (
    GTK_WIDGET (self->label),
    &(GtkAllocation){ mirrored ? width - label : 0, 0, label, height }, -1);
  gtk_widget_size_allocate (
    self->field, &(GtkAllocation){ mirrored ? 0 : width - field, 0, field, height }, -1);
}

static GtkSizeRequestMode
get_request_mode (GtkWidget *widget)
{
  return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

/* ---- life ---- */

static void
qn_row_set_property (GObject *object, guint id, const GValue *value, GParamSpec *pspec)
{
  QnRow *self = QN_ROW (object);
  if (id == PROPERTY_LABEL)
    gtk_label_set_text_with_mnemonic (self->label, g_value_get_string (value));
  else if (id == PROPERTY_FIELD) {
    GtkWidget *field = g_value_get_object (value);
    self->field = field;
    gtk_widget_set_parent (field, GTK_WIDGET (self));
    gtk_label_set_mnemonic_widget (self->label, field);
    gtk_accessible_update_relation (
      GTK_ACCESSIBLE (field), GTK_ACCESSIBLE_RELATION_LABELLED_BY, self->label, NULL, -1);
    g_object_bind_property (field, "visible", self, "visible", G_BINDING_SYNC_CREATE);
  } else
    G_OBJECT_WARN_INVALID_PROPERTY_ID (object, id, pspec);
}

static void
qn_row_dispose (GObject *object)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (GTK_WIDGET (object))) != NULL)
    gtk_widget_unparent (child);
  G_OBJECT_CLASS (qn_row_parent_class)->dispose (object);
}

static void
qn_row_class_init (QnRowClass *klass)
{
  GObjectClass *object_class = G_OBJECT_CLASS (klass);
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  object_class->dispose = qn_row_dispose;
  widget_class->measure = measure;
  widget_class->size_allocate = allocate;
  widget_class->get_request_mode = get_request_mode;
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
  gtk_widget_set_parent (GTK_WIDGET (self->label), GTK_WIDGET (self));
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
