/* Beams in the window: drawn, selected, changed in the panel, moved by pointer and keys, undone;
 * their section forces in the drawing, in the panel and in a table. */
#include "driver.h"
#include "support/room.h"

static guint
selected_beams (QnWindow *window)
{
  guint count = 0;
  qn_selection_get (selection_of (window), QN_PICK_BEAM, &count);
  return count;
}

/* Back to nothing and forth again: the same text. */
static void
check_history (QnWindow *window)
{
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *text = g_strdup (document->text->text);
  guint steps = document->history->position;
  for (guint i = 0; i < steps; i++)
    g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (document->project.model.beam_count, ==, 0);
  for (guint i = 0; i < steps; i++)
    g_assert_true (qn_document_redo (document));
  g_assert_cmpstr (document->text->text, ==, text);
}

/* A portal from three drags; the feet are fixed by clicks; it is moved, turned, deleted. */
static void
test_draw (void)
{
  QnWindow *window = driver_open_window (1280, 900);
  driver_activate (window, "win.draw");
  driver_key ("b");
  driver_drag (window, 0.5, 0.5, 0.5, 2.5);
  g_assert_cmpuint (model_of (window)->beam_count, ==, 1);
  g_assert_cmpuint (selected_beams (window), ==, 1);
  driver_drag (window, 0.5, 2.5, 3.5, 2.5);
  driver_drag (window, 3.5, 2.5, 3.5, 0.5);
  g_assert_cmpuint (model_of (window)->beam_count, ==, 3);
  g_assert_cmpuint (model_of (window)->node_count, ==, 4);
  g_assert_cmpuint (model_of (window)->section_count, ==, 1);
  driver_key ("s");
  driver_click (window, 0.5, 0.5);
  driver_click (window, 3.5, 0.5);
  g_assert_true (model_of (window)->nodes[0].support[QN_DOF_RZ]);
  g_assert_true (model_of (window)->nodes[3].support[QN_DOF_UX]);
  driver_key ("f");
  driver_drag (window, 0.5, 2.5, 1.5, 2.5);
  const QnModel *model = model_of (window);
  g_assert_cmpint (model->live_loads[model->live_load_count - 1].kind, ==, QN_LOAD_NODE);

  driver_key ("v");
  driver_click (window, 2.0, 2.5);
  g_assert_cmpuint (selected_beams (window), ==, 1);
  driver_screenshot (GTK_WIDGET (window), "beam-selected");
  /* Its end by the handle, together with the column below. */
  driver_drag (window, 3.5, 2.5, 3.5, 3.0);
  g_assert_cmpstr (driver_last_step (window), ==, "Move Beam End");
  g_assert_cmpfloat_with_epsilon (model_of (window)->nodes[2].at.y, 3.0, 1e-9);
  g_assert_cmpuint (model_of (window)->node_count, ==, 4);

  /* All of it by keys. */
  driver_key ("ctrl+a");
  g_assert_cmpuint (selected_beams (window), ==, 3);
  double before = model_of (window)->nodes[0].at.x;
  driver_key ("Right");
  g_assert_cmpstr (driver_last_step (window), ==, "Move");
  double step = model_of (window)->nodes[0].at.x - before;
  g_assert_cmpfloat (step, >, 0.0);
  g_assert_cmpfloat_with_epsilon (model_of (window)->nodes[2].at.x, 3.5 + step, 1e-9);
  driver_activate (window, "win.duplicate");
  g_assert_cmpuint (model_of (window)->beam_count, ==, 6);
  g_assert_cmpuint (selected_beams (window), ==, 3);
  driver_key ("Delete");
  g_assert_cmpuint (model_of (window)->beam_count, ==, 3);
  check_history (window);
  driver_discard (window);
}

static gboolean
is_check (GtkWidget *widget, gconstpointer label)
{
  return GTK_IS_CHECK_BUTTON (widget) && gtk_widget_get_mapped (widget)
         && g_strcmp0 (gtk_check_button_get_label (GTK_CHECK_BUTTON (widget)), label)
              == 0;
}

/* The form changes the beam and its section. */
static void
test_form (void)
{
  QnWindow *window = driver_open_example ("36-mast-on-block.quoin");
  driver_activate (window, "win.show-panel::properties");
  const QnId first = 0;
  qn_selection_set (selection_of (window), QN_PICK_BEAM, &first, 1);
  driver_settle ();
  GtkWidget *root = GTK_WIDGET (window);
  g_assert_nonnull (driver_find_widget (root, driver_says, "First End"));
  GtkWidget *hinge = driver_find_widget (root, is_check, "Hinge at the se_cond end");
  g_assert_nonnull (hinge);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (hinge), TRUE);
  g_assert_true (model_of (window)->beams[0].hinge[1]);
  g_assert_cmpstr (driver_last_step (window), ==, "Set Hinge");
  driver_key ("ctrl+z");
  g_assert_false (model_of (window)->beams[0].hinge[1]);
  g_assert_cmpuint (selected_beams (window), ==, 1);
  driver_screenshot (root, "beam-form");
  GtkWidget *own = driver_find_widget (root, driver_is_button, "_Section of Their Own");
  g_assert_nonnull (own);
  gtk_widget_grab_focus (own);
  driver_screenshot (root, "section-form");
  driver_press (root, "Section of Their Own");
  g_assert_cmpuint (model_of (window)->section_count, ==, 2);
  driver_press (root, "Remove Unused Sections");
  g_assert_cmpuint (model_of (window)->section_count, ==, 1);
  driver_discard (window);
}

/* M, V and N after a run, and the numbers beside them: in the portal under its force the largest
 * moment is at its corner. */
static void
test_diagrams (void)
{
  QnWindow *window = driver_open_example ("32-frame-beams.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_key ("F5");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_nonnull (run->result.beam_forces);
  driver_key ("ctrl+6");
  QnViewState *state = state_of (window);
  g_assert_cmpint (state->options.view, ==, QN_VIEW_DIAGRAMS);
  driver_screenshot (GTK_WIDGET (window), "diagram-moments");
  driver_activate (window, "win.diagram::V");
  g_assert_cmpint ((int) qn_view_state_get_options (state).diagram, ==, QN_DIAGRAM_SHEAR);
  driver_screenshot (GTK_WIDGET (window), "diagram-shear");
  driver_activate (window, "win.diagram::N");
  g_assert_cmpint ((int) qn_view_state_get_options (state).diagram, ==,
                   QN_DIAGRAM_NORMAL);

  driver_activate (window, "win.view::model");
  driver_activate (window, "win.show-panel::properties");
  const QnId first = 0;
  qn_selection_set (selection_of (window), QN_PICK_BEAM, &first, 1);
  driver_settle ();
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, "M: "));
  driver_screenshot (GTK_WIDGET (window), "beam-forces");
  /* Outdated forces are not shown. */
  driver_key ("Right");
  driver_settle ();
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, "M: "));
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/beams/draw", test_draw);
  g_test_add_func ("/app/beams/form", test_form);
  g_test_add_func ("/app/beams/diagrams", test_diagrams);
}
