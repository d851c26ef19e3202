#include "app/views/curve-view.h"

#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/document/run-text.h"
#include "doc/view/magnet.h"
#include "io/exchange/table-csv.h"
#include "render/drawing/camera.h"
#include "render/drawing/color.h"
#include "render/figure/curve-plot.h"

#include <glib/gi18n.h>
#include <pango/pangocairo.h>

/* px, with text of the usual size. */
#define MARGIN_LEFT   56.0
#define MARGIN_BOTTOM 36.0
#define MARGIN_TOP    12.0
#define MARGIN_RIGHT  14.0
#define TICK_PX       52.0 /* least distance of ticks */
#define LEAST_HEIGHT  190.0

/* Runs drawn over each other, the current one included. */
#define MOST_CURVES 6

#define ZOOM_STEP 1.25

/* Height of the axis while nothing has moved, m. */
#define LEAST_MOTION 1e-6

typedef struct Series {
  QnRun *run; /* NULL while an analysis runs */
  QnCurve curve;
} Series;

struct _QnCurveView {
  GtkWidget parent_instance;
  QnViewState *state;

  Series series[MOST_CURVES]; /* the current run first */
  int series_count;
  gboolean live;   /* an analysis runs: abscissa is the number of the step, or the time */
  double live_end; /* when it ends at the latest, s; 0: it is none in time */
  const QnModel *model; /* of the run or the job; borrowed */
  QnId block;
  QnDof dof;
  QnBox range;     /* what is in view: displacement, multiplier */
  gboolean chosen; /* by the user */
  QnBox pan_from;  /* the range when panning began */
  QnVec2 pointer;  /* px; outside where nothing is told */
  gboolean inside;
};

G_DEFINE_FINAL_TYPE (QnCurveView, qn_curve_view, GTK_TYPE_WIDGET)

/* Lengths for text of the usual size grow with the text. */
static double
px (QnCurveView *self, double usual)
{
  return usual * qn_text_unit (GTK_WIDGET (self)) / QN_TEXT_UNIT;
}

/* ---- what is shown ---- */

static void
clear_series (QnCurveView *self)
{
  for (int i = 0; i < self->series_count; i++) {
    qn_curve_clear (&self->series[i].curve);
    g_clear_pointer (&self->series[i].run, qn_run_unref);
  }
  self->series_count = 0;
}

static void
take_live_curve (QnCurveView *self, QnJob *job)
{
  gsize count = 0;
  const QnVec2 *points = qn_job_get_curve (job, &count);
  QnCurve *curve = &self->series[0].curve;
  self->live = TRUE;
  self->live_end = qn_job_get_followed (job, &self->block, &self->dof);
  self->model = qn_job_get_model (job);
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

/* Whether displacements are shown over the time instead of multipliers over displacements. */
static gboolean
is_in_time (QnCurveView *self)
{
  return self->series_count > 0 && self->series[0].curve.in_time;
}

static gboolean
settles (QnCurveView *self)
{
  return self->series_count > 0 && self->series[0].curve.settles;
}

/* Up to the peak and a little more; a motion that runs away leaves the picture. */
static void
fit (QnCurveView *self)
{
  QnBox box = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  self->chosen = FALSE;
  for (int k = 0; k < self->series_count; k++) {
    const QnCurve *curve = &self->series[k].curve;
    double end = 0.0;
    gboolean cut = !self->live && qn_curve_get_end (curve, &end);
    for (gsize i = 0; i < curve->count; i++) {
      double x = curve->x[i], first = curve->x[0];
      gboolean beyond = cut && fabs (x - first) > fabs (end - first);
      qn_box_add_point (&box, qn_vec2 (beyond ? end : x, curve->y[i]));
    }
  }
  if (self->live)
    box.max.x = MAX (box.max.x, self->live_end);
  if (box.max.x <= box.min.x)
    box.max.x = box.min.x + 1.0;
  if (is_in_time (self))
    box.max.y += box.max.y > box.min.y ? 0.06 * (box.max.y - box.min.y) : LEAST_MOTION;
  else
    box.max.y = box.max.y > 0.0 ? box.max.y + 0.06 * (box.max.y - box.min.y) : 1.0;
  self->range = box;
}

static void
update_description (QnCurveView *self, const QnRun *run)
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
    GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Load–displacement curve"),
    GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text != NULL ? text : _ ("No result yet"), -1);
}

