/* Tables of steps and contacts of the current run. Rows carry no data of their own: cells look
 * their numbers up when they come into view. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/settings.h"
#include "doc/text/beam-summary.h"
#include "doc/text/explain.h"
#include "io/text/outcome-text.h"
#include "render/scene/motion.h"
#include <glib/gi18n.h>
#include <math.h>

#define TABLE_HEIGHT 220

#define MOST_COLUMNS 8

typedef struct Table Table;
typedef char *(*CellFunc) (const Table *table, const QnRun *run, guint row);

typedef struct Column {
  const Table *table;
  CellFunc cell;
} Column;

struct Table {
  QnViewState *state;
  QnCanvas *canvas;  /* of contacts and beams */
  GtkWidget *widget; /* of beams */
  GtkStringList *rows;
  GtkSingleSelection *selection;
  GtkColumnViewColumn *stage; /* of steps: shown where there are stages */
  const char *exported;       /* target of the action that writes the table to a file */
  const Column *columns[MOST_COLUMNS]; /* the view's */
  guint column_count;
};

/* An end of an element of a beam. */
typedef struct BeamEnd {
  QnId beam;
  double x; /* m, from the beam's first node */
  QnBeamPoint forces;
} BeamEnd;

static QnRun *
run_of (const Table *table)
{
  return qn_document_get_run (qn_view_state_get_document (table->state));
}

/* ---- columns ---- */

/* The whole row as text, and the table as a file. */
static GMenuModel *
make_row_menu (GtkWidget *label, QnMenuPlace *place, gpointer data)
{
  const Column *column = data;
  const Table *table = column->table;
  const QnRun *run = run_of (table);
  GtkListItem *cell = g_object_get_data (G_OBJECT (label), "qn-item");
  guint row = gtk_list_item_get_position (cell);
  (void) place;
  if (run == NULL || row == GTK_INVALID_LIST_POSITION)
    return NULL;
  gtk_single_selection_set_selected (table->selection, row);
  g_autoptr (GString) text = g_string_new (NULL);
  for (guint i = 0; i < table->column_count; i++) {
    g_autofree char *value = table->columns[i]->cell (table, run, row);
    g_string_append_printf (text, "%s%s", i > 0 ? "\t" : "", value);
  }
  GMenu *menu = g_menu_new ();
  qn_menu_add_target (menu, _ ("_Copy Row"), "win.copy-text",
                      g_variant_new_string (text->str));
  g_autofree char *action = g_strdup_printf ("win.export-result::%s", table->exported);
  g_menu_append (menu, _ ("_Export Table…"), action);
  return G_MENU_MODEL (menu);
}

static void
on_setup_cell (GtkSignalListItemFactory *factory, GtkListItem *item, gpointer data)
{
  (void) factory;
  GtkWidget *label = gtk_label_new (NULL);
  g_object_set_data (G_OBJECT (label), "qn-item", item);
  qn_context_menu_attach (label, make_row_menu, data);
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
  g_autofree char *text =
    run != NULL ? column->cell (column->table, run, row) : g_strdup ("");
  gtk_label_set_text (GTK_LABEL (gtk_list_item_get_child (item)), text);
}

