#include "app/forms/law-view.h"

#include "app/widgets/plot-view.h"
#include "doc/text/law-text.h"

/* m: of the block's side, where a law speaks of strains. */
#define TYPICAL_LENGTH 0.1

typedef struct View {
  QnLawPreset what;
  GArray *samples; /* of QnLawSample; empty where the law snaps back */
} View;

static void
free_view (gpointer data)
{
  View *view = data;
  g_array_unref (view->samples);
  g_free (view);
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  const View *view = data;
  return view->samples->len > 0 ? qn_law_plot (&view->what, view->samples) : NULL;
}

void
qn_law_view_init (GtkWidget *area)
{
  static const QnPlotHand hand = { .make = make_plot };
  View *view = g_new0 (View, 1);
  view->samples = g_array_new (FALSE, FALSE, sizeof (QnLawSample));
  g_object_set_data_full (G_OBJECT (area), "qn-view", view, free_view);
  qn_plot_view_init (area, &hand, view);
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
  qn_plot_view_fit (area);
}
