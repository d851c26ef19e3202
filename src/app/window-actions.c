#include "app/window-private.h"

#include "app/panel.h"
#include "app/settings.h"
#include <glib/gi18n.h>

/* px on the screen that an arrow key moves the selection by, when there is no grid. */
#define NUDGE_PX 5.0

#define ZOOM_FACTOR 1.25

static void
on_table_action (GSimpleAction *action, GVariant *parameter, gpointer data)
{
  const QnWindowAction *row = g_object_get_data (G_OBJECT (action), "qn-row");
  row->func (data, parameter);
}

void
qn_window_add_action_table (QnWindow *self, const QnWindowAction *actions, gsize count)
{
  for (gsize i = 0; i < count; i++) {
    const char *type = actions[i].parameter;
    g_autoptr (GSimpleAction) action =
      g_simple_action_new (actions[i].name, type != NULL ? G_VARIANT_TYPE (type) : NULL);
    g_object_set_data (G_OBJECT (action), "qn-row", (gpointer) &actions[i]);
    g_signal_connect (action, "activate", G_CALLBACK (on_table_action), self);
    g_action_map_add_action (G_ACTION_MAP (self), G_ACTION (action));
  }
}

/* ---- editing ---- */

typedef struct Edit {
  QnBlockSet set;
  QnTransform transform;
  int copies;
} Edit;

static QnBlockSet
dup_selected (QnWindow *self)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_document_get_selection (self->document), &count);
  return (QnBlockSet){ g_memdup2 (ids, count * sizeof *ids), count };
}

static gboolean
edit_delete (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_delete_blocks (model, ((const Edit *) data)->set, error);
}

static gboolean
edit_detach (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_detach (model, ((const Edit *) data)->set, error);
}

static gboolean
edit_transform (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  return qn_edit_transform_blocks (model, edit->set, edit->transform, error);
}

static gboolean
edit_copy (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  return qn_edit_copy_blocks (model, edit->set, edit->transform, edit->copies, error);
}

static void
edit_selection (QnWindow *self, const char *name, const char *key, QnEditFunc func,
                Edit edit)
{
  edit.set = dup_selected (self);
  qn_canvas_edit (self->canvas, name, key, func, &edit);
  g_free ((gpointer) edit.set.ids);
}

static void
delete_selected (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  edit_selection (self, _ ("Delete"), NULL, edit_delete, (Edit){ 0 });
}

static void
detach (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  edit_selection (self, _ ("Detach Wall"), NULL, edit_detach, (Edit){ 0 });
}

/* Box around the selected blocks. */
static gboolean
selected_box (QnWindow *self, QnVec2 *low, QnVec2 *high)
{
  const QnModel *model = qn_document_get_model (self->document);
  QnBlockSet set = dup_selected (self);
  *low = qn_vec2 (INFINITY, INFINITY);
  *high = qn_vec2 (-INFINITY, -INFINITY);
  for (guint i = 0; i < set.count; i++) {
    const QnVec2 *v = qn_model_block_vertices (model, set.ids[i]);
    for (QnId k = 0; k < model->blocks[set.ids[i]].vertex_count; k++) {
      *low = qn_vec2 (MIN (low->x, v[k].x), MIN (low->y, v[k].y));
      *high = qn_vec2 (MAX (high->x, v[k].x), MAX (high->y, v[k].y));
    }
  }
  g_free ((gpointer) set.ids);
  return low->x <= high->x;
}

static void
mirror (QnWindow *self, GVariant *parameter)
{
  QnVec2 low, high;
  if (!selected_box (self, &low, &high))
    return;
  QnVec2 middle = qn_vec2_lerp (low, high, 0.5);
  gboolean vertical = g_str_equal (g_variant_get_string (parameter, NULL), "vertical");
  QnVec2 other =
    vertical ? qn_vec2 (middle.x, middle.y + 1.0) : qn_vec2 (middle.x + 1.0, middle.y);
  edit_selection (self, _ ("Mirror"), NULL, edit_transform,
                  (Edit){ .transform = qn_transform_mirror (middle, other) });
}

/* Degrees, counter-clockwise, about the middle of the selection. */
static void
rotate (QnWindow *self, GVariant *parameter)
{
  QnVec2 low, high;
  if (!selected_box (self, &low, &high))
    return;
  double angle = g_variant_get_double (parameter) * G_PI / 180.0;
  edit_selection (
    self, _ ("Rotate"), NULL, edit_transform,
    (Edit){ .transform = qn_transform_rotation (qn_vec2_lerp (low, high, 0.5), angle) });
}

