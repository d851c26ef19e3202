/* Studies in the window: a number is made to vary by its context menu, the study runs beside the
 * project, a case opens in the drawing, tables and figures are written, a load moves along a line
 * that is drawn. */
#include "driver.h"

#include "app/pages/study-private.h"
#include "app/widgets/quantity-entry.h"
#include "app/window/window-private.h"
#include "study/plan/study.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static gboolean
shows (GtkWidget *widget, gconstpointer data)
{
  return QN_IS_QUANTITY_ENTRY (widget) && gtk_widget_get_mapped (widget)
         && g_str_has_prefix (gtk_editable_get_text (GTK_EDITABLE (widget)), data);
}

static gboolean
is_drop_down (GtkWidget *widget, gconstpointer data)
{
  if (!GTK_IS_DROP_DOWN (widget))
    return FALSE;
  GListModel *rows = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
  return GTK_IS_STRING_LIST (rows) && g_list_model_get_n_items (rows) > 0
         && g_str_equal (gtk_string_list_get_string (GTK_STRING_LIST (rows), 0), data);
}

static gboolean
is_area (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_DRAWING_AREA (widget);
}

static gboolean
is_progress (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_PROGRESS_BAR (widget);
}

static gboolean
is_idle (gpointer dialog)
{
  return !gtk_widget_get_visible (driver_find_widget (dialog, is_progress, NULL));
}

static gboolean
shows_case (gpointer window)
{
  const QnRun *run = qn_window_get_document (window)->run;
  return run != NULL && g_str_has_prefix (run->name, "Case ");
}

static gboolean
has_study (gpointer data)
{
  (void) data;
  return driver_find_page ("Study") != NULL;
}

static gsize
count_lines (const char *path)
{
  g_autofree char *text = NULL;
  gsize lines = 0;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  for (const char *c = text; *c != '\0'; c++)
    lines += *c == '\n';
  return lines;
}

/* Runs that the document has. */
static guint
count_runs (gpointer window)
{
  return qn_window_get_document (window)->runs->len;
}

typedef struct Opened {
  QnWindow *window;
  guint before; /* runs */
} Opened;

static gboolean
has_opened (gpointer data)
{
  const Opened *opened = data;
  return count_runs (opened->window) > opened->before;
}

/* Clicks down the middle of the scatter until a point is met: its case opens, another run. */
static void
click_points (GtkWidget *dialog, QnWindow *window)
{
  GtkWidget *plot = driver_find_widget (dialog, is_area, NULL);
  QnStudyPage *study = g_object_get_data (G_OBJECT (dialog), QN_FORM);
  Opened opened = { window, count_runs (window) };
  driver_activate (window, "win.study");
  driver_settle ();
  study->chosen = -1;
  for (int y = 60; y < gtk_widget_get_height (plot) && study->chosen < 0; y += 15) {
    driver_point_at (plot, gtk_widget_get_width (plot) / 2.0, y);
    driver_press_button ("1");
  }
  g_assert_cmpint (study->chosen, >=, 0);
  driver_wait (has_opened, &opened);
}

static void
export_to (GtkWidget *dialog, const char *what, const char *path)
{
  gtk_widget_activate_action (dialog, "study.export-path", "(ss)", what, path);
}

/* A study of a drawing without a file opens once it has been saved. */
static void
test_unsaved (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "mine.quoin", NULL);
  g_autofree char *example = driver_example_path ("41-column-impulse.quoin");
  QnWindow *window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_copy (window, example));
  driver_activate (window, "win.study");
  g_assert_null (driver_find_page ("Study"));
  g_assert_nonnull (g_object_get_data (G_OBJECT (window), QN_CHOOSER));
  g_object_set_data (G_OBJECT (window), QN_CHOOSER, NULL);
  driver_activate_target (window, "win.save-path", g_variant_new_string (path));
  GtkWidget *page = driver_find_page ("Study");
  g_assert_nonnull (page);
  /* Of an analysis in time what it gives is offered. */
  g_assert_nonnull (driver_find_widget (page, driver_says, "Collapsed (1: yes, 0: no)"));
  g_assert_null (driver_find_widget (page, driver_says, "Collapse multiplier λ"));
  driver_discard (window);
}

