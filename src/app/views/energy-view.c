#include "app/views/energy-view.h"

#include "app/forms/form.h"
#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/view/energy-plot.h"
#include "render/drawing/color.h"

#include <glib/gi18n.h>
#include <math.h>

#define HEIGHT 180

/* The plot's text over that of the window: the panel is narrow. */
#define TEXT_SHARE 0.825

typedef struct View {
  QnViewState *state;
  GtkWidget *root, *plot;
  GtkLabel *values[QN_ENERGY_CURVES];
  GtkLabel *time;
  QnEnergyPlot energies;
  QnPlotPlace place; /* of what was drawn last */
  double pointer;    /* s; negative: the pointer is elsewhere */
} View;

static const QnRun *
run_of (const View *view)
{
  const QnRun *run = qn_document_get_run (qn_view_state_get_document (view->state));
  return run != NULL && run->result.history.row_count > 1 ? run : NULL;
}

/* Of the step that is shown, s. */
static double
shown_time (const View *view, const QnRun *run)
{
  int step = qn_view_state_get_step (view->state);
  gsize last = run->result.step_count - 1;
  gsize i = step == QN_STEP_LAST ? last : MIN ((gsize) step, last);
  return run->result.steps[i].time;
}

static void
show_values (View *view)
{
  const QnRun *run = run_of (view);
  if (run == NULL || run->result.step_count == 0 || view->energies.count == 0)
    return;
  double time = view->pointer >= 0.0 ? view->pointer : shown_time (view, run);
  gsize i = qn_energy_plot_find (&view->energies, time);
  g_autofree char *at = qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_TIME,
                                              view->energies.times[i], 4);
  g_autofree char *small = g_markup_printf_escaped (_ ("<small>at %s</small>"), at);
  gtk_label_set_markup (view->time, small);
  for (int curve = 0; curve < QN_ENERGY_CURVES; curve++) {
    QnColor c = qn_series_color (qn_energy_series (curve), false);
    double value = view->energies.energies[view->energies.count * (gsize) curve + i];
    g_autofree char *number = qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, value, 4);
    g_autofree char *text = g_markup_printf_escaped (
      "<small><span foreground=\"#%02x%02x%02x\" background=\"white\">%s</span> "
      "%s: %s %s</small>",
      c.r, c.g, c.b, qn_energy_is_dashed (curve) ? "╌" : "━", qn_energy_text (curve),
      number, view->energies.symbol);
    gtk_label_set_markup (view->values[curve], text);
  }
  gtk_widget_queue_draw (view->plot);
}

static void
update (View *view)
{
  const QnRun *run = run_of (view);
  gboolean busy = qn_document_get_job (qn_view_state_get_document (view->state)) != NULL;
  qn_energy_plot_clear (&view->energies);
  view->pointer = -1.0;
  if (run != NULL)
    qn_energy_plot_init (&view->energies, &run->result.history);
  gtk_widget_set_visible (view->root, run != NULL && !busy);
  show_values (view);
}

/* Plots are drawn on paper, in a dark window too. */
static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  View *view = data;
  const QnRun *run = run_of (view);
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  if (run == NULL || run->result.step_count == 0 || view->energies.count == 0)
    return;
  qn_energy_plot_draw (&view->energies, FALSE, cr, width, height,
                       TEXT_SHARE * qn_text_unit (GTK_WIDGET (area)), &view->place);
  double x = view->place.x_zero + view->place.x_scale * shown_time (view, run);
  cairo_set_source_rgb (cr, 0.9, 0.35, 0.0);
  cairo_set_line_width (cr, 1.0);
  cairo_move_to (cr, floor (x) + 0.5, 8.0);
  cairo_line_to (cr, floor (x) + 0.5, view->place.y_zero);
  cairo_stroke (cr);
  if (gtk_widget_has_focus (GTK_WIDGET (area))) {
    cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
    cairo_rectangle (cr, 1.5, 1.5, width - 3.0, height - 3.0);
    cairo_stroke (cr);
  }
}

/* ---- hand ---- */

/* Time at a place of the plot, s. */
static double
time_at (const View *view, double x)
{
  return view->place.x_scale > 0.0
           ? fmax ((x - view->place.x_zero) / view->place.x_scale, 0.0)
           : 0.0;
}

