/* Select and move: click, Shift+click, rectangle; drag a block to move what is selected, and a
 * handle to change it. */
#include "app/canvas/gesture.h"
#include "app/canvas/handle.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

/* px: a corner this near to the press is what a move carries. */
#define GRAB_PX 14.0

static gboolean
shows_undeformed (QnCanvas *canvas)
{
  return !qn_view_needs_result (canvas->state->options.view);
}

/* The corner of a block that was grabbed, or the place itself. */
static QnVec2
grabbed_point (QnCanvas *canvas, QnId block, const QnToolEvent *event)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnVec2 *v = qn_model_block_vertices (model, block);
  QnVec2 best = event->model;
  double nearest = GRAB_PX;
  for (QnId i = 0; i < model->blocks[block].vertex_count; i++) {
    double distance =
      qn_vec2_length (qn_vec2_sub (qn_canvas_to_screen (canvas, v[i]), event->screen));
    if (distance < nearest) {
      nearest = distance;
      best = v[i];
    }
  }
  return best;
}

/* Selects a part that is pressed, or with Shift or Control more or less than before; a drag moves it. */
static void
press_on_part (QnCanvas *canvas, QnPick part, const QnToolEvent *event)
{
  QnSelection *selection = canvas->selection;
  if (event->modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK)) {
    qn_selection_toggle (selection, part.kind, part.id);
    return;
  }
  if (part.kind == QN_PICK_BLOCK && event->press_count > 1) {
    qn_selection_select_blocks_like (selection, qn_canvas_get_model (canvas), part.id,
                                     event->press_count == 2 ? QN_LIKE_COURSE
                                                             : QN_LIKE_WALL);
    return;
  }
  if (!qn_selection_has (selection, part.kind, part.id))
    qn_selection_set_one (selection, part.kind, part.id);
  if (!shows_undeformed (canvas))
    return;
  canvas->gesture.from = canvas->gesture.to =
    part.kind == QN_PICK_BLOCK ? grabbed_point (canvas, part.id, event) : event->model;
  QnBlockSet set = qn_selection_get_parts (selection).blocks;
  qn_canvas_set_magnet_skip (canvas,
                             qn_block_set_to_flags (set, qn_canvas_get_model (canvas)));
  qn_canvas_set_in_gesture (canvas, TRUE);
}

/* ---- faces ---- */

/* Whether what the view shows is of the document's model, so that numbers are the same. */
static gboolean
shows_document (QnCanvas *canvas)
{
  const QnRun *run = canvas->document->run;
  return shows_undeformed (canvas)
         || (run != NULL && !qn_document_is_stale (canvas->document, run));
}

static QnId
face_under (QnCanvas *canvas, const QnToolEvent *event)
{
  return shows_document (canvas) ? qn_canvas_pick_joint (canvas, event->screen) : QN_NONE;
}

static void
select_face (QnCanvas *canvas, QnId face, const QnToolEvent *event)
{
  const QnContacts *contacts = &canvas->document->contacts;
  if (event->modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK))
    qn_selection_toggle (canvas->selection, QN_PICK_FACE, face);
  else if (event->press_count > 1)
    qn_selection_select_faces_like (canvas->selection, contacts, face,
                                    event->press_count == 2 ? QN_LIKE_LINE
                                                            : QN_LIKE_DIRECTION);
  else
    qn_selection_set_one (canvas->selection, QN_PICK_FACE, face);
}

/* ---- loads, bars, ties ---- */

/* The load, bar or tie under the pointer; bars and ties also where a result has moved them. Loads in weights
 * are chosen in the list: their arrows lie in the middle of blocks, where these are taken hold of. */
static gboolean
select_item (QnCanvas *canvas, QnVec2 screen)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  QnPick pick =
    qn_canvas_pick (canvas, screen, 1u << QN_PICK_DEAD_LOAD | 1u << QN_PICK_LIVE_LOAD);
  const gboolean live = pick.kind == QN_PICK_LIVE_LOAD;
  if (!shows_undeformed (canvas) || pick.id == QN_NONE
      || qn_model_loads (model, live, NULL)[pick.id].kind == QN_LOAD_WEIGHT)
    pick = qn_canvas_pick (canvas, screen, 1u << QN_PICK_BAR | 1u << QN_PICK_TIE);
  if (pick.id == QN_NONE || !shows_document (canvas))
    return FALSE;
  qn_selection_set_one (canvas->selection, pick.kind, pick.id);
  return TRUE;
}