static void
take_run (QnCurveView *self, QnRun *run, QnCurveMotion motion)
{
  Series *series = &self->series[self->series_count];
  if (!qn_run_has_curve (run) || run->result.step_count == 0
      || !qn_curve_from_result (&series->curve, &run->model, &run->result, motion))
    return;
  if (self->series_count > 0
      && !qn_curve_shares_axes (&self->series[0].curve, &series->curve)) {
    qn_curve_clear (&series->curve);
    return;
  }
  series->run = qn_run_ref (run);
  self->series_count++;
}

/* The current run, and over it those of the same blocks. */
static void
take_runs (QnCurveView *self, QnDocument *document)
{
  QnRun *run = qn_document_get_run (document);
  if (run == NULL)
    return;
  QnCurveMotion motion = qn_result_curve_motion (&run->model, &run->result);
  self->block = motion.body;
  self->dof = motion.dof;
  take_run (self, run, motion);
  self->model = &run->model;
  const GPtrArray *runs = qn_document_get_runs (document);
  for (guint i = runs->len;
       i-- > 0 && self->series_count > 0 && self->series_count < MOST_CURVES;) {
    QnRun *other = g_ptr_array_index (runs, i);
    if (other != run && other->model.block_count == run->model.block_count
        && other->model.node_count == run->model.node_count)
      take_run (self, other, motion);
  }
}

