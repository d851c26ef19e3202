#include "app/forms/form.h"
#include "app/forms/panel.h"
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

static GtkWidget *
new_hint (void)
{
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 36);
  gtk_widget_add_css_class (label, "dim-label");
  gtk_widget_set_margin_start (label, 12);
  gtk_widget_set_margin_end (label, 12);
  gtk_widget_set_margin_top (label, 12);
  return label;
}

GtkWidget *
qn_properties_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  panel->canvas = canvas;
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  panel->hint = new_hint ();
  GtkWidget *parts[] = {
    qn_style_form_new (canvas),       panel->hint,
    qn_block_form_new (canvas),       qn_place_form_new (canvas),
    qn_corner_table_new (canvas),     qn_wall_form_new (canvas),
    qn_opening_form_new (canvas),     qn_masonry_form_new (canvas),
    qn_face_form_new (canvas),        qn_beam_form_new (canvas),
    qn_beam_end_form_new (canvas, 0), qn_beam_end_form_new (canvas, 1),
    qn_section_form_new (canvas),     qn_array_form_new (canvas)
  };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++)
    gtk_box_append (GTK_BOX (box), parts[i]);
  qn_own (box, panel);
  qn_watch (box, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return box;
}