/* Where the button is let go without a drag: a load, a bar, or in the view of the model a joint. */
static void
click (QnCanvas *canvas, const QnToolEvent *event)
{
  QnId face = face_under (canvas, event);
  gboolean plain = (event->modifiers & (GDK_SHIFT_MASK | GDK_CONTROL_MASK)) == 0;
  if (!plain || event->press_count != 1 || select_item (canvas, event->screen))
    return;
  if (face != QN_NONE && canvas->state->options.view == QN_VIEW_MODEL)
    qn_selection_set_one (canvas->selection, QN_PICK_FACE, face);
}

/* The block or beam under the pointer, by its number in the document, which has it under the same name; QN_NONE:
 * not any more. */
static QnPick
part_under (QnCanvas *canvas, QnVec2 screen)
{
  const QnModel *shown, *model = qn_canvas_get_model (canvas);
  const QnContacts *contacts;
  const QnResult *result;
  QnPick pick = qn_canvas_pick (canvas, screen, 1u << QN_PICK_BLOCK | 1u << QN_PICK_BEAM);
  if (pick.kind != QN_PICK_NOTHING && !shows_document (canvas)
      && qn_view_state_get_content (canvas->state, canvas->state->options.view, &shown,
                                    &contacts, &result))
    pick.id = pick.kind == QN_PICK_BEAM
                ? qn_model_find_beam (model, shown->beams[pick.id].name)
                : qn_model_find_block (model, shown->blocks[pick.id].name);
  return pick;
}

/* ---- openings and handles ---- */

/* Selects the opening at a place of the model; FALSE where there is none. */
static gboolean
select_opening (QnCanvas *canvas, QnVec2 at)
{
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  for (gsize i = list->count; i > 0 && shows_undeformed (canvas); i--) {
    int opening = qn_masonry_opening_at (&list->items[i - 1], at);
    if (opening == QN_NO_OPENING)
      continue;
    qn_selection_set_opening (canvas->selection, (QnId) (i - 1), opening);
    return TRUE;
  }
  return FALSE;
}

/* A click into an opening selects it, and a drag from there moves it. */
static gboolean
press_on_opening (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGrip grip = { .kind = QN_GRIP_MASONRY,
                  .at = event->model,
                  .handle = QN_HANDLE_MIDDLE };
  if (!select_opening (canvas, event->model))
    return FALSE;
  grip.object = canvas->selection->object;
  grip.opening = canvas->selection->opening;
  qn_handle_begin (canvas, grip);
  return TRUE;
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  gesture->from_screen = event->screen;
  QnGrip grip;
  if (event->press_count == 1 && qn_handle_find (canvas, event->screen, &grip)) {
    qn_handle_begin (canvas, grip);
    return;
  }
  /* In the view of the model a drag moves what lies under the pointer: there a joint is selected by a
   * click, when the button is let go. */
  QnId face = face_under (canvas, event);
  if (face != QN_NONE && canvas->state->options.view != QN_VIEW_MODEL) {
    select_face (canvas, face, event);
    return;
  }
  const QnPick part = part_under (canvas, event->screen);
  if (part.id != QN_NONE)
    press_on_part (canvas, part, event);
  if (part.kind != QN_PICK_NOTHING)
    return;
  if (press_on_opening (canvas, event))
    return;
  if ((event->modifiers & GDK_SHIFT_MASK) == 0)
    qn_selection_clear (canvas->selection);
  gesture->from = gesture->to = event->model;
  qn_canvas_set_in_gesture (canvas, TRUE);
  gesture->band = TRUE;
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (!canvas->in_gesture)
    return;
  if (!gesture->dragging && !qn_canvas_is_drag (canvas, event))
    return;
  gesture->dragging = TRUE;
  /* Bonds and angles have steps of their own. */
  gboolean by_magnet = !gesture->band && gesture->grip.kind != QN_GRIP_TURN;
  gesture->to = by_magnet ? event->point : event->model;
  if (!gesture->band && (event->modifiers & GDK_SHIFT_MASK)) {
    /* Shift keeps a move horizontal or vertical. */
    QnVec2 d = qn_vec2_sub (gesture->to, gesture->from);
    if (fabs (d.x) > fabs (d.y))
      gesture->to.y = gesture->from.y;
    else
      gesture->to.x = gesture->from.x;
  }
}

