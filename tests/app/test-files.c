/* What a window leaves behind: history in the file, recovery after a crash, several windows. */
#include "driver.h"

#include "app/widgets/chooser.h"
#include "app/widgets/shortened.h"
#include "app/window/window-private.h"
#include "doc/document/recovery.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

/* A file that keeps its history is undone step by step after opening it again. */
static void
test_kept_history (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "wall.quoin", NULL);
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *opened = g_strdup (document->text->text);
  driver_activate (window, "win.keep-history");
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  driver_activate (window, "win.rotate(90.0)");
  driver_activate_target (window, "win.save-path", g_variant_new_string (path));
  driver_discard (window);

  window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  document = qn_window_get_document (window);
  g_assert_cmpuint (document->history->steps->len, ==, 2);
  g_assert_true (g_variant_get_boolean (
    g_action_group_get_action_state (G_ACTION_GROUP (window), "keep-history")));
  driver_activate (window, "win.undo");
  driver_activate (window, "win.undo");
  g_assert_cmpstr (document->text->text, ==, opened);
  driver_discard (window);
  g_unlink (path);
  g_rmdir (folder);
}

/* What a crashed program has left behind is offered in a window of its own, unsaved, and its
 * file is not touched. */
static void
test_recovery (void)
{
  g_autofree char *example = driver_example_path ("01-sliding-block.quoin");
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (example, &text, NULL, NULL));
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_mkdir_with_parents (folder, 0700);
  /* No process has this number. */
  g_autofree char *left = g_build_filename (folder, "999999999-crash.recovery", NULL);
  g_autofree char *content = g_strdup_printf ("%s\n%s", example, text);
  g_assert_true (g_file_set_contents (left, content, -1, NULL));

  g_application_activate (G_APPLICATION (driver_application ()));
  driver_settle ();
  QnWindow *recovered = NULL;
  for (GList *l = gtk_application_get_windows (driver_application ()); l != NULL;
       l = l->next) {
    if (QN_IS_WINDOW (l->data) && !qn_window_is_blank (l->data))
      recovered = l->data;
  }
  g_assert_nonnull (recovered);
  QnDocument *document = qn_window_get_document (recovered);
  g_assert_cmpstr (document->path, ==, example);
  g_assert_true (qn_document_is_modified (document));
  g_assert_cmpuint (model_of (recovered)->block_count, ==, 2);
  driver_screenshot (GTK_WIDGET (recovered), "recovered");
  g_assert_false (g_file_test (left, G_FILE_TEST_EXISTS));
  /* It is safe again before anything else happens. */
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  g_assert_nonnull (dir);
  g_assert_nonnull (g_dir_read_name (dir));
  driver_discard (recovered);
}

static gboolean
is_card_of (GtkWidget *widget, gconstpointer path)
{
  GVariant *target = GTK_IS_BUTTON (widget)
                       ? gtk_actionable_get_action_target_value (GTK_ACTIONABLE (widget))
                       : NULL;
  return target != NULL && g_variant_is_of_type (target, G_VARIANT_TYPE_STRING)
         && g_str_equal (g_variant_get_string (target, NULL), path);
}

/* Several files in several windows; a file opens where nothing is yet. */
static void
test_windows (void)
{
  QnWindow *first = driver_open_window (1280, 800);
  g_autofree char *a = driver_example_path ("01-sliding-block.quoin");
  g_autofree char *b = driver_example_path ("05-stack.quoin");
  guint before = g_list_length (gtk_application_get_windows (driver_application ()));
  driver_activate_target (first, "win.open-path", g_variant_new_string (a));
  g_assert_cmpuint (g_list_length (gtk_application_get_windows (driver_application ())),
                    ==, before);
  driver_activate_target (first, "win.open-path", g_variant_new_string (b));
  GList *windows = gtk_application_get_windows (driver_application ());
  g_assert_cmpuint (g_list_length (windows), ==, before + 1);
  QnWindow *second = NULL;
  for (GList *l = windows; l != NULL; l = l->next) {
    if (l->data != first && g_strcmp0 (qn_window_get_document (l->data)->path, b) == 0)
      second = l->data;
  }
  g_assert_nonnull (second);
  g_assert_cmpstr (qn_window_get_document (first)->path, ==, a);
  driver_discard (second);
  driver_discard (first);
}

/* An example of the start page is a drawing of its own: saving asks for a place and leaves the
 * example as it was. */
