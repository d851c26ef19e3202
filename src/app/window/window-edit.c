/* Actions that change the drawing: what is selected is moved, copied and deleted, undone and done
 * again, and travels by the clipboard. */
#include "app/tools/tools.h"
#include "app/window/window-private.h"

#include "doc/edit/edit-masonry.h"
#include "doc/edit/edit-shape.h"
#include <glib/gi18n.h>

/* px on the screen that an arrow key moves the selection by, when there is no grid. */
#define NUDGE_PX 5.0

/* Places beside their old one, a quarter of their width apart, that are tried for pasted blocks. */
#define MOST_PLACES 400

/* Of the blocks alone: beams do not travel by the clipboard, nor have they walls or are joined. */
static void
edit_blocks (QnWindow *self, const char *name,
             gboolean (*func) (QnModel *model, QnBlockSet set, GError **error))
{
  QnCanvasDraft draft;
  if (qn_canvas_begin_edit (self->canvas, &draft))
    qn_canvas_end_edit (self->canvas, &draft, name, NULL,
                        func (draft.model,
                              qn_selection_get_parts (self->canvas->selection).blocks,
                              &draft.error));
}

/* ---- openings ---- */

typedef struct OpeningEdit {
  QnId object;
  int opening;
  double dx, dy; /* half blocks, courses */
} OpeningEdit;

static gboolean
move_opening (QnMasonry *masonry, gpointer data, GError **error)
{
  const OpeningEdit *edit = data;
  const QnLeaf *leaf = &masonry->wall.leaves[0];
  QnOpening *opening = &masonry->wall.openings[edit->opening];
  opening->at.x += edit->dx * 0.5 * leaf->unit.x;
  opening->at.y += edit->dy * leaf->unit.y;
  return TRUE;
}

/* The selected opening; FALSE where there is none. */
static gboolean
selected_opening (QnWindow *self, OpeningEdit *edit)
{
  const QnMasonries *list = qn_canvas_get_masonry (self->canvas);
  edit->object = self->document->selection->object;
  edit->opening = self->document->selection->opening;
  return edit->object != QN_NONE && (gsize) edit->object < list->count
         && (gsize) edit->opening < list->items[edit->object].wall.opening_count;
}

/* ---- loads and bars ---- */

/* Names of the steps that remove and copy one. */
static const char *const item_steps[][2] = {
  [QN_PICK_DEAD_LOAD] = { N_ ("Remove Load"), N_ ("Duplicate Load") },
  [QN_PICK_LIVE_LOAD] = { N_ ("Remove Load"), N_ ("Duplicate Load") },
  [QN_PICK_BAR] = { N_ ("Remove Bar"), N_ ("Duplicate Bar") },
  [QN_PICK_TIE] = { N_ ("Remove Tie"), N_ ("Duplicate Tie") },
};

/* Removes or copies the selected one, and selects the copy. FALSE where none is selected. */
static gboolean
edit_item (QnWindow *self, gboolean copy)
{
  QnPick item = qn_selection_get_item (self->document->selection);
  QnCanvasDraft draft;
  if (item.id == QN_NONE)
    return FALSE;
  if (!copy)
    qn_selection_clear (self->document->selection);
  if (!qn_canvas_begin_edit (self->canvas, &draft))
    return TRUE;
  if (copy)
    item.id = qn_edit_duplicate_item (draft.model, item.kind, item.id, &draft.error);
  const gboolean done =
    copy ? item.id != QN_NONE
         : qn_edit_remove_item (draft.model, item.kind, item.id, &draft.error);
  if (qn_canvas_end_edit (self->canvas, &draft, _ (item_steps[item.kind][copy]), NULL,
                          done)
      && copy)
    qn_selection_set_one (self->document->selection, item.kind, item.id);
  return TRUE;
}

/* ---- actions ---- */

static void
delete_selected (QnWindow *self, const char *name)
{
  OpeningEdit opening = { 0 };
  const gboolean is_opening = selected_opening (self, &opening);
  const QnPartSet parts = qn_selection_get_parts (self->canvas->selection);
  QnCanvasDraft draft;
  if (edit_item (self, FALSE))
    return;
  if (is_opening)
    qn_selection_clear (self->document->selection);
  if (qn_canvas_begin_edit (self->canvas, &draft))
    qn_canvas_end_edit (
      self->canvas, &draft, is_opening ? _ ("Fill Opening") : _ ("Delete"), NULL,
      is_opening ? qn_edit_remove_opening (&draft.project, opening.object,
                                           (gsize) opening.opening, &draft.error)
                 : qn_edit_delete_all (draft.model, parts, &draft.error));
}

