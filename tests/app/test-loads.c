/* Loads and reinforcing bars in the list and in the drawing: chosen in either, drawn by pointer and by
 * keys, changed, undone. */
#include "driver.h"
#include "support/room.h"

static GtkExpander *
find_expander (QnWindow *window, const char *label)
{
  GtkWidget *found = driver_find_widget (GTK_WIDGET (window), driver_is_expander, label);
  g_assert_nonnull (found);
  return GTK_EXPANDER (found);
}

static QnWindow *
open_panel (const char *example)
{
  driver_pass_over_gtk ();
  QnWindow *window = driver_open_example (example);
  gtk_window_set_default_size (GTK_WINDOW (window), 1280, 1060);
  driver_activate (window, "win.show-panel::analysis");
  return window;
}

/* Which row of the list of loads is selected; -1: none. */
static int
selected_row (QnWindow *window, const char *box, const char *list)
{
  GtkWidget *rows = driver_find_id (driver_find_id (GTK_WIDGET (window), box), list);
  GtkListBoxRow *row = gtk_list_box_get_selected_row (GTK_LIST_BOX (rows));
  return row != NULL ? gtk_list_box_row_get_index (row) : -1;
}

/* A load is chosen in the drawing and marked in the list, and the other way round; copied, moved,
 * removed with the keys of the drawing, and all of it undone by name. */
static void
test_both_ways (void)
{
  QnWindow *window = open_panel ("27-retaining-wall.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  GtkExpander *expander = find_expander (window, "_Loads");
  g_assert_false (gtk_expander_get_expanded (expander));

  /* An arrow of the soil's pressure on the wall's left side. */
  driver_click (window, -0.25, 0.15);
  g_assert_true (qn_selection_get_one (selection_of (window), QN_PICK_LIVE_LOAD) >= 0);
  driver_settle ();
  g_assert_true (gtk_expander_get_expanded (expander));
  int first = qn_selection_get_one (selection_of (window), QN_PICK_LIVE_LOAD);
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, first);
  driver_screenshot (root, "load-selected");
  driver_activate (window, "win.show-panel::properties");
  g_assert_nonnull (driver_find_widget (
    root, driver_says, "Numbers of loads, bars and ties are under Analysis."));
  driver_open_analysis (window);

  GtkListBox *rows =
    GTK_LIST_BOX (driver_find_id (driver_find_id (root, "loads_card"), "loads"));
  gtk_list_box_select_row (rows, gtk_list_box_get_row_at_index (rows, 1 - first));
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_LIVE_LOAD), ==,
                   1 - first);

  /* The second of two goes up, and stays selected. */
  gtk_list_box_select_row (rows, gtk_list_box_get_row_at_index (rows, 1));
  const double surcharge = model_of (window)->live_loads[1].pressure;
  g_assert_cmpfloat (surcharge, >, 0.0);
  driver_press (root, "Move Up");
  g_assert_cmpfloat (model_of (window)->live_loads[0].pressure, ==, surcharge);
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, 0);
  g_assert_cmpstr (driver_last_step (window), ==, "Move Load");
  driver_press (root, "Move Down");
  g_assert_cmpfloat (model_of (window)->live_loads[1].pressure, ==, surcharge);
  driver_press (root, "Duplicate Load");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 3);
  g_assert_cmpfloat (model_of (window)->live_loads[2].pressure, ==, surcharge);
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, 2);

  /* The drawing's own commands mean the load that is selected. */
  driver_activate (window, "win.delete");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 2);
  g_assert_cmpstr (driver_last_step (window), ==, "Remove Load");
  g_assert_true (qn_selection_is_empty (selection_of (window)));
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, -1);
  qn_selection_set_one (selection_of (window), QN_PICK_LIVE_LOAD, 0);
  driver_activate (window, "win.duplicate");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 3);
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, 1);
  while (qn_document_undo (qn_window_get_document (window)))
    driver_settle ();
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 2);
  g_assert_cmpfloat (model_of (window)->live_loads[1].pressure, ==, surcharge);

  /* An empty list says so. */
  driver_press (root, "Add Set");
  driver_settle ();
  g_assert_true (gtk_widget_get_mapped (
    driver_find_id (driver_find_id (root, "loads_card"), "empty")));
  driver_screenshot (root, "loads-empty");
  driver_discard (window);
}

/* A middle click into a block still means the block, where a load in weights has its arrow. */
static void
test_blocks_first (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  driver_click (window, 0.2, 0.5);
  guint count = 0;
  qn_selection_get (selection_of (window), QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, 1);
  /* So does the right button. */
  const QnModel *model = model_of (window);
  g_assert_cmpint (model->live_loads[0].kind, ==, QN_LOAD_WEIGHT);
  for (QnId block = 1; block <= 2; block++) {
    QnVec2 middle = model->blocks[block].centroid;
    driver_point (window, middle.x, middle.y);
    driver_press_button ("3");
    g_assert_true (qn_selection_has (selection_of (window), QN_PICK_BLOCK, block));
    driver_key ("Escape");
  }
  driver_discard (window);
}

