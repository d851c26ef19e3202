/* What leaves a window: figures with style and preview, figures that the project keeps and makes
 * again, comparison sheets, printed pages. */
#include "app/pages/pages.h"
#include "app/window/window-private.h"
#include "doc/view/figures.h"
#include "doc/view/report-template.h"
#include "driver.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

static gboolean
is_check_called (GtkWidget *widget, gconstpointer label)
{
  if (!GTK_IS_CHECK_BUTTON (widget))
    return FALSE;
  const char *its = gtk_check_button_get_label (GTK_CHECK_BUTTON (widget));
  g_auto (GStrv) parts = g_strsplit (its != NULL ? its : "", "_", 2);
  g_autofree char *plain = g_strjoinv ("", parts);
  return g_str_equal (plain, label);
}

static gboolean
is_bytes_of (const char *path, const char *other)
{
  g_autofree char *a = NULL, *b = NULL;
  gsize na = 0, nb = 0;
  return g_file_get_contents (path, &a, &na, NULL)
         && g_file_get_contents (other, &b, &nb, NULL) && na == nb
         && memcmp (a, b, na) == 0;
}

static gboolean
exists (gpointer path)
{
  return g_file_test (path, G_FILE_TEST_EXISTS);
}

static gboolean
is_label_with (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_LABEL (widget)
         && strstr (gtk_label_get_text (GTK_LABEL (widget)), text) != NULL;
}

/* Kept with its style from the dialog, made again from the window after an analysis, and by the
 * command line: the same bytes. */
static void
test_figures (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *project = g_build_filename (folder, "wall.quoin", NULL);
  g_autofree char *picture = g_build_filename (folder, "mechanism.png", NULL);
  g_autofree char *from_cli = g_build_filename (folder, "cli", NULL);
  g_autofree char *other = g_build_filename (from_cli, "mechanism.png", NULL);
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.export");
  GtkWidget *dialog = driver_find_dialog ("Export Figure");
  g_assert_nonnull (dialog);
  GtkWidget *check = driver_find_widget (dialog, is_check_called, "Black and white");
  g_assert_nonnull (check);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check), TRUE);
  driver_screenshot (dialog, "export-dialog-style");
  driver_press (dialog, "Keep in Project");
  g_assert_null (driver_find_dialog ("Export Figure"));

  g_autoptr (GError) error = NULL;
  g_autoptr (GPtrArray) figures = qn_document_get_figures (document, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (figures->len, ==, 1);
  const QnRecipe *recipe = g_ptr_array_index (figures, 0);
  g_assert_cmpstr (recipe->name, ==, "mechanism");
  g_assert_true (recipe->view.monochrome);
  g_assert_false (qn_recipe_is_stale (recipe, qn_document_get_project (document)));

  driver_activate_target (window, "win.save-path", g_variant_new_string (project));
  driver_discard (window);
  window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, project));
  document = qn_window_get_document (window);
  driver_activate (window, "win.figures");
  dialog = driver_find_page ("Figures");
  g_assert_nonnull (dialog);
  driver_screenshot (dialog, "figures");
  driver_press (dialog, "Make All Again");
  driver_wait (exists, picture);

  g_mkdir (from_cli, 0700);
  const char *argv[] = {
    g_getenv ("QUOIN_CLI"), "figures", project, "-o", from_cli, NULL
  };
  int status = -1;
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_STDOUT_TO_DEV_NULL,
                               NULL, NULL, NULL, NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  g_assert_true (is_bytes_of (picture, other));

  /* A second figure of the same file takes the place of neither. */
  g_autoptr (QnRecipe) twin = qn_recipe_new ("twin", QN_VIEW_MODEL);
  g_free (twin->file);
  twin->file = g_strdup ("./mechanism.png");
  g_assert_true (qn_document_store_figure (document, twin, NULL));
  driver_press (dialog, "Make All Again");
  g_assert_nonnull (
    driver_find_widget (dialog, is_label_with, "another figure is the same file"));
  g_assert_true (is_bytes_of (picture, other));
  driver_activate (window, "win.undo");

  /* A model that has changed is told, and removing can be undone. */
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((1.0,0.0))");
  g_autoptr (GPtrArray) later = qn_document_get_figures (document, NULL);
  g_assert_true (qn_recipe_is_stale (g_ptr_array_index (later, 0),
                                     qn_document_get_project (document)));
  g_assert_true (qn_document_remove_figure (document, "mechanism", NULL));
  g_autoptr (GPtrArray) none = qn_document_get_figures (document, NULL);
  g_assert_cmpuint (none->len, ==, 0);
  driver_activate (window, "win.undo");
  g_autoptr (GPtrArray) again = qn_document_get_figures (document, NULL);
  g_assert_cmpuint (again->len, ==, 1);
  driver_discard (window);
  g_unlink (other);
  g_rmdir (from_cli);
  g_unlink (picture);
  g_unlink (project);
  g_rmdir (folder);
}

