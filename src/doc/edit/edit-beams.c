#include "doc/edit/edit-beams.h"
#include "core/base/integer.h"

#include <math.h>

static gboolean
has_ends (const QnBeam *beam)
{
  return beam->nodes[0] != QN_NONE && beam->nodes[1] != QN_NONE;
}

/* Marks the nodes that stay: riding ones whose block is there, free ones with a beam that stays. */
static void
mark_nodes (const QnModel *from, QnId (*follow) (gconstpointer data, QnId block),
            gconstpointer data, gboolean *stays)
{
  for (gsize i = 0; i < from->node_count; i++)
    stays[i] =
      from->nodes[i].block == QN_NONE || follow (data, from->nodes[i].block) != QN_NONE;

  g_autofree gboolean *used = g_new0 (gboolean, from->node_count + 1);
  for (gsize i = 0; i < from->beam_count; i++) {
    const QnId *ends = from->beams[i].nodes;
    if (has_ends (&from->beams[i]) && stays[ends[0]] && stays[ends[1]])
      used[ends[0]] = used[ends[1]] = TRUE;
  }
  for (gsize i = 0; i < from->node_count; i++)
    stays[i] = stays[i] && (used[i] || from->nodes[i].block != QN_NONE);
}

static gboolean
copy_nodes (const QnModel *from, QnModel *to,
            QnId (*follow) (gconstpointer data, QnId block), gconstpointer data,
            QnBeamRebuild *rebuild)
{
  g_autofree gboolean *stays = g_new0 (gboolean, from->node_count + 1);
  mark_nodes (from, follow, data, stays);
  for (gsize i = 0; i < from->node_count; i++) {
    const QnNode *old = &from->nodes[i];
    if (old->beam != QN_NONE || !stays[i])
      continue;
    QnNode *node = qn_model_add_node (to, old->name);
    if (node == NULL)
      return FALSE;
    char *name = node->name;
    *node = *old;
    node->name = name;
    if (old->block != QN_NONE)
      node->block = follow (data, old->block);
    rebuild->nodes[i] = (QnId) to->node_count - 1;
  }
  return TRUE;
}

static gboolean
copy_beams (const QnModel *from, QnModel *to, QnBeamRebuild *rebuild)
{
  for (gsize i = 0; i < from->beam_count; i++) {
    const QnBeam *old = &from->beams[i];
    rebuild->beams[i] = QN_NONE;
    if (!has_ends (old))
      continue;
    QnId ends[2] = { rebuild->nodes[old->nodes[0]], rebuild->nodes[old->nodes[1]] };
    if (ends[0] == QN_NONE || ends[1] == QN_NONE)
      continue;
    QnBeam *beam = qn_model_add_beam (to, old->name);
    if (beam == NULL)
      return FALSE;
    char *name = beam->name;
    *beam = *old;
    beam->name = name;
    beam->nodes[0] = ends[0];
    beam->nodes[1] = ends[1];
    rebuild->beams[i] = (QnId) to->beam_count - 1;
  }
  return TRUE;
}

/* Nodes that cut a beam become those nearest to their places, for it may be cut into another
 * number of elements. */
static void
follow_inner_nodes (const QnModel *from, const QnModel *to, QnBeamRebuild *rebuild)
{
  g_autofree guint *counts = g_new0 (guint, from->beam_count + 1);
  g_autofree guint *seen = g_new0 (guint, from->beam_count + 1);
  for (gsize i = 0; i < from->node_count; i++)
    if (from->nodes[i].beam != QN_NONE)
      counts[from->nodes[i].beam]++;
  for (gsize i = 0; i < from->node_count; i++) {
    QnId old = from->nodes[i].beam;
    if (old == QN_NONE || rebuild->beams[old] == QN_NONE)
      continue;
    const QnBeam *beam = &to->beams[rebuild->beams[old]];
    int32_t last = beam->element_count;
    int32_t number = (int32_t) qn_to_integer (
      round ((double) ++seen[old] / (counts[old] + 1) * last), 0, last);
    rebuild->nodes[i] = number <= 0 ? beam->nodes[0]
                        : number >= last
                          ? beam->nodes[1]
                          : to->elements[beam->first_element + number].nodes[0];
  }
}

gboolean
qn_edit_copy_beams (const QnModel *from, QnModel *to,
                    QnId (*follow) (gconstpointer data, QnId block), gconstpointer data,
                    QnBeamRebuild *rebuild, QnDiag *diag)
{
  rebuild->nodes = g_new (QnId, from->node_count + 1);
  rebuild->beams = g_new (QnId, from->beam_count + 1);
  for (gsize i = 0; i < from->node_count; i++)
    rebuild->nodes[i] = QN_NONE;
  if (!copy_nodes (from, to, follow, data, rebuild) || !copy_beams (from, to, rebuild)
      || qn_model_expand_beams (to, diag) != QN_OK)
    return FALSE;
  follow_inner_nodes (from, to, rebuild);
  return TRUE;
}

void
qn_beam_rebuild_clear (QnBeamRebuild *rebuild)
{
  g_clear_pointer (&rebuild->nodes, g_free);
  g_clear_pointer (&rebuild->beams, g_free);
}

void
qn_edit_transform_nodes (QnModel *model, const gboolean *flags, QnTransform transform)
{
  gboolean all = TRUE;
  for (gsize i = 0; i < model->block_count; i++)
    all = all && flags[i];
  for (gsize i = 0; i < model->node_count; i++) {
    QnNode *node = &model->nodes[i];
    gboolean moves = node->block != QN_NONE ? flags[node->block] : all;
    if (moves && (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT))
      node->at = qn_transform_apply (transform, node->at);
  }
  for (gsize i = 0; i < 2 * model->tie_count; i++) {
    QnTieEnd *end = &model->ties[i / 2].ends[i % 2];
    if (end->block != QN_NONE ? flags[end->block] : all)
      end->at = qn_transform_apply (transform, end->at);
  }
}
