/* What is within reach: context menus, numbers typed and in panels, keys wherever the focus is,
 * pasting. */
#include "driver.h"

#include "app/canvas/canvas-private.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/quantity-entry.h"
#include "app/window/action-table.h"
#include "io/project/typical-joint.h"
#include "support/edit-model.h"
#include "support/room.h"

static const char two_blocks[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"base\", \"vertices\": [[0,0],[2,0],[2,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"top\", \"vertices\": [[0.5,1],[1.5,1],[1.5,2],[0.5,2]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 },"
  "    { \"name\": \"other\", \"vertices\": [[4,0],[5,0],[5,1],[4,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] } ],"
  "  \"contact\": { \"law\": \"dry\" },"
  "  \"loads\": { \"live\": [ { \"kind\": \"force\", \"block\": \"top\", \"value\": "
  "[100, 0],"
  "    \"at\": [1.0, 1.5] } ] } }";

/* Four with joints of 10, 12, 30, 50 and 60 mm between them, as traced over a photo. */
static const char traced_blocks[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"base\", \"vertices\": "
  "[[0,0],[1.52,0],[1.52,0.3],[0,0.3]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"a\", \"vertices\": [[0,0.31],[0.5,0.31],[0.5,0.6],[0,0.6]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 },"
  "    { \"name\": \"b\", \"vertices\": [[0.53,0.312],[1,0.312],[1,0.6],[0.53,0.6]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 },"
  "    { \"name\": \"c\", \"vertices\": "
  "[[1.06,0.35],[1.52,0.35],[1.52,0.5],[1.4,0.6],[1.06,0.6]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" } }";

static QnWindow *
open_text (const char *text)
{
  QnWindow *window = driver_open_window (1280, 800);
  g_autoptr (GError) error = NULL;
  g_autofree char *path = g_build_filename (g_get_tmp_dir (), "quoin-reach.quoin", NULL);
  g_assert_true (g_file_set_contents (path, text, -1, &error));
  g_assert_true (qn_window_open_path (window, path));
  g_assert_cmpint (remove (path), ==, 0);
  driver_settle ();
  return window;
}

static QnWindow *
open_blocks (void)
{
  return open_text (two_blocks);
}

static QnVec2
corner_of (QnWindow *window, const char *name)
{
  QnId id = qn_model_find_block (model_of (window), name);
  g_assert_cmpint (id, !=, QN_NONE);
  QnBox box = QN_BOX_EMPTY;
  const QnVec2 *v = qn_model_block_vertices (model_of (window), id);
  for (QnId k = 0; k < model_of (window)->blocks[id].vertex_count; k++)
    qn_box_add_point (&box, v[k]);
  return box.min;
}

static void
check_corner (QnWindow *window, const char *name, double x, double y)
{
  QnVec2 corner = corner_of (window, name);
  g_assert_cmpfloat_with_epsilon (corner.x, x, 1e-9);
  g_assert_cmpfloat_with_epsilon (corner.y, y, 1e-9);
}

/* The context menu that is open, or NULL. */
static GtkWidget *
open_menu (QnWindow *window)
{
  return driver_find_widget (GTK_WIDGET (canvas_of (window)), driver_is_menu, NULL);
}

static gboolean
has_action (GMenuModel *menu, const char *action)
{
  for (int i = 0; i < g_menu_model_get_n_items (menu); i++) {
    g_autofree char *its = NULL;
    if (g_menu_model_get_item_attribute (menu, i, G_MENU_ATTRIBUTE_ACTION, "s", &its)
        && g_str_equal (its, action))
      return TRUE;
    static const char *const links[] = { G_MENU_LINK_SECTION, G_MENU_LINK_SUBMENU };
    for (gsize k = 0; k < G_N_ELEMENTS (links); k++) {
      g_autoptr (GMenuModel) below = g_menu_model_get_item_link (menu, i, links[k]);
      if (below != NULL && has_action (below, action))
        return TRUE;
    }
  }
  return FALSE;
}

