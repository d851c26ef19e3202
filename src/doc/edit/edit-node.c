#include "doc/edit/edit-frame.h"

#include "core/base/polygon.h"
#include <glib/gi18n-lib.h>
#include <math.h>

/* Places nearer to each other, relative to their coordinates, are one. */
#define SAME_PLACE 1e-9

/* ---- where nodes are ---- */

double
qn_place_reach (QnVec2 at)
{
  return SAME_PLACE * MAX (1.0, MAX (fabs (at.x), fabs (at.y)));
}

QnId
qn_model_block_under (const QnModel *model, QnVec2 at)
{
  const double reach = qn_place_reach (at);
  for (QnId i = (QnId) model->block_count - 1; i >= 0; i--) {
    const QnVec2 *v = qn_model_block_vertices (model, i);
    if (qn_polygon_depth (v, (gsize) model->blocks[i].vertex_count, at) >= -reach)
      return i;
  }
  return QN_NONE;
}

static char *
dup_end_text (const QnModel *model, QnVec2 at, const char *nothing)
{
  QnId block = qn_model_block_under (model, at);
  return block != QN_NONE ? g_strdup_printf (_ ("on block %s"), model->blocks[block].name)
                          : g_strdup (nothing);
}

char *
qn_beam_end_dup_text (const QnModel *model, QnVec2 at)
{
  QnId node = qn_model_node_near (model, at, qn_place_reach (at));
  return node != QN_NONE ? g_strdup_printf (_ ("at node %s"), model->nodes[node].name)
                         : dup_end_text (model, at, _ ("free"));
}

char *
qn_tie_end_dup_text (const QnModel *model, QnVec2 at)
{
  return dup_end_text (model, at, _ ("in the ground"));
}

QnId
qn_model_node_near (const QnModel *model, QnVec2 at, double reach)
{
  QnId best = QN_NONE;
  double nearest = reach;
  for (QnId i = 0; i < (QnId) model->node_count; i++) {
    double distance = qn_vec2_length (qn_vec2_sub (model->nodes[i].at, at));
    if (model->nodes[i].beam == QN_NONE && distance <= nearest) {
      nearest = distance;
      best = i;
    }
  }
  return best;
}

guint
qn_model_node_beams (const QnModel *model, QnId node)
{
  guint count = 0;
  for (gsize i = 0; i < model->beam_count; i++)
    count += model->beams[i].nodes[0] == node || model->beams[i].nodes[1] == node;
  return count;
}

/* ---- moving ---- */

static void
replace_id (QnId *id, QnId gone, QnId by)
{
  if (*id == gone)
    *id = by;
}

static void
seat_on (QnNode *node, QnSeat seat, QnId block)
{
  node->seat = seat;
  node->block = seat == QN_SEAT_FREE ? QN_NONE : block;
  for (int dof = 0; dof < QN_DOF_COUNT && seat != QN_SEAT_FREE; dof++)
    node->support[dof] = false;
}

gboolean
qn_edit_place_node (QnModel *model, QnId id, QnVec2 at, GError **error)
{
  QnNode *node = &model->nodes[id];
  QnVec2 from = node->at;
  node->at = qn_vec2 (INFINITY, INFINITY); /* not found as its own neighbour */
  QnId other = qn_model_node_near (model, at, qn_place_reach (at));
  if (other != QN_NONE) {
    node->at = from;
    /* Everything that named the one names the other; rebuilding leaves out a node without
     * beams. */
    for (gsize i = 0; i < model->beam_count; i++) {
      replace_id (&model->beams[i].nodes[0], id, other);
      replace_id (&model->beams[i].nodes[1], id, other);
    }
    for (gsize i = 0; i < qn_model_load_count (model); i++)
      if (qn_model_load (model, i)->kind == QN_LOAD_NODE)
        replace_id (&qn_model_load (model, i)->node, id, other);
    replace_id (&model->analysis.control_node, id, other);
    for (gsize i = 0; i < model->stage_count; i++)
      replace_id (&model->stages[i].control_node, id, other);
    model->nodes[id].seat = QN_SEAT_FREE;
    model->nodes[id].block = QN_NONE;
    return qn_edit_rebuild (model, NULL, error);
  }
  node->at = at;
  QnId block = qn_model_block_under (model, at);
  seat_on (node, block != QN_NONE ? QN_SEAT_POINT : QN_SEAT_FREE, block);
  return TRUE;
}

/* ---- how nodes are held ---- */

gboolean
qn_edit_set_node_seat (QnModel *model, QnId id, QnSeat seat, QnId block, QnBlockSide side,
                       GError **error)
{
  if (seat != QN_SEAT_FREE && block == QN_NONE)
    return qn_edit_refuse (
      error, _ ("There is no block here: move the end of the beam onto one"));
  seat_on (&model->nodes[id], seat, block);
  model->nodes[id].side = side;
  return TRUE;
}

gboolean
qn_edit_set_node_support (QnModel *model, QnId id, const bool support[QN_DOF_COUNT],
                          GError **error)
{
  QnNode *node = &model->nodes[id];
  if (node->block != QN_NONE)
    return qn_edit_refuse (error,
                           _ ("A node on a block is held by its block: fix the block"));
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    node->support[dof] = support[dof];
  return TRUE;
}

gboolean
qn_edit_part_beam (QnModel *model, QnId beam, int end, GError **error)
{
  QnId shared = model->beams[beam].nodes[end];
  if (qn_model_node_beams (model, shared) < 2)
    return qn_edit_refuse_nothing (error, _ ("No other beam ends here"));
  g_autofree char *name =
    qn_edit_dup_new_name (model, qn_model_find_node, model->nodes[shared].name, "-", 2);
  QnNode *node = qn_model_add_node (model, name);
  if (node == NULL)
    return qn_edit_no_memory (error);
  char *own = node->name;
  *node = model->nodes[shared];
  node->name = own;
  node->note = 0;
  model->beams[beam].nodes[end] = (QnId) model->node_count - 1;
  return TRUE;
}

gboolean
qn_edit_add_node_force (QnModel *model, QnId node, gboolean live, QnVec2 force,
                        GError **error)
{
  QnLoad *load = qn_edit_new_load (model, live, error);
  if (load == NULL)
    return FALSE;
  load->kind = QN_LOAD_NODE;
  load->node = node;
  load->vector = force;
  return TRUE;
}
