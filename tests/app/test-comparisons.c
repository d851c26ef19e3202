/* Results and variants beside each other: their order, their names, what is dragged onto them. */
#include "menu-driver.h"

#include "app/widgets/row.h"
#include "support/room.h"

static guint
count_pictures (GtkWidget *dialog)
{
  GtkWidget *grid =
    gtk_widget_get_parent (driver_find_widget (dialog, driver_is_cell, NULL));
  guint count = 0;
  for (GtkWidget *child = gtk_widget_get_first_child (grid); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    count += driver_is_cell (child, NULL);
  return count;
}

static GtkWidget *
label_of (GtkWidget *picture)
{
  GtkWidget *label = gtk_widget_get_first_child (picture);
  while (!GTK_IS_LABEL (label))
    label = gtk_widget_get_next_sibling (label);
  return label;
}

/* The words beneath a picture, a new string. */
static char *
dup_words (GtkWidget *picture)
{
  return g_strdup (gtk_label_get_text (GTK_LABEL (label_of (picture))));
}

/* A wall solved by load control and by limit analysis. */
static QnWindow *
open_two_runs (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  return window;
}

static void
test_comparison (void)
{
  QnWindow *window = open_two_runs ();
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 2);
  GtkWidget *first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *words = dup_words (first);
  gtk_widget_grab_focus (first);
  menu_check_keys (first, "Later");
  menu_right_click (first);
  driver_screenshot (driver_find_widget (first, driver_is_menu, NULL), "menu-comparison");
  menu_choose (first, "Later");
  first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *after = dup_words (first);
  g_assert_cmpstr (words, !=, after);
  menu_right_click (first);
  menu_choose (first, "Remove from Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 1);
  first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *left = dup_words (first);
  g_assert_true (g_str_has_suffix (words, left)); /* alone it needs no name beneath */
  /* The picture that stayed has the focus. */
  driver_key ("Delete");
  driver_settle ();
  g_assert_null (driver_find_widget (dialog, driver_is_cell, NULL));
  driver_discard (window);
}

static gboolean
is_name (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_ENTRY (widget)
         && g_str_equal (gtk_editable_get_text (GTK_EDITABLE (widget)), text);
}

static void
set_friction (QnWindow *window, const char *number)
{
  driver_open_analysis (window);
  GtkWidget *row = driver_find_widget (GTK_WIDGET (window), menu_is_row, "Friction");
  GtkWidget *friction = qn_row_get_field (QN_ROW (row));
  gtk_widget_grab_focus (friction);
  driver_key ("ctrl+a");
  driver_type (number);
  driver_key ("Return");
}

/* Three variants are told apart by what differs, until one is given a name over its picture; the name is
 * in the table, is undone, and is typed in the panel of results too. */
static void
test_variants (void)
{
  static const char *const frictions[] = { "0.3", "0.8" };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_key ("F5");
  driver_wait_for_job (window);
  for (gsize i = 0; i < G_N_ELEMENTS (frictions); i++) {
    set_friction (window, frictions[i]);
    driver_key ("F5");
    driver_wait_for_job (window);
  }
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 3);
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "friction 0.3"));
  GtkWidget *name = driver_find_widget (dialog, is_name, "friction 0.8");
  g_assert_nonnull (name);
  driver_screenshot (dialog, "comparison-names");
  GtkWidget *outcome = driver_find_widget (dialog, driver_says, "Outcome");
  GtkAdjustment *across = gtk_scrollable_get_hadjustment (
    GTK_SCROLLABLE (gtk_widget_get_ancestor (outcome, GTK_TYPE_VIEWPORT)));
  g_assert_cmpfloat (gtk_adjustment_get_upper (across), <=,
                     gtk_adjustment_get_page_size (across) + 1.0);
  /* Solved again it stays where it stands, of the project still. */
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  g_assert_null (
    driver_find_widget (dialog, driver_says, "Changed")); /* the names say it */
  g_assert_cmpuint (count_pictures (dialog), ==, 3);
  name = driver_find_widget (dialog, is_name, "friction 0.8");
  driver_point_at (name, 0.5 * gtk_widget_get_width (name), 8.0);
  driver_press_button ("1");
  driver_key ("ctrl+a");
  driver_type ("rough joints");
  driver_key ("Return");
  g_assert_cmpstr (driver_last_step (window), ==, "Rename Run");
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "rough joints"));
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "Changed"));
  driver_key ("Escape");
  g_assert_null (driver_find_page ("Comparison"));
  driver_key ("ctrl+z");
  const QnRun *run = qn_window_get_document (window)->run;
  g_assert_cmpstr (run->label, ==, "friction 0.8");

  driver_activate (window, "win.show-panel::result");
  GtkWidget *entry = driver_find_id (GTK_WIDGET (window), "run_name");
  gtk_widget_grab_focus (entry);
  driver_key ("ctrl+a");
  driver_type ("rough");
  driver_key ("Tab"); /* leaving takes it, too */
  g_assert_cmpstr (run->name, ==, "rough, load control");
  driver_screenshot (GTK_WIDGET (window), "run-name");
  driver_discard (window);
}

/* All methods after one of them add the others alone. */
static void
test_all_methods (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  const GPtrArray *runs = qn_window_get_document (window)->runs;
  driver_key ("F5");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-all");
  driver_wait_for_job (window);
  g_assert_cmpuint (runs->len, ==, 3);
  for (guint i = 0; i < runs->len; i++)
    for (guint k = 0; k < i; k++)
      g_assert_cmpstr (((QnRun *) runs->pdata[i])->name, !=,
                       ((QnRun *) runs->pdata[k])->name);
  driver_discard (window);
}

