/* Whether the window holds what it has to say: with strings as long as German ones, from right to
 * left, in the dark, at twice the scale, with large text, in high contrast. Everything must fit a screen of 1280 x 800; pictures of
 * the states are kept for the eye. Nothing lies beyond what it is in, no panel is cut, no label is left
 * without letters. QUOIN_LOOK names the look: plain, long, rtl, dark, large (twice the scale), text (of
 * 20 points), contrast, contrast-dark, or a language. */
#include "driver.h"

#include "app/widgets/builder.h"
#include "app/widgets/settings.h"

#include <glib/gstdio.h>
#include <libintl.h>
#include <string.h>

enum { SCREEN_WIDTH = 1280, SCREEN_HEIGHT = 800 };

static const char *look;

static void
complain (GtkWidget *widget, const char *what, const char *words)
{
  GString *path = g_string_new (NULL);
  for (GtkWidget *w = widget; w != NULL; w = gtk_widget_get_parent (w)) {
    const char *id = gtk_buildable_get_buildable_id (GTK_BUILDABLE (w));
    g_string_append_printf (path, "%s%s%s%s", path->len > 0 ? " in " : "",
                            G_OBJECT_TYPE_NAME (w), id != NULL ? " " : "",
                            id != NULL ? id : "");
  }
  g_test_message ("%s, %s: %s: %s%s", look, what, words, path->str,
                  GTK_IS_LABEL (widget) ? gtk_label_get_text (GTK_LABEL (widget)) : "");
  g_string_free (path, TRUE);
  g_test_fail ();
}

/* Only what scrolls may be larger than what it is in; and labels of buttons, and sliders, which GTK draws
 * beyond their rooms. */
static gboolean
may_be_larger (GtkWidget *parent)
{
  return gtk_widget_get_overflow (parent) == GTK_OVERFLOW_HIDDEN
         || GTK_IS_REVEALER (parent) || GTK_IS_BUTTON (parent)
         || gtk_widget_get_ancestor (parent, GTK_TYPE_RANGE) != NULL;
}

/* What asks for the most width, from the outside to the inside as long as one part does. */
static GtkWidget *
find_widest (GtkWidget *widget)
{
  GtkWidget *widest = NULL;
  int most = 0;
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child)) {
    int least = 0;
    gtk_widget_measure (child, GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL, NULL, NULL);
    if (gtk_widget_get_mapped (child) && least > most) {
      widest = child;
      most = least;
    }
  }
  return widest == NULL || most < 250 ? widget : find_widest (widest);
}

static void
walk (GtkWidget *widget, const char *what)
{
  GtkWidget *parent = gtk_widget_get_parent (widget);
  if (!gtk_widget_get_child_visible (widget) || !gtk_widget_get_mapped (widget)
      || GTK_IS_NATIVE (widget))
    return;
  graphene_rect_t bounds;
  if (!may_be_larger (parent) && gtk_widget_compute_bounds (widget, parent, &bounds)
      && (bounds.origin.x < -1.0f || bounds.origin.y < -1.0f
          || bounds.origin.x + bounds.size.width
               > (float) gtk_widget_get_width (parent) + 13.0f
          || bounds.origin.y + bounds.size.height
               > (float) gtk_widget_get_height (parent) + 13.0f))
    complain (widget, what, "lies beyond what it is in");
  if (GTK_IS_VIEWPORT (widget)) {
    GtkAdjustment *across = gtk_scrollable_get_hadjustment (GTK_SCROLLABLE (widget));
    if (gtk_widget_get_ancestor (widget, GTK_TYPE_STACK) != NULL
        && gtk_widget_has_css_class (
          gtk_widget_get_parent (gtk_widget_get_ancestor (widget, GTK_TYPE_STACK)),
          "side-panel")
        && gtk_adjustment_get_upper (across)
             > gtk_adjustment_get_page_size (across) + 1.0)
      complain (find_widest (widget), what, "is cut to the right");
  }
  if (GTK_IS_LABEL (widget)) {
    PangoLayout *layout = gtk_label_get_layout (GTK_LABEL (widget));
    if (pango_layout_is_ellipsized (layout) && gtk_widget_get_width (widget) < 24)
      complain (widget, what, "has no letter left");
    if (pango_layout_is_ellipsized (layout) && !gtk_widget_get_has_tooltip (widget))
      complain (widget, what, "is cut short without a tooltip");
  }
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    walk (child, what);
}

