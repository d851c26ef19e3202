#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/plot-view.h"
#include "app/widgets/settings.h"
#include "doc/view/sheet.h"

#include <glib/gi18n.h>
#include <math.h>

/* The plot's text over that of the window: the panel is narrow. */
#define TEXT_SHARE 0.825

typedef struct View {
  QnViewState *state;
  GtkWidget *root, *plot;
  double pointer; /* s; not-a-number: the pointer is elsewhere */
} View;

static const QnRun *
run_of (const View *view)
{
  const QnRun *run = view->state->document->run;
  return run != NULL && run->result.history.row_count > 1 && run->result.step_count > 0
           ? run
           : NULL;
}

/* Of the step that is shown, s. */
static double
shown_time (gpointer data)
{
  const View *view = data;
  const QnRun *run = run_of (view);
  return run->result.steps[qn_view_state_get_shown_step (view->state)].time;
}

static void
show_values (View *view)
{
  const QnRun *run = run_of (view);
  const char *unit;
  if (run == NULL)
    return;
  g_autoptr (QnPlot) plot = qn_energy_plot (&run->result.history, &unit);
  const QnMarks *marks = (const QnMarks *) (void *) plot->marks->data;
  double time = isnan (view->pointer) ? shown_time (view) : view->pointer;
  gsize i = 0;
  while (i + 1 < marks->count
         && fabs (marks->x[i + 1] - time) <= fabs (marks->x[i] - time))
    i++;
  g_autofree char *at =
    qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_TIME, marks->x[i], 4);
  g_autofree char *small = g_markup_printf_escaped (_ ("<small>at %s</small>"), at);
  gtk_label_set_markup (qn_part (view->root, "time"), small);
  for (int curve = 0; curve < QN_ENERGY_CURVES; curve++) {
    const QnMarks *m = &marks[curve];
    QnColor c = qn_series_color (m->series, false);
    g_autofree char *number =
      qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, m->y[i], 4);
    g_autofree char *text = g_markup_printf_escaped (
      "<small><span foreground=\"#%02x%02x%02x\" background=\"white\">%s</span> "
      "%s: %s %s</small>",
      c.r, c.g, c.b, m->dash > 0 ? "╌" : "━", m->label, number, unit);
    g_autofree char *id = g_strdup_printf ("value_%d", curve);
    gtk_label_set_markup (qn_part (view->root, id), text);
  }
  gtk_widget_queue_draw (view->plot);
}

static void
update (View *view)
{
  gboolean busy = view->state->document->job != NULL;
  view->pointer = NAN;
  gtk_widget_set_visible (view->root, run_of (view) != NULL && !busy);
  show_values (view);
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const QnRun *run = run_of (data);
  const char *unit;
  if (run == NULL)
    return NULL;
  QnPlot *plot = qn_energy_plot (&run->result.history, &unit);
  plot->without_legend = true;
  return plot;
}

/* Time at a place of the plot, s. */
static double
time_at (const View *view, QnVec2 at)
{
  return fmax (qn_plot_place_value (qn_plot_view_get_place (view->plot), at).x, 0.0);
}

/* The step that is nearest in time. */
static void
go_to (gpointer data, QnVec2 at)
{
  View *view = data;
  const QnRun *run = run_of (view);
  if (run != NULL && qn_run_is_in_time (run))
    qn_view_state_show_step (view->state,
                             qn_result_step_at (&run->result, time_at (view, at)));
}

static void
point (gpointer data, const QnVec2 *at)
{
  View *view = data;
  view->pointer = at != NULL ? time_at (view, *at) : NAN;
  show_values (view);
}

GtkWidget *
qn_energy_view_new (QnViewState *state)
{
  static const QnPlotHand hand = { .text_share = TEXT_SHARE,
                                   .steps = TRUE,
                                   .make = make_plot,
                                   .cursor = shown_time,
                                   .go_to = go_to,
                                   .point = point };
  g_autoptr (GtkBuilder) builder = qn_builder_new ("energy-view");
  View *view = g_new0 (View, 1);
  view->state = state;
  view->pointer = NAN;
  view->root = qn_builder_take_widget (builder, "energies");
  view->plot = qn_builder_get_widget (builder, "plot");
  qn_plot_view_init (view->plot, &hand, view);
  qn_own (view->root, view);
  qn_watch (view->root, state->document, "runs-changed", G_CALLBACK (update), view);
  qn_watch (view->root, state->document, "job-changed", G_CALLBACK (update), view);
  qn_watch (view->root, state, "changed", G_CALLBACK (show_values), view);
  qn_watch (view->root, qn_settings_get (), "changed", G_CALLBACK (show_values), view);
  update (view);
  return view->root;
}
