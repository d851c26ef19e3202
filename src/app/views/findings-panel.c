#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/quantity-entry.h"
#include "doc/edit/repair.h"
#include "doc/text/explain.h"
#include <glib/gi18n.h>

/* Findings listed at most; more would be a wall of text, the rest is marked in the drawing. */
#define MOST_ROWS 200

typedef struct Panel {
  QnCanvas *canvas;
  GtkWidget *form, *list;
  QnQuantityEntry *gap_width;
  double chosen_width; /* of gaps, m; 0: the usual one */
} Panel;

/* What a button of a row does. */
typedef struct Fix {
  QnFinding finding;
  QnRepair repair;
} Fix;

/* ---- repairs ---- */

static void
on_fix (GtkButton *button, Panel *panel)
{
  /* The end of the edit makes the list anew, and with it this button goes. */
  const Fix *fix = g_object_get_data (G_OBJECT (button), "qn-fix");
  QnCanvasDraft draft;
  if (qn_canvas_begin_edit (panel->canvas, &draft))
    qn_canvas_end_edit (
      panel->canvas, &draft, _ (qn_repair_words[fix->repair].step), NULL,
      qn_edit_repair (draft.model, &fix->finding, fix->repair, &draft.error));
}

static void
on_repair_all (Panel *panel)
{
  guint count = 0;
  QnCanvasDraft draft;
  if (!qn_canvas_begin_edit (panel->canvas, &draft)
      || !qn_canvas_end_edit (panel->canvas, &draft, _ ("Repair Contacts"), NULL,
                              qn_edit_repair_all (draft.model, &count, &draft.error)))
    return;
  gsize left = panel->canvas->document->contacts.findings.count;
  g_autofree char *repaired = g_strdup_printf (
    ngettext ("%u finding repaired.", "%u findings repaired.", count), count);
  g_autofree char *rest = g_strdup_printf (
    ngettext ("%zu is left: choose what is to be done with it.",
              "%zu are left: choose what is to be done with them.", left),
    left);
  g_autofree char *message = g_strdup_printf ("%s %s", repaired, rest);
  if (left > 0)
    qn_canvas_tell (panel->canvas, message);
}

static void
add_fixes (Panel *panel, GtkWidget *box, const QnModel *model, const QnFinding *finding,
           gboolean gaps)
{
  QnRepair choices[QN_REPAIR_COUNT];
  guint count = qn_repair_get_choices (model, finding, gaps, choices);
  for (guint i = 0; i < count; i++) {
    GtkWidget *button = gtk_button_new_with_label (_ (qn_repair_words[choices[i]].label));
    Fix *fix = g_new (Fix, 1);
    *fix = (Fix){ *finding, choices[i] };
    g_autofree char *what = qn_repair_explain (model, finding, choices[i]);
    gtk_widget_set_tooltip_text (button, what);
    gtk_accessible_update_property (GTK_ACCESSIBLE (button),
                                    GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, what, -1);
    g_object_set_data_full (G_OBJECT (button), "qn-fix", fix, g_free);
    g_signal_connect (button, "clicked", G_CALLBACK (on_fix), panel);
    gtk_flow_box_append (GTK_FLOW_BOX (box), button);
    gtk_widget_set_focusable (gtk_widget_get_parent (button), FALSE);
  }
  gtk_widget_set_visible (box, count > 0);
}

/* ---- the list ---- */

static void
on_row_activated (GtkListBox *list, GtkListBoxRow *row, Panel *panel)
{
  const QnContacts *contacts = &panel->canvas->document->contacts;
  int index = gtk_list_box_row_get_index (row);
  if (index < 0 || (gsize) index >= contacts->findings.count)
    return;
  const QnFinding *finding = &contacts->findings.items[index];
  QnId blocks[] = { finding->block_a, finding->block_b };
  guint count = (finding->block_a != QN_NONE) + (finding->block_b != QN_NONE);
  qn_view_state_set_view (panel->canvas->state, QN_VIEW_CONTACTS);
  qn_selection_set (panel->canvas->selection, QN_PICK_BLOCK, blocks, count);
  if (qn_finding_has_place (finding))
    qn_canvas_show_place (panel->canvas, finding->at);
}

static GMenuModel *
make_row_menu (GtkWidget *box, QnMenuPlace *place, gpointer data)
{
  Panel *panel = data;
  on_row_activated (NULL, GTK_LIST_BOX_ROW (gtk_widget_get_parent (box)), panel);
  GMenu *menu = g_menu_new ();
  qn_menu_add_target (
    menu, _ ("_Copy Text"), "win.copy-text",
    g_variant_new_string (g_object_get_data (G_OBJECT (box), "qn-text")));
  g_menu_append (menu, _ ("_Fit"), "win.fit");
  return G_MENU_MODEL (menu);
}

/* Marks the joints of mortar that would be closed, and says how many and how wide they are. Returns
 * whether blocks stand apart by mortar at all: such are not fixed to the ground. */
