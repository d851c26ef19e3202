/* Earthquakes in the window: the history while it is computed, energies, initial motion by hand,
 * capacity against a spectrum. */
#include "driver.h"

#include "app/canvas/canvas-private.h"
#include "app/views/curve-view.h"

#include <math.h>
#include <string.h>

static gboolean
has_name (GtkWidget *widget, gconstpointer name)
{
  return strcmp (gtk_widget_get_name (widget), name) == 0;
}

static gboolean
has_label (GtkWidget *widget, gconstpointer text)
{
  return GTK_IS_LABEL (widget) && gtk_widget_get_mapped (widget)
         && strstr (gtk_label_get_text (GTK_LABEL (widget)), text) != NULL;
}

static gboolean
is_curve (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return QN_IS_CURVE_VIEW (widget);
}

/* ---- while it runs ---- */

static gboolean
take_long (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->analysis.dynamic.duration = 5000;
  return TRUE;
}

static gboolean
has_live_history (gpointer window)
{
  gsize count = 0;
  QnJob *job = qn_document_get_job (qn_window_get_document (window));
  return job != NULL && qn_job_get_curve (job, &count)[0].x >= 0.0 && count >= 3
         && driver_find_widget (window, has_label, " of 5000 s") != NULL
         && driver_find_widget (window, has_label, " left") != NULL;
}

/* The history grows over the whole time of the analysis; what has come so far is told with the time
 * that is left. */
static void
test_live_history (void)
{
  QnWindow *window = driver_open_example ("43-shaken-wall.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_assert_true (qn_document_edit (document, "Longer", NULL, take_long, NULL, NULL));
  driver_activate (window, "win.show-panel::result");
  driver_activate (window, "win.run");
  driver_wait (has_live_history, window);
  GtkWidget *curve = driver_find_widget (GTK_WIDGET (window), is_curve, NULL);
  QnVec2 low, high;
  qn_curve_view_get_range (QN_CURVE_VIEW (curve), &low, &high);
  g_assert_cmpfloat (low.x, ==, 0.0);
  g_assert_cmpfloat (high.x, ==, 5000.0);
  driver_screenshot (GTK_WIDGET (window), "live-history");
  driver_activate (window, "win.cancel");
  driver_wait_for_job (window);
  const QnRun *run = qn_document_get_run (document);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_CANCELLED);
  driver_discard (window);
}

/* ---- energies ---- */

static int
step_of (QnWindow *window)
{
  return qn_view_state_get_step (qn_window_get_view_state (window));
}

static double
time_of (QnWindow *window)
{
  const QnRun *run = qn_document_get_run (qn_window_get_document (window));
  return run->result.steps[step_of (window)].time;
}

/* The plot leads to the time that is clicked, the arrow keys go on; values are told. */
static void
test_energies (void)
{
  QnWindow *window = driver_open_example ("41-column-impulse.quoin");
  driver_activate (window, "win.show-panel::result");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  driver_run (300);
  GtkWidget *plot = driver_find_widget (GTK_WIDGET (window), has_name, "energy-plot");
  g_assert_true (gtk_widget_get_mapped (plot));
  double width = gtk_widget_get_width (plot);
  driver_point_at (plot, 0.6 * width, 40);
  driver_press_button ("1");
  driver_run (200);
  double clicked = time_of (window);
  g_assert_cmpfloat (clicked, >, 2.0);
  g_assert_cmpfloat (clicked, <, 6.0);
  int step = step_of (window);
  driver_key ("Right");
  driver_run (200);
  g_assert_cmpint (step_of (window), ==, step + 1);
  const char *const kinds[] = { "input",   "kinetic",   "elastic", "friction",
                                "damping", "numerical", "error" };
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *text = g_strdup_printf ("%s: ", kinds[i]);
    g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), has_label, text));
  }
  driver_screenshot (GTK_WIDGET (window), "energies");

  /* Values under the pointer, elsewhere than at the step. */
  g_autofree char *before = g_strdup (gtk_label_get_text (
    GTK_LABEL (driver_find_widget (GTK_WIDGET (window), has_label, "kinetic: "))));
  driver_point_at (plot, 0.3 * width, 60);
  driver_run (200);
  g_assert_null (driver_find_widget (GTK_WIDGET (window), has_label, before));
  driver_discard (window);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  gtk_init ();
  g_test_add_func ("/app/earthquakes/live-history", test_live_history);
  g_test_add_func ("/app/earthquakes/energies", test_energies);
  return g_test_run ();
}