static void
test_example (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *example = driver_example_path ("43-shaken-wall.quoin");
  g_autofree char *before = NULL, *after = NULL;
  g_assert_true (g_file_get_contents (example, &before, NULL, NULL));
  GtkWidget *card = driver_find_widget (GTK_WIDGET (window), is_card_of, example);
  g_assert_nonnull (card);
  g_signal_emit_by_name (card, "clicked");
  driver_settle ();
  g_assert_false (qn_window_is_blank (window));
  g_assert_null (document->path);
  g_assert_false (qn_document_is_modified (document));
  g_assert_cmpuint (model_of (window)->ground_count, ==, 1);

  driver_activate (window, "win.save");
  g_assert_nonnull (g_object_get_data (G_OBJECT (window), QN_CHOOSER));
  g_object_set_data (G_OBJECT (window), QN_CHOOSER, NULL);
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "mine.quoin", NULL);
  g_autofree char *record = g_build_filename (folder, "43-synthetic-record.csv", NULL);
  driver_activate_target (window, "win.save-path", g_variant_new_string (path));
  g_assert_cmpstr (document->path, ==, path);
  g_assert_true (g_file_test (record, G_FILE_TEST_EXISTS));
  g_assert_true (g_file_get_contents (example, &after, NULL, NULL));
  g_assert_cmpstr (before, ==, after);
  driver_discard (window);
  g_unlink (record);
  g_unlink (path);
  g_rmdir (folder);
}

/* A file that is open is shown where it is, not opened twice. */
static void
test_open_again (void)
{
  QnWindow *first = driver_open_example ("01-sliding-block.quoin");
  QnWindow *other = driver_open_example ("05-stack.quoin");
  guint before = g_list_length (gtk_application_get_windows (driver_application ()));
  g_autofree char *path = driver_example_path ("../examples/01-sliding-block.quoin");
  driver_activate_target (other, "win.open-path", g_variant_new_string (path));
  GFile *files[] = { g_file_new_for_path (path) };
  g_application_open (G_APPLICATION (driver_application ()), files, 1, "");
  driver_settle ();
  g_object_unref (files[0]);
  g_assert_cmpuint (g_list_length (gtk_application_get_windows (driver_application ())),
                    ==, before);
  driver_discard (other);
  driver_discard (first);
}

static void
expect_text (const char *path, const char *words, gboolean there)
{
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  g_assert_true ((strstr (text, words) != NULL) == there);
}

/* What another program has written meanwhile is replaced only when the user says so. */
static void
test_changed_elsewhere (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "shared.quoin", NULL);
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_activate_target (window, "win.save-path", g_variant_new_string (path));
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  driver_activate (window, "win.save");
  g_assert_false (qn_document_is_modified (qn_window_get_document (window)));

  g_assert_true (g_file_set_contents (path, "theirs", -1, NULL));
  driver_activate (window, "win.nudge((1.0,0.0))");
  driver_activate (window, "win.save");
  GtkWidget *dialog = driver_find_message ();
  g_assert_nonnull (dialog);
  driver_screenshot (dialog, "changed-elsewhere");
  gtk_window_close (GTK_WINDOW (dialog));
  driver_settle ();
  g_assert_true (qn_document_is_modified (qn_window_get_document (window)));
  expect_text (path, "theirs", TRUE);

  driver_activate (window, "win.save");
  driver_press (driver_find_message (), "Overwrite");
  g_assert_false (qn_document_is_modified (qn_window_get_document (window)));
  expect_text (path, "theirs", FALSE);
  /* From now on it is ours again. */
  driver_activate (window, "win.nudge((1.0,0.0))");
  driver_activate (window, "win.save");
  g_assert_null (driver_find_message ());
  driver_discard (window);
  g_unlink (path);
  g_rmdir (folder);
}