static void
expect_pdf (const char *path)
{
  g_autofree char *bytes = NULL;
  gsize length = 0;
  g_assert_true (g_file_get_contents (path, &bytes, &length, NULL));
  g_assert_cmpuint (length, >, 2000);
  g_assert_true (g_str_has_prefix (bytes, "%PDF"));
}

static void
test_sheet (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "sheet.pdf", NULL);
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  const GPtrArray *runs = qn_window_get_document (window)->runs;
  g_assert_cmpuint (runs->len, ==, 2);
  driver_activate (window, "win.compare");
  gtk_widget_activate_action (driver_find_page ("Comparison"), "compare.export-path", "s",
                              path);
  expect_pdf (path);
  driver_key ("Escape");

  /* The outline of the one lies over the other. */
  QnViewState *state = state_of (window);
  qn_view_state_set_onion (state, g_ptr_array_index (runs, 0));
  g_assert_nonnull (qn_view_state_get_options (state).onion);
  driver_screenshot (GTK_WIDGET (window), "onion");
  driver_discard (window);
  g_unlink (path);
  g_rmdir (folder);
}

static guint
count_files (const char *folder)
{
  g_autoptr (GDir) files = g_dir_open (folder, 0, NULL);
  guint count = 0;
  while (files != NULL && g_dir_read_name (files) != NULL)
    count++;
  return count;
}

static gboolean
has_no_animation_dialog (gpointer data)
{
  (void) data;
  return driver_find_dialog ("Export Animation") == NULL;
}

static gboolean
tells_of_cancelling (gpointer dialog)
{
  return driver_find_widget (dialog, is_label_with, "Cancelled") != NULL;
}

/* The dialog says what it will write; cancelled it leaves nothing, else all of it. */
static void
test_animation (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *pictures = g_strconcat (folder, "/pictures/", NULL);
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.export-result::animation");
  GtkWidget *dialog = driver_find_dialog ("Export Animation");
  g_assert_nonnull (dialog);
  g_assert_nonnull (driver_find_widget (dialog, is_label_with, "48 pictures"));
  driver_screenshot (dialog, "animation-dialog");
  driver_key ("Escape");
  driver_wait (has_no_animation_dialog, NULL);

  g_autofree char *action =
    g_strdup_printf ("win.export-path(('animation', '%s'))", pictures);
  driver_activate (window, action);
  dialog = driver_find_dialog ("Export Animation");
  g_assert_nonnull (dialog);
  driver_screenshot (dialog, "animation-progress");
  driver_press (dialog, "Cancel");
  driver_wait (tells_of_cancelling, dialog);
  g_assert_cmpuint (count_files (pictures), ==, 0);
  gtk_window_destroy (GTK_WINDOW (dialog));

  driver_activate (window, action);
  driver_wait (has_no_animation_dialog, NULL);
  g_assert_cmpuint (count_files (pictures), ==, 48);

  /* Closing the dialog cancels as well. */
  g_autofree char *gif = g_build_filename (folder, "a.gif", NULL);
  g_autofree char *other = g_strdup_printf ("win.export-path(('animation', '%s'))", gif);
  driver_activate (window, other);
  dialog = driver_find_dialog ("Export Animation");
  gtk_window_destroy (GTK_WINDOW (dialog));
  driver_discard (window); /* the thread holds a part of it until its end */
  g_assert_false (g_file_test (gif, G_FILE_TEST_EXISTS));

  g_autoptr (GDir) files = g_dir_open (pictures, 0, NULL);
  const char *name;
  while (files != NULL && (name = g_dir_read_name (files)) != NULL) {
    g_autofree char *path = g_build_filename (pictures, name, NULL);
    g_unlink (path);
  }
  g_rmdir (pictures);
  g_assert_cmpint (g_rmdir (folder), ==, 0);
}