void
qn_tool_select_under (QnCanvas *canvas, QnVec2 screen)
{
  QnSelection *selection = canvas->selection;
  QnVec2 at = qn_camera_to_model (&canvas->camera, screen);
  QnToolEvent event = { .screen = screen, .model = at, .point = at, .press_count = 1 };
  if (select_item (canvas, screen))
    return;
  QnId face = face_under (canvas, &event);
  if (face != QN_NONE) {
    if (!qn_selection_has (selection, QN_PICK_FACE, face))
      qn_selection_set_one (selection, QN_PICK_FACE, face);
    return;
  }
  const QnPick part = part_under (canvas, screen);
  if (part.id != QN_NONE) {
    if (!qn_selection_has (selection, part.kind, part.id))
      qn_selection_set_one (selection, part.kind, part.id);
    return;
  }
  qn_selection_clear (selection);
  select_opening (canvas, at);
}

static void
finish_move (QnCanvas *canvas, QnVec2 by)
{
  qn_canvas_set_magnet_skip (canvas, NULL);
  qn_canvas_set_in_gesture (canvas, FALSE);
  qn_canvas_transform (canvas, _ ("Move"), NULL, qn_transform_translation (by.x, by.y),
                       0);
}

static void
finish_band (QnCanvas *canvas)
{
  QnGesture *gesture = &canvas->gesture;
  g_autoptr (GArray) ids = g_array_new (FALSE, FALSE, sizeof (QnId));
  if (canvas->state->options.view == QN_VIEW_CONTACTS) {
    qn_canvas_faces_inside (canvas, gesture->from, gesture->to, ids);
    qn_selection_add (canvas->selection, QN_PICK_FACE, (const QnId *) ids->data,
                      ids->len);
    return;
  }
  qn_canvas_pick_inside (canvas, qn_canvas_to_screen (canvas, gesture->from),
                         qn_canvas_to_screen (canvas, gesture->to), ids);
  qn_selection_add (canvas->selection, QN_PICK_BLOCK, (const QnId *) ids->data, ids->len);
  g_array_set_size (ids, 0);
  qn_canvas_beams_inside (canvas, gesture->from, gesture->to, ids);
  qn_selection_add (canvas->selection, QN_PICK_BEAM, (const QnId *) ids->data, ids->len);
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (!canvas->in_gesture)
    return;
  if (!gesture->dragging && gesture->grip.kind == QN_GRIP_NONE)
    click (canvas, event);
  if (gesture->band && gesture->dragging)
    finish_band (canvas);
  else if (gesture->grip.kind != QN_GRIP_NONE && gesture->dragging) {
    qn_handle_finish (canvas);
    return;
  } else if (gesture->dragging) {
    finish_move (canvas, qn_vec2_sub (gesture->to, gesture->from));
    return;
  }
  qn_canvas_set_magnet_skip (canvas, NULL);
  qn_canvas_set_in_gesture (canvas, FALSE);
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  QnGesture *gesture = &canvas->gesture;
  if (count < 1 || count > 2 || gesture->band)
    return FALSE;
  if (gesture->grip.kind == QN_GRIP_TURN) {
    qn_handle_turn (canvas, values[0]);
    return count == 1;
  }
  if (gesture->grip.kind != QN_GRIP_NONE) {
    gesture->to =
      qn_vec2_add (gesture->from, qn_vec2 (values[0], count > 1 ? values[1] : 0.0));
    qn_handle_finish (canvas);
    return TRUE;
  }
  finish_move (canvas, qn_vec2 (values[0], count > 1 ? values[1] : 0.0));
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  QnGesture *gesture = &canvas->gesture;
  if (!gesture->dragging) {
    qn_handle_draw_all (canvas, cr);
    return;
  }
  if (gesture->grip.kind != QN_GRIP_NONE) {
    qn_handle_draw_drag (canvas, cr);
    return;
  }
  if (!gesture->band) {
    QnVec2 by = qn_vec2_sub (gesture->to, gesture->from);
    qn_gesture_draw_moved (canvas, cr, qn_transform_translation (by.x, by.y));
    qn_canvas_draw_dimension (canvas, cr, gesture->from, gesture->to);
    return;
  }
  qn_gesture_draw_frame (canvas, cr, gesture->from, gesture->to);
}

const QnTool qn_tool_select = {
  .name = "select",
  .icon = "quoin-select-symbolic",
  .label = N_ ("Select and Move"),
  .hint = N_ (
    "Click selects, double click a course, triple click a wall; drag to move, handles "
    "change; type “right; up” and Enter to move exactly"),
  .accel = "v",
  .numbers_label = N_ ("right; up"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .numbers_at_rest = TRUE,
  .press = press,
  .motion = motion,
  .release = release,
  .numbers = numbers,
  .draw_ready = qn_handle_draw_all,
  .draw = draw,
};
