#include "app/widgets/layouts.h"

#define SPACING    6
#define LEAST_ROWS 7

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

typedef struct Pair {
  GtkWidget *first, *second;
  GtkRequisition least[2], usual[2];
  gboolean beside; /* each other, which there is room for */
} Pair;

static Pair
measure_children (GtkWidget *widget, int width)
{
  Pair pair = { .first = gtk_widget_get_first_child (widget),
                .second = gtk_widget_get_last_child (widget) };
  gtk_widget_get_preferred_size (pair.first, &pair.least[0], &pair.usual[0]);
  gtk_widget_get_preferred_size (pair.second, &pair.least[1], &pair.usual[1]);
  pair.beside = width < 0 || pair.usual[0].width + SPACING + pair.usual[1].width <= width;
  return pair;
}

static void
measure_pair (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
              int *natural, int *minimum_baseline, int *natural_baseline)
{
  Pair pair = measure_children (widget, for_size);
  if (orientation == GTK_ORIENTATION_HORIZONTAL) {
    *minimum = MAX (pair.least[0].width, pair.least[1].width);
    *natural = pair.usual[0].width + SPACING + pair.usual[1].width;
  } else
    *minimum = *natural = pair.beside
                            ? MAX (pair.usual[0].height, pair.usual[1].height)
                            : pair.usual[0].height + SPACING + pair.usual[1].height;
}

static void
allocate_pair (GtkWidget *widget, int width, int height, int baseline)
{
  Pair pair = measure_children (widget, width);
  GtkAllocation first = { 0, 0, width, height }, second = first;
  if (pair.beside) {
    first.width = width - SPACING - pair.usual[1].width;
    second.x = first.width + SPACING;
    second.width = width - second.x;
  } else {
    first.height = MIN (pair.usual[0].height, height);
    second.y = first.height + SPACING;
    second.height = MAX (height - second.y, 0);
    second.width = MAX (pair.least[1].width, MIN (width, pair.usual[1].width));
    second.x = width - second.width;
  }
  gtk_widget_size_allocate (pair.first, &first, -1);
  gtk_widget_size_allocate (pair.second, &second, -1);
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

/* ---- even columns ---- */

/* As few columns as are no higher than that, and the rows of each. */
static int
count_columns (GtkWidget *widget, int height, int *rows, GtkRequisition *cell)
{
  int count = 0;
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child), count++)
    gtk_widget_get_preferred_size (child, cell, NULL);
  int most = height < 0 ? count : CLAMP (height / cell->height, 1, count);
  int columns = (count + most - 1) / most;
  *rows = (count + columns - 1) / columns;
  return columns;
}

static void
measure_columns (GtkWidget *widget, GtkOrientation orientation, int for_size,
                 int *minimum, int *natural, int *minimum_baseline, int *natural_baseline)
{
  int rows;
  GtkRequisition cell;
  if (orientation == GTK_ORIENTATION_HORIZONTAL) {
    *minimum = *natural = count_columns (widget, for_size, &rows, &cell) * cell.width;
    return;
  }
  count_columns (widget, -1, &rows, &cell);
  *minimum = LEAST_ROWS * cell.height;
  *natural = rows * cell.height;
}

static void
allocate_columns (GtkWidget *widget, int width, int height, int baseline)
{
  int rows, i = 0;
  GtkRequisition cell;
  count_columns (widget, height, &rows, &cell);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child), i++)
    gtk_widget_size_allocate (child,
                              &(GtkAllocation){ i / rows * cell.width,
                                                i % rows * cell.height, cell.width,
                                                cell.height },
                              -1);
}

static GtkSizeRequestMode
width_for_height (GtkWidget *widget)
{
  return GTK_SIZE_REQUEST_WIDTH_FOR_HEIGHT;
}

void
qn_layout_even_columns (GtkWidget *box)
{
  gtk_widget_set_layout_manager (
    box, gtk_custom_layout_new (width_for_height, measure_columns, allocate_columns));
}