/* The friction of a wall, from its context menu to a case in the drawing. */
static void
test_vary (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "ferris-tin-loi/wall3.quoin");
  driver_open_analysis (window);
  GtkWidget *friction = driver_find_widget (GTK_WIDGET (window), shows, "0.65");
  g_assert_nonnull (friction);
  gtk_widget_grab_focus (friction);
  driver_settle ();
  driver_key ("shift+F10");
  driver_screenshot (GTK_WIDGET (window), "study-vary");
  driver_key ("Up");
  driver_key ("Return");
  driver_wait (has_study, NULL);
  GtkWidget *dialog = driver_find_page ("Study");
  g_assert_nonnull (dialog);
  driver_settle ();

  /* Twice is once. */
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.65);
  driver_settle ();
  driver_activate (window, "win.study");
  driver_settle ();
  driver_key ("F5");
  driver_wait (is_idle, dialog);
  driver_screenshot (dialog, "study-cumulative");

  QnStudy study;
  g_autoptr (GError) error = NULL;
  g_autofree char *path = g_build_filename (folder, "wall.quoin-study", NULL);
  g_assert_true (qn_study_read (path, NULL, &study, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (study.parameters->len, ==, 1);
  g_assert_cmpstr (qn_study_parameter (&study, 0)->paths[0], ==, "laws[0].friction");
  qn_study_clear (&study);

  gtk_drop_down_set_selected (
    GTK_DROP_DOWN (driver_find_widget (dialog, is_drop_down, "Cumulative curve")), 1);
  gtk_widget_grab_focus (driver_find_widget (dialog, is_area, NULL));
  driver_settle ();
  driver_key ("Right");
  driver_key ("Right");
  driver_screenshot (dialog, "study-scatter");
  driver_key ("Return");
  driver_wait (shows_case, window);
  /* Nothing has changed since: it has other numbers than the drawing. */
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, "Outdated"));
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "case of the study"));
  driver_screenshot (GTK_WIDGET (window), "study-case");
  click_points (dialog, window);
  g_assert_cmpint (state_of (window)->options.view, ==, QN_VIEW_MECHANISM);

  g_autofree char *table = g_build_filename (folder, "t.csv", NULL);
  g_autofree char *figure = g_build_filename (folder, "f.svg", NULL);
  g_autofree char *sheet = g_build_filename (folder, "m.png", NULL);
  export_to (dialog, "table", table);
  export_to (dialog, "figure", figure);
  export_to (dialog, "mechanisms", sheet);
  g_assert_cmpuint (count_lines (table), ==, 201);
  g_assert_true (g_file_test (figure, G_FILE_TEST_EXISTS));
  g_assert_true (g_file_test (sheet, G_FILE_TEST_EXISTS));
  driver_discard (window);

  /* Opened again by its own file, results are there at once. */
  window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  driver_wait (has_study, NULL);
  dialog = driver_find_page ("Study");
  g_autofree char *again = g_build_filename (folder, "again.csv", NULL);
  export_to (dialog, "table", again);
  g_assert_cmpuint (count_lines (again), ==, 201);
  driver_discard (window);
}