/* The dialog that GTK shows where no portal does, whichever of its interfaces asked for it. */
static GtkFileChooser *
begin_choosing (QnWindow *window, const char *action, const char *shown,
                const char *hidden)
{
  driver_activate (window, action);
  g_assert_nonnull (g_object_get_data (G_OBJECT (window), QN_CHOOSER));
  GtkWidget *dialog = driver_find_other ();
  g_assert_true (GTK_IS_FILE_CHOOSER (dialog));
  g_assert_true (gtk_window_get_modal (GTK_WINDOW (dialog)));
  GtkFileChooser *chooser = GTK_FILE_CHOOSER (dialog);
  g_autoptr (GListModel) filters = gtk_file_chooser_get_filters (chooser);
  g_assert_cmpuint (g_list_model_get_n_items (filters), ==, 1);
  g_autoptr (GtkFilter) filter = g_list_model_get_item (filters, 0);
  g_autoptr (GFileInfo) info = g_file_info_new ();
  g_file_info_set_content_type (info, "application/octet-stream");
  g_file_info_set_display_name (info, shown);
  g_assert_true (gtk_filter_match (filter, info));
  g_file_info_set_display_name (info, hidden);
  g_assert_false (gtk_filter_match (filter, info));
  return chooser;
}

static void
respond (QnWindow *window, GtkFileChooser *chooser, int response)
{
  gtk_dialog_response (GTK_DIALOG (chooser), response);
  driver_settle ();
  g_assert_null (g_object_get_data (G_OBJECT (window), QN_CHOOSER));
  g_assert_null (driver_find_other ());
}

typedef struct Choice {
  GtkFileChooser *chooser;
  GFile *file;
} Choice;

static gboolean
is_chosen (gpointer data)
{
  const Choice *choice = data;
  g_autoptr (GFile) file = gtk_file_chooser_get_file (choice->chooser);
  return file != NULL && g_file_equal (file, choice->file);
}

/* Each chooser shows files of its kind; none is left behind, and what was chosen is opened. */
static void
test_choosers (void)
{
  static const char *const choosers[][3] = {
    { "win.open", "wall.QUOIN", "wall.dxf" },
    { "win.save-as", "wall.quoin", "wall.dxf" },
    { "win.open-result", "wall.result.json", "wall.quoin" },
    { "win.import", "wall.dxf", "wall.png" },
    { "win.picture", "wall.JPG", "wall.dxf" },
  };
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_pass_over_gtk ();
  for (gsize i = 0; i < G_N_ELEMENTS (choosers); i++) {
    GtkFileChooser *chooser =
      begin_choosing (window, choosers[i][0], choosers[i][1], choosers[i][2]);
    respond (window, chooser, GTK_RESPONSE_CANCEL);
  }

  g_autofree char *path = driver_example_path ("../examples/05-stack.quoin");
  g_autoptr (GFile) file = g_file_new_for_path (path);
  GtkFileChooser *chooser =
    begin_choosing (window, choosers[0][0], choosers[0][1], choosers[0][2]);
  gtk_file_chooser_set_file (chooser, file, NULL);
  driver_wait (is_chosen, &(Choice){ chooser, file });
  respond (window, chooser, GTK_RESPONSE_ACCEPT);
  QnWindow *opened = qn_window_find_path (driver_application (), path);
  g_assert_nonnull (opened);
  g_assert_cmpuint (model_of (opened)->block_count, >, 0);
  /* The next one begins beside it. */
  chooser = begin_choosing (opened, choosers[0][0], choosers[0][1], choosers[0][2]);
  g_autoptr (GFile) beside = gtk_file_chooser_get_current_folder (chooser);
  g_autoptr (GFile) folder = g_file_get_parent (file);
  g_assert_nonnull (beside);
  g_assert_true (g_file_equal (beside, folder));
  respond (opened, chooser, GTK_RESPONSE_CANCEL);
  driver_discard (opened);
  driver_discard (window);
}

/* Where a file cannot be written the bar says so, and the drawing is as unsaved as before. */
static void
test_save_fails (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *path = g_strdup (document->path);
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  const char *where = "/no/such/folder/wall.quoin";
  driver_activate_target (window, "win.save-path", g_variant_new_string (where));
  g_assert_true (gtk_widget_get_visible (window->info_bar));
  g_assert_nonnull (strstr (gtk_label_get_text (window->info_label), where));
  g_assert_true (qn_document_is_modified (document));
  g_assert_cmpstr (document->path, ==, path);
  driver_discard (window);
}

