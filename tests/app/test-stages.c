/* Stages and settlements in the window: made in the panel, solved, and looked at one by one. */
#include "driver.h"

#include "app/widgets/quantity-entry.h"
#include "support/room.h"

static void
open_expander (GtkWidget *root, const char *label)
{
  GtkWidget *expander = driver_find_widget (root, driver_is_expander, label);
  g_assert_nonnull (expander);
  gtk_expander_set_expanded (GTK_EXPANDER (expander), TRUE);
  driver_settle ();
}

static gboolean
is_set (GtkWidget *widget, gconstpointer name)
{
  return GTK_IS_CHECK_BUTTON (widget) && gtk_widget_get_mapped (widget)
         && g_strcmp0 (gtk_check_button_get_label (GTK_CHECK_BUTTON (widget)), name) == 0;
}

static gboolean
is_list_of_stages (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_LIST_BOX (widget) && gtk_widget_get_mapped (widget)
         && gtk_list_box_get_row_at_index (GTK_LIST_BOX (widget), 1) != NULL;
}

static gboolean
is_stage_choice (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  if (!GTK_IS_DROP_DOWN (widget) || !gtk_widget_get_mapped (widget))
    return FALSE;
  GListModel *names = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
  g_autoptr (GtkStringObject) first =
    names != NULL ? g_list_model_get_item (names, 0) : NULL;
  return first != NULL && g_str_equal (gtk_string_object_get_string (first), "Dead load");
}

/* A wall, its foundation settles, then the loads push it: two sets, two stages. */
static void
test_settle_and_push (void)
{
  QnWindow *window = driver_open_example ("19-settling-wall.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  QnDocument *document = qn_window_get_document (window);
  gtk_window_set_default_size (GTK_WINDOW (window), 1280, 1060);
  driver_open_analysis (window);
  open_expander (root, "_Loads");
  driver_press (root, "Add Set");
  g_assert_cmpuint (model_of (window)->load_set_count, ==, 1);
  driver_press (root, "Weight");
  g_assert_cmpuint (model_of (window)->live_load_count, ==, 2);
  g_assert_cmpint (model_of (window)->live_loads[1].set, ==, 1);
  driver_screenshot (root, "load-form");
  open_expander (root, "Loading in _Stages");
  driver_press (root, "Add Stage");
  driver_press (root, "Add Stage");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 2);
  g_assert_cmpuint (model_of (window)->stages[0].sets, ==, 1);
  g_assert_cmpuint (model_of (window)->stages[1].sets, ==, 2);
  /* The form shows the stage that is selected in the list. */
  GtkWidget *list = driver_find_widget (root, is_list_of_stages, NULL);
  g_assert_nonnull (list);
  gtk_list_box_select_row (GTK_LIST_BOX (list),
                           gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), 0));
  gtk_list_box_select_row (GTK_LIST_BOX (list),
                           gtk_list_box_get_row_at_index (GTK_LIST_BOX (list), 1));
  GtkWidget *loads = driver_find_widget (root, driver_is_expander, "_Loads");
  gtk_expander_set_expanded (GTK_EXPANDER (loads), FALSE);
  gtk_widget_grab_focus (driver_find_widget (root, driver_is_button, "_Earlier"));
  driver_screenshot (root, "stage-form");
  /* A stage that drives nothing is refused, and the check is back. */
  GtkWidget *check = driver_find_widget (root, is_set, "set 1");
  g_assert_nonnull (check);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check), FALSE);
  g_assert_true (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)));
  g_assert_cmpuint (model_of (window)->stages[1].sets, ==, 2);
  driver_press (root, "Earlier");
  g_assert_cmpuint (model_of (window)->stages[0].sets, ==, 2);
  driver_press (root, "Later");
  g_assert_cmpuint (model_of (window)->stages[0].sets, ==, 1);

  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_cmpint (run->result.stage, ==, 2);
  GtkWidget *stage = driver_find_widget (root, is_stage_choice, NULL);
  g_assert_nonnull (stage);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (stage), 1);
  driver_settle ();
  QnViewState *state = state_of (window);
  g_assert_cmpint (state->options.view, ==, QN_VIEW_DEFORMED);
  int step = qn_view_state_get_step (state);
  g_assert_cmpint (run->result.steps[step].stage, ==, 1);
  g_assert_cmpint (run->result.steps[step + 1].stage, ==, 2);
  g_assert_cmpfloat_with_epsilon (run->result.steps[step].multiplier, 1.0, 1e-9);
  open_expander (root, "_Steps");
  driver_screenshot (root, "stage-result");
  /* The choice follows the step. */
  driver_activate (window, "win.next-step");
  g_assert_cmpuint (gtk_drop_down_get_selected (GTK_DROP_DOWN (stage)), ==, 2);

  while (qn_document_undo (document))
    driver_settle ();
  g_assert_cmpuint (model_of (window)->stage_count, ==, 0);
  g_assert_cmpuint (model_of (window)->load_set_count, ==, 0);
  driver_discard (window);
}

