#include "app/form.h"
#include "app/panel.h"
#include "doc/explain.h"
#include <glib/gi18n.h>

/* Findings listed at most; more would be a wall of text, the rest is marked in the drawing. */
#define MOST_ROWS 200

typedef struct Panel {
  QnCanvas *canvas;
  GtkWidget *list;
  GtkLabel *summary;
} Panel;

static void
on_row_activated (GtkListBox *list, GtkListBoxRow *row, Panel *panel)
{
  (void) list;
  const QnContacts *contacts =
    qn_document_get_contacts (qn_canvas_get_document (panel->canvas));
  int index = gtk_list_box_row_get_index (row);
  if (index < 0 || (gsize) index >= contacts->findings.count)
    return;
  const QnFinding *finding = &contacts->findings.items[index];
  QnId blocks[] = { finding->block_a, finding->block_b };
  guint count = (finding->block_a != QN_NONE) + (finding->block_b != QN_NONE);
  qn_view_state_set_view (qn_canvas_get_state (panel->canvas), QN_VIEW_CONTACTS);
  qn_selection_set_blocks (qn_canvas_get_selection (panel->canvas), blocks, count);
  qn_canvas_show_place (panel->canvas, finding->at);
}

static GtkWidget *
make_row (const QnModel *model, const QnFinding *finding)
{
  g_autofree char *text = qn_explain_finding (model, finding);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 8);
  GtkWidget *icon = gtk_image_new_from_icon_name ("dialog-warning-symbolic");
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_wrap_mode (GTK_LABEL (label), PANGO_WRAP_WORD_CHAR);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_box_append (GTK_BOX (box), icon);
  gtk_box_append (GTK_BOX (box), label);
  return box;
}

static void
update (Panel *panel)
{
  QnDocument *document = qn_canvas_get_document (panel->canvas);
  const QnModel *model = qn_document_get_model (document);
  const QnContacts *contacts = qn_document_get_contacts (document);
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (panel->list)) != NULL)
    gtk_list_box_remove (GTK_LIST_BOX (panel->list), child);
  gsize shown = MIN (contacts->findings.count, MOST_ROWS);
  for (gsize i = 0; i < shown; i++)
    gtk_list_box_append (GTK_LIST_BOX (panel->list),
                         make_row (model, &contacts->findings.items[i]));
  gtk_widget_set_visible (panel->list, shown > 0);

  g_autofree char *text = g_strdup_printf (
    _ ("%u blocks, %u contact faces, %u contact pairs.\n%s"), (guint) model->block_count,
    (guint) contacts->face_count, (guint) contacts->pair_count,
    shown == 0
      ? _ ("Nothing to complain of.")
      : _ ("Each line leads to its place; the triangles in the drawing mark them."));
  gtk_label_set_text (panel->summary, text);
}

GtkWidget *
qn_findings_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  panel->canvas = canvas;
  GtkWidget *form = qn_form_new ();
  qn_form_add_heading (form, _ ("Contacts Found"));
  panel->summary = qn_form_add_text (form);
  panel->list = gtk_list_box_new ();
  gtk_list_box_set_selection_mode (GTK_LIST_BOX (panel->list), GTK_SELECTION_NONE);
  gtk_widget_add_css_class (panel->list, "rich-list");
  gtk_widget_add_css_class (panel->list, "frame");
  gtk_accessible_update_property (GTK_ACCESSIBLE (panel->list),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Findings"), -1);
  g_signal_connect (panel->list, "row-activated", G_CALLBACK (on_row_activated), panel);
  qn_form_add_wide (form, panel->list);
  qn_own (form, panel);
  qn_watch (form, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return form;
}
