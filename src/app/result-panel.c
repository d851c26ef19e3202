#include "app/curve-view.h"
#include "app/form.h"
#include "app/panel.h"
#include "app/settings.h"
#include "doc/explain.h"
#include "render/motion.h"
#include <glib/gi18n.h>

typedef struct Panel {
  QnCanvas *canvas;
  QnViewState *state;
  GtkWidget *empty, *content, *stale;
  GtkLabel *outcome, *mechanism, *facts;
  GtkDropDown *runs;
  GtkStringList *step_rows, *contact_rows;
  GtkSingleSelection *step_selection;
} Panel;

static QnDocument *
document_of (const Panel *panel)
{
  return qn_view_state_get_document (panel->state);
}

static const QnRun *
run_of (const Panel *panel)
{
  return qn_document_get_run (document_of (panel));
}

/* ---- tables: rows carry no data of their own, cells look their numbers up ---- */

typedef char *(*CellFunc) (const QnRun *run, guint row);

typedef struct Column {
  const Panel *panel;
  CellFunc cell;
} Column;

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
  const QnRun *run = run_of (column->panel);
  guint row = gtk_list_item_get_position (item);
  g_autofree char *text = run != NULL ? column->cell (run, row) : g_strdup ("");
  gtk_label_set_text (GTK_LABEL (gtk_list_item_get_child (item)), text);
}

static void
add_column (GtkWidget *view, const char *title, const Panel *panel, CellFunc cell)
{
  Column *data = g_new (Column, 1);
  *data = (Column){ panel, cell };
  GtkListItemFactory *factory = gtk_signal_list_item_factory_new ();
  g_signal_connect (factory, "setup", G_CALLBACK (on_setup_cell), NULL);
  g_signal_connect_data (factory, "bind", G_CALLBACK (on_bind_cell), data,
                         (GClosureNotify) (gpointer) g_free, 0);
  g_autoptr (GtkColumnViewColumn) column = gtk_column_view_column_new (title, factory);
  gtk_column_view_append_column (GTK_COLUMN_VIEW (view), column);
}

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
  if (row >= run->result.pair_count)
    return g_strdup ("");
  return qn_units_format (qn_settings_get_units (), QN_QUANTITY_FORCE,
                          run->result.pairs[row].normal_force, 4);
}

static char *
cell_shear (const QnRun *run, guint row)
{
  if (row >= run->result.pair_count)
    return g_strdup ("");
  return qn_units_format (qn_settings_get_units (), QN_QUANTITY_FORCE,
                          run->result.pairs[row].shear_force, 4);
}

/* A row per step or pair, without contents. */
static void
set_row_count (GtkStringList *rows, gsize count)
{
  guint have = g_list_model_get_n_items (G_LIST_MODEL (rows));
  const char **blank = g_new0 (const char *, count + 1);
  for (gsize i = 0; i < count; i++)
    blank[i] = "";
  gtk_string_list_splice (rows, 0, have, blank);
  g_free (blank);
}

static GtkWidget *
wrap_table (GtkWidget *view, const char *title)
{
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_min_content_height (GTK_SCROLLED_WINDOW (scroller), 220);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), view);
  gtk_widget_add_css_class (scroller, "frame");
  GtkWidget *expander = gtk_expander_new_with_mnemonic (title);
  gtk_expander_set_child (GTK_EXPANDER (expander), scroller);
  return expander;
}

