/* Context menus of lists, choices, tables, studies and comparisons: by the right button, by Menu and by
 * Shift+F10, and what their items do. What is dragged and dropped with the pointer. */
#include "driver.h"

#include "app/widgets/row.h"
#include "doc/edit/edit-stage.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

/* An item of a menu, by its label without underlines. */
static gboolean
is_item (GtkWidget *widget, gconstpointer label)
{
  g_autofree char *text = NULL;
  if (!g_str_equal (G_OBJECT_TYPE_NAME (widget), "GtkModelButton")
      || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_object_get (widget, "text", &text, NULL);
  g_auto (GStrv) parts = g_strsplit (text, "_", 2);
  g_autofree char *plain = g_strjoinv ("", parts);
  return g_str_equal (plain, label);
}

static GtkWidget *
row_of (GtkWidget *list, int index)
{
  GtkWidget *row =
    GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), index));
  g_assert_nonnull (row);
  gtk_widget_grab_focus (row);
  driver_settle ();
  return row;
}

static void
expect_menu (GtkWidget *inside)
{
  GtkWidget *widget = GTK_WIDGET (gtk_widget_get_root (inside));
  if (driver_find_widget (widget, driver_is_menu, NULL) == NULL) {
    driver_screenshot (widget, "menu-missing");
    g_error ("no menu of the %s", G_OBJECT_TYPE_NAME (inside));
  }
}

/* Opens the menu in the middle of a widget by the right button. */
static void
right_click (GtkWidget *widget)
{
  driver_point_at (widget, 0.5 * gtk_widget_get_width (widget),
                   0.5 * gtk_widget_get_height (widget));
  driver_press_button ("3");
  expect_menu (widget);
}

/* Clicks on an item of the menu that is open there. */
static void
choose (GtkWidget *widget, const char *label)
{
  driver_click_on (widget, is_item, label);
}

/* Both keys open it where the focus is, and Escape closes it. */
static void
check_keys (GtkWidget *widget, const char *label)
{
  static const char *const keys[] = { "Menu", "shift+F10" };
  for (gsize i = 0; i < G_N_ELEMENTS (keys); i++) {
    driver_key (keys[i]);
    expect_menu (widget);
    g_assert_nonnull (driver_find_widget (widget, is_item, label));
    driver_key ("Escape");
    g_assert_null (driver_find_widget (widget, driver_is_menu, NULL));
  }
}

static QnWindow *
open_panel (const char *example, const char *panel)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example (example);
  driver_activate_target (window, "win.show-panel", g_variant_new_string (panel));
  driver_unfold (GTK_WIDGET (window));
  driver_settle ();
  return window;
}

/* ---- forms ---- */

static void
test_bars (void)
{
  QnWindow *window = open_panel ("09-reinforced-cantilever.quoin", "analysis");
  gsize count = model_of (window)->bar_count;
  g_assert_cmpuint (count, >, 0);
  GtkWidget *row = row_of (driver_find_id (GTK_WIDGET (window), "bars"), 0);
  check_keys (row, "Remove Bar");
  right_click (row);
  driver_screenshot (driver_find_widget (row, driver_is_menu, NULL), "menu-bar");
  choose (row, "Remove Bar");
  g_assert_cmpuint (model_of (window)->bar_count, ==, count - 1);
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->bar_count, ==, count);
  driver_discard (window);
}

static void
test_stages (void)
{
  QnWindow *window = open_panel ("16-load-stages.quoin", "analysis");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 2);
  g_autofree char *second = g_strdup (model_of (window)->stages[1].name);
  GtkWidget *row =
    row_of (driver_find_id (driver_find_id (GTK_WIDGET (window), "method"), "stages"), 1);
  check_keys (row, "Remove Stage");
  right_click (row);
  choose (row, "Earlier");
  g_assert_cmpstr (model_of (window)->stages[0].name, ==, second);
  driver_discard (window);
}