/* A force is drawn with its size and angle beside the arrow; a unit that is none of forces is refused with the
 * reason, and the force that is typed in another one comes. */
static void
test_typed_force (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  gsize before = model_of (window)->live_load_count;
  QnVec2 from = model_of (window)->blocks[3].centroid;
  driver_key ("f");
  driver_point (window, from.x, from.y);
  driver_press_button ("1");
  driver_point (window, from.x + 0.3, from.y);
  driver_screenshot (GTK_WIDGET (window), "force-angle");
  driver_type ("2 kg");
  driver_key ("Return");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, before);
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "“kg” is not a unit"));
  for (int i = 0; i < 2; i++)
    driver_key ("BackSpace");
  driver_type ("kN");
  driver_key ("Return");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, before + 1);
  const QnLoad *load = &model_of (window)->live_loads[before];
  g_assert_cmpfloat_with_epsilon (load->vector.x, 2000.0, 1e-9);
  g_assert_cmpfloat_with_epsilon (load->vector.y, 0.0, 1e-9);
  driver_discard (window);
}

/* Edges are chosen in the drawing: by a click, along several, by keys; for a load that is there. */
static void
test_draw_edge_load (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  const gsize live = model_of (window)->live_load_count;
  driver_activate (window, "win.tool::edge-load");
  driver_point (window, 0.2, 1.01);
  driver_screenshot (root, "edge-load-hover");
  driver_click (window, 0.2, 1.01);
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 1);
  const QnLoad *load = &model_of (window)->live_loads[live];
  g_assert_cmpint (load->kind, ==, QN_LOAD_EDGE);
  g_assert_cmpint (load->block, ==, 5);
  g_assert_cmpint (load->edge, ==, 2);
  g_assert_true (load->normal);
  g_assert_cmpfloat (load->intensity[0], ==, 1e4);
  g_assert_cmpint (selected_row (window, "loads_card", "loads"), ==, (int) live);
  g_assert_cmpstr (driver_last_step (window), ==, "Add Edge Load");
  driver_screenshot (root, "edge-load-drawn");

  /* From the right side over the top. */
  driver_drag (window, 0.41, 0.9, 0.1, 1.01);
  load = &model_of (window)->live_loads[live + 1];
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 2);
  g_assert_cmpint (load->edge, ==, 1);
  g_assert_cmpint (load->edge_count, ==, 2);

  /* Of two edges that lie on each other the one of the block that the pointer is in. */
  driver_click (window, 0.2, 0.395);
  g_assert_cmpint (model_of (window)->live_loads[live + 2].block, ==, 2);
  driver_click (window, 0.2, 0.405);
  g_assert_cmpint (model_of (window)->live_loads[live + 3].block, ==, 3);

  /* The selected load goes to another edge; the tool stays, and the next click is a new load. */
  driver_press (root, "Choose Edges in the Drawing");
  driver_click (window, -0.01, 0.7);
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 4);
  g_assert_cmpint (model_of (window)->live_loads[live + 3].block, ==, 4);
  g_assert_cmpint (model_of (window)->live_loads[live + 3].edge, ==, 3);
  g_assert_cmpstr (driver_last_step (window), ==, "Choose Edges");

  /* Away from all edges nothing is added, and Escape leaves the tool. */
  driver_click (window, 1.2, 0.9);
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 4);

  /* By keys: the pointer is on the edge, Enter takes it. */
  driver_point (window, 0.41, 0.3);
  driver_key ("Left");
  driver_key ("Return");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 5);
  g_assert_cmpint (model_of (window)->live_loads[live + 4].edge, ==, 1);
  driver_key ("Escape");
  g_autoptr (GVariant) tool =
    g_action_group_get_action_state (G_ACTION_GROUP (window), "tool");
  g_assert_cmpstr (g_variant_get_string (tool, NULL), ==, "select");
  while (qn_document_undo (qn_window_get_document (window)))
    driver_settle ();
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live);
  driver_discard (window);
}

/* A bar is drawn by a drag and by two clicks, is selected then, found again by a click on it, copied
 * and removed. */
static void
test_draw_bar (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  driver_activate (window, "win.tool::bar");
  driver_drag (window, 0.2, 0.1, 0.2, 0.9);
  g_assert_cmpuint (model_of (window)->bar_count, ==, 1);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_BAR), ==, 0);
  g_assert_cmpint (selected_row (window, "ties_card", "bars"), ==, 0);
  driver_click (window, 0.3, 0.1);
  driver_click (window, 0.3, 0.9);
  g_assert_cmpuint (model_of (window)->bar_count, ==, 2);
  g_assert_cmpint (selected_row (window, "ties_card", "bars"), ==, 1);
  driver_screenshot (root, "bars-drawn");
  /* Diameters are in mm, whatever lengths are in. */
  GtkWidget *diameter = driver_find_id (root, "diameter");
  g_assert_cmpstr (gtk_editable_get_text (GTK_EDITABLE (diameter)), ==, "16\u00a0mm");
  driver_activate (window, "win.tool::select");
  driver_click (window, 1.3, 0.9);
  g_assert_true (qn_selection_is_empty (selection_of (window)));
  driver_click (window, 0.2, 0.55);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_BAR), ==, 0);
  driver_key ("Delete");
  g_assert_cmpuint (model_of (window)->bar_count, ==, 1);
  driver_click (window, 0.3, 0.55);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_BAR), ==, 0);
  driver_activate (window, "win.duplicate");
  g_assert_cmpuint (model_of (window)->bar_count, ==, 2);
  g_assert_cmpstr (driver_last_step (window), ==, "Duplicate Bar");
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_BAR), ==, 1);
  driver_discard (window);
}