static void
on_step_selected (GtkSingleSelection *selection, GParamSpec *pspec, Panel *panel)
{
  (void) pspec;
  guint row = gtk_single_selection_get_selected (selection);
  if (row == GTK_INVALID_LIST_POSITION)
    return;
  if (qn_view_state_get_view (panel->state) != QN_VIEW_DEFORMED)
    qn_view_state_set_view (panel->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (panel->state, (int) row);
}

static GtkWidget *
build_steps (Panel *panel)
{
  panel->step_rows = gtk_string_list_new (NULL);
  panel->step_selection = gtk_single_selection_new (G_LIST_MODEL (panel->step_rows));
  gtk_single_selection_set_autoselect (panel->step_selection, FALSE);
  gtk_single_selection_set_can_unselect (panel->step_selection, TRUE);
  g_signal_connect (panel->step_selection, "notify::selected",
                    G_CALLBACK (on_step_selected), panel);
  GtkWidget *view =
    gtk_column_view_new (g_object_ref (GTK_SELECTION_MODEL (panel->step_selection)));
  g_object_set_data_full (G_OBJECT (view), "qn-selection", panel->step_selection,
                          g_object_unref);
  add_column (view, _ ("Step"), panel, cell_step);
  add_column (view, _ ("Multiplier"), panel, cell_multiplier);
  add_column (view, _ ("Iterations"), panel, cell_iterations);
  add_column (view, _ ("Event"), panel, cell_event);
  return wrap_table (view, _ ("_Steps"));
}

static GtkWidget *
build_contacts (Panel *panel)
{
  panel->contact_rows = gtk_string_list_new (NULL);
  GtkWidget *view = gtk_column_view_new (
    GTK_SELECTION_MODEL (gtk_no_selection_new (G_LIST_MODEL (panel->contact_rows))));
  const char *unit = qn_units_symbol (qn_settings_get_units (), QN_QUANTITY_FORCE);
  g_autofree char *normal = g_strdup_printf ("N (%s)", unit);
  g_autofree char *shear = g_strdup_printf ("T (%s)", unit);
  add_column (view, _ ("Blocks"), panel, cell_blocks);
  add_column (view, _ ("State"), panel, cell_state);
  add_column (view, normal, panel, cell_normal);
  add_column (view, shear, panel, cell_shear);
  return wrap_table (view, _ ("_Contacts at the end"));
}

/* ---- words ---- */

static void
update_words (Panel *panel, const QnRun *run)
{
  g_autofree char *outcome = qn_explain_outcome (&run->model, &run->result);
  gtk_label_set_text (panel->outcome, outcome);
  gtk_widget_set_visible (panel->stale, qn_document_is_stale (document_of (panel), run));

  g_autofree char *words =
    qn_explain_mechanism (&run->model, &run->contacts, &run->result);
  gtk_label_set_text (panel->mechanism, words != NULL ? words : "");
  gtk_widget_set_visible (GTK_WIDGET (panel->mechanism), words != NULL);

  const QnStatistics *s = &run->result.statistics;
  g_autofree char *facts = g_strdup_printf (
    _ ("%u steps, %d iterations, %d factorisations, %.2f s"),
    (guint) run->result.step_count, s->iterations, s->factorizations, s->seconds);
  gtk_label_set_text (panel->facts, facts);
}

static void
on_run_chosen (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  (void) pspec;
  const GPtrArray *runs = qn_document_get_runs (document_of (panel));
  guint row = gtk_drop_down_get_selected (choice);
  if (row < runs->len)
    qn_document_set_run (document_of (panel), g_ptr_array_index (runs, row));
}

static void
update_runs (Panel *panel)
{
  const GPtrArray *runs = qn_document_get_runs (document_of (panel));
  g_autoptr (GtkStringList) names = gtk_string_list_new (NULL);
  guint selected = GTK_INVALID_LIST_POSITION;
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = g_ptr_array_index (runs, i);
    g_autofree char *name =
      run->result.has_collapse_multiplier
        ? g_strdup_printf ("%s: %.4f", run->name, run->result.collapse_multiplier)
        : g_strdup_printf ("%s: %s", run->name,
                           qn_explain_outcome_label (run->result.outcome));
    gtk_string_list_append (names, name);
    if (run == run_of (panel))
      selected = i;
  }
  g_signal_handlers_block_matched (panel->runs, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                   panel);
  gtk_drop_down_set_model (panel->runs, G_LIST_MODEL (names));
  gtk_drop_down_set_selected (panel->runs, selected);
  g_signal_handlers_unblock_matched (panel->runs, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                     panel);
}

static void
update_on_change (Panel *panel)
{
  const QnRun *run = run_of (panel);
  if (run != NULL)
    gtk_widget_set_visible (panel->stale,
                            qn_document_is_stale (document_of (panel), run));
}

static void
update (Panel *panel)
{
  const QnRun *run = run_of (panel);
  gboolean busy = qn_document_get_job (document_of (panel)) != NULL;
  gtk_widget_set_visible (panel->content, run != NULL || busy);
  gtk_widget_set_visible (panel->empty, run == NULL && !busy);
  update_runs (panel);
  g_signal_handlers_block_by_func (panel->step_selection, on_step_selected, panel);
  set_row_count (panel->step_rows, run != NULL ? run->result.step_count : 0);
  set_row_count (panel->contact_rows,
                 run != NULL && run->result.pairs != NULL ? run->result.pair_count : 0);
  g_signal_handlers_unblock_by_func (panel->step_selection, on_step_selected, panel);
  if (run != NULL)
    update_words (panel, run);
}

static GtkWidget *
build_content (Panel *panel)
{
  const char *const none[] = { NULL };
  GtkWidget *form = qn_form_new ();
  panel->stale = gtk_label_new (_ ("Outdated: the model has changed since this run."));
  gtk_widget_add_css_class (panel->stale, "stale");
  gtk_label_set_wrap (GTK_LABEL (panel->stale), TRUE);
  qn_form_add_wide (form, panel->stale);
  panel->outcome = qn_form_add_text (form);
  gtk_widget_add_css_class (GTK_WIDGET (panel->outcome), "outcome");
  panel->mechanism = qn_form_add_text (form);
  qn_form_add_wide (form, qn_curve_view_new (panel->state));
  panel->runs =
    qn_form_add_choice (form, _ ("_Run"), none, G_CALLBACK (on_run_chosen), panel);
  panel->facts = qn_form_add_text (form);
  gtk_widget_add_css_class (GTK_WIDGET (panel->facts), "dim-label");
  qn_form_add_wide (form, build_steps (panel));
  qn_form_add_wide (form, build_contacts (panel));
  return form;
}

GtkWidget *
qn_result_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  panel->canvas = canvas;
  panel->state = qn_canvas_get_state (canvas);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  panel->empty = gtk_label_new (_ ("No result yet. Solve the model with F5."));
  gtk_label_set_wrap (GTK_LABEL (panel->empty), TRUE);
  gtk_widget_add_css_class (panel->empty, "dim-label");
  gtk_widget_set_margin_top (panel->empty, 24);
  panel->content = build_content (panel);
  gtk_box_append (GTK_BOX (box), panel->empty);
  gtk_box_append (GTK_BOX (box), panel->content);

  qn_own (box, panel);
  QnDocument *document = document_of (panel);
  qn_watch (box, document, "runs-changed", G_CALLBACK (update), panel);
  qn_watch (box, document, "job-changed", G_CALLBACK (update), panel);
  qn_watch (box, document, "changed", G_CALLBACK (update_on_change), panel);
  update (panel);
  return box;
}