static void
test_loads (void)
{
  QnWindow *window = open_panel ("16-load-stages.quoin", "analysis");
  GtkWidget *form = driver_find_id (GTK_WIDGET (window), "loads_card");
  GtkDropDown *list = GTK_DROP_DOWN (driver_find_id (form, "list"));
  gtk_drop_down_set_selected (list, 0);
  driver_settle ();
  gsize count = qn_model_count_loads (model_of (window), -1);
  g_assert_cmpuint (count, >, 0);
  GtkWidget *row = row_of (driver_find_id (form, "loads"), 0);
  check_keys (row, "Copy Text");
  right_click (row);
  choose (row, "Remove Load");
  g_assert_cmpuint (qn_model_count_loads (model_of (window), -1), ==, count - 1);
  driver_discard (window);
}

static gboolean
is_add_popover (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_POPOVER (widget) && gtk_widget_get_mapped (widget)
         && driver_find_widget (widget, driver_has_id, "add_weight") != NULL;
}

/* The list of kinds under Add closes by Escape, by a click beside it, by what is chosen and with its window;
 * keys are heard behind it. */
static void
test_add_load (void)
{
  QnWindow *window = open_panel ("01-sliding-block.quoin", "analysis");
  GtkWidget *root = GTK_WIDGET (window);
  GtkWidget *add = driver_find_id (driver_find_id (root, "loads_card"), "add");
  gsize count = qn_model_count_loads (model_of (window), -1);
  for (int way = 0; way < 4; way++) {
    gtk_widget_grab_focus (add);
    driver_settle ();
    driver_point_at (add, 0.5 * gtk_widget_get_width (add), 8.0);
    driver_press_button ("1");
    GtkWidget *popover = driver_find_widget (root, is_add_popover, NULL);
    g_assert_nonnull (popover);
    if (way == 0) {
      driver_screenshot (popover, "menu-add-load");
      driver_key ("Escape");
    } else if (way == 1)
      driver_click (window, 0.0, -1.0);
    else if (way == 2)
      driver_press (popover, "Weight");
    else
      break; /* open when the window goes */
    g_assert_null (driver_find_widget (root, is_add_popover, NULL));
  }
  g_assert_cmpuint (qn_model_count_loads (model_of (window), -1), ==, count + 1);
  driver_discard (window);
}

static void
test_laws (void)
{
  QnWindow *window = open_panel ("ferris-tin-loi/wall3.quoin", "analysis");
  gsize count = model_of (window)->law_count;
  GtkWidget *law =
    driver_find_id (driver_find_id (GTK_WIDGET (window), "materials"), "law");
  gtk_widget_grab_focus (law);
  driver_settle ();
  check_keys (law, "Duplicate Law");
  right_click (law);
  choose (law, "Duplicate Law");
  g_assert_cmpuint (model_of (window)->law_count, ==, count + 1);
  driver_discard (window);
}

/* ---- tables of results ---- */

static gboolean
is_cell (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LABEL (widget) && gtk_widget_get_mapped (widget)
         && g_object_get_data (G_OBJECT (widget), "qn-item") != NULL;
}

static void
test_tables (void)
{
  QnWindow *window = open_panel ("06-arch.quoin", "result");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_unfold (GTK_WIDGET (window));
  driver_settle ();
  GtkWidget *cell = driver_find_widget (GTK_WIDGET (window), is_cell, NULL);
  g_assert_nonnull (cell);
  gtk_widget_grab_focus (gtk_widget_get_ancestor (cell, GTK_TYPE_COLUMN_VIEW));
  driver_settle ();
  right_click (cell);
  choose (cell, "Copy Row");
  driver_discard (window);
}

/* A menu that is open when its window closes, here over a history in time, goes with it, and the next
 * window hears the pointer. */
