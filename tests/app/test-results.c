/* What the window says about results: the curve under the pointer, the factor on displacements, the
 * list of runs. */
#include "driver.h"

#include "app/forms/panel.h"
#include "doc/document/bounds.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

static GtkWidget *
curve_of (QnWindow *window)
{
  GtkWidget *found = driver_find_widget (GTK_WIDGET (window), driver_has_name, "curve");
  g_assert_nonnull (found);
  return found;
}

static double
width_of_range (GtkWidget *curve)
{
  QnBox range = driver_plot_range (curve);
  return range.max.x - range.min.x;
}

static void
solve (QnWindow *window, const char *action)
{
  driver_activate (window, action);
  driver_wait_for_job (window);
}

/* The block slides by less than the dead load has pressed it down: its sliding is shown. */
static void
test_curve_of_sliding (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  solve (window, "win.run");
  const QnRun *run = qn_window_get_document (window)->run;
  const QnResult *result = &run->result;
  const double *last = qn_result_step_displacements (result, result->step_count - 1) + 3;
  g_assert_cmpfloat (fabs (last[QN_DOF_UY]), >, last[QN_DOF_UX]);
  QnBox range = driver_plot_range (curve_of (window));
  g_assert_cmpfloat_with_epsilon (range.min.x, 0.0, 1e-12);
  g_assert_cmpfloat (range.max.x, >=, last[QN_DOF_UX]);
  g_assert_cmpfloat (range.max.x, <, 1.3 * last[QN_DOF_UX]);
  driver_discard (window);
}

/* The answer is told in words of the load, and against what the project asks for. */
static void
test_demand (void)
{
  QnWindow *window = driver_open_example ("01-sliding-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_key ("F5");
  driver_wait_for_job (window);
  GtkWidget *root = GTK_WIDGET (window);
  g_assert_nonnull (
    driver_find_widget (root, driver_says, "Load multiplier at collapse: 0.4 g."));
  g_assert_null (driver_find_widget (root, driver_says, "demand"));
  g_assert_true (qn_document_edit_extra (document, "Demand", NULL, "report",
                                         "{ \"demand\": 0.5 }", NULL));
  driver_settle ();
  g_assert_nonnull (
    driver_find_widget (root, driver_says, "The demand of 0.5 is not met: 0.8 of it."));
  driver_screenshot (root, "demand");
  driver_key ("ctrl+z");
  g_assert_null (driver_find_widget (root, driver_says, "demand"));
  driver_discard (window);
}

/* The axis ends a little beyond the peak although the last motion goes ten times as far; the wheel
 * zooms about the pointer, a double click fits again. */
static void
test_curve (void)
{
  QnWindow *window = driver_open_example ("ferris-tin-loi/wall6.quoin");
  solve (window, "win.run");
  GtkWidget *curve = curve_of (window);
  const QnRun *run = qn_window_get_document (window)->run;
  double farthest = 0.0;
  const double *last =
    qn_result_step_displacements (&run->result, run->result.step_count - 1);
  for (gsize i = 0; i < 3 * run->result.block_count; i++)
    farthest = i % 3 < 2 ? fmax (farthest, fabs (last[i])) : farthest;
  double fitting = width_of_range (curve);
  g_assert_cmpfloat (fitting, <, 0.3 * farthest);

  GtkWidget *widget = curve;
  double x = 0.5 * gtk_widget_get_width (widget);
  double y = 0.4 * gtk_widget_get_height (widget);
  driver_point_at (widget, x, y);
  g_autofree char *told = qn_curve_view_dup_values (curve, x, y);
  driver_screenshot (GTK_WIDGET (window), "curve");
  g_test_message ("%s", told);
  g_assert_nonnull (strstr (told, "m, multiplier 0."));
  driver_press_button ("4"); /* without Ctrl and focus the panel scrolls */
  g_assert_cmpfloat (width_of_range (curve), ==, fitting);
  driver_press_button ("1");
  driver_press_button ("4");
  g_assert_cmpfloat_with_epsilon (width_of_range (curve), fitting / 1.25, 1e-9);
  /* The click has taken the drawing along. */
  g_assert_cmpint (qn_view_state_get_step (state_of (window)), !=, QN_STEP_LAST);
  /* Far into a place where no curve is, nothing is told of points that are out of sight. */
  driver_point_at (widget, x, 0.7 * gtk_widget_get_height (widget));
  for (int i = 0; i < 14; i++)
    driver_press_button ("4");
  g_assert_null (qn_curve_view_dup_values (curve, x, y));
  driver_screenshot (GTK_WIDGET (window), "curve-close");
  driver_key ("0");
  g_assert_cmpfloat_with_epsilon (width_of_range (curve), fitting, 1e-12);
  driver_discard (window);
}

/* The factor is the same at every step, is told, and has a switch to the true scale. */
static void
test_factor (void)
{
  QnWindow *window = driver_open_example ("19-settling-wall.quoin");
  solve (window, "win.run");
  QnViewState *state = state_of (window);
  qn_view_state_set_view (state, QN_VIEW_DEFORMED);
  double fitting = qn_view_state_get_shown_scale (state);
  g_assert_cmpfloat (fitting, >, 1.0);
  driver_screenshot (GTK_WIDGET (window), "factor");
  qn_view_state_set_step (state, 4);
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), ==, fitting);
  driver_press (GTK_WIDGET (window), "1∶1");
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), ==, 1.0);
  driver_screenshot (GTK_WIDGET (window), "true-scale");
  driver_press (GTK_WIDGET (window), "1∶1");
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), ==, fitting);
  driver_discard (window);
}

