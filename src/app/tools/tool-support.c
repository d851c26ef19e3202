/* Support: a click fixes a block, or a node of beams, another one frees it. */
#include "app/canvas/canvas.h"
#include "app/tools/tools.h"
#include "core/model/support.h"

#include <glib/gi18n.h>

typedef struct Support {
  QnId id;
  bool fixed[QN_DOF_COUNT];
} Support;

static gboolean
edit_block (QnModel *model, gpointer data, GError **error)
{
  const Support *support = data;
  return qn_edit_set_support (model, (QnBlockSet){ &support->id, 1 }, support->fixed,
                              error);
}

static gboolean
edit_node (QnModel *model, gpointer data, GError **error)
{
  const Support *support = data;
  return qn_edit_set_node_support (model, support->id, support->fixed, error);
}

/* Everything fixed becomes free, everything else fixed. */
static gboolean
toggle (Support *support, const bool held[QN_DOF_COUNT])
{
  bool all = qn_support_is_full (held);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    support->fixed[dof] = !all;
  return all;
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  Support support = { .id = qn_canvas_pick_node (canvas, event->screen) };
  if (support.id != QN_NONE && model->nodes[support.id].block == QN_NONE) {
    gboolean all = toggle (&support, model->nodes[support.id].support);
    qn_canvas_edit (canvas, all ? _ ("Free Node") : _ ("Fix Node"), NULL, edit_node,
                    &support);
    return;
  }
  QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
  if (pick.kind != QN_PICK_BLOCK)
    return;
  support.id = pick.id;
  gboolean all = toggle (&support, model->blocks[pick.id].support);
  qn_canvas_edit (canvas, all ? _ ("Free Block") : _ ("Fix Block"), NULL, edit_block,
                  &support);
}

const QnTool qn_tool_support = {
  .name = "support",
  .icon = "quoin-support-symbolic",
  .label = N_ ("Support"),
  .hint = N_ ("Click a block or an end of a beam to fix it; click again to free it"),
  .accel = "s",
  .press = press,
};