static void
test_open_at_end (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("40-rocking-in-time.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  GtkWidget *button = driver_find_id (GTK_WIDGET (window), "field_button");
  GtkPopover *menu = gtk_menu_button_get_popover (GTK_MENU_BUTTON (button));
  driver_point_at (button, 0.5 * gtk_widget_get_width (button),
                   0.5 * gtk_widget_get_height (button));
  driver_press_button ("1");
  g_assert_true (gtk_widget_get_mapped (GTK_WIDGET (menu)));
  driver_discard (window);

  guint count = 0;
  window = driver_open_example ("05-stack.quoin");
  driver_click (window, 0.2, 0.5);
  qn_selection_get (selection_of (window), QN_PART_BLOCK, &count);
  g_assert_cmpuint (count, ==, 1);
  driver_discard (window);
}

/* A submenu that is closed, by Escape or by a choice, leaves a window that hears keys; also while one page
 * of the menu follows upon the other. */
static void
test_submenu (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("12-facade.quoin");
  QnSelection *selection = selection_of (window);
  GtkWidget *canvas = GTK_WIDGET (canvas_of (window));
  for (int i = 0; i < 4; i++) {
    guint count = 0;
    driver_point_at (canvas, 60, 300);
    driver_press_button ("3");
    expect_menu (canvas);
    driver_set_animated (i % 2 == 1);
    driver_click_on (canvas, is_item, "Show");
    if (i < 2)
      driver_key ("Escape");
    else
      driver_click_on (canvas, is_item, "Block Names");
    driver_key ("ctrl+a");
    driver_set_animated (FALSE);
    driver_settle ();
    qn_selection_get (selection, QN_PART_BLOCK, &count);
    g_assert_cmpuint (count, ==, model_of (window)->block_count);
    qn_selection_clear (selection);
  }
  driver_press_button ("3");
  driver_click_on (canvas, is_item, "Show");
  driver_discard (window); /* with the submenu open */
}

/* Menus and popovers behind buttons that can be pressed now. */
static void
add_menu_buttons (GtkWidget *widget, GPtrArray *buttons)
{
  if (GTK_IS_MENU_BUTTON (widget) && gtk_widget_get_mapped (widget)
      && gtk_widget_is_sensitive (widget)
      && gtk_menu_button_get_popover (GTK_MENU_BUTTON (widget)) != NULL)
    g_ptr_array_add (buttons, widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    add_menu_buttons (child, buttons);
}

static void
open_popover (GtkMenuButton *button)
{
  gtk_widget_grab_focus (GTK_WIDGET (button)); /* into sight */
  driver_settle ();
  gtk_menu_button_popup (button);
  driver_settle ();
  g_assert_true (
    gtk_widget_get_mapped (GTK_WIDGET (gtk_menu_button_get_popover (button))));
}

/* Whatever a button opens closes by Escape, and the window hears keys afterwards; each is open once when
 * its window goes. */
static void
test_every_button (void)
{
  static const struct {
    const char *example, *panel, *action;
    guint buttons; /* at least */
  } states[] = {
    { "53-arch-bridge.quoin", "analysis", "win.envelope", 5 },
    { "12-facade.quoin", "properties", "win.study", 4 },
  };
  driver_pass_over_gtk ();
  for (gsize i = 0; i < G_N_ELEMENTS (states); i++) {
    guint last = 0, button_count;
    do {
      QnWindow *window = open_panel (states[i].example, states[i].panel);
      GtkWidget *root = GTK_WIDGET (window);
      g_autoptr (GPtrArray) buttons = g_ptr_array_new ();
      driver_activate (window, "win.select-all");
      driver_activate (window, states[i].action);
      driver_settle ();
      add_menu_buttons (root, buttons);
      button_count = buttons->len;
      g_assert_cmpuint (button_count, >=, states[i].buttons);
      for (guint k = 0; last == 0 && k < button_count; k++) {
        guint count = 0;
        g_test_message ("button %u", k);
        open_popover (buttons->pdata[k]);
        driver_key ("Escape");
        g_assert_false (gtk_widget_get_mapped (
          GTK_WIDGET (gtk_menu_button_get_popover (buttons->pdata[k]))));
        qn_selection_clear (selection_of (window));
        driver_key ("ctrl+a");
        qn_selection_get (selection_of (window), QN_PART_BLOCK, &count);
        g_assert_cmpuint (count, ==, model_of (window)->block_count);
      }
      g_test_message ("window with button %u", last);
      open_popover (buttons->pdata[last]);
      driver_discard (window);
    } while (++last < button_count);
  }
}

static gboolean
is_choice (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_DROP_DOWN (widget) && gtk_widget_get_mapped (widget)
         && gtk_widget_is_sensitive (widget);
}

static gboolean
is_open (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_POPOVER (widget) && gtk_widget_get_mapped (widget);
}

/* Choices and menus close by Escape and by a click beside them, and nothing is chosen; a choice may be open
 * when its window goes. */
static void
test_beside (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = open_panel ("01-sliding-block.quoin", "analysis");
  GtkWidget *choice = driver_find_widget (GTK_WIDGET (window), is_choice, NULL);
  GtkWidget *openers[] = { GTK_WIDGET (window->history_button), choice };
  g_assert_nonnull (choice);
  guint chosen = gtk_drop_down_get_selected (GTK_DROP_DOWN (choice));
  for (gsize i = 0; i < G_N_ELEMENTS (openers); i++)
    for (int beside = 0; beside < 2; beside++) {
      gtk_widget_grab_focus (openers[i]);
      driver_settle ();
      driver_key ("space");
      g_assert_nonnull (driver_find_widget (openers[i], is_open, NULL));
      if (beside)
        driver_click (window, 0.0, -1.0);
      else
        driver_key ("Escape");
      g_assert_null (driver_find_widget (openers[i], is_open, NULL));
    }
  g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (choice)), ==, chosen);
  gtk_widget_grab_focus (choice);
  driver_settle ();
  driver_key ("space");
  g_assert_nonnull (driver_find_widget (choice, is_open, NULL));
  driver_discard (window);
}

