/* Lines from point to point: beams, reinforcing bars across joints, ties, and mirrors. An end of a beam or
 * tie on a block, or of a beam on another, is held there; elsewhere it is free or on the ground. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-frame.h"
#include "doc/edit/edit-tie.h"
#include <glib/gi18n.h>

static gboolean
add_beam (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  const QnToolSettings *settings = canvas->settings;
  const QnBeamStyle style = { .section = settings->section,
                              .hinge = { settings->hinges[0], settings->hinges[1] },
                              .element_count = settings->elements };
  return qn_edit_add_beam (draft->model, gesture->from, gesture->to, style,
                           &draft->error);
}

static gboolean
add_bar (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  return qn_edit_draw_bar (draft->model, gesture->from, gesture->to, &draft->error);
}

static gboolean
add_tie (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  return qn_edit_draw_tie (draft->model, gesture->from, gesture->to, &draft->error);
}

/* The last of its kind is new: selected, it has its handles and numbers there. */
static void
select_added (QnCanvas *canvas)
{
  const QnPickKind kind = canvas->tool == &qn_tool_beam  ? QN_PICK_BEAM
                          : canvas->tool == &qn_tool_bar ? QN_PICK_BAR
                                                         : QN_PICK_TIE;
  const gsize count = qn_model_count_items (qn_canvas_get_model (canvas), kind);
  qn_selection_set_one (canvas->selection, kind, (QnId) count - 1);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
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
  const QnVec2 a = canvas->gesture.from, b = canvas->gesture.to;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (a.x != b.x || a.y != b.y)
    qn_canvas_transform (canvas, _ ("Mirror"), NULL, qn_transform_mirror (a, b),
                         canvas->settings->mirror_copy ? 1 : 0);
}

static void
draw_mirror (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
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
  .step = N_ ("Add Beam"),
  .edit = add_beam,
  .added = select_added,
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
  .step = N_ ("Add Bar"),
  .edit = add_bar,
  .added = select_added,
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
  .step = N_ ("Add Tie"),
  .edit = add_tie,
  .added = select_added,
  .draw = draw_tie,
};