/* Items tell the keys that do the same: GTK finds those that work everywhere, the others are told by
 * the menu. */
static void
expect_keys_told (GMenuModel *menu)
{
  for (int i = 0; i < g_menu_model_get_n_items (menu); i++) {
    g_autofree char *action = NULL, *told = NULL;
    g_menu_model_get_item_attribute (menu, i, G_MENU_ATTRIBUTE_ACTION, "s", &action);
    g_menu_model_get_item_attribute (menu, i, "accel", "s", &told);
    const QnActionRow *row = action != NULL ? qn_action_find (action) : NULL;
    if (row != NULL && row->reach == QN_REACH_NO_ENTRY) {
      g_auto (GStrv) keys = g_strsplit (row->keys, " ", -1);
      g_assert_cmpstr (told, ==, keys[0]);
    }
    static const char *const links[] = { G_MENU_LINK_SECTION, G_MENU_LINK_SUBMENU };
    for (gsize k = 0; k < G_N_ELEMENTS (links); k++) {
      g_autoptr (GMenuModel) below = g_menu_model_get_item_link (menu, i, links[k]);
      if (below != NULL)
        expect_keys_told (below);
    }
  }
}

static gboolean
is_scroller (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_SCROLLED_WINDOW (widget);
}

/* All of the menu is in sight. */
static void
expect_whole (GtkWidget *menu)
{
  GtkWidget *scroller = driver_find_widget (menu, is_scroller, NULL);
  GtkAdjustment *down =
    gtk_scrolled_window_get_vadjustment (GTK_SCROLLED_WINDOW (scroller));
  g_assert_cmpfloat (gtk_adjustment_get_page_size (down), >=,
                     gtk_adjustment_get_upper (down));
}

/* Opens the menu there, checks what it offers, and closes it. */
static void
check_menu (QnWindow *window, double x, double y, const char *action, const char *shot)
{
  driver_point (window, x, y);
  driver_press_button ("3");
  GtkWidget *menu = open_menu (window);
  g_assert_nonnull (menu);
  g_assert_true (
    has_action (gtk_popover_menu_get_menu_model (GTK_POPOVER_MENU (menu)), action));
  expect_whole (menu);
  expect_keys_told (gtk_popover_menu_get_menu_model (GTK_POPOVER_MENU (menu)));
  driver_screenshot (menu, shot);
  driver_key ("Escape");
  g_assert_null (open_menu (window));
}

/* On a block, a joint, a load and the paper, by the right button; by both keys for the selection. */
static void
test_context_menus (void)
{
  QnWindow *window = open_blocks ();
  check_menu (window, 4.3, 0.3, "win.support", "menu-block");
  g_assert_true (qn_selection_has (selection_of (window), QN_PICK_BLOCK, 2));
  check_menu (window, 1.0, 1.0, "win.joint-law", "menu-joint");
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_FACE), ==, 0);
  check_menu (window, 3.0, 0.6, "win.paste", "menu-paper");
  g_assert_true (qn_selection_is_empty (selection_of (window)));
  driver_click (window, 4.3, 0.3);
  static const char *const keys[] = { "Menu", "shift+F10" };
  for (gsize i = 0; i < G_N_ELEMENTS (keys); i++) {
    driver_key (keys[i]);
    driver_settle ();
    g_assert_nonnull (open_menu (window));
    driver_key ("Escape");
    g_assert_true (qn_selection_has (selection_of (window), QN_PICK_BLOCK, 2));
  }
  qn_selection_set_one (selection_of (window), QN_PICK_LIVE_LOAD, 0);
  driver_activate (window, "win.delete");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 0);
  driver_activate (window, "win.undo");
  qn_selection_set (selection_of (window), QN_PICK_BLOCK, (QnId[]){ 2 }, 1);
  driver_activate (window, "win.support::pinned");
  g_assert_false (model_of (window)->blocks[2].support[QN_DOF_RZ]);
  driver_discard (window);
}

/* A press that something takes from the drawing ends where it was: no block follows the pointer with the
 * button up. */