static gboolean
update_gaps (Panel *panel, const QnModel *model)
{
  double usual = ceil (1e3 * qn_model_usual_gap (model)) * 1e-3;
  double width = panel->chosen_width > 0.0 ? panel->chosen_width : usual;
  gboolean shown = model->block_count > 1 && width > 0.0;
  QnGaps gaps = { 0 }, usual_gaps = { 0 };
  if (shown)
    qn_model_find_gaps (model, width, &gaps);
  if (shown && gaps.count == 0 && width < usual)
    qn_model_find_gaps (model, usual, &usual_gaps);
  gboolean any = gaps.count > 0, apart = any || usual_gaps.count > 0;
  gtk_widget_set_visible (qn_part (panel->form, "gap_box"), shown);
  gtk_widget_set_sensitive (qn_part (panel->form, "close_gaps"), any);
  g_autofree char *text = qn_gaps_dup_text (&gaps);
  g_autofree char *open =
    any ? g_strdup_printf (_ ("%s, marked in red: the blocks beside them do not touch."),
                           text)
        : g_strdup (_ ("No joints of mortar up to this width."));
  gtk_label_set_text (qn_part (panel->form, "gap_text"), open);
  qn_quantity_entry_set_value (panel->gap_width, width);
  if (!gtk_widget_get_mapped (panel->form))
    qn_gaps_clear (&gaps);
  qn_canvas_show_gaps (panel->canvas, &gaps);
  qn_gaps_clear (&usual_gaps);
  return apart;
}

static void
on_close_gaps (Panel *panel)
{
  double width = qn_quantity_entry_get_value (panel->gap_width);
  QnCanvasDraft draft;
  if (qn_canvas_begin_edit (panel->canvas, &draft))
    qn_canvas_end_edit (panel->canvas, &draft, _ ("Close Gaps"), NULL,
                        qn_edit_close_gaps (draft.model, width, &draft.error));
}

static void
on_mapped (Panel *panel)
{
  update_gaps (panel, qn_canvas_get_model (panel->canvas));
}

static void
on_unmapped (Panel *panel)
{
  QnGaps none = { 0 };
  qn_canvas_show_gaps (panel->canvas, &none);
}

static void
on_gap_width (Panel *panel)
{
  panel->chosen_width = qn_quantity_entry_get_value (panel->gap_width);
  on_mapped (panel);
}

static void
update (Panel *panel)
{
  const QnModel *model = &panel->canvas->document->project.model;
  const QnContacts *contacts = &panel->canvas->document->contacts;
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (panel->list)) != NULL)
    gtk_list_box_remove (GTK_LIST_BOX (panel->list), child);
  gsize shown = MIN (contacts->findings.count, MOST_ROWS);
  gboolean gaps = update_gaps (panel, model);
  for (gsize i = 0; i < shown; i++) {
    const QnFinding *finding = &contacts->findings.items[i];
    g_autoptr (GtkBuilder) builder = qn_builder_new ("finding-row");
    GtkWidget *row = qn_builder_take_widget (builder, "row");
    char *words = qn_explain_finding (model, finding);
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (builder, "text")), words);
    add_fixes (panel, qn_builder_get_widget (builder, "fixes"), model, finding, gaps);
    g_object_set_data_full (G_OBJECT (row), "qn-text", words, g_free);
    qn_context_menu_attach (row, make_row_menu, panel);
    gtk_list_box_append (GTK_LIST_BOX (panel->list), row);
  }
  gtk_widget_set_visible (panel->list, shown > 0);
  gtk_widget_set_visible (qn_part (panel->form, "repair_all"), shown > 1);

  const QnCount counts[] = { { QN_COUNTED_BLOCKS, model->block_count },
                             { QN_COUNTED_FACES, contacts->face_count },
                             { QN_COUNTED_PAIRS, contacts->pair_count } };
  g_autofree char *content = qn_counts_dup_text (counts, G_N_ELEMENTS (counts), ", ");
  g_autofree char *text = g_strdup_printf (
    "%s.\n%s", content,
    shown == 0
      ? gaps ? "" : _ ("No findings.")
      : _ ("Click a line to go to its place; triangles mark the places in the drawing."));
  gtk_label_set_text (qn_part (panel->form, "summary"), text);
}

GtkWidget *
qn_findings_panel_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("findings-panel");
  GtkWidget *form = qn_builder_take_widget (builder, "form");
  Panel *panel = g_new (Panel, 1);
  *panel = (Panel){
    .canvas = canvas,
    .form = form,
    .list = qn_builder_get_widget (builder, "list"),
    .gap_width = QN_QUANTITY_ENTRY (qn_builder_get_widget (builder, "gap_width")),
  };
  g_signal_connect (panel->list, "row-activated", G_CALLBACK (on_row_activated), panel);
  g_signal_connect_swapped (qn_part (panel->form, "repair_all"), "clicked",
                            G_CALLBACK (on_repair_all), panel);
  g_signal_connect_swapped (qn_part (panel->form, "close_gaps"), "clicked",
                            G_CALLBACK (on_close_gaps), panel);
  g_signal_connect_swapped (panel->gap_width, "committed", G_CALLBACK (on_gap_width),
                            panel);
  g_signal_connect_swapped (form, "map", G_CALLBACK (on_mapped), panel);
  g_signal_connect_swapped (form, "unmap", G_CALLBACK (on_unmapped), panel);
  qn_own (form, panel);
  qn_watch (form, canvas->document, "changed", G_CALLBACK (update), panel);
  update (panel);
  return form;
}
