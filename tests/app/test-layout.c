/* Where things lie: small windows and large text, messages over the drawing, buttons of the views,
 * panels beside the drawing. */
#include "driver.h"

#include "app/canvas/canvas-private.h"
#include "app/window/window-private.h"
#include "support/room.h"

static gboolean
is_tool (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_TOGGLE_BUTTON (widget)
         && g_strcmp0 (gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)),
                       "win.tool")
              == 0;
}

/* Every tool lies in the window, beside or below the one before, whatever the height. */
static void
expect_tools_in_sight (QnWindow *window)
{
  GtkWidget *tool = driver_find_widget (GTK_WIDGET (window), is_tool, NULL);
  int count = 0;
  graphene_rect_t at, before = GRAPHENE_RECT_INIT (0, 0, 0, 0);
  for (; tool != NULL; tool = gtk_widget_get_next_sibling (tool), count++) {
    g_assert_true (gtk_widget_get_mapped (tool));
    g_assert_true (gtk_widget_compute_bounds (tool, GTK_WIDGET (window), &at));
    g_assert_cmpfloat (at.origin.y + at.size.height, <=,
                       gtk_widget_get_height (GTK_WIDGET (window)));
    g_assert_cmpfloat (at.origin.x + at.size.width, <, 200.0f);
    g_assert_false (count > 0 && graphene_rect_intersection (&at, &before, NULL));
    before = at;
  }
  g_assert_cmpint (count, ==, 19);
}

static gboolean
is_title (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LABEL (widget) && gtk_widget_has_css_class (widget, "title");
}

static int
least_width (QnWindow *window)
{
  int width = 0;
  gtk_widget_measure (GTK_WIDGET (window), GTK_ORIENTATION_HORIZONTAL, -1, &width, NULL,
                      NULL, NULL);
  return width;
}

/* The buttons at the lower right lie on no word of the legend. */
static void
expect_legend_free (QnWindow *window)
{
  QnCanvas *canvas = canvas_of (window);
  graphene_rect_t buttons;
  g_assert_true (gtk_widget_compute_bounds (
    driver_find_id (GTK_WIDGET (window), "view_box"), GTK_WIDGET (canvas), &buttons));
  QnBox legend = qn_canvas_legend_box (canvas, qn_canvas_get_scene (canvas));
  g_assert_true (legend.max.x <= (double) buttons.origin.x
                 || legend.max.y <= (double) buttons.origin.y);
  /* It leaves the drawing its room. */
  double part = (legend.max.x - legend.min.x) * (legend.max.y - legend.min.y)
                / gtk_widget_get_width (GTK_WIDGET (canvas))
                / gtk_widget_get_height (GTK_WIDGET (canvas));
  g_assert_cmpfloat (part, <, 0.25);
}