static GtkColumnViewColumn *
add_column (GtkWidget *view, const char *title, Table *table, CellFunc cell)
{
  Column *data = g_new (Column, 1);
  *data = (Column){ table, cell };
  table->columns[table->column_count++] = data;
  GtkListItemFactory *factory = gtk_signal_list_item_factory_new ();
  g_signal_connect (factory, "setup", G_CALLBACK (on_setup_cell), data);
  g_signal_connect_data (factory, "bind", G_CALLBACK (on_bind_cell), data,
                         (GClosureNotify) (gpointer) g_free, 0);
  g_autoptr (GtkColumnViewColumn) column = gtk_column_view_column_new (title, factory);
  gtk_column_view_append_column (GTK_COLUMN_VIEW (view), column);
  return column; /* the view holds it */
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
cell_step (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  (void) run;
  return g_strdup_printf ("%u", row);
}

static char *
cell_stage (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  int32_t stage = row < run->result.step_count ? run->result.steps[row].stage : 0;
  return stage > 0 && (gsize) stage <= run->model.stage_count
           ? qn_stage_dup_name (&run->model, stage)
           : g_strdup ("");
}

static char *
cell_multiplier (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  return row < run->result.step_count
           ? run->result.history.width > 0
               ? g_strdup_printf ("%.4f s", run->result.steps[row].time)
               : g_strdup_printf ("%.5f", run->result.steps[row].multiplier)
           : g_strdup ("");
}

static char *
cell_displacement (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  if (row >= run->result.step_count)
    return g_strdup ("");
  const QnMotion motion = { .model = &run->model,
                            .displacements =
                              qn_result_step_displacements (&run->result, row),
                            .linear = run->model.analysis.geometry == QN_GEOMETRY_LINEAR,
                            .scale = 1.0 };
  return qn_units_format (qn_units_of_motion (qn_settings_get_units ()),
                          QN_QUANTITY_LENGTH, qn_motion_largest (&motion), 4);
}

static char *
cell_iterations (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  return row < run->result.step_count
           ? g_strdup_printf ("%d", run->result.steps[row].iterations)
           : g_strdup ("");
}

static char *
cell_event (const Table *table, const QnRun *run, guint row)
{
  (void) table;
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
cell_blocks (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  if (row >= run->contacts.pair_count)
    return g_strdup ("");
  const QnContactFace *face = &run->contacts.faces[run->contacts.pairs[row].face];
  return g_strdup_printf ("%s – %s", run->model.blocks[face->a].name,
                          run->model.blocks[face->b].name);
}

static char *
cell_state (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  return g_strdup (row < run->result.pair_count
                     ? qn_explain_pair_state (run->result.pairs[row].state)
                     : "");
}

static char *
cell_normal (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  return row < run->result.pair_count
           ? dup_quantity (QN_QUANTITY_FORCE, run->result.pairs[row].normal_force)
           : g_strdup ("");
}

static char *
cell_shear (const Table *table, const QnRun *run, guint row)
{
  (void) table;
  return row < run->result.pair_count
           ? dup_quantity (QN_QUANTITY_FORCE, run->result.pairs[row].shear_force)
           : g_strdup ("");
}

/* ---- section forces: two rows for every element, its ends ---- */

/* The step that the drawing shows. */
static gsize
shown_step (const Table *table, const QnRun *run)
{
  int step = qn_view_state_get_step (table->state);
  return step == QN_STEP_LAST ? run->result.step_count - 1 : (gsize) step;
}

static gboolean
find_end (const Table *table, const QnRun *run, guint row, BeamEnd *end)
{
  const QnResult *result = &run->result;
  gsize element = row / 2;
  if (result->step_count == 0 || result->beam_forces == NULL
      || element >= result->element_count || element >= run->model.element_count)
    return FALSE;
  const QnBeamElement *e = &run->model.elements[element];
  const QnBeam *beam = &run->model.beams[e->beam];
  double length = qn_model_beam_length (&run->model, e->beam) / beam->element_count;
  const QnBeamForces *forces =
    &qn_result_step_beam_forces (result, shown_step (table, run))[element];
  *end = (BeamEnd){ .beam = e->beam,
                    .x = length * ((double) element - beam->first_element + row % 2),
                    .forces = qn_beam_forces_at (forces, length, row % 2) };
  return TRUE;
}

static char *
cell_beam (const Table *table, const QnRun *run, guint row)
{
  BeamEnd end;
  return g_strdup (find_end (table, run, row, &end) ? run->model.beams[end.beam].name
                                                    : "");
}

static char *
cell_place (const Table *table, const QnRun *run, guint row)
{
  BeamEnd end;
  return find_end (table, run, row, &end) ? dup_quantity (QN_QUANTITY_LENGTH, end.x)
                                          : g_strdup ("");
}

static char *
cell_beam_normal (const Table *table, const QnRun *run, guint row)
{
  BeamEnd end;
  return find_end (table, run, row, &end)
           ? dup_quantity (QN_QUANTITY_FORCE, end.forces.normal)
           : g_strdup ("");
}

static char *
cell_beam_shear (const Table *table, const QnRun *run, guint row)
{
  BeamEnd end;
  return find_end (table, run, row, &end)
           ? dup_quantity (QN_QUANTITY_FORCE, end.forces.shear)
           : g_strdup ("");
}

static char *
cell_beam_moment (const Table *table, const QnRun *run, guint row)
{
  BeamEnd end;
  return find_end (table, run, row, &end)
           ? dup_quantity (QN_QUANTITY_MOMENT, end.forces.moment)
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
  gtk_column_view_column_set_visible (table->stage,
                                      run != NULL && run->model.stage_count > 0);
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
  table->exported = "curve";
  GtkWidget *view = make_view (table, G_CALLBACK (on_step_selected));
  g_autofree char *displacement = g_strdup_printf (
    "%s (%s)", _ ("Largest motion"),
    qn_units_symbol (qn_units_of_motion (qn_settings_get_units ()), QN_QUANTITY_LENGTH));
  add_column (view, _ ("Step"), table, cell_step);
  table->stage = add_column (view, _ ("Stage"), table, cell_stage);
  add_column (view, _ ("Multiplier or time"), table, cell_multiplier);
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
  if (run == NULL || row >= run->contacts.pair_count)
    return;
  /* Ringed, and told in the inspector where the drawing is still the same. */
  qn_canvas_show_place (table->canvas, run->contacts.pairs[row].point);
  if (!qn_document_is_stale (qn_canvas_get_document (table->canvas), run))
    qn_selection_set_face (qn_canvas_get_selection (table->canvas),
                           run->contacts.pairs[row].face);
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
  table->exported = "contacts";
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

/* A row leads to its beam. */
static void
on_beam_selected (GtkSingleSelection *selection, GParamSpec *pspec, Table *table)
{
  (void) pspec;
  const QnRun *run = run_of (table);
  guint row = gtk_single_selection_get_selected (selection);
  BeamEnd end;
  if (row == GTK_INVALID_LIST_POSITION || run == NULL
      || !find_end (table, run, row, &end))
    return;
  const QnModel *model = qn_canvas_get_model (table->canvas);
  QnId beam = qn_model_find_beam (model, run->model.beams[end.beam].name);
  if (beam != QN_NONE)
    qn_selection_set_beams (qn_canvas_get_selection (table->canvas), &beam, 1);
}

static void
update_beams (Table *table)
{
  const QnRun *run = run_of (table);
  gboolean there = run != NULL && run->result.beam_forces != NULL;
  gtk_widget_set_visible (table->widget, there);
  set_row_count (table, there ? 2 * run->result.element_count : 0,
                 G_CALLBACK (on_beam_selected));
}

GtkWidget *
qn_beam_table_new (QnCanvas *canvas)
{
  Table *table = g_new0 (Table, 1);
  table->canvas = canvas;
  table->state = qn_canvas_get_state (canvas);
  table->exported = "beams";
  GtkWidget *view = make_view (table, G_CALLBACK (on_beam_selected));
  g_autofree char *place = dup_title ("x", QN_QUANTITY_LENGTH);
  g_autofree char *normal = dup_title ("N", QN_QUANTITY_FORCE);
  g_autofree char *shear = dup_title ("V", QN_QUANTITY_FORCE);
  g_autofree char *moment = dup_title ("M", QN_QUANTITY_MOMENT);
  add_column (view, _ ("Beam"), table, cell_beam);
  add_column (view, place, table, cell_place);
  add_column (view, normal, table, cell_beam_normal);
  add_column (view, shear, table, cell_beam_shear);
  add_column (view, moment, table, cell_beam_moment);
  GtkWidget *widget = table->widget = wrap_table (view, _ ("Section _forces of beams"));
  qn_own (widget, table);
  qn_watch (widget, qn_view_state_get_document (table->state), "runs-changed",
            G_CALLBACK (update_beams), table);
  qn_watch (widget, table->state, "changed", G_CALLBACK (update_beams), table);
  update_beams (table);
  return widget;
}