static void
test_lost_release (void)
{
  QnWindow *window = open_blocks ();
  QnCanvas *canvas = canvas_of (window);
  g_autoptr (GListModel) controllers =
    gtk_widget_observe_controllers (GTK_WIDGET (canvas));
  driver_point (window, 4.3, 0.3);
  driver_hold_button (TRUE);
  g_assert_true (canvas->in_gesture);
  for (guint i = 0; i < g_list_model_get_n_items (controllers); i++) {
    g_autoptr (GtkEventController) each = g_list_model_get_item (controllers, i);
    if (GTK_IS_GESTURE (each))
      gtk_event_controller_reset (each);
  }
  driver_hold_button (FALSE);
  driver_point (window, 4.6, 0.5);
  driver_point (window, 5.6, 1.5);
  g_assert_false (canvas->in_gesture);
  g_assert_true (qn_selection_has (selection_of (window), QN_PICK_BLOCK, 2));
  check_corner (window, "other", 4.0, 0.0);
  driver_discard (window);
}

/* "right; up" with the button up, and held; sums are worked out. */
static void
test_typed_moves (void)
{
  QnWindow *window = open_blocks ();
  driver_click (window, 4.3, 0.3);
  driver_type ("0.4*3+0.01; 1/2");
  driver_key ("Return");
  check_corner (window, "other", 5.21, 0.5);
  driver_activate (window, "win.undo");
  driver_activate (window, "win.rotate(90.0)");
  driver_activate (window, "win.undo");
  /* The rotate tool turns about the middle when an angle is typed at once. */
  driver_activate (window, "win.tool::rotate");
  driver_type ("90");
  driver_key ("Return");
  check_corner (window, "other", 4.0, 0.0);
  g_assert_true (qn_window_get_document (window)->history->position > 0);
  driver_discard (window);
}

static gboolean
is_entry_called (GtkWidget *widget, gconstpointer name)
{
  return QN_IS_QUANTITY_ENTRY (widget) && gtk_widget_get_mapped (widget)
         && g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), name)
              == 0;
}

static void
enter (QnWindow *window, const char *id, const char *text)
{
  GtkWidget *entry = driver_find_widget (GTK_WIDGET (window), is_entry_called, id);
  g_assert_nonnull (entry);
  gtk_editable_set_text (GTK_EDITABLE (entry), text);
  g_signal_emit_by_name (entry, "activate");
  driver_settle ();
}

/* Place and size in the panel, for one and for several. */
static void
test_numbers_panel (void)
{
  QnWindow *window = open_blocks ();
  driver_click (window, 4.3, 0.3);
  enter (window, "x", "3+0.25");
  enter (window, "width", "0.4*3+0.01");
  check_corner (window, "other", 3.25, 0.0);
  QnId id = qn_model_find_block (model_of (window), "other");
  g_assert_cmpfloat_with_epsilon (model_of (window)->blocks[id].area, 1.21, 1e-9);
  driver_screenshot (GTK_WIDGET (window), "numbers-one");
  driver_activate (window, "win.select-all");
  enter (window, "x", "1");
  check_corner (window, "base", 1.0, 0.0);
  check_corner (window, "other", 4.25, 0.0);
  driver_screenshot (GTK_WIDGET (window), "numbers-several");
  /* Several have no angle of their own. */
  g_assert_null (driver_find_widget (GTK_WIDGET (window), is_entry_called, "angle"));
  QnVec2 was = corner_of (window, "base");
  enter (window, "turn", "180");
  g_assert_cmpfloat (corner_of (window, "base").x, >, was.x + 1.0);
  enter (window, "turn", "180");
  check_corner (window, "base", was.x, was.y);
  driver_discard (window);
}

static gboolean
is_widget_called (GtkWidget *widget, gconstpointer name)
{
  return GTK_IS_BUILDABLE (widget)
         && g_strcmp0 (gtk_buildable_get_buildable_id (GTK_BUILDABLE (widget)), name)
              == 0;
}

