#include "app/window/window-private.h"

#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/settings.h"
#include "app/window/action-table.h"
#include "core/base/word.h"
#include <glib/gi18n.h>

#define ZOOM_FACTOR 1.25

/* Of an action: its QnWindowAction. */
#define ROW "qn-row"

static void
on_table_action (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  const QnWindowAction *row = g_object_get_data (G_OBJECT (action), ROW);
  if (parameter == NULL)
    row->func (data, row->name);
  else if (g_variant_is_of_type (parameter, G_VARIANT_TYPE_STRING))
    row->func (data, g_variant_get_string (parameter, NULL));
  else
    row->take (data, parameter);
}

/* ---- viewing ---- */

static void
new_drawing (QnWindow *self, const char *name)
{
  qn_window_show_work (self);
  gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s", "wall");
}

static void
zoom (QnWindow *self, const char *name)
{
  qn_canvas_zoom (self->canvas,
                  g_str_equal (name, "zoom-in") ? ZOOM_FACTOR : 1.0 / ZOOM_FACTOR);
}

static void
fit (QnWindow *self, const char *name)
{
  qn_canvas_fit (self->canvas);
}

static void
play (QnWindow *self, const char *name)
{
  qn_playback_bar_toggle (self->playback);
}

static void
go_by_step (QnWindow *self, const char *name)
{
  const int by = g_str_equal (name, "next-step") ? 1 : -1;
  const QnRun *run = self->document->run;
  if (run == NULL || run->result.step_count == 0)
    return;
  int last = (int) run->result.step_count - 1;
  int step = (int) qn_view_state_get_shown_step (self->state);
  if (!qn_view_needs_result (self->state->options.view))
    qn_view_state_set_view (self->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (self->state, CLAMP (step + by, 0, last));
}

static void
show_panel (QnWindow *self, const char *name)
{
  if (gtk_stack_get_child_by_name (self->side_stack, name) == NULL)
    return;
  gtk_stack_set_visible_child_name (self->side_stack, name);
  g_action_group_change_action_state (G_ACTION_GROUP (self), "side-panel",
                                      g_variant_new_boolean (TRUE));
}

static void
toggle_fullscreen (QnWindow *self, const char *name)
{
  g_object_set (self, "fullscreened", !gtk_window_is_fullscreen (GTK_WINDOW (self)),
                NULL);
}

static void
show_shortcuts (QnWindow *self, const char *name)
{
  qn_action_show_shortcuts (GTK_WINDOW (self));
}

/* ---- actions with a state ---- */

static void
on_tool (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  const QnTool *tool = qn_tool_find (g_variant_get_string (value, NULL));
  if (tool == NULL)
    return;
  g_simple_action_set_state (action, value);
  if (qn_view_needs_result (self->state->options.view) && tool != &qn_tool_select)
    qn_view_state_set_view (self->state, QN_VIEW_MODEL);
  qn_canvas_set_tool (self->canvas, tool);
  qn_window_show_drawing (self, FALSE);
  gtk_widget_grab_focus (GTK_WIDGET (self->canvas));
}

static void
on_view (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  QnView view;
  if (!qn_find_word (g_variant_get_string (value, NULL), qn_view_names, QN_VIEW_COUNT,
                     &view))
    return;
  if (qn_view_needs_result (view) && self->document->run == NULL) {
    qn_window_show_error (self, _ ("There is no result to show yet: solve first (F5)"));
    return;
  }
  qn_view_state_set_view (self->state, view);
}

static void
on_side_panel (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  g_simple_action_set_state (action, value);
  gtk_widget_set_visible (self->side_panel, g_variant_get_boolean (value));
  qn_window_arrange (self);
}

static void
on_diagram (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  QnDiagram diagram;
  if (!qn_find_word (g_variant_get_string (value, NULL), qn_diagram_names,
                     QN_DIAGRAM_COUNT, &diagram))
    return;
  g_simple_action_set_state (action, value);
  self->state->options.diagram = diagram;
  qn_view_state_changed (self->state);
  if (self->document->run != NULL)
    qn_view_state_set_view (self->state, QN_VIEW_DIAGRAMS);
}

static void
on_field (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  QnField field;
  if (!qn_find_word (g_variant_get_string (value, NULL), qn_field_names, QN_FIELD_COUNT,
                     &field))
    return;
  g_simple_action_set_state (action, value);
  self->state->options.field = field;
  qn_view_state_changed (self->state);
}

static void
on_keep_history (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  qn_document_set_keeps_history (self->document, g_variant_get_boolean (value));
}

static void
on_switch (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  qn_view_state_set_switch (self->state, g_action_get_name (G_ACTION (action)),
                            g_variant_get_boolean (value));
}

static const char *const switches[] = { "ghost", "symbols", "loads",     "dimensions",
                                        "names", "values",  "monochrome" };

/* Switches that are settings: every window has them. */
static const char *const kept[] = { "snap", "grid", "live" };

static void
add_stateful_actions (QnWindow *self)
{
  const GActionEntry entries[] = {
    { .name = "tool",
      .parameter_type = "s",
      .state = "'select'",
      .change_state = on_tool },
    { .name = "view",
      .parameter_type = "s",
      .state = "'model'",
      .change_state = on_view },
    { .name = "diagram",
      .parameter_type = "s",
      .state = "'M'",
      .change_state = on_diagram },
    { .name = "side-panel", .state = "true", .change_state = on_side_panel },
    { .name = "keep-history", .state = "false", .change_state = on_keep_history },
    { .name = "field",
      .parameter_type = "s",
      .state = "'none'",
      .change_state = on_field },
  };
  g_action_map_add_action_entries (G_ACTION_MAP (self), entries, G_N_ELEMENTS (entries),
                                   self);
  for (gsize i = 0; i < G_N_ELEMENTS (switches); i++) {
    g_autoptr (GSimpleAction) action =
      g_simple_action_new_stateful (switches[i], NULL, g_variant_new_boolean (FALSE));
    g_signal_connect (action, "change-state", G_CALLBACK (on_switch), self);
    g_action_map_add_action (G_ACTION_MAP (self), G_ACTION (action));
  }
  for (gsize i = 0; i < G_N_ELEMENTS (kept); i++) {
    g_autoptr (GAction) action = g_settings_create_action (qn_settings_get (), kept[i]);
    g_action_map_add_action (G_ACTION_MAP (self), action);
  }
}

void
qn_window_forget_settings (QnWindow *self)
{
  for (gsize i = 0; i < G_N_ELEMENTS (kept); i++)
    g_action_map_remove_action (G_ACTION_MAP (self), kept[i]);
}

static const QnWindowAction view_actions[] = {
  { "draw", NULL, { new_drawing }, 0 },
  { "zoom-in", NULL, { zoom }, 0 },
  { "zoom-out", NULL, { zoom }, 0 },
  { "fit", NULL, { fit }, 0 },
  { "play", NULL, { play }, QN_NEEDS_RUN },
  { "next-step", NULL, { go_by_step }, QN_NEEDS_RUN },
  { "previous-step", NULL, { go_by_step }, QN_NEEDS_RUN },
  { "show-panel", "s", { show_panel }, 0 },
  { "fullscreen", NULL, { toggle_fullscreen }, 0 },
  { "shortcuts", NULL, { show_shortcuts }, 0 },
  { .name = NULL },
};

/* The first ones have a state. */
static const QnWindowAction stateful_actions[] = {
  { "field", .needs = QN_NEEDS_RUN },
  { "diagram", .needs = QN_NEEDS_RUN | QN_NEEDS_BEAM_FORCES },
  { .name = NULL },
};
static const QnWindowAction *const tables[] = {
  stateful_actions,         view_actions,
  qn_window_edit_actions,   qn_window_file_actions,
  qn_window_import_actions, qn_window_analysis_actions,
  qn_window_export_actions, qn_window_page_actions
};

void
qn_window_add_actions (QnWindow *self)
{
  add_stateful_actions (self);
  for (gsize i = 1; i < G_N_ELEMENTS (tables); i++)
    for (const QnWindowAction *row = tables[i]; row->name != NULL; row++) {
      const char *type = row->parameter;
      g_autoptr (GSimpleAction) action =
        g_simple_action_new (row->name, type != NULL ? G_VARIANT_TYPE (type) : NULL);
      g_signal_connect (action, "activate", G_CALLBACK (on_table_action), self);
      g_object_set_data (G_OBJECT (action), ROW, (gpointer) row);
      g_action_map_add_action (G_ACTION_MAP (self), G_ACTION (action));
    }
}

static QnNeeds
find_facts (QnWindow *self)
{
  QnDocument *document = self->document;
  QnEditHistory *history = document->history;
  QnSelection *selection = document->selection;
  const QnModel *model = &document->project.model;
  const QnRun *run = document->run;
  QnJob *job = document->job;
  gboolean busy = job != NULL && !qn_job_get_run (job)->live;
  gboolean own = qn_window_page_has (self, "undo");
  guint blocks = selection->ids[QN_PICK_BLOCK]->len;
  gboolean parts = blocks > 0 || selection->ids[QN_PICK_BEAM]->len > 0;
  gboolean opening = selection->object != QN_NONE;
  gboolean item = qn_selection_get_item (selection).id != QN_NONE;
  const struct {
    gboolean holds;
    QnNeeds fact;
  } facts[] = {
    { !qn_window_is_blank (self), QN_NEEDS_WORK },
    { model->block_count > 0 || model->beam_count > 0, QN_NEEDS_MODEL },
    { !busy, QN_NEEDS_IDLE },
    { busy || self->reporting != NULL || qn_window_page_can (self, "cancel"),
      QN_NEEDS_JOB },
    { run != NULL, QN_NEEDS_RUN },
    { run != NULL && run->result.beam_forces != NULL, QN_NEEDS_BEAM_FORCES },
    { own ? qn_window_page_can (self, "undo") : history->position > 0, QN_NEEDS_UNDO },
    { own ? qn_window_page_can (self, "redo") : history->position < history->steps->len,
      QN_NEEDS_REDO },
    { blocks > 0, QN_NEEDS_BLOCKS },
    { blocks > 1, QN_NEEDS_TWO_BLOCKS },
    { parts, QN_NEEDS_PARTS },
    { parts || opening, QN_NEEDS_MOVABLE },
    { parts || item, QN_NEEDS_COPYABLE },
    { parts || opening || item, QN_NEEDS_THING },
    { selection->ids[QN_PICK_FACE]->len > 0, QN_NEEDS_FACE },
    { self->last_export != NULL, QN_NEEDS_EXPORTED },
    { !qn_window_page_has (self, "run") || qn_window_page_can (self, "run"),
      QN_NEEDS_READY },
  };
  QnNeeds all = QN_NEEDS_NOTHING;
  for (gsize i = 0; i < G_N_ELEMENTS (facts); i++)
    if (facts[i].holds)
      all |= facts[i].fact;
  return all;
}

static GSimpleAction *
find_action (QnWindow *self, const char *name)
{
  return G_SIMPLE_ACTION (g_action_map_lookup_action (G_ACTION_MAP (self), name));
}

void
qn_window_update_actions (QnWindow *self)
{
  QnNeeds facts = find_facts (self);
  for (gsize i = 0; i < G_N_ELEMENTS (tables); i++)
    for (const QnWindowAction *row = tables[i]; row->name != NULL; row++)
      g_simple_action_set_enabled (find_action (self, row->name),
                                   (row->needs & ~facts) == 0);
  for (gsize i = 0; i < G_N_ELEMENTS (switches); i++)
    g_simple_action_set_state (
      find_action (self, switches[i]),
      g_variant_new_boolean (qn_view_state_get_switch (self->state, switches[i])));
  g_simple_action_set_state (
    find_action (self, "view"),
    g_variant_new_string (qn_view_names[self->state->options.view]));
  g_simple_action_set_state (find_action (self, "keep-history"),
                             g_variant_new_boolean (self->document->keeps_history));
}

/* ---- keys without an accelerator, which entries and the drawing's gestures see first ---- */

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnWindow *self)
{
  GtkWidget *focus = gtk_window_get_focus (GTK_WINDOW (self));
  gboolean on_drawing = focus == NULL || focus == GTK_WIDGET (self->canvas);
  if (keyval == GDK_KEY_Escape && qn_window_get_page (self) != NULL
      && (!gtk_widget_get_mapped (GTK_WIDGET (self->canvas))
          || (focus != NULL && gtk_widget_is_ancestor (focus, self->page_box)))) {
    qn_window_show_drawing (self, TRUE);
    return TRUE;
  }
  if (qn_window_is_blank (self) || GTK_IS_EDITABLE (focus) || GTK_IS_TEXT_VIEW (focus))
    return FALSE;
  gboolean shift = (modifiers & GDK_SHIFT_MASK) != 0;
  if (keyval == GDK_KEY_Menu || (keyval == GDK_KEY_F10 && shift))
    return focus != NULL && qn_context_menu_open (focus);
  if (keyval == GDK_KEY_Escape && !on_drawing)
    return gtk_event_controller_key_forward (controller, GTK_WIDGET (self->canvas));
  if (self->canvas->in_gesture && (modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK)) == 0)
    return FALSE;
  g_autofree char *detailed = qn_action_dup_for_key (keyval, modifiers, on_drawing);
  g_autofree char *name = NULL;
  g_autoptr (GVariant) target = NULL;
  return detailed != NULL && g_action_parse_detailed_name (detailed, &name, &target, NULL)
         && gtk_widget_activate_action_variant (GTK_WIDGET (self), name, target);
}

void
qn_window_add_keys (QnWindow *self)
{
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (GTK_WIDGET (self), key);
}
