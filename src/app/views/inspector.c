#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/settings.h"
#include "app/widgets/text-unit.h"
#include "doc/text/explain.h"
#include "doc/view/inspect.h"
#include "render/figure/joint-plot.h"
#include <glib/gi18n.h>

/* The plot's text over that of the window: it is small. */
#define TEXT_SHARE 0.8

typedef struct Inspector {
  QnCanvas *canvas;
  GtkWidget *box, *title, *rows, *diagram;
  QnPlot *plots[2]; /* of the forces in a joint; NULL: none is shown */
} Inspector;

static GtkWidget *
new_label (const char *text, gboolean value)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0F);
  /* A grid whose columns both wrap asks for too little height. */
  gtk_label_set_wrap (GTK_LABEL (label), value);
  gtk_label_set_selectable (GTK_LABEL (label), value);
  /* Numbers are copied by the mouse; the keys keep to the fields. */
  gtk_widget_set_focusable (label, FALSE);
  gtk_widget_set_hexpand (label, value);
  gtk_widget_set_valign (label, GTK_ALIGN_START);
  gtk_widget_add_css_class (label, value ? "numeric" : "dim-label");
  return label;
}

static void
draw (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const Inspector *inspector = data;
  if (inspector->plots[0] != NULL)
    qn_joint_plots_draw (inspector->plots, cr, width, height,
                         TEXT_SHARE * qn_text_unit (GTK_WIDGET (area)));
}

static void
clear_plots (Inspector *inspector)
{
  g_clear_pointer (&inspector->plots[1], qn_plot_free);
  g_clear_pointer (&inspector->plots[0], qn_plot_free);
}

static void
make_plots (Inspector *inspector, const QnStepView *view, QnId face)
{
  const QnUnits units = qn_settings_get_units ();
  const char *force = qn_units_symbol (units, QN_QUANTITY_FORCE);
  const double length = view->contacts->faces[face].length;
  qn_joint_plots_init (inspector->plots, view->model, view->contacts, view->pairs, face);
  QnPlot *cone = inspector->plots[0], *along = inspector->plots[1];
  g_autofree char *size = qn_units_format (units, QN_QUANTITY_LENGTH, length, 4);
  cone->x.label = along->y.label =
    qn_plot_keep (cone, g_strdup_printf (_ ("N, %s"), force));
  cone->y.label = qn_plot_keep (cone, g_strdup_printf (_ ("T, %s"), force));
  along->x.label =
    qn_plot_keep (along, g_strdup_printf (_ ("along the joint, %s %s"), size,
                                          qn_units_symbol (units, QN_QUANTITY_LENGTH)));
  cone->x.factor = cone->y.factor = along->y.factor =
    1 / qn_units_factor (units, QN_QUANTITY_FORCE);
  along->x.factor = 1 / qn_units_factor (units, QN_QUANTITY_LENGTH);
}

static void
show_diagram (Inspector *inspector, const QnStepView *view, QnPick what)
{
  const gboolean shown = what.kind == QN_PICK_FACE && view->pairs != NULL;
  g_autofree char *description = NULL; /* the plots in words */
  clear_plots (inspector);
  if (shown) {
    const QnJointReading reading =
      qn_joint_reading (view->contacts, what.id, view->pairs);
    description = qn_explain_pairs (reading.states);
    make_plots (inspector, view, what.id);
  }
  gtk_accessible_update_property (GTK_ACCESSIBLE (inspector->diagram),
                                  GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                  description != NULL ? description : "", -1);
  gtk_widget_set_visible (inspector->diagram, shown);
  gtk_widget_queue_draw (inspector->diagram);
}

static void
update (Inspector *inspector)
{
  QnDocument *document = inspector->canvas->document;
  QnSelection *selection = inspector->canvas->selection;
  const guint faces = selection->ids[QN_PICK_FACE]->len;
  const QnPickKind kind = faces > 0 ? QN_PICK_FACE : QN_PICK_BLOCK;
  const QnPick what = { kind, qn_selection_get_one (selection, kind) };
  QnStepView view;
  /* A single joint or block, of the document's model: a result of another one says nothing of it. */
  gboolean shown = faces + selection->ids[QN_PICK_BLOCK]->len == 1
                   && document->run != NULL
                   && !qn_document_is_stale (document, document->run)
                   && qn_step_view_init (&view, inspector->canvas->state);
  gtk_widget_set_visible (inspector->box, shown);
  if (!shown)
    return;
  g_autofree char *title = qn_inspect_dup_title (&view, what);
  g_autofree char *values =
    qn_inspect_dup_values (&view, what, qn_settings_get_units (), FALSE);
  gtk_widget_set_visible (inspector->box, title != NULL && values != NULL);
  if (title != NULL && values != NULL) {
    gtk_label_set_text (GTK_LABEL (inspector->title), title);
    /* Lines of a name and a value. */
    g_auto (GStrv) lines = g_strsplit (values, "\n", -1);
    GtkWidget *row;
    while ((row = gtk_widget_get_first_child (inspector->rows)) != NULL)
      gtk_grid_remove (GTK_GRID (inspector->rows), row);
    for (int i = 0; lines[i] != NULL; i++) {
      g_auto (GStrv) parts = g_strsplit (lines[i], "\t", 2);
      gtk_grid_attach (GTK_GRID (inspector->rows), new_label (parts[0], FALSE), 0, i, 1,
                       1);
      gtk_grid_attach (GTK_GRID (inspector->rows), new_label (parts[1], TRUE), 1, i, 1,
                       1);
    }
    show_diagram (inspector, &view, what);
  }
  qn_step_view_clear (&view);
}

static void
inspector_free (gpointer data, GObject *box)
{
  Inspector *inspector = data;
  clear_plots (inspector);
  g_free (inspector);
}

GtkWidget *
qn_inspector_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("inspector");
  Inspector *inspector = g_new0 (Inspector, 1);
  *inspector = (Inspector){ .canvas = canvas,
                            .box = qn_builder_take_widget (builder, "inspector"),
                            .title = qn_builder_get_widget (builder, "title"),
                            .rows = qn_builder_get_widget (builder, "rows"),
                            .diagram = qn_builder_get_widget (builder, "diagram") };
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (inspector->diagram), draw, inspector,
                                  NULL);
  GtkWidget *box = inspector->box;
  g_object_weak_ref (G_OBJECT (box), inspector_free, inspector);
  qn_watch (box, canvas->selection, "changed", G_CALLBACK (update), inspector);
  qn_watch (box, canvas->document, "runs-changed", G_CALLBACK (update), inspector);
  qn_watch (box, canvas->document, "changed", G_CALLBACK (update), inspector);
  qn_watch (box, canvas->state, "changed", G_CALLBACK (update), inspector);
  qn_watch (box, qn_settings_get (), "changed", G_CALLBACK (update), inspector);
  update (inspector);
  return box;
}