/* The same of the main menu. */
static void
test_main_submenu (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("12-facade.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  gtk_widget_grab_focus (GTK_WIDGET (canvas_of (window)));
  for (int i = 0; i < 2; i++) {
    guint count = 0;
    driver_key ("F10");
    expect_menu (root);
    driver_click_on (root, is_item, "Show");
    if (i == 0)
      driver_key ("Escape");
    else
      driver_click_on (root, is_item, "Block Names");
    driver_key ("ctrl+a");
    qn_selection_get (selection_of (window), QN_PART_BLOCK, &count);
    g_assert_cmpuint (count, ==, model_of (window)->block_count);
    qn_selection_clear (selection_of (window));
  }
  driver_key ("F10");
  driver_click_on (root, is_item, "Show");
  driver_discard (window); /* with the submenu open */
}

/* ---- comparison ---- */

static guint
count_pictures (GtkWidget *dialog)
{
  GtkWidget *grid =
    gtk_widget_get_parent (driver_find_widget (dialog, driver_is_cell, NULL));
  guint count = 0;
  for (GtkWidget *child = gtk_widget_get_first_child (grid); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    count += driver_is_cell (child, NULL);
  return count;
}

/* The words beneath a picture, a new string. */
static char *
dup_words (GtkWidget *picture)
{
  GtkWidget *label = gtk_widget_get_first_child (picture);
  while (!GTK_IS_LABEL (label))
    label = gtk_widget_get_next_sibling (label);
  return g_strdup (gtk_label_get_text (GTK_LABEL (label)));
}

static void
test_comparison (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 2);
  GtkWidget *first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *words = dup_words (first);
  gtk_widget_grab_focus (first);
  check_keys (first, "Later");
  right_click (first);
  driver_screenshot (driver_find_widget (first, driver_is_menu, NULL), "menu-comparison");
  choose (first, "Later");
  first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *after = dup_words (first);
  g_assert_cmpstr (words, !=, after);
  right_click (first);
  choose (first, "Remove from Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 1);
  first = driver_find_widget (dialog, driver_is_cell, NULL);
  g_autofree char *left = dup_words (first);
  g_assert_true (g_str_has_suffix (words, left)); /* alone it needs no name beneath */
  /* The picture that stayed has the focus. */
  driver_key ("Delete");
  driver_settle ();
  g_assert_null (driver_find_widget (dialog, driver_is_cell, NULL));
  driver_discard (window);
}

static gboolean
is_name (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_ENTRY (widget)
         && g_str_equal (gtk_editable_get_text (GTK_EDITABLE (widget)), text);
}

static gboolean
is_row (GtkWidget *widget, gconstpointer name)
{
  g_autofree char *own = QN_IS_ROW (widget) && gtk_widget_get_mapped (widget)
                           ? qn_row_dup_name (QN_ROW (widget))
                           : NULL;
  return own != NULL && g_str_has_prefix (own, name);
}

static void
set_friction (QnWindow *window, const char *number)
{
  driver_open_analysis (window);
  GtkWidget *row = driver_find_widget (GTK_WIDGET (window), is_row, "Friction");
  GtkWidget *friction = qn_row_get_field (QN_ROW (row));
  gtk_widget_grab_focus (friction);
  driver_key ("ctrl+a");
  driver_type (number);
  driver_key ("Return");
}

/* Three variants are told apart by what differs, until one is given a name over its picture; the name is
 * in the table, is undone, and is typed in the panel of results too. */
static void
test_variants (void)
{
  static const char *const frictions[] = { "0.3", "0.8" };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_key ("F5");
  driver_wait_for_job (window);
  for (gsize i = 0; i < G_N_ELEMENTS (frictions); i++) {
    set_friction (window, frictions[i]);
    driver_key ("F5");
    driver_wait_for_job (window);
  }
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  g_assert_cmpuint (count_pictures (dialog), ==, 3);
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "friction 0.3"));
  GtkWidget *name = driver_find_widget (dialog, is_name, "friction 0.8");
  g_assert_nonnull (name);
  driver_screenshot (dialog, "comparison-names");
  GtkWidget *outcome = driver_find_widget (dialog, driver_says, "Outcome");
  GtkAdjustment *across = gtk_scrollable_get_hadjustment (
    GTK_SCROLLABLE (gtk_widget_get_ancestor (outcome, GTK_TYPE_VIEWPORT)));
  g_assert_cmpfloat (gtk_adjustment_get_upper (across), <=,
                     gtk_adjustment_get_page_size (across) + 1.0);
  driver_point_at (name, 0.5 * gtk_widget_get_width (name), 8.0);
  driver_press_button ("1");
  driver_key ("ctrl+a");
  driver_type ("rough joints");
  driver_key ("Return");
  g_assert_cmpstr (driver_last_step (window), ==, "Rename Run");
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "rough joints"));
  driver_key ("Escape");
  g_assert_null (driver_find_page ("Comparison"));
  driver_key ("ctrl+z");
  const QnRun *run = qn_document_get_run (qn_window_get_document (window));
  g_assert_cmpstr (run->label, ==, "friction 0.8");

  driver_activate (window, "win.show-panel::result");
  GtkWidget *entry = driver_find_id (GTK_WIDGET (window), "run_name");
  gtk_widget_grab_focus (entry);
  driver_key ("ctrl+a");
  driver_type ("rough");
  driver_key ("Tab"); /* leaving takes it, too */
  g_assert_cmpstr (run->name, ==, "rough, load control");
  driver_screenshot (GTK_WIDGET (window), "run-name");
  driver_discard (window);
}

