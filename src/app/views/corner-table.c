/* The corners of the selected block by their coordinates. */
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/quantity-entry.h"
#include "doc/edit/edit-shape.h"
#include <glib/gi18n.h>

/* A block with more corners is a curve: its table would be as long as the window is high. */
#define MOST_CORNERS 40
#define FARTHEST     1e6

typedef struct Table {
  QnCanvas *canvas;
  GtkWidget *expander, *grid;
  GtkWidget *entries[MOST_CORNERS][2]; /* x, y */
  QnId count;                          /* of rows */
} Table;

/* The only block that is selected, or QN_NONE. */
static QnId
selected_block (Table *table)
{
  const QnPartSet set = qn_canvas_get_parts (table->canvas);
  return set.blocks.count == 1 && set.beams.count == 0 ? set.blocks.ids[0] : QN_NONE;
}

static void
on_committed (QnQuantityEntry *entry, Table *table)
{
  QnId block = selected_block (table);
  const QnModel *model = qn_canvas_get_model (table->canvas);
  if (block == QN_NONE || (gsize) block >= model->block_count)
    return;
  const QnVec2 *v = qn_model_block_vertices (model, block);
  for (QnId k = 0; k < MIN (table->count, model->blocks[block].vertex_count); k++) {
    QnVec2 to = v[k];
    if (GTK_WIDGET (entry) == table->entries[k][0])
      to.x = qn_quantity_entry_get_value (entry);
    else if (GTK_WIDGET (entry) == table->entries[k][1])
      to.y = qn_quantity_entry_get_value (entry);
    else
      continue;
    QnCanvasDraft draft;
    const QnVec2 from = v[k];
    if (!qn_canvas_begin_edit (table->canvas, &draft)
        || !qn_canvas_end_edit (table->canvas, &draft, _ ("Move Corner"), NULL,
                                qn_edit_move_corner (draft.model,
                                                     (QnBlockSet){ &block, 1 }, from, to,
                                                     &draft.error)))
      qn_quantity_entry_refuse (entry, _ ("No block has this shape"));
    return;
  }
}

static GtkWidget *
new_entry (Table *table, QnId corner, int axis)
{
  GtkWidget *entry = qn_quantity_entry_new (QN_QUANTITY_LENGTH, -FARTHEST, FARTHEST);
  g_autofree char *name = g_strdup_printf (
    axis == 0 ? _ ("Corner %d, x") : _ ("Corner %d, y"), (int) corner + 1);
  gtk_accessible_update_property (GTK_ACCESSIBLE (entry), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  name, -1);
  g_signal_connect (entry, "committed", G_CALLBACK (on_committed), table);
  gtk_widget_set_hexpand (entry, TRUE);
  return entry;
}

static void
update (Table *table)
{
  const QnModel *model = qn_canvas_get_model (table->canvas);
  QnId block = selected_block (table);
  gboolean shown = block != QN_NONE && (gsize) block < model->block_count
                   && model->blocks[block].vertex_count <= MOST_CORNERS;
  gtk_widget_set_visible (table->expander, shown);
  if (!shown)
    return;
  const QnVec2 *v = qn_model_block_vertices (model, block);
  QnId count = model->blocks[block].vertex_count;
  while (table->count > count)
    gtk_grid_remove_row (GTK_GRID (table->grid), --table->count);
  for (; table->count < count; table->count++) {
    g_autofree char *number = g_strdup_printf ("%d", (int) table->count + 1);
    gtk_grid_attach (GTK_GRID (table->grid), gtk_label_new (number), 0, table->count, 1,
                     1);
    for (int axis = 0; axis < 2; axis++) {
      GtkWidget *entry = new_entry (table, table->count, axis);
      table->entries[table->count][axis] = entry;
      gtk_grid_attach (GTK_GRID (table->grid), entry, 1 + axis, table->count, 1, 1);
    }
  }
  for (QnId k = 0; k < table->count; k++) {
    qn_quantity_entry_set_value (QN_QUANTITY_ENTRY (table->entries[k][0]), v[k].x);
    qn_quantity_entry_set_value (QN_QUANTITY_ENTRY (table->entries[k][1]), v[k].y);
  }
}

GtkWidget *
qn_corner_table_new (QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("corner-table");
  GtkWidget *expander = qn_builder_take_widget (builder, "corners");
  Table *table = g_new0 (Table, 1);
  table->canvas = canvas;
  table->grid = qn_builder_get_widget (builder, "grid");
  table->expander = expander;
  qn_own (expander, table);
  qn_watch (expander, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update),
            table);
  qn_watch (expander, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update),
            table);
  update (table);
  return expander;
}
