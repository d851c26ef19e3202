#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include "doc/document/document.h"
#include "doc/document/run.h"
#include "doc/view/load-text.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n.h>

typedef struct Panel {
  QnForm base;
  GtkWidget *curve;
} Panel;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (CONTENT, "content", NULL)                                                       \
  FIELD (RUNS, "runs", NULL)                                                             \
  FIELD (NAME, "run_name", NULL)                                                         \
  FIELD (STAGE, "stage", NULL)                                                           \
  FIELD (ONION, "onion", NULL)                                                           \
  FIELD (VIEWS, "views", NULL)                                                           \
  FIELD (TABLES, "tables", NULL)
QN_FORM_FIELDS;

static QnDocument *
document_of (const Panel *panel)
{
  return panel->base.canvas->document;
}

static QnViewState *
state_of (const Panel *panel)
{
  return panel->base.canvas->state;
}

/* ---- what is shown ---- */

/* The runs, with the row of `chosen` among them; -1: none. */
static void
add_runs (const Panel *panel, const QnRun *chosen, QnValue *value)
{
  const GPtrArray *runs = document_of (panel)->runs;
  const guint before = value->row_count;
  for (guint i = 0; i < runs->len; i++) {
    const QnRun *run = runs->pdata[i];
    const gboolean other =
      qn_document_get_run_age (document_of (panel), run) == QN_RUN_OTHER_MODEL;
    g_autofree char *title = qn_run_dup_title (run);
    qn_value_take_row (value, g_strconcat (other ? "⚠ " : "", title, NULL));
    if (run == chosen)
      value->number = before + i;
  }
}

/* Those that the run came to, behind the dead load. */
static void
add_stages (const QnRun *run, QnValue *value)
{
  size_t first = 0, last = 0;
  qn_value_add_row (value, _ ("Dead load"));
  for (int32_t i = 1; i <= (int32_t) run->model.stage_count; i++) {
    if (!qn_result_stage_steps (&run->result, i, &first, &last))
      return;
    g_autofree char *name = qn_stage_dup_name (&run->model, i);
    qn_value_take_row (value, g_strdup_printf (_ ("%s, to %.4g"), name,
                                               run->result.steps[last].multiplier));
  }
}

static gboolean
has_stages (const QnRun *run)
{
  return run != NULL && run->model.stage_count > 0 && run->result.step_count > 0;
}

/* That of the step that is shown. */
static int32_t
shown_stage (const Panel *panel, const QnRun *run)
{
  return run->result.steps[qn_view_state_get_shown_step (state_of (panel))].stage;
}

static void
follow_stage (Panel *panel)
{
  const QnRun *run = document_of (panel)->run;
  panel->base.showing = TRUE;
  if (has_stages (run))
    gtk_drop_down_set_selected (GTK_DROP_DOWN (panel->base.widgets[STAGE]),
                                (guint) shown_stage (panel, run));
  panel->base.showing = FALSE;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  Panel *panel = (Panel *) data;
  QnDocument *document = document_of (panel);
  const QnRun *run = document->run;
  const gboolean busy = document->job != NULL;
  value->number = -1;
  switch (field) {
  case EMPTY:
    return run == NULL && !busy;
  case CONTENT:
    /* Limit analysis and modes follow no path; without an equilibrium there is none. */
    gtk_widget_set_visible (panel->curve,
                            busy || run == NULL
                              || (qn_run_has_curve (run) && run->result.step_count > 0));
    return run != NULL || busy;
  case RUNS:
    add_runs (panel, run, value);
    /* There may not be room for all of it. */
    gtk_widget_set_tooltip_text (panel->base.widgets[RUNS],
                                 value->number < 0 ? NULL
                                                   : value->rows[qn_value_int (value)]);
    return TRUE;
  case NAME: /* runs after edits and cases of studies have none of their own */
    value->text = g_strdup (run != NULL ? run->label : NULL);
    return value->text != NULL;
  case STAGE:
    if (!has_stages (run))
      return FALSE;
    add_stages (run, value);
    value->number = shown_stage (panel, run);
    return TRUE;
  case ONION:
    qn_value_add_row (value, C_ ("run", "None"));
    value->number = 0;
    add_runs (panel, state_of (panel)->onion, value);
    return value->row_count > 2;
  }
  return TRUE;
}

/* ---- what is chosen ---- */

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Panel *panel = (const Panel *) data;
  const GPtrArray *runs = document_of (panel)->runs;
  const QnRun *run = document_of (panel)->run;
  const guint row = (guint) qn_value_int (value);
  size_t first = 0, last = 0;
  if (field == RUNS && row < runs->len)
    qn_document_set_run (document_of (panel), runs->pdata[row]);
  else if (field == ONION)
    qn_view_state_set_onion (state_of (panel),
                             row > 0 && row <= runs->len ? runs->pdata[row - 1] : NULL);
  else if (field == STAGE && run != NULL
           && qn_result_stage_steps (&run->result, (int32_t) row, &first, &last)) {
    const QnView view = state_of (panel)->options.view;
    if (!qn_view_needs_result (view) || view == QN_VIEW_MECHANISM)
      qn_view_state_set_view (state_of (panel), QN_VIEW_DEFORMED);
    qn_view_state_set_step (state_of (panel), (int) last); /* the end of the stage */
  } else if (field == NAME)
    return run != NULL
           && qn_document_rename_run (document_of (panel), run, value->text, error);
  return TRUE;
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

GtkWidget *
qn_result_panel_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("result-panel", Panel, .follows = QN_FOLLOW_RUNS);
  Panel *panel = qn_form_new (&kind, canvas);
  GtkBox *views = GTK_BOX (panel->base.widgets[VIEWS]);
  GtkBox *tables = GTK_BOX (panel->base.widgets[TABLES]);
  panel->curve = qn_curve_view_new (canvas->state);
  gtk_box_append (views, qn_answer_card_new (document_of (panel)));
  gtk_box_append (views, qn_inspector_new (canvas));
  gtk_box_append (views, panel->curve);
  gtk_box_append (views, qn_energy_view_new (canvas->state));
  gtk_box_append (tables, qn_step_table_new (canvas->state));
  gtk_box_append (tables, qn_contact_table_new (canvas));
  gtk_box_append (tables, qn_beam_table_new (canvas));
  qn_context_menu_attach (panel->base.widgets[RUNS], make_run_menu, NULL);
  qn_watch (panel->base.root, canvas->state, "changed", G_CALLBACK (follow_stage), panel);
  return qn_form_show (panel);
}
