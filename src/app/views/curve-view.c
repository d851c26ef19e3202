#include "app/views/curve-view.h"

#include "app/widgets/settings.h"
#include "doc/view/magnet.h"
#include "io/exchange/table-csv.h"
#include "render/figure/curve-plot.h"

#include <glib/gi18n.h>
#include <pango/pangocairo.h>

#define MARGIN_LEFT   46.0
#define MARGIN_BOTTOM 36.0
#define MARGIN_TOP    12.0
#define MARGIN_RIGHT  14.0
#define TICK_PX       52.0 /* least distance of ticks */
#define LEAST_HEIGHT  190

struct _QnCurveView {
  GtkWidget parent_instance;
  QnViewState *state;

  QnCurve curve; /* of the current run, or live */
  gboolean live; /* abscissa is the number of the step */
  QnId block;
  QnDof dof;
  double x_min, x_max, y_max;
};

G_DEFINE_FINAL_TYPE (QnCurveView, qn_curve_view, GTK_TYPE_WIDGET)

/* ---- what is shown ---- */

static void
take_live_curve (QnCurveView *self, QnJob *job)
{
  gsize count = 0;
  const double *multipliers = qn_job_get_multipliers (job, &count);
  self->live = TRUE;
  self->curve.count = count;
  self->curve.x = calloc (count + 1, sizeof (double));
  self->curve.y = calloc (count + 1, sizeof (double));
  for (gsize i = 0; i < count; i++) {
    self->curve.x[i] = (double) i;
    self->curve.y[i] = multipliers[i];
  }
}

static void
update_range (QnCurveView *self)
{
  self->x_min = 0.0;
  self->x_max = self->y_max = 0.0;
  for (gsize i = 0; i < self->curve.count; i++) {
    self->x_min = MIN (self->x_min, self->curve.x[i]);
    self->x_max = MAX (self->x_max, self->curve.x[i]);
    self->y_max = MAX (self->y_max, self->curve.y[i]);
  }
  if (self->x_max <= self->x_min)
    self->x_max = self->x_min + 1.0;
  self->y_max = self->y_max > 0.0 ? 1.06 * self->y_max : 1.0;
}

static void
update_description (QnCurveView *self, const QnRun *run)
{
  g_autofree char *text = NULL;
  if (run != NULL && run->result.step_count > 0)
    text = g_strdup_printf (_ ("Curve of %u steps up to a load multiplier of %.4g; the "
                               "arrow keys go from step to step"),
                            (guint) run->result.step_count,
                            run->result.steps[run->result.step_count - 1].multiplier);
  gtk_accessible_update_property (
    GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Load–displacement curve"),
    GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text != NULL ? text : _ ("No result yet"), -1);
}

/* The controlled block, or node behind the blocks. */
static QnId
controlled_body (const QnModel *model)
{
  size_t body = qn_model_controlled_body (model, model->analysis.control_block,
                                          model->analysis.control_node);
  return body != SIZE_MAX ? (QnId) body : QN_NONE;
}

static void
update (QnCurveView *self)
{
  QnDocument *document = qn_view_state_get_document (self->state);
  QnJob *job = qn_document_get_job (document);
  const QnRun *run = qn_document_get_run (document);
  qn_curve_clear (&self->curve);
  self->curve = (QnCurve){ 0 };
  self->live = FALSE;
  self->block = QN_NONE;
  if (job != NULL)
    take_live_curve (self, job);
  else if (run != NULL && run->result.step_count > 0
           && !qn_curve_from_result (
             &self->curve, &run->result, controlled_body (&run->model),
             run->model.analysis.control_dof, &self->block, &self->dof))
    self->curve = (QnCurve){ 0 };
  update_range (self);
  update_description (self, run);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}

/* ---- places ---- */

static double
plot_width (QnCurveView *self)
{
  return gtk_widget_get_width (GTK_WIDGET (self)) - MARGIN_LEFT - MARGIN_RIGHT;
}

static double
plot_height (QnCurveView *self)
{
  return gtk_widget_get_height (GTK_WIDGET (self)) - MARGIN_TOP - MARGIN_BOTTOM;
}

static QnVec2
to_screen (QnCurveView *self, double x, double y)
{
  double u = (x - self->x_min) / (self->x_max - self->x_min), v = y / self->y_max;
  return qn_vec2 (MARGIN_LEFT + u * plot_width (self),
                  MARGIN_TOP + (1.0 - v) * plot_height (self));
}

