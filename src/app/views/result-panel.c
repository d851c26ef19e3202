#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/choice-list.h"
#include "app/widgets/context-menu.h"
#include "doc/document/run-name.h"
#include "doc/document/run.h"
#include "doc/view/load-text.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n.h>

typedef struct Panel {
  QnViewState *state;
  GtkWidget *empty, *content, *curve;
  GtkDropDown *runs, *stage, *onion;
  GtkEditable *name;
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

/* Runs after edits and cases of studies have no name of their own. */
static void
update_name (Panel *panel)
{
  const QnRun *run = run_of (panel);
  const char *label = run != NULL ? run->label : NULL;
  gtk_widget_set_visible (GTK_WIDGET (panel->name), label != NULL);
  if (label != NULL && g_strcmp0 (gtk_editable_get_text (panel->name), label) != 0)
    gtk_editable_set_text (panel->name, label);
}

static void
on_run_chosen (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  const GPtrArray *runs = qn_document_get_runs (document_of (panel));
  guint row = gtk_drop_down_get_selected (choice);
  if (row < runs->len)
    qn_document_set_run (document_of (panel), g_ptr_array_index (runs, row));
}

static void
on_onion_chosen (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  const GPtrArray *runs = qn_document_get_runs (document_of (panel));
  guint row = gtk_drop_down_get_selected (choice);
  qn_view_state_set_onion (
    panel->state, row > 0 && row <= runs->len ? g_ptr_array_index (runs, row - 1) : NULL);
}

static void
on_named (Panel *panel)
{
  const QnRun *run = run_of (panel);
  g_autoptr (GError) error = NULL;
  if (!gtk_widget_get_mapped (GTK_WIDGET (panel->name))) /* the window goes */
    return;
  if (run == NULL
      || !qn_document_rename_run (document_of (panel), run,
                                  gtk_editable_get_text (panel->name), &error))
    update_name (panel);
}

static char *
dup_run_title (Panel *panel, const QnRun *run)
{
  const char *mark =
    qn_document_get_run_age (document_of (panel), run) == QN_RUN_OTHER_MODEL ? "⚠ " : "";
  g_autofree char *title = qn_run_dup_title (run);
  return g_strconcat (mark, title, NULL);
}

static void
update_runs (Panel *panel)
{
  const GPtrArray *runs = qn_document_get_runs (document_of (panel));
  g_autoptr (GPtrArray) names = g_ptr_array_new_with_free_func (g_free);
  guint selected = GTK_INVALID_LIST_POSITION, onion = 0;
  g_ptr_array_add (names, g_strdup (C_ ("run", "None")));
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = g_ptr_array_index (runs, i);
    g_ptr_array_add (names, dup_run_title (panel, run));
    if (run == run_of (panel))
      selected = i;
    if (run == qn_view_state_get_onion (panel->state))
      onion = i + 1;
  }
  update_name (panel);
  g_ptr_array_add (names, NULL);
  const char *const *all = (const char *const *) names->pdata;
  qn_choice_list_fill (panel->runs, all + 1, selected, panel);
  /* There may not be room for all of it. */
  gtk_widget_set_tooltip_text (GTK_WIDGET (panel->runs),
                               selected < runs->len ? all[selected + 1] : NULL);
  qn_choice_list_fill (panel->onion, all, onion, panel);
  gtk_widget_set_visible (GTK_WIDGET (panel->onion), runs->len > 1);
}

/* ---- stages ---- */