/* All methods after one of them add the others alone. */
static void
test_all_methods (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  const GPtrArray *runs = qn_document_get_runs (qn_window_get_document (window));
  driver_key ("F5");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-all");
  driver_wait_for_job (window);
  g_assert_cmpuint (runs->len, ==, 3);
  for (guint i = 0; i < runs->len; i++)
    for (guint k = 0; k < i; k++)
      g_assert_cmpstr (((QnRun *) runs->pdata[i])->name, !=,
                       ((QnRun *) runs->pdata[k])->name);
  driver_discard (window);
}

/* ---- words ---- */

static gboolean
is_emoji_item (GtkWidget *widget, gconstpointer data)
{
  g_autofree char *text = NULL;
  (void) data;
  if (!g_str_equal (G_OBJECT_TYPE_NAME (widget), "GtkModelButton")
      || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_object_get (widget, "text", &text, NULL);
  return text != NULL && strstr (text, "moji") != NULL;
}

/* Names take any sign, numbers do not. A project without a title has the name of its file once in the title
 * bar, and among those opened last its name with the folder. */
static void
test_words (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "plain.quoin", NULL);
  const char *text =
    "{ \"format\": \"quoin\", \"version\": 1, \"blocks\": [ { \"name\": \"a\","
    "  \"vertices\": [[0,0],[1,0],[1,1],[0,1]], \"thickness\": 1, \"unit_weight\": 1e4,"
    "  \"support\": [true, true, true] } ],"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ], \"contact\": { \"law\": \"dry\" } }";
  driver_pass_over_gtk ();
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  driver_open_analysis (window);
  GtkWidget *row = driver_find_widget (GTK_WIDGET (window), is_row, "Increments");
  GtkWidget *entry = qn_row_get_field (QN_ROW (row));
  right_click (entry);
  g_assert_null (driver_find_widget (entry, is_emoji_item, NULL));
  driver_screenshot (GTK_WIDGET (window), "number-menu");
  driver_key ("Escape");
  /* A unit that does not fit is refused with the reason in sight, not only where the pointer rests. */
  gtk_widget_grab_focus (entry);
  driver_key ("ctrl+a");
  driver_type ("2 kg");
  driver_key ("Return");
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, "“kg”"));
  driver_screenshot (GTK_WIDGET (window), "refused-unit");
  driver_discard (window);

  window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  driver_settle ();
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, "plain.quoin"));
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, "plain.quoin —"));
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, folder));
  driver_screenshot (GTK_WIDGET (window), "title-once");
  driver_discard (window);
  window = driver_open_window (1280, 800);
  driver_screenshot (GTK_WIDGET (window), "recent");
  GtkWidget *recent = driver_find_widget (GTK_WIDGET (window), driver_says, folder);
  g_assert_nonnull (recent);
  g_assert_cmpstr (gtk_label_get_text (GTK_LABEL (gtk_widget_get_prev_sibling (recent))),
                   ==, "plain");
  driver_discard (window);
}

