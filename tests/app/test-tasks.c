/* How many clicks and keys a task takes from the start page on: as many as here, and no more. File choosers,
 * which are GTK's or the desktop's, are not counted. */
#include "driver.h"

#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

/* A button or an item of a menu that is on the screen, by its label. */
static gboolean
is_labelled (GtkWidget *widget, gconstpointer label)
{
  g_autofree char *text = NULL;
  if (!gtk_widget_get_mapped (widget))
    return FALSE;
  if (GTK_IS_BUTTON (widget))
    text = g_strdup (gtk_button_get_label (GTK_BUTTON (widget)));
  else if (g_str_equal (G_OBJECT_TYPE_NAME (widget), "GtkModelButton"))
    g_object_get (widget, "text", &text, NULL);
  if (text == NULL)
    return FALSE;
  g_auto (GStrv) parts = g_strsplit (text, "_", 2);
  g_autofree char *plain = g_strjoinv ("", parts);
  return g_str_equal (plain, label);
}

static void
expect_inputs (const char *task, guint most, gint64 begun)
{
  guint count = driver_take_inputs ();
  g_test_message ("%s: %u clicks and keys, %.1f s", task, count,
                  (double) (g_get_monotonic_time () - begun) / G_USEC_PER_SEC);
  g_assert_cmpuint (count, <=, most);
}

/* A wall with a door and two windows, solved, its figure on the screen to be exported. */
static void
test_wall (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_take_inputs ();
  gint64 begun = g_get_monotonic_time ();
  driver_click_on (GTK_WIDGET (window), is_labelled, "New Drawing");
  driver_key ("w");
  driver_drag (window, 0.0, 0.0, 4.8, 2.8);
  driver_key ("o");
  driver_drag (window, 0.4, 0.7, 1.2, 1.75);
  driver_drag (window, 2.0, 0.0, 2.8, 1.75);
  driver_drag (window, 3.6, 0.7, 4.4, 1.75);
  driver_key ("F5");
  driver_wait_for_job (window);
  const QnRun *run = qn_window_get_document (window)->run;
  g_assert_nonnull (run);
  g_assert_true (run->result.has_collapse_multiplier);
  driver_key ("ctrl+e");
  GtkWidget *dialog = driver_find_dialog ("Export Figure");
  g_assert_nonnull (dialog);
  g_assert_true (
    driver_is_button (gtk_window_get_focus (GTK_WINDOW (dialog)), "_Export…"));
  driver_screenshot (GTK_WIDGET (window), "task-wall");
  expect_inputs ("wall with a door and two windows, solved, to be exported", 9, begun);
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_discard (window);
}

/* A drawing with mortar becomes a model without a finding; it is dropped, or chosen with Ctrl+I. */
static void
test_mortar (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  g_autofree char *path = driver_example_path ("dxf/wall-mortar.dxf");
  driver_take_inputs ();
  gint64 begun = g_get_monotonic_time ();
  driver_activate_target (window, "win.take-path", g_variant_new_string (path));
  GtkWidget *dialog = driver_find_dialog ("Import");
  g_assert_nonnull (dialog);
  driver_key ("Return"); /* what the dialog offers is taken */
  driver_settle ();
  QnDocument *document = qn_window_get_document (window);
  g_assert_cmpuint (document->project.model.block_count, >, 1);
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  driver_screenshot (GTK_WIDGET (window), "task-mortar");
  expect_inputs ("drawing with mortar to a sound model", 1, begun);
  driver_discard (window);
}

static gboolean
has_five_pictures (gpointer dialog)
{
  guint count = 0;
  GtkWidget *cell = driver_find_widget (dialog, driver_is_cell, NULL);
  for (; cell != NULL; cell = gtk_widget_get_next_sibling (cell))
    count += driver_is_cell (cell, NULL);
  return count == 5;
}

/* Five projects side by side, which are solved there: the menu, and one drop of the files, which another
 * test does with the pointer. */