/* The end of the chosen one. */
static void
on_stage_chosen (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  const QnRun *run = run_of (panel);
  size_t first = 0, last = 0;
  if (run == NULL
      || !qn_result_stage_steps (
        &run->result, (int32_t) gtk_drop_down_get_selected (choice), &first, &last))
    return;
  if (!qn_view_needs_result (qn_view_state_get_view (panel->state))
      || qn_view_state_get_view (panel->state) == QN_VIEW_MECHANISM)
    qn_view_state_set_view (panel->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (panel->state, (int) last);
}

/* The stage of the step that is shown. */
static void
follow_stage (Panel *panel)
{
  const QnRun *run = run_of (panel);
  gsize count = run != NULL ? run->result.step_count : 0;
  if (count == 0 || run->model.stage_count == 0)
    return;
  int step = qn_view_state_get_step (panel->state);
  const QnStep *at = &run->result.steps[step == QN_STEP_LAST ? count - 1 : (gsize) step];
  qn_choice_list_select (panel->stage, (guint) at->stage, panel);
}

static void
update (Panel *panel)
{
  const QnRun *run = run_of (panel);
  gboolean busy = qn_document_get_job (document_of (panel)) != NULL;
  gtk_widget_set_visible (panel->content, run != NULL || busy);
  gtk_widget_set_visible (panel->empty, run == NULL && !busy);
  update_runs (panel);
  /* Limit analysis and modes follow no path; without an equilibrium there is none. */
  gtk_widget_set_visible (panel->curve,
                          busy || run == NULL
                            || (qn_run_has_curve (run) && run->result.step_count > 0));
  /* Those that the run came to, behind the dead load. */
  gboolean any = run != NULL && run->model.stage_count > 0 && run->result.step_count > 0;
  gtk_widget_set_visible (GTK_WIDGET (panel->stage), any);
  if (!any)
    return;
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  g_strv_builder_add (names, _ ("Dead load"));
  size_t first = 0, last = 0;
  for (int32_t i = 1; i <= (int32_t) run->model.stage_count; i++) {
    if (!qn_result_stage_steps (&run->result, i, &first, &last))
      break;
    g_autofree char *name = qn_stage_dup_name (&run->model, i);
    g_autofree char *line =
      g_strdup_printf (_ ("%s, to %.4g"), name, run->result.steps[last].multiplier);
    g_strv_builder_add (names, line);
  }
  g_auto (GStrv) strings = g_strv_builder_end (names);
  qn_choice_list_fill (panel->stage, (const char *const *) strings, 0, panel);
  follow_stage (panel);
}

/* What can be done with the run that is shown. */
static GMenuModel *
make_run_menu (GtkWidget *runs, QnMenuPlace *place, gpointer data)
{
  if (gtk_drop_down_get_selected_item (GTK_DROP_DOWN (runs)) == NULL)
    return NULL;
  g_autoptr (GtkBuilder) builder = qn_builder_new ("context-menus");
  return G_MENU_MODEL (g_object_ref (gtk_builder_get_object (builder, "run")));
}

static GtkDropDown *
take_choice (GtkBuilder *builder, const char *id, GCallback chosen, Panel *panel)
{
  GtkDropDown *choice = GTK_DROP_DOWN (qn_builder_get_widget (builder, id));
  qn_choice_list_prepare (choice);
  g_signal_connect (choice, "notify::selected", chosen, panel);
  return choice;
}

GtkWidget *
qn_result_panel_new (QnCanvas *canvas)
{
  QnViewState *state = qn_canvas_get_state (canvas);
  QnDocument *document = qn_view_state_get_document (state);
  g_autoptr (GtkBuilder) builder = qn_builder_new ("result-panel");
  GtkWidget *box = qn_builder_take_widget (builder, "panel");
  GtkBox *views = GTK_BOX (qn_builder_get_widget (builder, "views"));
  GtkBox *tables = GTK_BOX (qn_builder_get_widget (builder, "tables"));
  Panel *panel = g_new (Panel, 1);
  *panel = (Panel){
    .state = state,
    .empty = qn_builder_get_widget (builder, "empty"),
    .content = qn_builder_get_widget (builder, "content"),
    .curve = qn_curve_view_new (state),
    .runs = take_choice (builder, "runs", G_CALLBACK (on_run_chosen), panel),
    .stage = take_choice (builder, "stage", G_CALLBACK (on_stage_chosen), panel),
    .onion = take_choice (builder, "onion", G_CALLBACK (on_onion_chosen), panel),
  };
  panel->name = GTK_EDITABLE (qn_builder_get_widget (builder, "run_name"));
  g_signal_connect_swapped (panel->name, "activate", G_CALLBACK (on_named), panel);
  GtkEventController *focus = gtk_event_controller_focus_new ();
  g_signal_connect_swapped (focus, "leave", G_CALLBACK (on_named), panel);
  gtk_widget_add_controller (GTK_WIDGET (panel->name), focus);
  qn_context_menu_attach (GTK_WIDGET (panel->runs), make_run_menu, NULL);
  gtk_box_append (views, qn_answer_card_new (document));
  gtk_box_append (views, qn_inspector_new (canvas));
  gtk_box_append (views, panel->curve);
  gtk_box_append (views, qn_energy_view_new (state));
  gtk_box_append (tables, qn_step_table_new (state));
  gtk_box_append (tables, qn_contact_table_new (canvas));
  gtk_box_append (tables, qn_beam_table_new (canvas));

  qn_own (box, panel);
  qn_watch (box, document, "runs-changed", G_CALLBACK (update), panel);
  qn_watch (box, document, "job-changed", G_CALLBACK (update), panel);
  qn_watch (box, document, "changed", G_CALLBACK (update_runs), panel);
  qn_watch (box, state, "changed", G_CALLBACK (follow_stage), panel);
  update (panel);
  return box;
}
