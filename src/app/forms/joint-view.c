#include "app/forms/joint-view.h"

#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/text/explain.h"
#include <glib/gi18n.h>
#include <stdlib.h>

/* The plot's text over that of the window: it is small. */
#define TEXT_SHARE 0.8

typedef struct View {
  QnJointPlot plot;
} View;

static void
on_gone (gpointer data, GObject *where)
{
  View *view = data;
  free (view->plot.points);
  g_free (view);
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  View *view = data;
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  if (view->plot.count == 0)
    return;
  QnUnits units = qn_settings_get_units ();
  const char *force = qn_units_symbol (units, QN_QUANTITY_FORCE);
  g_autofree char *normal = g_strdup_printf (_ ("N, %s"), force);
  g_autofree char *shear = g_strdup_printf (_ ("T, %s"), force);
  g_autofree char *size =
    qn_units_format (units, QN_QUANTITY_LENGTH, view->plot.length, 4);
  g_autofree char *along = g_strdup_printf (_ ("along the joint, %s %s"), size,
                                            qn_units_symbol (units, QN_QUANTITY_LENGTH));
  QnJointPlot plot = view->plot;
  plot.force_factor = qn_units_factor (units, QN_QUANTITY_FORCE);
  plot.length_factor = qn_units_factor (units, QN_QUANTITY_LENGTH);
  plot.normal_label = normal;
  plot.shear_label = shear;
  plot.along_label = along;
  qn_joint_plot_draw (&plot, cr, width, height,
                      TEXT_SHARE * qn_text_unit (GTK_WIDGET (area)));
}

void
qn_joint_view_init (GtkWidget *area)
{
  View *view = g_new0 (View, 1);
  g_object_set_data (G_OBJECT (area), "qn-view", view);
  g_object_weak_ref (G_OBJECT (area), on_gone, view);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw, view, NULL);
}

/* The plot in words. */
static char *
dup_description (const QnJointPlot *plot)
{
  guint states[QN_PAIR_STATE_COUNT] = { 0 };
  for (gsize i = 0; i < plot->count; i++)
    states[plot->points[i].state]++;
  return qn_explain_pairs (states);
}

void
qn_joint_view_set_plot (GtkWidget *area, const QnJointPlot *plot)
{
  View *view = g_object_get_data (G_OBJECT (area), "qn-view");
  free (view->plot.points);
  view->plot = *plot;
  g_autofree char *description = dup_description (plot);
  gtk_accessible_update_property (GTK_ACCESSIBLE (area),
                                  GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, description, -1);
  gtk_widget_queue_draw (area);
}