static const char *
shown_in (QnWindow *window, const char *id)
{
  GtkWidget *entry = driver_find_widget (GTK_WIDGET (window), is_entry_called, id);
  return gtk_editable_get_text (GTK_EDITABLE (entry));
}

/* What is not the same for all selected blocks is no number of theirs; a number that is entered holds
 * for all, in one step. A support that is changed in one direction stays in the others. */
static void
test_various_values (void)
{
  QnWindow *window = open_blocks ();
  qn_selection_set (selection_of (window), QN_PICK_BLOCK, (QnId[]){ 2 }, 1);
  driver_settle ();
  enter (window, "thickness", "0.5");
  driver_activate (window, "win.support::pinned");
  qn_selection_set (selection_of (window), QN_PICK_BLOCK, (QnId[]){ 1, 2 }, 2);
  driver_screenshot (GTK_WIDGET (window), "numbers-various");
  g_assert_cmpstr (shown_in (window, "thickness"), ==, "");
  g_assert_cmpstr (shown_in (window, "weight"), !=, "");
  enter (window, "thickness", "1 m"); /* that of the first one */
  const QnBlock *blocks = model_of (window)->blocks;
  g_assert_cmpfloat (blocks[2].thickness, ==, 1.0);
  g_assert_cmpstr (shown_in (window, "thickness"), !=, "");
  driver_activate (window, "win.undo");
  g_assert_cmpfloat (model_of (window)->blocks[2].thickness, ==, 0.5);

  GtkWidget *turn =
    driver_find_widget (GTK_WIDGET (window), is_widget_called, "support_turn");
  gtk_check_button_set_active (GTK_CHECK_BUTTON (turn), TRUE);
  driver_settle ();
  blocks = model_of (window)->blocks;
  g_assert_true (blocks[1].support[QN_DOF_RZ] && blocks[2].support[QN_DOF_RZ]);
  g_assert_false (blocks[1].support[QN_DOF_UX]);
  g_assert_true (blocks[2].support[QN_DOF_UX]);
  driver_discard (window);
}

/* A typical stone gives its unit weight and tells the source; the joints keep their laws. */
static void
test_typical_stone (void)
{
  QnWindow *window = open_blocks ();
  qn_selection_set (selection_of (window), QN_PICK_BLOCK, (QnId[]){ 1, 2 }, 2);
  driver_settle ();
  GtkWidget *stone = driver_find_widget (GTK_WIDGET (window), is_widget_called, "stone");
  GtkWidget *source =
    driver_find_widget (GTK_WIDGET (window), is_widget_called, "stone_source");
  g_assert_false (gtk_widget_get_visible (source));
  gtk_drop_down_set_selected (GTK_DROP_DOWN (stone), 0);
  driver_screenshot (GTK_WIDGET (window), "typical-stone");
  const QnModel *model = model_of (window);
  for (int i = 1; i <= 2; i++)
    g_assert_cmpfloat (model->blocks[i].unit_weight, ==,
                       qn_typical_stones[0].unit_weight);
  g_assert_cmpfloat (model->blocks[0].unit_weight, ==, 1e4);
  g_assert_cmpstr (gtk_label_get_text (GTK_LABEL (source)), ==,
                   qn_typical_stones[0].source);
  g_assert_true (gtk_widget_get_visible (source));
  driver_activate (window, "win.undo");
  g_assert_cmpfloat (model_of (window)->blocks[1].unit_weight, ==, 1e4);
  g_assert_false (gtk_widget_get_visible (source));
  driver_discard (window);
}

/* A block that gets another name stays selected. */
static gboolean
rename_other (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_rename_block (model, 2, data, error);
}

static void
test_renamed_stays_selected (void)
{
  QnWindow *window = open_blocks ();
  driver_click (window, 4.3, 0.3);
  g_assert_true (edit_model (qn_window_get_document (window), "Rename", NULL,
                             rename_other, "pier", NULL));
  g_assert_true (qn_selection_has (selection_of (window), QN_PICK_BLOCK, 2));
  driver_discard (window);
}

static gboolean
is_label_beginning (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_LABEL (widget)
         && g_str_has_prefix (gtk_label_get_text (GTK_LABEL (widget)), text);
}