static void
list_entries (GtkWidget *widget, GPtrArray *entries)
{
  if (QN_IS_QUANTITY_ENTRY (widget) && gtk_widget_get_mapped (widget)
      && gtk_widget_is_sensitive (widget))
    g_ptr_array_add (entries, widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    list_entries (child, entries);
}

static gboolean
is_open_menu (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_POPOVER (widget) && gtk_widget_get_mapped (widget);
}

/* GTK does not hear every click on what has just been scrolled there. */
static void
open_menu (GtkWidget *entry)
{
  for (int attempt = 0;
       attempt < 5 && driver_find_widget (entry, is_open_menu, NULL) == NULL; attempt++) {
    driver_point_at (entry, gtk_widget_get_width (entry) / 2.0,
                     gtk_widget_get_height (entry) / 2.0);
    driver_press_button ("3");
  }
}

static void
close_menu (GtkWidget *entry)
{
  GtkWidget *menu = driver_find_widget (entry, is_open_menu, NULL);
  if (menu != NULL)
    gtk_popover_popdown (GTK_POPOVER (menu));
  driver_settle ();
}

/* The path that the menu of an entry offers to vary, or "". */
static char *
dup_offered (GtkWidget *entry)
{
  char *path = NULL;
  GMenuModel *menu = gtk_entry_get_extra_menu (GTK_ENTRY (entry));
  if (menu != NULL && g_menu_model_get_n_items (menu) == 1) {
    g_autoptr (GVariant) target =
      g_menu_model_get_item_attribute_value (menu, 0, "target", NULL);
    g_variant_get (target, "(sd)", &path, NULL);
  }
  return path != NULL ? path : g_strdup ("");
}

/* What a click with the right button would offer, without waiting for one: the entry is told. */
static char *
dup_path (GtkWidget *entry)
{
  g_autoptr (GListModel) controllers = gtk_widget_observe_controllers (entry);
  for (guint i = 0; i < g_list_model_get_n_items (controllers); i++) {
    g_autoptr (GObject) controller = g_list_model_get_item (controllers, i);
    if (GTK_IS_GESTURE_CLICK (controller)
        && gtk_gesture_single_get_button (GTK_GESTURE_SINGLE (controller))
             == GDK_BUTTON_SECONDARY)
      g_signal_emit_by_name (controller, "pressed", 1, 0.0, 0.0);
  }
  return dup_offered (entry);
}

/* The same after a click. */
static char *
click_path (GtkWidget *entry)
{
  gtk_entry_set_extra_menu (GTK_ENTRY (entry), NULL);
  gtk_widget_grab_focus (entry); /* scrolls there */
  driver_settle ();
  open_menu (entry);
  char *path = dup_offered (entry);
  close_menu (entry);
  return path;
}

/* The first of the paths that is no line of `found`, or NULL. */
static const char *
find_missing (const char *const *paths, const char *found)
{
  for (gsize k = 0; paths[k] != NULL; k++) {
    g_autofree char *line = g_strdup_printf ("\n%s\n", paths[k]);
    if (strstr (found, line) == NULL)
      return paths[k];
  }
  return NULL;
}

static gboolean
is_list_of_stages (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LIST_BOX (widget)
         && g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), "stages")
              == 0;
}

static gboolean
is_stage_form (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_EXPANDER (widget)
         && g_strcmp0 (gtk_expander_get_label (GTK_EXPANDER (widget)),
                       "Loading in _Stages")
              == 0;
}

/* Shows the form of stages and selects the first. */
static void
select_stage (QnWindow *window)
{
  GtkWidget *form = driver_find_widget (GTK_WIDGET (window), is_stage_form, NULL);
  g_assert_nonnull (form);
  gtk_expander_set_expanded (GTK_EXPANDER (form), TRUE);
  driver_settle ();
  GtkWidget *list = driver_find_widget (form, is_list_of_stages, NULL);
  g_assert_nonnull (list);
  gtk_list_box_select_row (GTK_LIST_BOX (list),
                           gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), 0));
  driver_settle ();
}

/* Every number of the panels that the project's file holds can be made to vary, whatever form it is in. */
static void
test_every_number (void)
{
  static const struct {
    const char *example, *panel;
    enum { NOTHING, A_BEAM, A_BLOCK, A_STAGE, AN_OPENING } selected;
    const char *paths[12];
  } cases[] = {
    { "ferris-tin-loi/wall3.quoin",
      "analysis",
      NOTHING,
      { "laws[0].friction", "laws[0].kn", "contact.pairs.offset", "analysis.increments",
        "analysis.residual_tolerance", "contact.tolerance", "loads.live[0].direction[0]",
        "loads.dead[0].direction[1]" } },
    { "30-beam-cantilever.quoin",
      "properties",
      A_BEAM,
      { "sections[0].young", "beams[0].elements" } },
    { "42-arch-pulse.quoin",
      "analysis",
      NOTHING,
      { "gravity", "analysis.dynamic.duration", "analysis.dynamic.damping.stiffness" } },
    { "14-pointed-arch.quoin",
      "properties",
      A_BLOCK,
      { "masonry[2].thickness", "masonry[2].perturbation" } },
    { "16-load-stages.quoin",
      "analysis",
      A_STAGE,
      { "analysis.stages[0].target", "analysis.stages[0].increments" } },
    { "24-rocking-block.quoin",
      "analysis",
      A_STAGE,
      { "analysis.stages[0].control.target", "analysis.stages[0].increments" } },
    { "12-facade.quoin",
      "properties",
      AN_OPENING,
      { "masonry[0].openings[0].at[0]", "masonry[0].openings[0].at[1]",
        "masonry[0].openings[0].width", "masonry[0].openings[0].height" } },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    char *folder = test_scratch_new ();
    QnWindow *window = driver_open_copy (folder, cases[i].example);
    QnDocument *document = qn_window_get_document (window);
    QnSelection *selection = document->selection;
    QnId beam = 0, block = (QnId) document->project.model.block_count - 1;
    if (cases[i].selected == A_BEAM)
      qn_selection_set (selection, QN_PICK_BEAM, &beam, 1);
    else if (cases[i].selected == A_BLOCK)
      qn_selection_set (selection, QN_PICK_BLOCK, &block, 1);
    else if (cases[i].selected == AN_OPENING)
      qn_selection_set_opening (selection, 0, 0);
    g_autofree char *panel = g_strconcat ("win.show-panel::", cases[i].panel, NULL);
    driver_activate (window, panel);
    driver_unfold (gtk_stack_get_visible_child (window->side_stack));
    driver_settle ();
    if (cases[i].selected == A_STAGE)
      select_stage (window);
    g_autoptr (GPtrArray) entries = g_ptr_array_new ();
    g_autoptr (GString) found = g_string_new ("\n");
    list_entries (GTK_WIDGET (window), entries);
    const char *missing = find_missing (cases[i].paths, found->str);
    for (guint k = 0; k < entries->len && missing != NULL; k++) {
      GtkWidget *entry = g_ptr_array_index (entries, k);
      g_autofree char *offered = dup_path (entry);
      if (!g_strv_contains (cases[i].paths, offered))
        continue;
      g_autofree char *path = click_path (entry);
      g_string_append_printf (found, "%s\n", path);
      missing = find_missing (cases[i].paths, found->str);
    }
    g_test_message ("%s:%s", cases[i].example, found->str);
    if (missing != NULL)
      g_error ("%s cannot be made to vary", missing);
    driver_discard (window);
    test_scratch_free (folder);
  }
}

