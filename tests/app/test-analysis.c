/* Analyses in the window: live mode, failures explained at the block, every procedure from the
 * panel, HybriDFEM against limit analysis, results marked as outdated. */
#include "driver.h"

#include "app/widgets/settings.h"
#include "doc/document/bounds.h"
#include "doc/edit/edit.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <string.h>

static gboolean
has_fresh_run (gpointer window)
{
  QnDocument *document = qn_window_get_document (window);
  const QnRun *run = document->run;
  return run != NULL && !qn_document_is_stale (document, run) && document->job == NULL;
}

/* Each edit of a small wall is solved again, without leaving the view, and leaves one run. */
static void
test_live (void)
{
  GSettings *settings = qn_settings_get ();
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_settings_set_boolean (settings, "live", TRUE);
  driver_wait (has_fresh_run, window);
  double before = document->run->result.collapse_multiplier;
  g_assert_cmpint (state_of (window)->options.view, ==, QN_VIEW_MODEL);

  QnId top = 0;
  for (gsize i = 0; i < model_of (window)->block_count; i++) {
    if (!model_of (window)->blocks[i].support[0])
      top = (QnId) i;
  }
  qn_selection_set (document->selection, QN_PICK_BLOCK, &top, 1);
  gtk_widget_activate_action (GTK_WIDGET (window), "win.nudge", "(dd)", 1.0, 0.0);
  g_assert_true (qn_document_is_stale (document, document->run));
  driver_wait (has_fresh_run, window);
  g_assert_cmpfloat_with_epsilon (document->run->result.collapse_multiplier, before,
                                  1e-9);
  g_assert_cmpuint (document->runs->len, ==, 1);
  driver_screenshot (GTK_WIDGET (window), "live");
  g_settings_set_boolean (settings, "live", FALSE);
  driver_discard (window);
}

static gboolean
lift (QnModel *model, gpointer data, GError **error)
{
  QnBlockSet set = { data, 1 };
  return qn_edit_transform_blocks (model, set, qn_transform_translation (0.0, 0.5),
                                   error);
}

static gboolean
sink (QnModel *model, gpointer data, GError **error)
{
  QnBlockSet set = { data, 1 };
  return qn_edit_transform_blocks (model, set, qn_transform_translation (0.0, -0.05),
                                   error);
}

/* A block in the air and one inside another are named, selected and shown. */
static void
test_failures (void)
{
  const struct {
    ModelEdit edit;
    const char *picture;
  } cases[] = { { lift, "floating" }, { sink, "overlapping" } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnWindow *window = driver_open_example ("01-sliding-block.quoin");
    QnDocument *document = qn_window_get_document (window);
    QnId top = 0;
    for (gsize k = 0; k < model_of (window)->block_count; k++) {
      if (!model_of (window)->blocks[k].support[0])
        top = (QnId) k;
    }
    g_assert_true (edit_model (document, "Spoil", NULL, cases[i].edit, &top, NULL));
    driver_activate (window, "win.run");
    driver_wait_for_job (window);
    driver_screenshot (GTK_WIDGET (window), cases[i].picture);
    g_assert_true (qn_selection_has (document->selection, QN_PICK_BLOCK, top));
    g_assert_null (document->run);
    driver_discard (window);
  }
}

static gboolean
remove_friction (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->laws[0].friction = 0;
  return TRUE;
}