/* A copy beside the original, selected for the next step. */
static void
duplicate (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  QnVec2 low, high;
  if (!selected_box (self, &low, &high))
    return;
  gsize before = qn_document_get_model (self->document)->block_count;
  g_autofree char *text = g_strdup (qn_document_get_text (self->document));
  edit_selection (
    self, _ ("Duplicate"), NULL, edit_copy,
    (Edit){ .transform = qn_transform_translation (1.25 * (high.x - low.x), 0.0),
            .copies = 1 });
  const QnModel *model = qn_document_get_model (self->document);
  if (g_str_equal (text, qn_document_get_text (self->document)))
    return;
  /* Free blocks stand before those of walls; the new ones are the last of them. */
  gsize free_count = 0;
  while (free_count < model->block_count && model->blocks[free_count].wall == QN_NONE)
    free_count++;
  gsize added = model->block_count - before;
  g_autofree QnId *ids = g_new (QnId, added + 1);
  for (gsize i = 0; i < added; i++)
    ids[i] = (QnId) (free_count - added + i);
  qn_selection_set_blocks (qn_document_get_selection (self->document), ids,
                           (guint) added);
}

/* Copies side by side: (number, dx, dy). */
static void
array (QnWindow *self, GVariant *parameter)
{
  int copies;
  double dx, dy;
  g_variant_get (parameter, "(idd)", &copies, &dx, &dy);
  edit_selection (self, _ ("Array"), NULL, edit_copy,
                  (Edit){ .transform = qn_transform_translation (dx, dy),
                          .copies = CLAMP (copies, 1, 10000) });
}

static void
nudge (QnWindow *self, GVariant *parameter)
{
  double dx, dy;
  g_variant_get (parameter, "(dd)", &dx, &dy);
  double step =
    qn_magnet_round_distance (NUDGE_PX / qn_canvas_get_camera (self->canvas)->scale);
  edit_selection (self, _ ("Nudge"), "nudge", edit_transform,
                  (Edit){ .transform = qn_transform_translation (dx * step, dy * step) });
}

static void
undo (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_document_undo (self->document);
}

static void
redo (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_document_redo (self->document);
}

static void
select_all (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_selection_select_all (qn_document_get_selection (self->document),
                           qn_document_get_model (self->document));
}

static void
select_like (QnWindow *self, GVariant *parameter)
{
  const char *what = g_variant_get_string (parameter, NULL);
  QnSelection *selection = qn_document_get_selection (self->document);
  const QnModel *model = qn_document_get_model (self->document);
  guint count = 0;
  const QnId *ids = qn_selection_get_blocks (selection, &count);
  if (count == 0)
    return;
  QnId block = ids[0];
  if (g_str_equal (what, "course"))
    qn_selection_select_course (selection, model, block);
  else if (g_str_equal (what, "wall"))
    qn_selection_select_wall (selection, model, block);
  else
    qn_selection_select_same_law (selection, model, block);
}

/* ---- clipboard: blocks travel as a project of their own ---- */

static void
copy (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  QnBlockSet set = dup_selected (self);
  const QnModel *model = qn_document_get_model (self->document);
  GString *text = g_string_new ("quoin-blocks\n");
  for (guint i = 0; i < set.count; i++) {
    const QnBlock *block = &model->blocks[set.ids[i]];
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append_printf (text, "%d %d", block->vertex_count,
                            block->support[QN_DOF_UX] && block->support[QN_DOF_UY]);
    g_string_append_printf (text, " %s",
                            g_ascii_dtostr (number, sizeof number, block->thickness));
    g_string_append_printf (text, " %s",
                            g_ascii_dtostr (number, sizeof number, block->unit_weight));
    const QnVec2 *v = qn_model_block_vertices (model, set.ids[i]);
    for (QnId k = 0; k < block->vertex_count; k++) {
      g_string_append_printf (text, " %s",
                              g_ascii_dtostr (number, sizeof number, v[k].x));
      g_string_append_printf (text, " %s",
                              g_ascii_dtostr (number, sizeof number, v[k].y));
    }
    g_string_append_c (text, '\n');
  }
  if (set.count > 0)
    gdk_clipboard_set_text (gtk_widget_get_clipboard (GTK_WIDGET (self)), text->str);
  g_string_free (text, TRUE);
  g_free ((gpointer) set.ids);
}

static void
cut (QnWindow *self, GVariant *parameter)
{
  copy (self, parameter);
  edit_selection (self, _ ("Cut"), NULL, edit_delete, (Edit){ 0 });
}

/* One line of what copy() wrote. */
static gboolean
paste_line (QnModel *model, const char *line, double offset, GError **error)
{
  char *at = (char *) line;
  double head[4];
  for (int i = 0; i < 4; i++)
    head[i] = g_ascii_strtod (at, &at);
  int count = (int) CLAMP (head[0], 3.0, 1e5);
  bool fixed = head[1] != 0.0;
  QnBlockStyle style = { head[2], head[3], QN_NONE, { fixed, fixed, fixed } };
  g_autofree QnVec2 *vertices = g_new (QnVec2, (gsize) count);
  for (int i = 0; i < count; i++) {
    vertices[i].x = g_ascii_strtod (at, &at) + offset;
    vertices[i].y = g_ascii_strtod (at, &at);
  }
  return qn_edit_add_block (model, vertices, (guint) count, style, error);
}

