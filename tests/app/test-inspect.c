/* What the window tells of joints and blocks: under the pointer, after a click in any view, from the
 * rows of tables; and the colours of results, chosen in the window. */
#include "driver.h"

#include "doc/view/inspect.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

/* A wall, solved. */
static QnWindow *
open_solved (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  return window;
}

/* Middle of a joint as the view draws it, and the joint that lies lowest there. */
static QnVec2
middle_of (QnWindow *window, QnId face)
{
  const QnContactFace *f = &qn_window_get_document (window)->contacts.faces[face];
  return qn_vec2_lerp (f->start, f->end, 0.5);
}

/* A bed joint of the right pier, pressed. */
static QnId
pressed_joint (QnWindow *window)
{
  const QnRun *run = qn_window_get_document (window)->run;
  QnId found = QN_NONE;
  double most = 0.0;
  for (gsize f = 0; f < run->contacts.face_count; f++) {
    QnJointReading r = qn_joint_reading (&run->contacts, (QnId) f, run->result.pairs);
    gboolean held = run->model.blocks[run->contacts.faces[f].a].support[0];
    if (!held && r.normal < most) {
      most = r.normal;
      found = (QnId) f;
    }
  }
  g_assert_cmpint (found, !=, QN_NONE);
  return found;
}

static gboolean
says (QnWindow *window, const char *text)
{
  return driver_find_widget (GTK_WIDGET (window), driver_says, text) != NULL;
}

static gboolean
is_last_name (GtkWidget *widget, gconstpointer data)
{
  return driver_says (widget, data) && GTK_IS_GRID (gtk_widget_get_parent (widget));
}

/* The diagram of a joint begins below the last of its values. */
static void
assert_apart (QnWindow *window)
{
  GtkWidget *last = driver_find_widget (GTK_WIDGET (window), is_last_name, "Law");
  g_assert_nonnull (last);
  GtkWidget *grid = gtk_widget_get_parent (last);
  GtkWidget *diagram = gtk_widget_get_next_sibling (grid);
  graphene_rect_t values, drawn;
  g_assert_true (GTK_IS_DRAWING_AREA (diagram) && gtk_widget_get_mapped (diagram));
  g_assert_true (gtk_widget_compute_bounds (last, GTK_WIDGET (window), &values));
  g_assert_true (gtk_widget_compute_bounds (diagram, GTK_WIDGET (window), &drawn));
  g_assert_cmpfloat (values.origin.y + values.size.height, <=, drawn.origin.y + 0.5F);
}

/* A click on a joint selects it in the views of the model and of forces, and the panel of results
 * tells its values. */
static void
test_click_joint (void)
{
  static const char *const views[] = { "win.view::forces", "win.view::model",
                                       "win.view::contacts" };
  QnWindow *window = open_solved ();
  QnSelection *selection = qn_window_get_document (window)->selection;
  QnId joint = pressed_joint (window);
  QnVec2 at = middle_of (window, joint);
  driver_activate (window, "win.show-panel::result");
  for (gsize i = 0; i < G_N_ELEMENTS (views); i++) {
    driver_activate (window, views[i]);
    driver_settle ();
    qn_selection_clear (selection);
    driver_click (window, at.x, at.y);
    g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==, joint);
    g_assert_true (says (window, "Eccentricity"));
    g_assert_true (says (window, "Joint "));
    assert_apart (window);
    driver_screenshot (GTK_WIDGET (window), i == 0   ? "inspect-forces"
                                            : i == 1 ? "inspect-model"
                                                     : "inspect-contacts");
  }
  driver_discard (window);
}

/* In the view of contacts a click selects what the pointer tells of: also joints of blocks that are
 * small on the screen. */
static void
test_small_joints (void)
{
  QnWindow *window = driver_open_example ("12-facade.quoin");
  QnSelection *selection = selection_of (window);
  QnCanvas *canvas = canvas_of (window);
  const QnContacts *contacts = &qn_window_get_document (window)->contacts;
  driver_activate (window, "win.view::contacts");
  gsize shortest = 0;
  for (gsize f = 1; f < contacts->face_count; f++)
    if (contacts->faces[f].length < contacts->faces[shortest].length)
      shortest = f;
  QnVec2 at = middle_of (window, (QnId) shortest);
  QnVec2 s = qn_canvas_to_screen (canvas, at);
  s = qn_vec2 (round (s.x), round (s.y)); /* the pointer is on whole pixels */
  QnId told = qn_canvas_pick_joint (canvas, s);
  g_assert_cmpint (told, !=, QN_NONE);
  driver_point_at (GTK_WIDGET (canvas), s.x, s.y);
  driver_press_button ("1");
  g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==, told);
  driver_discard (window);
}

static gboolean
has_card (QnWindow *window)
{
  QnBox card = card_of (canvas_of (window));
  return card.max.x > card.min.x;
}

/* What the pointer rests on is told once it has moved there, not because a result has come; and beside the
 * buttons that lie over the drawing. */