static void
detach (QnWindow *self, const char *name)
{
  edit_blocks (self, _ ("Detach into Free Blocks"), qn_edit_detach);
}

static void
join (QnWindow *self, const char *name)
{
  edit_blocks (self, _ ("Join Blocks"), qn_edit_join_blocks);
}

/* Each body of the mechanism that is shown becomes one block, whose corners can be dragged. */
static void
join_bodies (QnWindow *self, const char *name)
{
  const QnRun *run = self->document->run;
  QnMechanism mechanism = { 0 };
  QnCanvasDraft draft;
  if (run->result.mechanism == NULL || qn_document_is_stale (self->document, run)
      || qn_mechanism_of_result (&mechanism, &run->model, &run->contacts, &run->result,
                                 NULL)
           != QN_OK)
    qn_canvas_tell (self->canvas,
                    _ ("The chosen result has no mechanism of the drawing"));
  else if (qn_canvas_begin_edit (self->canvas, &draft))
    qn_canvas_end_edit (self->canvas, &draft, _ ("Make Mechanism"), NULL,
                        qn_edit_join_bodies (draft.model, &mechanism, &draft.error));
  qn_mechanism_clear (&mechanism);
}

static void
mirror (QnWindow *self, const char *axis)
{
  QnVec2 low, high;
  if (!qn_canvas_get_parts_box (self->canvas, &low, &high))
    return;
  QnVec2 middle = qn_vec2_lerp (low, high, 0.5);
  gboolean vertical = g_str_equal (axis, "vertical");
  QnVec2 other =
    vertical ? qn_vec2 (middle.x, middle.y + 1.0) : qn_vec2 (middle.x + 1.0, middle.y);
  qn_canvas_transform (self->canvas, _ ("Mirror"), NULL,
                       qn_transform_mirror (middle, other), 0);
}

/* Copies, each turned about the middle of the selection, rad, and moved against the one before; 0: itself. */
static void
repeat (QnWindow *self, const char *name, double turn, QnVec2 by, int copies)
{
  QnVec2 low, high;
  if (qn_canvas_get_parts_box (self->canvas, &low, &high))
    qn_canvas_transform (
      self->canvas, name, NULL,
      qn_transform_compose (qn_transform_rotation (qn_vec2_lerp (low, high, 0.5), turn),
                            qn_transform_translation (by.x, by.y)),
      copies);
}

/* Degrees, counter-clockwise. */
static void
rotate (QnWindow *self, GVariant *parameter)
{
  repeat (self, _ ("Rotate"), g_variant_get_double (parameter) * G_PI / 180.0,
          qn_vec2 (0.0, 0.0), 0);
}

/* What an edit has added: named otherwise than everything that was there. */
static void
select_added (QnWindow *self, const QnModel *before)
{
  const QnModel *model = &self->document->project.model;
  QnSelection *selection = self->document->selection;
  g_autoptr (GArray) added = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    if (qn_model_find_block (before, model->blocks[i].name) == QN_NONE)
      g_array_append_val (added, i);
  }
  guint blocks = added->len;
  for (QnId i = 0; i < (QnId) model->beam_count; i++) {
    if (qn_model_find_beam (before, model->beams[i].name) == QN_NONE)
      g_array_append_val (added, i);
  }
  if (added->len == 0)
    return;
  const QnId *ids = (const QnId *) added->data;
  qn_selection_set (selection, QN_PICK_BLOCK, ids, blocks);
  qn_selection_add (selection, QN_PICK_BEAM, ids + blocks, added->len - blocks);
}

/* A copy beside the original, selected for the next step; beside it by a part of its height where
 * it has no width. */