/* It fits into 600 x 500, also with results and a message; the side panel folds away and back. */
static void
test_small_window (void)
{
  QnWindow *window = driver_open_window (600, 500);
  g_autofree char *path = driver_example_path ("ferris-tin-loi/wall3.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_settle ();
  driver_activate (window, "win.run");
  g_assert_cmpint (least_width (window), <=, 600);
  driver_wait_for_job (window);
  driver_activate (window, "win.view::forces");
  qn_window_show_error (window, "A message that is long enough to need more than one "
                                "line where the window is as narrow as this one is.");
  driver_screenshot (GTK_WIDGET (window), "small-window");
  expect_tools_in_sight (window);
  GtkWidget *title = driver_find_widget (GTK_WIDGET (window), is_title, NULL);
  g_assert_false (pango_layout_is_ellipsized (gtk_label_get_layout (GTK_LABEL (title))));
  int width = least_width (window), height = 0;
  gtk_widget_measure (GTK_WIDGET (window), GTK_ORIENTATION_VERTICAL, 600, &height, NULL,
                      NULL, NULL);
  g_test_message ("least size %d x %d", width, height);
  g_assert_cmpint (width, <=, 600);
  g_assert_cmpint (height, <=, 500);
  int canvas = gtk_widget_get_width (GTK_WIDGET (canvas_of (window)));
  g_assert_cmpint (canvas, >, 400);
  /* The panel leaves the drawing its least room, or is there instead. */
  GtkWidget *drawing = GTK_WIDGET (canvas_of (window));
  driver_key ("F9");
  g_assert_true (!gtk_widget_get_mapped (drawing)
                 || gtk_widget_get_width (drawing) < canvas);
  g_assert_cmpint (least_width (window), <=, 600);
  driver_screenshot (GTK_WIDGET (window), "small-window-panel");
  driver_key ("F9");
  g_assert_true (gtk_widget_get_mapped (drawing));
  g_assert_cmpint (gtk_widget_get_width (drawing), ==, canvas);
  static const char *const views[] = { "win.view::forces", "win.view::deformed" };
  for (gsize i = 0; i < G_N_ELEMENTS (views); i++) {
    driver_activate (window, views[i]);
    expect_legend_free (window);
    g_assert_cmpint (least_width (window), <=, 600);
  }
  driver_discard (window);
}

/* A message lies over the drawing, which keeps its place. */
static void
test_message_over_drawing (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  int height = gtk_widget_get_height (GTK_WIDGET (canvas_of (window)));
  expect_tools_in_sight (window);
  qn_window_show_error (window, "Something is wrong, and it takes so many words to tell "
                                "what it is, and where, and what can be done about it, "
                                "that one line of the drawing is too short for them.");
  driver_settle ();
  GtkWidget *canvas = GTK_WIDGET (canvas_of (window));
  g_assert_cmpint (gtk_widget_get_height (canvas), ==, height);
  GtkWidget *bar = window->info_bar;
  graphene_rect_t bounds,
    room =
      GRAPHENE_RECT_INIT (0, 0, (float) gtk_widget_get_width (canvas), (float) height);
  g_assert_true (gtk_widget_compute_bounds (bar, canvas, &bounds));
  g_assert_true (graphene_rect_contains_rect (&room, &bounds));
  driver_screenshot (GTK_WIDGET (window), "message");
  driver_discard (window);
}

/* The buttons of the views keep their places in every view of a result, and take no more of the
 * drawing in one than in another. */
static void
test_views_keep_places (void)
{
  static const char *const views[] = { "win.view::model",    "win.view::contacts",
                                       "win.view::deformed", "win.view::mechanism",
                                       "win.view::forces",   "win.view::diagrams" };
  QnWindow *window = driver_open_example ("34-frame-hybrid.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  graphene_rect_t first, now;
  int height = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (views); i++) {
    driver_activate (window, views[i]);
    driver_settle ();
    GtkWidget *button =
      driver_find_widget (GTK_WIDGET (window), driver_is_button, "Forces");
    GtkWidget *all = gtk_widget_get_ancestor (button, GTK_TYPE_BOX);
    while (!gtk_widget_has_css_class (all, "view-switcher"))
      all = gtk_widget_get_parent (all);
    g_assert_true (gtk_widget_compute_bounds (button, GTK_WIDGET (window), &now));
    if (i == 0) {
      first = now;
      height = gtk_widget_get_height (all);
    }
    g_assert_cmpint (gtk_widget_get_height (all), ==, height);
    g_assert_true (graphene_rect_equal (&first, &now));
  }
  driver_discard (window);
}

/* The multiplier of the step is there in full, with steps of two digits too. */
static void
test_step_in_full (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  g_autofree char *path = driver_example_path ("16-load-stages.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.view::deformed");
  GtkLabel *label = GTK_LABEL (driver_find_id (GTK_WIDGET (window), "step"));
  static const char *const texts[] = { NULL,
                                       "Schritt 125 von 125, Multiplikator 1,0000" };
  for (gsize i = 0; i < G_N_ELEMENTS (texts); i++) {
    if (texts[i] != NULL)
      gtk_label_set_text (label, texts[i]);
    driver_settle ();
    g_assert_false (pango_layout_is_ellipsized (gtk_label_get_layout (label)));
  }
  driver_discard (window);
}

/* Whatever the panels show, the drawing keeps its width. */
static void
test_panels_keep_width (void)
{
  static const char *const panels[] = { "win.show-panel::properties",
                                        "win.show-panel::analysis",
                                        "win.show-panel::result",
                                        "win.show-panel::findings" };
  QnWindow *window = driver_open_example ("16-load-stages.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  int width = gtk_widget_get_width (GTK_WIDGET (canvas_of (window)));
  driver_activate (window, "win.select-all");
  for (gsize i = 0; i < G_N_ELEMENTS (panels); i++) {
    driver_activate (window, panels[i]);
    driver_settle ();
    g_assert_cmpint (gtk_widget_get_width (GTK_WIDGET (canvas_of (window))), ==, width);
  }
  driver_discard (window);
}

/* What switches views lies on the drawing, and on nothing beside it. */
static void
expect_switcher_on_drawing (QnWindow *window)
{
  GtkWidget *canvas = GTK_WIDGET (canvas_of (window));
  GtkWidget *switcher = driver_find_id (GTK_WIDGET (window), "view_switcher");
  graphene_rect_t bounds;
  if (!gtk_widget_get_mapped (canvas))
    return;
  while (!gtk_widget_has_css_class (switcher, "view-switcher"))
    switcher = gtk_widget_get_parent (switcher);
  g_assert_true (gtk_widget_compute_bounds (switcher, canvas, &bounds));
  g_assert_cmpfloat (bounds.origin.x, >=, 0.0f);
  g_assert_cmpfloat (bounds.origin.x + bounds.size.width, <=,
                     (float) gtk_widget_get_width (canvas));
}

static void
close_panel (QnWindow *window)
{
  g_action_group_change_action_state (G_ACTION_GROUP (window), "side-panel",
                                      g_variant_new_boolean (FALSE));
  driver_settle ();
}

/* Large text in a small window: panels and tools fold away, and what fits is the drawing that is seen. */
static void
test_large_text (void)
{
  static const int sizes[][2] = { { 600, 500 }, { 1024, 768 } };
  g_autofree char *font = NULL;
  g_object_get (gtk_settings_get_default (), "gtk-font-name", &font, NULL);
  g_object_set (gtk_settings_get_default (), "gtk-font-name", "Sans 20", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (sizes); i++) {
    QnWindow *window = driver_open_window (sizes[i][0], sizes[i][1]);
    g_autofree char *path = driver_example_path ("ferris-tin-loi/wall3.quoin");
    g_assert_true (qn_window_open_path (window, path));
    driver_settle ();
    close_panel (window);
    int least = 0;
    gtk_widget_measure (GTK_WIDGET (window), GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL,
                        NULL, NULL);
    g_assert_cmpint (least, <=, 600);
    GtkWidget *canvas = GTK_WIDGET (canvas_of (window));
    driver_activate (window, "win.run");
    driver_wait_for_job (window);
    close_panel (window);
    driver_activate (window, "win.fit");
    g_autofree char *name = g_strdup_printf ("large-text-%d", sizes[i][0]);
    driver_screenshot (GTK_WIDGET (window), name);
    QnVec2 foot = qn_canvas_to_screen (QN_CANVAS (canvas), qn_vec2 (0.0, 0.0));
    QnVec2 head = qn_canvas_to_screen (QN_CANVAS (canvas), qn_vec2 (0.0, 1.925));
    g_assert_cmpfloat (foot.y - head.y, >, 0.3 * gtk_widget_get_height (canvas));

    /* The panel takes the place of the drawing where both have no room, and gives it back. */
    driver_open_analysis (window);
    g_autofree char *panel = g_strdup_printf ("large-text-%d-panel", sizes[i][0]);
    driver_screenshot (GTK_WIDGET (window), panel);
    g_assert_true (!gtk_widget_get_mapped (canvas)
                   || gtk_widget_get_width (canvas) >= 250);
    expect_switcher_on_drawing (window);
    close_panel (window);
    g_assert_true (gtk_widget_get_mapped (canvas));
    driver_discard (window);
  }
  g_object_set (gtk_settings_get_default (), "gtk-font-name", font, NULL);
}

QN_TESTS
{
  g_test_add_func ("/app/reach/small-window", test_small_window);
  g_test_add_func ("/app/reach/message", test_message_over_drawing);
  g_test_add_func ("/app/reach/views-keep-places", test_views_keep_places);
  g_test_add_func ("/app/reach/step-in-full", test_step_in_full);
  g_test_add_func ("/app/reach/panels-keep-width", test_panels_keep_width);
  g_test_add_func ("/app/window/large-text", test_large_text);
}