static void
test_card (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall3.quoin");
  QnCanvas *canvas = canvas_of (window);
  QnVec2 at = model_of (window)->blocks[model_of (window)->block_count / 2].centroid;
  driver_point (window, at.x, at.y);
  driver_key ("F5");
  driver_wait_for_job (window);
  g_assert_cmpint (state_of (window)->options.view, ==, QN_VIEW_MECHANISM);
  g_assert_false (has_card (window));
  driver_point (window, at.x + 0.02, at.y);
  g_assert_true (has_card (window));
  driver_activate (window, "win.view::forces");
  g_assert_false (has_card (window));

  /* Over the lower right corner, where the buttons are. */
  GtkWidget *buttons = driver_find_id (GTK_WIDGET (window), "view_box");
  graphene_rect_t covered;
  g_assert_true (gtk_widget_compute_bounds (buttons, GTK_WIDGET (canvas), &covered));
  QnVec2 screen = qn_canvas_to_screen (canvas, at);
  /* The drawing is moved until a block is there. */
  QnVec2 wanted = qn_vec2 (covered.origin.x - 60, covered.origin.y - 30);
  const char *const down[] = { "mousedown", "2", NULL }, *const up[] = { "mouseup", "2",
                                                                         NULL };
  driver_point_at (GTK_WIDGET (canvas), screen.x, screen.y);
  driver_xdotool (down);
  driver_point_at (GTK_WIDGET (canvas), wanted.x, wanted.y);
  driver_xdotool (up);
  driver_point_at (GTK_WIDGET (canvas), wanted.x + 2, wanted.y + 2);
  g_assert_true (has_card (window));
  QnBox card = card_of (canvas);
  driver_screenshot (GTK_WIDGET (window), "inspect-card");
  g_assert_true (card.max.x <= covered.origin.x || card.max.y <= covered.origin.y);
  driver_discard (window);
}

/* In the view of the model a drag that begins at a joint moves the block that lies there. */
static void
test_drag_beside_joint (void)
{
  QnWindow *window = open_solved ();
  QnDocument *document = qn_window_get_document (window);
  QnVec2 at = middle_of (window, pressed_joint (window));
  guint count = 0;
  driver_activate (window, "win.view::model");
  driver_drag (window, at.x, at.y, at.x + 0.5, at.y);
  g_assert_cmpint (qn_selection_get_one (document->selection, QN_PICK_FACE), ==, QN_NONE);
  qn_selection_get (document->selection, QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, 1);
  g_assert_true (document->history->position > 0);
  driver_discard (window);
}

/* A row of the table of contacts selects its joint, and keeps its place. */
static gboolean
is_contact_table (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return GTK_IS_COLUMN_VIEW (widget)
         && g_list_model_get_n_items (
              gtk_column_view_get_columns (GTK_COLUMN_VIEW (widget)))
              == 4;
}

static gboolean
is_contact_expander (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return driver_is_expander (widget, "_Contacts at the end");
}

/* Where a widget is in its window. */
static double
top_of (GtkWidget *widget, QnWindow *window)
{
  double y = NAN;
  gtk_widget_translate_coordinates (widget, GTK_WIDGET (window), 0.0, 0.0, NULL, &y);
  return y;
}

static void
test_table_row (void)
{
  QnWindow *window = open_solved ();
  const QnRun *run = qn_window_get_document (window)->run;
  QnSelection *selection = qn_window_get_document (window)->selection;
  driver_activate (window, "win.show-panel::result");
  GtkWidget *expander =
    driver_find_widget (GTK_WIDGET (window), is_contact_expander, NULL);
  g_assert_nonnull (expander);
  gtk_expander_set_expanded (GTK_EXPANDER (expander), TRUE);
  driver_settle ();
  GtkWidget *table = driver_find_widget (GTK_WIDGET (window), is_contact_table, NULL);
  g_assert_nonnull (table);
  const guint row = 41;
  double before = top_of (table, window);
  gtk_single_selection_set_selected (
    GTK_SINGLE_SELECTION (gtk_column_view_get_model (GTK_COLUMN_VIEW (table))), row);
  driver_settle ();
  g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==,
                   run->contacts.pairs[row].face);
  /* The values of the joint come in above; the next row is still under the pointer. */
  g_assert_cmpfloat (fabs (top_of (table, window) - before), <, 2.0);
  driver_screenshot (GTK_WIDGET (window), "inspect-row");
  driver_discard (window);
}

/* The text with one part replaced, which must be there; frees the old one. */
static char *
replace (char *text, const char *part, const char *by)
{
  g_assert_nonnull (strstr (text, part));
  g_auto (GStrv) parts = g_strsplit (text, part, 2);
  g_free (text);
  return g_strjoinv (by, parts);
}

/* A block that has fallen lies on contacts found on the way: they have rows below the pairs, which
 * say what it weighs, and a row leads to its corner. */