/* The blocks that slide off a slope without friction are selected. */
static void
test_dead_load (void)
{
  QnWindow *window = driver_open_example ("04-block-on-slope.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_assert_true (edit_model (document, "No Friction", NULL, remove_friction, NULL, NULL));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  guint selected = 0;
  qn_selection_get (document->selection, QN_PICK_BLOCK, &selected);
  g_assert_cmpuint (selected, ==, 1);
  driver_screenshot (GTK_WIDGET (window), "dead-load");
  driver_discard (window);
}

static gboolean
is_procedure_choice (GtkWidget *widget, gconstpointer data)
{
  if (!GTK_IS_DROP_DOWN (widget))
    return FALSE;
  GListModel *rows = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
  if (!GTK_IS_STRING_LIST (rows) || g_list_model_get_n_items (rows) == 0)
    return FALSE;
  return g_str_equal (gtk_string_list_get_string (GTK_STRING_LIST (rows), 0), data);
}

/* Every procedure can be chosen, with all it needs, and gives about the same answer. */
static void
test_procedures (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_open_analysis (window);
  GtkWidget *choice = driver_find_widget (GTK_WIDGET (window), is_procedure_choice,
                                          "Load control (HybriDFEM)");
  g_assert_nonnull (choice);
  double first = 0.0;
  guint count =
    g_list_model_get_n_items (gtk_drop_down_get_model (GTK_DROP_DOWN (choice)));
  g_assert_cmpuint (count, ==, 7);
  for (guint i = 0; i < count; i++) {
    gtk_drop_down_set_selected (GTK_DROP_DOWN (choice), i);
    driver_settle ();
    g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (choice)), ==, i);
    if (i == 1)
      driver_screenshot (GTK_WIDGET (window), "displacement-control");
    driver_activate (window, "win.run");
    driver_wait_for_job (window);
    const QnRun *run = document->run;
    g_assert_nonnull (run);
    g_assert_cmpuint (document->runs->len, ==, i + 1);
    if (run->model.analysis.procedure == QN_PROCEDURE_DYNAMIC) {
      g_assert_cmpuint (run->result.history.row_count, >, 1);
      driver_screenshot (GTK_WIDGET (window), "in-time");
      continue;
    }
    double largest =
      run->result.has_collapse_multiplier ? run->result.collapse_multiplier : 0.0;
    for (gsize k = 0; k < run->result.step_count; k++)
      largest = MAX (largest, run->result.steps[k].multiplier);
    if (i == 0)
      first = largest;
    g_assert_cmpfloat_with_epsilon (largest, first, 0.02 * first);
    driver_open_analysis (window);
  }
  driver_discard (window);
}

/* An analysis in time is shown with its settings and its ground motion, which can be undone; its
 * result is told by time. */
static void
test_in_time (void)
{
  QnWindow *window = driver_open_example ("41-column-impulse.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_open_analysis (window);
  GtkWidget *choice = driver_find_widget (GTK_WIDGET (window), is_procedure_choice,
                                          "Load control (HybriDFEM)");
  g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (choice)), ==, 6);
  driver_screenshot (GTK_WIDGET (window), "ground-motion");
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "step impulse"));
  driver_press (GTK_WIDGET (window), "+ Pulse");
  g_assert_cmpuint (model_of (window)->ground_count, ==, 2);
  driver_press (GTK_WIDGET (window), "Remove Motion");
  g_assert_cmpuint (model_of (window)->ground_count, ==, 1);
  g_assert_cmpint (model_of (window)->ground[0].pulse.kind, ==, QN_PULSE_STEP_IMPULSE);
  driver_activate (window, "win.undo");
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->ground_count, ==, 1);

  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_cmpuint (run->result.history.row_count, >, 100);
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, " s of "));
  driver_screenshot (GTK_WIDGET (window), "history");
  driver_discard (window);
}

/* After an analysis of which one has seen progress the window is not drawn any more. */
static void
test_rest (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  gtk_widget_activate_action (GTK_WIDGET (window), "win.run", NULL);
  g_signal_emit_by_name (qn_window_get_document (window), "job-progress");
  driver_wait_for_job (window);
  driver_discard (window);
}

static gboolean
has_all_runs (gpointer window)
{
  return qn_window_get_document (window)->runs->len == 3
         && qn_window_get_document (window)->job == NULL;
}

static void
test_bounds (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.run-all");
  driver_wait (has_all_runs, window);
  double bounds[QN_BOUND_KIND_COUNT];
  /* No jump of wall 3 is a snap. */
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 5);
  g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
  g_assert_nonnull (verdict);
  driver_screenshot (GTK_WIDGET (window), "bounds");
  driver_activate (window, "win.compare");
  GtkWidget *compare = driver_find_page ("Comparison");
  g_assert_nonnull (compare);
  driver_screenshot (compare, "compare");

  /* Outdated numbers are not compared with anything. */
  driver_activate (window, "win.select-all");
  driver_activate (window, "win.nudge((0.0,1.0))");
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 0);
  driver_discard (window);
}

