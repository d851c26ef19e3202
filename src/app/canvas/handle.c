#include "app/canvas/handle.h"

#include "app/canvas/gesture.h"
#include "doc/edit/edit-masonry.h"
#include "doc/edit/edit-shape.h"
#include "doc/edit/edit-tie.h"
#include "io/project/project-masonry.h"
#include <glib/gi18n.h>
#include <math.h>

#define HANDLE_PX      4.5  /* half a side of the square */
#define REACH_PX       8.0  /* how near the pointer must be */
#define LEAST_APART_PX 20.0 /* handles of one thing */
#define TURN_PX        28.0 /* of the turning handle above the selection */

/* Blocks with more corners show none of them: a curve, not a shape to edit by hand. */
#define MOST_CORNERS 40

/* Of more beams than these no single ends are dragged. */
#define MOST_BEAMS 40

/* ---- what there is to drag ---- */

static void
add_grip (GArray *grips, QnGrip grip)
{
  g_array_append_val (grips, grip);
}

static void
add_masonry_grips (QnCanvas *canvas, GArray *grips, QnId object, int opening)
{
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  if (object < 0 || (gsize) object >= list->count
      || (opening != QN_NO_OPENING
          && (gsize) opening >= list->items[object].wall.opening_count))
    return;
  QnHandle handles[QN_HANDLE_COUNT];
  guint count = qn_masonry_get_handles (&list->items[object], opening, handles);
  for (guint i = 0; i < count; i++) {
    QnGrip grip = { .kind = QN_GRIP_MASONRY,
                    .at = handles[i].at,
                    .object = object,
                    .opening = opening,
                    .handle = (int) handles[i].kind };
    add_grip (grips, grip);
  }
}

static void
add_turn_grip (QnCanvas *canvas, GArray *grips)
{
  QnVec2 low, high;
  if (!qn_canvas_get_parts_box (canvas, &low, &high))
    return;
  double above = TURN_PX / canvas->camera.scale;
  QnGrip grip = { .kind = QN_GRIP_TURN,
                  .at = qn_vec2 (0.5 * (low.x + high.x), high.y + above),
                  .center = qn_vec2_lerp (low, high, 0.5) };
  add_grip (grips, grip);
}

/* Ends of the selected beams, each once. */
static void
add_node_grips (QnCanvas *canvas, GArray *grips)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnBeamSet set = qn_selection_get_parts (canvas->selection).beams;
  g_autoptr (GHashTable) known = g_hash_table_new (NULL, NULL);
  for (guint i = 0; i < set.count && set.count <= MOST_BEAMS; i++) {
    for (int end = 0; end < 2; end++) {
      QnId node = model->beams[set.ids[i]].nodes[end];
      if (g_hash_table_add (known, GINT_TO_POINTER (node)))
        add_grip (
          grips,
          (QnGrip){ .kind = QN_GRIP_NODE, .at = model->nodes[node].at, .object = node });
    }
  }
}

static void
add_tie_grips (QnCanvas *canvas, GArray *grips)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  QnId tie = qn_selection_get_one (canvas->selection, QN_PICK_TIE);
  for (int end = 0; end < 2 && tie != QN_NONE && (gsize) tie < model->tie_count; end++)
    add_grip (grips, (QnGrip){ .kind = QN_GRIP_TIE,
                               .at = model->ties[tie].ends[end].at,
                               .object = tie,
                               .handle = end });
}