static gboolean
edit_paste (QnModel *model, gpointer data, GError **error)
{
  g_auto (GStrv) lines = g_strsplit (data, "\n", -1);
  if (!g_str_equal (lines[0], "quoin-blocks")) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("There are no blocks on the clipboard"));
    return FALSE;
  }
  /* Beside everything there is, where nothing overlaps. */
  double left = INFINITY, right = -INFINITY;
  for (gsize i = 0; i < model->vertex_count; i++)
    right = MAX (right, model->vertices[i].x);
  for (int i = 1; lines[i] != NULL && *lines[i] != '\0'; i++) {
    char *at = lines[i];
    for (int k = 0; k < 4; k++)
      g_ascii_strtod (at, &at);
    while (*at != '\0') {
      char *before = at;
      left = MIN (left, g_ascii_strtod (at, &at));
      g_ascii_strtod (at, &at);
      if (at == before)
        break;
    }
  }
  double offset = isfinite (left) && isfinite (right)
                    ? right - left + model->characteristic_length
                    : 0.0;
  for (int i = 1; lines[i] != NULL && *lines[i] != '\0'; i++) {
    if (!paste_line (model, lines[i], offset, error))
      return FALSE;
  }
  return TRUE;
}

static void
on_clipboard_text (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (QnWindow) self = data;
  g_autofree char *text =
    gdk_clipboard_read_text_finish (GDK_CLIPBOARD (source), result, NULL);
  qn_canvas_edit (self->canvas, _ ("Paste"), NULL, edit_paste,
                  text != NULL ? text : (char *) "");
}

static void
paste (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  gdk_clipboard_read_text_async (gtk_widget_get_clipboard (GTK_WIDGET (self)), NULL,
                                 on_clipboard_text, g_object_ref (self));
}

/* ---- viewing ---- */

static void
new_drawing (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_window_show_work (self);
  gtk_widget_activate_action (GTK_WIDGET (self), "win.tool", "s", "wall");
}

static void
zoom_in (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_canvas_zoom (self->canvas, ZOOM_FACTOR);
}

static void
zoom_out (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_canvas_zoom (self->canvas, 1.0 / ZOOM_FACTOR);
}

static void
fit (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_canvas_fit (self->canvas);
}

static void
play (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_playback_bar_toggle (self->playback);
}

static void
go_by_steps (QnWindow *self, int by)
{
  const QnRun *run = qn_document_get_run (self->document);
  if (run == NULL || run->result.step_count == 0)
    return;
  int last = (int) run->result.step_count - 1;
  int step = qn_view_state_get_step (self->state);
  if (!qn_view_needs_result (qn_view_state_get_view (self->state)))
    qn_view_state_set_view (self->state, QN_VIEW_DEFORMED);
  qn_view_state_set_step (self->state,
                          CLAMP ((step == QN_STEP_LAST ? last : step) + by, 0, last));
}

static void
next_step (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  go_by_steps (self, 1);
}

static void
previous_step (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  go_by_steps (self, -1);
}

static void
show_panel (QnWindow *self, GVariant *parameter)
{
  gtk_stack_set_visible_child_name (self->side_stack,
                                    g_variant_get_string (parameter, NULL));
}

static void
toggle_fullscreen (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  if (gtk_window_is_fullscreen (GTK_WINDOW (self)))
    gtk_window_unfullscreen (GTK_WINDOW (self));
  else
    gtk_window_fullscreen (GTK_WINDOW (self));
}

static void
export_figure (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_export_dialog_show (self);
}

static void
repeat_export (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_export_repeat (self);
}

static void
compare (QnWindow *self, GVariant *parameter)
{
  (void) parameter;
  qn_compare_window_show (self);
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
  if (qn_view_needs_result (qn_view_state_get_view (self->state))
      && tool != &qn_tool_select)
    qn_view_state_set_view (self->state, QN_VIEW_MODEL);
  qn_canvas_set_tool (self->canvas, tool);
  gtk_widget_grab_focus (GTK_WIDGET (self->canvas));
}

static void
on_view (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  QnView view;
  (void) action;
  if (!qn_view_parse (g_variant_get_string (value, NULL), &view))
    return;
  if (qn_view_needs_result (view) && qn_document_get_run (self->document) == NULL)
    return;
  qn_view_state_set_view (self->state, view);
}

static void
on_switch (GSimpleAction *action, GVariant *value, gpointer data)
{
  QnWindow *self = data;
  g_simple_action_set_state (action, value);
  qn_view_state_set_switch (self->state, g_action_get_name (G_ACTION (action)),
                            g_variant_get_boolean (value));
}

