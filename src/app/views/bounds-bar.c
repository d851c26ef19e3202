#include "app/views/bounds-bar.h"

#include <glib/gi18n.h>
#include <math.h>
#include <pango/pangocairo.h>

#define HEIGHT 46
#define INSET  12.0 /* px, left and right of the line */
#define LINE_Y 14.0
#define REACH  9.0 /* px: what the pointer takes for a mark */

struct _QnBoundsBar {
  GtkWidget parent_instance;
  GArray *bounds;
  double low, high; /* of the finite values, or around them */
  gboolean alike;   /* the values do not differ */
};

G_DEFINE_FINAL_TYPE (QnBoundsBar, qn_bounds_bar, GTK_TYPE_WIDGET)

double
qn_bounds_bar_place (QnBoundsBar *self, double value)
{
  double width = gtk_widget_get_width (GTK_WIDGET (self)) - 2.0 * INSET;
  if (!isfinite (value))
    return INSET + width;
  return INSET + width * (value - self->low) / (self->high - self->low);
}

static char *
dup_value (double value)
{
  return isinf (value) ? g_strdup ("∞") : g_strdup_printf ("%.4f", value);
}

/* Marks that stand on each other are told together. */
char *
qn_bounds_bar_dup_told (QnBoundsBar *self, double x)
{
  g_autoptr (GString) text = g_string_new (NULL);
  for (guint i = 0; i < self->bounds->len; i++) {
    const QnBound *bound = &g_array_index (self->bounds, QnBound, i);
    if (fabs (qn_bounds_bar_place (self, bound->value) - x) > REACH)
      continue;
    g_autofree char *value = dup_value (bound->value);
    g_string_append_printf (text, "%s%s: %s\n%s", text->len > 0 ? "\n\n" : "",
                            bound->label, value, bound->guarantee);
  }
  return text->len > 0 ? g_strdup (text->str) : NULL;
}

static void
draw_mark (cairo_t *cr, QnBoundKind kind, double x, const GdkRGBA *ink)
{
  gdk_cairo_set_source_rgba (cr, ink);
  cairo_set_line_width (cr, 2.0);
  switch (kind) {
  case QN_BOUND_PATH:
    cairo_set_source_rgb (cr, 0.9, 0.35, 0.0);
    cairo_arc (cr, x, LINE_Y, 5.5, 0.0, 2.0 * G_PI);
    cairo_fill (cr);
    return;
  case QN_BOUND_FIRST_LIMIT:
    cairo_move_to (cr, x, LINE_Y - 6.0);
    cairo_line_to (cr, x + 5.0, LINE_Y);
    cairo_line_to (cr, x, LINE_Y + 6.0);
    cairo_line_to (cr, x - 5.0, LINE_Y);
    cairo_close_path (cr);
    break;
  case QN_BOUND_LOWER:
  case QN_BOUND_UPPER:
    cairo_move_to (cr, x, LINE_Y - 9.0);
    cairo_line_to (cr, x, LINE_Y + 9.0);
    break;
  case QN_BOUND_LEAST:
  case QN_BOUND_GREATEST: {
    double tip = kind == QN_BOUND_LEAST ? 5.0 : -5.0;
    cairo_move_to (cr, x, LINE_Y);
    cairo_line_to (cr, x + tip, LINE_Y - 6.0);
    cairo_line_to (cr, x + tip, LINE_Y + 6.0);
    cairo_close_path (cr);
    cairo_fill (cr);
    return;
  }
  case QN_BOUND_KIND_COUNT:
    break;
  }
  cairo_stroke (cr);
}

static void
draw_number (QnBoundsBar *self, cairo_t *cr, double value, double align)
{
  g_autofree char *text = dup_value (value);
  g_autofree char *small = g_strdup_printf ("<small>%s</small>", text);
  g_autoptr (PangoLayout) layout =
    gtk_widget_create_pango_layout (GTK_WIDGET (self), NULL);
  pango_layout_set_markup (layout, small, -1);
  int width, height;
  pango_layout_get_pixel_size (layout, &width, &height);
  cairo_move_to (cr, align * (gtk_widget_get_width (GTK_WIDGET (self)) - width),
                 HEIGHT - height);
  pango_cairo_show_layout (cr, layout);
}