/* Gaps are marked and counted up to the width that is typed, and closed in one step that undo gives
 * back. */
static void
test_gaps (void)
{
  QnWindow *window = open_text (traced_blocks);
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.show-panel::findings");
  const char *const counted[] = { "3 joints of mortar, 10 to 30 mm",
                                  "5 joints of mortar, 10 to 60 mm",
                                  "2 joints of mortar, 10 to 12 mm" };
  const char *const widths[] = { "40 mm", "70 mm", "15 mm" };
  for (gsize i = 0; i < G_N_ELEMENTS (widths); i++) {
    enter (window, "gap_width", widths[i]);
    g_assert_nonnull (
      driver_find_widget (GTK_WIDGET (window), is_label_beginning, counted[i]));
  }
  enter (window, "gap_width", "70 mm");
  driver_screenshot (GTK_WIDGET (window), "gaps-marked");
  driver_press (GTK_WIDGET (window), "Close Gaps");
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  g_assert_cmpuint (document->contacts.face_count, ==, 5);
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), is_label_beginning,
                                        "No joints of mortar up to this width."));
  driver_activate (window, "win.undo");
  g_assert_cmpuint (document->contacts.face_count, ==, 0);
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), is_label_beginning, counted[1]));
  driver_discard (window);
}

/* What is pasted lies free of everything and is selected. */
static void
test_paste (void)
{
  QnWindow *window = open_blocks ();
  driver_click (window, 4.3, 0.3);
  driver_key ("ctrl+c");
  for (int i = 0; i < 3; i++) {
    driver_key ("ctrl+v");
    driver_settle ();
    guint count = 0;
    const QnId *ids = qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
    g_assert_cmpuint (count, ==, 1);
    g_assert_cmpuint (model_of (window)->block_count, ==, (guint) (4 + i));
    g_assert_cmpint (ids[0], ==, 3 + i);
  }
  const QnContacts *contacts = &qn_window_get_document (window)->contacts;
  for (gsize i = 0; i < contacts->findings.count; i++)
    g_assert_cmpint (contacts->findings.items[i].problem, !=, QN_PROBLEM_BLOCKS_OVERLAP);
  driver_discard (window);
}

/* A stone that is dragged out of its wall dissolves it: the step says so, and undo gives it back. */
static void
test_dissolving_is_named (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_lay_large_wall (window);
  QnDocument *document = qn_window_get_document (window);
  QnId id = (QnId) model_of (window)->block_count - 1;
  QnCanvasDraft draft;
  g_assert_true (qn_canvas_begin_edit (canvas_of (window), &draft));
  g_assert_true (qn_canvas_end_edit (
    canvas_of (window), &draft, "Move", NULL,
    qn_edit_transform_blocks (draft.model, (QnBlockSet){ &id, 1 },
                              qn_transform_translation (3.0, 0.0), &draft.error)));
  g_assert_cmpstr (driver_last_step (window), ==, "Move, Wall to Free Blocks");
  g_assert_true (qn_document_undo (document));
  g_assert_cmpint (model_of (window)->blocks[id].masonry, !=, QN_NONE);
  driver_discard (window);
}

/* After a click on a button the keys of tools and shortcuts work as before. */
static gboolean
is_fit_button (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_BUTTON (widget)
         && g_strcmp0 (gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)),
                       "win.fit")
              == 0;
}

static void
test_keys_after_buttons (void)
{
  QnWindow *window = open_blocks ();
  GtkWidget *button = driver_find_widget (GTK_WIDGET (window), is_fit_button, NULL);
  driver_point_at (button, 0.5 * gtk_widget_get_width (button),
                   0.5 * gtk_widget_get_height (button));
  driver_press_button ("1");
  driver_key ("w");
  g_assert_cmpstr (canvas_of (window)->tool->name, ==, "wall");
  driver_key ("F10");
  driver_key ("Escape");
  driver_key ("v");
  g_assert_cmpstr (canvas_of (window)->tool->name, ==, "select");
  driver_key ("ctrl+a");
  guint count = 0;
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, 3);
  driver_discard (window);
}

