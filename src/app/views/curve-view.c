#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/paper-area.h"
#include "app/widgets/plot-view.h"
#include "app/widgets/settings.h"
#include "doc/document/run.h"
#include "io/exchange/table-csv.h"
#include "render/figure/curve-plot.h"

#include <glib/gi18n.h>
#include <math.h>

#define LEAST_HEIGHT 190 /* px, with text of the usual size */

/* The plot's text over that of the window: the panel is narrow. */
#define TEXT_SHARE 0.9

/* m: beyond that motions are told in the units of the drawing, not in those of motions. */
#define FAR 10.0

/* Runs drawn over each other, the current one included. */
#define MOST_CURVES 6

typedef struct Series {
  QnRun *run; /* NULL while an analysis runs */
  QnCurve whole,
    fitting; /* the second without the last motion of a path that runs away */
} Series;

typedef struct View {
  QnViewState *state;
  GtkWidget *area;
  Series series[MOST_CURVES]; /* the current run first */
  int series_count;
  gboolean live;   /* an analysis runs: abscissa is the number of the step, or the time */
  double live_end; /* when it ends at the latest, s; 0: it is none in time */
  const QnModel *model; /* of the run or the job; borrowed */
  QnId block;
  QnDof dof;
  gboolean zoomed; /* whole curves are shown */
} View;

/* ---- what is shown ---- */

static void
clear_series (View *self)
{
  for (int i = 0; i < self->series_count; i++) {
    qn_curve_clear (&self->series[i].whole);
    qn_curve_clear (&self->series[i].fitting);
    g_clear_pointer (&self->series[i].run, qn_run_unref);
  }
  self->series_count = 0;
}

static void
take_live_curve (View *self, QnJob *job)
{
  gsize count = 0;
  const QnVec2 *points = qn_job_get_curve (job, &count);
  QnCurve *curve = &self->series[0].whole;
  self->live = TRUE;
  self->live_end = qn_job_get_followed (job, &self->block, &self->dof);
  self->model = &qn_job_get_run (job)->model;
  self->series_count = 1;
  *curve = (QnCurve){
    .limit_point = -1, .collapse_point = -1, .dot = -1, .in_time = self->live_end > 0.0
  };
  curve->count = count;
  curve->x = g_new (double, count + 1);
  curve->y = g_new (double, count + 1);
  for (gsize i = 0; i < count; i++) {
    curve->x[i] = points[i].x;
    curve->y[i] = points[i].y;
  }
}

/* Marks are those of the current run. */
static void
take_run (View *self, QnRun *run, QnCurveMotion motion)
{
  Series *series = &self->series[self->series_count];
  if (!qn_run_has_curve (run) || run->result.step_count == 0)
    return;
  qn_curve_from_result (&series->whole, &run->model, &run->result, motion);
  if (self->series_count > 0
      && !qn_curve_shares_axes (&self->series[0].whole, &series->whole)) {
    qn_curve_clear (&series->whole);
    return;
  }
  qn_curve_from_result (&series->fitting, &run->model, &run->result, motion);
  qn_curve_cut_runaway (&series->fitting);
  series->run = qn_run_ref (run);
  self->series_count++;
}

/* The current run, and over it those of the same blocks. */
static void
take_runs (View *self, QnDocument *document)
{
  QnRun *run = document->run;
  if (run == NULL)
    return;
  QnCurveMotion motion = qn_result_curve_motion (&run->model, &run->result);
  self->block = motion.body;
  self->dof = motion.dof;
  take_run (self, run, motion);
  self->model = &run->model;
  const GPtrArray *runs = document->runs;
  for (guint i = runs->len;
       i-- > 0 && self->series_count > 0 && self->series_count < MOST_CURVES;) {
    QnRun *other = g_ptr_array_index (runs, i);
    if (other != run && other->model.block_count == run->model.block_count
        && other->model.node_count == run->model.node_count)
      take_run (self, other, motion);
  }
}

