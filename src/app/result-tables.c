/* Tables of steps and contacts of the current run. Rows carry no data of their own: cells look
 * their numbers up when they come into view. */
#include "app/form.h"
#include "app/panel.h"
#include "app/settings.h"
#include "doc/explain.h"
#include "render/motion.h"
#include <glib/gi18n.h>
#include <math.h>

#define TABLE_HEIGHT 220

typedef char *(*CellFunc) (const QnRun *run, guint row);

typedef struct Table {
  QnViewState *state;
  QnCanvas *canvas; /* of contacts */
  GtkStringList *rows;
  GtkSingleSelection *selection;
} Table;

typedef struct Column {
  const Table *table;
  CellFunc cell;
} Column;

static QnRun *
run_of (const Table *table)
{
  return qn_document_get_run (qn_view_state_get_document (table->state));
}

/* ---- columns ---- */

static void
on_setup_cell (GtkSignalListItemFactory *factory, GtkListItem *item, gpointer data)
{
  (void) factory;
  (void) data;
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_xalign (GTK_LABEL (label), 1.0f);
  gtk_widget_add_css_class (label, "numeric");
  gtk_list_item_set_child (item, label);
}

static void
on_bind_cell (GtkSignalListItemFactory *factory, GtkListItem *item, Column *column)
{
  (void) factory;
  const QnRun *run = run_of (column->table);
  guint row = gtk_list_item_get_position (item);
  g_autofree char *text = run != NULL ? column->cell (run, row) : g_strdup ("");
  gtk_label_set_text (GTK_LABEL (gtk_list_item_get_child (item)), text);
}

static void
add_column (GtkWidget *view, const char *title, const Table *table, CellFunc cell)
{
  Column *data = g_new (Column, 1);
  *data = (Column){ table, cell };
  GtkListItemFactory *factory = gtk_signal_list_item_factory_new ();
  g_signal_connect (factory, "setup", G_CALLBACK (on_setup_cell), NULL);
  g_signal_connect_data (factory, "bind", G_CALLBACK (on_bind_cell), data,
                         (GClosureNotify) (gpointer) g_free, 0);
  g_autoptr (GtkColumnViewColumn) column = gtk_column_view_column_new (title, factory);
  gtk_column_view_append_column (GTK_COLUMN_VIEW (view), column);
}

static char *
dup_quantity (QnQuantity quantity, double value)
{
  return qn_units_format (qn_settings_get_units (), quantity, value, 4);
}

/* "N (kN)" */
static char *
dup_title (const char *name, QnQuantity quantity)
{
  return g_strdup_printf ("%s (%s)", name,
                          qn_units_symbol (qn_settings_get_units (), quantity));
}

/* ---- steps ---- */

static char *
cell_step (const QnRun *run, guint row)
{
  (void) run;
  return g_strdup_printf ("%u", row);
}

static char *
cell_multiplier (const QnRun *run, guint row)
{
  return row < run->result.step_count
           ? g_strdup_printf ("%.5f", run->result.steps[row].multiplier)
           : g_strdup ("");
}

static char *
cell_displacement (const QnRun *run, guint row)
{
  if (row >= run->result.step_count)
    return g_strdup ("");
  const QnMotion motion = { .model = &run->model,
                            .displacements =
                              qn_result_step_displacements (&run->result, row),
                            .linear = run->model.analysis.geometry == QN_GEOMETRY_LINEAR,
                            .scale = 1.0 };
  return dup_quantity (QN_QUANTITY_LENGTH, qn_motion_largest (&motion));
}

static char *
cell_iterations (const QnRun *run, guint row)
{
  return row < run->result.step_count
           ? g_strdup_printf ("%d", run->result.steps[row].iterations)
           : g_strdup ("");
}

static char *
cell_event (const QnRun *run, guint row)
{
  if (row >= run->result.step_count)
    return g_strdup ("");
  switch (run->result.steps[row].event) {
  case QN_EVENT_SNAP:
    return g_strdup (_ ("jump"));
  case QN_EVENT_COLLAPSE:
    return g_strdup (_ ("collapse"));
  case QN_EVENT_NONE:
  case QN_EVENT_COUNT:
    break;
  }
  return g_strdup ("");
}

/* ---- contacts ---- */

static char *
cell_blocks (const QnRun *run, guint row)
{
  if (row >= run->contacts.pair_count)
    return g_strdup ("");
  const QnContactFace *face = &run->contacts.faces[run->contacts.pairs[row].face];
  return g_strdup_printf ("%s – %s", run->model.blocks[face->a].name,
                          run->model.blocks[face->b].name);
}

static char *
cell_state (const QnRun *run, guint row)
{
  return g_strdup (row < run->result.pair_count
                     ? qn_explain_pair_state (run->result.pairs[row].state)
                     : "");
}

static char *
cell_normal (const QnRun *run, guint row)
{
  return row < run->result.pair_count
           ? dup_quantity (QN_QUANTITY_FORCE, run->result.pairs[row].normal_force)
           : g_strdup ("");
}

static char *
cell_shear (const QnRun *run, guint row)
{
  return row < run->result.pair_count
           ? dup_quantity (QN_QUANTITY_FORCE, run->result.pairs[row].shear_force)
           : g_strdup ("");
}

/* ---- building ---- */