static void
expect_file (const char *folder, const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_assert_true (g_file_test (path, G_FILE_TEST_EXISTS));
  g_unlink (path);
}

/* The drawing for CAD, the steps for ParaView, the result to be opened again, here and by the
 * command line; a folder that is not there is told. */
static void
test_files (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  static const char *const kinds[][2] = { { "drawing", "wall.dxf" },
                                          { "steps", "steps.pvd" },
                                          { "result", "result.json" } };
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  GActionGroup *actions = G_ACTION_GROUP (window);
  g_assert_false (g_action_group_get_action_enabled (actions, "export-result"));
  g_assert_true (g_action_group_get_action_enabled (actions, "export-drawing"));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = g_build_filename (folder, kinds[i][1], NULL);
    driver_activate_target (window, "win.export-path",
                            g_variant_new ("(ss)", kinds[i][0], path));
    g_assert_true (g_file_test (path, G_FILE_TEST_EXISTS));
  }
  const QnRun *run = qn_window_get_document (window)->run;
  double solved = run->result.collapse_multiplier;
  driver_activate_target (window, "win.export-path",
                          g_variant_new ("(ss)", "drawing", "/no/such/folder/wall.dxf"));
  driver_screenshot (GTK_WIDGET (window), "export-failed");
  g_assert_true (gtk_widget_get_visible (window->info_bar));
  g_assert_nonnull (
    strstr (gtk_label_get_text (window->info_label), "/no/such/folder/wall.dxf"));
  driver_discard (window);

  window = driver_open_example ("02-overturning-block.quoin");
  g_autofree char *result = g_build_filename (folder, "result.json", NULL);
  driver_activate_target (window, "win.take-path", g_variant_new_string (result));
  run = qn_window_get_document (window)->run;
  g_assert_nonnull (run);
  g_assert_cmpfloat (run->result.collapse_multiplier, ==, solved);
  g_assert_cmpint (state_of (window)->options.view, ==, QN_VIEW_MECHANISM);
  driver_screenshot (GTK_WIDGET (window), "result-opened");
  driver_discard (window);

  g_autofree char *model = driver_example_path ("02-overturning-block.quoin");
  const char *argv[] = {
    g_getenv ("QUOIN_CLI"), "check", model, "--result", result, NULL
  };
  int status = -1;
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL, G_SPAWN_STDOUT_TO_DEV_NULL,
                               NULL, NULL, NULL, NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++)
    expect_file (folder, kinds[i][1]);
  g_autoptr (GDir) steps = g_dir_open (folder, 0, NULL);
  for (const char *name; (name = g_dir_read_name (steps)) != NULL;)
    expect_file (folder, name);
  g_rmdir (folder);
}

static gboolean
is_reported (gpointer window)
{
  GAction *cancel = g_action_map_lookup_action (G_ACTION_MAP (window), "cancel");
  return !g_action_get_enabled (cancel);
}