static void
duplicate (QnWindow *self, const char *name)
{
  QnVec2 low, high;
  QnModel before;
  if (edit_item (self, TRUE) || !qn_canvas_get_parts_box (self->canvas, &low, &high)
      || qn_model_copy (&self->document->project.model, &before, NULL) != QN_OK)
    return;
  double aside = 1.25 * (high.x - low.x);
  if (!(aside > 0.0))
    aside = 0.25 * (high.y - low.y);
  qn_canvas_transform (self->canvas, _ ("Duplicate"), NULL,
                       qn_transform_translation (aside, 0.0), 1);
  select_added (self, &before);
  qn_model_clear (&before);
}

/* Copies (number, right, up, turn in rad), each moved and turned against the one before: a row, or
 * with a turn a ring. */
static void
array (QnWindow *self, GVariant *parameter)
{
  int copies;
  double dx, dy, turn;
  g_variant_get (parameter, "(iddd)", &copies, &dx, &dy, &turn);
  repeat (self, _ ("Array"), turn, qn_vec2 (dx, dy), CLAMP (copies, 1, 10000));
}

static void
nudge (QnWindow *self, GVariant *parameter)
{
  double dx, dy;
  OpeningEdit opening = { 0 };
  QnCanvasDraft draft;
  g_variant_get (parameter, "(dd)", &dx, &dy);
  if (selected_opening (self, &opening)) {
    opening.dx = dx;
    opening.dy = dy;
    if (qn_canvas_begin_edit (self->canvas, &draft))
      qn_canvas_end_edit (self->canvas, &draft, _ ("Move Opening"), "nudge-opening",
                          qn_edit_change_masonry (&draft.project, opening.object,
                                                  move_opening, &opening, &draft.error));
    return;
  }
  double step = qn_magnet_round_distance (NUDGE_PX / self->canvas->camera.scale);
  qn_canvas_transform (self->canvas, _ ("Move"), "nudge",
                       qn_transform_translation (dx * step, dy * step), 0);
}

static void
undo_or_redo (QnWindow *self, const char *name)
{
  if (!qn_window_page_does (self, name))
    (g_str_equal (name, "undo") ? qn_document_undo : qn_document_redo) (self->document);
}

static void
go_to_step (QnWindow *self, GVariant *parameter)
{
  qn_document_go_to (self->document, (guint) g_variant_get_int32 (parameter));
}

/* The run that is shown leaves the list. */
static void
remove_run (QnWindow *self, const char *name)
{
  qn_document_remove_run (self->document, self->document->run);
}

static void
select_all (QnWindow *self, const char *name)
{
  qn_selection_select_all (self->document->selection, &self->document->project.model);
}

static void
select_like (QnWindow *self, const char *what)
{
  const QnModel *model = &self->document->project.model;
  const QnId block = qn_selection_get_one (self->document->selection, QN_PICK_BLOCK);
  if (block == QN_NONE)
    return;
  qn_selection_select_blocks_like (self->document->selection, model, block,
                                   g_str_equal (what, "course") ? QN_LIKE_COURSE
                                   : g_str_equal (what, "wall") ? QN_LIKE_WALL
                                                                : QN_LIKE_LAW);
}

static void
select_faces_like (QnWindow *self, const char *what)
{
  const QnContacts *contacts = &self->document->contacts;
  QnId face = qn_selection_get_one (self->document->selection, QN_PICK_FACE);
  if (face == QN_NONE || (gsize) face >= contacts->face_count)
    return;
  qn_selection_select_faces_like (self->document->selection, contacts, face,
                                  g_str_equal (what, "line")        ? QN_LIKE_LINE
                                  : g_str_equal (what, "direction") ? QN_LIKE_DIRECTION
                                                                    : QN_LIKE_LAW);
}

/* ---- supports, joints, loads of context menus ---- */

static void
hold (QnWindow *self, const char *how)
{
  static const struct {
    const char *name;
    bool support[QN_DOF_COUNT];
  } kinds[] = { { "fixed", { true, true, true } },
                { "pinned", { true, true, false } },
                { "roller", { false, true, false } },
                { "free", { false, false, false } } };
  QnCanvasDraft draft;
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++)
    if (g_str_equal (kinds[i].name, how) && qn_canvas_begin_edit (self->canvas, &draft))
      qn_canvas_end_edit (
        self->canvas, &draft, _ ("Set Support"), NULL,
        qn_edit_set_support (draft.model,
                             qn_selection_get_parts (self->canvas->selection).blocks,
                             QN_DOF_UX, QN_DOF_COUNT, kinds[i].support, &draft.error));
}

