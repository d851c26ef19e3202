/* F1 opens the page of the manual that is about what has the focus. */
#include "driver.h"

#include "app/widgets/help.h"
#include "support/room.h"

static void
expect_page (QnWindow *window, const char *page)
{
  g_autofree char *resource = g_strdup_printf ("/io/github/quoin/Quoin/help/%s.md",
                                               qn_window_get_help_page (window));
  g_assert_cmpstr (qn_window_get_help_page (window), ==, page);
  g_assert_true (g_resources_get_info (resource, 0, NULL, NULL, NULL));
}

static gboolean
is_shown_stack (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_STACK (widget);
}

static void
expect_help (const char *page)
{
  driver_settle ();
  GtkWidget *help = driver_find_dialog ("Help");
  g_assert_nonnull (help);
  GtkWidget *stack = driver_find_widget (help, is_shown_stack, NULL);
  g_assert_cmpstr (gtk_stack_get_visible_child_name (GTK_STACK (stack)), ==, page);
  g_autofree char *french =
    g_strdup_printf ("/io/github/quoin/Quoin/help/fr/%s.md", page);
  g_assert_true (g_resources_get_info (french, 0, NULL, NULL, NULL));
  driver_screenshot (help, "help");
  gtk_window_destroy (GTK_WINDOW (help));
  driver_settle ();
}

/* What F1 does in a dialog; without a window manager the X server gives it no keys. */
static void
press_help_key (GtkWidget *dialog)
{
  g_autoptr (GtkShortcutTrigger) key = gtk_keyval_trigger_new (GDK_KEY_F1, 0);
  g_autoptr (GListModel) controllers = gtk_widget_observe_controllers (dialog);
  gboolean pressed = FALSE;
  for (guint i = 0; i < g_list_model_get_n_items (controllers); i++) {
    g_autoptr (GObject) controller = g_list_model_get_item (controllers, i);
    GListModel *keys =
      GTK_IS_SHORTCUT_CONTROLLER (controller) ? G_LIST_MODEL (controller) : NULL;
    for (guint k = 0; keys != NULL && k < g_list_model_get_n_items (keys); k++) {
      g_autoptr (GtkShortcut) shortcut = g_list_model_get_item (keys, k);
      if (gtk_shortcut_trigger_equal (gtk_shortcut_get_trigger (shortcut), key))
        pressed = gtk_shortcut_action_activate (gtk_shortcut_get_action (shortcut), 0,
                                                dialog, NULL);
    }
  }
  g_assert_true (pressed);
}

static void
test_context (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  expect_page (window, "first-wall");
  g_autofree char *path = driver_example_path ("12-facade.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_settle ();
  expect_page (window, "drawing");
  QnSelection *selection = qn_window_get_document (window)->selection;
  qn_selection_set_opening (selection, 0, 0);
  expect_page (window, "openings");
  qn_selection_set_one (selection, QN_PICK_FACE, 3);
  expect_page (window, "joints");
  qn_selection_clear (selection);
  static const char *const tools[][2] = {
    { "wall", "openings" },  { "beam", "frames" },  { "support", "loads" },
    { "force", "loads" },    { "joint", "joints" }, { "picture", "import" },
    { "polygon", "drawing" }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (tools); i++) {
    g_autofree char *action = g_strconcat ("win.tool::", tools[i][0], NULL);
    driver_activate (window, action);
    expect_page (window, tools[i][1]);
  }
  driver_key ("F1");
  expect_help ("drawing");

  /* A widget has the page of what is around it, or none. */
  GtkWidget *outer = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0),
            *inner = gtk_label_new ("");
  g_object_ref_sink (outer);
  gtk_box_append (GTK_BOX (outer), inner);
  g_assert_null (qn_help_find_page (inner));
  qn_help_set_page (outer, "results");
  g_assert_cmpstr (qn_help_find_page (inner), ==, "results");
  g_object_unref (outer);
  driver_discard (window);
}

static void
test_dialogs (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.export");
  GtkWidget *dialog = driver_find_dialog ("Export Figure");
  g_assert_nonnull (dialog);
  press_help_key (dialog);
  expect_help ("export");
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_activate (window, "win.study");
  driver_key ("F1");
  expect_help ("uncertainty");
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/help/context", test_context);
  g_test_add_func ("/app/help/dialogs", test_dialogs);
}