static void
qn_bounds_bar_snapshot (GtkWidget *widget, GtkSnapshot *snapshot)
{
  QnBoundsBar *self = QN_BOUNDS_BAR (widget);
  GdkRGBA ink, faint;
  if (self->bounds == NULL || self->bounds->len < 2)
    return;
  cairo_t *cr = gtk_snapshot_append_cairo (
    snapshot,
    &GRAPHENE_RECT_INIT (0, 0, (float) gtk_widget_get_width (widget), (float) HEIGHT));
  gtk_style_context_get_color (gtk_widget_get_style_context (widget), &ink);
  faint = ink;
  faint.alpha = 0.3f;
  double lower = qn_bounds_find (self->bounds, QN_BOUND_LOWER);
  double from = qn_bounds_bar_place (self, self->low);
  cairo_set_line_width (cr, 4.0);
  gdk_cairo_set_source_rgba (cr, &faint);
  cairo_move_to (cr, from, LINE_Y);
  cairo_line_to (cr, qn_bounds_bar_place (self, self->high), LINE_Y);
  cairo_stroke (cr);
  if (!isnan (lower)) {
    gdk_cairo_set_source_rgba (cr, &ink);
    cairo_move_to (cr, from, LINE_Y);
    cairo_line_to (cr, qn_bounds_bar_place (self, lower), LINE_Y);
    cairo_stroke (cr);
  }
  for (guint i = 0; i < self->bounds->len; i++) {
    const QnBound *bound = &g_array_index (self->bounds, QnBound, i);
    draw_mark (cr, bound->kind, qn_bounds_bar_place (self, bound->value), &ink);
  }
  gdk_cairo_set_source_rgba (cr, &ink);
  if (!self->alike) {
    draw_number (self, cr, self->low, 0.0);
    draw_number (self, cr, self->high, 1.0);
  }
  cairo_destroy (cr);
}

static gboolean
on_query_tooltip (GtkWidget *widget, int x, int y, gboolean keyboard, GtkTooltip *tooltip)
{
  QnBoundsBar *self = QN_BOUNDS_BAR (widget);
  g_autofree char *text =
    keyboard || self->bounds == NULL ? NULL : qn_bounds_bar_dup_told (self, x);
  gtk_tooltip_set_text (tooltip, text);
  return text != NULL;
}

static void
qn_bounds_bar_measure (GtkWidget *widget, GtkOrientation orientation, int for_size,
                       int *minimum, int *natural, int *minimum_baseline,
                       int *natural_baseline)
{
  *minimum = *natural = orientation == GTK_ORIENTATION_VERTICAL ? HEIGHT : 160;
  *minimum_baseline = *natural_baseline = -1;
}

static void
qn_bounds_bar_finalize (GObject *object)
{
  g_clear_pointer (&QN_BOUNDS_BAR (object)->bounds, g_array_unref);
  G_OBJECT_CLASS (qn_bounds_bar_parent_class)->finalize (object);
}

static void
qn_bounds_bar_class_init (QnBoundsBarClass *klass)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (klass);
  G_OBJECT_CLASS (klass)->finalize = qn_bounds_bar_finalize;
  widget_class->snapshot = qn_bounds_bar_snapshot;
  widget_class->measure = qn_bounds_bar_measure;
  widget_class->query_tooltip = on_query_tooltip;
  gtk_widget_class_set_accessible_role (widget_class, GTK_ACCESSIBLE_ROLE_IMG);
}

static void
qn_bounds_bar_init (QnBoundsBar *self)
{
  /* Multipliers grow to the right in every script, as on the axes of a curve. */
  gtk_widget_set_direction (GTK_WIDGET (self), GTK_TEXT_DIR_LTR);
  gtk_widget_set_has_tooltip (GTK_WIDGET (self), TRUE);
  gtk_widget_set_hexpand (GTK_WIDGET (self), TRUE);
}

void
qn_bounds_bar_set (QnBoundsBar *self, GArray *bounds)
{
  g_array_ref (bounds);
  g_clear_pointer (&self->bounds, g_array_unref);
  self->bounds = bounds;
  self->low = (double) INFINITY;
  self->high = (double) -INFINITY;
  g_autoptr (GString) told = g_string_new (NULL);
  for (guint i = 0; i < bounds->len; i++) {
    const QnBound *bound = &g_array_index (bounds, QnBound, i);
    g_autofree char *value = dup_value (bound->value);
    g_string_append_printf (told, "%s: %s. ", bound->label, value);
    if (!isfinite (bound->value))
      continue;
    self->low = fmin (self->low, bound->value);
    self->high = fmax (self->high, bound->value);
  }
  /* Values that are all alike stand in the middle. */
  double least = 1e-3 * fmax (fabs (self->low), 1e-9);
  self->alike = !(self->high - self->low > least);
  if (self->alike) {
    self->low -= least;
    self->high += least;
  }
  gtk_widget_set_visible (GTK_WIDGET (self), bounds->len > 1 && isfinite (self->low));
  gtk_accessible_update_property (GTK_ACCESSIBLE (self), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  _ ("Multipliers found"),
                                  GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, told->str, -1);
  gtk_widget_queue_draw (GTK_WIDGET (self));
}
