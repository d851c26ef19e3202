#include "app/forms/joint-view.h"

#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/text/explain.h"
#include <glib/gi18n.h>
#include <stdlib.h>

/* The plot's text over that of the window: it is small. */
#define TEXT_SHARE 0.8

static void
free_plot (gpointer data)
{
  QnJointPlot *plot = data;
  free (plot->points);
  g_free (plot);
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  QnJointPlot plot = *(QnJointPlot *) data;
  if (plot.count == 0)
    return;
  QnUnits units = qn_settings_get_units ();
  const char *force = qn_units_symbol (units, QN_QUANTITY_FORCE);
  g_autofree char *normal = g_strdup_printf (_ ("N, %s"), force);
  g_autofree char *shear = g_strdup_printf (_ ("T, %s"), force);
  g_autofree char *size = qn_units_format (units, QN_QUANTITY_LENGTH, plot.length, 4);
  g_autofree char *along = g_strdup_printf (_ ("along the joint, %s %s"), size,
                                            qn_units_symbol (units, QN_QUANTITY_LENGTH));
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
  QnJointPlot *plot = g_new0 (QnJointPlot, 1);
  g_object_set_data_full (G_OBJECT (area), "qn-plot", plot, free_plot);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw, plot, NULL);
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
  QnJointPlot *own = g_object_get_data (G_OBJECT (area), "qn-plot");
  free (own->points);
  *own = *plot;
  g_autofree char *description = dup_description (plot);
  gtk_accessible_update_property (GTK_ACCESSIBLE (area),
                                  GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, description, -1);
  gtk_widget_queue_draw (area);
}