/* ---- dragging ---- */

static void
press (gboolean down)
{
  const char *const arguments[] = { down ? "mousedown" : "mouseup", "1", NULL };
  driver_xdotool (arguments);
}

/* Moves the pointer in steps: a drag begins and is followed by its motion. */
static void
move_along (double x0, double y0, double x1, double y1)
{
  for (int i = 1; i <= 8; i++) {
    g_autofree char *x = g_strdup_printf ("%.0f", x0 + (x1 - x0) * i / 8.0);
    g_autofree char *y = g_strdup_printf ("%.0f", y0 + (y1 - y0) * i / 8.0);
    const char *const arguments[] = { "mousemove", x, y, NULL };
    driver_xdotool (arguments);
  }
}

/* Middle of a widget on the screen, in a window at its corner. */
static void
find_middle (GtkWidget *widget, double *x, double *y)
{
  GtkNative *native = gtk_widget_get_native (widget);
  double left, top;
  gtk_native_get_surface_transform (native, &left, &top);
  gtk_widget_translate_coordinates (widget, GTK_WIDGET (native),
                                    0.5 * gtk_widget_get_width (widget),
                                    0.5 * gtk_widget_get_height (widget), x, y);
  *x += left;
  *y += top;
}

/* The words beneath the first picture, dragged onto the second with the pointer. */
static void
test_drag_caption (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate (window, "win.run-limit::associative");
  driver_wait_for_job (window);
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  GtkWidget *first = driver_find_widget (dialog, driver_is_cell, NULL);
  GtkWidget *second = gtk_widget_get_next_sibling (first);
  g_autofree char *words = dup_words (second);
  double x0, y0, x1, y1;
  GtkWidget *label = gtk_widget_get_first_child (first);
  while (!GTK_IS_LABEL (label))
    label = gtk_widget_get_next_sibling (label);
  find_middle (label, &x0, &y0);
  find_middle (second, &x1, &y1);
  driver_point_at (label, 0.5 * gtk_widget_get_width (label),
                   0.5 * gtk_widget_get_height (label));
  press (TRUE);
  move_along (x0, y0, x1, y1);
  press (FALSE);
  driver_settle ();
  g_autofree char *after = dup_words (driver_find_widget (dialog, driver_is_cell, NULL));
  g_assert_cmpstr (after, ==, words);
  driver_discard (window);
}

