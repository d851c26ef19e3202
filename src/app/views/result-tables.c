/* Tables of steps and contacts of the current run. Rows carry no data of their own: cells look
 * their numbers up when they come into view. */
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/settings.h"
#include "doc/text/explain.h"
#include "io/text/outcome-text.h"
#include "render/scene/reading.h"
#include <glib/gi18n.h>

typedef struct Table Table;

typedef struct ColumnTitle {
  const char *text;    /* to be translated */
  QnQuantity quantity; /* whose unit stands behind it; QN_QUANTITY_NUMBER: none */
  gboolean words;      /* not numbers: from the left */
} ColumnTitle;

enum { MOST_COLUMNS = 6 };

typedef struct TableKind {
  const char *title;    /* to be translated */
  const char *exported; /* target of the action that writes the table to a file */
  ColumnTitle columns[MOST_COLUMNS];
  guint column_count;
  gsize (*count_rows) (const QnRun *run);
  /* The text of a cell. `row` is below the number of rows. */
  char *(*dup_cell) (const Table *table, const QnRun *run, guint row, guint column);
  void (*select) (const Table *table, const QnRun *run, guint row);
  void (*follow) (Table *table); /* the state of the view has changed; or NULL */
} TableKind;

struct Table {
  const TableKind *kind;
  QnViewState *state;
  QnCanvas *canvas; /* of contacts and beams */
  GtkWidget *widget;
  GtkStringList *rows;
  GtkSingleSelection *selection;
  GtkColumnViewColumn *columns[MOST_COLUMNS];
  double top;    /* before the next layout, … */
  gulong layout; /* … where the panel scrolls to keep it; 0: it is not to be kept */
};

static QnRun *
run_of (const Table *table)
{
  return table->state->document->run;
}

static char *
dup_quantity (QnQuantity quantity, double value)
{
  return qn_units_format (qn_settings_get_units (), quantity, value, 4);
}

/* ---- steps ---- */

enum { STEP, STAGE, MULTIPLIER, DISPLACEMENT, ITERATIONS, EVENT, STEP_COLUMNS };

static gsize
count_steps (const QnRun *run)
{
  return run->result.step_count;
}

static char *
dup_step_cell (const Table *table, const QnRun *run, guint row, guint column)
{
  const QnResult *result = &run->result;
  const QnStep *step = &result->steps[row];
  const QnMotion motion = qn_step_motion (&run->model, result, row);
  switch (column) {
  case STEP:
    return g_strdup_printf ("%u", row);
  case STAGE:
    return step->stage > 0 && (gsize) step->stage <= run->model.stage_count
             ? qn_stage_dup_name (&run->model, step->stage)
             : g_strdup ("");
  case MULTIPLIER:
    return result->history.width > 0 ? g_strdup_printf ("%.4f s", step->time)
                                     : g_strdup_printf ("%.5f", step->multiplier);
  case DISPLACEMENT:
    return qn_units_format (qn_units_of_motion (qn_settings_get_units ()),
                            QN_QUANTITY_LENGTH, qn_motion_largest (&motion), 4);
  case ITERATIONS:
    return g_strdup_printf ("%d", step->iterations);
  default:
    return g_strdup (step->event == QN_EVENT_SNAP       ? _ ("jump")
                     : step->event == QN_EVENT_COLLAPSE ? _ ("collapse")
                                                        : "");
  }
}

