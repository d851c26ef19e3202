/* Lines from point to point: beams, reinforcing bars across joints, ties, and mirrors. An end of a beam or
 * tie on a block, or of a beam on another, is held there; elsewhere it is free or on the ground. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-frame.h"
#include "doc/edit/edit-tie.h"
#include <glib/gi18n.h>

/* Adds to the draft the line between two points. */
typedef gboolean (*AddFunc) (QnCanvas *canvas, QnDraft *draft, QnVec2 from, QnVec2 to);

static gboolean
add_beam (QnCanvas *canvas, QnDraft *draft, QnVec2 from, QnVec2 to)
{
  const QnToolSettings *settings = qn_canvas_get_tool_settings (canvas);
  g_autofree char *section = g_strdup (settings->section);
  const QnBeamStyle style = { .section = section,
                              .hinge = { settings->hinges[0], settings->hinges[1] },
                              .element_count = settings->elements };
  return qn_edit_add_beam (draft->model, from, to, style, &draft->error);
}

static gboolean
add_bar (QnCanvas *canvas, QnDraft *draft, QnVec2 from, QnVec2 to)
{
  return qn_edit_draw_bar (draft->model, from, to, &draft->error);
}

static gboolean
add_tie (QnCanvas *canvas, QnDraft *draft, QnVec2 from, QnVec2 to)
{
  return qn_edit_draw_tie (draft->model, from, to, &draft->error);
}

/* One undo step with the drawn line, which is the last of its kind; FALSE where there is none. */
static gboolean
add (QnCanvas *canvas, const char *name, AddFunc func)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnVec2 from = gesture->from, to = gesture->to;
  QnDraft draft;
  qn_canvas_set_in_gesture (canvas, FALSE);
  return !(from.x == to.x && from.y == to.y) && qn_canvas_begin_edit (canvas, &draft)
         && qn_canvas_end_edit (canvas, &draft, name, NULL,
                                func (canvas, &draft, from, to));
}

/* What is new is selected, so that its handles and numbers are there. */

static void
complete_beam (QnCanvas *canvas)
{
  if (!add (canvas, _ ("Add Beam"), add_beam))
    return;
  const QnId last = (QnId) qn_canvas_get_model (canvas)->beam_count - 1;
  qn_selection_set (qn_canvas_get_selection (canvas), QN_PART_BEAM, &last, 1);
}

static void
complete_item (QnCanvas *canvas, QnItemKind kind, const char *name, AddFunc func)
{
  if (add (canvas, name, func))
    qn_selection_set_item (
      qn_canvas_get_selection (canvas), kind,
      (QnId) qn_model_count_items (qn_canvas_get_model (canvas), kind) - 1);
}

static void
complete_bar (QnCanvas *canvas)
{
  complete_item (canvas, QN_ITEM_BAR, _ ("Add Bar"), add_bar);
}

static void
complete_tie (QnCanvas *canvas)
{
  complete_item (canvas, QN_ITEM_TIE, _ ("Add Tie"), add_tie);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  g_autofree char *angle = qn_gesture_dup_angle (gesture);
  qn_gesture_draw_line (canvas, cr, gesture->from, gesture->to);
  qn_gesture_draw_words (canvas, cr, angle, gesture->to);
}

static void
draw_tie (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_held (canvas, cr, qn_tie_end_dup_text);
}

static void
draw_beam (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_held (canvas, cr, qn_beam_end_dup_text);
}

static void
complete_mirror (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnVec2 a = gesture->from, b = gesture->to;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (a.x != b.x || a.y != b.y)
    qn_canvas_transform (canvas, _ ("Mirror"), NULL, qn_transform_mirror (a, b),
                         qn_canvas_get_tool_settings (canvas)->mirror_copy ? 1 : 0);
}

static void
draw_mirror (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_draw_moved (canvas, cr, qn_transform_mirror (gesture->from, gesture->to));
  draw (canvas, cr);
}

/* Control, or the switch in the panel, keeps the original. */
const QnTool qn_tool_mirror = {
  .name = "mirror",
  .icon = "quoin-mirror-symbolic",
  .label = N_ ("Mirror"),
  .hint = N_ ("Drag the line about which to mirror what is selected; Shift holds it "
              "straight"),
  .accel = "y",
  QN_GESTURE_LINE,
  .complete = complete_mirror,
  .draw = draw_mirror,
};

const QnTool qn_tool_beam = {
  .name = "beam",
  .begins = TRUE,
  .icon = "quoin-beam-symbolic",
  .label = N_ ("Beam"),
  .hint = N_ ("Drag from end to end; an end on a block or on another beam is held there; "
              "Shift holds it straight"),
  .accel = "b",
  QN_GESTURE_LINE,
  .complete = complete_beam,
  .draw = draw_beam,
};

const QnTool qn_tool_bar = {
  .name = "bar",
  .icon = "quoin-bar-symbolic",
  .label = N_ ("Reinforcing Bar"),
  .hint = N_ ("Drag from end to end, across joints at any angle; Shift holds it "
              "straight; law and diameter are in the panel Analysis"),
  .accel = "e",
  QN_GESTURE_LINE,
  .complete = complete_bar,
  .draw = draw,
};

const QnTool qn_tool_tie = {
  .name = "tie",
  .icon = "quoin-tie-symbolic",
  .label = N_ ("Tie"),
  .hint =
    N_ ("Click both ends; an end on a block is fixed to it, elsewhere to the ground; "
        "Shift holds it straight; steel and anchors are in the panel Analysis"),
  .accel = "k",
  QN_GESTURE_LINE,
  .complete = complete_tie,
  .draw = draw_tie,
};
