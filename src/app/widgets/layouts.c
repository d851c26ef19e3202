#include "app/widgets/layouts.h"

#define SPACING 6

/* ---- the first that fits ---- */

static GtkSizeRequestMode
constant_size (GtkWidget *widget)
{
  return GTK_SIZE_REQUEST_CONSTANT_SIZE;
}

/* As wide as the last child at least, and as the widest by itself; as high as the highest. */
static void
measure_first_fit (GtkWidget *widget, GtkOrientation orientation, int for_size,
                   int *minimum, int *natural, int *minimum_baseline,
                   int *natural_baseline)
{
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
allocate_first_fit (GtkWidget *widget, int width, int height, int baseline)
{
  gboolean placed = FALSE;
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

void
qn_layout_first_fit (GtkWidget *box)
{
  gtk_widget_set_layout_manager (
    box, gtk_custom_layout_new (constant_size, measure_first_fit, allocate_first_fit));
}

/* ---- beside or below each other ---- */

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
measure_pair (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
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
allocate_pair (GtkWidget *widget, int width, int height, int baseline)
{
  Sizes widths = measure_both (widget, GTK_ORIENTATION_HORIZONTAL);
  Sizes heights = measure_both (widget, GTK_ORIENTATION_VERTICAL);
  GtkAllocation first = { 0, 0, width, height }, second = first;
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
height_for_width (GtkWidget *widget)
{
  return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

void
qn_layout_wrap_pair (GtkWidget *box)
{
  gtk_widget_set_layout_manager (
    box, gtk_custom_layout_new (height_for_width, measure_pair, allocate_pair));
}
