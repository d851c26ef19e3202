/* Pages in place of the drawing: keys, and how they are left. */
#include "driver.h"

#include "app/window/window-private.h"
#include "support/room.h"
#include "support/scratch.h"

static gboolean
shows_page (GtkWidget *widget, gconstpointer page)
{
  return GTK_IS_STACK (widget)
         && g_strcmp0 (gtk_stack_get_visible_child_name (GTK_STACK (widget)), page) == 0;
}

static gboolean
can_act (GtkWidget *widget, gconstpointer action)
{
  return GTK_IS_ACTIONABLE (widget) && gtk_widget_is_sensitive (widget)
         && g_strcmp0 (gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)), action)
              == 0;
}

/* In every page under the drawing: F1 shows what the manual says of it, Ctrl+S saves, Escape goes back to
 * the drawing; Undo acts on the drawing but where the page has steps of its own. */
static void
test_keys (void)
{
  static const char *const pages[][3] = { { "win.capacity", "Capacity", "earthquakes" },
                                          { "win.figures", "Figures", "export" },
                                          { "win.envelope", "Moving Load", "bridges" },
                                          { "win.compare", "Comparison", "results" },
                                          { "win.study", "Study", "uncertainty" } };
  driver_pass_over_gtk ();
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "06-arch.quoin");
  QnDocument *document = qn_window_get_document (window);
  for (gsize i = 0; i < G_N_ELEMENTS (pages); i++) {
    driver_activate (window, "win.select-all");
    driver_activate (window, "win.nudge((0.0,1.0))");
    g_assert_true (qn_document_is_modified (document));
    driver_activate (window, pages[i][0]);
    g_test_message ("%s", pages[i][0]);
    g_assert_nonnull (driver_find_page (pages[i][1]));
    driver_key ("F1");
    GtkWidget *help = driver_find_dialog ("Help");
    g_assert_nonnull (help);
    g_assert_nonnull (driver_find_widget (help, shows_page, pages[i][2]));
    driver_key ("Escape");
    g_assert_null (driver_find_dialog ("Help"));
    driver_key ("ctrl+s");
    g_assert_false (qn_document_is_modified (document));
    gboolean own = qn_window_page_has (window, "undo");
    driver_key ("ctrl+z");
    g_assert_true (qn_document_is_modified (document) == !own);
    driver_key ("Escape");
    g_assert_null (qn_window_get_page (window));
    g_assert_true (gtk_widget_get_mapped (GTK_WIDGET (window->canvas)));
  }
  /* Into a window of their own and back. */
  driver_activate (window, "win.envelope");
  driver_activate (window, "win.own-window");
  driver_activate (window, "win.own-window");
  g_assert_null (window->page_window);
  g_assert_true (gtk_widget_get_root (window->page_box) == GTK_ROOT (window));
  g_assert_true (gtk_widget_get_mapped (driver_find_page ("Moving Load")));
  /* In a window of their own they keep their actions; they come back when it closes. */
  driver_activate (window, "win.study");
  driver_activate (window, "win.own-window");
  GtkWidget *apart = window->page_window;
  g_assert_true (GTK_WIDGET (gtk_widget_get_root (window->page_box)) == apart);
  g_assert_true (gtk_widget_get_mapped (GTK_WIDGET (window->canvas)));
  g_assert_nonnull (driver_find_widget (apart, can_act, "study.save-as"));
  gtk_window_close (GTK_WINDOW (apart));
  driver_settle ();
  g_assert_null (window->page_window);
  g_assert_null (qn_window_get_page (window));
  /* All of them are still there; closed one after the other they leave the drawing. */
  driver_activate (window, "win.compare");
  for (gsize i = 0; i < G_N_ELEMENTS (pages); i++) {
    g_assert_nonnull (qn_window_get_page (window));
    driver_activate (window, "win.close-page");
  }
  g_assert_null (qn_window_get_page (window));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/pages/keys", test_keys);
}