static gboolean
is_label_with (GtkWidget *widget, gconstpointer data)
{
  return GTK_IS_LABEL (widget)
         && strstr (gtk_label_get_text (GTK_LABEL (widget)), data) != NULL;
}

static gboolean
study_says (GtkWidget *dialog, const char *words)
{
  return driver_find_widget (dialog, is_label_with, words) != NULL;
}

/* Values by the keyboard, undo, cancel, and what is wrong is said. */
static void
test_edit (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "ferris-tin-loi/wall3.quoin");
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.65);
  driver_wait (has_study, NULL);
  GtkWidget *dialog = driver_find_page ("Study");
  driver_settle ();
  GtkWidget *least = driver_find_widget (dialog, shows, "0.585");
  g_assert_nonnull (least);
  gtk_widget_grab_focus (least);
  driver_key ("ctrl+a");
  driver_type ("0.4");
  driver_key ("Return");
  g_assert_nonnull (driver_find_widget (dialog, shows, "0.4"));
  gtk_widget_activate_action (dialog, "study.undo", NULL);
  driver_settle ();
  g_assert_nonnull (driver_find_widget (dialog, shows, "0.585"));
  gtk_widget_activate_action (dialog, "study.redo", NULL);
  driver_settle ();
  g_assert_nonnull (driver_find_widget (dialog, shows, "0.4"));

  /* What cannot be computed is said, and nothing starts. */
  gtk_widget_grab_focus (driver_find_widget (dialog, shows, "0.4"));
  driver_key ("ctrl+a");
  driver_type ("0.9");
  driver_key ("Return");
  gtk_widget_activate_action (dialog, "study.run", NULL);
  driver_settle ();
  g_assert_true (study_says (dialog, "min must be less than max"));
  g_assert_true (is_idle (dialog));
  gtk_widget_activate_action (dialog, "study.undo", NULL);
  driver_settle ();

  /* Cancelled, what there is remains; the same study goes on. */
  gtk_widget_activate_action (dialog, "study.run", NULL);
  driver_settle ();
  gtk_widget_activate_action (dialog, "study.cancel", NULL);
  driver_wait (is_idle, dialog);
  gtk_widget_activate_action (dialog, "study.run", NULL);
  driver_settle ();
  driver_wait (is_idle, dialog);
  g_autofree char *table = g_build_filename (folder, "t.csv", NULL);
  export_to (dialog, "table", table);
  g_assert_cmpuint (count_lines (table), ==, 201);
  driver_discard (window);
}

static double
number_in (GtkWidget *dialog, const char *id)
{
  return qn_quantity_entry_get_value (QN_QUANTITY_ENTRY (driver_find_id (dialog, id)));
}

/* Another distribution keeps the fractiles, which are named; what cannot be computed is said before the
 * study runs, and above the curve how many cases had no answer. */