/* Names without an ending get one, but replace nothing that was not chosen. */
static void
test_endings (void)
{
  const char *const endings[] = { ".png", ".svg", NULL };
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *bare = g_build_filename (folder, "wall 1.5", NULL);
  g_autofree char *typed = g_build_filename (folder, "wall.SVG", NULL);
  g_autofree char *whole = g_strconcat (bare, ".png", NULL);
  g_autoptr (GError) error = NULL;
  g_autofree char *first = qn_chooser_complete_path (bare, endings, &error);
  g_assert_cmpstr (first, ==, whole);
  g_autofree char *kept = qn_chooser_complete_path (typed, endings, &error);
  g_assert_cmpstr (kept, ==, typed);
  g_autofree char *doubled = g_strconcat (typed, ".png", NULL);
  g_autofree char *once = qn_chooser_complete_path (doubled, endings, &error);
  g_assert_cmpstr (once, ==, typed);
  g_assert_no_error (error);
  g_assert_true (g_file_set_contents (whole, "", -1, NULL));
  g_assert_null (qn_chooser_complete_path (bare, endings, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_EXISTS);
  g_unlink (whole);
  g_rmdir (folder);
}

/* ---- several windows at the end ---- */

static QnWindow *
open_changed (const char *example, const char *folder)
{
  QnWindow *window = driver_open_example (example);
  g_autofree char *copy = g_build_filename (folder, example, NULL);
  driver_activate_target (window, "win.save-path", g_variant_new_string (copy));
  gtk_widget_grab_focus (GTK_WIDGET (canvas_of (window)));
  driver_settle ();
  driver_key ("ctrl+a");
  driver_key ("Right");
  g_assert_true (qn_document_is_modified (qn_window_get_document (window)));
  return window;
}

static guint
count_windows (gboolean main_ones)
{
  GListModel *toplevels = gtk_window_get_toplevels ();
  guint count = 0;
  for (guint i = 0; i < g_list_model_get_n_items (toplevels); i++) {
    g_autoptr (GtkWidget) toplevel = g_list_model_get_item (toplevels, i);
    count += gtk_widget_get_mapped (toplevel)
             && (main_ones ? QN_IS_WINDOW (toplevel)
                           : g_str_equal (gtk_widget_get_name (toplevel), "question"));
  }
  return count;
}

static gboolean
has_no_windows (gpointer data)
{
  (void) data;
  return count_windows (TRUE) == 0;
}

/* Quitting asks once for all windows; Escape keeps them; those ticked are saved and the others not. Nothing
 * shines through the question. */
static void
test_quit (void)
{
  static const char *const examples[] = { "01-sliding-block.quoin", "05-stack.quoin",
                                          "06-arch.quoin" };
  driver_pass_over_gtk ();
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  char *before[G_N_ELEMENTS (examples)];
  for (gsize i = 0; i < G_N_ELEMENTS (examples); i++) {
    open_changed (examples[i], folder);
    g_autofree char *path = g_build_filename (folder, examples[i], NULL);
    g_assert_true (g_file_get_contents (path, &before[i], NULL, NULL));
  }
  driver_key ("ctrl+q");
  g_assert_cmpuint (count_windows (FALSE), ==, 1);
  GtkWidget *question = driver_find_message ();
  driver_screenshot (question, "quit");
  cairo_surface_t *picture = driver_picture (question);
  const guint8 *pixels = cairo_image_surface_get_data (picture);
  int stride = cairo_image_surface_get_stride (picture);
  int middle = cairo_image_surface_get_width (picture) / 2,
      above = cairo_image_surface_get_height (picture) / 8;
  g_assert_cmpuint (pixels[above * stride + 4 * middle + 3], ==, 255);
  cairo_surface_destroy (picture);
  driver_key ("Escape");
  g_assert_cmpuint (count_windows (FALSE), ==, 0);
  g_assert_cmpuint (count_windows (TRUE), ==, 3);

  driver_key ("ctrl+q");
  driver_click_on (driver_find_message (), driver_is_check, "Semicircular arch");
  driver_click_on (driver_find_message (), driver_is_button, "_Save");
  driver_wait (has_no_windows, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (examples); i++) {
    g_autofree char *path = g_build_filename (folder, examples[i], NULL);
    g_autofree char *after = NULL;
    g_assert_true (g_file_get_contents (path, &after, NULL, NULL));
    g_assert_cmpint (g_str_equal (before[i], after), ==, i == 2);
    g_free (before[i]);
    g_unlink (path);
  }
  g_rmdir (folder);
}

/* One window as large as the screen leaves the others as they are, and the next one is as large. */
static void
test_sizes (void)
{
  QnWindow *first = driver_open_window (900, 600),
           *second = driver_open_window (900, 600);
  int width = 0, height = 0;
  gtk_window_set_default_size (GTK_WINDOW (second), 1000, 700);
  driver_settle ();
  gtk_window_get_default_size (GTK_WINDOW (first), &width, &height);
  g_assert_cmpint (width, ==, 900);
  gtk_window_maximize (GTK_WINDOW (second));
  driver_settle ();
  g_assert_false (gtk_window_is_maximized (GTK_WINDOW (first)));
  driver_discard (second);
  driver_discard (first);
}

/* A file that is none is told of where it was asked for, and opens no window. */
static void
test_broken (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "broken.quoin", NULL);
  g_assert_true (g_file_set_contents (path, "{ \"format\": ", -1, NULL));
  QnWindow *window = driver_open_example ("05-stack.quoin");
  driver_activate_target (window, "win.open-path", g_variant_new_string (path));
  g_assert_cmpuint (count_windows (TRUE), ==, 1);
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "broken.quoin"));
  g_autoptr (GFile) file = g_file_new_for_path (path);
  g_application_open (G_APPLICATION (driver_application ()), &file, 1, "");
  driver_settle ();
  g_assert_cmpuint (count_windows (TRUE), ==, 1);
  driver_discard (window);
  /* Where there is no other window it is one with the start page. */
  g_application_open (G_APPLICATION (driver_application ()), &file, 1, "");
  driver_settle ();
  g_assert_cmpuint (count_windows (TRUE), ==, 1);
  window = QN_WINDOW (gtk_application_get_windows (driver_application ())->data);
  g_assert_true (qn_window_is_blank (window));
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "broken.quoin"));
  driver_screenshot (GTK_WIDGET (window), "broken-file");
  driver_discard (window);
  g_unlink (path);
  g_rmdir (folder);
}

