/* Support: a click fixes a block, another one frees it. */
#include "app/canvas.h"

#include "doc/edit.h"
#include <glib/gi18n.h>

typedef struct Support {
  QnId block;
  bool fixed[QN_DOF_COUNT];
} Support;

static gboolean
edit_support (QnModel *model, gpointer data, GError **error)
{
  const Support *support = data;
  return qn_edit_set_support (model, (QnBlockSet){ &support->block, 1 }, support->fixed,
                              error);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
  if (pick.kind != QN_PICK_BLOCK)
    return;
  const QnModel *model = qn_document_get_model (qn_canvas_get_document (canvas));
  const QnBlock *block = &model->blocks[pick.id];
  bool all =
    block->support[QN_DOF_UX] && block->support[QN_DOF_UY] && block->support[QN_DOF_RZ];
  Support support = { pick.id, { !all, !all, !all } };
  qn_canvas_edit (canvas, all ? _ ("Free Block") : _ ("Fix Block"), NULL, edit_support,
                  &support);
}

const QnTool qn_tool_support = {
  .name = "support",
  .icon = "quoin-support-symbolic",
  .label = N_ ("Support"),
  .hint = N_ ("Click a block to fix it; click again to free it"),
  .accel = "s",
  .press = press,
};