static void
walk_below (GtkWidget *window, const char *what)
{
  for (GtkWidget *child = gtk_widget_get_first_child (window); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    walk (child, what);
}

static void
expect_to_fit (GtkWidget *window, const char *what)
{
  driver_unfold (window);
  driver_settle ();
  int width = 0, height = 0;
  gtk_widget_measure (window, GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL, NULL, NULL);
  gtk_widget_measure (window, GTK_ORIENTATION_VERTICAL, -1, &height, NULL, NULL, NULL);
  g_test_message ("%s, %s: at least %d x %d", look, what, width, height);
  g_assert_cmpint (width, <=, SCREEN_WIDTH);
  g_assert_cmpint (height, <=, SCREEN_HEIGHT);
  g_autofree char *name = g_strdup_printf ("look-%s-%s", look, what);
  driver_screenshot (window, name);
  walk_below (window, what);
}

static void
expect_dialog_to_fit (const char *what)
{
  driver_settle ();
  GtkWidget *dialog = driver_find_other ();
  g_assert_nonnull (dialog);
  expect_to_fit (dialog, what);
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_settle ();
}

static void
test_window (void)
{
  QnWindow *window = driver_open_window (SCREEN_WIDTH, SCREEN_HEIGHT);
  expect_to_fit (GTK_WIDGET (window), "start");
  g_autofree char *path = driver_example_path ("ferris-tin-loi/wall3.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  expect_to_fit (GTK_WIDGET (window), "result");
  driver_open_analysis (window);
  expect_to_fit (GTK_WIDGET (window), "analysis");
  driver_activate (window, "win.view::contacts");
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.show-panel::properties");
  expect_to_fit (GTK_WIDGET (window), "properties");
  qn_selection_set_one (qn_window_get_document (window)->selection, QN_PICK_FACE, 40);
  expect_to_fit (GTK_WIDGET (window), "joint");
  driver_activate (window, "win.show-panel::findings");
  expect_to_fit (GTK_WIDGET (window), "findings");
  driver_discard (window);
}

/* Masonry with an opening selected: the longest form there is. */
static void
test_masonry (void)
{
  QnWindow *window = driver_open_window (SCREEN_WIDTH, SCREEN_HEIGHT);
  g_autofree char *path = driver_example_path ("12-facade.quoin");
  g_assert_true (qn_window_open_path (window, path));
  qn_selection_set_opening (qn_window_get_document (window)->selection, 0, 0);
  expect_to_fit (GTK_WIDGET (window), "opening");
  driver_activate (window, "win.tool::arch");
  expect_to_fit (GTK_WIDGET (window), "arch");
  driver_discard (window);
}

/* A window of 1024 px has room for a page and the panel beside it, with text of usual size. */
static void
expect_page_to_fit (QnWindow *window, const char *what)
{
  int width = 0;
  driver_settle ();
  gtk_widget_measure (GTK_WIDGET (window), GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL,
                      NULL, NULL);
  g_test_message ("%s, page %s: %d", look, what, width);
  if (strstr (look, "text") == NULL)
    g_assert_cmpint (width, <=, 1024);
  expect_to_fit (GTK_WIDGET (window), what);
}

static gboolean
has_envelope (gpointer window)
{
  return g_action_group_get_action_enabled (
    g_object_get_data (G_OBJECT (qn_window_get_page (window)), QN_ACTIONS), "worst");
}

static void
test_pages (void)
{
  QnWindow *window = driver_open_window (1024, 700);
  g_autofree char *path = driver_example_path ("53-arch-bridge.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.capacity");
  expect_page_to_fit (window, "capacity");
  driver_activate (window, "win.envelope");
  expect_page_to_fit (window, "envelope");
  driver_activate (window, "win.run-shown");
  driver_wait (has_envelope, window);
  expect_page_to_fit (window, "envelope-found");
  driver_discard (window);
}

static void
test_dialogs (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  GActionGroup *program = G_ACTION_GROUP (driver_application ());
  driver_activate (window, "win.export");
  expect_dialog_to_fit ("export");
  driver_activate (window, "win.figures");
  expect_to_fit (GTK_WIDGET (window), "figures");
  g_autofree char *drawing = driver_example_path ("dxf/wall-clutter.dxf");
  driver_activate_target (window, "win.take-path", g_variant_new_string (drawing));
  expect_dialog_to_fit ("import");
  g_action_group_activate_action (program, "preferences", NULL);
  expect_dialog_to_fit ("preferences");
  g_action_group_activate_action (program, "help", NULL);
  expect_dialog_to_fit ("help");
  driver_activate (window, "win.study");
  expect_to_fit (GTK_WIDGET (window), "study");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  expect_to_fit (GTK_WIDGET (window), "compare");
  driver_activate (window, "win.export-result::animation");
  expect_dialog_to_fit ("animation");
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  gtk_window_close (GTK_WINDOW (window));
  expect_dialog_to_fit ("unsaved");
  driver_discard (window);
}

/* A window with an example in a folder that is the same everywhere, since the title names it. */
static QnWindow *
open_copy (const char *example, int width, int height)
{
  QnWindow *window = driver_open_window (width, height);
  g_autofree char *path = driver_example_path (example);
  g_autofree char *name = g_path_get_basename (path);
  g_autofree char *folder = g_build_filename (g_get_tmp_dir (), "walls", NULL);
  g_autofree char *copy = g_build_filename (folder, name, NULL);
  g_autofree char *text = NULL;
  g_mkdir_with_parents (folder, 0755);
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  g_assert_true (g_file_set_contents (copy, text, -1, NULL));
  g_assert_true (qn_window_open_path (window, copy));
  driver_settle ();
  return window;
}

static void
discard_copy (QnWindow *window)
{
  const char *path = qn_window_get_document (window)->path;
  g_autofree char *copy = g_strdup (path);
  g_autofree char *folder = g_path_get_dirname (copy);
  driver_discard (window);
  g_remove (copy);
  g_rmdir (folder);
}

static void
solve_and_show_mechanism (QnWindow *window)
{
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.view::mechanism");
  driver_activate (window, "win.fit");
}

/* The picture of the README: a wall that was solved, with its mechanism. */
static void
test_picture (void)
{
  QnWindow *window = open_copy ("ferris-tin-loi/wall3.quoin", 1400, 900);
  solve_and_show_mechanism (window);
  driver_screenshot (GTK_WIDGET (window), "window");
  discard_copy (window);
}

/* Pictures of the manual, which docs/window.sh takes. */
static void
manual_picture (GtkWidget *window, const char *name)
{
  driver_settle ();
  g_autofree char *full = g_strdup_printf ("manual-%s-%s", look, name);
  driver_screenshot (window, full);
}

static void
manual_dialog (const char *name)
{
  driver_settle ();
  GtkWidget *dialog = driver_find_other ();
  g_assert_nonnull (dialog);
  manual_picture (dialog, name);
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_settle ();
}

static void
test_manual_results (void)
{
  QnWindow *window = open_copy ("ferris-tin-loi/wall3.quoin", 1100, 720);
  driver_activate (window, "win.view::contacts");
  qn_selection_set_one (qn_window_get_document (window)->selection, QN_PICK_FACE, 40);
  driver_activate (window, "win.show-panel::properties");
  manual_picture (GTK_WIDGET (window), "contacts");
  qn_selection_clear (qn_window_get_document (window)->selection);
  driver_activate (window, "win.show-panel::analysis");
  gtk_expander_set_expanded (
    GTK_EXPANDER (driver_find_id (GTK_WIDGET (window), "method")), TRUE);
  driver_activate (window, "win.view::model");
  manual_picture (GTK_WIDGET (window), "analysis");
  solve_and_show_mechanism (window);
  manual_picture (GTK_WIDGET (window), "result");
  driver_activate (window, "win.export");
  manual_dialog ("export");
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  manual_picture (GTK_WIDGET (window), "compare");
  discard_copy (window);
}

static void
test_manual_drawing (void)
{
  QnWindow *window = open_copy ("12-facade.quoin", 1100, 720);
  qn_selection_set_opening (qn_window_get_document (window)->selection, 0, 0);
  driver_activate (window, "win.show-panel::properties");
  manual_picture (GTK_WIDGET (window), "opening");
  g_autofree char *drawing = driver_example_path ("dxf/wall-clutter.dxf");
  driver_activate_target (window, "win.take-path", g_variant_new_string (drawing));
  manual_dialog ("import");
  discard_copy (window);
}

int
main (int argc, char **argv)
{
  look = g_getenv ("QUOIN_LOOK");
  if (look == NULL)
    look = "plain";
  g_test_init (&argc, &argv, NULL);
  const char *catalogues = g_getenv ("QUOIN_CATALOGUES");
  if (catalogues != NULL) {
    bindtextdomain ("quoin", catalogues);
    bind_textdomain_codeset ("quoin", "UTF-8");
    textdomain ("quoin");
  }
  gtk_init ();
  if (g_str_equal (look, "rtl"))
    gtk_widget_set_default_direction (GTK_TEXT_DIR_RTL);
  if (strstr (look, "dark") != NULL)
    g_settings_set_string (qn_settings_get (), "style", "dark");
  if (strstr (look, "text") != NULL)
    g_object_set (gtk_settings_get_default (), "gtk-font-name", "Sans 20", NULL);
  if (strstr (look, "contrast") != NULL)
    g_object_set (gtk_settings_get_default (), "gtk-theme-name", "Default-hc", NULL);
  g_test_add_func ("/app/look/window", test_window);
  g_test_add_func ("/app/look/masonry", test_masonry);
  g_test_add_func ("/app/look/dialogs", test_dialogs);
  g_test_add_func ("/app/look/pages", test_pages);
  if (g_str_equal (look, "plain"))
    g_test_add_func ("/app/look/picture", test_picture);
  if (g_str_equal (look, "plain") || g_str_equal (look, "fr")) {
    g_test_add_func ("/app/look/manual-results", test_manual_results);
    g_test_add_func ("/app/look/manual-drawing", test_manual_drawing);
  }
  return g_test_run ();
}