/* Escape closes every window that is no main one, and so does the end of the main one. */
static void
test_escape (void)
{
  static const char *const actions[] = { "win.export-result::report",
                                         "win.export-result::animation",
                                         "win.export",
                                         "app.preferences",
                                         "app.about",
                                         "app.help",
                                         "win.shortcuts" };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("06-arch.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++) {
    driver_activate (window, actions[i]);
    g_test_message ("%s", actions[i]);
    g_assert_nonnull (driver_find_other ());
    driver_key ("Escape");
    g_assert_null (driver_find_other ());
    driver_activate (window, actions[i]);
    g_assert_nonnull (driver_find_other ());
    driver_discard (window);
    g_assert_null (driver_find_other ());
    window = driver_open_example ("06-arch.quoin");
    driver_activate (window, "win.run");
    driver_wait_for_job (window);
  }
  driver_discard (window);
}

/* "~" stands for the user's folder, and for no other whose name begins like it. */
static void
test_folder (void)
{
  g_autofree char *own = g_build_filename (g_get_home_dir (), "walls", "a.quoin", NULL);
  g_autofree char *top = g_build_filename (g_get_home_dir (), "a.quoin", NULL);
  g_autofree char *beside = g_strconcat (g_get_home_dir (), "ly", NULL);
  g_autofree char *other = g_build_filename (beside, "a.quoin", NULL);
  g_autofree char *of_own = qn_shortened_dup_folder (own);
  g_autofree char *of_top = qn_shortened_dup_folder (top);
  g_autofree char *of_other = qn_shortened_dup_folder (other);
  g_assert_cmpstr (of_own, ==, "~/walls");
  g_assert_cmpstr (of_top, ==, "~");
  g_assert_cmpstr (of_other, ==, beside);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/files/kept-history", test_kept_history);
  g_test_add_func ("/app/files/recovery", test_recovery);
  g_test_add_func ("/app/files/windows", test_windows);
  g_test_add_func ("/app/files/open-again", test_open_again);
  g_test_add_func ("/app/files/example", test_example);
  g_test_add_func ("/app/files/changed-elsewhere", test_changed_elsewhere);
  g_test_add_func ("/app/files/choosers", test_choosers);
  g_test_add_func ("/app/files/save-fails", test_save_fails);
  g_test_add_func ("/app/files/endings", test_endings);
  g_test_add_func ("/app/files/quit", test_quit);
  g_test_add_func ("/app/files/sizes", test_sizes);
  g_test_add_func ("/app/files/broken", test_broken);
  g_test_add_func ("/app/files/escape", test_escape);
  g_test_add_func ("/app/files/folder", test_folder);
}
