#include "app/forms/form.h"
#include "app/forms/joint-view.h"
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/settings.h"
#include "doc/view/inspect.h"
#include <glib/gi18n.h>

typedef struct Inspector {
  QnCanvas *canvas;
  GtkWidget *box, *title, *rows, *diagram;
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

/* A single joint or block is selected. */
static gboolean
find_selected (Inspector *inspector, QnInspected *what)
{
  QnSelection *selection = qn_canvas_get_selection (inspector->canvas);
  guint faces = 0, blocks = 0;
  const QnId *face = qn_selection_get (selection, QN_PART_FACE, &faces);
  const QnId *block = qn_selection_get (selection, QN_PART_BLOCK, &blocks);
  if (faces + blocks != 1)
    return FALSE;
  *what = faces == 1 ? (QnInspected){ QN_INSPECTED_JOINT, *face }
                     : (QnInspected){ QN_INSPECTED_BLOCK, *block };
  return TRUE;
}

/* The selection is of the document's model: a result of another one says nothing of it. */
static gboolean
has_result (Inspector *inspector)
{
  QnDocument *document = qn_canvas_get_document (inspector->canvas);
  const QnRun *run = qn_document_get_run (document);
  return run != NULL && !qn_document_is_stale (document, run);
}

static void
show_diagram (Inspector *inspector, const QnStepView *view, QnInspected what)
{
  QnJointPlot plot = { 0 };
  gboolean shown = what.kind == QN_INSPECTED_JOINT && view->pairs != NULL
                   && qn_joint_plot_fill (&plot, view->model, view->contacts,
                                          view->result, (int) view->step, what.id);
  if (shown)
    qn_joint_view_set_plot (inspector->diagram, &plot);
  gtk_widget_set_visible (inspector->diagram, shown);
}

static void
update (Inspector *inspector)
{
  QnInspected what;
  QnStepView view;
  gboolean shown = find_selected (inspector, &what) && has_result (inspector)
                   && qn_step_view_init (&view, qn_canvas_get_state (inspector->canvas));
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

GtkWidget *
qn_inspector_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("inspector");
  Inspector *inspector = g_new (Inspector, 1);
  *inspector = (Inspector){ .canvas = canvas,
                            .box = qn_builder_take_widget (builder, "inspector"),
                            .title = qn_builder_get_widget (builder, "title"),
                            .rows = qn_builder_get_widget (builder, "rows"),
                            .diagram = qn_builder_get_widget (builder, "diagram") };
  qn_joint_view_init (inspector->diagram);
  GtkWidget *box = inspector->box;
  QnDocument *document = qn_canvas_get_document (canvas);
  qn_own (box, inspector);
  qn_watch (box, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update),
            inspector);
  qn_watch (box, document, "runs-changed", G_CALLBACK (update), inspector);
  qn_watch (box, document, "changed", G_CALLBACK (update), inspector);
  qn_watch (box, qn_canvas_get_state (canvas), "changed", G_CALLBACK (update), inspector);
  qn_watch (box, qn_settings_get (), "changed", G_CALLBACK (update), inspector);
  update (inspector);
  return box;
}