/* In a dark window the paper is dark and the ink light. */
static void
test_dark_paper (void)
{
  QnWindow *window = open_blocks ();
  g_object_set (gtk_settings_get_default (), "gtk-application-prefer-dark-theme", TRUE,
                NULL);
  driver_screenshot (GTK_WIDGET (window), "dark");
  cairo_surface_t *picture = driver_picture (GTK_WIDGET (window));
  QnVec2 at = qn_canvas_to_screen (canvas_of (window), qn_vec2 (3.02, 0.62));
  double x, y;
  gtk_widget_translate_coordinates (GTK_WIDGET (canvas_of (window)), GTK_WIDGET (window),
                                    at.x, at.y, &x, &y);
  const guint32 *row =
    (const guint32 *) (gconstpointer) (cairo_image_surface_get_data (picture)
                                       + (gsize) y
                                           * (gsize) cairo_image_surface_get_stride (
                                             picture));
  guint32 pixel = row[(gsize) x];
  g_assert_cmpuint (pixel >> 8 & 0xff, <, 90);
  cairo_surface_destroy (picture);
  g_object_set (gtk_settings_get_default (), "gtk-application-prefer-dark-theme", FALSE,
                NULL);
  driver_discard (window);
}

/* ---- lists ---- */

static gboolean
is_list_box (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LIST_BOX (widget);
}

static gboolean
is_history_button (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_MENU_BUTTON (widget)
         && gtk_menu_button_get_popover (GTK_MENU_BUTTON (widget)) != NULL
         && driver_find_widget (
              GTK_WIDGET (gtk_menu_button_get_popover (GTK_MENU_BUTTON (widget))),
              is_list_box, NULL)
              != NULL;
}

static void
choose_in_menu (GtkWidget *root, const char *action)
{
  GtkWidget *menu = driver_find_widget (root, driver_is_menu, NULL);
  g_assert_nonnull (menu);
  g_assert_true (
    has_action (gtk_popover_menu_get_menu_model (GTK_POPOVER_MENU (menu)), action));
  driver_key ("Home"); /* the first item, wherever the focus is */
  driver_key ("Return");
  g_assert_null (driver_find_widget (root, driver_is_menu, NULL));
}

/* A step of the history by the right button, another by the keys. */
static void
test_history_menu (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = open_blocks ();
  QnDocument *document = qn_window_get_document (window);
  QnEditHistory *history = document->history;
  driver_key ("ctrl+a");
  driver_activate (window, "win.nudge((1.0,0.0))");
  driver_key ("Escape");
  driver_key ("ctrl+a");
  driver_activate (window, "win.nudge((0.0,1.0))");
  guint last = history->position;
  g_assert_cmpuint (last, >=, 2);
  GtkWidget *button = driver_find_widget (GTK_WIDGET (window), is_history_button, NULL);
  g_assert_nonnull (button);
  gtk_menu_button_popup (GTK_MENU_BUTTON (button));
  driver_settle ();
  GtkWidget *list = driver_find_widget (button, is_list_box, NULL);
  g_assert_nonnull (list);
  GtkWidget *row =
    GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), (int) last - 1));
  driver_point_at (row, 20.0, 0.5 * gtk_widget_get_height (row));
  driver_press_button ("3");
  choose_in_menu (list, "win.go-to-step");
  g_assert_cmpuint (history->position, ==, last - 1);
  gtk_menu_button_popup (GTK_MENU_BUTTON (button));
  driver_settle ();
  gtk_widget_grab_focus (
    GTK_WIDGET (gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), (int) last)));
  driver_key ("Menu");
  choose_in_menu (list, "win.go-to-step");
  g_assert_cmpuint (history->position, ==, last);
  driver_discard (window);
}

/* The choice of runs by the keys: the run that is shown is taken away. */
static gboolean
has_menu_of_runs (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_DROP_DOWN (widget) && gtk_widget_get_mapped (widget)
         && qn_context_menu_open (widget);
}

