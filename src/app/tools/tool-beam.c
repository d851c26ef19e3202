/* Beam: from point to point; an end on a block, or on another beam's, holds on to it. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  const QnToolSettings *settings = qn_canvas_get_tool_settings (canvas);
  g_autofree char *section = g_strdup (settings->section);
  const QnVec2 from = gesture->from, to = gesture->to;
  const QnBeamStyle style = { .section = section,
                              .hinge = { settings->hinges[0], settings->hinges[1] },
                              .element_count = settings->elements };
  QnDraft draft;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if ((from.x != to.x || from.y != to.y) && qn_canvas_begin_edit (canvas, &draft)
      && qn_canvas_end_edit (
        canvas, &draft, _ ("Add Beam"), NULL,
        qn_edit_add_beam (draft.model, from, to, style, &draft.error))) {
    /* The new beam is selected, so that its handles and its form are there. */
    const QnModel *model = qn_canvas_get_model (canvas);
    QnId last = (QnId) model->beam_count - 1;
    qn_selection_set (qn_canvas_get_selection (canvas), QN_PART_BEAM, &last, 1);
  }
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_held (canvas, cr, qn_beam_end_dup_text);
}

const QnTool qn_tool_beam = {
  .name = "beam",
  .icon = "quoin-beam-symbolic",
  .label = N_ ("Beam"),
  .hint = N_ ("Drag from end to end; an end on a block or on another beam is held there; "
              "Shift holds it straight"),
  .accel = "b",
  QN_GESTURE_LINE,
  .complete = complete,
  .draw = draw,
};