/* A window to the right of the others, from which files can be dragged. */
static GdkContentProvider *
give_files (GtkDragSource *source, double x, double y, gpointer data)
{
  const char *const *names = data;
  GSList *files = NULL;
  (void) source;
  (void) x;
  (void) y;
  for (guint i = 0; names[i] != NULL; i++) {
    g_autofree char *path = driver_example_path (names[i]);
    files = g_slist_append (files, g_file_new_for_path (path));
  }
  GdkContentProvider *content =
    gdk_content_provider_new_typed (GDK_TYPE_FILE_LIST, files);
  g_slist_free_full (files, g_object_unref);
  return content;
}

static void
drag_files (const char *const *names, GtkWidget *onto)
{
  GtkWidget *window = gtk_window_new ();
  GtkDragSource *source = gtk_drag_source_new ();
  gtk_window_set_title (GTK_WINDOW (window), "files of the test");
  gtk_window_set_decorated (GTK_WINDOW (window), FALSE);
  gtk_window_set_default_size (GTK_WINDOW (window), 200, 200);
  gtk_window_set_child (GTK_WINDOW (window), gtk_label_new ("files"));
  g_signal_connect (source, "prepare", G_CALLBACK (give_files), (gpointer) names);
  gtk_widget_add_controller (window, GTK_EVENT_CONTROLLER (source));
  gtk_window_present (GTK_WINDOW (window));
  driver_settle ();
  const char *const aside[] = { "search",     "--name", "files of the test",
                                "windowmove", "1600",   "700",
                                NULL };
  driver_xdotool (aside);
  const char *const there[] = { "mousemove", "1700", "800", NULL };
  driver_xdotool (there);
  press (TRUE);
  double x, y;
  find_middle (onto, &x, &y);
  move_along (1700, 800, x, y);
  press (FALSE);
  driver_settle ();
  gtk_window_destroy (GTK_WINDOW (window));
}

static gboolean
has_path (gpointer data)
{
  return qn_document_get_path (qn_window_get_document (data)) != NULL;
}

static gboolean
has_two_pictures (gpointer dialog)
{
  return driver_find_widget (dialog, driver_is_cell, NULL) != NULL
         && count_pictures (dialog) == 2;
}

/* A project dropped on an empty window is opened; two on a comparison are solved and shown. */
static void
test_drop_files (void)
{
  static const char *const one[] = { "06-arch.quoin", NULL };
  static const char *const two[] = { "02-overturning-block.quoin", "05-stack.quoin",
                                     NULL };
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_window (1200, 760);
  drag_files (one, GTK_WIDGET (window));
  driver_wait (has_path, window);
  g_assert_true (g_str_has_suffix (qn_document_get_path (qn_window_get_document (window)),
                                   "06-arch.quoin"));
  driver_activate (window, "win.compare");
  GtkWidget *dialog = driver_find_page ("Comparison");
  drag_files (two, dialog);
  driver_wait (has_two_pictures, dialog);
  driver_discard (window);
}

