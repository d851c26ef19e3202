/* The moving load in the window: found in the background, dragged over the bridge with the pointer and by
 * keys, put into the project, written. */
#include "driver.h"

#include "app/pages/pages.h"
#include "app/widgets/builder.h"
#include "study/cases/envelope.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static gboolean
is_found (gpointer page)
{
  return !gtk_widget_get_visible (driver_find_id (page, "progress"));
}

/* The words under the picture. */
static const char *
words (GtkWidget *page)
{
  return gtk_label_get_text (GTK_LABEL (driver_find_id (page, "status")));
}

static double
position (GtkWidget *page)
{
  return gtk_range_get_value (GTK_RANGE (driver_find_id (page, "scale")));
}

static const QnLoad *
vehicle_of (QnWindow *window)
{
  const QnModel *model = model_of (window);
  return &model->live_loads[qn_find_vehicle_load (model)];
}

static gboolean
has_legend (QnWindow *window, const char *text)
{
  const QnScene *scene = qn_canvas_get_scene (canvas_of (window));
  for (guint i = 0; i < scene->legend->len; i++)
    if (g_str_equal (g_array_index (scene->legend, QnLegendEntry, i).text, text))
      return TRUE;
  return FALSE;
}

/* From the bridge of the examples to the worst position, its picture and table. */
static void
test_bridge (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *pdf = g_build_filename (folder, "e.pdf", NULL);
  g_autofree char *csv = g_build_filename (folder, "e.csv", NULL);
  g_autofree char *bytes = NULL;
  g_autofree char *table = NULL;
  QnWindow *window = driver_open_example ("53-arch-bridge.quoin");
  g_assert_true (has_legend (window, "live load: vehicle CS 454 bogie 1.3 m"));
  g_assert_false (has_legend (window, "live load: load on edges"));
  driver_activate (window, "win.envelope");
  GtkWidget *page = driver_find_page ("Moving Load");
  g_assert_nonnull (page);
  GtkWidget *area = driver_find_id (page, "area"), *put = driver_find_id (page, "put");
  g_assert_false (gtk_widget_get_sensitive (put));
  gtk_spin_button_set_value (GTK_SPIN_BUTTON (driver_find_id (page, "step")), 0.5);
  g_assert_cmpstr (driver_last_step (window), ==, "Set Moving Load");
  driver_activate (window, "win.run-shown");
  driver_wait (is_found, page);
  g_assert_true (gtk_widget_get_sensitive (put));
  g_assert_nonnull (strstr (words (page), "adequacy factor 4.7"));
  g_assert_nonnull (strstr (words (page), "axles of 186.39 kN"));
  driver_screenshot (page, "envelope-worst");
  const double worst = position (page);

  /* The pointer takes the vehicle along, keys move it by a step. */
  const double width = gtk_widget_get_width (area), height = gtk_widget_get_height (area);
  driver_point_at (area, 0.3 * width, 0.2 * height);
  driver_hold_button (TRUE);
  driver_point_at (area, 0.6 * width, 0.2 * height);
  driver_point_at (area, 0.7 * width, 0.2 * height);
  driver_hold_button (FALSE);
  driver_settle ();
  const double dragged = position (page);
  g_assert_cmpfloat (dragged, >, worst);
  driver_key ("Left");
  g_assert_cmpfloat (position (page), ==, dragged - 1);
  driver_screenshot (page, "envelope-dragged");

  /* What is shown goes into the project and back again. */
  const double placed = vehicle_of (window)->position;
  driver_press (page, "Worst Position");
  g_assert_cmpfloat (position (page), ==, worst);
  driver_press (page, "Put Vehicle Here");
  g_assert_cmpfloat (vehicle_of (window)->position, !=, placed);
  g_assert_null (strstr (words (page), "has changed"));
  driver_activate (window, "win.undo");
  g_assert_cmpfloat (vehicle_of (window)->position, ==, placed);
  g_assert_null (strstr (words (page), "has changed"));

  gtk_widget_activate_action (page, "envelope.export-path", "s", pdf);
  g_assert_nonnull (strstr (words (page), pdf));
  gtk_widget_activate_action (page, "envelope.export-path", "s", csv);
  g_assert_true (g_file_get_contents (pdf, &bytes, NULL, NULL));
  g_assert_true (g_file_get_contents (csv, &table, NULL, NULL));
  g_assert_true (g_str_has_prefix (bytes, "%PDF"));
  g_assert_true (g_str_has_prefix (table, "position [m],to the right,to the left\n"));

  /* Another vehicle beside the first: lines of its own; the settings are undone. */
  GtkWidget *list = driver_find_id (page, "vehicles");
  GtkWidget *last = gtk_widget_get_last_child (list);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (last), TRUE);
  driver_activate (window, "win.run-shown");
  driver_wait (is_found, page);
  GListModel *lines =
    gtk_drop_down_get_model (GTK_DROP_DOWN (driver_find_id (page, "line")));
  g_assert_cmpuint (g_list_model_get_n_items (lines), ==, 4);
  driver_activate (window, "win.undo");
  g_assert_false (gtk_check_button_get_active (GTK_CHECK_BUTTON (last)));

  /* Closed while it is being found. */
  driver_activate (window, "win.run-shown");
  driver_activate (window, "win.close-page");
  driver_discard (window);
}

/* Without a vehicle the page says what to do. */
static void
test_none (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  driver_activate (window, "win.envelope");
  GtkWidget *page = driver_find_page ("Moving Load");
  g_assert_nonnull (strstr (words (page), "No vehicle"));
  GActionGroup *actions = g_object_get_data (G_OBJECT (page), QN_ACTIONS);
  g_assert_false (g_action_group_get_action_enabled (actions, "run"));
  g_assert_false (gtk_widget_get_sensitive (driver_find_id (page, "animate")));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/envelope/bridge", test_bridge);
  g_test_add_func ("/app/envelope/none", test_none);
}
