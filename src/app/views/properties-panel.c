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
  QnSelection *selection = panel->canvas->selection;
  const gboolean item = qn_selection_get_item (selection).id != QN_NONE;
  gtk_label_set_text (GTK_LABEL (panel->hint),
                      item ? _ ("Numbers of loads, bars and ties are under Analysis.")
                           : _ ("Select blocks, beams or an opening, or joints in the "
                                "contacts view, to change them here."));
  gtk_widget_set_visible (panel->hint, item || qn_selection_is_empty (selection));
}

GtkWidget *
qn_properties_panel_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("properties-panel");
  GtkWidget *box = qn_builder_take_widget (builder, "panel");
  Panel *panel = g_new (Panel, 1);
  *panel = (Panel){ canvas, qn_builder_get_widget (builder, "hint") };
  static const QnFormKind *const parts[] = {
    &qn_block_form,      &qn_place_form,   NULL,
    &qn_wall_form,       &qn_opening_form, &qn_masonry_form,
    &qn_face_form,       &qn_beam_form,    &qn_first_end_form,
    &qn_second_end_form, &qn_section_form, &qn_array_form
  };
  gtk_box_prepend (GTK_BOX (box), qn_form_show (qn_form_new (&qn_style_form, canvas)));
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++) /* the table is no form */
    gtk_box_append (GTK_BOX (box), parts[i] != NULL
                                     ? qn_form_show (qn_form_new (parts[i], canvas))
                                     : qn_corner_table_new (canvas));
  qn_own (box, panel);
  qn_watch (box, canvas->selection, "changed", G_CALLBACK (update), panel);
  update (panel);
  return box;
}