/* ---- studies ---- */

static gboolean
has_no_parameters (gpointer dialog)
{
  return !gtk_widget_get_visible (driver_find_id (dialog, "parameters"));
}

static gboolean
has_results (gpointer dialog)
{
  gboolean enabled = FALSE;
  GtkWidget *export = driver_find_id (dialog, "export");
  GtkWidget *progress = driver_find_id (dialog, "progress");
  enabled = gtk_widget_get_sensitive (export);
  return enabled && !gtk_widget_get_visible (progress);
}

static gboolean
has_case (gpointer window)
{
  return qn_document_get_runs (qn_window_get_document (window))->len == 1;
}

static void
test_study (void)
{
  driver_pass_over_gtk ();
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *source = driver_example_path ("ferris-tin-loi/wall3.quoin");
  g_autofree char *path = g_build_filename (folder, "wall.quoin", NULL);
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (source, &text, NULL, NULL));
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  QnWindow *window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  driver_settle ();
  gtk_widget_activate_action (GTK_WIDGET (window), "win.vary", "(sd)", "laws[0].friction",
                              0.65);
  driver_settle ();
  GtkWidget *dialog = driver_find_page ("Study");
  g_assert_nonnull (dialog);
  gtk_spin_button_set_value (GTK_SPIN_BUTTON (driver_find_id (dialog, "count")), 8);
  driver_settle ();
  gtk_widget_activate_action (dialog, "study.run", NULL);
  driver_settle ();
  driver_wait (has_results, dialog);

  GtkWidget *plot = driver_find_id (dialog, "plot");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (driver_find_id (dialog, "figure")), 1);
  driver_settle ();
  gtk_widget_grab_focus (plot);
  driver_key ("Right");
  check_keys (plot, "Open Case in the Drawing");
  right_click (plot);
  g_assert_nonnull (driver_find_widget (plot, is_item, "Table…"));
  driver_key ("Escape");
  driver_key ("Menu");
  expect_menu (plot);
  choose (plot, "Copy Text");
  driver_key ("Menu");
  expect_menu (plot);
  choose (plot, "Open Case in the Drawing");
  driver_wait (has_case, window);
  g_assert_true (gtk_widget_get_mapped (GTK_WIDGET (window->canvas)));
  g_assert_null (qn_window_get_page (window));
  driver_activate (window, "win.study");

  GtkWidget *parameters = driver_find_id (dialog, "parameters");
  GtkWidget *row =
    GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (parameters), 0));
  right_click (driver_find_id (row, "place"));
  choose (row, "Leave It As It Is");
  driver_wait (has_no_parameters, dialog);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/menus/bars", test_bars);
  g_test_add_func ("/app/menus/stages", test_stages);
  g_test_add_func ("/app/menus/loads", test_loads);
  g_test_add_func ("/app/menus/add-load", test_add_load);
  g_test_add_func ("/app/menus/laws", test_laws);
  g_test_add_func ("/app/menus/tables", test_tables);
  g_test_add_func ("/app/menus/open-at-end", test_open_at_end);
  g_test_add_func ("/app/menus/submenu", test_submenu);
  g_test_add_func ("/app/menus/main-submenu", test_main_submenu);
  g_test_add_func ("/app/menus/every-button", test_every_button);
  g_test_add_func ("/app/menus/beside", test_beside);
  g_test_add_func ("/app/menus/comparison", test_comparison);
  g_test_add_func ("/app/menus/variants", test_variants);
  g_test_add_func ("/app/menus/words", test_words);
  g_test_add_func ("/app/menus/all-methods", test_all_methods);
  g_test_add_func ("/app/menus/drag-caption", test_drag_caption);
  g_test_add_func ("/app/menus/drop-files", test_drop_files);
  g_test_add_func ("/app/menus/study", test_study);
}