static void
test_distribution (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "01-sliding-block.quoin");
  driver_pass_over_gtk ();
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.5);
  driver_wait (has_study, NULL);
  GtkWidget *dialog = driver_find_page ("Study");
  driver_settle ();
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "Least"));
  gtk_widget_grab_focus (driver_find_id (dialog, "kind"));
  driver_settle ();
  driver_key ("space");
  driver_key ("Down");
  driver_key ("Return");
  g_assert_cmpfloat_with_epsilon (number_in (dialog, "first"), 0.5, 1e-9);
  g_assert_cmpfloat_with_epsilon (number_in (dialog, "second"), 0.05 / 1.6448536, 1e-6);
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "Mean"));
  g_assert_nonnull (
    driver_find_widget (dialog, driver_says, "below 0.45, 5 % above 0.55"));
  driver_screenshot (dialog, "study-normal");

  GtkWidget *deviation = driver_find_id (dialog, "second");
  gtk_widget_grab_focus (deviation);
  driver_key ("ctrl+a");
  driver_type ("0.5");
  driver_key ("Return");
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "-0.322 is refused"));
  driver_key ("F5");
  driver_wait (is_idle, dialog);
  g_assert_nonnull (
    driver_find_widget (dialog, driver_says, "cases have no answer; the figures"));
  driver_screenshot (dialog, "study-failed");
  driver_discard (window);
}

/* The results, in a folder beside the project that is named after it. */
static char *
find_results (const char *folder)
{
  g_autofree char *all = g_build_filename (folder, "wall-study", NULL);
  g_autoptr (GDir) dir = g_dir_open (all, 0, NULL);
  const char *name = g_dir_read_name (dir);
  return name != NULL ? g_build_filename (all, name, NULL) : NULL;
}

/* An output over two parameters, on the screen and as a file. */
static void
test_surface (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "ferris-tin-loi/wall3.quoin");
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.65);
  driver_wait (has_study, NULL);
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].kn", 1e8);
  GtkWidget *dialog = driver_find_page ("Study");
  GtkWidget *figure = driver_find_widget (dialog, is_drop_down, "Cumulative curve");
  driver_settle ();
  gtk_drop_down_set_selected (GTK_DROP_DOWN (figure), 5);
  gtk_drop_down_set_selected (
    GTK_DROP_DOWN (driver_find_widget (dialog, is_drop_down, "Grid of values")), 0);
  driver_settle ();
  g_autofree char *early = g_build_filename (folder, "early.svg", NULL);
  export_to (dialog, "figure", early);
  g_assert_false (g_file_test (early, G_FILE_TEST_EXISTS));
  gtk_widget_activate_action (dialog, "study.run", NULL);
  driver_settle ();
  driver_wait (is_idle, dialog);
  driver_screenshot (dialog, "study-surface");
  g_autofree char *path = g_build_filename (folder, "surface.svg", NULL);
  g_autofree char *table = g_build_filename (folder, "t.csv", NULL);
  export_to (dialog, "table", table);
  export_to (dialog, "figure", path);
  g_assert_cmpuint (count_lines (table), >, 4);
  g_assert_true (g_file_test (path, G_FILE_TEST_EXISTS));

  /* The same picture as from the command line. */
  g_autofree char *results = find_results (folder);
  g_autofree char *second = g_build_filename (folder, "second.svg", NULL);
  const char *const command[] = { g_getenv ("QUOIN_CLI"),
                                  "study",
                                  "plot",
                                  "--kind",
                                  "surface",
                                  "--of",
                                  "collapse_multiplier",
                                  "--by",
                                  "friction",
                                  "--by",
                                  "kn",
                                  "-o",
                                  second,
                                  results,
                                  NULL };
  int status = -1;
  g_assert_true (g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_DEFAULT, NULL, NULL,
                               NULL, NULL, &status, NULL));
  g_assert_cmpint (status, ==, 0);
  g_autofree char *shown = NULL, *printed = NULL;
  g_assert_true (g_file_get_contents (path, &shown, NULL, NULL));
  g_assert_true (g_file_get_contents (second, &printed, NULL, NULL));
  g_assert_true (g_str_equal (shown, printed));
  g_assert_nonnull (strstr (shown, "\nSource: wall.quoin\n"));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/study/unsaved", test_unsaved);
  g_test_add_func ("/app/study/vary", test_vary);
  g_test_add_func ("/app/study/every-number", test_every_number);
  g_test_add_func ("/app/study/edit", test_edit);
  g_test_add_func ("/app/study/distribution", test_distribution);
  g_test_add_func ("/app/study/surface", test_surface);
}
