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
  int count; /* of its rows: number, x, y */
} Table;

/* The only block that is selected, or QN_NONE. */
static QnId
selected_block (Table *table)
{
  const QnPartSet set = qn_selection_get_parts (table->canvas->selection);
  return set.blocks.count == 1 && set.beams.count == 0 ? set.blocks.ids[0] : QN_NONE;
}

static void
on_committed (QnQuantityEntry *entry, Table *table)
{
  QnId block = selected_block (table);
  const QnModel *model = qn_canvas_get_model (table->canvas);
  int column, corner;
  gtk_grid_query_child (GTK_GRID (table->grid), GTK_WIDGET (entry), &column, &corner,
                        NULL, NULL);
  if (block == QN_NONE || (gsize) block >= model->block_count
      || corner >= model->blocks[block].vertex_count)
    return;
  QnCanvasDraft draft;
  const QnVec2 from = qn_model_block_vertices (model, block)[corner];
  QnVec2 to = from;
  *(column == 1 ? &to.x : &to.y) = qn_quantity_entry_get_value (entry);
  if (!qn_canvas_begin_edit (table->canvas, &draft)
      || !qn_canvas_end_edit (table->canvas, &draft, _ ("Move Corner"), NULL,
                              qn_edit_move_corner (draft.model, (QnBlockSet){ &block, 1 },
                                                   from, to, &draft.error)))
    qn_quantity_entry_refuse (entry, _ ("No block has this shape"));
}

static GtkWidget *
new_entry (Table *table, int corner, int axis)
{
  GtkWidget *entry = qn_quantity_entry_new (QN_QUANTITY_LENGTH, -FARTHEST, FARTHEST);
  g_autofree char *name =
    g_strdup_printf (axis == 0 ? _ ("Corner %d, x") : _ ("Corner %d, y"), corner + 1);
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
  const int count = model->blocks[block].vertex_count;
  GtkGrid *grid = GTK_GRID (table->grid);
  while (table->count > count)
    gtk_grid_remove_row (grid, --table->count);
  for (; table->count < count; table->count++) {
    g_autofree char *number = g_strdup_printf ("%d", table->count + 1);
    gtk_grid_attach (grid, gtk_label_new (number), 0, table->count, 1, 1);
    for (int axis = 0; axis < 2; axis++)
      gtk_grid_attach (grid, new_entry (table, table->count, axis), 1 + axis,
                       table->count, 1, 1);
  }
  for (int k = 0; k < count; k++)
    for (int axis = 0; axis < 2; axis++)
      qn_quantity_entry_set_value (
        QN_QUANTITY_ENTRY (gtk_grid_get_child_at (grid, 1 + axis, k)),
        axis == 0 ? v[k].x : v[k].y);
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
  qn_watch (expander, canvas->selection, "changed", G_CALLBACK (update), table);
  qn_watch (expander, canvas->document, "changed", G_CALLBACK (update), table);
  update (table);
  return expander;
}
