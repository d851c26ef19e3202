/* HybriDFEM against limit analysis: the numbers, what each guarantees, and how they stand to each
 * other. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/document/bounds.h"
#include <glib/gi18n.h>
#include <math.h>

typedef struct Table {
  QnDocument *document;
  GtkWidget *box, *grid;
  GtkLabel *verdict;
} Table;

static GtkWidget *
make_label (const char *text, const char *css_class)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 30);
  gtk_widget_set_hexpand (label, TRUE);
  if (css_class != NULL)
    gtk_widget_add_css_class (label, css_class);
  return label;
}

static void
add_bound (Table *table, const QnBound *bound, int row)
{
  g_autofree char *value =
    isinf (bound->value) ? g_strdup ("∞") : g_strdup_printf ("%.4f", bound->value);
  GtkWidget *number = gtk_label_new (value);
  gtk_label_set_xalign (GTK_LABEL (number), 1.0f);
  gtk_widget_set_valign (number, GTK_ALIGN_START);
  gtk_widget_add_css_class (number, "numeric");
  gtk_widget_add_css_class (number, "heading");
  gtk_grid_attach (GTK_GRID (table->grid), make_label (bound->label, "heading"), 0,
                   2 * row, 1, 1);
  gtk_grid_attach (GTK_GRID (table->grid), number, 1, 2 * row, 1, 1);
  gtk_grid_attach (GTK_GRID (table->grid), make_label (bound->guarantee, "guarantee"), 0,
                   2 * row + 1, 2, 1);
}

static void
update (Table *table)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (table->grid)) != NULL)
    gtk_grid_remove (GTK_GRID (table->grid), child);
  g_autoptr (GArray) bounds = qn_bounds_collect (table->document);
  for (guint i = 0; i < bounds->len; i++)
    add_bound (table, &g_array_index (bounds, QnBound, i), (int) i);
  g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
  gtk_label_set_text (table->verdict, verdict != NULL ? verdict : "");
  gtk_widget_set_visible (GTK_WIDGET (table->verdict), verdict != NULL);
}

GtkWidget *
qn_bounds_table_new (QnDocument *document)
{
  Table *table = g_new0 (Table, 1);
  table->document = document;
  table->box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 6);
  table->verdict = GTK_LABEL (make_label (NULL, "outcome"));
  table->grid = gtk_grid_new ();
  gtk_grid_set_column_spacing (GTK_GRID (table->grid), 12);
  gtk_grid_set_row_spacing (GTK_GRID (table->grid), 2);
  GtkWidget *button = gtk_button_new_with_mnemonic (_ ("Solve by _All Methods"));
  gtk_widget_set_tooltip_text (
    button, _ ("HybriDFEM, then limit analysis with both flow rules, of the same model"));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.run-all");
  gtk_box_append (GTK_BOX (table->box), GTK_WIDGET (table->verdict));
  gtk_box_append (GTK_BOX (table->box), table->grid);
  gtk_box_append (GTK_BOX (table->box), button);

  GtkWidget *expander =
    gtk_expander_new_with_mnemonic (_ ("_HybriDFEM against limit analysis"));
  gtk_expander_set_child (GTK_EXPANDER (expander), table->box);
  gtk_expander_set_expanded (GTK_EXPANDER (expander), TRUE);
  qn_own (expander, table);
  qn_watch (expander, document, "runs-changed", G_CALLBACK (update), table);
  qn_watch (expander, document, "changed", G_CALLBACK (update), table);
  update (table);
  return expander;
}