static void
test_runs_menu (void)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example ("06-arch.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_activate_target (window, "win.show-panel", g_variant_new_string ("result"));
  GtkWidget *runs = driver_find_widget (GTK_WIDGET (window), has_menu_of_runs, NULL);
  g_assert_nonnull (runs);
  driver_settle ();
  GtkWidget *menu = driver_find_widget (runs, driver_is_menu, NULL);
  g_assert_nonnull (menu);
  g_assert_true (has_action (gtk_popover_menu_get_menu_model (GTK_POPOVER_MENU (menu)),
                             "win.export-result"));
  g_assert_true (has_action (gtk_popover_menu_get_menu_model (GTK_POPOVER_MENU (menu)),
                             "win.remove-run"));
  expect_whole (menu);
  driver_screenshot (menu, "menu-run");
  driver_key ("Escape");
  g_assert_null (driver_find_widget (runs, driver_is_menu, NULL));
  driver_activate (window, "win.remove-run");
  g_assert_cmpuint (document->runs->len, ==, 0);
  driver_discard (window);
}

/* ---- keys wherever the focus is ---- */

static void
collect_focusable (GtkWidget *widget, GPtrArray *found)
{
  if (!gtk_widget_get_mapped (widget) || !gtk_widget_get_sensitive (widget)
      || GTK_IS_POPOVER (widget))
    return;
  if (gtk_widget_get_focusable (widget) && !GTK_IS_EDITABLE (widget))
    g_ptr_array_add (found, widget);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    collect_focusable (child, found);
}

/* A tool's key chooses the tool from every widget that can have the focus but entries. */
static void
test_keys_from_anywhere (void)
{
  static const char *const panels[] = { "properties", "analysis", "result", "findings" };
  QnWindow *window = driver_open_example ("16-load-stages.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  guint tried = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (panels); i++) {
    driver_activate_target (window, "win.show-panel", g_variant_new_string (panels[i]));
    driver_settle ();
    g_autoptr (GPtrArray) found = g_ptr_array_new ();
    collect_focusable (GTK_WIDGET (window), found);
    for (guint k = 0; k < found->len; k += 1 + found->len / 25) {
      GtkWidget *widget = found->pdata[k];
      driver_activate_target (window, "win.tool", g_variant_new_string ("select"));
      if (!gtk_widget_get_mapped (widget) || !gtk_widget_grab_focus (widget)
          || GTK_IS_EDITABLE (gtk_window_get_focus (GTK_WINDOW (window))))
        continue;
      driver_key ("m");
      const char *tool = canvas_of (window)->tool->name;
      if (!g_str_equal (tool, "measure"))
        g_error ("with the focus on a %s the key chose no tool",
                 G_OBJECT_TYPE_NAME (widget));
      tried++;
    }
  }
  g_assert_cmpuint (tried, >, 40);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/reach/context-menus", test_context_menus);
  g_test_add_func ("/app/reach/lost-release", test_lost_release);
  g_test_add_func ("/app/reach/typed-moves", test_typed_moves);
  g_test_add_func ("/app/reach/numbers-panel", test_numbers_panel);
  g_test_add_func ("/app/reach/various-values", test_various_values);
  g_test_add_func ("/app/reach/typical-stone", test_typical_stone);
  g_test_add_func ("/app/reach/renamed", test_renamed_stays_selected);
  g_test_add_func ("/app/reach/gaps", test_gaps);
  g_test_add_func ("/app/reach/paste", test_paste);
  g_test_add_func ("/app/reach/dissolving", test_dissolving_is_named);
  g_test_add_func ("/app/reach/keys-after-buttons", test_keys_after_buttons);
  g_test_add_func ("/app/reach/dark-paper", test_dark_paper);
  g_test_add_func ("/app/reach/keys-from-anywhere", test_keys_from_anywhere);
  g_test_add_func ("/app/reach/history-menu", test_history_menu);
  g_test_add_func ("/app/reach/runs-menu", test_runs_menu);
}