/* The step whose point is nearest. */
static int
step_at (QnCurveView *self, QnVec2 at)
{
  int best = QN_STEP_LAST;
  double least = INFINITY;
  for (gsize i = 0; i < self->curve.count; i++) {
    QnVec2 p = to_screen (self, self->curve.x[i], self->curve.y[i]);
    double distance = qn_vec2_length (qn_vec2_sub (p, at));
    if (distance < least) {
      least = distance;
      best = (int) i;
    }
  }
  return best;
}

/* ---- drawing ---- */

static void
draw_text (QnCurveView *self, cairo_t *cr, const char *text, double x, double y,
           double align_x, gboolean upright)
{
  g_autoptr (PangoLayout) layout =
    gtk_widget_create_pango_layout (GTK_WIDGET (self), NULL);
  g_autofree char *small = g_markup_printf_escaped ("<small>%s</small>", text);
  pango_layout_set_markup (layout, small, -1);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  cairo_save (cr);
  cairo_translate (cr, x, y);
  if (upright)
    cairo_rotate (cr, -G_PI_2);
  cairo_move_to (cr, -align_x * width, upright ? 0.0 : -0.5 * height);
  pango_cairo_show_layout (cr, layout);
  cairo_restore (cr);
}

static void
draw_y_ticks (QnCurveView *self, cairo_t *cr)
{
  double step =
    qn_magnet_round_distance (self->y_max * TICK_PX * 0.6 / plot_height (self));
  for (int i = 0; i * step <= self->y_max; i++) {
    QnVec2 p = to_screen (self, self->x_min, i * step);
    g_autofree char *text =
      qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, i * step, 4);
    cairo_move_to (cr, p.x, floor (p.y) + 0.5);
    cairo_rel_line_to (cr, plot_width (self), 0.0);
    draw_text (self, cr, text, p.x - 5.0, p.y, 1.0, FALSE);
  }
}

static void
draw_x_ticks (QnCurveView *self, cairo_t *cr)
{
  QnUnits units = qn_settings_get_units ();
  QnQuantity quantity = self->live               ? QN_QUANTITY_NUMBER
                        : self->dof == QN_DOF_RZ ? QN_QUANTITY_ANGLE
                                                 : QN_QUANTITY_LENGTH;
  double factor = qn_units_factor (units, quantity);
  double span = (self->x_max - self->x_min) / factor;
  double step = qn_magnet_round_distance (span * TICK_PX / plot_width (self));
  for (double i = ceil (self->x_min / factor / step); i * step * factor <= self->x_max;
       i++) {
    QnVec2 p = to_screen (self, i * step * factor, 0.0);
    g_autofree char *text =
      qn_units_format (units, quantity, i == 0.0 ? 0.0 : i * step * factor, 4);
    cairo_move_to (cr, floor (p.x) + 0.5, p.y);
    cairo_rel_line_to (cr, 0.0, 4.0);
    draw_text (self, cr, text, p.x, p.y + 11.0, 0.5, FALSE);
  }
}

static void
draw_x_label (QnCurveView *self, cairo_t *cr)
{
  static const char *const components[] = { "ux", "uy", "rz" };
  double x = MARGIN_LEFT + 0.5 * plot_width (self);
  double y = gtk_widget_get_height (GTK_WIDGET (self)) - 7.0;
  if (self->live) {
    draw_text (self, cr, _ ("Step"), x, y, 0.5, FALSE);
    return;
  }
  const QnRun *run = qn_document_get_run (qn_view_state_get_document (self->state));
  if (run == NULL || self->block == QN_NONE)
    return;
  QnQuantity quantity = self->dof == QN_DOF_RZ ? QN_QUANTITY_ANGLE : QN_QUANTITY_LENGTH;
  g_autofree char *text = g_strdup_printf (
    "%s, %s (%s)", components[self->dof], qn_result_body_name (&run->model, self->block),
    qn_units_symbol (qn_settings_get_units (), quantity));
  draw_text (self, cr, text, x, y, 0.5, FALSE);
}