/* A wall under soil: a case, a backfill of it, an edge load, a surcharge; all undone again. */
static void
test_edge_loads (void)
{
  QnWindow *window = driver_open_example ("05-stack.quoin");
  GtkWidget *root = GTK_WIDGET (window);
  QnDocument *document = qn_window_get_document (window);
  const gsize dead = model_of (window)->dead_load_count;
  gtk_window_set_default_size (GTK_WINDOW (window), 1280, 1060);
  driver_open_analysis (window);
  open_expander (root, "Load C_ases");
  driver_press (root, "Add Case");
  g_assert_cmpuint (model_of (window)->load_case_count, ==, 1);
  g_assert_cmpfloat (model_of (window)->load_cases[0].factor, ==, 1.0);
  open_expander (root, "_Loads");

  /* Of all blocks that are free where none is selected. */
  driver_press (root, "Backfill");
  g_assert_cmpuint (model_of (window)->dead_load_count, ==, dead + 1);
  const QnLoad *load = &model_of (window)->dead_loads[dead];
  g_assert_cmpint (load->kind, ==, QN_LOAD_BACKFILL);
  g_assert_cmpuint (model_of (window)->edge_force_count, ==, 5);
  driver_press (root, "Surcharge");
  g_assert_cmpint (model_of (window)->dead_loads[dead + 1].kind, ==, QN_LOAD_SURCHARGE);

  /* An edge load needs a block, and is on its top. */
  qn_selection_set (document->selection, QN_PICK_BLOCK, (QnId[]){ 2 }, 1);
  driver_press (root, "Edge Load");
  load = &model_of (window)->dead_loads[dead + 2];
  g_assert_cmpint (load->kind, ==, QN_LOAD_EDGE);
  g_assert_cmpint (load->block, ==, 2);
  size_t source = dead + 2;
  g_assert_cmpfloat (qn_model_load_resultant (model_of (window), source).x, ==, 0.0);
  g_assert_cmpfloat (qn_model_load_resultant (model_of (window), source).y, <, 0.0);
  driver_screenshot (root, "edge-load-form");
  while (qn_document_undo (document))
    driver_settle ();
  g_assert_cmpuint (model_of (window)->dead_load_count, ==, dead);
  g_assert_cmpuint (model_of (window)->load_case_count, ==, 0);
  driver_discard (window);
}

/* Whatever a form shows, its window closes: by its own shortcut, and with the program. */
static void
test_close_with_selected (void)
{
  static const char *const keys[] = { "ctrl+w", "ctrl+q" };
  for (gsize i = 0; i < G_N_ELEMENTS (keys); i++) {
    QnWindow *window = driver_open_example ("16-load-stages.quoin");
    GtkWidget *root = GTK_WIDGET (window);
    gtk_window_set_default_size (GTK_WINDOW (window), 1280, 1060);
    driver_open_analysis (window);
    open_expander (root, "Loading in _Stages");
    open_expander (root, "_Loads");
    GtkListBox *list = GTK_LIST_BOX (driver_find_widget (root, is_list_of_stages, NULL));
    gtk_list_box_select_row (list, gtk_list_box_get_row_at_index (list, 1));
    gtk_widget_grab_focus (GTK_WIDGET (gtk_list_box_get_row_at_index (list, 1)));
    driver_settle ();
    DriverParts *parts = driver_watch_parts (window);
    driver_key (keys[i]);
    driver_wait_until_gone (parts);
  }
}

static gboolean
is_number (GtkWidget *widget, gconstpointer value)
{
  return QN_IS_QUANTITY_ENTRY (widget) && gtk_widget_get_mapped (widget)
         && qn_quantity_entry_get_value (QN_QUANTITY_ENTRY (widget))
              == *(const double *) value;
}