static void
test_comparison (void)
{
  static const char *const names[] = { "01-sliding-block.quoin",
                                       "02-overturning-block.quoin", "05-stack.quoin",
                                       "06-arch.quoin", "ferris-tin-loi/wall3.quoin" };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_window (1280, 800);
  driver_take_inputs ();
  gint64 begun = g_get_monotonic_time ();
  driver_key ("F10");
  driver_click_on (GTK_WIDGET (window), is_labelled, "Compare…");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_nonnull (dialog);
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autofree char *path = driver_example_path (names[i]);
    gtk_widget_activate_action (dialog, "compare.add-path", "s", path);
  }
  driver_wait (has_five_pictures, dialog);
  driver_screenshot (dialog, "task-comparison");
  expect_inputs ("five projects compared", 2, begun);
  driver_discard (window);
}

/* Drops files on a widget, as its drop target hears of it. */
static void
drop_files (GtkWidget *widget, const char *const *paths)
{
  g_autoptr (GListModel) controllers = gtk_widget_observe_controllers (widget);
  g_auto (GValue) value = G_VALUE_INIT;
  GSList *files = NULL;
  for (; *paths != NULL; paths++)
    files = g_slist_append (files, g_file_new_for_path (*paths));
  g_value_init (&value, GDK_TYPE_FILE_LIST);
  g_value_take_boxed (&value, gdk_file_list_new_from_list (files));
  g_slist_free_full (files, g_object_unref);
  gboolean taken = FALSE;
  for (guint i = 0; i < g_list_model_get_n_items (controllers); i++) {
    g_autoptr (GObject) controller = g_list_model_get_item (controllers, i);
    if (GTK_IS_DROP_TARGET (controller))
      g_signal_emit_by_name (controller, "drop", &value, 10.0, 10.0, &taken);
  }
  g_assert_true (taken);
}

static gboolean
is_trouble (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LABEL (widget)
         && g_str_has_prefix (gtk_label_get_text (GTK_LABEL (widget)), "⚠");
}

static gboolean
has_two_pictures (gpointer dialog)
{
  GtkWidget *cell = driver_find_widget (dialog, driver_is_cell, NULL);
  GtkWidget *next = cell != NULL ? gtk_widget_get_next_sibling (cell) : NULL;
  return next != NULL && driver_is_cell (next, NULL)
         && driver_find_widget (dialog, is_trouble, NULL) != NULL;
}

/* A folder and a file are dropped; of the folder what is no project is passed over, and a broken
 * project is told of, once. */
static void
test_dropped_files (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *broken = g_build_filename (folder, "broken.quoin", NULL);
  g_autofree char *other = g_build_filename (folder, "readme.txt", NULL);
  g_autofree char *good = g_build_filename (folder, "good.quoin", NULL);
  g_autofree char *example = driver_example_path ("05-stack.quoin");
  g_autofree char *single = driver_example_path ("01-sliding-block.quoin");
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (example, &text, NULL, NULL));
  g_assert_true (g_file_set_contents (good, text, -1, NULL));
  g_assert_true (g_file_set_contents (broken, "{ \"format\": \"quoin\",", -1, NULL));
  g_assert_true (g_file_set_contents (other, "nothing", -1, NULL));

  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_nonnull (dialog);
  drop_files (dialog, (const char *const[]){ folder, single, NULL });
  driver_wait (has_two_pictures, dialog);
  const char *told =
    gtk_label_get_text (GTK_LABEL (driver_find_widget (dialog, is_trouble, NULL)));
  g_assert_nonnull (strstr (told, "broken.quoin"));
  g_assert_null (strchr (told, '\n'));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/tasks/wall", test_wall);
  g_test_add_func ("/app/tasks/mortar", test_mortar);
  g_test_add_func ("/app/tasks/comparison", test_comparison);
  g_test_add_func ("/app/tasks/dropped-files", test_dropped_files);
}