static void
test_found_rows (void)
{
  g_autofree char *example = driver_example_path ("40-rocking-in-time.quoin");
  char *text = NULL;
  g_assert_true (g_file_get_contents (example, &text, NULL, NULL));
  text = replace (text, "[-0.049757, 0.008652, 0.0986978]", "[0.25, -0.02, -0.35]");
  text = replace (text, "[0.5, -0.2], [0.5, 0]", "[3, -0.2], [3, 0]");
  text = replace (text, "\"mass\": 0", "\"mass\": 2");
  text = replace (text, "\"rho\": 0.8",
                  "\"rho\": 0.8, \"contacts\": \"follow\", \"fall\": true");
  g_autofree char *path =
    g_build_filename (g_get_tmp_dir (), "quoin-test-found.quoin", NULL);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  g_free (text);
  QnWindow *window = driver_open_window (1280, 800);
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  const QnRun *run = qn_window_get_document (window)->run;
  gsize count;
  const QnFoundForce *found =
    qn_step_found (&run->result, run->result.step_count - 1, &count);
  g_assert_cmpuint (count, >, 0);
  double carried = 0.0;
  for (gsize i = 0; i < count; i++)
    carried -= found[i].normal;
  double weight = run->model.blocks[1].weight;
  g_assert_cmpfloat_with_epsilon (carried, weight, 0.05 * weight);

  driver_activate (window, "win.show-panel::result");
  GtkWidget *expander =
    driver_find_widget (GTK_WIDGET (window), is_contact_expander, NULL);
  gtk_expander_set_expanded (GTK_EXPANDER (expander), TRUE);
  driver_settle ();
  GtkWidget *table = driver_find_widget (GTK_WIDGET (window), is_contact_table, NULL);
  GtkSelectionModel *rows = gtk_column_view_get_model (GTK_COLUMN_VIEW (table));
  g_assert_cmpuint (g_list_model_get_n_items (G_LIST_MODEL (rows)), ==,
                    run->result.pair_count + count);
  gtk_single_selection_set_selected (GTK_SINGLE_SELECTION (rows),
                                     (guint) run->result.pair_count);
  driver_screenshot (GTK_WIDGET (window), "inspect-found");
  driver_discard (window);
  g_unlink (path);
}

/* After an edit the result is of another model: its blocks are known by name alone. */
static gboolean
edit_delete_first (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const QnId first = (QnId) model->block_count - 1;
  return qn_edit_delete_blocks (model, (QnBlockSet){ &first, 1 }, error);
}

static void
test_stale_result (void)
{
  QnWindow *window = open_solved ();
  QnDocument *document = qn_window_get_document (window);
  QnSelection *selection = document->selection;
  QnId joint = pressed_joint (window);
  QnVec2 at = middle_of (window, joint);
  driver_activate (window, "win.view::forces");
  g_assert_true (edit_model (document, "Delete", NULL, edit_delete_first, NULL, NULL));
  driver_settle ();
  driver_click (window, at.x, at.y);
  g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==, QN_NONE);
  g_assert_false (says (window, "Eccentricity"));
  driver_discard (window);
}

/* Colours are chosen where the results are, and leave with them; loads are shown there when they
 * are asked for. */
static void
test_fields_and_loads (void)
{
  QnWindow *window = open_solved ();
  QnViewState *state = state_of (window);
  driver_activate (window, "win.view::model");
  g_assert_true (qn_view_state_get_options (state).loads);
  driver_activate (window, "win.view::deformed");
  g_assert_false (qn_view_state_get_options (state).loads);
  driver_activate (window, "win.field::stress");
  g_assert_cmpint (qn_view_state_get_options (state).field, ==, QN_FIELD_STRESS);
  driver_screenshot (GTK_WIDGET (window), "field-stress");
  driver_activate (window, "win.view::mechanism");
  driver_activate (window, "win.field::displacement");
  g_assert_cmpint (qn_view_state_get_options (state).field, ==, QN_FIELD_DISPLACEMENT);
  driver_activate (window, "win.loads");
  g_assert_true (qn_view_state_get_options (state).loads);
  driver_activate (window, "win.view::model");
  g_assert_cmpint (qn_view_state_get_options (state).field, ==, QN_FIELD_NONE);
  driver_activate (window, "win.loads");
  g_assert_false (qn_view_state_get_options (state).loads);
  driver_activate (window, "win.view::forces");
  g_assert_true (qn_view_state_get_options (state).loads);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/inspect/click-joint", test_click_joint);
  g_test_add_func ("/app/inspect/small-joints", test_small_joints);
  g_test_add_func ("/app/inspect/card", test_card);
  g_test_add_func ("/app/inspect/drag-beside-joint", test_drag_beside_joint);
  g_test_add_func ("/app/inspect/table-row", test_table_row);
  g_test_add_func ("/app/inspect/stale-result", test_stale_result);
  g_test_add_func ("/app/inspect/fields-and-loads", test_fields_and_loads);
  g_test_add_func ("/app/inspect/found-rows", test_found_rows);
}