/* A number that is typed when the window is closed counts as a change, which is asked about. */
static void
test_close_while_typing (void)
{
  QnWindow *window = driver_open_example ("16-load-stages.quoin");
  driver_open_analysis (window);
  double increments = model_of (window)->analysis.increments;
  GtkWidget *entry = driver_find_widget (GTK_WIDGET (window), is_number, &increments);
  g_assert_nonnull (entry);
  gtk_widget_grab_focus (entry);
  driver_key ("ctrl+a");
  driver_type ("17");
  driver_key ("ctrl+w");
  g_assert_cmpint (model_of (window)->analysis.increments, ==, 17);
  GtkWidget *question = driver_find_message ();
  g_assert_nonnull (question);
  DriverParts *parts = driver_watch_parts (window);
  driver_press (question, "Discard");
  driver_wait_until_gone (parts);
}

static void
enter (GtkWidget *form, const char *id, const char *text)
{
  GtkWidget *entry = driver_find_id (form, id);
  gtk_editable_set_text (GTK_EDITABLE (entry), text);
  g_signal_emit_by_name (entry, "activate");
  driver_settle ();
}

/* A cyclic protocol is one row of the list, is entered by its amplitudes, and moves as a whole; the result
 * tells every cycle. */
static void
test_cycles (void)
{
  QnWindow *window = driver_open_example ("46-cyclic-panel.quoin");
  QnDocument *document = qn_window_get_document (window);
  GtkWidget *root = GTK_WIDGET (window);
  gtk_window_set_default_size (GTK_WINDOW (window), 1280, 1060);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  open_expander (root, "Stages and c_ycles");
  g_assert_nonnull (driver_find_widget (root, driver_says, "cycle 4: load multiplier"));
  driver_screenshot (root, "cycles-curve");
  driver_open_analysis (window);
  open_expander (root, "Loading in _Stages");
  GtkWidget *form = driver_find_widget (root, driver_is_expander, "Loading in _Stages");
  GtkListBox *list = GTK_LIST_BOX (driver_find_widget (root, is_list_of_stages, NULL));
  for (int i = 0; i < 12; i++)
    g_assert_cmpint (
      gtk_widget_get_visible (GTK_WIDGET (gtk_list_box_get_row_at_index (list, i))), ==,
      i == 0);
  gtk_list_box_select_row (list, gtk_list_box_get_row_at_index (list, 0));
  driver_settle ();
  g_assert_cmpstr (
    gtk_editable_get_text (GTK_EDITABLE (driver_find_id (form, "amplitudes"))), ==,
    "0.5\u00a0mm; 2\u00a0mm");
  enter (form, "amplitudes", "1; 0.3 cm; 4");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 18);
  g_assert_cmpfloat (model_of (window)->stages[7].control.target, ==, -0.003);
  enter (form, "cycles", "1");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 9);
  driver_screenshot (root, "cycles-form");

  /* A stage behind it goes before all of it. */
  driver_press (root, "Add Stage");
  driver_press (root, "Earlier");
  g_assert_cmpint (model_of (window)->stages[0].leg, ==, 0);
  g_assert_cmpint (model_of (window)->stages[9].leg, ==, 9);
  gtk_list_box_select_row (list, gtk_list_box_get_row_at_index (list, 1));
  driver_settle ();
  enter (form, "name", "swing");
  g_assert_cmpstr (model_of (window)->stages[9].name, ==, "swing");
  enter (form, "amplitudes", "0");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 10);
  gtk_widget_grab_focus (GTK_WIDGET (list));
  driver_press (root, "Remove Stage");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 1);
  while (qn_document_undo (document))
    driver_settle ();
  g_assert_cmpint (model_of (window)->stages[11].leg, ==, 12);
  g_assert_cmpfloat (model_of (window)->stages[11 - 1].control.target, ==, -0.002);

  /* Without amplitudes it is a stage like others. */
  gtk_list_box_select_row (list, gtk_list_box_get_row_at_index (list, 0));
  driver_settle ();
  enter (form, "amplitudes", "");
  g_assert_cmpuint (model_of (window)->stage_count, ==, 1);
  g_assert_cmpint (model_of (window)->stages[0].leg, ==, 0);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/stages/settle-and-push", test_settle_and_push);
  g_test_add_func ("/app/stages/cycles", test_cycles);
  g_test_add_func ("/app/stages/edge-loads", test_edge_loads);
  g_test_add_func ("/app/stages/close-with-selected", test_close_with_selected);
  g_test_add_func ("/app/stages/close-while-typing", test_close_while_typing);
}