static void
update_description (View *self, const QnRun *run)
{
  g_autofree char *text = NULL;
  if (run != NULL && run->result.step_count > 0 && run->result.history.width > 0)
    text = g_strdup_printf (
      _ ("History of %u steps over %.4g s; the arrow keys go from step to step"),
      (guint) run->result.step_count, run->result.steps[run->result.step_count - 1].time);
  else if (run != NULL && run->result.step_count > 0)
    text = g_strdup_printf (_ ("Curve of %u steps up to a load multiplier of %.4g; the "
                               "arrow keys go from step to step"),
                            (guint) run->result.step_count,
                            run->result.steps[run->result.step_count - 1].multiplier);
  gtk_accessible_update_property (
    GTK_ACCESSIBLE (self->area), GTK_ACCESSIBLE_PROPERTY_LABEL,
    _ ("Load–displacement curve"), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
    text != NULL ? text : _ ("No result yet"), -1);
}

static void
update (View *self)
{
  QnJob *job = self->state->document->job;
  clear_series (self);
  self->live = FALSE;
  self->model = NULL;
  self->block = QN_NONE;
  if (job != NULL)
    take_live_curve (self, job);
  else
    take_runs (self, self->state->document);
  update_description (self, self->state->document->run);
  qn_plot_view_fit (self->area);
}

/* Of an analysis that runs there is nothing to cut. */
static const QnCurve *
shown (const View *self, int series)
{
  const Series *s = &self->series[series];
  return self->zoomed || self->live ? &s->whole : &s->fitting;
}

/* The point of the step that is shown, -1: there is none. */
static ptrdiff_t
shown_point (const View *self)
{
  int step = qn_view_state_get_step (self->state);
  if (self->live || self->series_count == 0)
    return -1;
  ptrdiff_t last = (ptrdiff_t) shown (self, 0)->count - 1;
  return step == QN_STEP_LAST ? last : MIN (step, last);
}

/* ---- drawing ---- */

static QnQuantity
displacement (const View *self)
{
  return self->dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH;
}

static QnUnits
units_of_motion (void)
{
  return qn_units_of_motion (qn_settings_get_units ());
}

/* In the units of the window: "ux since the dead load, block (mm)". */
static void
name_axes (const View *self, QnPlot *plot)
{
  const QnCurve *curve = &self->series[0].whole;
  QnPlotAxis *axis = curve->in_time ? &plot->y : &plot->x;
  const QnUnits forces = qn_settings_get_units ();
  if (self->live && !curve->in_time) {
    plot->x.label = _ ("Step");
    plot->x.factor = 1.0;
    return;
  }
  if (self->live)
    plot->x.high = self->live_end;
  axis->factor = 1.0 / qn_units_factor (units_of_motion (), displacement (self));
  if (self->block != QN_NONE)
    axis->label = qn_plot_keep (
      plot, g_strdup_printf (
              curve->since_dead ? _ ("%s since the dead load, %s (%s)") : "%s, %s (%s)",
              qn_dof_names[self->dof], qn_result_body_name (self->model, self->block),
              qn_units_symbol (units_of_motion (), displacement (self))));
  if (!curve->settles)
    return;
  plot->y.label =
    qn_plot_keep (plot, g_strdup_printf (_ ("Reaction (%s)"),
                                         qn_units_symbol (forces, QN_QUANTITY_FORCE)));
  plot->y.factor = 1.0 / qn_units_factor (forces, QN_QUANTITY_FORCE);
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  View *self = data;
  QnCurve curves[MOST_CURVES];
  self->zoomed = zoomed;
  if (self->series_count == 0)
    return NULL;
  for (int k = 0; k < self->series_count; k++) {
    curves[k] = *shown (self, k);
    if (k > 0)
      curves[k].limit_point = curves[k].collapse_point = -1;
  }
  curves[0].dot = shown_point (self);
  QnPlot *plot = qn_curve_plot (curves, (gsize) self->series_count, NULL, 0);
  plot->without_legend = true;
  name_axes (self, plot);
  return plot;
}

static double
find_cursor (gpointer data)
{
  const View *self = data;
  ptrdiff_t point = shown_point (self);
  return point < 0 ? NAN : shown (self, 0)->x[point];
}

/* The point of a curve that is nearest of those in sight, and how far it is, px; -1: there is none. */
static int
nearest_point (const View *self, int series, QnVec2 at, double *distance)
{
  const QnPlotPlace *place = qn_plot_view_get_place (self->area);
  const QnCurve *curve = shown (self, series);
  int best = -1;
  *distance = INFINITY;
  for (gsize i = 0; i < curve->count; i++) {
    QnVec2 p = { place->x_zero + place->x_scale * curve->x[i],
                 place->y_zero + place->y_scale * curve->y[i] };
    double d = qn_vec2_length (qn_vec2_sub (p, at));
    bool sight = p.x >= place->frame.min.x && p.x <= place->frame.max.x
                 && p.y >= place->frame.min.y && p.y <= place->frame.max.y;
    if (sight && d < *distance) {
      *distance = d;
      best = (int) i;
    }
  }
  return best;
}

