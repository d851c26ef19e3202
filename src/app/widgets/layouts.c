#include "app/widgets/layouts.h"

#define SPACING    6
#define LEAST_ROWS 7

/* ---- the first that fits ---- */

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
    box, gtk_custom_layout_new (NULL, measure_first_fit, allocate_first_fit));
}

/* ---- beside or below each other ---- */

typedef struct Pair {
  GtkWidget *child[2];
  int least[2], width[2], height[2];
  gboolean beside; /* each other, which there is room for */
} Pair;

static Pair
measure_children (GtkWidget *widget, int room)
{
  Pair pair = { .child = { gtk_widget_get_first_child (widget),
                           gtk_widget_get_last_child (widget) } };
  const int rest = gtk_widget_get_hexpand (pair.child[1]);
  for (int i = 0; i < 2; i++)
    gtk_widget_measure (pair.child[i], GTK_ORIENTATION_HORIZONTAL, -1, &pair.least[i],
                        &pair.width[i], NULL, NULL);
  pair.beside =
    room < 0 || pair.width[0] + SPACING + (rest ? pair.least : pair.width)[1] <= room;
  if (pair.beside && room >= 0)
    pair.width[rest] = room - SPACING - pair.width[!rest];
  for (int i = 0; i < 2; i++) {
    if (!pair.beside)
      pair.width[i] = i <= rest ? room : MAX (pair.least[i], MIN (room, pair.width[i]));
    gtk_widget_measure (pair.child[i], GTK_ORIENTATION_VERTICAL, pair.width[i], NULL,
                        &pair.height[i], NULL, NULL);
  }
  return pair;
}

static void
measure_pair (GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
              int *natural, int *minimum_baseline, int *natural_baseline)
{
  const gboolean across = orientation == GTK_ORIENTATION_HORIZONTAL;
  Pair pair = measure_children (widget, across ? -1 : for_size);
  *minimum = MAX (pair.least[0], pair.least[1]);
  *natural = pair.width[0] + SPACING + pair.width[1];
  if (!across)
    *minimum = *natural = pair.beside ? MAX (pair.height[0], pair.height[1])
                                      : pair.height[0] + SPACING + pair.height[1];
}

static void
allocate_pair (GtkWidget *widget, int width, int height, int baseline)
{
  Pair pair = measure_children (widget, width);
  const int upper =
    gtk_widget_get_hexpand (pair.child[1]) && pair.least[1] > pair.least[0];
  for (int i = 0; i < 2; i++) {
    const int below = pair.beside || i == upper ? 0 : pair.height[upper] + SPACING;
    GtkAllocation place = { i * (width - pair.width[1]), below, pair.width[i],
                            MAX (height - below, 0) };
    if (!pair.beside && i == upper)
      place.height = pair.height[i];
    gtk_widget_size_allocate (pair.child[i], &place, -1);
  }
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
