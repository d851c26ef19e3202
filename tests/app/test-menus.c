/* Context menus of lists, choices, tables and studies: by the right button, by Menu and by Shift+F10,
 * and what their items do. */
#include "menu-driver.h"

#include "app/widgets/row.h"
#include "doc/edit/edit-stage.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

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
  menu_check_keys (row, "Remove Bar");
  menu_right_click (row);
  driver_screenshot (driver_find_widget (row, driver_is_menu, NULL), "menu-bar");
  menu_choose (row, "Remove Bar");
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
  menu_check_keys (row, "Remove Stage");
  menu_right_click (row);
  menu_choose (row, "Earlier");
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
  gsize count = model_of (window)->dead_load_count;
  g_assert_cmpuint (count, >, 0);
  GtkWidget *row = row_of (driver_find_id (form, "loads"), 0);
  menu_check_keys (row, "Copy Text");
  menu_right_click (row);
  menu_choose (row, "Remove Load");
  g_assert_cmpuint (model_of (window)->dead_load_count, ==, count - 1);
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
  gsize count = model_of (window)->dead_load_count;
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
  g_assert_cmpuint (model_of (window)->dead_load_count, ==, count + 1);
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
  menu_check_keys (law, "Duplicate Law");
  menu_right_click (law);
  menu_choose (law, "Duplicate Law");
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
  menu_right_click (cell);
  menu_choose (cell, "Copy Row");
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
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
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
    menu_expect (canvas);
    driver_set_animated (i % 2 == 1);
    driver_click_on (canvas, menu_is_item, "Show");
    if (i < 2)
      driver_key ("Escape");
    else
      driver_click_on (canvas, menu_is_item, "Block Names");
    driver_key ("ctrl+a");
    driver_set_animated (FALSE);
    driver_settle ();
    qn_selection_get (selection, QN_PICK_BLOCK, &count);
    g_assert_cmpuint (count, ==, model_of (window)->block_count);
    qn_selection_clear (selection);
  }
  driver_press_button ("3");
  driver_click_on (canvas, menu_is_item, "Show");
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
    { "12-facade.quoin", "properties", "win.study", 3 },
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
        qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
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
    menu_expect (root);
    driver_click_on (root, menu_is_item, "Show");
    if (i == 0)
      driver_key ("Escape");
    else
      driver_click_on (root, menu_is_item, "Block Names");
    driver_key ("ctrl+a");
    qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
    g_assert_cmpuint (count, ==, model_of (window)->block_count);
    qn_selection_clear (selection_of (window));
  }
  driver_key ("F10");
  driver_click_on (root, menu_is_item, "Show");
  driver_discard (window); /* with the submenu open */
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
  GtkWidget *row = driver_find_widget (GTK_WIDGET (window), menu_is_row, "Increments");
  GtkWidget *entry = qn_row_get_field (QN_ROW (row));
  menu_right_click (entry);
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

/* ---- studies ---- */

static gboolean
has_no_parameters (gpointer dialog)
{
  return !gtk_widget_get_mapped (driver_find_id (dialog, "parameters"));
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
  return qn_window_get_document (window)->runs->len == 1;
}

static void
test_study (void)
{
  driver_pass_over_gtk ();
  test_autoscratch char *folder = test_scratch_new ();
  QnWindow *window = driver_open_copy (folder, "ferris-tin-loi/wall3.quoin");
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
  menu_check_keys (plot, "Open Case in the Drawing");
  menu_right_click (plot);
  g_assert_nonnull (driver_find_widget (plot, menu_is_item, "Table…"));
  driver_key ("Escape");
  driver_key ("Menu");
  menu_expect (plot);
  menu_choose (plot, "Copy Text");
  driver_key ("Menu");
  menu_expect (plot);
  menu_choose (plot, "Open Case in the Drawing");
  driver_wait (has_case, window);
  g_assert_true (gtk_widget_get_mapped (GTK_WIDGET (window->canvas)));
  g_assert_null (qn_window_get_page (window));
  driver_activate (window, "win.study");

  GtkWidget *parameters = driver_find_id (dialog, "parameters");
  GtkWidget *row =
    GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (parameters), 0));
  menu_right_click (driver_find_id (row, "place"));
  menu_choose (row, "Leave It As It Is");
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
  g_test_add_func ("/app/menus/words", test_words);
  g_test_add_func ("/app/menus/study", test_study);
}