/* The step that is nearest in time. */
static void
go_to (View *view, double x)
{
  const QnRun *run = run_of (view);
  if (run == NULL || !qn_run_is_in_time (run))
    return;
  if (!qn_view_needs_result (qn_view_state_get_view (view->state))
      || qn_view_state_get_view (view->state) == QN_VIEW_MECHANISM)
    qn_view_state_set_view (view->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (view->state, qn_run_step_at (run, time_at (view, x)));
}

static void
on_drag_begin (GtkGestureDrag *gesture, double x, double y, View *view)
{
  gtk_widget_grab_focus (view->plot);
  go_to (view, x);
}

static void
on_drag_update (GtkGestureDrag *gesture, double dx, double dy, View *view)
{
  double x, y;
  if (gtk_gesture_drag_get_start_point (gesture, &x, &y))
    go_to (view, x + dx);
}

static void
on_motion (GtkEventControllerMotion *controller, double x, double y, View *view)
{
  view->pointer = time_at (view, x);
  show_values (view);
}

static void
on_leave (GtkEventControllerMotion *controller, View *view)
{
  view->pointer = -1.0;
  show_values (view);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, View *view)
{
  if (keyval == GDK_KEY_Left)
    gtk_widget_activate_action (view->plot, "win.previous-step", NULL);
  else if (keyval == GDK_KEY_Right)
    gtk_widget_activate_action (view->plot, "win.next-step", NULL);
  else
    return FALSE;
  return TRUE;
}

static void
on_destroy (GtkWidget *root, View *view)
{
  qn_energy_plot_clear (&view->energies);
}

static GtkLabel *
add_label (GtkWidget *grid, int place)
{
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_widget_set_hexpand (label, TRUE);
  gtk_grid_attach (GTK_GRID (grid), label, place % 2, place / 2, 1, 1);
  return GTK_LABEL (label);
}

GtkWidget *
qn_energy_view_new (QnViewState *state)
{
  View *view = g_new0 (View, 1);
  GtkWidget *grid = gtk_grid_new ();
  view->state = state;
  view->pointer = -1.0;
  view->root = gtk_box_new (GTK_ORIENTATION_VERTICAL, 4);
  view->plot = gtk_drawing_area_new ();
  gtk_widget_set_direction (view->plot, GTK_TEXT_DIR_LTR);
  gtk_widget_set_focusable (view->plot, TRUE);
  gtk_widget_set_name (view->plot, "energy-plot");
  gtk_drawing_area_set_content_height (GTK_DRAWING_AREA (view->plot), HEIGHT);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (view->plot), draw, view, NULL);
  gtk_accessible_update_property (
    GTK_ACCESSIBLE (view->plot), GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Energy over time"),
    GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
    _ ("The arrow keys go from step to step; the values are shown below"), -1);
  GtkGesture *drag = gtk_gesture_drag_new ();
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_drag_begin), view);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_drag_update), view);
  gtk_widget_add_controller (view->plot, GTK_EVENT_CONTROLLER (drag));
  GtkEventController *motion = gtk_event_controller_motion_new ();
  g_signal_connect (motion, "enter", G_CALLBACK (on_motion), view);
  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), view);
  g_signal_connect (motion, "leave", G_CALLBACK (on_leave), view);
  gtk_widget_add_controller (view->plot, motion);
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), view);
  gtk_widget_add_controller (view->plot, key);
  gtk_grid_set_column_homogeneous (GTK_GRID (grid), TRUE);
  for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
    view->values[curve] = add_label (grid, curve);
  view->time = add_label (grid, QN_ENERGY_CURVES);
  gtk_box_append (GTK_BOX (view->root), view->plot);
  gtk_box_append (GTK_BOX (view->root), grid);

  qn_own (view->root, view);
  g_signal_connect (view->root, "destroy", G_CALLBACK (on_destroy), view);
  QnDocument *document = qn_view_state_get_document (state);
  qn_watch (view->root, document, "runs-changed", G_CALLBACK (update), view);
  qn_watch (view->root, document, "job-changed", G_CALLBACK (update), view);
  qn_watch (view->root, state, "changed", G_CALLBACK (show_values), view);
  qn_watch (view->root, qn_settings_get (), "changed", G_CALLBACK (show_values), view);
  update (view);
  return view->root;
}
