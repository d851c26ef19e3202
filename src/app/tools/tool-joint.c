/* Laws of joints: a click, or a frame, gives contact faces the law that the panel shows. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit.h"
#include <glib/gi18n.h>

void
qn_tool_joint_set_law (QnCanvas *canvas, const QnId *ids, guint count, const char *law)
{
  const QnContacts *contacts = &canvas->document->contacts;
  const QnFaceSet set = { contacts, ids, count };
  QnCanvasDraft draft;
  if (count > 0 && qn_canvas_begin_edit (canvas, &draft)) {
    QnId id =
      law != NULL && *law != '\0' ? qn_model_find_law (draft.model, law) : QN_NONE;
    qn_canvas_end_edit (canvas, &draft, _ ("Set Law of Joints"), NULL,
                        qn_edit_set_faces (draft.model, set, &id, NULL, &draft.error));
  }
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  qn_view_state_set_view (canvas->state, QN_VIEW_CONTACTS);
  canvas->gesture.from = canvas->gesture.to = event->model;
  canvas->gesture.from_screen = event->screen;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  canvas->gesture.to = event->model;
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (!canvas->in_gesture)
    return;
  g_autoptr (GArray) ids = g_array_new (FALSE, FALSE, sizeof (QnId));
  if (qn_canvas_is_drag (canvas, event))
    qn_canvas_faces_inside (canvas, canvas->gesture.from, event->model, ids);
  else {
    QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_FACE);
    if (pick.kind == QN_PICK_FACE)
      g_array_append_val (ids, pick.id);
  }
  qn_canvas_set_in_gesture (canvas, FALSE);
  qn_tool_joint_set_law (canvas, (const QnId *) ids->data, ids->len,
                         canvas->settings->joint_law);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  qn_gesture_draw_frame (canvas, cr, canvas->gesture.from, canvas->gesture.to);
}

const QnTool qn_tool_joint = {
  .name = "joint",
  .icon = "quoin-joint-symbolic",
  .label = N_ ("Law of Joints"),
  .hint = N_ ("Click a joint, or drag a frame around several, to give them the law that "
              "the panel shows"),
  .accel = "l",
  .press = press,
  .motion = motion,
  .release = release,
  .draw = draw,
};
