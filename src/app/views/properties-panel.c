#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include <glib/gi18n.h>

typedef struct Panel {
  QnCanvas *canvas;
  GtkWidget *hint;
} Panel;

/* Where nothing is selected that has a form here. */
static void
update (Panel *panel)
{
  QnSelection *selection = qn_canvas_get_selection (panel->canvas);
  gboolean item = FALSE, empty = qn_selection_is_empty (selection);
  for (int kind = 0; kind < QN_ITEM_COUNT; kind++)
    item = item || qn_selection_get_item (selection, (QnItemKind) kind) != QN_NONE;
  gtk_label_set_text (GTK_LABEL (panel->hint),
                      item ? _ ("Numbers of loads, bars and ties are under Analysis.")
                           : _ ("Select blocks, beams or an opening, or joints in the "
                                "contacts view, to change them here."));
  gtk_widget_set_visible (panel->hint, item || empty);
}

GtkWidget *
qn_properties_panel_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("properties-panel");
  GtkWidget *box = qn_builder_take_widget (builder, "panel");
  Panel *panel = g_new (Panel, 1);
  *panel = (Panel){ canvas, qn_builder_get_widget (builder, "hint") };
  GtkWidget *parts[] = {
    qn_style_form_new (canvas),       qn_block_form_new (canvas),
    qn_place_form_new (canvas),       qn_corner_table_new (canvas),
    qn_wall_form_new (canvas),        qn_opening_form_new (canvas),
    qn_masonry_form_new (canvas),     qn_face_form_new (canvas),
    qn_beam_form_new (canvas),        qn_beam_end_form_new (canvas, 0),
    qn_beam_end_form_new (canvas, 1), qn_section_form_new (canvas),
    qn_array_form_new (canvas)
  };
  gtk_box_prepend (GTK_BOX (box), parts[0]);
  for (gsize i = 1; i < G_N_ELEMENTS (parts); i++)
    gtk_box_append (GTK_BOX (box), parts[i]);
  qn_own (box, panel);
  qn_watch (box, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return box;
}