static gboolean
is_table_row (GtkWidget *widget, gconstpointer data)
{
  return GTK_IS_LABEL (widget) && GTK_IS_GRID (gtk_widget_get_parent (widget))
         && g_str_equal (gtk_label_get_text (GTK_LABEL (widget)), data);
}

static int
row_of (GtkWidget *dialog, const char *text)
{
  GtkWidget *label = driver_find_widget (dialog, is_table_row, text);
  int column, row = -1;
  if (label != NULL)
    gtk_grid_query_child (GTK_GRID (gtk_widget_get_parent (label)), label, &column, &row,
                          &column, &column);
  return row;
}

static gboolean
shows_three (gpointer dialog)
{
  return driver_find_widget (dialog, is_table_row, "0.3558") != NULL
         && driver_find_widget (dialog, is_table_row, "0.2637") != NULL
         && driver_find_widget (dialog, is_table_row, "0.6415") != NULL;
}

#define ROCKING "Rocking block, let go at half its angle of overturning"

static gboolean
shows_rocking (gpointer dialog)
{
  return driver_find_widget (dialog, is_table_row, ROCKING) != NULL;
}

/* Files are compared without a window of theirs: solved, named by their titles, in an order that keys
 * change; what cannot be read is told. */
static void
test_compare_files (void)
{
  static const char *const names[] = { "ferris-tin-loi/wall3.quoin",
                                       "ferris-tin-loi/wall4.quoin",
                                       "ferris-tin-loi/wall1.quoin", "README.md" };
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_nonnull (dialog);
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autofree char *path = driver_example_path (names[i]);
    gtk_widget_activate_action (dialog, "compare.add-path", "s", path);
  }
  driver_wait (shows_three, dialog);
  driver_screenshot (dialog, "compare-files");
  GtkWidget *cell = driver_find_widget (dialog, driver_is_cell, NULL);
  g_assert_nonnull (cell);
  gtk_widget_grab_focus (cell);
  int row_before = row_of (dialog, "100.0 %"), wall3 = row_of (dialog, "0.3558");
  g_assert_cmpint (row_before, ==, wall3);
  driver_key ("alt+Right");
  g_assert_cmpint (row_of (dialog, "0.3558"), ==, wall3 + 1);
  g_assert_cmpint (row_of (dialog, "100.0 %"), ==, row_of (dialog, "0.2637"));
  /* All columns are in sight. A motion is told by how far it went, and its curve has other axes. */
  GtkWidget *head = driver_find_widget (dialog, is_table_row, "Outcome");
  GtkAdjustment *across = gtk_scrollable_get_hadjustment (
    GTK_SCROLLABLE (gtk_widget_get_ancestor (head, GTK_TYPE_VIEWPORT)));
  g_assert_cmpfloat (gtk_adjustment_get_upper (across), <=,
                     gtk_adjustment_get_page_size (across) + 1.0);
  GtkGrid *table = GTK_GRID (gtk_widget_get_parent (head));
  g_autofree char *rocking = driver_example_path ("40-rocking-in-time.quoin");
  gtk_widget_activate_action (dialog, "compare.add-path", "s", rocking);
  driver_wait (shows_rocking, dialog);
  GtkWidget *moved = gtk_grid_get_child_at (table, 3, row_of (dialog, ROCKING));
  g_assert_cmpfloat (g_ascii_strtod (gtk_label_get_text (GTK_LABEL (moved)), NULL), >, 1);
  /* The pictures are as high as they need to be at any width. */
  GtkWidget *pictures = driver_find_id (dialog, "grid");
  int least;
  gtk_widget_measure (pictures, GTK_ORIENTATION_VERTICAL, -1, &least, NULL, NULL, NULL);
  g_assert_cmpint (gtk_widget_get_height (gtk_widget_get_parent (pictures)), >=, least);
  driver_screenshot (dialog, "compare-in-time");
  driver_discard (window);
}

static gboolean
shows_wall4 (gpointer dialog)
{
  return driver_find_widget (dialog, is_table_row, "0.2637") != NULL;
}

