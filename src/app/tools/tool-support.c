/* Support: a click fixes a block, or a node of beams, another one frees it. */
#include "app/canvas/canvas.h"
#include "app/tools/tools.h"

#include <glib/gi18n.h>

/* Everything fixed becomes free, everything else fixed. */
static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnId node = qn_canvas_pick_node (canvas, event->screen);
  const gboolean of_node = node != QN_NONE && model->nodes[node].block == QN_NONE;
  const QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
  QnCanvasDraft draft;
  if (!of_node && pick.kind != QN_PICK_BLOCK)
    return;
  const gboolean all = qn_support_is_full (of_node ? model->nodes[node].support
                                                   : model->blocks[pick.id].support);
  const bool fixed[QN_DOF_COUNT] = { !all, !all, !all };
  const char *name = of_node ? (all ? _ ("Free Node") : _ ("Fix Node"))
                     : all   ? _ ("Free Block")
                             : _ ("Fix Block");
  if (qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (
      canvas, &draft, name, NULL,
      of_node ? qn_edit_set_node_support (draft.model, node, fixed, &draft.error)
              : qn_edit_set_support (draft.model, (QnBlockSet){ &pick.id, 1 }, QN_DOF_UX,
                                     QN_DOF_COUNT, fixed, &draft.error));
}

const QnTool qn_tool_support = {
  .name = "support",
  .icon = "quoin-support-symbolic",
  .label = N_ ("Support"),
  .hint = N_ ("Click a block or an end of a beam to fix it; click again to free it"),
  .accel = "s",
  .press = press,
};