/* Handles of what is selected, none in views of results. */
static GArray *
collect_all (QnCanvas *canvas)
{
  GArray *grips = g_array_new (FALSE, FALSE, sizeof (QnGrip));
  if (qn_view_needs_result (canvas->state->options.view))
    return grips;
  const QnModel *model = qn_canvas_get_model (canvas);
  QnSelection *selection = canvas->selection;
  if (selection->object != QN_NONE) {
    add_masonry_grips (canvas, grips, selection->object, selection->opening);
    return grips;
  }
  guint count = 0;
  const QnId *ids = qn_selection_get (selection, QN_PICK_BLOCK, &count);
  add_turn_grip (canvas, grips);
  add_node_grips (canvas, grips);
  add_tie_grips (canvas, grips);
  if (count == 0)
    return grips;
  if (count == 1 && model->blocks[ids[0]].masonry == QN_NONE
      && model->blocks[ids[0]].wall == QN_NONE) {
    const QnVec2 *v = qn_model_block_vertices (model, ids[0]);
    const QnId corners = model->blocks[ids[0]].vertex_count;
    for (QnId k = 0; k < corners && corners <= MOST_CORNERS; k++)
      add_grip (grips, (QnGrip){ .kind = QN_GRIP_CORNER, .at = v[k] });
    return grips;
  }
  QnId first = model->blocks[ids[0]].masonry;
  gsize objects = 0;
  g_autofree gboolean *whole =
    qn_edit_whole_objects (model, (QnBlockSet){ ids, count }, &objects);
  gboolean alone = first != QN_NONE && whole[first];
  for (guint i = 0; i < count && alone; i++)
    alone = model->blocks[ids[i]].masonry == first;
  if (alone)
    add_masonry_grips (canvas, grips, first, QN_NO_OPENING);
  return grips;
}

/* Handles that come too near to each other would cover what they change; the one that turns stands
 * beside it. */
static GArray *
collect (QnCanvas *canvas)
{
  GArray *grips = collect_all (canvas);
  double nearest = INFINITY;
  for (guint i = 0; i < grips->len; i++)
    for (guint k = i + 1; k < grips->len && grips->len <= 2 * MOST_CORNERS; k++) {
      const QnGrip *a = &g_array_index (grips, QnGrip, i);
      const QnGrip *b = &g_array_index (grips, QnGrip, k);
      if (a->kind == QN_GRIP_TURN || b->kind == QN_GRIP_TURN || a->kind == QN_GRIP_NODE
          || b->kind == QN_GRIP_NODE)
        continue;
      QnVec2 way = qn_vec2_sub (qn_canvas_to_screen (canvas, a->at),
                                qn_canvas_to_screen (canvas, b->at));
      nearest = MIN (nearest, qn_vec2_length (way));
    }
  for (guint i = grips->len; i-- > 0 && nearest < LEAST_APART_PX;) {
    QnGripKind kind = g_array_index (grips, QnGrip, i).kind;
    if (kind == QN_GRIP_CORNER || kind == QN_GRIP_MASONRY)
      g_array_remove_index (grips, i);
  }
  return grips;
}

gboolean
qn_handle_find (QnCanvas *canvas, QnVec2 screen, QnGrip *grip)
{
  g_autoptr (GArray) grips = collect (canvas);
  double nearest = REACH_PX;
  gboolean found = FALSE;
  for (guint i = 0; i < grips->len; i++) {
    const QnGrip *candidate = &g_array_index (grips, QnGrip, i);
    QnVec2 s = qn_canvas_to_screen (canvas, candidate->at);
    double distance = qn_vec2_length (qn_vec2_sub (s, screen));
    if (distance <= nearest) {
      nearest = distance;
      *grip = *candidate;
      found = TRUE;
    }
  }
  return found;
}