static void
update (QnCurveView *self)
{
  QnDocument *document = qn_view_state_get_document (self->state);
  QnJob *job = qn_document_get_job (document);
  clear_series (self);
  self->live = FALSE;
  self->model = NULL;
  self->block = QN_NONE;
  if (job != NULL)
    take_live_curve (self, job);
  else
    take_runs (self, document);
  fit (self);
  update_description (self, qn_document_get_run (document));
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* ---- places ---- */

static double
plot_left (QnCurveView *self)
{
  return px (self, MARGIN_LEFT);
}

static double
plot_top (QnCurveView *self)
{
  return px (self, MARGIN_TOP);
}

static double
plot_width (QnCurveView *self)
{
  return gtk_widget_get_width (GTK_WIDGET (self)) - plot_left (self)
         - px (self, MARGIN_RIGHT);
}

static double
plot_height (QnCurveView *self)
{
  return gtk_widget_get_height (GTK_WIDGET (self)) - plot_top (self)
         - px (self, MARGIN_BOTTOM);
}

static QnVec2
to_screen (QnCurveView *self, double x, double y)
{
  const QnBox *r = &self->range;
  double u = (x - r->min.x) / (r->max.x - r->min.x);
  double v = (y - r->min.y) / (r->max.y - r->min.y);
  return qn_vec2 (plot_left (self) + u * plot_width (self),
                  plot_top (self) + (1.0 - v) * plot_height (self));
}

/* Points outside of the range stand at the edge of the frame, but not where the user has chosen the
 * range. */
static QnVec2
to_frame (QnCurveView *self, const QnCurve *curve, gsize i)
{
  QnVec2 p = to_screen (self, curve->x[i], curve->y[i]);
  if (self->chosen)
    return p;
  return qn_vec2 (CLAMP (p.x, plot_left (self), plot_left (self) + plot_width (self)),
                  CLAMP (p.y, plot_top (self), plot_top (self) + plot_height (self)));
}

/* The point of a curve that is nearest of those in sight, and how far it is, px; -1: there is none. */
static int
nearest_point (QnCurveView *self, const QnCurve *curve, QnVec2 at, double *distance)
{
  int best = -1;
  *distance = INFINITY;
  for (gsize i = 0; i < curve->count; i++) {
    QnVec2 p = to_frame (self, curve, i);
    double d = qn_vec2_length (qn_vec2_sub (p, at));
    bool shown = p.x >= plot_left (self) && p.x <= plot_left (self) + plot_width (self)
                 && p.y >= plot_top (self) && p.y <= plot_top (self) + plot_height (self);
    if (shown && d < *distance) {
      *distance = d;
      best = (int) i;
    }
  }
  return best;
}

/* Shows `share` of the range, keeping the place under `at`; 1 / share is the magnification. */
static void
zoom (QnCurveView *self, double share, QnVec2 at)
{
  QnBox *r = &self->range;
  double u = (at.x - plot_left (self)) / plot_width (self);
  double v = 1.0 - (at.y - plot_top (self)) / plot_height (self);
  double width = r->max.x - r->min.x, height = r->max.y - r->min.y;
  if (self->series_count == 0 || !(width * share > 1e-12) || width * share > 1e6)
    return;
  r->min.x += u * width * (1.0 - share);
  r->min.y += v * height * (1.0 - share);
  r->max = qn_vec2 (r->min.x + width * share, r->min.y + height * share);
  self->chosen = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* ---- drawing ---- */

static PangoLayout *
create_layout (QnCurveView *self, const char *text)
{
  PangoLayout *layout = gtk_widget_create_pango_layout (GTK_WIDGET (self), NULL);
  g_autofree char *small = g_markup_printf_escaped ("<small>%s</small>", text);
  pango_layout_set_markup (layout, small, -1);
  return layout;
}

static void
draw_text (QnCurveView *self, cairo_t *cr, const char *text, double x, double y,
           double align_x, gboolean upright)
{
  g_autoptr (PangoLayout) layout = create_layout (self, text);
  int width, height, most = gtk_widget_get_height (GTK_WIDGET (self));
  pango_layout_get_pixel_size (layout, &width, &height);
  if (upright && width > most) { /* its unit, at the end, stays */
    pango_layout_set_width (layout, most * PANGO_SCALE);
    pango_layout_set_ellipsize (layout, PANGO_ELLIPSIZE_MIDDLE);
    width = most;
    y = 0.5 * most;
  }
  cairo_save (cr);
  cairo_translate (cr, x, y);
  if (upright)
    cairo_rotate (cr, -G_PI_2);
  cairo_move_to (cr, -align_x * width, upright ? 0.0 : -0.5 * height);
  pango_cairo_show_layout (cr, layout);
  cairo_restore (cr);
}

static QnQuantity
displacement (QnCurveView *self)
{
  return self->dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH;
}

static QnQuantity
abscissa (QnCurveView *self)
{
  return is_in_time (self) ? QN_QUANTITY_TIME
         : self->live      ? QN_QUANTITY_NUMBER
                           : displacement (self);
}

static QnQuantity
ordinate (QnCurveView *self)
{
  return is_in_time (self) ? displacement (self)
         : settles (self)  ? QN_QUANTITY_FORCE
                           : QN_QUANTITY_NUMBER;
}

static void
draw_y_ticks (QnCurveView *self, cairo_t *cr)
{
  const QnBox *r = &self->range;
  QnUnits units = qn_units_of_motion (qn_settings_get_units ());
  QnQuantity quantity = ordinate (self);
  double factor = qn_units_factor (units, quantity);
  double step =
    factor
    * qn_magnet_round_distance ((r->max.y - r->min.y) / factor * px (self, TICK_PX) * 0.6
                                / plot_height (self));
  for (double i = ceil (r->min.y / step); i * step <= r->max.y; i++) {
    QnVec2 p = to_screen (self, r->min.x, i * step);
    g_autofree char *text =
      qn_units_format (units, quantity, i == 0.0 ? 0.0 : i * step, 4);
    cairo_move_to (cr, p.x, floor (p.y) + 0.5);
    cairo_rel_line_to (cr, plot_width (self), 0.0);
    draw_text (self, cr, text, p.x - 5.0, p.y, 1.0, FALSE);
  }
}

static void
draw_x_ticks (QnCurveView *self, cairo_t *cr)
{
  QnUnits units = qn_units_of_motion (qn_settings_get_units ());
  QnQuantity quantity = abscissa (self);
  double factor = qn_units_factor (units, quantity);
  const QnBox *r = &self->range;
  double span = (r->max.x - r->min.x) / factor;
  double step = qn_magnet_round_distance (span * px (self, TICK_PX) / plot_width (self));
  for (double i = ceil (r->min.x / factor / step); i * step * factor <= r->max.x; i++) {
    QnVec2 p = to_screen (self, i * step * factor, r->min.y);
    g_autofree char *text =
      qn_units_format (units, quantity, i == 0.0 ? 0.0 : i * step * factor, 4);
    cairo_move_to (cr, floor (p.x) + 0.5, p.y);
    cairo_rel_line_to (cr, 0.0, 4.0);
    draw_text (self, cr, text, p.x, p.y + px (self, 11.0), 0.5, FALSE);
  }
}

/* "ux since the dead load, block (mm)", where that is longer than its room "ux (mm)"; NULL where no block
 * is followed. */
static char *
dup_displacement_label (QnCurveView *self, double room)
{
  static const char *const components[] = { "ux", "uy", "rz" };
  if (self->series_count == 0 || self->block == QN_NONE)
    return NULL;
  const char *component = components[self->dof];
  const char *unit =
    qn_units_symbol (qn_units_of_motion (qn_settings_get_units ()), displacement (self));
  g_autofree char *full = g_strdup_printf (
    self->series[0].curve.since_dead ? _ ("%s since the dead load, %s (%s)")
                                     : "%s, %s (%s)",
    component, qn_result_body_name (self->model, self->block), unit);
  int width;
  g_autoptr (PangoLayout) layout = create_layout (self, full);
  pango_layout_get_pixel_size (layout, &width, NULL);
  return width <= room ? g_steal_pointer (&full)
                       : g_strdup_printf ("%s (%s)", component, unit);
}

static void
draw_x_label (QnCurveView *self, cairo_t *cr)
{
  double x = plot_left (self) + 0.5 * plot_width (self);
  double y = gtk_widget_get_height (GTK_WIDGET (self)) - px (self, 7.0);
  if (is_in_time (self) || self->live) {
    draw_text (self, cr, is_in_time (self) ? _ ("Time (s)") : _ ("Step"), x, y, 0.5,
               FALSE);
    return;
  }
  g_autofree char *text =
    dup_displacement_label (self, 2.0 * (gtk_widget_get_width (GTK_WIDGET (self)) - x));
  if (text != NULL)
    draw_text (self, cr, text, x, y, 0.5, FALSE);
}

static void
draw_y_label (QnCurveView *self, cairo_t *cr)
{
  g_autofree char *text =
    is_in_time (self)
      ? dup_displacement_label (self, gtk_widget_get_height (GTK_WIDGET (self)))
      : NULL;
  g_autofree char *force =
    settles (self) ? g_strdup_printf (
      _ ("Reaction (%s)"), qn_units_symbol (qn_settings_get_units (), QN_QUANTITY_FORCE))
                   : NULL;
  const char *set = self->series_count > 0 ? self->series[0].curve.set : NULL;
  draw_text (self, cr,
             text != NULL    ? text
             : force != NULL ? force
             : set != NULL   ? set
                             : _ ("Load multiplier"),
             2.0, plot_top (self) + 0.5 * plot_height (self), 0.5, TRUE);
}

/* On dark ground nearer to white: colours of the paper have little contrast there. */
static void
set_series_color (cairo_t *cr, int series, const GdkRGBA *ink)
{
  QnColor c = qn_series_color (series, false);
  double white = ink->red > 0.5f ? 0.55 : 0.0;
  cairo_set_source_rgb (cr, white + (1.0 - white) * c.r / 255.0,
                        white + (1.0 - white) * c.g / 255.0,
                        white + (1.0 - white) * c.b / 255.0);
}

/* A cross for collapse, a diamond for the first limit point. */
static void
draw_marks (QnCurveView *self, cairo_t *cr, const QnCurve *curve)
{
  if (curve->collapse_point >= 0 && (gsize) curve->collapse_point < curve->count) {
    QnVec2 p = to_frame (self, curve, (gsize) curve->collapse_point);
    cairo_move_to (cr, p.x - 5.0, p.y - 5.0);
    cairo_line_to (cr, p.x + 5.0, p.y + 5.0);
    cairo_move_to (cr, p.x - 5.0, p.y + 5.0);
    cairo_line_to (cr, p.x + 5.0, p.y - 5.0);
    cairo_stroke (cr);
  }
  if (curve->limit_point >= 0 && (gsize) curve->limit_point < curve->count) {
    QnVec2 p = to_frame (self, curve, (gsize) curve->limit_point);
    cairo_move_to (cr, p.x, p.y - 6.0);
    cairo_line_to (cr, p.x + 5.0, p.y);
    cairo_line_to (cr, p.x, p.y + 6.0);
    cairo_line_to (cr, p.x - 5.0, p.y);
    cairo_close_path (cr);
    cairo_stroke (cr);
  }
}

/* Where the last motion leaves the picture: an arrow, and how far it goes. */
static void
draw_runaway (QnCurveView *self, cairo_t *cr, const QnCurve *curve)
{
  double end = 0.0;
  if (self->chosen || self->live || !qn_curve_get_end (curve, &end))
    return;
  QnVec2 p = to_frame (self, curve, curve->count - 1);
  double way = end < curve->x[0] ? -1.0 : 1.0;
  g_autofree char *far =
    qn_units_format_full (qn_units_of_motion (qn_settings_get_units ()), abscissa (self),
                          curve->x[curve->count - 1], 3);
  g_autofree char *text = g_strdup_printf (_ ("moves on to %s"), far);
  cairo_move_to (cr, p.x + 9.0 * way, p.y);
  cairo_rel_line_to (cr, -9.0 * way, -4.0);
  cairo_rel_line_to (cr, 0.0, 8.0);
  cairo_close_path (cr);
  cairo_fill (cr);
  draw_text (self, cr, text, p.x, p.y + px (self, 14.0), way > 0.0 ? 1.0 : 0.0, FALSE);
}

static void
clip_to_frame (QnCurveView *self, cairo_t *cr, double more)
{
  cairo_rectangle (cr, plot_left (self), plot_top (self) - more, plot_width (self),
                   plot_height (self) + 2.0 * more);
  cairo_clip (cr);
}

static void
draw_series (QnCurveView *self, cairo_t *cr, int index, const GdkRGBA *ink)
{
  const QnCurve *curve = &self->series[index].curve;
  cairo_save (cr);
  clip_to_frame (self, cr, 1.0);
  for (gsize i = 0; i < curve->count; i++) {
    QnVec2 p = to_screen (self, curve->x[i], curve->y[i]);
    cairo_line_to (cr, CLAMP (p.x, -1e5, 1e5), CLAMP (p.y, -1e5, 1e5));
  }
  set_series_color (cr, index, ink);
  cairo_set_line_width (cr, index == 0 ? 2.0 : 1.2);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke (cr);
  cairo_restore (cr);
  if (self->live || index > 0)
    return;
  gdk_cairo_set_source_rgba (cr, ink);
  cairo_set_line_width (cr, 1.5);
  cairo_save (cr);
  if (self->chosen)
    clip_to_frame (self, cr, 1.0);
  draw_marks (self, cr, curve);
  cairo_restore (cr);
  draw_runaway (self, cr, curve);
}

static void
draw_cursor (QnCurveView *self, cairo_t *cr)
{
  int step = qn_view_state_get_step (self->state);
  if (self->live || self->series_count == 0)
    return;
  const QnCurve *curve = &self->series[0].curve;
  gsize i = step == QN_STEP_LAST ? curve->count - 1 : (gsize) step;
  if (i >= curve->count)
    return;
  QnVec2 p = to_frame (self, curve, i);
  cairo_save (cr);
  if (self->chosen)
    clip_to_frame (self, cr, 1.0);
  cairo_set_source_rgb (cr, 0.9, 0.35, 0.0);
  cairo_set_line_width (cr, 1.0);
  cairo_move_to (cr, floor (p.x) + 0.5, plot_top (self));
  cairo_rel_line_to (cr, 0.0, plot_height (self));
  cairo_stroke (cr);
  cairo_arc (cr, p.x, p.y, 5.0, 0.0, 2.0 * G_PI);
  cairo_fill (cr);
  cairo_restore (cr);
}

void
qn_curve_view_get_range (QnCurveView *self, QnVec2 *low, QnVec2 *high)
{
  *low = self->range.min;
  *high = self->range.max;
}

char *
qn_curve_view_dup_values (QnCurveView *self, double x, double y)
{
  double least = INFINITY, distance;
  int series = -1, point = -1;
  for (int k = 0; k < self->series_count; k++) {
    int i = nearest_point (self, &self->series[k].curve, qn_vec2 (x, y), &distance);
    if (i >= 0 && distance < least) {
      least = distance;
      series = k;
      point = i;
    }
  }
  if (series < 0)
    return NULL;
  const Series *s = &self->series[series];
  g_autofree char *value = qn_units_format_full (
    qn_units_of_motion (qn_settings_get_units ()), abscissa (self), s->curve.x[point], 4);
  if (self->live && !s->curve.in_time)
    return g_strdup_printf (_ ("Step %d: multiplier %.4f"), point, s->curve.y[point]);
  g_autofree char *moved = qn_units_format_full (
    qn_units_of_motion (qn_settings_get_units ()), ordinate (self), s->curve.y[point], 4);
  g_autofree char *own = s->curve.in_time
                           ? g_strdup_printf ("%s: %s", value, moved)
                           : g_strdup_printf (_ ("Step %d: %s, multiplier %.4f"), point,
                                              value, s->curve.y[point]);
  if (self->series_count == 1)
    return g_steal_pointer (&own);
  g_autofree char *title = qn_run_dup_title (s->run);
  return g_strdup_printf ("%s\n%s", title, own);
}

/* Values of the point nearest to the pointer, in a corner where they cover no curve that rises. */
static void
draw_values (QnCurveView *self, cairo_t *cr, const GdkRGBA *ink)
{
  g_autofree char *text =
    self->inside ? qn_curve_view_dup_values (self, self->pointer.x, self->pointer.y)
                 : NULL;
  if (text == NULL)
    return;
  g_autoptr (PangoLayout) layout = create_layout (self, text);
  pango_layout_set_width (layout, (int) plot_width (self) * PANGO_SCALE);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  double x = plot_left (self) + plot_width (self) - width - 4.0;
  double y = plot_top (self) + plot_height (self) - height - 4.0;
  GdkRGBA paper = *ink;
  paper.red = paper.green = paper.blue = ink->red > 0.5f ? 0.15f : 1.0f;
  paper.alpha = 0.85f;
  gdk_cairo_set_source_rgba (cr, &paper);
  cairo_rectangle (cr, x - 3.0, y - 2.0, width + 6.0, height + 4.0);
  cairo_fill (cr);
  gdk_cairo_set_source_rgba (cr, ink);
  cairo_move_to (cr, x, y);
  pango_cairo_show_layout (cr, layout);
}

static void
qn_curve_view_snapshot (GtkWidget *widget, GtkSnapshot *snapshot)
{
  QnCurveView *self = QN_CURVE_VIEW (widget);
  float width = (float) gtk_widget_get_width (widget);
  float height = (float) gtk_widget_get_height (widget);
  if (plot_width (self) < 20.0 || plot_height (self) < 20.0)
    return;
  cairo_t *cr =
    gtk_snapshot_append_cairo (snapshot, &GRAPHENE_RECT_INIT (0, 0, width, height));
  GdkRGBA ink;
  gtk_style_context_get_color (gtk_widget_get_style_context (GTK_WIDGET (self)), &ink);
  GdkRGBA faint = ink;
  faint.alpha = 0.25f;
  cairo_set_line_width (cr, 1.0);
  gdk_cairo_set_source_rgba (cr, &ink);
  draw_y_ticks (self, cr);
  draw_x_ticks (self, cr);
  draw_x_label (self, cr);
  draw_y_label (self, cr);
  gdk_cairo_set_source_rgba (cr, &faint);
  cairo_stroke (cr);
  for (int i = self->series_count; i-- > 0;)
    draw_series (self, cr, i, &ink);
  draw_cursor (self, cr);
  draw_values (self, cr, &ink);
  cairo_destroy (cr);
  if (gtk_widget_has_focus (widget))
    gtk_snapshot_render_focus (snapshot, gtk_widget_get_style_context (widget), 1, 1,
                               width - 2, height - 2);
}

/* ---- hand ---- */

static void
go_to (QnCurveView *self, double x, double y)
{
  double distance;
  int step = self->series_count > 0 && !self->live
               ? nearest_point (self, &self->series[0].curve, qn_vec2 (x, y), &distance)
               : -1;
  if (step < 0)
    return;
  if (!qn_view_needs_result (qn_view_state_get_view (self->state))
      || qn_view_state_get_view (self->state) == QN_VIEW_MECHANISM)
    qn_view_state_set_view (self->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (self->state, step);
}

static void
on_drag_begin (GtkGestureDrag *gesture, double x, double y, QnCurveView *self)
{
  gtk_widget_grab_focus (GTK_WIDGET (self));
  go_to (self, x, y);
}

static void
on_drag_update (GtkGestureDrag *gesture, double dx, double dy, QnCurveView *self)
{
  double x, y;
  if (gtk_gesture_drag_get_start_point (gesture, &x, &y))
    go_to (self, x + dx, y + dy);
}

static void
on_click (GtkGestureClick *gesture, int presses, double x, double y, QnCurveView *self)
{
  if (presses != 2)
    return;
  fit (self);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
on_pan_begin (GtkGestureDrag *gesture, double x, double y, QnCurveView *self)
{
  self->pan_from = self->range;
}

static void
on_pan_update (GtkGestureDrag *gesture, double dx, double dy, QnCurveView *self)
{
  const QnBox *from = &self->pan_from;
  QnVec2 moved = qn_vec2 (-dx / plot_width (self) * (from->max.x - from->min.x),
                          dy / plot_height (self) * (from->max.y - from->min.y));
  self->range.min = qn_vec2_add (from->min, moved);
  self->range.max = qn_vec2_add (from->max, moved);
  self->chosen = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
on_motion (GtkEventControllerMotion *controller, double x, double y, QnCurveView *self)
{
  self->pointer = qn_vec2 (x, y);
  self->inside = TRUE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

static void
on_leave (GtkEventControllerMotion *controller, QnCurveView *self)
{
  self->inside = FALSE;
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* With Ctrl, or once the curve has been clicked: else the panel scrolls past it. */
static gboolean
on_scroll (GtkEventControllerScroll *controller, double dx, double dy, QnCurveView *self)
{
  GdkModifierType held =
    gtk_event_controller_get_current_event_state (GTK_EVENT_CONTROLLER (controller));
  if ((held & GDK_CONTROL_MASK) == 0 && !gtk_widget_has_focus (GTK_WIDGET (self)))
    return FALSE;
  zoom (self, pow (ZOOM_STEP, dy), self->pointer);
  return TRUE;
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnCurveView *self)
{
  if (keyval == GDK_KEY_Left)
    gtk_widget_activate_action (GTK_WIDGET (self), "win.previous-step", NULL);
  else if (keyval == GDK_KEY_Right)
    gtk_widget_activate_action (GTK_WIDGET (self), "win.next-step", NULL);
  else if (keyval == GDK_KEY_plus || keyval == GDK_KEY_KP_Add)
    zoom (self, 1.0 / ZOOM_STEP, to_screen (self, 0.0, 0.0));
  else if (keyval == GDK_KEY_minus || keyval == GDK_KEY_KP_Subtract)
    zoom (self, ZOOM_STEP, to_screen (self, 0.0, 0.0));
  else if (keyval == GDK_KEY_0 || keyval == GDK_KEY_KP_0) {
    fit (self);
    gtk_widget_queue_draw (GTK_WIDGET (self));
  } else
    return FALSE;
  return TRUE;
}

static void
qn_curve_view_measure (GtkWidget *widget, GtkOrientation orientation, int for_size,
                       int *minimum, int *natural, int *minimum_baseline,
                       int *natural_baseline)
{
  *minimum = *natural = orientation == GTK_ORIENTATION_VERTICAL
                          ? (int) px (QN_CURVE_VIEW (widget), LEAST_HEIGHT)
                          : 200;
  *minimum_baseline = *natural_baseline = -1;
}

static void
qn_curve_view_finalize (GObject *object)
{
  QnCurveView *self = QN_CURVE_VIEW (object);
  clear_series (self);
  g_clear_object (&self->state);
  G_OBJECT_CLASS (qn_curve_view_parent_class)->finalize (object);
}

static void
qn_curve_view_class_init (QnCurveViewClass *klass)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  G_OBJECT_CLASS (klass)->finalize = qn_curve_view_finalize;
  widget_class->snapshot = qn_curve_view_snapshot;
  widget_class->measure = qn_curve_view_measure;
  gtk_widget_class_set_accessible_role (widget_class, GTK_ACCESSIBLE_ROLE_IMG);
}

static void
qn_curve_view_init (QnCurveView *self)
{
  gtk_widget_set_direction (GTK_WIDGET (self), GTK_TEXT_DIR_LTR);
  GtkWidget *widget = GTK_WIDGET (self);
  gtk_widget_set_focusable (widget, TRUE);
  gtk_widget_set_hexpand (widget, TRUE);
  gtk_widget_set_overflow (widget, GTK_OVERFLOW_HIDDEN);
  GtkGesture *drag = gtk_gesture_drag_new ();
  g_signal_connect (drag, "drag-begin", G_CALLBACK (on_drag_begin), self);
  g_signal_connect (drag, "drag-update", G_CALLBACK (on_drag_update), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (drag));
  GtkGesture *click = gtk_gesture_click_new ();
  g_signal_connect (click, "pressed", G_CALLBACK (on_click), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (click));
  GtkGesture *pan = gtk_gesture_drag_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (pan), GDK_BUTTON_MIDDLE);
  g_signal_connect (pan, "drag-begin", G_CALLBACK (on_pan_begin), self);
  g_signal_connect (pan, "drag-update", G_CALLBACK (on_pan_update), self);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (pan));
  GtkEventController *motion = gtk_event_controller_motion_new ();
  g_signal_connect (motion, "enter", G_CALLBACK (on_motion), self);
  g_signal_connect (motion, "motion", G_CALLBACK (on_motion), self);
  g_signal_connect (motion, "leave", G_CALLBACK (on_leave), self);
  gtk_widget_add_controller (widget, motion);
  GtkEventController *scroll =
    gtk_event_controller_scroll_new (GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
  g_signal_connect (scroll, "scroll", G_CALLBACK (on_scroll), self);
  gtk_widget_add_controller (widget, scroll);
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (widget, key);
}

GtkWidget *
qn_curve_view_new (QnViewState *state)
{
  QnCurveView *self = g_object_new (QN_TYPE_CURVE_VIEW, NULL);
  self->state = g_object_ref (state);
  QnDocument *document = qn_view_state_get_document (state);
  g_signal_connect_object (state, "changed", G_CALLBACK (gtk_widget_queue_draw), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (document, "runs-changed", G_CALLBACK (update), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (document, "job-changed", G_CALLBACK (update), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (document, "job-progress", G_CALLBACK (update), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (qn_settings_get (), "changed",
                           G_CALLBACK (gtk_widget_queue_draw), self, G_CONNECT_SWAPPED);
  update (self);
  return GTK_WIDGET (self);
}
