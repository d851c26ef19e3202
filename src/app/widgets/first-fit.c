#include "app/widgets/first-fit.h"

struct _QnFirstFit {
  GtkWidget parent_instance;
};

G_DEFINE_FINAL_TYPE (QnFirstFit, qn_first_fit, GTK_TYPE_WIDGET)

/* As wide as the last child at least, and as the widest by itself; as high as the highest. */
static void
measure (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
         int *natural, int *minimum_baseline, int *natural_baseline)
{
  (void) for_size;
  *minimum = *natural = 0;
  *minimum_baseline = *natural_baseline = -1;
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child)) {
    int least, usual;
    gtk_widget_measure (child, orientation, -1, &least, &usual, NULL, NULL);
    *minimum = orientation == GTK_ORIENTATION_HORIZONTAL ? least : MAX (*minimum, least);
    *natural = MAX (*natural, usual);
  }
}

static void
allocate (GtkWidget *widget, int width, int height, int baseline)
{
  gboolean placed = FALSE;
  (void) baseline;
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child)) {
    int least;
    gtk_widget_measure (child, GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL, NULL, NULL);
    gboolean fits =
      !placed && (least <= width || gtk_widget_get_next_sibling (child) == NULL);
    gtk_widget_set_child_visible (child, fits);
    if (fits)
      gtk_widget_size_allocate (child, &(GtkAllocation){ 0, 0, width, height }, -1);
    placed = placed || fits;
  }
}

static GtkSizeRequestMode
get_request_mode (GtkWidget *widget)
{
  (void) widget;
  return GTK_SIZE_REQUEST_CONSTANT_SIZE;
}

static void
qn_first_fit_dispose (GObject *object)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (GTK_WIDGET (object))) != NULL)
    gtk_widget_unparent (child);
  G_OBJECT_CLASS (qn_first_fit_parent_class)->dispose (object);
}

static void
qn_first_fit_class_init (QnFirstFitClass *klass)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  G_OBJECT_CLASS (klass)->dispose = qn_first_fit_dispose;
  widget_class->measure = measure;
  widget_class->size_allocate = allocate;
  widget_class->get_request_mode = get_request_mode;
}

static void
qn_first_fit_init (QnFirstFit *self)
{
  (void) self;
}
