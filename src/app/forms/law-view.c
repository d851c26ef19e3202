#include "app/forms/law-view.h"

#include "app/widgets/text-unit.h"
#include "doc/text/law-trace.h"

/* m: of the block's side, where a law speaks of strains. */
#define TYPICAL_LENGTH 0.1

typedef struct View {
  QnLawPreset what;
  GArray *samples; /* of QnLawSample; empty where the law snaps back */
} View;

static void
on_gone (gpointer data, GObject *where)
{
  View *view = data;
  g_array_unref (view->samples);
  g_free (view);
}

/* Plots are on paper, in dark windows too. */
static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const View *view = data;
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  if (view->samples->len > 0) {
    QnCurve curve;
    QnCurvePlot plot;
    qn_law_plot (&view->what, view->samples, &curve, &plot);
    QnPage page = { width, height, qn_text_unit (GTK_WIDGET (area)), true, false, NULL };
    qn_curve_plot_draw (&plot, cr, &page, 6.0, 6.0, width - 12.0, height - 12.0);
    qn_curve_clear (&curve);
  }
}

void
qn_law_view_init (GtkWidget *area)
{
  View *view = g_new0 (View, 1);
  view->samples = g_array_new (FALSE, FALSE, sizeof (QnLawSample));
  g_object_set_data (G_OBJECT (area), "qn-view", view);
  g_object_weak_ref (G_OBJECT (area), on_gone, view);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (area), draw, view, NULL);
}

void
qn_law_view_set_law (GtkWidget *area, const QnLaw *law)
{
  View *view = g_object_get_data (G_OBJECT (area), "qn-view");
  view->what = qn_law_preset_for (law);
  view->what.law.name = view->what.law.source = NULL; /* not ours */
  g_array_set_size (view->samples, 0);
  qn_law_trace (&view->what, law->basis == QN_BASIS_MATERIAL ? TYPICAL_LENGTH : 1.0,
                view->samples);
  gtk_widget_queue_draw (area);
}