/* ---- dragging ---- */

static void
press (gboolean down)
{
  const char *const arguments[] = { down ? "mousedown" : "mouseup", "1", NULL };
  driver_xdotool (arguments);
}

/* Moves the pointer in steps: a drag begins and is followed by its motion. */
static void
move_along (double x0, double y0, double x1, double y1)
{
  for (int i = 1; i <= 8; i++) {
    g_autofree char *x = g_strdup_printf ("%.0f", x0 + (x1 - x0) * i / 8.0);
    g_autofree char *y = g_strdup_printf ("%.0f", y0 + (y1 - y0) * i / 8.0);
    const char *const arguments[] = { "mousemove", x, y, NULL };
    driver_xdotool (arguments);
  }
}

/* Middle of a widget on the screen, in a window at its corner. */
static void
find_middle (GtkWidget *widget, double *x, double *y)
{
  GtkNative *native = gtk_widget_get_native (widget);
  double left, top;
  gtk_native_get_surface_transform (native, &left, &top);
  gtk_widget_translate_coordinates (widget, GTK_WIDGET (native),
                                    0.5 * gtk_widget_get_width (widget),
                                    0.5 * gtk_widget_get_height (widget), x, y);
  *x += left;
  *y += top;
}

/* The words beneath the first picture, dragged onto the second with the pointer. */
static void
test_drag_caption (void)
{
  QnWindow *window = open_two_runs ();
  GtkWidget *dialog = driver_find_page ("Comparison");
  GtkWidget *first = driver_find_widget (dialog, driver_is_cell, NULL);
  GtkWidget *second = gtk_widget_get_next_sibling (first);
  g_autofree char *words = dup_words (second);
  double x0, y0, x1, y1;
  GtkWidget *label = label_of (first);
  find_middle (label, &x0, &y0);
  find_middle (second, &x1, &y1);
  driver_point_at (label, 0.5 * gtk_widget_get_width (label),
                   0.5 * gtk_widget_get_height (label));
  press (TRUE);
  move_along (x0, y0, x1, y1);
  press (FALSE);
  driver_settle ();
  g_autofree char *after = dup_words (driver_find_widget (dialog, driver_is_cell, NULL));
  g_assert_cmpstr (after, ==, words);
  driver_discard (window);
}

/* A window to the right of the others, from which files can be dragged. */
static GdkContentProvider *
give_files (GtkDragSource *source, double x, double y, gpointer data)
{
  const char *const *names = data;
  GSList *files = NULL;
  (void) source;
  (void) x;
  (void) y;
  for (guint i = 0; names[i] != NULL; i++) {
    g_autofree char *path = driver_example_path (names[i]);
    files = g_slist_append (files, g_file_new_for_path (path));
  }
  GdkContentProvider *content =
    gdk_content_provider_new_typed (GDK_TYPE_FILE_LIST, files);
  g_slist_free_full (files, g_object_unref);
  return content;
}

static void
drag_files (const char *const *names, GtkWidget *onto)
{
  GtkWidget *window = gtk_window_new ();
  GtkDragSource *source = gtk_drag_source_new ();
  gtk_window_set_title (GTK_WINDOW (window), "files of the test");
  gtk_window_set_decorated (GTK_WINDOW (window), FALSE);
  gtk_window_set_default_size (GTK_WINDOW (window), 200, 200);
  gtk_window_set_child (GTK_WINDOW (window), gtk_label_new ("files"));
  g_signal_connect (source, "prepare", G_CALLBACK (give_files), (gpointer) names);
  gtk_widget_add_controller (window, GTK_EVENT_CONTROLLER (source));
  gtk_window_present (GTK_WINDOW (window));
  driver_settle ();
  const char *const aside[] = { "search",     "--name", "files of the test",
                                "windowmove", "1600",   "700",
                                NULL };
  driver_xdotool (aside);
  const char *const there[] = { "mousemove", "1700", "800", NULL };
  driver_xdotool (there);
  press (TRUE);
  double x, y;
  find_middle (onto, &x, &y);
  move_along (1700, 800, x, y);
  press (FALSE);
  driver_settle ();
  gtk_window_destroy (GTK_WINDOW (window));
}

static gboolean
has_path (gpointer data)
{
  return qn_window_get_document (data)->path != NULL;
}

static gboolean
has_two_pictures (gpointer dialog)
{
  return driver_find_widget (dialog, driver_is_cell, NULL) != NULL
         && count_pictures (dialog) == 2;
}

/* A project dropped on an empty window is opened; two on a comparison are solved and shown. */
static void
test_drop_files (void)
{
  static const char *const one[] = { "06-arch.quoin", NULL };
  static const char *const two[] = { "02-overturning-block.quoin", "05-stack.quoin",
                                     NULL };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_window (1200, 760);
  drag_files (one, GTK_WIDGET (window));
  driver_wait (has_path, window);
  g_assert_true (
    g_str_has_suffix (qn_window_get_document (window)->path, "06-arch.quoin"));
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  drag_files (two, dialog);
  driver_wait (has_two_pictures, dialog);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/comparisons/comparison", test_comparison);
  g_test_add_func ("/app/comparisons/variants", test_variants);
  g_test_add_func ("/app/comparisons/all-methods", test_all_methods);
  g_test_add_func ("/app/comparisons/drag-caption", test_drag_caption);
  g_test_add_func ("/app/comparisons/drop-files", test_drop_files);
}