static gboolean
lists_runs (GtkWidget *widget, gconstpointer window)
{
  if (!GTK_IS_DROP_DOWN (widget))
    return FALSE;
  GListModel *model = gtk_drop_down_get_model (GTK_DROP_DOWN (widget));
  const GPtrArray *runs = qn_window_get_document ((QnWindow *) window)->runs;
  return model != NULL && g_list_model_get_n_items (model) == runs->len
         && g_str_has_prefix (gtk_string_list_get_string (GTK_STRING_LIST (model), 0),
                              ((QnRun *) runs->pdata[0])->name);
}

/* A run that is chosen from the list renews the list while GTK is still working on the choice. */
static void
test_runs (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  QnDocument *document = qn_window_get_document (window);
  solve (window, "win.run");
  solve (window, "win.run-limit::associative");
  GtkWidget *choice = driver_find_widget (GTK_WIDGET (window), lists_runs, window);
  g_assert_nonnull (choice);
  const GPtrArray *runs = document->runs;
  for (guint i = 0; i < runs->len; i++) {
    gtk_drop_down_set_selected (GTK_DROP_DOWN (choice), i);
    driver_settle ();
    g_assert_true (document->run == runs->pdata[i]);
  }
  driver_discard (window);
}

/* One number, with what it means and the mechanism; every value that was found stands behind an expander,
 * with how. */
static void
test_answer (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  QnDocument *document = qn_window_get_document (window);
  solve (window, "win.run");
  solve (window, "win.run-limit::associative");
  solve (window, "win.run-limit::non-associative");
  driver_settle ();
  double bounds[QN_BOUND_KIND_COUNT];
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 5);
  driver_screenshot (GTK_WIDGET (window), "answer");
  g_autofree char *text = qn_bounds_dup_text (bounds);
  g_auto (GStrv) told = g_strsplit (g_strchomp (text), "\n\n", -1);
  g_assert_cmpuint (g_strv_length (told), ==, 5);
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, told[0]));
  driver_unfold (driver_find_id (GTK_WIDGET (window), "card"));
  driver_settle ();
  for (guint i = 0; told[i] != NULL; i++)
    g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, told[i]));
  driver_screenshot (GTK_WIDGET (window), "answer-open");
  driver_discard (window);
}

/* A tie is selected where the mechanism has moved it, and deleted there; one that is drawn nearly level is
 * level, and its end on the edge of the wall. */
static void
test_tie (void)
{
  QnWindow *window = driver_open_example ("47-gable-with-tie.quoin");
  solve (window, "win.run-limit::associative");
  driver_activate (window, "win.view::mechanism");
  driver_click (window, -1.5, 4.9);
  g_assert_cmpint (qn_selection_get_one (selection_of (window), QN_PICK_TIE), ==, 0);
  driver_screenshot (GTK_WIDGET (window), "tie-of-mechanism");
  driver_key ("Delete");
  g_assert_cmpuint (model_of (window)->tie_count, ==, 0);

  driver_activate (window, "win.view::model");
  driver_key ("k");
  driver_drag (window, -1, 2.2, 0, 2.24);
  g_assert_cmpuint (model_of (window)->tie_count, ==, 1);
  const QnTieEnd *ends = model_of (window)->ties[0].ends;
  const QnTieEnd *held = &ends[ends[0].block == QN_NONE];
  g_assert_cmpint (held->block, !=, QN_NONE);
  g_assert_cmpfloat_with_epsilon (held->at.x, 0, 1e-12);
  g_assert_cmpfloat_with_epsilon (ends[0].at.y, ends[1].at.y, 1e-12);
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/results/tie", test_tie);
  g_test_add_func ("/app/results/demand", test_demand);
  g_test_add_func ("/app/results/curve-of-sliding", test_curve_of_sliding);
  g_test_add_func ("/app/results/curve", test_curve);
  g_test_add_func ("/app/results/factor", test_factor);
  g_test_add_func ("/app/results/runs", test_runs);
  g_test_add_func ("/app/results/answer", test_answer);
}