/* A file that a window has solved already is not shown twice, as where its folder is added. */
static void
test_compare_own_file (void)
{
  static const char *const names[] = { "ferris-tin-loi/wall3.quoin",
                                       "ferris-tin-loi/wall4.quoin" };
  QnWindow *window = driver_open_example (names[0]);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autofree char *path = driver_example_path (names[i]);
    gtk_widget_activate_action (dialog, "compare.add-path", "s", path);
  }
  driver_wait (shows_wall4, dialog);
  g_assert_cmpint (row_of (dialog, "0.2637"), ==, row_of (dialog, "0.3558") + 1);
  driver_discard (window);
}

/* Modes and the buckling load stand in the list of runs, each with its shape; beside them the path
 * keeps its place in the table of bounds. */
static void
test_modes_and_stability (void)
{
  QnWindow *window = driver_open_example ("11-vibrating-beam.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.run-modes::dead");
  driver_wait_for_job (window);
  const GPtrArray *runs = document->runs;
  g_assert_cmpuint (runs->len, ==, 6);
  const QnRun *first = document->run;
  g_assert_true (first == g_ptr_array_index (runs, 0));
  g_assert_cmpfloat_with_epsilon (first->result.vibration.omega, 315.711, 0.01);
  QnViewState *state = state_of (window);
  g_assert_cmpint (state->options.view, ==, QN_VIEW_MECHANISM);
  qn_document_set_run (document, g_ptr_array_index (runs, 1));
  driver_screenshot (GTK_WIDGET (window), "mode-2");
  double bounds[QN_BOUND_KIND_COUNT];
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 0);
  driver_discard (window);

  window = driver_open_example ("21-column-pinned.quoin");
  document = qn_window_get_document (window);
  driver_activate (window, "win.run-stability");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_cmpint (run->kind, ==, QN_RUN_STABILITY);
  g_assert_cmpfloat_with_epsilon (run->result.first_limit_multiplier, 2470.2, 0.1);
  driver_screenshot (GTK_WIDGET (window), "stability");
  driver_discard (window);

  /* A dry wall vibrates on its closed joints. */
  window = driver_open_example ("ferris-tin-loi/wall1.quoin");
  driver_activate (window, "win.run-modes::loaded");
  driver_wait_for_job (window);
  g_assert_null (qn_window_get_document (window)->job_error);
  run = qn_window_get_document (window)->run;
  g_assert_cmpint (run->kind, ==, QN_RUN_MODE);
  driver_discard (window);
}

/* The motion of the ground is plotted, in every way. */
static void
test_ground_preview (void)
{
  QnWindow *window = driver_open_example ("42-arch-pulse.quoin");
  driver_open_analysis (window);
  GtkWidget *choice =
    driver_find_widget (GTK_WIDGET (window), is_procedure_choice, "Acceleration");
  g_assert_nonnull (choice);
  for (guint i = 0; i < 4; i++) {
    g_autofree char *name = g_strdup_printf ("ground-%u", i);
    gtk_drop_down_set_selected (GTK_DROP_DOWN (choice), i);
    gtk_widget_grab_focus (choice);
    driver_key ("Tab");
    driver_key ("Tab");
    g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (choice)), ==, i);
    g_assert_true (gtk_widget_get_mapped (gtk_widget_get_next_sibling (choice)));
    driver_screenshot (GTK_WIDGET (window), name);
  }
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/analysis/live", test_live);
  g_test_add_func ("/app/analysis/failures", test_failures);
  g_test_add_func ("/app/analysis/dead-load", test_dead_load);
  g_test_add_func ("/app/analysis/procedures", test_procedures);
  g_test_add_func ("/app/analysis/in-time", test_in_time);
  g_test_add_func ("/app/analysis/ground-preview", test_ground_preview);
  g_test_add_func ("/app/analysis/rest", test_rest);
  g_test_add_func ("/app/analysis/bounds", test_bounds);
  g_test_add_func ("/app/analysis/compare-files", test_compare_files);
  g_test_add_func ("/app/analysis/compare-own-file", test_compare_own_file);
  g_test_add_func ("/app/analysis/modes-and-stability", test_modes_and_stability);
}
