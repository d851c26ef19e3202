#include "app/widgets/wrap-pair.h"

#define SPACING 6

struct _QnWrapPair {
  GtkWidget parent_instance;
};

G_DEFINE_FINAL_TYPE (QnWrapPair, qn_wrap_pair, GTK_TYPE_WIDGET)

typedef struct Sizes {
  int least[2], usual[2];
} Sizes;

static Sizes
measure_both (GtkWidget *pair, GtkOrientation orientation)
{
  Sizes sizes;
  GtkWidget *children[] = { gtk_widget_get_first_child (pair),
                            gtk_widget_get_last_child (pair) };
  for (int i = 0; i < 2; i++)
    gtk_widget_measure (children[i], orientation, -1, &sizes.least[i], &sizes.usual[i],
                        NULL, NULL);
  return sizes;
}

/* Whether they stand beside each other; both have the height that they have by themselves. */
static gboolean
fits (const Sizes *widths, int width)
{
  return width < 0 || widths->usual[0] + SPACING + widths->usual[1] <= width;
}

static void
measure (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
         int *natural, int *minimum_baseline, int *natural_baseline)
{
  Sizes widths = measure_both (widget, GTK_ORIENTATION_HORIZONTAL);
  *minimum_baseline = *natural_baseline = -1;
  if (orientation == GTK_ORIENTATION_HORIZONTAL) {
    *minimum = MAX (widths.least[0], widths.least[1]);
    *natural = widths.usual[0] + SPACING + widths.usual[1];
    return;
  }
  Sizes heights = measure_both (widget, GTK_ORIENTATION_VERTICAL);
  *minimum = *natural = fits (&widths, for_size)
                          ? MAX (heights.usual[0], heights.usual[1])
                          : heights.usual[0] + SPACING + heights.usual[1];
}

static void
allocate (GtkWidget *widget, int width, int height, int baseline)
{
  Sizes widths = measure_both (widget, GTK_ORIENTATION_HORIZONTAL);
  Sizes heights = measure_both (widget, GTK_ORIENTATION_VERTICAL);
  GtkAllocation first = { 0, 0, width, height }, second = first;
  (void) baseline;
  if (fits (&widths, width)) {
    first.width = width - SPACING - widths.usual[1];
    second.x = first.width + SPACING;
    second.width = width - second.x;
  } else {
    first.height = MIN (heights.usual[0], height);
    second.y = first.height + SPACING;
    second.height = MAX (height - second.y, 0);
    second.width = MAX (widths.least[1], MIN (width, widths.usual[1]));
    second.x = width - second.width;
  }
  gtk_widget_size_allocate (gtk_widget_get_first_child (widget), &first, -1);
  gtk_widget_size_allocate (gtk_widget_get_last_child (widget), &second, -1);
}

static GtkSizeRequestMode
get_request_mode (GtkWidget *widget)
{
  (void) widget;
  return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void
qn_wrap_pair_dispose (GObject *object)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (GTK_WIDGET (object))) != NULL)
    gtk_widget_unparent (child);
  G_OBJECT_CLASS (qn_wrap_pair_parent_class)->dispose (object);
}

static void
qn_wrap_pair_class_init (QnWrapPairClass *klass)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  G_OBJECT_CLASS (klass)->dispose = qn_wrap_pair_dispose;
  widget_class->measure = measure;
  widget_class->size_allocate = allocate;
  widget_class->get_request_mode = get_request_mode;
}

static void
qn_wrap_pair_init (QnWrapPair *self)
{
  (void) self;
}

GtkWidget *
qn_wrap_pair_new (GtkWidget *first, GtkWidget *second)
{
  GtkWidget *pair = g_object_new (QN_TYPE_WRAP_PAIR, NULL);
  gtk_widget_set_parent (first, pair);
  gtk_widget_set_parent (second, pair);
  return pair;
}