/* Ties drawn by two clicks, to a block and to the ground; numbers, presets, an end that is dragged, copied
 * and removed, each undone. */
static void
test_draw_tie (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  driver_activate (window, "win.tool::tie");
  driver_click (window, 0.2, 0.9);
  driver_click (window, 1.5, 0.9);
  g_assert_cmpuint (model_of (window)->tie_count, ==, 1);
  const QnTie *tie = &model_of (window)->ties[0];
  g_assert_cmpint (tie->ends[0].block, !=, QN_NONE);
  g_assert_cmpint (tie->ends[1].block, ==, QN_NONE);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_TIE), ==, 0);
  g_assert_cmpint (selected_row (window, "ties_card", "ties"), ==, 0);
  driver_screenshot (root, "tie-drawn");
  driver_activate (window, "win.tool::select");
  driver_drag (window, 1.5, 0.9, 1.4, 0.6);
  g_assert_cmpstr (driver_last_step (window), ==, "Move Tie End");
  g_assert_cmpfloat_with_epsilon (model_of (window)->ties[0].ends[1].at.y, 0.6, 0.06);
  driver_activate (window, "win.duplicate");
  g_assert_cmpstr (driver_last_step (window), ==, "Duplicate Tie");
  g_assert_cmpuint (model_of (window)->tie_count, ==, 2);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_TIE), ==, 1);
  driver_activate (window, "win.delete");
  g_assert_cmpuint (model_of (window)->tie_count, ==, 1);
  for (int i = 0; i < 4; i++)
    driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->tie_count, ==, 0);
  driver_discard (window);
}

/* A vehicle comes in place of the sideways weight that a new drawing grows by, and says so; Undo brings the
 * weight back. Beside another growing load nothing goes, and nothing is said. */
static void
test_vehicle_in_place (void)
{
  static const char words[] = "The vehicle takes the place of the sideways weight";
  QnWindow *window = open_panel ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  driver_open_analysis (window);
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 1);
  g_assert_cmpint (model_of (window)->live_loads[0].kind, ==, QN_LOAD_WEIGHT);
  driver_press (root, "Vehicle");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 1);
  g_assert_cmpint (model_of (window)->live_loads[0].kind, ==, QN_LOAD_VEHICLE);
  driver_screenshot (root, "vehicle-in-place");
  g_assert_nonnull (driver_find_widget (root, driver_says, words));
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 1);
  g_assert_cmpint (model_of (window)->live_loads[0].kind, ==, QN_LOAD_WEIGHT);
  driver_discard (window);

  window = open_panel ("27-retaining-wall.quoin");
  root = GTK_WIDGET (window);
  driver_open_analysis (window);
  const gsize live = model_of (window)->live_load_count;
  g_assert_cmpuint (live, >, 1);
  driver_press (root, "Vehicle");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, live + 1);
  g_assert_null (driver_find_widget (root, driver_says, words));
  driver_discard (window);
}

/* A bar crosses a joint, and ends in blocks: one within a block is refused with the reason, and so is to drag the
 * block away that it ends in. */
static void
test_bar_apart (void)
{
  QnWindow *window = open_panel ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  driver_activate (window, "win.tool::bar");
  driver_drag (window, 0.1, 0.45, 0.3, 0.55);
  g_assert_cmpuint (model_of (window)->bar_count, ==, 0);
  g_assert_nonnull (driver_find_widget (root, driver_says, "crosses no contact face"));
  driver_drag (window, 0.32, 0.7, 0.32, 0.9);
  g_assert_cmpuint (model_of (window)->bar_count, ==, 1);
  driver_activate (window, "win.tool::select");
  driver_drag (window, 0.06, 0.94, 1.06, 0.94);
  g_assert_cmpfloat (qn_model_block_box (model_of (window), 5).min.x, ==, 0.0);
  g_assert_nonnull (driver_find_widget (root, driver_says, "bar ends in no block"));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/loads/draw-tie", test_draw_tie);
  g_test_add_func ("/app/loads/both-ways", test_both_ways);
  g_test_add_func ("/app/loads/blocks-first", test_blocks_first);
  g_test_add_func ("/app/loads/typed-force", test_typed_force);
  g_test_add_func ("/app/loads/draw-edge-load", test_draw_edge_load);
  g_test_add_func ("/app/loads/draw-bar", test_draw_bar);
  g_test_add_func ("/app/loads/bar-apart", test_bar_apart);
  g_test_add_func ("/app/loads/vehicle-in-place", test_vehicle_in_place);
}