/* A row per step or pair, without contents. */
static void
set_row_count (Table *table, gsize count, GCallback selected)
{
  guint have = g_list_model_get_n_items (G_LIST_MODEL (table->rows));
  const char **blank = g_new0 (const char *, count + 1);
  for (gsize i = 0; i < count; i++)
    blank[i] = "";
  g_signal_handlers_block_by_func (table->selection, selected, table);
  gtk_string_list_splice (table->rows, 0, have, blank);
  gtk_single_selection_set_selected (table->selection, GTK_INVALID_LIST_POSITION);
  g_signal_handlers_unblock_by_func (table->selection, selected, table);
  g_free (blank);
}

static GtkWidget *
wrap_table (GtkWidget *view, const char *title)
{
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_min_content_height (GTK_SCROLLED_WINDOW (scroller),
                                              TABLE_HEIGHT);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), view);
  gtk_widget_add_css_class (scroller, "frame");
  gtk_widget_add_css_class (view, "data-table");
  GtkWidget *expander = gtk_expander_new_with_mnemonic (title);
  gtk_expander_set_child (GTK_EXPANDER (expander), scroller);
  return expander;
}

static GtkWidget *
make_view (Table *table, GCallback selected)
{
  table->rows = gtk_string_list_new (NULL);
  table->selection = gtk_single_selection_new (G_LIST_MODEL (table->rows));
  gtk_single_selection_set_autoselect (table->selection, FALSE);
  gtk_single_selection_set_can_unselect (table->selection, TRUE);
  g_signal_connect (table->selection, "notify::selected", selected, table);
  GtkWidget *view =
    gtk_column_view_new (g_object_ref (GTK_SELECTION_MODEL (table->selection)));
  g_object_set_data_full (G_OBJECT (view), "qn-selection", table->selection,
                          g_object_unref);
  return view;
}

static void
on_step_selected (GtkSingleSelection *selection, GParamSpec *pspec, Table *table)
{
  (void) pspec;
  guint row = gtk_single_selection_get_selected (selection);
  if (row == GTK_INVALID_LIST_POSITION)
    return;
  if (qn_view_state_get_view (table->state) != QN_VIEW_DEFORMED)
    qn_view_state_set_view (table->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (table->state, (int) row);
}

static void
update_steps (Table *table)
{
  const QnRun *run = run_of (table);
  set_row_count (table, run != NULL ? run->result.step_count : 0,
                 G_CALLBACK (on_step_selected));
}

/* The row follows the slider and the curve. */
static void
follow_step (Table *table)
{
  int step = qn_view_state_get_step (table->state);
  guint row =
    step == QN_STEP_LAST || qn_view_state_get_view (table->state) != QN_VIEW_DEFORMED
      ? GTK_INVALID_LIST_POSITION
      : (guint) step;
  g_signal_handlers_block_by_func (table->selection, on_step_selected, table);
  gtk_single_selection_set_selected (table->selection, row);
  g_signal_handlers_unblock_by_func (table->selection, on_step_selected, table);
}

GtkWidget *
qn_step_table_new (QnViewState *state)
{
  Table *table = g_new0 (Table, 1);
  table->state = state;
  GtkWidget *view = make_view (table, G_CALLBACK (on_step_selected));
  g_autofree char *displacement = dup_title (_ ("Largest motion"), QN_QUANTITY_LENGTH);
  add_column (view, _ ("Step"), table, cell_step);
  add_column (view, _ ("Multiplier"), table, cell_multiplier);
  add_column (view, displacement, table, cell_displacement);
  add_column (view, _ ("Iterations"), table, cell_iterations);
  add_column (view, _ ("Event"), table, cell_event);
  GtkWidget *widget = wrap_table (view, _ ("_Steps"));
  qn_own (widget, table);
  qn_watch (widget, qn_view_state_get_document (state), "runs-changed",
            G_CALLBACK (update_steps), table);
  qn_watch (widget, state, "changed", G_CALLBACK (follow_step), table);
  update_steps (table);
  return widget;
}

static void
on_contact_selected (GtkSingleSelection *selection, GParamSpec *pspec, Table *table)
{
  (void) pspec;
  guint row = gtk_single_selection_get_selected (selection);
  const QnRun *run = run_of (table);
  if (run != NULL && row < run->contacts.pair_count)
    qn_canvas_show_place (table->canvas, run->contacts.pairs[row].point);
}

static void
update_contacts (Table *table)
{
  const QnRun *run = run_of (table);
  set_row_count (table,
                 run != NULL && run->result.pairs != NULL ? run->result.pair_count : 0,
                 G_CALLBACK (on_contact_selected));
}

GtkWidget *
qn_contact_table_new (QnCanvas *canvas)
{
  Table *table = g_new0 (Table, 1);
  table->canvas = canvas;
  table->state = qn_canvas_get_state (canvas);
  GtkWidget *view = make_view (table, G_CALLBACK (on_contact_selected));
  g_autofree char *normal = dup_title ("N", QN_QUANTITY_FORCE);
  g_autofree char *shear = dup_title ("T", QN_QUANTITY_FORCE);
  add_column (view, _ ("Blocks"), table, cell_blocks);
  add_column (view, _ ("State"), table, cell_state);
  add_column (view, normal, table, cell_normal);
  add_column (view, shear, table, cell_shear);
  GtkWidget *widget = wrap_table (view, _ ("_Contacts at the end"));
  qn_own (widget, table);
  qn_watch (widget, qn_view_state_get_document (table->state), "runs-changed",
            G_CALLBACK (update_contacts), table);
  update_contacts (table);
  return widget;
}