void
qn_handle_begin (QnCanvas *canvas, QnGrip grip)
{
  canvas->gesture.from = canvas->gesture.to = grip.at;
  canvas->gesture.grip = grip;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

/* ---- drawing ---- */

static void
draw_opening_outline (QnCanvas *canvas, cairo_t *cr)
{
  const QnId object = canvas->selection->object;
  const int opening = canvas->selection->opening;
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  if (qn_view_needs_result (canvas->state->options.view))
    return;
  if (object == QN_NONE || (gsize) object >= list->count
      || (gsize) opening >= list->items[object].wall.opening_count)
    return;
  QnVec2 corners[4];
  qn_masonry_opening_corners (&list->items[object], opening, corners);
  qn_canvas_trace (canvas, cr, corners, G_N_ELEMENTS (corners));
  qn_gesture_paint (cr);
}

void
qn_handle_draw_all (QnCanvas *canvas, cairo_t *cr)
{
  g_autoptr (GArray) grips = collect (canvas);
  draw_opening_outline (canvas, cr);
  for (guint i = 0; i < grips->len; i++) {
    const QnGrip *grip = &g_array_index (grips, QnGrip, i);
    QnVec2 s = qn_canvas_to_screen (canvas, grip->at);
    if (grip->kind == QN_GRIP_TURN) {
      cairo_move_to (cr, s.x, s.y + HANDLE_PX);
      cairo_line_to (cr, s.x, s.y + TURN_PX);
      cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
      cairo_set_line_width (cr, 1.0);
      cairo_stroke (cr);
    }
    if (grip->kind == QN_GRIP_TURN || grip->kind == QN_GRIP_NODE
        || grip->kind == QN_GRIP_TIE
        || (grip->handle == QN_HANDLE_MIDDLE && grip->kind == QN_GRIP_MASONRY))
      cairo_arc (cr, s.x, s.y, HANDLE_PX, 0.0, 2.0 * G_PI);
    else
      cairo_rectangle (cr, s.x - HANDLE_PX, s.y - HANDLE_PX, 2.0 * HANDLE_PX,
                       2.0 * HANDLE_PX);
    cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
    cairo_fill_preserve (cr);
    cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
    cairo_set_line_width (cr, 1.5);
    cairo_stroke (cr);
  }
}

/* ---- dragging ---- */

static double
turn_angle (QnCanvas *canvas)
{
  const QnGesture *gesture = &canvas->gesture;
  QnVec2 a = qn_vec2_sub (gesture->grip.at, gesture->grip.center);
  QnVec2 b = qn_vec2_sub (gesture->to, gesture->grip.center);
  double angle = atan2 (qn_vec2_cross (a, b), qn_vec2_dot (a, b));
  /* Whole degrees, and the quarters with some pull. */
  double quarter = round (angle / G_PI_2) * G_PI_2, degree = G_PI / 180.0;
  if (!qn_canvas_snaps (canvas))
    return angle;
  return fabs (angle - quarter) < 3.0 * degree ? quarter
                                               : round (angle / degree) * degree;
}

/* Bonds have a grid of their own; what has none follows the magnet. */
static gboolean
drag_masonry (QnMasonry *masonry, gpointer canvas, GError **error)
{
  const QnGesture *gesture = &((QnCanvas *) canvas)->gesture;
  qn_masonry_drag (masonry, gesture->grip.opening, (QnHandleKind) gesture->grip.handle,
                   gesture->from, gesture->to, qn_canvas_snaps (canvas));
  return TRUE;
}

static const char *
step_name (QnCanvas *canvas, const QnGrip *grip)
{
  if (grip->opening != QN_NO_OPENING)
    return grip->handle == QN_HANDLE_MIDDLE ? _ ("Move Opening") : _ ("Resize Opening");
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  switch (list->items[grip->object].kind) {
  case QN_MASONRY_WALL:
    return _ ("Resize Wall");
  case QN_MASONRY_ARCH:
    return _ ("Change Arch");
  case QN_MASONRY_COLUMN:
    return _ ("Resize Column");
  case QN_MASONRY_BUTTRESS:
  case QN_MASONRY_PORTAL:
  case QN_MASONRY_RUBBLE:
  case QN_MASONRY_KIND_COUNT:
    break;
  }
  return _ ("Change Masonry");
}

static void
end_drag (QnCanvas *canvas)
{
  qn_canvas_set_magnet_skip (canvas, NULL);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

void
qn_handle_turn (QnCanvas *canvas, double angle)
{
  const QnVec2 center = canvas->gesture.grip.center;
  end_drag (canvas);
  qn_canvas_transform (canvas, _ ("Rotate"), NULL, qn_transform_rotation (center, angle),
                       0);
}

void
qn_handle_finish (QnCanvas *canvas)
{
  const QnGesture *gesture = &canvas->gesture;
  const QnGrip *grip = &gesture->grip;
  QnCanvasDraft draft;
  if (grip->kind == QN_GRIP_TURN) {
    qn_handle_turn (canvas, turn_angle (canvas));
    return;
  }
  const char *name = grip->kind == QN_GRIP_MASONRY  ? step_name (canvas, grip)
                     : grip->kind == QN_GRIP_CORNER ? _ ("Move Corner")
                     : grip->kind == QN_GRIP_NODE   ? _ ("Move Beam End")
                                                    : _ ("Move Tie End");
  const gboolean begun = qn_canvas_begin_edit (canvas, &draft);
  const gboolean done =
    !begun                          ? FALSE
    : grip->kind == QN_GRIP_MASONRY ? qn_edit_change_masonry (
        &draft.project, grip->object, drag_masonry, canvas, &draft.error)
    : grip->kind == QN_GRIP_CORNER
      ? qn_edit_move_corner (draft.model,
                             qn_selection_get_parts (canvas->selection).blocks,
                             gesture->from, gesture->to, &draft.error)
    : grip->kind == QN_GRIP_NODE
      ? qn_edit_place_node (draft.model, grip->object, gesture->to, &draft.error)
      : qn_edit_place_tie_end (draft.model, grip->object, grip->handle, gesture->to,
                               &draft.error);
  end_drag (canvas);
  if (begun)
    qn_canvas_end_edit (canvas, &draft, name, NULL, done);
}

static void
draw_masonry_drag (QnCanvas *canvas, cairo_t *cr)
{
  const QnGrip *grip = &canvas->gesture.grip;
  const QnProject *project = qn_document_get_project (canvas->document);
  QnMasonries list;
  if (!qn_project_get_masonry (project, &list, NULL))
    return;
  if ((gsize) grip->object < list.count) {
    QnMasonry *masonry = &list.items[grip->object];
    drag_masonry (masonry, canvas, NULL);
    qn_gesture_draw_masonry (canvas, cr, masonry);
    if (grip->opening != QN_NO_OPENING) {
      QnVec2 c[4];
      qn_masonry_opening_corners (masonry, grip->opening, c);
      qn_canvas_draw_dimension (canvas, cr, c[0], c[1]);
      qn_canvas_draw_dimension (canvas, cr, c[1], c[2]);
    }
  }
  qn_masonries_clear (&list);
}

static void
draw_corner_drag (QnCanvas *canvas, cairo_t *cr, const QnGesture *gesture)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnBlockSet set = qn_selection_get_parts (canvas->selection).blocks;
  if (set.count == 0)
    return;
  gsize n = (gsize) model->blocks[set.ids[0]].vertex_count;
  g_autofree QnVec2 *v =
    g_memdup2 (qn_model_block_vertices (model, set.ids[0]), n * sizeof (QnVec2));
  for (gsize i = 0; i < n; i++) {
    if (v[i].x == gesture->from.x && v[i].y == gesture->from.y)
      v[i] = gesture->to;
  }
  qn_canvas_trace (canvas, cr, v, n);
  qn_gesture_paint (cr);
  qn_canvas_draw_dimension (canvas, cr, gesture->from, gesture->to);
}

/* All beams that end there, with their lengths. */
static void
draw_node_drag (QnCanvas *canvas, cairo_t *cr, const QnGesture *gesture)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  for (gsize i = 0; i < model->beam_count; i++) {
    const QnId *ends = model->beams[i].nodes;
    for (int end = 0; end < 2; end++)
      if (ends[end] == gesture->grip.object)
        qn_gesture_draw_line (canvas, cr, model->nodes[ends[1 - end]].at, gesture->to);
  }
}

void
qn_handle_draw_drag (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
  switch (gesture->grip.kind) {
  case QN_GRIP_MASONRY:
    draw_masonry_drag (canvas, cr);
    break;
  case QN_GRIP_CORNER:
    draw_corner_drag (canvas, cr, gesture);
    break;
  case QN_GRIP_NODE:
    draw_node_drag (canvas, cr, gesture);
    break;
  case QN_GRIP_TIE: {
    const QnTieEnd *ends = qn_canvas_get_model (canvas)->ties[gesture->grip.object].ends;
    qn_gesture_draw_line (canvas, cr, ends[1 - gesture->grip.handle].at, gesture->to);
    break;
  }
  case QN_GRIP_TURN: {
    double angle = turn_angle (canvas);
    qn_gesture_draw_moved (canvas, cr,
                           qn_transform_rotation (gesture->grip.center, angle));
    g_autofree char *text = g_strdup_printf ("%.1f°", angle * 180.0 / G_PI);
    QnVec2 s = qn_canvas_to_screen (canvas, gesture->to);
    qn_canvas_draw_label (canvas, cr, text, qn_vec2 (s.x + 14.0, s.y - 8.0));
    break;
  }
  case QN_GRIP_NONE:
    break;
  }
}