static void
select_step (const Table *table, const QnRun *run, guint row)
{
  if (table->state->options.view != QN_VIEW_DEFORMED)
    qn_view_state_set_view (table->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (table->state, (int) row);
}

static void on_selected (GtkSingleSelection *selection, GParamSpec *pspec, Table *table);

/* The row follows the slider and the curve. */
static void
follow_step (Table *table)
{
  int step = qn_view_state_get_step (table->state);
  guint row = step == QN_STEP_LAST || table->state->options.view != QN_VIEW_DEFORMED
                ? GTK_INVALID_LIST_POSITION
                : (guint) step;
  g_signal_handlers_block_by_func (table->selection, on_selected, table);
  gtk_single_selection_set_selected (table->selection, row);
  g_signal_handlers_unblock_by_func (table->selection, on_selected, table);
}

/* ---- contacts: pairs, then what was found on the way and carries something at the end ---- */

static const QnFoundForce *
found_forces (const QnRun *run, gsize *count)
{
  *count = 0;
  return run->result.step_count > 0
           ? qn_step_found (&run->result, run->result.step_count - 1, count)
           : NULL;
}

enum { BLOCKS, STATE, NORMAL, SHEAR, CONTACT_COLUMNS };

static gsize
count_contacts (const QnRun *run)
{
  gsize found;
  found_forces (run, &found);
  return run->result.pairs != NULL ? run->result.pair_count + found : 0;
}

static char *
dup_contact_cell (const Table *table, const QnRun *run, guint row, guint column)
{
  const QnResult *result = &run->result;
  gsize count;
  const QnFoundForce *found = row >= result->pair_count
                                ? &found_forces (run, &count)[row - result->pair_count]
                                : NULL;
  const QnPairResult *pair = found == NULL ? &result->pairs[row] : NULL;
  switch (column) {
  case BLOCKS: {
    if (found == NULL && row >= run->contacts.pair_count)
      return g_strdup ("");
    const QnFoundContact *contact =
      found != NULL ? &result->found[found->found].contact : NULL;
    const QnContactFace *face =
      found == NULL ? &run->contacts.faces[run->contacts.pairs[row].face] : NULL;
    const QnBlock *blocks = run->model.blocks;
    return g_strdup_printf ("%s – %s",
                            blocks[found != NULL ? contact->block : face->a].name,
                            blocks[found != NULL ? contact->other : face->b].name);
  }
  case STATE:
    return g_strdup (qn_explain_pair_state (found != NULL ? found->state : pair->state));
  case NORMAL:
    return dup_quantity (QN_QUANTITY_FORCE,
                         found != NULL ? found->normal : pair->normal_force);
  default:
    return dup_quantity (QN_QUANTITY_FORCE,
                         found != NULL ? found->shear : pair->shear_force);
  }
}

/* Ringed, and told in the inspector where the drawing is still the same. */
static void
select_contact (const Table *table, const QnRun *run, guint row)
{
  gsize count;
  const QnFoundForce *found = found_forces (run, &count);
  gsize pairs = run->result.pair_count;
  if (row >= pairs && row - pairs < count)
    qn_canvas_show_place (
      table->canvas,
      qn_found_corner (&run->model,
                       &run->result.found[found[row - pairs].found].contact));
  if (row >= run->contacts.pair_count)
    return;
  qn_canvas_show_place (table->canvas, run->contacts.pairs[row].point);
  if (!qn_document_is_stale (table->canvas->document, run))
    qn_selection_set_one (table->canvas->selection, QN_PICK_FACE,
                          run->contacts.pairs[row].face);
}

/* ---- section forces: two rows for every element, its ends ---- */

enum { BEAM, PLACE, BEAM_NORMAL, BEAM_SHEAR, BEAM_MOMENT, BEAM_COLUMNS };

static gsize
count_ends (const QnRun *run)
{
  return run->result.beam_forces != NULL ? 2 * run->result.element_count : 0;
}

/* At the step that the drawing shows. */
static char *
dup_end_cell (const Table *table, const QnRun *run, guint row, guint column)
{
  const QnResult *result = &run->result;
  gsize element = row / 2;
  if (result->step_count == 0 || element >= run->model.element_count)
    return g_strdup ("");
  const QnBeamElement *e = &run->model.elements[element];
  const QnBeam *beam = &run->model.beams[e->beam];
  double length = qn_model_beam_length (&run->model, e->beam) / beam->element_count;
  const QnBeamForces *forces = &qn_result_step_beam_forces (
    result, qn_view_state_get_shown_step (table->state))[element];
  QnBeamPoint end = qn_beam_forces_at (forces, length, row % 2);
  switch (column) {
  case BEAM:
    return g_strdup (beam->name);
  case PLACE:
    return dup_quantity (QN_QUANTITY_LENGTH,
                         length * ((double) element - beam->first_element + row % 2));
  case BEAM_NORMAL:
    return dup_quantity (QN_QUANTITY_FORCE, end.normal);
  case BEAM_SHEAR:
    return dup_quantity (QN_QUANTITY_FORCE, end.shear);
  default:
    return dup_quantity (QN_QUANTITY_MOMENT, end.moment);
  }
}

static void
select_beam (const Table *table, const QnRun *run, guint row)
{
  if (row / 2 >= run->model.element_count)
    return;
  const char *name = run->model.beams[run->model.elements[row / 2].beam].name;
  QnId beam = qn_model_find_beam (qn_canvas_get_model (table->canvas), name);
  if (beam != QN_NONE)
    qn_selection_set (table->canvas->selection, QN_PICK_BEAM, &beam, 1);
}

/* ---- cells and rows ---- */

static char *
dup_cell (const Table *table, guint row, guint column)
{
  const QnRun *run = run_of (table);
  return run != NULL && row < table->kind->count_rows (run)
           ? table->kind->dup_cell (table, run, row, column)
           : g_strdup ("");
}

/* The whole row as text, and the table as a file. */
static GMenuModel *
make_row_menu (GtkWidget *label, QnMenuPlace *place, gpointer data)
{
  const Table *table = data;
  GtkListItem *cell = g_object_get_data (G_OBJECT (label), "qn-item");
  guint row = gtk_list_item_get_position (cell);
  if (run_of (table) == NULL || row == GTK_INVALID_LIST_POSITION)
    return NULL;
  gtk_single_selection_set_selected (table->selection, row);
  g_autoptr (GString) text = g_string_new (NULL);
  for (guint i = 0; i < table->kind->column_count; i++) {
    g_autofree char *value = dup_cell (table, row, i);
    g_string_append_printf (text, "%s%s", i > 0 ? "\t" : "", value);
  }
  GMenu *menu = g_menu_new ();
  qn_menu_add_target (menu, _ ("_Copy Row"), "win.copy-text",
                      g_variant_new_string (text->str));
  g_autofree char *action =
    g_strdup_printf ("win.export-result::%s", table->kind->exported);
  g_menu_append (menu, _ ("_Export Table…"), action);
  return G_MENU_MODEL (menu);
}

static void
on_setup_cell (GtkSignalListItemFactory *factory, GtkListItem *item, gpointer data)
{
  const Table *table = data;
  guint column = GPOINTER_TO_UINT (g_object_get_data (G_OBJECT (factory), "qn-column"));
  GtkWidget *label = gtk_label_new (NULL);
  g_object_set_data (G_OBJECT (label), "qn-item", item);
  qn_context_menu_attach (label, make_row_menu, data);
  gtk_label_set_xalign (GTK_LABEL (label),
                        table->kind->columns[column].words ? 0.0f : 1.0f);
  gtk_widget_add_css_class (label, "numeric");
  gtk_list_item_set_child (item, label);
}

static void
on_bind_cell (GObject *factory, GtkListItem *item, const Table *table)
{
  guint column = GPOINTER_TO_UINT (g_object_get_data (factory, "qn-column"));
  g_autofree char *text = dup_cell (table, gtk_list_item_get_position (item), column);
  gtk_label_set_text (GTK_LABEL (gtk_list_item_get_child (item)), text);
}

/* The panel that scrolls, with where the table lies in it, px; NULL: it is in none. */
static GtkWidget *
panel_of (const Table *table, double *top)
{
  GtkWidget *panel = gtk_widget_get_ancestor (table->widget, GTK_TYPE_SCROLLED_WINDOW);
  graphene_point_t at = { 0 };
  if (panel != NULL
      && !gtk_widget_compute_point (table->widget, panel, graphene_point_zero (), &at))
    return NULL;
  *top = at.y;
  return panel;
}

static void
put_back (Table *table)
{
  double top;
  GtkWidget *panel = panel_of (table, &top);
  g_clear_signal_handler (&table->layout, gtk_widget_get_frame_clock (table->widget));
  if (panel == NULL)
    return;
  GtkAdjustment *scroll =
    gtk_scrolled_window_get_vadjustment (GTK_SCROLLED_WINDOW (panel));
  gtk_adjustment_set_value (scroll, gtk_adjustment_get_value (scroll) + top - table->top);
}

static void
on_selected (GtkSingleSelection *selection, GParamSpec *pspec, Table *table)
{
  guint row = gtk_single_selection_get_selected (selection);
  const QnRun *run = run_of (table);
  if (run == NULL || row >= table->kind->count_rows (run))
    return;
  /* What a row shows above the table moves it in the next layout: the panel scrolls by as much in the
   * same frame, and the next row is still under the pointer. */
  GdkFrameClock *clock = gtk_widget_get_frame_clock (table->widget);
  if (clock != NULL && table->layout == 0 && panel_of (table, &table->top) != NULL) {
    GClosure *closure = g_cclosure_new_swap (G_CALLBACK (put_back), table, NULL);
    g_object_watch_closure (G_OBJECT (table->widget), closure);
    table->layout = g_signal_connect_closure (clock, "layout", closure, TRUE);
    gdk_frame_clock_request_phase (clock, GDK_FRAME_CLOCK_PHASE_LAYOUT);
  }
  table->kind->select (table, run, row);
}

/* Rows without contents: cells look theirs up. */
static void
update (Table *table)
{
  const QnRun *run = run_of (table);
  gsize count = run != NULL ? table->kind->count_rows (run) : 0;
  guint have = g_list_model_get_n_items (G_LIST_MODEL (table->rows));
  g_autofree const char **blank = g_new0 (const char *, count + 1);
  for (gsize i = 0; i < count; i++)
    blank[i] = "";
  g_signal_handlers_block_by_func (table->selection, on_selected, table);
  gtk_string_list_splice (table->rows, 0, have, blank);
  gtk_single_selection_set_selected (table->selection, GTK_INVALID_LIST_POSITION);
  g_signal_handlers_unblock_by_func (table->selection, on_selected, table);
}

static void
update_steps (Table *table)
{
  const QnRun *run = run_of (table);
  gtk_column_view_column_set_visible (table->columns[STAGE],
                                      run != NULL && run->model.stage_count > 0);
  update (table);
}

static void
update_ends (Table *table)
{
  const QnRun *run = run_of (table);
  gtk_widget_set_visible (table->widget, run != NULL && run->result.beam_forces != NULL);
  update (table);
}

/* ---- building ---- */

static GtkWidget *
make_table (const TableKind *kind, QnViewState *state, QnCanvas *canvas,
            void (*updates) (Table *table))
{
  Table *table = g_new (Table, 1);
  g_autoptr (GtkBuilder) builder = qn_builder_new ("result-table");
  GtkColumnView *view = GTK_COLUMN_VIEW (gtk_builder_get_object (builder, "view"));
  *table = (Table){
    .kind = kind,
    .state = state,
    .canvas = canvas,
    .widget = qn_builder_take_widget (builder, "table"),
    .rows = GTK_STRING_LIST (gtk_builder_get_object (builder, "rows")),
    .selection = GTK_SINGLE_SELECTION (gtk_builder_get_object (builder, "selection")),
  };
  gtk_expander_set_label (GTK_EXPANDER (table->widget), _ (kind->title));
  g_signal_connect (table->selection, "notify::selected", G_CALLBACK (on_selected),
                    table);
  for (guint i = 0; i < kind->column_count; i++) {
    const ColumnTitle *title = &table->kind->columns[i];
    QnUnits units = qn_settings_get_units ();
    GtkListItemFactory *factory = gtk_signal_list_item_factory_new ();
    if (table->kind->count_rows == count_steps)
      units = qn_units_of_motion (units);
    g_autofree char *text =
      title->quantity == QN_QUANTITY_NUMBER
        ? g_strdup (_ (title->text))
        : g_strdup_printf ("%s (%s)", _ (title->text),
                           qn_units_symbol (units, title->quantity));
    g_object_set_data (G_OBJECT (factory), "qn-column", GUINT_TO_POINTER (i));
    g_signal_connect (factory, "setup", G_CALLBACK (on_setup_cell), table);
    g_signal_connect (factory, "bind", G_CALLBACK (on_bind_cell), table);
    g_autoptr (GtkColumnViewColumn) column = gtk_column_view_column_new (text, factory);
    gtk_column_view_append_column (view, column);
    table->columns[i] = column; /* the view holds it */
  }
  qn_own (table->widget, table);
  qn_watch (table->widget, state->document, "runs-changed", G_CALLBACK (updates), table);
  if (kind->follow != NULL)
    qn_watch (table->widget, state, "changed", G_CALLBACK (kind->follow), table);
  updates (table);
  return table->widget;
}

GtkWidget *
qn_step_table_new (QnViewState *state)
{
  static const TableKind kind = {
    .title = N_ ("_Steps"),
    .exported = "curve",
    .columns = { [STEP] = { N_ ("Step"), QN_QUANTITY_NUMBER, FALSE },
                 [STAGE] = { N_ ("Stage"), QN_QUANTITY_NUMBER, FALSE },
                 [MULTIPLIER] = { N_ ("Multiplier or time"), QN_QUANTITY_NUMBER, FALSE },
                 [DISPLACEMENT] = { N_ ("Largest displacement"), QN_QUANTITY_LENGTH,
                                    FALSE },
                 [ITERATIONS] = { N_ ("Iterations"), QN_QUANTITY_NUMBER, FALSE },
                 [EVENT] = { N_ ("Event"), QN_QUANTITY_NUMBER, TRUE } },
    .column_count = STEP_COLUMNS,
    .count_rows = count_steps,
    .dup_cell = dup_step_cell,
    .select = select_step,
    .follow = follow_step,
  };
  return make_table (&kind, state, NULL, update_steps);
}

GtkWidget *
qn_contact_table_new (QnCanvas *canvas)
{
  static const TableKind kind = {
    .title = N_ ("_Contacts at the end"),
    .exported = "contacts",
    .columns = { [BLOCKS] = { N_ ("Blocks"), QN_QUANTITY_NUMBER, TRUE },
                 [STATE] = { N_ ("State"), QN_QUANTITY_NUMBER, TRUE },
                 [NORMAL] = { "N", QN_QUANTITY_FORCE, FALSE },
                 [SHEAR] = { "T", QN_QUANTITY_FORCE, FALSE } },
    .column_count = CONTACT_COLUMNS,
    .count_rows = count_contacts,
    .dup_cell = dup_contact_cell,
    .select = select_contact,
  };
  return make_table (&kind, canvas->state, canvas, update);
}

GtkWidget *
qn_beam_table_new (QnCanvas *canvas)
{
  static const TableKind kind = {
    .title = N_ ("Section _forces of beams"),
    .exported = "beams",
    .columns = { [BEAM] = { N_ ("Beam"), QN_QUANTITY_NUMBER, TRUE },
                 [PLACE] = { "x", QN_QUANTITY_LENGTH, FALSE },
                 [BEAM_NORMAL] = { "N", QN_QUANTITY_FORCE, FALSE },
                 [BEAM_SHEAR] = { "V", QN_QUANTITY_FORCE, FALSE },
                 [BEAM_MOMENT] = { "M", QN_QUANTITY_MOMENT, FALSE } },
    .column_count = BEAM_COLUMNS,
    .count_rows = count_ends,
    .dup_cell = dup_end_cell,
    .select = select_beam,
    .follow = update_ends,
  };
  return make_table (&kind, canvas->state, canvas, update_ends);
}