static void
set_joint_law (QnWindow *self, const char *law)
{
  guint count = 0;
  const QnId *ids = qn_selection_get (self->document->selection, QN_PICK_FACE, &count);
  qn_tool_joint_set_law (self->canvas, ids, count, law);
}

/* A row of a list. */
static void
copy_text (QnWindow *self, const char *text)
{
  gdk_clipboard_set_text (gtk_widget_get_clipboard (GTK_WIDGET (self)), text);
}

/* ---- clipboard: blocks travel as text ---- */

/* Of each whether it is fixed, thickness, unit weight, corners. */
#define BLOCKS_TYPE  "a(bdda(dd))"
#define BLOCK_FORMAT "(bdd@a(dd))"

static void
copy (QnWindow *self, const char *name)
{
  QnBlockSet set = qn_selection_get_parts (self->canvas->selection).blocks;
  const QnModel *model = &self->document->project.model;
  GVariantBuilder blocks;
  g_variant_builder_init (&blocks, G_VARIANT_TYPE (BLOCKS_TYPE));
  for (guint i = 0; i < set.count; i++) {
    const QnBlock *block = &model->blocks[set.ids[i]];
    const QnVec2 *v = qn_model_block_vertices (model, set.ids[i]);
    g_variant_builder_add (
      &blocks, BLOCK_FORMAT, block->support[QN_DOF_UX] && block->support[QN_DOF_UY],
      block->thickness, block->unit_weight,
      g_variant_new_fixed_array (G_VARIANT_TYPE ("(dd)"), v, (gsize) block->vertex_count,
                                 sizeof *v));
  }
  g_autoptr (GVariant) all = g_variant_ref_sink (g_variant_builder_end (&blocks));
  g_autofree char *text = g_variant_print (all, FALSE);
  if (set.count > 0)
    gdk_clipboard_set_text (gtk_widget_get_clipboard (GTK_WIDGET (self)), text);
}

static void
cut (QnWindow *self, const char *name)
{
  copy (self, name);
  edit_blocks (self, _ ("Cut"), qn_edit_delete_blocks);
}

/* Blocks of BLOCKS_TYPE, moved. */
static gboolean
add_blocks (QnModel *model, GVariant *blocks, QnVec2 by, GError **error)
{
  GVariantIter iter;
  GVariant *corners;
  gboolean fixed, done = TRUE;
  QnBlockStyle style = { .law = QN_NONE };
  g_variant_iter_init (&iter, blocks);
  while (done
         && g_variant_iter_next (&iter, BLOCK_FORMAT, &fixed, &style.thickness,
                                 &style.unit_weight, &corners)) {
    gsize count;
    const QnVec2 *v = g_variant_get_fixed_array (corners, &count, sizeof *v);
    g_autofree QnVec2 *vertices = g_new (QnVec2, count);
    for (gsize k = 0; k < count; k++)
      vertices[k] = qn_vec2_add (v[k], by);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      style.support[dof] = fixed;
    done = qn_edit_add_block (model, vertices, (guint) count, style, error);
    g_variant_unref (corners);
  }
  return done;
}

/* Whether no block reaches into the moved box. */
static gboolean
is_free (const QnModel *model, QnBox box, QnVec2 by)
{
  const double touch = 1e-9 * (1.0 + qn_box_diagonal (box));
  const QnBox moved = { qn_vec2_add (box.min, by), qn_vec2_add (box.max, by) };
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (qn_box_meets_within (moved, qn_model_block_box (model, i), -touch))
      return FALSE;
  return TRUE;
}

/* Where they were, if that is free by now; else beside that, as near as there is room; else beside
 * everything. */
static QnVec2
find_room (const QnModel *model, QnBox box)
{
  double width = box.max.x - box.min.x;
  if (is_free (model, box, qn_vec2 (0.0, 0.0)))
    return qn_vec2 (0.0, 0.0);
  for (int i = 1; i <= MOST_PLACES; i++)
    for (int side = 1; side >= -1; side -= 2) {
      QnVec2 by = qn_vec2 (0.25 * side * (i + 4) * width, 0.0);
      if (is_free (model, box, by))
        return by;
    }
  const QnBox all = qn_box_of_points (model->vertices, model->vertex_count);
  return qn_vec2 (all.max.x - box.min.x + 0.25 * width, 0.0);
}