static gsize
report_size (QnWindow *window, const char *path)
{
  g_autofree char *bytes = NULL;
  gsize length = 0;
  driver_activate_target (window, "win.export-path",
                          g_variant_new ("(ss)", "report", path));
  driver_wait (is_reported, window);
  g_assert_true (g_file_get_contents (path, &bytes, &length, NULL));
  g_assert_true (g_str_has_prefix (bytes, "%PDF-"));
  g_unlink (path);
  return length;
}

static GtkWidget *
find_titled (GtkWidget *root, const char *label)
{
  if (GTK_IS_CHECK_BUTTON (root)
      && g_strcmp0 (gtk_check_button_get_label (GTK_CHECK_BUTTON (root)), label) == 0)
    return root;
  GtkWidget *found = NULL;
  for (GtkWidget *child = gtk_widget_get_first_child (root);
       child != NULL && found == NULL; child = gtk_widget_get_next_sibling (child))
    found = find_titled (child, label);
  return found;
}

/* The load multiplier that a report of the project compares with; 0: none. */
static double
kept_demand (QnDocument *document)
{
  QnReportTemplate plan;
  g_assert_true (
    qn_report_template_read (&plan, qn_document_get_project (document), NULL));
  double demand = plan.demand;
  qn_report_template_clear (&plan);
  return demand;
}

/* What a report holds is asked, kept as a step, and followed; runs stay what they are. */
static void
test_report_template (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *path =
    g_build_filename (g_get_tmp_dir (), "quoin-test-report.pdf", NULL);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  gsize whole = report_size (window, path);
  driver_activate (window, "win.export-result::report");
  GtkWidget *dialog = driver_find_dialog ("Export Report");
  g_assert_nonnull (dialog);
  driver_screenshot (dialog, "export-report");
  GtkWidget *results = find_titled (dialog, "_Results");
  g_assert_true (gtk_check_button_get_active (GTK_CHECK_BUTTON (results)));
  gtk_check_button_set_active (GTK_CHECK_BUTTON (results), FALSE);
  GtkEditable *demand = GTK_EDITABLE (driver_find_id (dialog, "demand"));
  g_assert_cmpstr (gtk_editable_get_text (demand), ==, "");
  gtk_editable_set_text (demand, "-0.1");
  driver_press (dialog, "Export…");
  g_assert_cmpfloat (kept_demand (document), ==, 0); /* refused: the dialog stays */
  gtk_editable_set_text (demand, "0.1*1.2");
  driver_press (dialog, "Export…");
  g_assert_cmpfloat (kept_demand (document), ==, 0.1 * 1.2);
  g_assert_false (qn_document_is_stale (document, document->run));
  gsize part = report_size (window, path);
  g_assert_cmpuint (part, <, whole);
  driver_activate (window, "win.undo");
  g_assert_cmpuint (report_size (window, path), >, part);
  g_assert_cmpfloat (kept_demand (document), ==, 0);
  driver_activate (window, "win.redo");
  g_assert_cmpfloat (kept_demand (document), ==, 0.1 * 1.2);
  driver_discard (window);
}

/* The report has every run of the model as it is now: more with two than with one, and none that an
 * edit has left behind. A folder that is not there is told. */
static void
test_report (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *path =
    g_build_filename (g_get_tmp_dir (), "quoin-test-report.pdf", NULL);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  gsize one = report_size (window, path);
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  gsize two = report_size (window, path);
  g_assert_cmpuint (two, >, one);
  driver_activate_target (window, "win.export-path",
                          g_variant_new ("(ss)", "report", "/no/such/folder/r.pdf"));
  driver_wait (is_reported, window);
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((0.1,0.0))");
  g_assert_cmpuint (report_size (window, path), <, one);
  driver_discard (window);
}

/* The report of a project that was edited has its combinations analysed, in the background; cancelled, it
 * leaves nothing. */
