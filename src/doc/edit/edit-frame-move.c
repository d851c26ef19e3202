/* Beams that are moved and copied, together with blocks. */
#include "doc/edit/edit-frame.h"

#include "doc/edit/edit-masonry.h"

/* ---- moving ---- */

/* A node that goes somewhere; told by name, because blocks that move may change numbers. */
typedef struct Target {
  char *name;
  QnVec2 at;
} Target;

static void
free_target (gpointer data)
{
  g_free (((Target *) data)->name);
}

/* Nodes of the beams that their blocks do not take along. */
static GArray *
collect_targets (const QnModel *model, QnPartSet set, QnTransform transform)
{
  GArray *targets = g_array_new (FALSE, FALSE, sizeof (Target));
  g_array_set_clear_func (targets, free_target);
  g_autofree gboolean *moved = qn_block_set_to_flags (set.blocks, model);
  g_autofree gboolean *known = g_new0 (gboolean, model->node_count + 1);
  for (guint i = 0; i < set.beams.count; i++) {
    for (int end = 0; end < 2; end++) {
      QnId id = model->beams[set.beams.ids[i]].nodes[end];
      const QnNode *node = &model->nodes[id];
      gboolean goes = node->seat == QN_SEAT_FREE
                      || (node->seat == QN_SEAT_POINT && !moved[node->block]);
      if (!goes || known[id])
        continue;
      known[id] = TRUE;
      Target target = { g_strdup (node->name), qn_transform_apply (transform, node->at) };
      g_array_append_val (targets, target);
    }
  }
  return targets;
}

gboolean
qn_edit_transform_all (QnProject *draft, QnPartSet set, QnTransform transform,
                       GError **error)
{
  if (set.beams.count == 0)
    return qn_edit_transform (draft, set.blocks, transform, error);
  g_autoptr (GArray) targets = collect_targets (&draft->model, set, transform);
  if (set.blocks.count > 0 && !qn_edit_transform (draft, set.blocks, transform, error))
    return FALSE;
  for (guint i = 0; i < targets->len; i++) {
    const Target *target = &g_array_index (targets, Target, i);
    QnId node = qn_model_find_node (&draft->model, target->name);
    if (node != QN_NONE)
      draft->model.nodes[node].at = target->at;
  }
  return TRUE;
}

/* ---- copying ---- */

/* A beam that is to be copied, with what its ends are. */
typedef struct Original {
  QnBeam beam;
  QnVec2 at[2];
  bool support[2][QN_DOF_COUNT];
} Original;

static GArray *
collect_originals (const QnModel *model, QnBeamSet beams)
{
  GArray *originals = g_array_new (FALSE, FALSE, sizeof (Original));
  for (guint i = 0; i < beams.count; i++) {
    Original original = { .beam = model->beams[beams.ids[i]] };
    for (int end = 0; end < 2; end++) {
      const QnNode *node = &model->nodes[original.beam.nodes[end]];
      original.at[end] = node->at;
      for (int dof = 0; dof < QN_DOF_COUNT; dof++)
        original.support[end][dof] = node->support[dof];
    }
    g_array_append_val (originals, original);
  }
  return originals;
}

static gboolean
copy_one (QnModel *model, const Original *original, QnTransform step, GError **error)
{
  QnVec2 ends[2];
  gboolean is_new[2];
  for (int end = 0; end < 2; end++) {
    gsize before = model->node_count;
    ends[end] = qn_transform_apply (step, original->at[end]);
    if (qn_edit_take_node (model, ends[end]) == QN_NONE)
      return qn_edit_no_memory (error);
    is_new[end] = model->node_count > before;
  }
  const QnBeam *old = &original->beam;
  QnBeamStyle style = { .section = model->sections[old->section].name,
                        .kind = old->kind,
                        .hinge = { old->hinge[0], old->hinge[1] },
                        .element_count = old->element_count };
  if (!qn_edit_add_beam (model, ends[0], ends[1], style, error))
    return FALSE;
  const QnBeam *beam = &model->beams[model->beam_count - 1];
  for (int end = 0; end < 2; end++) {
    QnNode *node = &model->nodes[beam->nodes[end]];
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      if (is_new[end] && node->block == QN_NONE)
        node->support[dof] = original->support[end][dof];
  }
  return TRUE;
}

gboolean
qn_edit_copy_all (QnProject *draft, QnPartSet set, QnTransform transform, int copies,
                  GError **error)
{
  g_autoptr (GArray) originals = collect_originals (&draft->model, set.beams);
  if ((set.blocks.count > 0 || set.beams.count == 0)
      && !qn_edit_copy (draft, set.blocks, transform, copies, error))
    return FALSE;
  QnTransform step = qn_transform_translation (0.0, 0.0);
  for (int k = 0; k < copies; k++) {
    step = qn_transform_compose (step, transform);
    for (guint i = 0; i < originals->len; i++)
      if (!copy_one (&draft->model, &g_array_index (originals, Original, i), step, error))
        return FALSE;
  }
  return TRUE;
}