static const char *const switches[] = { "ghost",      "symbols", "loads",
                                        "dimensions", "names",   "monochrome" };

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
  };
  g_action_map_add_action_entries (G_ACTION_MAP (self), entries, G_N_ELEMENTS (entries),
                                   self);
  for (gsize i = 0; i < G_N_ELEMENTS (switches); i++) {
    gboolean on = qn_view_state_get_switch (self->state, switches[i]);
    g_autoptr (GSimpleAction) action =
      g_simple_action_new_stateful (switches[i], NULL, g_variant_new_boolean (on));
    g_signal_connect (action, "change-state", G_CALLBACK (on_switch), self);
    g_action_map_add_action (G_ACTION_MAP (self), G_ACTION (action));
  }
  static const char *const kept[] = { "snap", "grid", "live" };
  for (gsize i = 0; i < G_N_ELEMENTS (kept); i++) {
    g_autoptr (GAction) action = g_settings_create_action (qn_settings_get (), kept[i]);
    g_action_map_add_action (G_ACTION_MAP (self), action);
  }
}

void
qn_window_add_actions (QnWindow *self)
{
  static const QnWindowAction actions[] = {
    { "delete", NULL, delete_selected },
    { "detach", NULL, detach },
    { "mirror", "s", mirror },
    { "rotate", "d", rotate },
    { "duplicate", NULL, duplicate },
    { "array", "(idd)", array },
    { "nudge", "(dd)", nudge },
    { "undo", NULL, undo },
    { "redo", NULL, redo },
    { "select-all", NULL, select_all },
    { "select-like", "s", select_like },
    { "copy", NULL, copy },
    { "cut", NULL, cut },
    { "paste", NULL, paste },
    { "draw", NULL, new_drawing },
    { "zoom-in", NULL, zoom_in },
    { "zoom-out", NULL, zoom_out },
    { "fit", NULL, fit },
    { "play", NULL, play },
    { "next-step", NULL, next_step },
    { "previous-step", NULL, previous_step },
    { "show-panel", "s", show_panel },
    { "fullscreen", NULL, toggle_fullscreen },
    { "export", NULL, export_figure },
    { "repeat-export", NULL, repeat_export },
    { "compare", NULL, compare },
  };
  qn_window_add_action_table (self, actions, G_N_ELEMENTS (actions));
  add_stateful_actions (self);
}

static void
set_enabled (QnWindow *self, const char *name, gboolean enabled)
{
  GAction *action = g_action_map_lookup_action (G_ACTION_MAP (self), name);
  if (action != NULL)
    g_simple_action_set_enabled (G_SIMPLE_ACTION (action), enabled);
}

void
qn_window_update_actions (QnWindow *self)
{
  QnHistory *history = qn_document_get_history (self->document);
  guint selected = 0;
  qn_selection_get_blocks (qn_document_get_selection (self->document), &selected);
  gboolean work = !qn_window_is_blank (self);
  gboolean blocks = qn_document_get_model (self->document)->block_count > 0;
  gboolean run = qn_document_get_run (self->document) != NULL;
  gboolean busy = qn_document_get_job (self->document) != NULL;
  const struct {
    const char *name;
    gboolean enabled;
  } states[] = { { "undo", work && qn_history_can_undo (history) },
                 { "redo", work && qn_history_can_redo (history) },
                 { "delete", selected > 0 },
                 { "detach", selected > 0 },
                 { "mirror", selected > 0 },
                 { "rotate", selected > 0 },
                 { "duplicate", selected > 0 },
                 { "array", selected > 0 },
                 { "nudge", selected > 0 },
                 { "copy", selected > 0 },
                 { "cut", selected > 0 },
                 { "select-like", selected > 0 },
                 { "select-all", blocks },
                 { "paste", work },
                 { "save", work },
                 { "save-as", work },
                 { "run", work && blocks && !busy },
                 { "run-limit", work && blocks && !busy },
                 { "cancel", busy },
                 { "pause", busy },
                 { "play", run },
                 { "export-result", run },
                 { "export-result-path", run },
                 { "next-step", run },
                 { "previous-step", run },
                 { "export", work && blocks },
                 { "repeat-export", work && self->last_export != NULL },
                 { "compare", qn_document_get_runs (self->document)->len > 0 } };
  for (gsize i = 0; i < G_N_ELEMENTS (states); i++)
    set_enabled (self, states[i].name, states[i].enabled);

  GAction *view = g_action_map_lookup_action (G_ACTION_MAP (self), "view");
  g_simple_action_set_state (
    G_SIMPLE_ACTION (view),
    g_variant_new_string (qn_view_name (qn_view_state_get_view (self->state))));
}