static void
test_report_combinations (void)
{
  QnWindow *window = driver_open_example ("50-wall-in-combinations.quoin");
  g_autofree char *path =
    g_build_filename (g_get_tmp_dir (), "quoin-test-combinations.pdf", NULL);
  g_assert_true (qn_document_edit_extra (qn_window_get_document (window), "Report", NULL,
                                         "report", "{ \"sections\": [\"combinations\"] }",
                                         NULL));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  /* At once: a window that settles in between lets it end. */
  g_action_group_activate_action (G_ACTION_GROUP (window), "export-path",
                                  g_variant_new ("(ss)", "report", path));
  driver_activate (window, "win.cancel");
  driver_wait (is_reported, window);
  g_assert_false (g_file_test (path, G_FILE_TEST_EXISTS));
  g_assert_cmpuint (report_size (window, path), >, 4000);
  g_autofree char *program = g_find_program_in_path ("pdftotext"), *text = NULL;
  const char *argv[] = { program, "-layout", path, "-", NULL };
  if (program != NULL) {
    driver_activate_target (window, "win.export-path",
                            g_variant_new ("(ss)", "report", path));
    driver_wait (is_reported, window);
    g_assert_true (
      g_spawn_sync (NULL, (char **) argv, NULL, 0, NULL, NULL, &text, NULL, NULL, NULL));
    g_assert_nonnull (strstr (text, "combinations by"));
    g_assert_nonnull (strstr (text, "stands"));
    g_unlink (path);
  }
  driver_discard (window);
}

/* Whether a picture is white from one row and column to another. */
static gboolean
is_white (cairo_surface_t *picture, int left, int top, int right, int bottom)
{
  const unsigned char *data = cairo_image_surface_get_data (picture);
  const int stride = cairo_image_surface_get_stride (picture);
  for (int row = top; row < bottom; row++)
    for (int i = left; i < right; i++)
      if ((((const guint32 *) (gconstpointer) (data + row * stride))[i] & 0xffffff)
          != 0xffffff)
        return FALSE;
  return TRUE;
}

/* The preview has the margins of the file: a title does not touch the edge. */
static void
test_preview_margins (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.export");
  GtkWidget *dialog = driver_find_dialog ("Export Figure");
  GtkWidget *preview = driver_find_id (dialog, "preview");
  graphene_rect_t at;
  double dx, dy;
  g_assert_true (gtk_widget_compute_bounds (preview, dialog, &at));
  gtk_native_get_surface_transform (GTK_NATIVE (dialog), &dx, &dy);
  /* The page of 4 : 3 lies in the middle. */
  const double width = MIN (at.size.width, at.size.height * 4 / 3),
               height = width * 3 / 4;
  const int left = (int) (dx + at.origin.x + 0.5 * (at.size.width - width)) + 1;
  const int top = (int) (dy + at.origin.y + 0.5 * (at.size.height - height)) + 1;
  const int right = left + (int) width - 2, bottom = top + (int) height - 2;
  const int margin = (int) (0.008 * width);
  cairo_surface_t *picture = driver_picture (dialog);
  g_assert_cmpint (margin, >, 1);
  g_assert_true (is_white (picture, left, top, left + margin, bottom));
  g_assert_true (is_white (picture, left, top, right, top + margin));
  g_assert_false (is_white (picture, left, top, right, bottom));
  cairo_surface_destroy (picture);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/export/preview-margins", test_preview_margins);
  g_test_add_func ("/app/export/figures", test_figures);
  g_test_add_func ("/app/export/sheet", test_sheet);
  g_test_add_func ("/app/export/animation", test_animation);
  g_test_add_func ("/app/export/files", test_files);
  g_test_add_func ("/app/export/report", test_report);
  g_test_add_func ("/app/export/report-combinations", test_report_combinations);
  g_test_add_func ("/app/export/report-template", test_report_template);
}
