/* Support: a click fixes a block, or a node of beams, another one frees it. */
#include "app/canvas/canvas.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

/* Everything fixed becomes free, everything else fixed. */
static gboolean
toggle (bool fixed[QN_DOF_COUNT], const bool held[QN_DOF_COUNT])
{
  bool all = qn_support_is_full (held);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    fixed[dof] = !all;
  return all;
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  QnId node = qn_canvas_pick_node (canvas, event->screen);
  bool fixed[QN_DOF_COUNT];
  QnCanvasDraft draft;
  if (node != QN_NONE && model->nodes[node].block == QN_NONE) {
    gboolean all = toggle (fixed, model->nodes[node].support);
    if (qn_canvas_begin_edit (canvas, &draft))
      qn_canvas_end_edit (
        canvas, &draft, all ? _ ("Free Node") : _ ("Fix Node"), NULL,
        qn_edit_set_node_support (draft.model, node, fixed, &draft.error));
    return;
  }
  QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
  if (pick.kind != QN_PICK_BLOCK)
    return;
  gboolean all = toggle (fixed, model->blocks[pick.id].support);
  if (qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (canvas, &draft, all ? _ ("Free Block") : _ ("Fix Block"), NULL,
                        qn_edit_set_support (draft.model, (QnBlockSet){ &pick.id, 1 },
                                             QN_DOF_UX, QN_DOF_COUNT, fixed,
                                             &draft.error));
}

const QnTool qn_tool_support = {
  .name = "support",
  .icon = "quoin-support-symbolic",
  .label = N_ ("Support"),
  .hint = N_ ("Click a block or an end of a beam to fix it; click again to free it"),
  .accel = "s",
  .press = press,
};