static void
on_clipboard_text (GObject *source, GAsyncResult *result, gpointer data)
{
  g_autoptr (QnWindow) self = data;
  g_autofree char *text =
    gdk_clipboard_read_text_finish (GDK_CLIPBOARD (source), result, NULL);
  if (self->canvas == NULL) /* the window was closed meanwhile */
    return;
  /* A clipboard without text has no blocks either, nor has what copy() has not written. */
  g_autoptr (GVariant) blocks = g_variant_parse (
    G_VARIANT_TYPE (BLOCKS_TYPE), text != NULL ? text : "", NULL, NULL, NULL);
  QnBox box = QN_BOX_EMPTY;
  for (gsize i = 0; blocks != NULL && i < g_variant_n_children (blocks); i++) {
    gsize count;
    g_autoptr (GVariant) block = g_variant_get_child_value (blocks, i);
    g_autoptr (GVariant) corners = g_variant_get_child_value (block, 3);
    const QnVec2 *v = g_variant_get_fixed_array (corners, &count, sizeof *v);
    qn_box_add_box (&box, qn_box_of_points (v, count));
  }
  if (!(box.min.x <= box.max.x)) {
    qn_window_show_error (self, _ ("There are no blocks on the clipboard"));
    return;
  }
  const QnModel *model = &self->document->project.model;
  QnModel before;
  if (qn_model_copy (model, &before, NULL) != QN_OK)
    return;
  const QnVec2 by = find_room (model, box);
  QnCanvasDraft draft;
  if (qn_canvas_begin_edit (self->canvas, &draft)
      && qn_canvas_end_edit (self->canvas, &draft, _ ("Paste"), NULL,
                             add_blocks (draft.model, blocks, by, &draft.error))) {
    select_added (self, &before);
    qn_canvas_show_area (self->canvas, qn_vec2_add (box.min, by),
                         qn_vec2_add (box.max, by));
  }
  qn_model_clear (&before);
}

static void
paste (QnWindow *self, const char *name)
{
  gdk_clipboard_read_text_async (gtk_widget_get_clipboard (GTK_WIDGET (self)), NULL,
                                 on_clipboard_text, g_object_ref (self));
}

const QnWindowAction qn_window_edit_actions[] = {
  { "delete", NULL, { delete_selected }, QN_NEEDS_THING },
  { "detach", NULL, { detach }, QN_NEEDS_BLOCKS },
  { "mirror", "s", { mirror }, QN_NEEDS_PARTS },
  { "rotate", "d", { .take = rotate }, QN_NEEDS_PARTS },
  { "duplicate", NULL, { duplicate }, QN_NEEDS_COPYABLE },
  { "join", NULL, { join }, QN_NEEDS_TWO_BLOCKS },
  { "join-bodies", NULL, { join_bodies }, QN_NEEDS_RUN },
  { "array", "(iddd)", { .take = array }, QN_NEEDS_PARTS },
  { "nudge", "(dd)", { .take = nudge }, QN_NEEDS_MOVABLE },
  { "support", "s", { hold }, QN_NEEDS_BLOCKS },
  { "joint-law", "s", { set_joint_law }, QN_NEEDS_FACE },
  { "copy-text", "s", { copy_text }, 0 },
  { "undo", NULL, { undo_or_redo }, QN_NEEDS_WORK | QN_NEEDS_UNDO },
  { "redo", NULL, { undo_or_redo }, QN_NEEDS_WORK | QN_NEEDS_REDO },
  { "go-to-step", "i", { .take = go_to_step }, QN_NEEDS_WORK },
  { "remove-run", NULL, { remove_run }, QN_NEEDS_RUN },
  { "select-all", NULL, { select_all }, QN_NEEDS_MODEL },
  { "select-like", "s", { select_like }, QN_NEEDS_BLOCKS },
  { "select-faces-like", "s", { select_faces_like }, QN_NEEDS_FACE },
  { "copy", NULL, { copy }, QN_NEEDS_BLOCKS },
  { "cut", NULL, { cut }, QN_NEEDS_BLOCKS },
  { "paste", NULL, { paste }, QN_NEEDS_WORK },
  { .name = NULL },
};