static void
draw_points (QnCurveView *self, cairo_t *cr, const GdkRGBA *ink)
{
  for (gsize i = 0; i < self->curve.count; i++) {
    QnVec2 p = to_screen (self, self->curve.x[i], self->curve.y[i]);
    cairo_line_to (cr, p.x, p.y);
  }
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.85);
  cairo_set_line_width (cr, 2.0);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke (cr);
  gdk_cairo_set_source_rgba (cr, ink);
  cairo_set_line_width (cr, 1.5);
  if (self->curve.collapse_point >= 0 && !self->live
      && (gsize) self->curve.collapse_point < self->curve.count) {
    QnVec2 p = to_screen (self, self->curve.x[self->curve.collapse_point],
                          self->curve.y[self->curve.collapse_point]);
    cairo_move_to (cr, p.x - 5.0, p.y - 5.0);
    cairo_line_to (cr, p.x + 5.0, p.y + 5.0);
    cairo_move_to (cr, p.x - 5.0, p.y + 5.0);
    cairo_line_to (cr, p.x + 5.0, p.y - 5.0);
    cairo_stroke (cr);
  }
  if (self->curve.limit_point >= 0 && !self->live
      && (gsize) self->curve.limit_point < self->curve.count) {
    QnVec2 p = to_screen (self, self->curve.x[self->curve.limit_point],
                          self->curve.y[self->curve.limit_point]);
    cairo_move_to (cr, p.x, p.y - 6.0);
    cairo_line_to (cr, p.x + 5.0, p.y);
    cairo_line_to (cr, p.x, p.y + 6.0);
    cairo_line_to (cr, p.x - 5.0, p.y);
    cairo_close_path (cr);
    cairo_stroke (cr);
  }
}

static void
draw_cursor (QnCurveView *self, cairo_t *cr)
{
  int step = qn_view_state_get_step (self->state);
  if (self->live || self->curve.count == 0)
    return;
  gsize i = step == QN_STEP_LAST ? self->curve.count - 1 : (gsize) step;
  if (i >= self->curve.count)
    return;
  QnVec2 p = to_screen (self, self->curve.x[i], self->curve.y[i]);
  cairo_set_source_rgb (cr, 0.9, 0.35, 0.0);
  cairo_set_line_width (cr, 1.0);
  cairo_move_to (cr, floor (p.x) + 0.5, MARGIN_TOP);
  cairo_rel_line_to (cr, 0.0, plot_height (self));
  cairo_stroke (cr);
  cairo_arc (cr, p.x, p.y, 5.0, 0.0, 2.0 * G_PI);
  cairo_fill (cr);
}

static void
draw (QnCurveView *self, cairo_t *cr)
{
  GdkRGBA ink;
  gtk_style_context_get_color (gtk_widget_get_style_context (GTK_WIDGET (self)), &ink);
  GdkRGBA faint = ink;
  faint.alpha = 0.25f;
  cairo_set_line_width (cr, 1.0);
  gdk_cairo_set_source_rgba (cr, &ink);
  draw_y_ticks (self, cr);
  draw_x_ticks (self, cr);
  draw_x_label (self, cr);
  draw_text (self, cr, _ ("Load multiplier"), 2.0, MARGIN_TOP + 0.5 * plot_height (self),
             0.5, TRUE);
  gdk_cairo_set_source_rgba (cr, &faint);
  cairo_stroke (cr);
  draw_points (self, cr, &ink);
  draw_cursor (self, cr);
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
  draw (self, cr);
  cairo_destroy (cr);
  if (gtk_widget_has_focus (widget))
    gtk_snapshot_render_focus (snapshot, gtk_widget_get_style_context (widget), 1, 1,
                               width - 2, height - 2);
}

/* ---- hand ---- */

static void
go_to (QnCurveView *self, double x, double y)
{
  int step = step_at (self, qn_vec2 (x, y));
  if (self->live || step == QN_STEP_LAST)
    return;
  if (!qn_view_needs_result (qn_view_state_get_view (self->state))
      || qn_view_state_get_view (self->state) == QN_VIEW_MECHANISM)
    qn_view_state_set_view (self->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (self->state, step);
}

static void
on_drag_begin (GtkGestureDrag *gesture, double x, double y, QnCurveView *self)
{
  (void) gesture;
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

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnCurveView *self)
{
  (void) controller;
  (void) keycode;
  (void) modifiers;
  if (keyval == GDK_KEY_Left)
    gtk_widget_activate_action (GTK_WIDGET (self), "win.previous-step", NULL);
  else if (keyval == GDK_KEY_Right)
    gtk_widget_activate_action (GTK_WIDGET (self), "win.next-step", NULL);
  else
    return FALSE;
  return TRUE;
}

static void
qn_curve_view_measure (GtkWidget *widget, GtkOrientation orientation, int for_size,
                       int *minimum, int *natural, int *minimum_baseline,
                       int *natural_baseline)
{
  (void) widget;
  (void) for_size;
  *minimum = *natural = orientation == GTK_ORIENTATION_VERTICAL ? LEAST_HEIGHT : 200;
  *minimum_baseline = *natural_baseline = -1;
}

static void
qn_curve_view_finalize (GObject *object)
{
  QnCurveView *self = QN_CURVE_VIEW (object);
  qn_curve_clear (&self->curve);
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