static char *
dup_values (const View *self, QnVec2 at)
{
  double least = INFINITY, distance;
  int series = -1, point = -1;
  for (int k = 0; k < self->series_count; k++) {
    int i = nearest_point (self, k, at, &distance);
    if (i >= 0 && distance < least) {
      least = distance;
      series = k;
      point = i;
    }
  }
  if (series < 0)
    return NULL;
  const Series *s = &self->series[series];
  double x = s->whole.x[point], y = s->whole.y[point];
  if (self->live && !s->whole.in_time)
    return g_strdup_printf (_ ("Step %d: multiplier %.4f"), point, y);
  const QnQuantity quantity = displacement (self);
  g_autofree char *value = qn_units_format_full (
    units_of_motion (), s->whole.in_time ? QN_QUANTITY_TIME : quantity, x, 4);
  g_autofree char *moved = qn_units_format_full (units_of_motion (), quantity, y, 4);
  g_autofree char *own =
    s->whole.in_time
      ? g_strdup_printf ("%s: %s", value, moved)
      : g_strdup_printf (_ ("Step %d: %s, multiplier %.4f"), point, value, y);
  if (self->series_count == 1)
    return g_steal_pointer (&own);
  g_autofree char *title = qn_run_dup_title (s->run);
  return g_strdup_printf ("%s\n%s", title, own);
}

/* Values of the point nearest to the pointer, or how far the last motion goes beyond the picture. */
static char *
tell (gpointer data, const QnVec2 *at)
{
  const View *self = data;
  if (at != NULL)
    return dup_values (self, *at);
  if (self->series_count == 0 || !shown (self, 0)->runs_on)
    return NULL;
  const QnCurve *whole = &self->series[0].whole;
  const double end = whole->x[whole->count - 1];
  g_autofree char *far = qn_units_format_full (
    fabs (end) < FAR ? units_of_motion () : qn_settings_get_units (), displacement (self),
    end, 3);
  return g_strdup_printf (_ ("moves on to %s"), far);
}

char *
qn_curve_view_dup_values (GtkWidget *view, double x, double y)
{
  return dup_values (g_object_get_data (G_OBJECT (view), "qn-view"), qn_vec2 (x, y));
}

static void
go_to (gpointer data, QnVec2 at)
{
  View *self = data;
  double distance;
  int step =
    self->series_count > 0 && !self->live ? nearest_point (self, 0, at, &distance) : -1;
  if (step >= 0)
    qn_view_state_show_step (self->state, step);
}

static void
free_view (gpointer data)
{
  View *self = data;
  clear_series (self);
  g_object_unref (self->state);
  g_free (self);
}

GtkWidget *
qn_curve_view_new (QnViewState *state)
{
  static const QnPlotHand hand = { .text_share = TEXT_SHARE,
                                   .steps = TRUE,
                                   .make = make_plot,
                                   .cursor = find_cursor,
                                   .go_to = go_to,
                                   .tell = tell };
  View *self = g_new0 (View, 1);
  GtkWidget *area = g_object_new (QN_TYPE_PAPER_AREA, "name", "curve", "content-height",
                                  LEAST_HEIGHT, "hexpand", TRUE, NULL);
  qn_plot_view_init (area, &hand, self);
  self->state = g_object_ref (state);
  self->area = area;
  g_object_set_data_full (G_OBJECT (area), "qn-view", self, free_view);
  qn_watch (area, state, "changed", G_CALLBACK (gtk_widget_queue_draw), area);
  qn_watch (area, qn_settings_get (), "changed", G_CALLBACK (gtk_widget_queue_draw),
            area);
  qn_watch (area, state->document, "runs-changed", G_CALLBACK (update), self);
  qn_watch (area, state->document, "job-changed", G_CALLBACK (update), self);
  qn_watch (area, state->document, "job-progress", G_CALLBACK (update), self);
  update (self);
  return area;
}
